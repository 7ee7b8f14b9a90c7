"""States on the constraints from rough ones (host/assemble/assemble.h)."""
import warnings

import numpy as np

from . import _linear, _run
from ._library import Error, LIBRARY, NAME, SIZES, TABLE, at
from ._structures import Assembly, AssemblyAsked
from ._tables import check, is_number

NQ, NX = SIZES['nq'], SIZES['nx']


def assemble(self, guess, *, hold=(), time=0.0, tolerance=1e-10, branches=0):
    """A state that fulfils the constraints, from a rough one, as gsmbp_assemble of Octave finds it.

    guess: the nx states, or the nq coordinates alone: the others are then as in initial, filters
    and observers settled. Coordinates and speeds are moved as little as possible in the metric of
    the mass matrix, or, where hold names coordinates, these and the speeds that move them stay as
    they are and the others follow on the branch of the guess; of Euler parameters all four may be
    held, or none. time [s]: of constraints; tolerance: the largest |phi| that may be left.
    branches: so many more guesses around it are tried, the same ones at every call; the different
    states come back as columns, the one next to the guess first: hold the independent coordinates.

    Result: x (nx,), with branches (nx, n). A loop that does not close, or values that only another
    branch reaches, are an Error; a position where constraints lose rank and held coordinates beyond
    the limits of their joints are a RunWarning.
    """
    who = NAME + '.assemble'
    check(who, 'tolerance', tolerance, 'positive')
    if not (is_number(branches) and 0 <= branches <= 1e6 and branches == int(branches)):
        raise ValueError('%s: branches: expected a whole number from 0 to 1000000; found %r' % (
            who, branches))
    t = _run._vector(who, 'time', [time] if np.ndim(time) == 0 else time, 1, 'time [s]')[0]
    bare = np.shape(guess) == (NQ,)
    if bare and NX != NQ:
        guess = np.concatenate([guess, self.initial[NQ:]])
    what = 'numbers (the states of %s, or its %d coordinates)' % (NAME, NQ)
    x = _run._vector(who, 'guess', guess, NX, what, self.states)
    found = closed(who, self, x, hold, t, tolerance, int(branches), bare)
    return found if branches else found[:, 0]


def closed(who, model, x, hold, t=0.0, tolerance=1e-10, branches=0, settle=False):
    """The states (nx, n) from the guess x (nx,)."""
    held = np.zeros(NQ, np.intc)
    held[_linear.places(who, 'hold', hold, model.coordinates, 'the name of a coordinate')] = 1
    asked = AssemblyAsked(
        t=t, branches=branches, longest=_longest(model), tolerance=tolerance, settle=settle,
        rank=_linear.general_rank())
    for name, numbers, kind in (('cst', model.cst, float), ('held', held, np.intc),
                                ('limits', joint_limits(model), float)):
        asked.put(name, numbers, kind)
    states = np.zeros((NX, 1 + branches), order='F')
    states[:, 0] = x
    found = Assembly()
    if LIBRARY.gs_loop_assemble(asked.address(), at(model.initial), at(states), found.address()):
        raise MemoryError(who)
    if not found.n:
        raise Error('%s: %s' % (who, found.text.decode()))
    for text in (found.beyond, found.lost):
        if text:
            warnings.warn('%s: %s' % (who, text.decode()), _run.RunWarning, stacklevel=4)
    return states[:, :found.n].copy()


def joint_limits(model):
    """(nq, 2): the least and largest values of the coordinates by the scene."""
    limits = np.tile([-np.inf, np.inf], (NQ, 1))
    for row in TABLE.get('limits') or []:
        if row['name'] in model.coordinates:
            limits[model.coordinates.index(row['name'])] = row['low'], row['high']
    return limits


def _longest(model):
    """The largest parameter that is a length [m]."""
    return max((abs(value) for name, value in model.parameters.items()
                if model.units['parameters'][name] == 'm'), default=0.0)
