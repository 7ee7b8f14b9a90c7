"""Derivatives of goals of a run, backwards: at a cost that does not depend on how many parameters
there are."""
import collections
import ctypes
import warnings

import numpy as np

from . import _run
from ._derivatives import Carried, KNOWN
from ._library import Error, LIBRARY, NAME, ROUTINES, SCENE, SIZES, TABLE, at
from ._structures import Result as Found, Start
from ._tables import DEFAULT

NX, NV, NY, NLAM = (SIZES[k] for k in ('nx', 'nv', 'ny', 'nlam'))
NO_MEMORY = 7   # of gsmbp/failures.h
LIBRARY.gs_loop_keep_steps.restype = ctypes.c_void_p
LIBRARY.gs_loop_forget_steps.restype = None

Adjoint = collections.namedtuple('Adjoint', 'J dJ dx0 run steps')
Adjoint.__doc__ = """What adjoint gives: J, the goals; dJ, a dict: their derivatives by each
parameter; dx0 (nx,), or (nx, k): by the start; run: the Result that the goal has seen; steps: how
many."""


def adjoint(self, x0, times, goal, *, rtol=DEFAULT.rtol, atol=DEFAULT.atol, start=DEFAULT.start,
            input=DEFAULT.input, fixed=DEFAULT.fixed, dx0=DEFAULT.dx0):
    """Goals of the run from the state x0 at times[0], and their derivatives by all parameters that
    the scene was derived for (requests adjoint and sensitivity) and by the start.

    goal: a function of a Result that gives (J, Jx) or (J, Jx, Jy): J a number or k numbers, Jx its
    derivatives by r.x, shape (nx, nt), of k goals (nx, nt, k), Jy those by r.y.
    rtol, atol, start: as simulate; input: constants or a Piecewise. dx0 (nx, n), fixed: what the
    start has of the parameters, as simulate. Steps are those of dp853, loops by Baumgarte's method;
    scenes without events and sampled devices.
    """
    who = NAME + '.adjoint'
    _refuse(who)
    times = _run.rising(who, times)
    _run._word(who, 'start', start, ('check', 'project'))
    x = _run._vector(who, 'x0', x0, NX, 'numbers (the states of %s)' % NAME, self.states)
    options = _run._options(who, self, 'dp853', rtol, atol, None, 0, 0, None,
                            'baumgarte', None, None)
    options.project = start == 'project'
    plan = _run._Plan(who, self)
    plan.inputs(input, times[0], x)
    begun = Carried.of(who, self, KNOWN, fixed, dx0, False, input)
    if NLAM > 0:
        begun.ask(options)
    model = self
    switches = model.swi() if 'swi' in ROUTINES else []
    inner = [] if plan.table is None else plan.table.breaks[1:-1]
    stops = np.unique(np.concatenate([times, [
        t for t in [*inner, *switches] if times[0] < t < times[-1]]]))
    run = _Kept(who, model, plan, begun, x, stops, options)
    r = _result(model, plan, times, run.states[:, np.searchsorted(stops, times)])
    J, Jx, Jy = _goals(who, goal, r)
    k = J.size
    dJ, by_start = np.zeros((len(KNOWN), k)), np.zeros((NX, k))
    for g in range(k):
        weights, alone = _at_outputs(model, r, Jx[:, :, g], Jy[:, :, g])
        all_ = np.zeros((NX, len(stops)), order='F')
        all_[:, np.searchsorted(stops, times)] = weights
        by_start[:, g], by_parameters = run.back(all_)
        dJ[:, g] = by_parameters + alone + begun.start.T @ by_start[:, g]
    if J.ndim == 0:
        dJ, by_start = dJ[:, 0], by_start[:, 0]
    return Adjoint(J, dict(zip(KNOWN, dJ)), by_start, r, run.steps)


def _refuse(who):
    if 'adj' not in ROUTINES:
        raise AttributeError('%s: %s was emitted without the subroutine ADJ: derive it with the '
                             'request adjoint of gsmbp_package' % (who, NAME))
    devices, events = TABLE.get('controllers') or [], TABLE.get('events') or []
    if events:
        raise ValueError('%s: no adjoint through events; %s has %s' % (
            who, NAME, events[0]['name']))
    if devices:
        raise ValueError('%s: no adjoint through samples; %s has sampled devices (%s)' % (
            who, NAME, devices[0]['name']))


