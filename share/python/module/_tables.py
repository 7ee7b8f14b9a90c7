"""What all hosts of runs share, as the library has it (gsmbp/options.h, methods.h, limits.h,
refusals.h, statistics.h and failures.h)."""
from types import SimpleNamespace

import numpy as np

from ._library import LIBRARY

(_COUNTS, _VALUES, _OPTIONS, _KINDS, _METHODS, _LOOPS, _LIMITS, _REFUSALS, _VERDICTS) = (
    [line.split('\t') for line in LIBRARY.gs_loop_table(k).decode().splitlines()]
    for k in range(9))
COUNTS, VALUES, VERDICTS = ([name for name, in rows] for rows in (_COUNTS, _VALUES, _VERDICTS))
METHODS = {word: int(number) for word, number, *_ in _METHODS}
FIXED = [row[0] for row in _METHODS if row[2] == 'fixed']   # methods with steps of one length
PLACE = {row[0]: row[3] for row in _METHODS}                # of their code
WAYS = tuple(word for word, _ in _LOOPS)
LIMITS = SimpleNamespace(**{name: float(value) for name, value in _LIMITS})
REFUSALS = SimpleNamespace(**dict(_REFUSALS))
_EXPECTED = dict(_KINDS)


def _default(text):
    try:
        return int(text) if text.isdigit() else float(text)
    except ValueError:
        return {'none': None, 'true': True}.get(text, text)


DEFAULT = SimpleNamespace(**{name: _default(text) for name, _, text in _OPTIONS})
KIND = {name: kind for name, kind, _ in _OPTIONS}


def is_number(x):
    x = np.asarray(x)
    return x.shape == () and x.dtype.kind in 'fiub' and bool(np.isfinite(x))


_FITS = {'positive': lambda x: x > 0, 'nonnegative': lambda x: x >= 0,
         'tolerance': lambda x: 0 < x < 1,
         'steps': lambda x: 0 <= x <= LIMITS.fixed_steps and x == int(x)}


def expected(name, value, kind=None):
    """What an option should be, and what was found."""
    return 'expected %s; found %r' % (_EXPECTED[kind or KIND[name]], value)


def check(who, name, value, kind=None):
    """Refuse the number of an option that is not of its kind."""
    kind = kind or KIND[name]
    if not (is_number(value) and _FITS[kind](value)):
        raise ValueError('%s: %s: %s' % (who, name, expected(name, value, kind)))
