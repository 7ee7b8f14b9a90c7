#!/usr/bin/python3
"""sessions.py [--write] [FILE...]: types the sessions that Texinfo or Markdown files print (all of
the manual, the help texts and the README).

A line `@c session NAME` (Markdown: `<!-- session NAME -->`) begins a session (or goes on with it,
in another file, too): the examples behind it whose first line begins with `(%i1) `, `>> `, `$ ` or
`>>> ` are typed, those of Maxima first, then those of Octave, of a shell, of Python (env/bin/python
where the shell has made that), in a new folder that looks like the top of the repository.
`@c file NAME` ahead of an example: it is the text of a file there. Prints `ok` or `not ok` an
example. In what is expected a line `...` stands for any lines, `...` at the end of a line for the
rest of it; numbers with a point may differ by 1e-4 or in their last digit, tiny ones (1e-12)
altogether, times in seconds and parts of it, too; lines that tell of a long derivation are left
out. Maxima is the image in which GSMBP is loaded; sessions of the README load the sources, as a
stranger's. --part=K/N: the part K of N of the sessions, of about the same length. --write: what
differs is written into the file instead, and pictures that the file shows (@image{figures/NAME,
...}) are copied to figures/ beside it.
"""
import functools
import glob
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, 'share', 'make'))
from typed_lines import goes_on  # noqa: E402
from maxima import maxima  # noqa: E402
PROMPT = {'maxima': re.compile(r'\(%i\d+\) '), 'octave': re.compile(r'>> '),
          'shell': re.compile(r'\$ '), 'python': re.compile(r'>>> ')}
DIRECTIVE = re.compile(r'(?:@c|<!--) (session|file) ([\w./-]+)')
NUMBER = re.compile(r'[-+]?\d+\.?\d*(?:[eEdD][-+]?\d+)?')
TIME = re.compile(r'(\d+\.?\d*) ?(s|ms|us|ns)\b(?! *[\])^*/])')
PROGRESS = re.compile(r'gsmbp: .* \(\d+ s so far\)')
MARK = '\x01next\x01'


class Example:
    """lines [first, last) of a file, what they are, and the session they belong to"""

    def __init__(self, path, first, session, name):
        self.path, self.first, self.session, self.file = path, first, session, name
        self.text = self.kind = None

    def close(self, lines, last, plain):
        self.last = last
        self.text = [plain(line) for line in lines[self.first:last]]
        for kind, prompt in PROMPT.items():
            if self.text and prompt.match(self.text[0]):
                self.kind = kind

    def steps(self):
        """[[typed lines], [expected lines]] of each input"""
        found = []
        for line in self.text:
            if PROMPT[self.kind].match(line):
                found.append([[PROMPT[self.kind].sub('', line, count=1)], []])
            elif not found[-1][1] and goes_on(self.kind, '\n'.join(found[-1][0])):
                found[-1][0].append(line)
            else:
                found[-1][1].append(line)
        return found


def texinfo_plain(line):
    return line.replace('@{', '{').replace('@}', '}').replace('@@', '@')


def texinfo_escaped(line):
    return line.replace('@', '@@').replace('{', '@{').replace('}', '@}')


def examples(path, lines):
    """the examples of a file"""
    texinfo = path.endswith(('.texi', '.m'))
    begin, end = (r'@(small)?example$', r'@end (small)?example$') if texinfo else (r'```', r'```$')
    plain = texinfo_plain if texinfo else str
    found, session, name, inside = [], None, None, None
    for k, line in enumerate(lines):
        told = DIRECTIVE.match(line)
        if told and told.group(1) == 'session':
            session, name = told.group(2), None
        elif told:
            name = told.group(2)
        elif inside is None and re.match(begin, line):
            inside = Example(path, k + 1, session, name)
        elif inside is not None and re.match(end, line):
            inside.close(lines, k, plain)
            if inside.kind or inside.file:
                found.append(inside)
            name = inside = None
    return found


