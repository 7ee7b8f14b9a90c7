"""Inverse kinematics: coordinates that bring a point or frame to poses (host/reach/reach.h)."""
import collections
import ctypes

import numpy as np

from . import _run
from ._arguments import nearest
from ._assemble import joint_limits
from ._library import LIBRARY, NAME, ROUTINES, SIZES, TABLE, at

NQ, NU, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nlam'))
POINTS = [row['name'] for row in TABLE.get('points') or []]
CLOSED = TABLE.get('reach') or {}   # what IKN was emitted for
METHODS = ('auto', 'closed', 'newton')

Reach = collections.namedtuple('Reach', 'q status distance branch solutions free')
Reach.__doc__ = """What reach gives for k poses: q (nq, k), NaN where a pose is out of reach or
beyond the limits; status: "ok", "singular", "unreachable" or "limits" for each; distance (2, k):
what an unreachable pose misses of the place [m] and of the axes; branch (k,); solutions: all of
each pose, (nq, n); free (nu, k): speeds that do not move the tool where the pose is singular."""


def reach(self, name, P, R=None, *, start=None, branch=0, limits=None, method='auto', given=None,
          time=0.0):
    """Coordinates that bring the point or frame of this name to poses, as gsmbp_reach of Octave.

    P (3, k): places [m] in ground axes; R (3, 3, k): the axes there, rotation matrices, or (4, k),
    Euler parameters, scalar first; None: the place alone. One pose may leave out k.
    start: coordinates from which the first pose is looked for (default initial); branch: of IKN;
    limits (nq, 2): default those of the scene; method: "closed": by IKN alone, "newton": by NIK
    alone; given: values of the coordinates that IKN is given; time [s]: of constraints.
    Result: a Reach.
    """
    who = NAME + '.reach'
    P, R = _poses(who, P, R)
    job = _Job(who, self, name, P.shape[1], R is not None, start, branch, limits, method, given,
               time)
    found = []
    before = job.start
    for k in range(P.shape[1]):
        axes = np.eye(3) if R is None else R[:, :, k]
        one = job.pose(P[:, k], axes, k, before)
        found.append(one)
        if np.isfinite(one.q).all():
            before = one.q
    one = Reach(*zip(*found))
    columns = {part: np.stack(getattr(one, part), axis=-1) for part in ('q', 'distance', 'free')}
    return one._replace(branch=np.array(one.branch), **columns)


# ------------------------------------------------------------------------------------ the poses

def _poses(who, P, R):
    """Places (3, k) and rotation matrices (3, 3, k), or None."""
    P = _finite(who, 'P', P)
    P = P[:, None] if P.shape == (3,) else P
    if P.ndim != 2 or P.shape[0] != 3:
        raise ValueError('%s: P: expected places of the shape (3, k) [m]; found %s' % (
            who, P.shape))
    if R is None:
        return P, None
    R = _finite(who, 'R', R)
    k = P.shape[1]
    R = R[..., None] if R.shape in ((4,), (3, 3)) and k == 1 else R
    if R.shape not in ((4, k), (3, 3, k)):
        raise ValueError('%s: R: expected the shape (3, 3, %d) (rotation matrices), (4, %d) (Euler '
                         'parameters) or None; found %s' % (who, k, k, R.shape))
    return P, np.stack([_axes(who, R[..., i], i) for i in range(k)], axis=2)


def _finite(who, what, given):
    a = np.asarray(given)
    if a.dtype.kind not in 'fiu' or not np.isfinite(a).all():
        raise ValueError('%s: %s: expected finite numbers; found %r' % (who, what, given))
    return a.astype(float)


def _axes(who, given, k):
    """Of Euler parameters, or the closest rotation: decimals are rounded."""
    given, axes = np.ravel(given, order='F'), np.zeros((3, 3), order='F')
    why = ctypes.create_string_buffer(200)
    if not LIBRARY.gs_loop_axes(ctypes.c_int(given.size), at(given), ctypes.c_int(k), at(axes), why,
                                ctypes.c_int(len(why))):
        raise ValueError('%s: %s' % (who, why.value.decode()))
    return axes


# -------------------------------------------------------------------------------------- the job

_One = collections.namedtuple('_One', Reach._fields)


