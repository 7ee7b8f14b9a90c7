#!/usr/bin/python3
"""messages.py [--list] [MANUAL]: every message of the package stands in the manual's chapter.

A message is a call of `gs__error`, `gs__wrong`, `error`, `warning`, ... in the sources, or a text
of one of the functions in TEXTS, which make parts of messages and warnings. Of each call the
longest run of fixed words (two at least) between variable parts must stand in MANUAL
(share/manual/errors.texi), where variable parts are written @var{...}. Prints `ok`, or the
messages that are missing; --list prints all.
"""
import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GAP = '\x00'
CALLS = {
    'mac': r'(?<![\w?])(gs__error|gs__wrong|printf(?=\(true,))\(',
    'lisp': r'\((\$gs__raise|format t)(?=\s)',
    'm': r'(?<![\w."])(error|warning|refuse) \(',
    'cc': r'(?<!\w)(error|error_with_id|warning_with_id) \(',
}
# functions whose texts are parts of messages: file, function ('': all of the file)
TEXTS = [
    ('gsmbp/emit/info.mac', 'gs__info_sentences'),
    ('gsmbp/emit/info.mac', 'gs__bad_arguments'),
    ('gsmbp/emit/requests.mac', 'gs__why_left_out'),
    ('gsmbp/emit/requests.mac', 'gs__why_not_square'),
    ('gsmbp/emit/requests.mac', 'gs__say_too_long'),
    ('gsmbp/scene/value_rules.mac', 'gs__rule_texts'),
    ('gsmbp/scene/value_rules.mac', 'gs__warn_negative'),
    ('gsmbp/library/dimensions.mac', 'gs__number_remedy'),
    ('gsmbp/scene/written_units.mac', 'gs__name_notes'),
    ('gsmbp/scene/end_links.mac', 'gs__refuse_end'),
    ('gsmbp/scene/end_links.mac', 'gs__light_text'),
    ('gsmbp/scene/check.mac', 'gs__impossible_bodies'),
    ('gsmbp/scene/beam_limits.mac', 'gs__buckling_notes'),
    ('gsmbp/scene/beam_limits.mac', 'gs__section_notes'),
    ('gsmbp/scene/beam_limits.mac', 'gs__moments_left_out'),
    ('gsmbp/scene/beam_limits.mac', 'gs__data_notes'),
    ('share/engine/host/failure.c', ''),
    ('share/engine/host/residuals.c', ''),
    ('share/engine/host/start.c', ''),
    ('share/engine/host/margins.c', ''),
    ('share/engine/host/linear/tangent.c', ''),
    ('share/engine/host/linear/dropped.c', ''),
    ('share/engine/host/linear/linear.c', ''),
    ('share/engine/host/linear/trim_told.c', ''),
    ('share/engine/host/linear/vibrations.c', ''),
    ('share/engine/host/planned.c', ''),
    ('share/engine/host/carry_states.c', ''),
    ('share/engine/host/assemble/assemble.c', ''),
    ('share/engine/host/assemble/close_guess.c', ''),
    ('share/engine/host/ipopt/ipopt.c', ''),
    ('share/engine/host/collocation/ends.c', ''),
    ('share/engine/host/collocation/ended.c', ''),
    ('share/engine/host/collocation/nlp.h', ''),
    ('share/engine/host/nlopt/nlopt.c', ''),
    ('share/engine/host/optimize/solve_small.c', ''),
    ('share/engine/host/optimize/solve_design.c', ''),
    ('share/engine/host/optimize/choices.c', ''),
    ('share/engine/host/optimize/conflict.c', ''),
    ('share/engine/host/optimize/told.c', ''),
    ('share/engine/core/gsmbp/refusals.h', ''),
    ('octave/+gs/+run/failure_text.m', 'dependent_rows'),
    ('octave/+gs/+run/failure_text.m', 'fastest'),
    ('octave/+gs/+start/verdict_words.m', 'verdict_words'),
    ('octave/+gs/+given/check_kind.m', 'wanted'),
    ('share/engine/core/gsmbp/options.h', ''),
    ('octave/+gs/+identify/list_doubts.m', 'outside'),
    ('octave/+gs/+identify/list_doubts.m', 'large'),
    ('octave/+gs/+identify/list_doubts.m', 'impossible'),
    ('octave/+gs/+identify/list_doubts.m', 'noisy'),
    ('octave/+gs/+identify/exchanged_signals.m', 'exchanged_signals'),
    ('octave/+gs/+identify/late_efforts.m', 'late_efforts'),
    ('octave/+gs/+identify/rescaled_efforts.m', 'rescaled_efforts'),
    ('octave/+gs/+identify/wrong_rates.m', 'wrong_rates'),
]
FORMAT = re.compile(r'%[-+0-9.*]*l?[a-zA-Z]|~:\[|~\d*[a-zA-Z%\]*;]|~\n\s*')


def read(path):
    with open(os.path.join(ROOT, path)) as f:
        return f.read()


def uncommented(text, kind):
    """the text with comments blanked, strings kept"""
    comment = {'mac': r'/\*.*?\*/', 'lisp': r';[^\n]*', 'm': r'(?:##|%!)[^\n]*',
               'cc': r'//[^\n]*|/\*.*?\*/'}[kind]
    token = re.compile(r'("(?:\\.|[^"\\])*"|#\\.)|' + comment, re.S)
    return token.sub(lambda m: m.group(1) or re.sub(r'[^\n]', ' ', m.group(0)), text)