def linked(source, target):
    """A second name of a file; a copy on another disk."""
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)


def workplace(loaded):
    """a folder that looks like the top of the repository, with nothing derived in it"""
    folder = tempfile.mkdtemp(prefix='session')
    for name in ('gsmbp', 'share', 'examples', 'tests'):
        os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
    shutil.copytree(os.path.join(ROOT, 'octave'), os.path.join(folder, 'octave'),
                    copy_function=linked)
    os.mkdir(os.path.join(folder, 'user'))
    with open(os.path.join(folder, 'user', 'gsmbp.mac'), 'w') as f:
        # a minus at the prompt as the public functions write it, in every version of Maxima
        f.write('gs__load_manual(sconcat(gs__share, "manual/"))$' if loaded else
                'load("%s/gsmbp/gsmbp.mac")$' % ROOT)
        f.write(' ?putprop(?mminus, 100, ?rbp)$\n')
    with open(os.path.join(folder, 'user', 'begin.lisp'), 'w') as f:   # what an image leaves out
        f.write('(in-package :maxima)\n(setq *display-labels-p* t)\n(setf (cdr '
                '$file_search_maxima)\n      (cons "%s/user/$$$.mac" (cdr $file_search_maxima)))\n'
                % folder)
    return folder


def run(command, typed, folder):
    said = subprocess.run(command, input=typed, cwd=folder, timeout=600, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={**os.environ, 'OMP_NUM_THREADS': '1', 'GCL_GC_ALLOC_MIN': '0.5'})
    return said.stdout


def trimmed(text):
    lines = [line.rstrip() for line in text.split('\n') if not PROGRESS.match(line)]
    while lines and not lines[0]:
        lines.pop(0)
    while lines and not lines[-1]:
        lines.pop()
    return lines


def maxima_answers(words, steps, folder):
    """the prompt and the output of each"""
    typed = '\n'.join('\n'.join(s[0]) for s in steps) + '\n'
    said = run([*words, '--quiet',
                '--preload-lisp=' + os.path.join(folder, 'user', 'begin.lisp'),
                '--userdir=' + os.path.join(folder, 'user')], typed, folder)
    parts = re.split(r'(\(%i\d+\) )', said)[1:]
    return [(parts[k], trimmed(parts[k + 1])) for k in range(0, len(parts) - 1, 2)]


def octave_answers(steps, folder):
    script = ['1;', 'page_screen_output (false);', 'addpath ("%s/octave");' % folder]
    for typed, _ in steps:
        quoted = '\n'.join(typed).replace("'", "''")
        lines = "', \"\\n\", '".join(quoted.split('\n'))
        script += [
            "try, eval (['%s']); catch gs_, printf ('error: %%s\\n', gs_.message); end" % lines,
            "printf ('%s\\n'); fflush (stdout);" % MARK
        ]
    path = os.path.join(folder, 'user', 'typed.m')
    with open(path, 'w') as f:
        f.write('\n'.join(script) + '\n')
    said = run(['octave-cli', '-qf', '--no-history', path], '', folder)
    return [('>> ', trimmed(part)) for part in said.split(MARK + '\n')[:-1]]


def shell_answers(steps, folder):
    first = '/usr/lib/ccache:' if '/usr/lib/ccache' in os.environ['PATH'] else ''
    script = ['PATH=%s/usr/bin:$PATH; exec 2>&1' % first, 'unset PIP_INDEX_URL PIP_FIND_LINKS',
              'export PIP_NO_INDEX=1']
    for typed, _ in steps:
        script += ['\n'.join(typed), "printf '%s\\n'" % MARK]
    said = run(['sh'], '\n'.join(script) + '\n', folder)
    return [('$ ', trimmed(part)) for part in said.split(MARK + '\n')[:-1]]


