#!/usr/bin/env python3
"""structure.py [ROOT] [--where FIGURE]: figures of how far the sources are from their goals.

One line `FIGURE NUMBER` each, or with --where the places behind one figure:
  circle      files of gsmbp/ in the largest circle of uses (1: no two files use each other)
  backward    uses between files against the order in which gsmbp.mac loads them
  wide        lines of source over 100 columns, in gsmbp octave share examples tests
  long        functions of gsmbp/ over 25 lines
  double      names of gsmbp/ that are defined more than once
  unnamed     namings of a step with an empty hint
  indices     parts taken by a number, a[2], in .mac files
  ordinals    parts taken by third ... tenth
  positional  structures of more than five fields made by position
  fragments   texts of Fortran statements in gsmbp/ beside the folder that prints it
  unprinted   ... in that folder, beside the files that print statements
  readers     functions that read words of Fortran
  layouts     places of the plan of a run (IP, RP) by number outside of the run time, whose file
              share/engine/core/inputs/lay_plan.c lays it out for everybody
  crowded     rooms of octave/+gs with more than 40 files
  nameless    names in them of one word
  shadows     functions in files of octave/ with the name of one in a room, or of a room that the
              file uses: Octave 7 would take them in its place
  strays      files of share/fortran that neither emitted routines nor its driver need (closure.py)
  indexed     results of functions in rooms that are indexed at once, which Octave 7 cannot
tests/sh/structure.sh holds them against tests/data/structure.txt.
"""
import contextlib
import io
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import closure
import deps

SOURCES = ('.mac', '.lisp', '.m', '.py', '.sh', '.f', '.F', '.cc', '.c', '.h', '.awk')
DATA = ('share/fmu/fmi/', 'tests/data/', 'tests/malformed/', 'tests/bench/peers/',
        'tests/fmu/cases', 'tests/reach/arms')
INDEX = re.compile(r'(?<![\w%])[\w%]+_?(?:\[\d+\])+')
FRAGMENT = re.compile(r'CALL |\bIF \(|\bDO "?\d|CONTINUE|DOUBLE PRECISION|\bINTEGER \w|EXTERNAL |'
                      r'\bRETURN\b|GO TO|\.(?:EQ|NE|GT|LT|GE|LE|AND|OR|NOT)\.|INFO = |END IF')
PRINTERS = ('statement_text', 'statements', 'expressions', 'lines', 'routine', 'header')
READER = re.compile(r'gs__(?:tokens|plain_tokens|identifiers|array_of)[( )]')
LAYOUT = re.compile(r'(?<![&>])\b(?:\w+(?:->|\.))*[iIrR][pP] ?[\[(] ?\(?\d')   # &ip[0] is all
ORDINAL = re.compile(r'\b(?:third|fourth|fifth|sixth|seventh|eighth|ninth|tenth)\s*\(')


def package(root):
    """the definitions of gsmbp/, and its files with the uses between them"""
    with contextlib.redirect_stdout(io.StringIO()):
        definitions, names, _, edges = deps.report_package(root, None, True)
    return definitions, names, edges


def circles(edges):
    nodes = sorted({f for edge in edges for f in edge})
    return deps.tarjan(nodes, lambda v: [b for a, b in edges if a == v])


def backward(root, edges):
    order = [n + '.mac' for n in deps.loads_in_order(root)]
    place = {}
    for k, loaded in enumerate(order):
        place[loaded] = place['gsmbp_' + loaded] = k
        place[loaded[:-4]] = k
    return [(a, b) for a, b in edges if a in place and b in place and place[b] > place[a]]


def wide(root):
    for top in ('gsmbp', 'octave', 'share', 'examples', 'tests'):
        for folder, _, files in os.walk(os.path.join(root, top)):
            for f in sorted(files):
                path = os.path.relpath(os.path.join(folder, f), root)
                if not is_source(path):
                    continue
                with open(os.path.join(root, path), errors='replace') as lines:
                    for k, line in enumerate(lines, 1):
                        if len(line.rstrip('\n')) > 100:
                            yield '%s:%d' % (path, k)


def is_source(path):
    script = '.' not in os.path.basename(path)
    made = '/out/' in path or '/compiled/' in path or '/build/' in path
    return (path.endswith(SOURCES) or script) and not path.startswith(DATA) and not made


def strays(root):
    """files of share/fortran that neither emitted routines nor the driver need"""
    return closure.needed(root)[1]


def fields_of(structure):
    return len(re.findall(r'\w+', structure.body.split('(', 2)[-1])) if structure else 0


def constructions(definitions, names):
    """the calls new(structure(a, b, ...)) of structures with more than five fields"""
    for d in definitions:
        for m in re.finditer(r'\bnew\s*\(\s*(\w+)\s*\(', d.body):
            made = [x for x in names.get(m.group(1), []) if x.kind == 'struct']
            if made and fields_of(made[0]) > 5:
                yield place(d)


