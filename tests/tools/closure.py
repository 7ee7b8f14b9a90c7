#!/usr/bin/env python3
"""closure.py [ROOT]: the files of share/fortran that the lineage needs, one a line: those of the
routines that emitted Fortran can call and of the driver (share/fortran/drive), and of all that
these call. closure.py --outside [ROOT]: the others; --roots [ROOT]: the routines that are called
first. A routine that gsmbp/ can emit a call of is one whose name is in its sources, comments aside.
"""
import glob
import os
import re
import sys


def code_of(path):
    """the text of a file without its comments"""
    with open(path, errors='replace') as f:
        text = f.read()
    if path.endswith('.f'):
        return re.sub(r'(?m)^[C*].*$', '', text)
    if path.endswith('.lisp'):
        return re.sub(r'(?m);;.*$', '', text)
    return re.sub(r'(?s)/\*.*?\*/', '', text)


def units(root):
    """{file: {routine: names of GS... in its text}} of share/fortran, files relative to it"""
    found, top = {}, os.path.join(root, 'share/fortran')
    for path in sorted(glob.glob(top + '/**/*.f', recursive=True)):
        parts = re.split(r'(?m)^(?= +(?:SUBROUTINE|[A-Z ]+FUNCTION) )', code_of(path))
        routines = {}
        for part in parts:
            head = re.match(r' +(?:SUBROUTINE|[A-Z ]+FUNCTION) +(\w+)', part)
            if head:
                routines[head.group(1)] = set(re.findall(r'\bGS\w+', part)) - {head.group(1)}
        found[os.path.relpath(path, top)] = routines
    return found


def roots(root, found):
    """the routines that are called first"""
    emitter = '\n'.join(code_of(path) for ending in ('mac', 'lisp')
                        for path in glob.glob(os.path.join(root, 'gsmbp', '*', '*.' + ending)))
    named = set(re.findall(r'\bGS\w+', emitter))
    return {name for file, routines in found.items() for name in routines
            if name in named or file.startswith('drive/')}


def needed(root):
    """the files that the lineage needs, and the others"""
    found = units(root)
    calls = {}
    for routines in found.values():
        for name, called in routines.items():
            calls.setdefault(name, set()).update(called)
    seen, todo = set(), roots(root, found)
    while todo:
        name = todo.pop()
        seen.add(name)
        todo |= (calls[name] & set(calls)) - seen
    inside = {file for file, routines in found.items() if seen & set(routines)}
    return inside, set(found) - inside


def main():
    words = [word for word in sys.argv[1:] if word.startswith('--')]
    root = ([word for word in sys.argv[1:] if word not in words] or ['.'])[0]
    if words == ['--roots']:
        rows = roots(root, units(root))
    else:
        rows = needed(root)[words == ['--outside']]
    print('\n'.join(sorted(rows)))


if __name__ == '__main__':
    main()