def python_answers(steps, folder):
    script = ['import code, sys', 'console = code.InteractiveConsole()',
              'for typed in %r:' % [typed for typed, _ in steps],
              '    if [console.push(line) for line in typed][-1]:', "        console.push('')",
              '    print(%r, flush=True)' % MARK]
    path = os.path.join(folder, 'user', 'typed.py')
    with open(path, 'w') as f:
        f.write('\n'.join(script) + '\n')
    own = os.path.join(folder, 'env', 'bin', 'python')
    said = run([own if os.path.exists(own) else '/usr/bin/python3', '-u', path], '', folder)
    return [('>>> ', trimmed(part)) for part in said.split(MARK + '\n')[:-1]]


def same_number(a, b):
    if a == b:
        return True
    if not re.search(r'[.eE]', a + b):
        return False
    x, y = (float(v.lower().replace('d', 'e')) for v in (a, b))
    digits = a.lower().split('e')[0].partition('.')[2]
    power = float('1e' + (a.lower().partition('e')[2] or '0'))
    last = 2.001*10.**-len(digits)*power if digits else 0.
    return abs(x - y) <= max(1e-4*abs(x), last, 1e-12)


def same_line(expected, said):
    rest = expected.endswith('...')
    if rest:
        expected = expected[:-3].rstrip()
    a, b = (' '.join(TIME.sub(r'0 \2', line).split()) for line in (expected, said))
    if rest:
        b = ' '.join(b.split()[:len(a.split())])
    words = [re.sub(r' +', ' ', NUMBER.sub('#', line)) for line in (a, b)]
    return words[0] == words[1] and all(
        same_number(x, y) for x, y in zip(NUMBER.findall(a), NUMBER.findall(b)))


def same(expected, said):
    """whether the lines agree; a line `...` of those expected stands for any"""
    expected, said = ([line for line in lines if line.strip()] for lines in (expected, said))
    if not expected:
        return not said
    if expected[0].strip() == '...':
        return any(same(expected[1:], said[k:]) for k in range(len(said) + 1))
    return bool(said) and same_line(expected[0], said[0]) and same(expected[1:], said[1:])


def agrees(expected, said):
    """the same; a list with numbers of many digits may be broken into lines elsewhere: Maxima 5.47
    prints 0.041924963111687908 for 0.04192496311168791"""
    return same(expected, said) or (
        any(re.search(r'\d\.\d{15}', line) for line in expected) and
        same_line(' '.join(expected), ' '.join(said)))


def typed_session(members, folder, words):
    """{example: [(typed, expected, prompt, said), ...]}"""
    for e in members:
        if e.file:
            with open(os.path.join(folder, e.file), 'w') as f:
                f.write('\n'.join(e.text) + '\n')
    found = {}
    for kind, answers in (('maxima', functools.partial(maxima_answers, words)),
                          ('octave', octave_answers), ('shell', shell_answers),
                          ('python', python_answers)):
        mine = [e for e in members if e.kind == kind and not e.file]
        steps = [(e, s) for e in mine for s in e.steps()]
        if not steps:
            continue
        said = answers([s for _, s in steps], folder)
        for k, (e, s) in enumerate(steps):
            prompt, lines = said[k] if k < len(said) else ('', ['nothing: the session has ended'])
            found.setdefault(e, []).append((s[0], s[1], prompt, lines))
    return found


def shown(answers):
    """the example as it would be typed"""
    lines = []
    for typed, expected, prompt, said in answers:
        lines += [prompt + typed[0]] + typed[1:] + (expected if agrees(expected, said) else said)
    return lines


def differs(answers):
    """the first difference, told"""
    for typed, expected, prompt, said in answers:
        if not agrees(expected, said):
            return '%s\n--- expected\n%s\n--- found\n%s' % (prompt + '\n'.join(typed),
                                                           '\n'.join(expected), '\n'.join(said))
    return None


