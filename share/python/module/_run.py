"""Runs: the start, the plan of a run as the run time has it, what comes back."""
import ctypes
import math
import time
import warnings

import numpy as np

from . import _start
from ._ends import Ends
from ._implicit import Choice, check_index2, sharp_friction
from ._library import (Error, LIBRARY, NAME, NO_INPUTS, ROUTINES, SCENE, SIZES, TABLE, address, at,
                       pointer)
from ._motion import Piecewise, as_piecewise
from ._tables import (COUNTS, DEFAULT, FIXED, LIMITS, METHODS, REFUSALS, VALUES, WAYS, check,
                      expected)

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))
AT_EVENT = 7       # what failed was an event: GS_AT_EVENT of gsmbp/failures.h, with the INFO
WRONG_MODE = 13    # where the mode that is given contradicts the state
ENDED = 11         # what a run says that an event of the user has ended
VIN = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, ctypes.c_int,
                       ctypes.POINTER(ctypes.c_double), ctypes.c_int, ctypes.c_int,
                       ctypes.c_void_p, ctypes.POINTER(ctypes.c_double))


class RunWarning(RuntimeWarning):
    """What a run has met: singular positions, stiffness, margins of devices."""


class Result:
    """What a run gives: t (nt,), x (nx, nt) states, v (nv, nt) inputs, y (ny, nt) outputs (None
    where the scene has none), stats (a dict); samples and events: dicts of arrays, or None."""

    def __init__(self, **fields):
        self.__dict__.update(fields)

    def __repr__(self):
        return '<run to t = %g s, %d times>' % (self.stats['reached'], len(self.t))


def meaning(name, info):
    """INFO of a subroutine in a sentence."""
    found = LIBRARY.gs_loop_meaning(name.lower().encode(), ctypes.c_int(info))
    return (found or b'failed').decode()


# ------------------------------------------------------------------------------------- the start

def _vector(who, what, given, n, text='finite numbers', names=None):
    a = np.asarray(given)
    numbers = a.dtype.kind in 'fiub' and a.shape == (n,)
    if names and numbers:
        for k in np.flatnonzero(~np.isfinite(a)):
            called = '%s[%d], %s' % (what, k, names[k])
            raise ValueError('%s: %s' % (who, REFUSALS.not_finite % (called, a[k])))
    if not numbers or not np.isfinite(a).all():
        raise ValueError('%s: %s: expected %d %s, found %s' % (
            who, what, n, text, a.tolist() if numbers else a.shape))
    return a.astype(float)


def rising(who, given):
    """Times as an array."""
    times = np.atleast_1d(np.asarray(given))
    wrong = None
    if times.dtype.kind not in 'fiu' or times.ndim != 1:
        wrong = repr(given)
    elif not times.size:
        wrong = 'none'
    elif not np.isfinite(times).all():
        k = int(np.flatnonzero(~np.isfinite(times))[0])
        wrong = '%g as number %d' % (times[k], k + 1)
    if wrong:
        raise ValueError('%s: %s' % (who, REFUSALS.times % wrong))
    late = np.flatnonzero(~(np.diff(times.astype(float)) > 0))
    if len(late):
        k = int(late[0])
        raise ValueError('%s: %s' % (
            who, REFUSALS.rising_times % (k + 1, times[k], times[k + 1])))
    return np.ascontiguousarray(times, float)


def _start_of(who, model, t, x0, start, modes):
    if start not in ('check', 'project'):
        raise ValueError('%s: start: expected one of "check", "project", found %r' % (who, start))
    x = _vector(who, 'x0', x0, NX, 'numbers (the states of %s)' % NAME, model.states)
    _start.take(who, model, t, x, start == 'check', modes)
    return x


# -------------------------------------------------------------------------------------- the plan

class _Pieces(ctypes.Structure):
    """gs_pieces of plan.h."""

    _fields_ = [(n, ctypes.c_int) for n in ('nc', 'np', 'k')] + [('numbers', ctypes.c_void_p)]


