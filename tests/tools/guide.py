"""guide.py ROOT: are the maps gsmbp/README.md, share/fortran/README.md,
share/engine/core/README.md, octave/+gs/README.md and tests/README.md true?

One line `ok WHAT` or `not ok WHAT: what is missing or too much` a check.
guide.py ROOT --callers prints who calls each routine of share/fortran; --write-callers writes it
into the index of share/fortran/README.md, out of which the rows of deleted routines go.
"""
import glob
import os
import re
import sys

ROOT = sys.argv[1]


def text_of(path):
    with open(os.path.join(ROOT, path), errors='replace') as f:
        return f.read()


def files_of(*patterns):
    found = [p for pattern in patterns for p in glob.glob(os.path.join(ROOT, pattern))]
    return sorted(os.path.relpath(p, ROOT) for p in found if os.path.isfile(p))


def without_comments(path):
    text = text_of(path)
    if path.endswith('.f'):
        return re.sub(r'(?m)^[C*].*$', '', text)
    if path.endswith('.lisp'):
        return re.sub(r'(?m);;.*$', '', text)
    return re.sub(r'(?s)/\*.*?\*/', '', text)


def report(what, problems):
    problems = sorted(problems)
    print('not ok %s: %s' % (what, '; '.join(problems[:8])) if problems else 'ok ' + what)


# -- share/fortran

def routines():
    """(name, file) of every program unit of share/fortran, and its text without comments"""
    found = {}
    for path in files_of('share/fortran/*/*.f', 'share/fortran/*/*/*.f'):
        for part in re.split(r'(?m)^(?= +(?:SUBROUTINE|[A-Z ]+FUNCTION) )', without_comments(path)):
            head = re.match(r' +(?:SUBROUTINE|[A-Z ]+FUNCTION) +(\w+)', part)
            if head:
                file = os.path.relpath(path, 'share/fortran')
                found[head.group(1), file] = part
    return found


def callers(units):
    """name: set of those who call it: routines, `emitted` code, the `glue` of Octave"""
    called = {name: set() for name, _ in units}
    for (caller, _), text in units.items():
        body = text.split('\n', 1)[1]
        for name in set(re.findall(r'\b(GS\w+)(?= *\()', body)) & set(called):
            called[name] |= {caller} - {name}
    for who, paths in (('emitted', files_of('gsmbp/*/*.mac', 'gsmbp/*/*.lisp')),
                       ('glue', files_of('octave/glue/*.[ch]', 'octave/glue/*.cc'))):
        text = '\n'.join(map(without_comments, paths))
        if who == 'glue':
            text = re.sub(r'//.*', '', text)
        for name in called:
            if re.search(r'\b%s(_\b|\b)' % name, text.upper() if who == 'glue' else text):
                called[name].add(who)
    return called


def index_of_fortran():
    """{(name, file): who calls it} as share/fortran/README.md has it"""
    folder, index = '', {}
    for line in text_of('share/fortran/README.md').splitlines():
        heading = re.match(r'## `(\w+/)`', line)
        folder = heading.group(1) if heading else folder
        row = re.match(r'\| `(\w+)` \| `([\w/.]+)` \|.*\| ([^|]*) \|$', line)
        if row:
            index[row.group(1), folder + row.group(2)] = (
                {who.strip() for who in row.group(3).split(',')} - {''})
    return index


def write_callers():
    """the index of share/fortran/README.md with the callers of today, of the routines of today"""
    units = routines()
    truth, folder, lines = callers(units), '', []
    for line in text_of('share/fortran/README.md').splitlines():
        heading = re.match(r'## `(\w+/)`', line)
        folder = heading.group(1) if heading else folder
        row = re.match(r'(\| `(\w+)` \| `([\w/.]+)` \|.*\| )[^|]* \|$', line)
        if row and (row.group(2), folder + row.group(3)) in units:
            line = '%s%s |' % (row.group(1), ', '.join(sorted(truth[row.group(2)])))
        if not row or (row.group(2), folder + row.group(3)) in units:
            lines.append(line)
    with open(os.path.join(ROOT, 'share/fortran/README.md'), 'w') as f:
        f.write('\n'.join(lines) + '\n')


def check_fortran():
    units, index = routines(), index_of_fortran()
    truth = callers(units)
    report('share/fortran/README.md: every routine is in the index',
           ['%s in %s' % u for u in set(units) - set(index)])
    report('share/fortran/README.md: every routine of the index exists',
           ['%s in %s' % u for u in set(index) - set(units)])
    report('share/fortran/README.md: who calls it',
           ['%s: found %s, the index says %s' % (name, ', '.join(sorted(truth[name])) or 'nobody',
                                                 ', '.join(sorted(who)) or 'nobody')
            for (name, file), who in index.items() if name in truth and truth[name] != who])


# -- share/engine/core

PROTOTYPE = r'(?m)^(?!static|typedef)[a-z]\w*[ \w*]*?\b(gs_\w+) \([^;{]*\);'

def check_c():
    """the index has the routines that the headers declare, each in the file that defines it"""
    declared = set()
    for path in files_of('share/engine/core/gsmbp/*.h'):
        if 'arith' not in path:
            declared |= set(re.findall(PROTOTYPE, without_comments(path)))
    defined = {}
    for path in files_of('share/engine/core/*/*.c', 'share/engine/core/*/*/*.c'):
        for name in re.findall(r'(?m)^(gs_\w+) \(', without_comments(path)):
            defined[name] = os.path.relpath(path, 'share/engine/core')
    folder, index = '', {}
    for line in text_of('share/engine/core/README.md').splitlines():
        heading = re.match(r'## `(\w+/)`', line)
        folder = heading.group(1) if heading else folder
        row = re.match(r'\| `(gs_\w+)` \| `([\w/.]+\.c)` \|', line)
        if row:
            index[row.group(1)] = folder + row.group(2)
    report('share/engine/core: every routine has its prototype, every prototype its routine',
           declared ^ set(defined))
    report('share/engine/core/README.md: the index has every routine and its file',
           {n for n in set(index) | set(defined) if index.get(n) != defined.get(n)})