def pictures(path, folder):
    """those that the file shows and the session has made go to figures/ beside it"""
    with open(path) as f:
        names = re.findall(r'@image\{figures/([\w-]+)', f.read())
    for name in names:
        made = os.path.join(folder, name + '.png')
        if os.path.exists(made):
            os.makedirs(os.path.join(os.path.dirname(path), 'figures'), exist_ok=True)
            shutil.copy(made, os.path.join(os.path.dirname(path), 'figures'))


def lines_of(path):
    """the lines of a file; those of a help text of Octave without the signs of a comment"""
    with open(path) as f:
        lines = f.read().split('\n')
    return [re.sub('^## ?', '', line) for line in lines] if path.endswith('.m') else lines


def processor_time():
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(u.ru_utime + u.ru_stime for u in used)


def judged(name, members, write):
    """types a session; {example: its text as it should be} where that is not what was found"""
    begun = processor_time()
    of_strangers = any(e.path == os.path.join(ROOT, 'README.md') for e in members)
    words, loaded = maxima(ROOT, image=not of_strangers)
    folder, change = workplace(loaded), {}
    try:
        for e, answers in typed_session(members, folder, words).items():
            wrong = differs(answers)
            place = '%s:%d: session %s' % (os.path.relpath(e.path, ROOT), e.first, name)
            print('not ok %s: %s' % (place, wrong) if wrong else 'ok ' + place, flush=True)
            if wrong:
                change[e] = shown(answers)
        if write:
            for path in {e.path for e in members}:
                pictures(path, folder)
    finally:
        shutil.rmtree(folder)
    print('session %s: %.1f s of processor time' % (name, processor_time() - begun), flush=True)
    return change


def rewritten(path, change):
    """the file with the examples as they should be"""
    escape = str if path.endswith('.md') else texinfo_escaped
    mark = '## ' if path.endswith('.m') else ''
    with open(path) as f:
        lines = f.read().split('\n')
    for e in sorted((e for e in change if e.path == path), key=lambda e: -e.first):
        lines[e.first:e.last] = [(mark + escape(line)).rstrip() for line in change[e]]
    with open(path + '.new', 'w') as f:
        f.write('\n'.join(lines))
    shutil.copymode(path, path + '.new')
    os.rename(path + '.new', path)


def all_files():
    """all that print sessions, but the chapters that `make manual` makes of help texts"""
    copies = ['%s.texi' % name for name in ('maxima', 'octave', 'elements', 'entries')]
    found = [glob.glob(os.path.join(ROOT, *place)) for place in
             (('share', 'manual', '*.texi'), ('octave', 'gsmbp_*.m'), ('README.md',))]
    return [path for paths in found for path in sorted(paths)
            if os.path.basename(path) not in copies]


def part_of(sessions, part, parts):
    """the names of the sessions of a part: the longest first, each to the shortest part so far; a
    session takes as long as some 15 inputs before its first one"""
    length = {name: 15 + sum(len(e.steps()) for e in members if e.kind)
              for name, members in sessions.items()}
    taken = [[] for _ in range(parts)]
    for name in sorted(length, key=lambda name: (-length[name], name)):
        min(taken, key=lambda names: sum(length[n] for n in names)).append(name)
    return taken[part - 1]


def main():
    write = '--write' in sys.argv
    only = next((a[len('--only='):] for a in sys.argv if a.startswith('--only=')), None)
    part = next((a[len('--part='):] for a in sys.argv if a.startswith('--part=')), '1/1')
    paths = [os.path.abspath(a) for a in sys.argv[1:] if not a.startswith('--')] or all_files()
    found = [e for path in paths for e in examples(path, lines_of(path))]
    for e in found:
        if e.session is None:
            print('not ok %s:%d: an example that belongs to no session' % (e.path, e.first))
    change = {}
    sessions = {name: [e for e in found if e.session == name]
                for name in dict.fromkeys(e.session for e in found if e.session)}
    for name in [only] if only else part_of(sessions, *map(int, part.split('/'))):
        change.update(judged(name, sessions[name], write))
    if write:
        for path in {e.path for e in change}:
            rewritten(path, change)


main()