def fragments(root):
    """the texts of Fortran statements in gsmbp/, as (file, text)"""
    for folder, _, files in os.walk(os.path.join(root, 'gsmbp')):
        for f in sorted(files):
            path = os.path.relpath(os.path.join(folder, f), root)
            if not path.endswith(('.mac', '.lisp')) or 'compiled' in path:
                continue
            with open(os.path.join(root, path), errors='replace') as source:
                text = source.read()
            text = re.sub(r'/\*.*?\*/' if path.endswith('.mac') else r';[^\n]*', ' ', text,
                          flags=re.S)
            for said in re.findall(r'"(?:\\.|[^"\\])*"', text, re.S):
                if FRAGMENT.search(said) and '~a' not in said:
                    yield path, said


def unprinted(root):
    name = lambda path: os.path.splitext(os.path.basename(path))[0]
    return [f for f in fragments(root) if '/fortran/' in f[0] and name(f[0]) not in PRINTERS]


def layouts(root):
    """the lines of octave/, share/python, share/fmu, share/package_c that number places of IP or
    RP"""
    for top in ('octave', 'share/python', 'share/fmu', 'share/package_c'):
        for folder, _, files in os.walk(os.path.join(root, top)):
            for f in sorted(files):
                path = os.path.relpath(os.path.join(folder, f), root)
                if not f.endswith(('.m', '.c', '.h', '.cc', '.py')):
                    continue
                with open(os.path.join(root, path), errors='replace') as lines:
                    for k, line in enumerate(lines, 1):
                        if LAYOUT.search(line):
                            yield '%s:%d' % (path, k)


def rooms(root):
    """{room: its files}"""
    top = os.path.join(root, 'octave', '+gs')
    return {room: [f for f in os.listdir(os.path.join(top, room)) if f.endswith('.m')]
            for room in sorted(os.listdir(top)) if room.startswith('+')}


def files_of_octave(root):
    """(path, text) of its functions"""
    for folder, _, files in os.walk(os.path.join(root, 'octave')):
        for f in sorted(files):
            if f.endswith('.m'):
                with open(os.path.join(folder, f), errors='replace') as text:
                    yield os.path.relpath(os.path.join(folder, f), root), text.read()


def shadows(root):
    known = {f[:-2] for files in rooms(root).values() for f in files}
    for path, text in files_of_octave(root):
        for name in re.findall(r'(?m)^ *function\s+(?:[^=(\n]*=\s*)?(\w+)', text):
            used = re.search(r'\bgs\.%s\.' % name, text)
            if used or (name in known and not path.endswith('/%s.m' % name)):
                yield '%s %s' % (path, name)


def indexed(root):
    """calls gs.room.name (...) with an index behind them; brackets in strings count as well, so
    that a call is left out where they do not match"""
    for path, text in files_of_octave(root):
        for call in re.finditer(r'(?m)^(?! *(?:#|function)).*?\bgs\.\w+\.\w+ ?(?=\()', text):
            depth, k = 1, call.end() + 1
            while depth and k < len(text):
                depth += (text[k] in '([{') - (text[k] in ')]}')
                k += 1
            if re.match(r"[({]|\.[a-zA-Z(]", text[k:k+2]):
                yield '%s:%d' % (path, text.count('\n', 0, call.end()) + 1)


def place(definition):
    return '%s:%d %s' % (definition.file, definition.line, definition.name)


def found(root):
    definitions, names, edges = package(root)
    mac = [d for d in definitions if d.file.endswith('.mac')]
    code = [d for d in definitions if d.kind in ('function', 'macro')]
    largest = max(circles(edges), key=len, default=[])
    every = lambda pattern, part: [place(d) for d in mac for _ in re.findall(pattern, part(d))]
    return {
        'circle': sorted(largest),
        'backward': ['%s uses %s' % e for e in sorted(backward(root, edges))],
        'wide': list(wide(root)),
        'long': ['%s %d' % (place(d), d.lines) for d in code if d.lines > deps.LONG_LINES],
        'double': [n for n, ds in names.items() if len(ds) > 1],
        'unnamed': every(r'name\w*\([^;$]*?,\s*""\)|, ""\)',
                         lambda d: d.raw if 'name' in d.raw else ''),
        'indices': every(INDEX, lambda d: d.body),
        'ordinals': every(ORDINAL, lambda d: d.body),
        'positional': list(constructions(definitions, names)),
        'fragments': ['%s %s' % f for f in fragments(root) if '/fortran/' not in f[0]],
        'unprinted': ['%s %s' % f for f in unprinted(root)],
        'readers': sorted({place(d) for d in code if READER.search(d.body.split(d.name, 1)[-1])}),
        'layouts': list(layouts(root)),
        'crowded': [room for room, files in rooms(root).items() if len(files) > 40],
        'nameless': [f for files in rooms(root).values() for f in files if '_' not in f],
        'shadows': list(shadows(root)),
        'indexed': list(indexed(root)),
        'strays': sorted(strays(root)),
    }


def main():
    words = [w for w in sys.argv[1:] if not w.startswith('--')]
    where = '--where' in sys.argv and words.pop()
    figures = found(words[0] if words else '.')
    if where:
        print('\n'.join(figures[where]))
    else:
        for name, places in figures.items():
            print(name, len(places))


if __name__ == '__main__':
    main()
