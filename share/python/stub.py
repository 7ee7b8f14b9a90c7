"""What of the stub __init__.pyi is made when a module is built: the options of simulate and the
statistics of a run with their types. Kinds, defaults and words are those of all hosts
(c/gsmbp/*.h); which of them the module has is read in _run.py.
"""
import ast
import os
import re

# types of the kinds of options.h, and of options of kind "any"
KINDS = {'flag': 'bool', 'tolerance': 'float', 'positive': 'float', 'nonnegative': 'float',
         'steps': 'int', 'list': 'ArrayLike', 'numbers': 'ArrayLike',
         'names': 'Union[str, Sequence[str]]'}
OPTIONS = {'step': 'float', 'atol': 'ArrayLike', 'maxorder': 'int', 'input': 'Input',
           'motion': 'Piecewise', 'gain': 'Any', 'reference': 'Any', 'limits': 'ArrayLike',
           'errors': "Literal['raise', 'return']"}
WORDS = {'method': ('methods.h', 'GS_METHODS'), 'start': ('options.h', 'GS_STARTS'),
         'loops': ('options.h', 'GS_LOOP_METHODS')}


def read(*path):
    with open(os.path.join(*path), encoding='utf-8') as file:
        return file.read()


def rows(home, header, table):
    """The entries of the rows of a table in the folder c of a package."""
    text = re.search(r'#define %s\(ROW\)(.*?[^\\])\n' % table, read(home, 'gsmbp', header), re.S)
    return [row.split(', ') for row in re.findall(r'ROW \(([^)]*)\)', text.group(1))]


def annotated(home, name, default):
    """An option of simulate as an argument of the stub."""
    kinds = {row[0]: row[1:] for row in rows(home, 'options.h', 'GS_OPTIONS')}
    kind, value = kinds.get(name, ('any', None))
    if name in WORDS:
        words = [row[0] for row in rows(home, *WORDS[name])]
        kind = 'Literal[%s]' % ', '.join(map(repr, words))
    else:
        kind = OPTIONS[name] if kind == 'any' else KINDS[kind]
    if default != 'DEFAULT.' + name:   # one of Python's own
        value = default
    elif value == 'none':
        kind, value = 'Optional[%s]' % kind, 'None'
    elif name in WORDS:
        value = repr(value)
    return '%s: %s = %s' % (name, kind, {'true': 'True', 'false': 'False'}.get(value, value))


def simulate(home, run):
    """The lines of simulate; run: the statements of _run.py."""
    found = [one for one in run if getattr(one, 'name', '') == 'simulate'][0].args
    options = [annotated(home, one.arg, ast.unparse(default))
               for one, default in zip(found.kwonlyargs, found.kw_defaults)]
    lead = '    def simulate('
    return [lead + 'self, x0: ArrayLike, times: ArrayLike, *,',
            *('%s%s,' % (' ' * len(lead), one) for one in options[:-1]),
            '%s%s) -> Result: ...' % (' ' * len(lead), options[-1])]


def statistics(home, run):
    """The statistics that are as the run time has them."""
    names = [ast.literal_eval(one.value) for one in run
             if isinstance(one, ast.Assign) and ast.unparse(one.targets[0]) == 'STATISTICS'][0]
    counts = [name for _, name in rows(home, 'statistics.h', 'GS_COUNTS')]
    return ['    %s: %s' % (name, 'int' if name in counts else 'float') for name in names]


def filled(home, module):
    """The lines of __init__.pyi in the folder of the module with those that are made."""
    run = ast.parse(read(module, '_run.py')).body
    made = {'    # simulate': simulate(home, run),
            '    # statistics': statistics(home, run)}
    lines = []
    for line in read(module, '__init__.pyi').splitlines():
        lines += made.get(line, [line])
    return lines