class _Given(ctypes.Structure):
    """gs_plan of plan.h."""

    _fields_ = [
        ('s', ctypes.c_void_p), ('nx', ctypes.c_int), ('inputs', ctypes.c_int),
        ('derivatives', ctypes.c_int), ('constants', ctypes.c_void_p), ('table', _Pieces),
        ('motion', _Pieces), ('planned', ctypes.c_void_p), ('reference', _Pieces),
        ('gain', _Pieces), ('limits', ctypes.c_void_p), ('memory', ctypes.c_void_p),
        ('on_the_way', ctypes.c_int), ('instants', ctypes.c_int), ('modes', ctypes.c_void_p),
        ('events', ctypes.c_int)]


if LIBRARY.gs_loop_plan_size() != ctypes.sizeof(_Given):
    raise ImportError('%s: the library was built with another plan.h' % NAME)


class _Plan:
    """What the plan of a run is made of (plan.h), its breaks, a callback."""

    def __init__(self, who, model, nx):
        self.who, self.model = who, model
        self.given = _Given(s=SCENE, nx=nx, derivatives=TABLE['command_order'])
        self.held, self.breaks, self.jumps = {}, [], frozenset()
        self.callback, self.ends = None, Ends()

    def put(self, name, numbers, kind=float):
        """An array of the plan, kept as long as it is."""
        self.held[name] = np.ascontiguousarray(numbers, kind).ravel(order='F')
        setattr(self.given, name, address(self.held[name]))

    def pieces(self, name, poly):
        self.held[name] = np.append(poly.flat(), 0.0)
        setattr(self.given, name, _Pieces(*poly.coefficients.shape, address(self.held[name])))
        self.breaks += poly.breaks[1:-1].tolist()

    def laid(self):
        """ip and rp."""
        given = ctypes.byref(self.given)
        ip = np.zeros(LIBRARY.gs_wholes(given), np.intc)
        rp = np.zeros(LIBRARY.gs_reals(given))
        LIBRARY.gs_lay(given, at(ip), at(rp))
        return ip, rp

    def motion(self, given):
        poly, planned = planned_motion(self.who, given)
        self.given.inputs = 2
        self.put('planned', planned, np.intc)
        self.pieces('motion', poly)

    def inputs(self, given, t0, x0):
        """Constants, a piecewise polynomial or a function v = f(t, x); what it is at the start is
        what the sampled devices hold before their first samples."""
        free = free_inputs()
        if given is None:
            given = np.zeros(NV)
        if callable(given) and not isinstance(given, Piecewise) and not hasattr(given, 'c'):
            self.given.inputs = 3
            self.callback = self.called(given, free)
            if TABLE.get('controllers'):
                self.put('constants', self.told(given, free, t0, x0[:NX]))
        elif isinstance(given, Piecewise) or hasattr(given, 'c'):
            poly = as_piecewise(self.who, 'input', given, getattr(given, 'n', NV)
                                if getattr(given, 'n', NV) in (NV, len(free)) else NV)
            self.given.inputs = 1
            self.pieces('table', poly if poly.n == NV else self.spread(poly, free))
        else:
            a = self.constants(np.atleast_1d(np.asarray(given)), free)
            if a.dtype.kind not in 'fiub' or a.shape != (NV,) or not np.isfinite(a).all():
                names = [self.model.inputs[k] for k in free]
                raise ValueError('%s: input: %s' % (self.who, REFUSALS.input % (
                    len(names), ', '.join(names), 'a function v = f(t, x)', repr(given))))
            self.put('constants', a.astype(float))

    @staticmethod
    def constants(a, free):
        if a.shape == (len(free),) and len(free) != NV:
            whole = np.zeros(NV)
            whole[free] = a
            return whole
        return a

    @staticmethod
    def spread(poly, free):
        whole = np.zeros((NV,) + poly.coefficients.shape[1:])
        whole[free] = poly.coefficients
        return Piecewise(poly.breaks, whole)

    def beside(self, t, side):
        """Where a function has the limit of a side: just before a jump, or behind it."""
        if t not in self.jumps:
            return t
        apart = max(2 * np.finfo(float).eps * abs(t), 1e-300)
        return t - apart if side < 0 else t + apart

    def told(self, function, free, t, x):
        """What a function v = f(t, x) gives, in all places."""
        given = function(t, x.copy())
        try:
            found = np.atleast_1d(np.asarray(given, float))
        except (TypeError, ValueError):
            raise ValueError('%s: input at t = %.9g s: expected %d numbers; found %r' % (
                self.who, t, NV, given)) from None
        return _vector(self.who, 'input at t = %.9g s' % t, self.constants(found, free), NV)

    def called(self, function, free):
        def inputs(t, x, nx, v, nv):
            own = np.ctypeslib.as_array(x, (nx,))[:NX]
            np.ctypeslib.as_array(v, (max(1, nv),))[:nv] = self.told(function, free, t, own)

        def vin(t, side, x, nx, nv, data, v):
            return self.ends.call(inputs, self.beside(t, side), x, nx, v, nv)
        return VIN(vin)

    def feedback(self, gain, reference, limits):
        if (gain is None) != (reference is None):
            why = REFUSALS.reference_alone if gain is None else REFUSALS.gain_alone
            raise ValueError('%s: %s' % (self.who, why))
        if gain is None:
            if limits is not None:
                raise ValueError('%s: limits %s' % (self.who, REFUSALS.limits_alone))
            return
        self.pieces('reference', constant(self.who, 'reference', reference, (NX,)))
        self.pieces('gain', constant(self.who, 'gain', gain, (NV, NX)))
        if limits is not None:
            self.put('limits', np.clip(self.bounds(limits), -1e300, 1e300))

    def bounds(self, given):
        try:
            bounds = np.array(given, float)
            if bounds.ndim < 2:
                bounds = np.broadcast_to(bounds, (NV,))
                bounds = np.stack([-bounds, bounds], axis=1)
        except ValueError:
            bounds = np.zeros(0)
        if bounds.shape != (NV, 2):
            raise ValueError('%s: limits: expected 1, %d or %d x 2 numbers, found %r' % (
                self.who, NV, NV, given))
        for k in np.flatnonzero(~(bounds[:, 0] < bounds[:, 1])):
            raise ValueError('%s: limits: %s' % (
                self.who, REFUSALS.limits_order % (self.model.inputs[k], *bounds[k])))
        return bounds

    def samples(self, times, memory, keep):
        """The plan of the sampled devices, see gs_sample."""
        devices = TABLE.get('controllers') or []
        if not devices:
            if memory is not None:
                raise ValueError('%s: memory: %s has no sampled devices' % (self.who, NAME))
            return
        self.model._has('ctl', 'ctp')
        period, delay = map(np.ascontiguousarray, self.model.ctp())
        if memory is not None:
            self.put('memory', _vector(self.who, 'memory', memory, SIZES['nxk']))
        devices = ctypes.c_int(len(period)), at(period), at(delay)
        self.given.on_the_way = LIBRARY.gs_pending(*devices)
        span = ctypes.c_double(times[-1] - times[0])
        self.given.instants = keep * int(LIBRARY.gs_instants(*devices, span))

    def events(self, modes):
        """The plan of the ports that stick or hit stops, see gs_resolve_event."""
        n = len(TABLE.get('events') or [])
        if not n:
            if modes is not None:
                raise ValueError('%s: modes: %s has no events' % (self.who, NAME))
            return
        self.model._has('evt', 'rst')
        self.given.events = int(LIMITS.recorded_events)
        if modes is not None:
            given = np.asarray(modes)
            if given.shape != (n,) or not np.isin(given, (-1, 0, 1)).all():
                raise ValueError('%s: modes: expected %d numbers, each -1, 0 or 1; found %r' % (
                    self.who, n, modes))
            self.put('modes', given, np.intc)
        self.no_mode_given(np.zeros(n) if modes is None else given)

    def no_mode_given(self, modes):
        """In the place of a mode, among all inputs, is 0 or what modes has."""
        for event, wanted in zip(TABLE['events'], modes):
            if event['input'] > 0 and 'constants' in self.held:
                found = self.held['constants'][event['input'] - 1]
                if found not in (0, wanted):
                    raise ValueError('%s: %s' % (
                        self.who, REFUSALS.given_mode % (event['name'], found)))


