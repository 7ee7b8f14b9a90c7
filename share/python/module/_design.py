"""What a design is asked for: variables, load cases, goals and demands, read from the arguments of
optimize."""
import collections
import inspect
import keyword

import numpy as np

from . import _inverse, _run, _trim
from ._arguments import guessed, nearest
from ._design_structures import WORDS
from ._library import TABLE
from ._tables import is_number

ALONE = ('value', 'mass')   # words that need no load case
RELATIONS = ('<', '>', '=')

# kind: parameter, state (its start) or own
Free = collections.namedtuple('Free', 'name kind start low high choices')
Row = collections.namedtuple('Row', 'word name function factor relation bound cases text')
Case = collections.namedtuple('Case', 'kind name given options target band')


def of_values(x):
    """Is it a function of one argument, the values of a design by their names?"""
    if not callable(x) or hasattr(x, 'breaks') or hasattr(x, 'c') or inspect.isclass(x):
        return False
    return arguments_of(x) == 1


def arguments_of(function):
    """How many arguments it must be given by place; 2 where it takes any number."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return 1
    if any(p.kind == p.VAR_POSITIONAL for p in parameters):
        return 2
    return sum(p.default is p.empty and p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)
               for p in parameters)


def rows_of(given, single):
    """A list of rows, of one row too: single says whether it is one."""
    if given is None:
        return []
    if single(given):
        return [given]
    return list(given)


def _finite(who, what, value, kind='a finite number'):
    if not is_number(value):
        raise ValueError('%s: %s: expected %s; found %r' % (who, what, kind, value))
    return float(value)


# ------------------------------------------------------------------------------- the variables

def read_free(who, model, given):
    rows = rows_of(given, lambda x: isinstance(x, (tuple, list)) and x and isinstance(x[0], str))
    found = []
    for row in rows:
        if not (isinstance(row, (tuple, list)) and len(row) == 3 and isinstance(row[0], str)):
            raise ValueError('%s: free: expected a row (name, start, (low, high)) for each '
                             'variable; found %r' % (who, row))
        found.append(_variable(who, model, *row))
    names = [one.name for one in found]
    for name in names:
        if names.count(name) > 1:
            raise ValueError('%s: free: %s is given twice' % (who, name))
    if not found:
        raise ValueError('%s: free: expected a row (name, start, (low, high)) for each variable; '
                         'found none' % who)
    return found


def _variable(who, model, name, start, bounds):
    what = 'free: %s' % name
    kind = _kind(who, model, name)
    start = _finite(who, what + ': start', start)
    choices = ()
    if isinstance(bounds, (set, frozenset)):
        if not bounds or not all(is_number(x) for x in bounds):
            raise ValueError('%s: %s: expected a set of finite numbers to choose from; found %r' % (
                who, what, bounds))
        if kind == 'state':
            raise ValueError('%s: %s: a start of a state cannot be chosen from a list' % (
                who, what))
        choices = tuple(sorted(float(x) for x in bounds))
        low, high = choices[0], choices[-1]
    else:
        low, high = _bounds(who, what, bounds)
    if not low <= start <= high:
        raise ValueError('%s: %s: expected a start from %g to %g; found %g' % (
            who, what, low, high, start))
    return Free(name, kind, start, low, high, choices)


def _bounds(who, what, given):
    try:
        low, high = (float(x) for x in given)
        if low < high:
            return low, high
    except (TypeError, ValueError):
        pass
    raise ValueError('%s: %s: expected bounds (low, high), the first below the second (-inf, inf: '
                     'none), or a set {a, b, ...}; found %r' % (who, what, given))


def _kind(who, model, name):
    if name in model.parameters:
        return 'parameter'
    if name in model.states:
        return 'state'
    for row in TABLE.get('dependent') or []:
        if row['name'] == name:
            raise ValueError('%s: free: %s is made of others, %s: expected one of these' % (
                who, name, row['expression']))
    if not name.isidentifier() or keyword.iskeyword(name):
        raise ValueError('%s: free: unknown name %r%s' % (
            who, name, nearest(name, list(model.parameters) + list(model.states))))
    return 'own'


# ------------------------------------------------------------------------------ the load cases

KINDS = {'run': (2, 'times, start'), 'inverse': (2, 'motion, times'), 'rest': (2, 'states, inputs'),
         'positions': (2, 'names, values')}
OWN = {'name': None, 'target': {}, 'band': 0.02}   # options of a case itself


def _keywords(function, *more):
    return [p.name for p in inspect.signature(function).parameters.values()
            if p.kind == p.KEYWORD_ONLY] + list(more)


OPTIONS = {'run': [name for name in _keywords(_run.simulate)
                   if name not in ('sensitivity', 'dx0', 'errors')],
           'inverse': _keywords(_inverse.inverse), 'rest': _keywords(_trim.trim),
           'positions': ['guess']}


def read_cases(who, model, given):
    rows = rows_of(given, lambda x: isinstance(x, (tuple, list)) and x and isinstance(x[0], str))
    found = [_case(who, model, k, row) for k, row in enumerate(rows)]
    names = [one.name for one in found]
    if len(set(names)) < len(names):
        raise ValueError('%s: cases: two have the same name: %s' % (who, ', '.join(names)))
    return found


def _case(who, model, k, row):
    what = 'cases: case %d' % (k + 1)
    if not (isinstance(row, (tuple, list)) and row and isinstance(row[0], str)):
        raise ValueError('%s: %s: expected (kind, arguments, ..., {option: value}); found %r' % (
            who, what, row))
    kind, given = row[0], list(row[1:])
    if kind == 'loop':
        raise ValueError('%s: %s: control loops ("loop") are for gsmbp_optimize of Octave alone; '
                         'expected one of %s' % (who, what, ', '.join(KINDS)))
    if kind not in KINDS:
        raise ValueError('%s: %s: unknown kind %r%s; expected one of %s' % (
            who, what, kind, guessed(kind, list(KINDS)), ', '.join(KINDS)))
    options = dict(given.pop()) if given and isinstance(given[-1], dict) else {}
    many, words = KINDS[kind]
    if len(given) != many:
        raise ValueError('%s: %s: %s: expected %s; found %d arguments' % (
            who, what, kind, words, len(given)))
    own = {name: options.pop(name, default) for name, default in OWN.items()}
    for name in options:
        if name not in OPTIONS[kind]:
            known = OPTIONS[kind] + list(OWN)
            raise ValueError('%s: %s: option %s is unknown%s; expected %s' % (
                who, what, name, guessed(str(name), known), ', '.join(known)))
    name = own['name'] or 'case%d' % (k + 1)
    if not (isinstance(name, str) and name.isidentifier()):
        raise ValueError('%s: %s: expected a name of letters and digits; found %r' % (
            who, what, name))
    if not (is_number(own['band']) and own['band'] > 0):
        raise ValueError('%s: %s: band: expected a finite number above 0; found %r' % (
            who, what, own['band']))
    if not isinstance(own['target'], dict):
        raise ValueError('%s: %s: target: expected a dict by names; found %r' % (
            who, what, own['target']))
    return Case(kind, name, given, options, own['target'], float(own['band']))


# ------------------------------------------------------------------------- goals and demands

def read_rows(who, what, given, cases, goal):
    """Goals (goal: true) or demands."""
    def single(x):
        return callable(x) or (isinstance(x, (tuple, list)) and len(x) > 0 and (
            isinstance(x[0], str) or (callable(x[0]) and not all(map(callable, x)))))
    rows = [(row,) if callable(row) else row for row in rows_of(given, single)]
    return [_row(who, '%s: row %d' % (what, k + 1), row, cases, goal)
            for k, row in enumerate(rows)]


def _row(who, here, row, cases, goal):
    if not isinstance(row, (tuple, list)) or not row:
        raise ValueError('%s: %s: expected a word and a name, or a function; found %r' % (
            who, here, row))
    rest = list(row)
    word, name, function = '', '', None
    if callable(rest[0]):
        function = rest.pop(0)
        text = getattr(function, '__name__', repr(function))
    else:
        word, name = _word_and_name(who, here, rest, cases)
        text = '%s %s' % (word, name)
        rest = rest[2:]
    numbers = range(len(cases))
    if rest and function is None and isinstance(rest[-1], str) and rest[-1] not in RELATIONS:
        names = [one.name for one in cases]
        if rest[-1] not in names:
            raise ValueError('%s: %s: unknown load case %r%s' % (
                who, here, rest[-1], nearest(rest[-1], names)))
        numbers = [names.index(rest[-1])]
        text += ' in ' + rest.pop()
    numbers = [] if function or word in ALONE else list(numbers)
    if goal:
        return Row(word, name, function, _factor(who, here, word, rest), '', 0.0, numbers, text)
    relation, bound = _demand(who, here, text, rest)
    return Row(word, name, function, 1.0, relation, bound, numbers,
               '%s %s %g' % (text, relation, bound))


def _word_and_name(who, here, row, cases):
    if len(row) < 2 or not all(isinstance(x, str) for x in row[:2]):
        raise ValueError('%s: %s: expected a word and a name, or a function; found %r' % (
            who, here, tuple(row)))
    if row[0] not in WORDS:
        raise ValueError('%s: %s: unknown word %r%s; expected one of %s' % (
            who, here, row[0], guessed(row[0], WORDS), ', '.join(WORDS)))
    if not cases and row[0] not in ALONE:
        raise ValueError('%s: %s: %s %s needs a load case (argument cases)' % (
            who, here, *row[:2]))
    return row[0], row[1]


def _factor(who, here, word, rest):
    if len(rest) > 1:
        raise ValueError('%s: %s: expected a word, a name and a factor; found %d more' % (
            who, here, len(rest) - 1))
    if word == 'each':
        raise ValueError('%s: %s: each is a word of demands; expected one number to make small' % (
            who, here))
    return _finite(who, here + ': factor', rest[0]) if rest else 1.0


def _demand(who, here, text, rest):
    if len(rest) != 2 or not isinstance(rest[0], str):
        raise ValueError('%s: %s: expected a relation ("<", ">", "=") and a bound after %s' % (
            who, here, text))
    _run._word(who, here + ': relation', rest[0], RELATIONS)
    return rest[0], _finite(who, here + ': bound', rest[1])