# -- maps: a line `* `file`: ...` (or a table's first cell) under a heading that names the folder

def named_in_map(path):
    """the files that a map names, relative to ROOT: each row under the heading of its folder"""
    folder, named = os.path.dirname(path), []
    place = folder
    for line in text_of(path).splitlines():
        heading = re.match(r'#+ `([\w/]+)/`', line)
        if heading:
            place = os.path.normpath(os.path.join(folder, heading.group(1)))
        elif line.startswith('#'):
            place = folder
        row = re.match(r'\| `([\w/.*]+)`((?:, `[\w/.*]+`)*) \|', line)
        if row:
            for name in re.findall(r'`([^`]+)`', row.group(0)):
                named.append(os.path.normpath(os.path.join(place, name)))
    return named


def check_map(path, files):
    named = named_in_map(path)
    report(path + ': every file is in the map', set(files) - set(named))
    report(path + ': every file of the map exists',
           [n for n in named if not files_of(n)])
    report(path + ': no file is in the map twice', {n for n in named if named.count(n) > 1})


def check_heads():
    """the first comment of a source begins with the file's own name"""
    wrong = []
    for path in files_of('gsmbp/*.mac', 'gsmbp/*.lisp', 'gsmbp/*/*.mac', 'gsmbp/*/*.lisp'):
        own = os.path.relpath(path, 'gsmbp')
        if not re.match(r'(/\*|;;+) %s: ' % re.escape(own), text_of(path)):
            wrong.append(path)
    report('the head of every file of gsmbp/ names it', wrong)


def check_named_files():
    """a file that a comment or a guide names exists"""
    wrong = []
    sources = files_of('gsmbp/*.mac', 'gsmbp/*.lisp', 'gsmbp/*/*.mac', 'gsmbp/*/*.lisp',
                       'gsmbp/README.md', 'tests/README.md', 'share/fortran/README.md', 'CHANGES')
    for path in sources:
        for name in re.findall(r'\b([a-z]\w*/[\w/+]+\.(?:mac|lisp|f|m|md|sh|py))\b', text_of(path)):
            places = ['', 'gsmbp', 'share', 'share/fortran/solve', os.path.dirname(path)]
            made = 'fortran_out' in name or 'any/where' in name
            if not made and not any(files_of(os.path.join(p, name)) for p in places):
                wrong.append('%s names %s' % (path, name))
    report('files that comments and guides name exist', set(wrong))


def check_named_functions():
    """a private function that the guide names is defined"""
    sources = files_of('gsmbp/*.mac', 'gsmbp/*.lisp', 'gsmbp/*/*.mac', 'gsmbp/*/*.lisp')
    defined = set()
    for path in sources:
        text = without_comments(path)
        defined |= set(re.findall(r'(?m)^ *(gs(?:mbp)?_\w+) *(?:\(|:)', text))
        defined |= set(re.findall(r'\(def\w+ \$(gs(?:mbp)?_\w+)', text))
        defined |= set(re.findall(r'define_variable\((gsmbp_\w+)', text))
    named = set(re.findall(r'`(gs(?:mbp)?_\w+)[`(]', text_of('gsmbp/README.md')))
    report('functions that gsmbp/README.md names are defined',
           {n for n in named - defined if not files_of('octave/%s.m' % n)})


def check_rooms():
    """octave/+gs/README.md names each room once"""
    named = re.findall(r'(?m)^\| `(\+\w+)` \|', text_of('octave/+gs/README.md'))
    rooms = {os.path.basename(os.path.dirname(p)) for p in files_of('octave/+gs/*/*.m')}
    report('octave/+gs/README.md has the rooms',
           (rooms ^ set(named)) | {n for n in named if named.count(n) > 1})


def check_version():
    version = re.search(r'gsmbp_version, "([^"]*)"', text_of('gsmbp/kernel/version.mac')).group(1)
    cited = re.search(r'(?m)^version: "?([^"\n]*)', text_of('CITATION.cff')).group(1)
    changes = re.search(r'(?m)^GSMBP (\S+)', text_of('CHANGES')).group(1)
    report('CITATION.cff and CHANGES have the version of kernel/version.mac',
           ['%s, found %s and %s' % (version, cited, changes)]
           if {cited, changes} != {version} else [])


if sys.argv[2:] == ['--write-callers']:
    write_callers()
elif sys.argv[2:] == ['--callers']:
    units = routines()
    who = callers(units)
    for name, file in sorted(units, key=lambda u: (u[1], u[0])):
        print(name, file, ', '.join(sorted(who[name])))
else:
    check_map('gsmbp/README.md', files_of('gsmbp/*.mac', 'gsmbp/*.lisp', 'gsmbp/*/*.mac',
                                          'gsmbp/*/*.lisp'))
    check_map('tests/README.md', files_of('tests/run', 'tests/rtest.awk', 'tests/tools/*',
                                          'tests/sh/*.sh', 'tests/malformed/*.py',
                                          'tests/random/*.py', 'tests/random/run'))
    check_fortran()
    check_c()
    check_heads()
    check_named_files()
    check_named_functions()
    check_rooms()
    check_version()