def free_inputs():
    """Places of the inputs that are neither held outputs of devices nor modes."""
    taken = {o for d in TABLE.get('controllers') or [] for o in d['outputs']}
    taken |= {e['input'] for e in TABLE.get('events') or []}
    return [i for i in range(NV) if i + 1 not in taken]


def constant(who, what, given, shape):
    """A piecewise polynomial of the entries of a matrix, by columns."""
    if isinstance(given, Piecewise) or hasattr(given, 'c'):
        return as_piecewise(who, what, given, int(np.prod(shape)))
    a = np.asarray(given, float)
    if a.shape != shape or not np.isfinite(a).all():
        shape = (shape + (1,))[:2]
        raise ValueError('%s: %s: %s' % (who, what, REFUSALS.matrix % (*shape, a.shape)))
    return Piecewise([0, 1], a.ravel(order='F')[:, None, None])


def planned_motion(who, given):
    """(poly, numbers of the planned coordinates): of all, or the actuated ones of a loop."""
    actuated = list(TABLE.get('actuated') or [])
    n = getattr(given, 'n', None)
    if NQ != NU:
        raise ValueError('%s: %s has Euler parameters: a motion cannot be planned' % (who, NAME))
    if n == NU and (NLAM == 0 or n == len(actuated)):
        planned = list(range(1, NU + 1))
    else:
        planned = actuated if NLAM else list(range(1, NU + 1))
    return as_piecewise(who, 'the planned motion', given, len(planned)), planned