class _Kept:
    """The run forward, whose steps are kept, and the way back."""

    def __init__(self, who, model, plan, begun, x, stops, options):
        self.who, self.model, self.plan, self.stops = who, model, plan, stops
        self.found = Found()
        given = Start(nt=len(stops))
        for name, value in (('times', stops), ('x0', x), ('par', model._values),
                            ('cst', model.cst)):
            given.put(name, value)
        LIBRARY.gs_loop_prepare(options.address(), given.address(), plan.given.address(),
                                self.found.address())
        _run._refuse(who, model, self.found)
        first = self.found.array('x', (self.found.nx,))
        x, atol, rtol = first[:NX], self.found.array('atol', (NX,)), self.found.rtol
        if self.found.nx > NX:
            begun.start = first[NX:].reshape(NX, begun.n, order='F')
        self.kept = ctypes.c_void_p(LIBRARY.gs_loop_keep_steps())
        if not self.kept:
            raise MemoryError(who)
        self.states = np.full((NX, len(stops)), np.nan, order='F')
        reached, steps = ctypes.c_double(), ctypes.c_int()
        with plan.ends:
            info = LIBRARY.gs_loop_forward(
                *self.scene(), at(x), ctypes.c_int(len(stops)), at(stops), ctypes.c_double(rtol),
                at(atol), self.kept, at(self.states), ctypes.byref(reached), ctypes.byref(steps))
        self.steps = steps.value
        self.ended(info, reached.value, 'the step became too small')

    def scene(self):
        return (SCENE, self.found.pointer('cst'), self.found.pointer('ip'),
                self.found.pointer('rp'), self.plan.ends.ask)

    def ended(self, info, reached, why):
        if self.plan.ends.failure is not None:
            raise self.plan.ends.failure
        if info == NO_MEMORY:
            raise MemoryError('%s at t = %.9g s' % (self.who, reached))
        if info != 0:
            raise Error('%s: %s at t = %.9g s' % (self.who, why, reached), info)

    def back(self, weights):
        """Derivatives by the start and by the parameters."""
        by_start, by_parameters = np.zeros(NX), np.zeros(len(KNOWN))
        reached = ctypes.c_double()
        with self.plan.ends:
            info = LIBRARY.gs_loop_backward(
                *self.scene(), self.kept, at(weights), at(by_start), at(by_parameters),
                ctypes.byref(reached))
        why = 'ADJ failed with INFO = %d, %s,' % (info, _run.meaning('adj', info))
        self.ended(info, reached.value, why)
        return by_start, by_parameters

    def __del__(self):
        if getattr(self, 'kept', None):
            LIBRARY.gs_loop_forget_steps(self.kept)
        if hasattr(self, 'found'):
            LIBRARY.gs_free_result(self.found.address())


def _result(model, plan, times, x):
    """The run as simulate gives it."""
    v = np.zeros((NV, len(times)))
    if plan.table is not None:
        v[:] = plan.table(times, side=-1)
        v[:, 0] = plan.table(times[0])
    elif 'constants' in plan.given.kept:
        v[:] = plan.given.kept['constants'][:, None]
    r = _run.Result(t=times, x=x, v=v, y=None, samples=None, events=None, audit=None, stats={
        'reached': times[-1]})
    if NY and 'out' in ROUTINES:
        with warnings.catch_warnings():
            warnings.simplefilter('ignore')
            r.y = model.out(_run._row_times(model, times, len(times)), x, v)
    return r


def _goals(who, goal, r):
    """J, Jx (nx, nt, k), Jy (ny, nt, k)."""
    found = goal(r)
    if not isinstance(found, tuple) or len(found) not in (2, 3):
        raise ValueError('%s: goal: expected (J, Jx) or (J, Jx, Jy), found %r' % (who, found))
    J = np.asarray(found[0], float)
    if J.ndim > 1:
        raise ValueError('%s: goal: expected a number or a vector J, found the shape %s' % (
            who, J.shape))
    both = []
    for name, given, of in (('Jx', found[1], r.x), ('Jy', (*found, None)[2], r.y)):
        shape = (np.shape(of) if of is not None else (NY, len(r.t))) + (J.size,)
        a = np.zeros(shape) if given is None else np.asarray(given, float)
        if a.shape not in (shape, shape[:2] if J.size == 1 else shape) or not np.isfinite(a).all():
            raise ValueError('%s: goal: expected %s of %d x %d x %d finite numbers, found the '
                             'shape %s' % (who, name, *shape, a.shape))
        both.append(a.reshape(shape))
    return (J, *both)


def _at_outputs(model, r, Jx, Jy):
    """Weights of the states at every time; what the outputs have of the parameters themselves."""
    weights, alone = Jx.copy(), np.zeros(len(KNOWN))
    if Jy.any():
        model._has('jac', 'oup')
        times = _run._row_times(model, r.t, len(r.t))
        for i in np.flatnonzero(Jy.any(axis=0)):
            state = times[i], r.x[:, i], r.v[:, i]
            weights[:, i] += model.linearize(*state).c.T @ Jy[:, i]
            alone += model.oup(*state).T @ Jy[:, i]
    return weights, alone