def closing(text, start):
    """where the parenthesis that opens at start is closed"""
    depth, k = 0, start
    while k < len(text):
        c = text[k]
        if c == '"':
            k = re.compile(r'"(?:\\.|[^"\\])*"', re.S).match(text, k).end()
            continue
        depth += (c in '([{') - (c in ')]}')
        if depth == 0:
            return k
        k += 1
    return k


def literal(text, kind):
    """what a string of the source says, variable parts as GAP"""
    text = re.sub(r'\\\n', '', text[1:-1])
    text = text.replace(r'\n', ' ').replace(r'\"', '"').replace('\\\\', '\\')
    return text if kind == 'mac' and '~' not in text else FORMAT.sub(GAP, text)


def pieces(text, kind):
    """runs of fixed words of an argument list; strings that follow each other are one"""
    if kind == 'mac':   # gs__error("place", ...) says "place: ..."
        text = re.sub(r'^\(\s*"([^"]*)"\s*,', r'("\1: "', text)
    token = re.compile(r'"(?:\\.|[^"\\])*"', re.S)
    said, end = '', 0
    for m in token.finditer(text):
        between = re.sub(r'[\s.\[\]]|\.\.\.', '', text[end:m.start()])
        joined = between in ('', ',') if kind == 'mac' else between == ''
        said += ('' if joined else GAP) + literal(m.group(0), kind)
        end = m.end()
    return [plain(p) for p in said.split(GAP)]


def plain(text):
    return re.sub(r'\s+', ' ', text).strip(' ;:,.()')


def kind_of(path):
    end = path.rsplit('.', 1)[1]
    return 'cc' if end in ('h', 'c') else end


def sources():
    for pattern in ('gsmbp/*.mac', 'gsmbp/*/*.mac', 'gsmbp/*.lisp', 'gsmbp/*/*.lisp', 'octave/*.m',
                    'octave/+gs/*/*.m', 'octave/glue/*.h', 'octave/glue/*.cc'):
        for path in sorted(glob.glob(os.path.join(ROOT, pattern))):
            yield os.path.relpath(path, ROOT)


def calls(path):
    """(line, fixed words) of the calls in a file"""
    kind = kind_of(path)
    text = uncommented(read(path), kind)
    for m in re.finditer(CALLS[kind], text):
        start = m.start() if kind == 'lisp' else m.end() - 1
        end = closing(text, start)
        if kind == 'mac' and re.match(r'\)\s*:=', text[end:]):
            continue
        if m.group(0).startswith('printf') and '"gsmbp' not in text[start:end]:
            continue   # what was asked for, no note
        yield text.count('\n', 0, m.start()) + 1, pieces(text[start:end], kind)


def said_by_shell(path):
    """(line, fixed words) of what a script of the shell says"""
    for k, line in enumerate(read(path).split('\n')):
        for m in re.finditer(r'''\becho (?:"([^"$]*)|'([^('][^']*))''', line):
            yield k + 1, [plain(m.group(1) or m.group(2) or '')]
        for m in re.finditer(r'''\becho "[^"]*?\$\w+([^"$]*)''', line):
            yield k + 1, [plain(m.group(1))]


def texts(path, name):
    """(line, fixed words) of the texts of a function"""
    kind = kind_of(path)
    text = uncommented(read(path), kind)
    begin = re.search(r'(?m)^' + name + r'\b|^function [^\n]*\b' + name + r'\b' if name else '',
                      text)
    if begin is None:
        sys.exit('messages.py: %s: no function %s' % (path, name))
    end = len(text)
    if name:
        end = re.compile(r'\$\s*$|^endfunction', re.M).search(text, begin.end()).end()
    for m in re.finditer(r'"(?:\\.|[^"\\])*"(?:[\s.\[]*"(?:\\.|[^"\\])*")*',
                         text[begin.start():end], re.S):
        for p in pieces(m.group(0), kind):
            if len(p) > 11 and ' ' in p:
                yield text.count('\n', 0, begin.start() + m.start()) + 1, [p]


def messages():
    """{fixed words: place}"""
    found = {}
    for path in sources():
        for line, parts in calls(path):
            words = max(parts, key=lambda p: (' ' in p, len(p)), default='')
            if ' ' in words:
                found.setdefault(words, '%s:%d' % (path, line))
    for path in sorted(glob.glob(os.path.join(ROOT, 'share/make/*'))):
        for line, parts in said_by_shell(os.path.relpath(path, ROOT)):
            if parts[0].count(' ') > 1 and '\\' not in parts[0]:
                found.setdefault(parts[0], '%s:%d' % (os.path.relpath(path, ROOT), line))
    for path, name in TEXTS:
        for line, parts in texts(path, name):
            found.setdefault(parts[0], '%s:%d' % (path, line))
    return found


def said_in(manual):
    """the manual as plain text"""
    text = re.sub(r'(?m)^@c .*$', '', manual)
    text = re.sub(r'@var\{[^}]*\}', GAP, text)
    text = re.sub(r'@(?:code|samp|option|file|w|r)\{((?:[^{}]|@[{}])*?)\}', r'\1', text)
    text = re.sub(r'@([@{}])', r'\1', text).replace('@dots{}', '...')
    return re.sub(r'\s+', ' ', text)


def main():
    names = [a for a in sys.argv[1:] if not a.startswith('--')]
    found = messages()
    if '--list' in sys.argv:
        for words, place in found.items():
            print('%s: %s' % (place, words))
        return
    manual = said_in(read(names[0] if names else 'share/manual/errors.texi'))
    missing = [(place, words) for words, place in found.items() if words not in manual]
    for place, words in missing:
        print('not ok the manual does not hold the message of %s: %s' % (place, words))
    if not missing:
        print('ok all %d messages stand in the manual' % len(found))
    sys.exit(bool(missing))


main()