# --------------------------------------------------------------------------------------- the run

def simulate(self, x0, times, *, method=DEFAULT.method, rtol=DEFAULT.rtol, atol=DEFAULT.atol,
             step=DEFAULT.step, maxstep=DEFAULT.maxstep, maxsteps=DEFAULT.maxsteps,
             maxorder=DEFAULT.maxorder, loops=DEFAULT.loops, drift=DEFAULT.drift,
             start=DEFAULT.start, input=DEFAULT.input, motion=DEFAULT.motion,
             gain=DEFAULT.gain, reference=DEFAULT.reference,
             limits=DEFAULT.limits, breaks=(), memory=DEFAULT.memory, samples=DEFAULT.samples,
             modes=DEFAULT.modes, audit=DEFAULT.audit, errors='raise'):
    """A run from the state x0 at times[0]; the states at all times come back.

    method: "dp853" (step control) or "rk4" (fixed step [s]); for stiff scenes "radau", "cvode"
    (BDF; needs SUNDIALS where the module is built) or "auto": dp853 that goes on with radau where
    its steps are bound by stability; for long runs that keep their energy "gauss" (fixed step).
    rtol, atol: tolerances, atol one number or one for each state; maxstep [s], maxsteps: 0 for
    none. maxorder: of radau and auto 5, 9 or 13 (default), of cvode 1 to 5 (default), of gauss 4,
    6 (default) or 8.
    loops: "projection", "baumgarte", "partitioning", "nullspace", "svd", "kane"; of radau and auto
    also "index2".
    drift: whether constraints are watched (default where the scene has loops).
    start: "check": x0 must fulfil the constraints; "project": it is moved onto them.
    input: nv constants (without those of sampled devices and modes if you like), a Piecewise (plan,
    table_of, a PPoly of SciPy) or a function v = f(t, x); motion: a planned motion instead.
    gain (nv, nx), reference (nx,): state feedback on top, limits: what the inputs may be.
    breaks: further times at which inputs jump [s]; a function is called beside them, on both sides.
    memory: of the sampled devices; samples: whether their instants are recorded; modes: of the
    ports that stick or hit stops.
    audit: an energy usual in the scene [J]; the result then has audit, the balance at the times.
    errors: "raise", or "return": a run that fails comes back as far as it went, with its failure in
    stats["failure"].
    """
    who = NAME + '.simulate'
    times = rising(who, times)
    if len(times) < 2:
        raise ValueError('%s: %s' % (who, REFUSALS.one_time % ('%.15g alone' % times[0])))
    if errors not in ('raise', 'return'):
        raise ValueError('%s: errors: expected "raise" or "return"; found %r' % (who, errors))
    model, way, index2 = _way(who, self, loops, method)
    x = _start_of(who, model, times[0], x0, start, modes)
    iopt, ropt, atol = _options(who, model, times[-1] - times[0], method, way, rtol, atol, step,
                                maxstep, maxsteps, drift)
    choice = Choice(who, method, maxorder, index2)
    kept = (float(ropt[1]), atol.copy()) if method not in FIXED else (np.nan, np.full(NX, np.nan))
    if audit is not None:
        model._has('rha', 'ene')
        check(who, 'audit', audit)
        x = np.append(x, [0.0, 0.0])
        atol = np.append(atol, [ropt[1] * audit] * 2)
    p = _Plan(who, model, len(x))
    if motion is not None and input is not None:
        raise ValueError('%s: give input or motion, not both' % who)
    if motion is not None:
        model._has('cmd')
        p.motion(motion)
    else:
        p.inputs(input, times[0], x)
    p.feedback(gain, reference, limits)
    p.samples(times, memory, bool(samples))
    p.events(modes)
    p.jumps = frozenset(float(b) for b in [*p.breaks, *_breaks(who, breaks)])
    stops = sorted(b for b in p.jumps if times[0] < b < times[-1])
    run = _run(model, p, x, times, stops, iopt, ropt, atol, audit is not None, choice)
    if p.ends.failure is not None:
        raise p.ends.failure
    s = run['stats']
    if run['info'] == 3 and s['failed'] == AT_EVENT and s['failed_info'] == WRONG_MODE:
        raise ValueError('%s: %s' % (
            who, _start.wrong_mode(model, times[0], x[:NX], modes, s['cause'] - 1)))
    return _result(who, model, p, run, choice.taken(s), kept, audit, errors)


