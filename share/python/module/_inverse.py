"""Inverse dynamics along a planned motion."""
import collections

import numpy as np

from . import _run
from ._library import Error, LIBRARY, NAME, NO_INPUTS, ROUTINES, SIZES, TABLE, address
from ._structures import Planned, PlannedAsked

Inverse = collections.namedtuple('Inverse', 't q u ud qj tau lam v x margins')


def inverse(self, motion, times, *, side=1, guess=None, internal=None):
    """What a planned motion needs, through loops and actuators, at the times (rising) [s].

    motion: a Piecewise (plan) of the actuated coordinates, or of all of an open chain; side: which
    limit to take at its breaks, 1 right, -1 left; guess (nq,): where the loops begin to close
    (default initial); internal: states of the devices at the first time (default initial).
    Result: t; q, u, ud (n, k): the motion, loops completed; qj (n, 1 + order, k): with all its
    derivatives; tau: efforts of the actuated coordinates (of all, in an open chain), lam:
    multipliers; v: inputs, x: states along the motion, margins: above 0 where the command can be
    given. What the scene has no subroutine for is None.
    """
    who = NAME + '.inverse'
    poly, planned = _run.planned_motion(who, motion)
    times = _run.rising(who, times)
    if side not in (-1, 1):
        raise ValueError('%s: side: expected 1 (right) or -1 (left); found %r' % (who, side))
    start = self.initial
    guess = _run._vector(who, 'guess', start[:SIZES['nq']] if guess is None else guess, SIZES['nq'])
    devices = start[SIZES['nq'] + SIZES['nu']:] if internal is None else internal
    devices = _run._vector(who, 'internal', devices, SIZES['nx'] - SIZES['nq'] - SIZES['nu'])
    qj, states = along(who, self, poly, planned, times, side, guess, devices)
    q, u, ud = (qj[:, k] for k in range(3))
    tau = lam = v = x = margins = None
    if SIZES['nlam'] and 'inl' in ROUTINES:
        tau, lam = self.inl(times, q, u, ud, **NO_INPUTS)
    elif 'inv' in ROUTINES:
        tau = self.inv(times, q, u, ud, **NO_INPUTS)
    if 'cmx' in ROUTINES:
        found = self.cmx(times, qj, states)
        v, margins = found.v, found.g
        x = np.concatenate([q, u, found.xa])
    elif 'cmd' in ROUTINES:
        v = self.cmd(times, qj, np.zeros(0)).v
    return Inverse(times, q, u, ud, qj, tau, lam, v, x, margins)


def along(who, model, poly, planned, times, side, guess, devices=None):
    """The motion of all coordinates at the times, one after the other, (nu, 1 + order, n), loops
    closed from the guess on; with the states of the devices at the first time theirs, (.., n)."""
    if SIZES['nlam'] and len(planned) < SIZES['nu']:
        model._has('clo')
    n, order = len(times), TABLE['command_order']
    qj = np.zeros((SIZES['nu'], 1 + order, n), order='F')
    states = np.zeros((SIZES['nx'] - SIZES['nq'] - SIZES['nu'], n), order='F')
    pieces, powers = poly.coefficients.shape[1:]
    asked = PlannedAsked(side=side, order=order, nplanned=len(planned), pieces=pieces,
                         powers=powers, carry=devices is not None, n=n)
    asked.put('planned', planned, np.intc)
    for name, numbers in (
            ('cst', model.cst), ('breaks', poly.breaks), ('coefficients', poly.coefficients),
            ('guess', guess), ('devices', states[:, 0] if devices is None else devices),
            ('t', times)):
        asked.put(name, numbers)
    found = Planned(qj=address(qj), devices=address(states))
    bad = LIBRARY.gs_loop_planned(asked.address(), found.address())
    if bad == 1:
        raise MemoryError(who)
    if bad:
        raise Error('%s: %s' % (who, found.text.decode()))
    return qj if devices is None else (qj, states)