class _Job:
    """What is asked for, checked."""

    def __init__(self, who, model, name, k, turned, start, branch, limits, method, given, time):
        self.who, self.model, self.whole = who, model, turned
        if name not in POINTS:
            raise ValueError('%s: unknown point %r%s' % (
                who, name, nearest(name, POINTS)))
        self.tool = POINTS.index(name)
        frame = TABLE['points'][self.tool]['kind'] == 'frame'
        if turned and not frame:
            raise ValueError('%s: %s is a point, not a frame: expected its place alone, without '
                             'axes' % (who, name))
        _run._word(who, 'method', method, METHODS)
        self.closed = self.by_formula(name, method, frame and not turned)
        if not self.closed and 'nik' not in ROUTINES:
            raise AttributeError('%s: %s has no closed form here: emit the model with the request '
                                 'reach (or inverse_kinematics(%s))' % (who, name, name))
        model._has('jpt')
        self.given = self.values(given, k)
        self.start = _run._vector(who, 'start', model.initial[:NQ] if start is None else start, NQ)
        self.limits = self.bounds(limits)
        self.branch = self.number(branch)
        self.time = _run._vector(who, 'time', [time], 1)[0]
        self.turns = np.array([row['unit'] == 'rad' for row in TABLE['coordinates']], np.intc)

    def by_formula(self, name, method, alone):
        """Was IKN emitted for this tool; of a frame it does not know the place alone."""
        if alone and method == 'closed':
            raise ValueError('%s: method: IKN of %s takes its axes too: expected R' % (
                self.who, name))
        chains = CLOSED.get('chains') or []
        closed = ('ikn' in ROUTINES and CLOSED.get('tool') == name and len(chains) == 1
                  and not alone and method != 'newton')
        if closed:
            self.rows = [self.model.coordinates.index(q) for q in chains[0]['coordinates']]
        elif method == 'closed':
            raise ValueError('%s: method: IKN was not emitted for %s (request inverse_kinematics('
                             '%s)), or the chain is closed' % (self.who, name, name))
        return closed

    def values(self, given, k):
        """Of the coordinates that IKN is given: a column for each pose."""
        names = (CLOSED.get('given') or []) if self.closed else []
        self.names = [self.model.coordinates.index(name) for name in names]
        if not names:
            if given is not None:
                raise ValueError('%s: given: no coordinate of this model is given' % self.who)
            return None
        a = _finite(self.who, 'given', np.zeros(0) if given is None else given)
        a = a[:, None] if a.ndim == 1 else a
        if a.shape not in ((len(names), 1), (len(names), k)):
            raise ValueError('%s: given: expected a value of %s, one column or %d; found %s' % (
                self.who, ', '.join(names), k, a.shape))
        return np.broadcast_to(a, (len(names), k))

    def bounds(self, limits):
        limits = joint_limits(self.model) if limits is None else limits
        a = np.clip(np.asarray(limits, float), -1e300, 1e300)
        if a.shape != (NQ, 2):
            raise ValueError('%s: limits: expected the shape (%d, 2); found %s' % (
                self.who, NQ, a.shape))
        for k in np.flatnonzero(~(a[:, 0] <= a[:, 1])):
            raise ValueError('%s: limits: %s: the least, %g, is above the largest, %g' % (
                self.who, self.model.coordinates[k], *a[k]))
        return np.asfortranarray(a)

    def number(self, branch):
        most = ROUTINES['ikn'].nothing['br'].size if self.closed else 0
        if branch != int(branch) or not 0 <= branch <= most:
            raise ValueError('%s: branch: expected one of the %d branches of IKN (0: any), found '
                             '%r' % (self.who, most, branch))
        return int(branch)

    def pose(self, P, R, k, before):
        """One pose: its _One."""
        one = _One(np.full(NQ, np.nan), 'ok', np.zeros(2), 0, np.zeros((NQ, 0)), np.zeros(NU))
        if self.closed:
            one = self.closest(P, R, k, before, one)
        else:
            call = self.filled('nik', t=self.time, k=self.tool + 1, job=int(self.whole), p=P, r=R,
                               q=before, qlo=self.limits[:, 0], qhi=self.limits[:, 1])
            reached = call() == 0
            one = one._replace(distance=call.dst.copy(), status='ok' if reached else 'unreachable')
            if reached:
                one = one._replace(q=call.q.copy(), solutions=call.q[:, None].copy())
        return self.freed(one) if one.status in ('ok', 'singular') else one

    def filled(self, name, **values):
        call = self.model.kept(name)
        for argument, value in values.items():
            getattr(call, argument)[...] = value
        return call

    def closest(self, P, R, k, before, one):
        """Of all solutions within the limits the one closest to that before."""
        more = [a.name for a in ROUTINES['ikn'].given if a.name not in ('p', 'r')]
        named = {more[0]: self.given[:, k]} if self.names else {}
        call = self.filled('ikn', p=P, r=R, **named)
        info, n = call(), int(call.ns)
        one = one._replace(distance=call.dst.copy())
        if info == 1:
            return one._replace(status='unreachable')
        every = np.tile(before[:, None], n)
        every[self.rows] = call.qs[:, :n]
        if self.names:
            every[self.names] = self.given[:, k:k + 1]
        near = np.asfortranarray(every)
        number = ctypes.c_int
        i = LIBRARY.gs_loop_choose(
            number(NQ), at(self.turns), at(self.limits), at(np.ascontiguousarray(before)),
            number(n), at(near), at(call.br), number(self.branch))
        one = one._replace(solutions=every.copy(), status='singular' if info == 2 else 'ok')
        if i < 0:
            return one._replace(status='limits')
        return one._replace(q=near[:, i].copy(), branch=int(call.br[i]))

    def freed(self, one):
        """A speed that does not move the tool, where it is singular."""
        J = self.model.jpt(self.time, one.q, np.zeros(NU))[0]
        J = J[:6 if self.whole else 3, NU * self.tool:NU * (self.tool + 1)]
        if NLAM:
            J = np.concatenate([J, self.model.con(self.time, one.q, np.zeros(NU)).hc])
        J, speed = np.asfortranarray(J), np.zeros(NU)
        found = LIBRARY.gs_loop_free(
            ctypes.c_int(len(J)), ctypes.c_int(NU), at(J), ctypes.c_int(one.status == 'singular'),
            at(speed))
        if found < 0:
            raise MemoryError(self.who)
        return one._replace(free=speed, status='singular' if found else one.status)