def _way(who, model, loops, method):
    """The model with its parameter loop_method, the number of the method of its loops, whether they
    are in index 2."""
    if loops is not None and loops not in WAYS:
        raise ValueError('%s: loops %s' % (who, REFUSALS.loops % (', '.join(WAYS), repr(loops))))
    euler = NQ > NU
    if loops is None:
        loops = WAYS['prj' in ROUTINES and (NLAM > 0 or euler)]
        if method == 'gauss' and NLAM > 0 and not euler and {'kin', 'con'} <= ROUTINES.keys():
            loops = 'partitioning'   # the steps are those of the independent coordinates alone
    index2 = loops == 'index2'
    if index2:
        check_index2(who, model, method)
        loops = 'projection'
    way = WAYS.index(loops) + 1
    if NLAM == 0:
        way = 1 + (way > 1 and euler)
    needs = [(), ('prj',), ('con', 'kin') + ('prj',) * euler, ('prj',), ('prj',),
             ('con', 'kin', 'prj')][way - 1]
    model._has('rhs', *needs)
    wanted = max(1, way - 2)
    if model.parameters.get('loop_method', wanted) != wanted:
        model = model.changed(loop_method=wanted)
    return model, way, index2


def _breaks(who, given):
    times = np.atleast_1d(np.asarray(given))
    if times.size and (times.dtype.kind not in 'fiu' or not np.isfinite(times).all()):
        raise ValueError('%s: breaks: %s' % (who, expected('breaks', given)))
    return times.ravel().tolist()


def _check_count(who, method, step, maxstep, span):
    """The number of steps: what the run time counts to, or what time resolves."""
    fixed = method in FIXED
    most = LIMITS.fixed_steps if fixed else LIMITS.controlled_steps
    steps = [(step * fixed, 'step'), (maxstep, 'maxstep'), (math.inf, '')]
    longest, name = min((h, name) for h, name in steps if h > 0)
    if span / longest > most:
        raise ValueError('%s: %s: %s' % (who, name, REFUSALS.too_many_steps % (
            span, longest, span / longest, method, most)))


