"""Inverse dynamics along a planned motion."""
import collections
import ctypes

import numpy as np

from . import _run
from ._library import Error, LIBRARY, NAME, NO_INPUTS, ROUTINES, SCENE, SIZES, TABLE, at

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
    follow = _Follower(who, self, poly, planned, guess)
    qj = np.stack([follow(t, side) for t in times], axis=2)
    q, u, ud = (qj[:, k] for k in range(3))
    tau = lam = v = x = margins = None
    if SIZES['nlam'] and 'inl' in ROUTINES:
        tau, lam = self.inl(times, q, u, ud, **NO_INPUTS)
    elif 'inv' in ROUTINES:
        tau = self.inv(times, q, u, ud, **NO_INPUTS)
    if 'cmx' in ROUTINES:
        states = _carried(who, self, poly, planned, guess, times, devices)
        found = self.cmx(times, qj, states)
        v, margins = found.v, found.g
        x = np.concatenate([q, u, found.xa])
    elif 'cmd' in ROUTINES:
        v = self.cmd(times, qj, np.zeros(0)).v
    return Inverse(times, q, u, ud, qj, tau, lam, v, x, margins)


class _Follower:
    """The motion with its derivatives at rising times, loops completed on one branch."""

    def __init__(self, who, model, poly, planned, guess):
        self.who, self.model, self.poly = who, model, poly
        self.planned = np.array(planned, np.intc)
        self.order = TABLE['command_order']
        self.closed = SIZES['nlam'] > 0 and len(planned) < SIZES['nu']
        self.qj = np.zeros((SIZES['nu'], self.order + 1), order='F')
        self.qj[:, 0] = guess
        self.w = np.zeros(len(planned) * (self.order + 1) + 2 * SIZES['nu'] + 2)
        self.flat = poly.flat()

    def __call__(self, t, side):
        if not self.closed:
            return np.stack(self.poly.derivatives(t, range(self.order + 1), side), axis=1)
        if self.w[1] == 0:   # a guess
            self._close(t, side)
        pieces, order = self.poly.coefficients.shape[1:]
        number = ctypes.c_int
        info = LIBRARY.gs_loop_follow(
            SCENE, ctypes.c_double(t), number(side), number(self.order), number(len(self.planned)),
            at(self.planned), number(pieces), number(order), at(self.flat),
            at(self.flat, pieces + 1), at(self.model.cst), at(self.qj), at(self.w))
        if info != 0:
            raise Error('%s: the loop cannot follow the motion at t = %.9g s: %s' % (
                self.who, t, _run.meaning('clo', info)), info)
        return self.qj.copy(order='F')

    def _close(self, t, side):
        """The first place: on the branch of the guess, along the straight way from it."""
        q, done = self.qj[:, 0].copy(), np.zeros(1)
        start = q[self.planned - 1]
        target = np.ascontiguousarray(self.poly.derivatives(t, range(1), side)[0])
        n, nu = len(self.planned), SIZES['nu']
        number = ctypes.c_int
        info = LIBRARY.gs_loop_close(
            SCENE, ctypes.c_double(t), number(self.order), number(n), at(self.planned), at(target),
            at(self.model.cst), at(q), at(done), at(np.zeros(nu * (self.order + 5) + 2 * n)))
        if info != 0:
            raise Error(
                '%s: the loop cannot follow the motion at t = %.9g s: it does not close at %s (%s)'
                % (self.who, t, ' '.join('%.6g' % x for x in start + done * (target - start)),
                   _run.meaning('clo', info)), info)
        self.qj[:, 0] = q


def _carried(who, model, poly, planned, guess, times, devices):
    """States of the devices at the times: internal ones integrated by their own rates."""
    inside = np.array(TABLE.get('internal') or [], int) - SIZES['nq'] - SIZES['nu'] - 1
    found = np.tile(devices[:, None], len(times))
    if not len(inside):
        return found
    follow = _Follower(who, model, poly, planned, guess)
    xi = devices.copy()

    def rate(t, y):
        xi[inside] = y
        return model.cmx(t, follow(t, 1), xi).xid[inside]
    follow(times[0], 1)
    for k in range(1, len(times)):
        found[inside, k] = _integrated(who, rate, times[k - 1], times[k], found[inside, k - 1])
    return found


_A = ((1 / 5,), (3 / 40, 9 / 40), (44 / 45, -56 / 15, 32 / 9),
      (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
      (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
      (35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84))
_C = (1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1)
_E = (71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)


def _integrated(who, rate, t, end, y, rtol=1e-11):
    """y at the time end, by Dormand and Prince of order 5."""
    h = (end - t) / 8
    atol = 1e-13 * max(1.0, np.abs(y).max(initial=0))
    f = [rate(t, y)]
    while t < end:
        h = min(h, end - t)
        for a, c in zip(_A, _C):
            z = y + h * sum(x * g for x, g in zip(a, f))
            f.append(rate(t + c * h, z))
        error = np.abs(h * sum(x * g for x, g in zip(_E, f)))
        ratio = (error / (atol + rtol * np.maximum(np.abs(y), np.abs(z)))).max(initial=0)
        if not np.isfinite(ratio) or h < 1e-12 * max(1.0, abs(end)):
            raise Error('%s: the internal states cannot be integrated beyond t = %.9g s' % (who, t))
        if ratio <= 1:
            t, y = (end if h >= end - t else t + h), z
        f = [f[-1 if ratio <= 1 else 0]]   # the last rates are those where the next step begins
        h *= min(5.0, max(0.2, 0.9 * max(ratio, 1e-10) ** -0.2))
    return y
