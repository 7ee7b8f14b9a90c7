"""same.py FILE: the messages of FILE (calls.txt) for one bad call are the same in all hosts, but
for the words of the host: its functions, classes of errors, how it writes values and places.
Prints ok or not ok for each call."""
import re
import sys

# calls that a host refuses by its own interface, or finds otherwise, with the reason
OTHER = {
    ('python', 8): 'a text where numbers are expected is of the language',
    ('python', 21): 'a text where numbers are expected is of the language',
    ('python', 45): 'no implicit methods',
    ('python', 47): 'no implicit methods',
    ('python', 49): 'names of arguments are of the language',
    ('python', 50): 'names of arguments are of the language',
    ('python', 53): 'no input is a word',
    ('fmu', 7): 'an FMU knows no units when it starts',
    **{('fmu', k): 'times are communication steps' for k in (17, 18, 19, 20)},
    ('fmu', 52): 'variables are set one by one',
    ('fmu', 66): 'variables have references',
    ('fmu', 67): 'the variable has bounds',
    ('fmu', 68): 'variables are set one by one',
    ('fmu', 73): 'the variable has bounds',
    ('sweep', 42): 'no audit of many runs',
    **{('sweep', k): 'a range of parameters' for k in (68, 70, 71)},
}


def words(text, scene):
    """What is said, without the words of the host."""
    for _ in range(3):
        text = re.sub(r'^(\(prepared by Octave\) |(\w*Error|warning): |gsmbp_\w+: |%s(\.\w+)?: )'
                      % scene, '', text)
    text = re.sub(r'\b(option|argument) |^the (?=gain)|^parameters: ', '', text)
    text = re.sub(r'^tolerance:', 'rtol:', text)
    text = re.sub(r'^x0[([]\d+[\])], ', '', text)            # places from 0 or from 1
    text = re.sub(r't = \S+ s', 't = T s', text)             # rounding of a time
    text = re.split(r'[,;:]? found|, a function|; known', text)[0]
    return text.strip().lower()


def is_same(a, b):
    """A host may have the first words of a list only."""
    listed = re.compile(r'one of .*')
    return a == b or listed.sub('', a) == listed.sub('', b) and (
        a.startswith(b.rstrip('"')) or b.startswith(a.rstrip('"')))


def calls(file):
    """(number, call, {host: message}) of those that more hosts than one refuse"""
    number, scene, call, said = 0, '', '', {}
    for line in open(file):
        if line.startswith('  '):
            host, text = line.strip().split(': ', 1)
            left_out = (host, number) in OTHER or text.startswith(('(no such call', 'accepted'))
            if not left_out:
                said[host] = words(text, scene)
            if host == 'sweep':
                yield number, call, said
        else:
            call, said = line.strip(), {}
            number, scene = int(call.split()[0]), call.split()[1]


bad = 0
for number, call, said in calls(sys.argv[1]):
    if not said:
        continue
    first = said.get('octave', '')
    for host, text in said.items():
        if not is_same(first, text):
            bad += 1
            print('not ok call %s: expected of %s the message of octave, "%s", found "%s"' % (
                call, host, first, text))
    if all(is_same(first, text) for text in said.values()):
        print('ok call %s: %s' % (call, ', '.join(said)))
sys.exit(bad > 0)