def _options(who, model, span, method, way, rtol, atol, step, maxstep, maxsteps, drift):
    if method not in METHODS:
        raise ValueError('%s: method: expected one of "%s", found %r' % (
            who, '", "'.join(METHODS), method))
    if step is None:
        step = 1e-3 if method in FIXED else 0.0
    check(who, 'step', step, 'positive' if method in FIXED else 'nonnegative')
    check(who, 'maxstep', maxstep)
    check(who, 'maxsteps', maxsteps)
    _check_count(who, method, step, maxstep, span)
    rtol, atol = _tolerances(who, model, rtol, atol, method)
    watched = NLAM > 0 and 'con' in ROUTINES if drift is None else bool(drift)
    rows = TABLE.get('speed_rows') or []
    iopt = [METHODS[method], way, int(watched), int(maxsteps),
            int(watched and NLAM > 0 and 'kin' in ROUTINES), len(rows), *rows]
    return np.array(iopt, np.intc), np.array([step, rtol, maxstep], float), atol


def _tolerances(who, model, rtol, atol, method):
    """rtol, atol, neither below what the precision can keep: it is raised, with a warning."""
    least = (100 if method in ('cvode', 'auto') else 10) * np.finfo(float).eps
    check(who, 'rtol', rtol)
    small = ['rtol = %g' % rtol] if rtol < least else []
    rtol = max(float(rtol), least)
    given, atol = atol, rtol * model.nominal if atol is None else np.asarray(atol)
    if atol.shape == ():
        atol = np.full(NX, atol)
    if atol.dtype.kind not in 'fiu' or atol.shape != (NX,) or not (
            np.isfinite(atol).all() and (atol >= 0).all()):
        raise ValueError('%s: atol: %s' % (who, REFUSALS.atol % (NX, repr(given))))
    low = np.flatnonzero(atol < least * model.nominal * (1 - 1e-9))
    if len(low):
        small.append('atol = %g of %s' % (atol[low[0]], model.states[low[0]]))
    if small and method != 'rk4':
        warnings.warn(
            '%s: %s' % (who, REFUSALS.low_tolerance % (', '.join(small), 'double', least)),
            RunWarning, stacklevel=5)
    return rtol, np.maximum(atol, least * model.nominal)


def _run(model, p, x, times, stops, iopt, ropt, atol, audit, choice):
    nx, nt = len(x), len(times)
    ip, rp = p.laid()
    out = {'ip': ip, 'rp': rp, 'x': np.zeros((nx, nt), order='F'),
           'v': np.zeros((max(1, NV), nt), order='F'), 'times': times, 'said': choice.said}
    _start.samples(p.who, model, times[0], ip, rp)
    counts, values = np.zeros(len(COUNTS), np.intc), np.zeros(len(VALUES))
    room = LIBRARY.gs_loop_room(SCENE, ctypes.c_int(nx), ctypes.c_int(p.given.derivatives))
    w = np.zeros(max(room, NU) + 20)
    if NQ == NU:
        w[:NU] = x[:NQ]
    stops = np.array(stops + [0.0])
    x, atol = np.ascontiguousarray(x), np.ascontiguousarray(atol)
    number = ctypes.c_int
    begun = time.perf_counter()
    with p.ends:
        out['info'] = LIBRARY.gs_loop_run(
            SCENE, pointer('rha') if audit else None, p.callback, p.ends.ask, number(nx),
            ctypes.c_double(times[0]), at(x), number(nt), at(times), number(len(stops) - 1),
            at(stops), at(iopt), at(ropt), at(atol), at(ip), at(rp), at(model.cst),
            at(out['x']), at(out['v']), at(counts), at(values), at(w), number(len(w)),
            choice.address, at(choice.numbers), choice.said, number(len(choice.said)))
    out['istat'] = counts
    out['stats'] = dict(zip(COUNTS + VALUES, counts.tolist() + values.tolist()))
    out['seconds'] = time.perf_counter() - begun
    return out


# ----------------------------------------------------------------------------- what comes back

