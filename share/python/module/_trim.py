"""Equilibria and steady motions (host/linear/linear.h)."""
import collections
import warnings

import numpy as np

from . import _linear, _run
from ._library import Error, LIBRARY, MODES, NAME, ROUTINES, SIZES, TABLE
from ._structures import Told, TrimAsked, TrimFound
from ._tables import check, REFUSALS

NQ, NU, NX, NV, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'nlam'))
WAYS = ('newton', 'levenberg', 'transient')

Trim = collections.namedtuple(
    'Trim', 'x v ud lam phi residual way running indifferent unique')
Trim.__doc__ = """What trim gives: x (nx,), v (nv,); ud (nu,): accelerations that are left; lam,
phi (nlam,): multipliers, constraints; residual: the largest rate or constraint in usual sizes; way:
how it was found; running: names of coordinates that run; indifferent: of states and free inputs
that can be moved without leaving it; unique (nlam,): which multipliers it determines."""


def trim(self, x, v=None, *, hold=(), free=(), steady=(), time=0.0, tolerance=1e-9,
         margins='check'):
    """An equilibrium near the states x (or the coordinates) and the inputs v (default zeros), or a
    steady motion, as gsmbp_trim of Octave finds it.

    hold: names of states that stay as they are; free: of inputs that are adjusted as well, of a
    steady motion of speeds, too; steady: of coordinates that run on at the constant speeds that x
    has for them. time [s]: of what depends on it. tolerance: of rates, by usual sizes of the states
    in a second, and of constraints. margins: "check", no device may be where its laws do not hold,
    or "ignore". Result: a Trim; that none is found is an exception with what does not vanish.
    """
    who = NAME + '.trim'
    self._has('jac')
    check(who, 'tolerance', tolerance, 'tolerance')
    _run._word(who, 'margins', margins, ('check', 'ignore'))
    t, x, v = _linear.numbers(who, self, time, x, v)
    steady = _linear.listed(who, 'steady', steady)
    asked = TrimAsked(steady=bool(steady), margins=margins == 'check', tolerance=tolerance)
    for member, numbers in _asked(who, self, hold, free, steady).items():
        asked.put(member, numbers or [0], np.intc)
        if 'n' + member in dict(TrimAsked._fields_):
            setattr(asked, 'n' + member, len(numbers) // (2 if member == 'running' else 1))
    asked.put('par', self._values)
    found, told = TrimFound(), Told()
    for name, size, kind in (('x', NX, float), ('v', NV, float), ('running', NQ, np.intc),
                             ('indifferent', NX + NV, np.intc)):
        found.put(name, np.zeros(max(1, size)), kind)
    LIBRARY.gs_loop_trim(_linear.place(self, t, x, v).address(), asked.address(), found.address(),
                         told.address())
    _linear.heed(who, self, told, Error)
    if found.warning:
        warnings.warn('%s: %s' % (who, found.warning.decode()), _run.RunWarning, stacklevel=3)
    r = _result(self, t, found)
    loose = _linear.warn_of_rank(who, self, t, r.x, REFUSALS.singular_rest)
    return r._replace(unique=r.unique & ~loose)


def _asked(who, model, hold, free, steady):
    """The names as numbers."""
    for name in _linear.listed(who, 'free', free):
        if name in [model.inputs[k] for k in MODES]:
            raise ValueError('%s: free: %s is the mode of an event (0: holds, -1 or 1: slips), no '
                             'input; v holds it' % (who, name))
    known, expected = model.inputs, 'the name of an input'
    if steady:
        known, expected = known + model.speeds, 'the name of an input or a speed'
    numbers = _linear.places(who, 'free', free, known, expected)
    pairs = [_linear.speed_of(who, model, 'steady', name)
             for name in steady]
    return {'hold': _linear.places(who, 'hold', hold, model.states, 'the name of a state'),
            'inputs': [k for k in numbers if k < NV],
            'speeds': [NQ + k - NV for k in numbers if k >= NV],
            'running': [k for pair in pairs for k in pair], 'modes': list(MODES)}


def _result(model, t, found):
    x, v = found.kept['x'][:NX], found.kept['v'][:NV]
    lam, phi = np.zeros(0), np.zeros(0)
    if NLAM:
        lam = model.acc(t, x, v).lam if 'acc' in ROUTINES else None
        phi = model.con(t, x[:NQ], np.zeros(NU)).phi
    names = model.states + model.inputs
    return Trim(x, v, model.rhs(t, x, v)[NQ:NQ + NU], lam, phi, found.residual, WAYS[found.way],
                tuple(model.coordinates[k] for k in np.flatnonzero(found.kept['running'][:NQ])),
                tuple(names[k] for k in np.flatnonzero(found.kept['indifferent'])),
                np.array([row.get('unique', True) for row in TABLE.get('multipliers') or []], bool))
