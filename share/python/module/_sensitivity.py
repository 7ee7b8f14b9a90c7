"""Equilibria, their poles and frequencies by parameters (host/linear/linear.h)."""
import collections
import ctypes

import numpy as np

from . import _linear
from ._derivatives import KNOWN, need_rates
from ._library import Error, LIBRARY, NAME, SIZES, at
from ._structures import PoleSlopes, RestSlopes, SlopesAsked, Told

NQ, NX, NV, NY = (SIZES[k] for k in ('nq', 'nx', 'nv', 'ny'))

Sensitivity = collections.namedtuple(
    'Sensitivity', 'names dx dv dy poles dpoles frequency dfrequency damping ddamping')
Sensitivity.__doc__ = """What sensitivity gives: names of the parameters; dicts by them: dx (nx,),
dv (nv,), dy (ny,) of states, inputs and outputs of the equilibrium (dy NaN where OUP is not there);
poles (n,) [1/s] of the linear model, by rising size, dpoles: NaN of a multiple one; frequency
[rad/s] and damping ratio of those with positive imaginary part, dfrequency, ddamping."""


def sensitivity(self, x, v=None, *, hold=(), free=(), time=0.0):
    """How the equilibrium at the states x and the inputs v (default zeros), its poles and its
    frequencies change with the parameters that the scene was derived for (request sensitivity), as
    gsmbp_sensitivity of Octave has it.

    hold: names of states that keep their value; free: of inputs that follow, both as of trim;
    time [s]: of what depends on it. Derivatives of the equilibrium are exact to rounding, those of
    poles to some ten digits (differences of order 6 of the exact Jacobian). Result: a Sensitivity.
    """
    who = NAME + '.sensitivity'
    need_rates(who)
    self._has('jac')
    t, x, v = _linear.numbers(who, self, time, x, v)
    x = _linear.on_constraints(who, self, t, x, 'check')
    asked = SlopesAsked()
    for member, count, option, names, known, kind in (
            ('hold', 'nhold', 'hold', hold, self.states, 'state'),
            ('inputs', 'ninputs', 'free', free, self.inputs, 'input')):
        numbers = _linear.places(who, option, names, known, 'the name of %s %s' % (
            'an' if kind == 'input' else 'a', kind))
        asked.put(member, numbers or [0], np.intc)
        setattr(asked, count, len(numbers))
    asked.put_texts('names', KNOWN)
    found, told = RestSlopes(), Told()
    for name, rows in (('dx', NX), ('dv', NV), ('dy', NY)):
        found.put(name, np.zeros(rows * len(KNOWN) + 1))
    LIBRARY.gs_loop_rest_slopes(_linear.place(self, t, x, v).address(), asked.address(),
                                found.address(), told.address())
    _linear.heed(who, self, told)
    dx, dv, dy = (_linear.matrix(found.kept[name], rows, len(KNOWN))
                  for name, rows in (('dx', NX), ('dv', NV), ('dy', NY)))
    if not found.outputs:
        dy = np.full((NY, len(KNOWN)), np.nan)
    return Sensitivity(tuple(KNOWN), *map(_by_names, (dx, dv, dy)),
                       *_of_poles(who, self, (t, x, v), dx, dv))


def _by_names(columns):
    return {name: columns[:, k].copy() for k, name in enumerate(KNOWN)}


def _of_poles(who, model, state, dx, dv):
    """Poles, frequencies and damping ratios, each followed by its derivatives."""
    t, x, v = state
    here = _linear.at_state(who, model, t, x, v, 'auto', ())
    e, right, left = _eigenvectors(here.a)
    n = len(e)
    slopes = [np.zeros((n, len(KNOWN)), complex), np.zeros((n, len(KNOWN))),
              np.zeros((n, len(KNOWN)))]
    for k, name in enumerate(KNOWN if n else ()):
        change = _along(who, model, state, (dx[:, k], dv[:, k]), name, here.states)
        found = PoleSlopes()
        for member, size in (('poles', 2 * n), ('frequency', n), ('damping', n)):
            found.put(member, np.zeros(size))
        LIBRARY.gs_slopes_of_poles(ctypes.c_int(n), *map(at, (e.view(float), right, left, change)),
                                   found.address())
        slopes[0][:, k] = found.kept['poles'].view(complex)
        slopes[1][:, k], slopes[2][:, k] = found.kept['frequency'], found.kept['damping']
    up = e.imag > 0
    frequency, damping = oscillations(e)
    return (e, _by_names(slopes[0]), frequency, _by_names(slopes[1][up]), damping,
            _by_names(slopes[2][up]))


def oscillations(poles):
    """Frequencies and damping ratios of the poles with positive imaginary part."""
    up = poles[poles.imag > 0]
    return np.abs(up), -up.real / np.abs(up)


def _eigenvectors(a):
    """Eigenvalues by rising size, right and left eigenvectors, columns one behind another."""
    if not a.size:
        return np.zeros(0, complex), np.zeros(0), np.zeros(0)
    e, right = (part.astype(complex) for part in np.linalg.eig(a))
    others, left = (part.astype(complex) for part in np.linalg.eig(a.T))
    order = np.argsort(np.abs(e), kind='stable')
    e, right = e[order], right[:, order]
    same = [np.argmin(np.abs(others.conj() - one)) for one in e]
    return e, *(part.ravel(order='F').view(float) for part in (right, left[:, same]))


def _along(who, model, state, slopes, name, states):
    """The derivative of the Jacobian by a parameter, along the equilibria that follow it."""
    (t, x, v), (dx, dv), p = state, slopes, model.parameters[name]
    steps, factors = np.zeros(6), np.zeros(6)
    LIBRARY.gs_family_steps(ctypes.c_int(NX), at(model.nominal), ctypes.c_double(p),
                            at(np.ascontiguousarray(dx)), at(steps), at(factors))
    change = 0
    for s, factor in zip(steps, factors):
        changed = model.changed(**{name: p + s})
        change += factor * _linear.at_state(who, changed, t, x + s * dx, v + s * dv, states, ()).a
    return change.ravel(order='F')