def _result(who, model, p, run, method, kept, audit, errors):
    wanted = run['stats']['outputs']
    ended = _ended(run)
    reached = run['stats']['outputs']
    t, v = run['times'][:reached], run['v'][:NV, :reached]
    x = run['x'][:NX, :reached]
    r = Result(t=t, x=x, v=v, y=None, samples=None, events=None, audit=None)
    r.stats = _stats(model, run, method)
    r.stats['rtol'], r.stats['atol'] = kept
    text = failure(run) + outside(model, run) if run['info'] != 0 else None
    r.stats['failure'] = text
    r.stats['stopped'] = ended and 'event %s' % ended
    if text is not None and errors != 'return':
        raise Error('%s: %s' % (who, text), run['info'], r)
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        if NY and 'out' in ROUTINES and reached:
            r.y = model.out(_row_times(model, t, wanted), x, v)
    if TABLE.get('controllers'):
        r.samples = _samples(run)
    if TABLE.get('events'):
        r.events = _events(model, run, len(run['x']))
    if audit is not None:
        r.audit = _audit(model, r, run['x'][NX:, :reached])
    _tell(who, model, r, method)
    return r


def _row_times(model, t, wanted):
    """The times that stand for the rows: where the scene switches a row has what was before, as the
    inputs in it, but for the first one and that of an event which ends the run."""
    if 'swi' not in ROUTINES:
        return t
    left = np.isin(t, model.swi())
    left[0] = False
    left[wanted:] = False
    return np.where(left, t - np.maximum(2 * np.finfo(float).eps * np.abs(t), 1e-300), t)


def _ended(run):
    """Where an event of the user has ended a run: its name, and the state there is the last row."""
    if run['info'] != ENDED:
        return None
    run['info'] = 0
    last = run['stats']['reached']
    number = int(_recorded(run)[2])
    k = run['stats']['outputs']
    if k == 0 or run['times'][k - 1] < last:
        run['times'] = np.array(run['times'], float)
        run['times'][k] = last
        run['stats']['outputs'] += 1
    return TABLE['events'][number - 1]['name']


def _stats(model, run, method):
    s = run['stats']
    stats = {name: s[name] for name in (
        'calls', 'accepted', 'rejected', 'projections', 'rank_losses', 'angle_singularities',
        'partition_changes', 'singular_positions', 'repeated', 'loose', 'phi', 'phidot', 'phi_at',
        'phidot_at', 'before_projection', 'smallest_step', 'largest_step', 'reached',
        'least_pivot', 'least_pivot_at')}
    stats['rank_loss_times'] = [s['first_rank_loss'], s['last_rank_loss']]
    stats['angle_times'] = [s['first_angles'], s['last_angles']]
    stats['singular_times'] = [s['first_singular'], s['last_singular']]
    stats['stiff'] = None
    if s['stiff']:
        stats['stiff'] = {'time': s['stiff_at'], 'eigenvalue': s['stiff_eigenvalue'],
                          'step': s['stiff_step'], 'state': model.states[s['stiff_state'] - 1]}
    stats['jacobians'] = s['jacobians'] * (method in ('cvode', 'radau'))
    stats['newton'] = s['newton'] * (method in ('cvode', 'radau', 'gauss'))
    stats.update(method=method, seconds=run['seconds'])
    return stats


def failure(run):
    """Why a run ended before its time."""
    text = ctypes.create_string_buffer(1000)
    LIBRARY.gs_loop_failure(
        ctypes.c_int(run['info']), at(run['istat']), ctypes.c_double(run['stats']['reached']),
        run['said'], text, ctypes.c_int(len(text)))
    return text.value.decode()


def outside(model, run):
    """What is added to that where devices were outside their margins in the last state."""
    k = run['stats']['outputs']
    if k >= len(run['times']):
        return ''
    x, v = run['x'][:NX, k], run['v'][:, k]
    if not (np.isfinite(x).all() and np.isfinite(v).all()):
        return ''
    return _start.outside(model, run['stats']['reached'], x, v)


def _samples(run):
    """t, memory (nxk, n), v (nv, n) after each instant; memory at the end; how many there were."""
    sizes, nxk = np.zeros(3, np.intc), SIZES['nxk']
    first = LIBRARY.gs_loop_samples(SCENE, at(run['ip']), at(run['rp']), at(sizes))
    places, count, memory = sizes.tolist()
    record = _records(run, first, 1 + nxk + NV, min(places, count))
    return {'t': record[0], 'memory': record[1:1 + nxk], 'v': record[1 + nxk:],
            'end': run['rp'][memory:memory + nxk].copy(), 'count': count}


def _records(run, first, width, n):
    return run['rp'][first:first + n * width].reshape(width, n, order='F')


def _recorded(run):
    """The records of events, a column each; how many events there were; the numbers of the one that
    ended the run and of the last one, 0 where there was none."""
    sizes, nx = np.zeros(4, np.intc), len(run['x'])
    first = LIBRARY.gs_loop_events(ctypes.c_int(nx), at(run['ip']), at(run['rp']), at(sizes))
    return (_records(run, first, 3 + 2 * nx, int(min(sizes[0], sizes[1]))), *sizes[1:].tolist())


def _events(model, run, nx):
    """t, number (from 0), device, mode after, states before and after, energy lost [J]."""
    record, all_ = _recorded(run)[:2]
    count = record.shape[1]
    numbers = record[1].astype(int) - 1
    before, after = record[3:3 + NX], record[3 + nx:3 + nx + NX]
    loss = np.zeros(count)
    if 'ene' in ROUTINES and count:
        loss = (model.ene(record[0], before) - model.ene(record[0], after))[:3].sum(axis=0)
        loss[(before == after).all(axis=0)] = 0
    return {'t': record[0], 'number': numbers, 'mode': record[2].astype(int), 'before': before,
            'after': after, 'loss': loss, 'count': all_,
            'device': [TABLE['events'][k]['name'] for k in numbers]}


def _audit(model, r, w):
    """Energy less what came in and was lost [J], what passed [J], the largest error beside that."""
    energy = model.ene(r.t, r.x, r.v)[:3]
    stored = energy.sum(axis=0)
    lost = np.zeros(len(r.t))
    if r.events is not None:
        lost = ((r.events['t'] <= r.t[:, None]) * r.events['loss']).sum(axis=1)
    balance = stored - stored[0] - w[0] + lost - lost[0]
    passed = w[1] + lost
    rounding = 64 * np.finfo(float).eps * np.abs(energy).sum(axis=0).max()
    size = max(passed[-1], np.abs(stored - stored[0]).max(), np.ptp(energy[0]))
    error = np.maximum(np.abs(balance) - rounding, 0).max() / max(size, np.finfo(float).tiny)
    none = not (energy.any() or passed.any())   # there is nothing that could be balanced
    return {'balance': balance, 'passed': passed, 'error': np.nan if none else error}


def _tell(who, model, r, method):
    s = r.stats
    told = []
    if s['singular_positions'] > 0:
        told.append('passed %d positions where its constraints lose rank, the first at t = %.6g s: '
                    'it may go on in more than one way there' % (
                        s['singular_positions'], s['singular_times'][0]))
    elif s['loose'] > 0 and method != 'dp853':
        told.append('came close to a position where its constraints lose rank at t = %.6g s: %s, '
                    'unlike dp853, does not watch its accuracy there' % (
                        s['least_pivot_at'], method))
    if s['angle_singularities'] > 0:
        told.append('came within 0.05 rad of a singularity of its orientation angles at t = %.6g s'
                    % s['angle_times'][0])
    for sentence, first in _start.margins(model, r.t, r.x, r.v):
        told.append('%s, passed first at t = %.6g s' % (sentence, first))
    if s['stiff'] and method in ('dp853', 'rk4'):
        told.append('at t = %(time).6g s the steps, %(step).3g s, are bound by stability (largest '
                    'eigenvalue about %(eigenvalue).3g 1/s, of %(state)s)' % s['stiff'])
    told += sharp_friction(model, r, method)
    for text in told:
        warnings.warn('%s: %s' % (who, text), RunWarning, stacklevel=5)
