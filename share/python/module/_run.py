"""Runs: the start, the plan of a run as the run time has it, what comes back."""
import ctypes
import math
import time
import warnings

import numpy as np

from . import _start
from ._derivatives import Carried
from ._ends import Ends
from ._implicit import cvode, sharp_friction
from ._library import Error, LIBRARY, NAME, ROUTINES, SCENE, SIZES, TABLE, at
from ._motion import Piecewise, as_piecewise
from ._structures import Inputs, Options, Result as Found, Start
from ._tables import DEFAULT, FIXED, METHODS, REFUSALS, WAYS, check, expected, is_number

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))
# what the statistics of a result have as the run time has it (stub.py)
STATISTICS = ('calls', 'accepted', 'rejected', 'projections', 'rank_losses', 'angle_singularities',
              'partition_changes', 'singular_positions', 'repeated', 'loose', 'phi', 'phidot',
              'phi_at', 'phidot_at', 'before_projection', 'smallest_step', 'largest_step',
              'reached', 'least_pivot', 'least_pivot_at')
VIN = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, ctypes.c_int,
                       ctypes.POINTER(ctypes.c_double), ctypes.c_int, ctypes.c_int,
                       ctypes.c_void_p, ctypes.POINTER(ctypes.c_double))


class RunWarning(RuntimeWarning):
    """What a run has met: singular positions, stiffness, margins of devices."""


class Result:
    """What a run gives: t (nt,), x (nx, nt) states, v (nv, nt) inputs, y (ny, nt) outputs (None
    where the scene has none), stats (a dict); samples and events: dicts of arrays, or None; with
    sensitivity dx (nx, nt), dv, dy: dicts by the names."""

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


# -------------------------------------------------------------------------------------- the plan

class _Plan:
    """The inputs of a run as the engine takes them (gs_run_inputs), a function that it calls."""

    def __init__(self, who, model):
        self.who, self.model = who, model
        self.given, self.table, self.ends = Inputs(), None, Ends()

    def pieces(self, name, poly):
        self.given.put_pieces(name, poly)

    def put(self, name, numbers, kind=float):
        self.given.put(name, numbers, kind)

    def motion(self, given):
        poly, planned = planned_motion(self.who, given)
        self.given.kind = 2
        self.put('planned', planned, np.intc)
        self.pieces('motion', poly)

    def inputs(self, given, t0, x0):
        """Constants, a piecewise polynomial or a function v = f(t, x); what it is at the start is
        what the sampled devices hold before their first samples."""
        free = free_inputs()
        if given is None:
            given = np.zeros(NV)
        if callable(given) and not isinstance(given, Piecewise) and not hasattr(given, 'c'):
            self.given.kind = 3
            self.given.keep('function', self.called(given, free))
            if TABLE.get('controllers'):
                self.put('constants', self.told(given, free, t0, x0[:NX]))
        elif isinstance(given, Piecewise) or hasattr(given, 'c'):
            poly = as_piecewise(self.who, 'input', given, getattr(given, 'n', NV)
                                if getattr(given, 'n', NV) in (NV, len(free)) else NV)
            self.given.kind = 1
            self.table = poly if poly.n == NV else self.spread(poly, free)
            self.pieces('table', self.table)
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
            return self.ends.call(inputs, t, x, nx, v, nv)
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


def _memory(who, given):
    """The memory of the sampled devices at the start, as it is given."""
    if given is None:
        return None
    if not TABLE.get('controllers'):
        raise ValueError('%s: memory: %s has no sampled devices' % (who, NAME))
    return _vector(who, 'memory', given, SIZES['nxk'])


def _modes(who, given):
    """Modes of the ports that stick or hit stops, as they are given."""
    if given is None:
        return None
    n = len(TABLE.get('events') or [])
    if not n:
        raise ValueError('%s: modes: %s has no events' % (who, NAME))
    modes = np.asarray(given)
    if modes.shape != (n,) or not np.isin(modes, (-1, 0, 1)).all():
        raise ValueError('%s: modes: expected %d numbers, each -1, 0 or 1; found %r' % (
            who, n, given))
    return modes


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
             modes=DEFAULT.modes, audit=DEFAULT.audit, sensitivity=DEFAULT.sensitivity,
             fixed=DEFAULT.fixed, dx0=DEFAULT.dx0, errors='raise'):
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
    sensitivity: names of parameters and of states, for their start values, by which derivatives are
    carried: the result then has dx, dv, dy, dicts of arrays like x, v, y by these names, and
    events["dt"], of the times of the events; stats["lost"] says what has none from where on. dx0
    (nx, n): what the start has of the n names (default: nothing; a state by its
    own start 1); fixed: coordinates of a closed chain that keep their derivatives at the start
    (default: the actuated ones), the others follow from the constraints.
    errors: "raise", or "return": a run that fails comes back as far as it went, with its failure in
    stats["failure"].
    """
    who = NAME + '.simulate'
    times = rising(who, times)
    if len(times) < 2:
        raise ValueError('%s: %s' % (who, REFUSALS.one_time % ('%.15g alone' % times[0])))
    _word(who, 'errors', errors, ('raise', 'return'))
    _word(who, 'start', start, ('check', 'project'))
    x = _vector(who, 'x0', x0, NX, 'numbers (the states of %s)' % NAME, self.states)
    options = _options(who, self, method, rtol, atol, step, maxstep, maxsteps, maxorder, loops,
                       drift, audit)
    options.project, options.samples = start == 'project', bool(samples)
    given = Start(nt=len(times))
    for name, value in (('times', times), ('x0', x), ('par', self._values), ('cst', self.cst),
                        ('memory', _memory(who, memory))):
        given.put(name, value)
    given.put('modes', _modes(who, modes), np.intc)
    p = _Plan(who, self)
    if motion is not None and input is not None:
        raise ValueError('%s: give input or motion, not both' % who)
    if motion is not None:
        p.motion(motion)
    else:
        p.inputs(input, times[0], x)
    p.feedback(gain, reference, limits)
    p.given.put('breaks', _breaks(who, breaks))
    p.given.nbreaks = len(p.given.kept['breaks'])
    carried = Carried.of(who, self, sensitivity, fixed, dx0, motion is not None, input)
    if carried:
        carried.ask(options)
    found = Found()
    begun = time.perf_counter()
    with p.ends:
        LIBRARY.gs_loop_run(options.address(), given.address(), p.given.address(), p.ends.ask,
                            found.address())
    try:
        if p.ends.failure is not None:
            raise p.ends.failure
        _refuse(who, self, found)
        return _result(who, self, found, time.perf_counter() - begun, audit, errors, carried)
    finally:
        LIBRARY.gs_free_result(found.address())


def _word(who, name, given, words):
    if given not in words:
        raise ValueError('%s: %s: expected one of "%s", found %r' % (
            who, name, '", "'.join(words), given))


def _refuse(who, model, found):
    """What the engine refuses before the run, or warns of."""
    if found.warning:
        warnings.warn('%s: %s' % (who, found.warning.decode()), RunWarning, stacklevel=4)
    why, option, text = found.refused, (found.option or b'').decode(), found.text.decode()
    if not why:
        return
    if why == Found.ROUTINE:
        model._has(option)
    if why == Found.START:
        text = _start.refusal(found.start.verdict, found.start.state, text, model)
    raise ValueError('%s: %s%s' % (who, option and option + ': ', text))


def _breaks(who, given):
    times = np.atleast_1d(np.asarray(given))
    if times.size and (times.dtype.kind not in 'fiu' or not np.isfinite(times).all()):
        raise ValueError('%s: breaks: %s' % (who, expected('breaks', given)))
    return times.ravel().tolist()


def _options(who, model, method, rtol, atol, step, maxstep, maxsteps, maxorder, loops, drift,
             audit):
    """As the engine takes them (gs_run_options); it looks at what they mean together."""
    _word(who, 'method', method, METHODS)
    if loops is not None and loops not in WAYS:
        raise ValueError('%s: loops %s' % (who, REFUSALS.loops % (', '.join(WAYS), repr(loops))))
    if step is not None:
        check(who, 'step', step, 'positive' if method in FIXED else 'nonnegative')
    if maxorder is not None and (isinstance(maxorder, bool) or not is_number(maxorder)):
        raise ValueError('%s: maxorder: %s' % (who, expected('maxorder', maxorder, 'whole')))
    for name, value in (('maxstep', maxstep), ('maxsteps', maxsteps), ('rtol', rtol)):
        check(who, name, value)
    if audit is not None:
        model._has('rha', 'ene')
        check(who, 'audit', audit)
    options = Options(
        method=method.encode(), loops=loops and loops.encode(), rtol=rtol, maxstep=maxstep,
        step=math.nan if step is None else step, maxsteps=maxsteps,
        maxorder=math.nan if maxorder is None else maxorder,
        drift=-1 if drift is None else bool(drift), audit=audit or 0, cvode=cvode(who, method))
    options.put('atol', _tolerances(who, atol))
    return options


def _tolerances(who, given):
    """One for each state, or None."""
    if given is None:
        return None
    atol = np.asarray(given)
    if atol.shape == ():
        atol = np.full(NX, atol)
    if atol.dtype.kind not in 'fiu' or atol.shape != (NX,) or not (
            np.isfinite(atol).all() and (atol >= 0).all()):
        raise ValueError('%s: atol: %s' % (who, REFUSALS.atol % (NX, repr(given))))
    return atol


# ----------------------------------------------------------------------------- what comes back

def _result(who, model, found, seconds, audit, errors, carried):
    rows, method = found.rows, found.method.decode()
    v, x = found.array('v', (max(1, NV), rows))[:NV], found.array('x', (found.nx, rows))
    r = Result(t=found.array('times', (rows,)), x=x[:NX], v=v, y=None, samples=None, events=None,
               audit=None)
    s = found.statistics()
    r.stats = _stats(model, s, method, seconds)
    r.stats['rtol'], r.stats['atol'] = found.rtol, found.array('atol', (NX,))
    if method in FIXED:
        r.stats['rtol'], r.stats['atol'] = np.nan, np.full(NX, np.nan)
    text = found.text.decode() if found.info else None
    r.stats['failure'] = text
    r.stats['stopped'] = None
    if found.ended:
        r.stats['stopped'] = 'event %s' % TABLE['events'][found.ended - 1]['name']
    if text is not None and errors != 'return':
        raise Error('%s: %s' % (who, text), found.info, r)
    if NY and 'out' in ROUTINES and rows:
        r.y = found.array('y', (NY, rows))
    if TABLE.get('controllers'):
        r.samples = _samples(found)
    if TABLE.get('events'):
        r.events = _events(model, found)
    if audit is not None:
        r.audit = _audit(model, r, x[NX:])
    if carried:
        carried.found(r, found)
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


def _stats(model, s, method, seconds):
    stats = {name: s[name] for name in STATISTICS}
    stats['rank_loss_times'] = [s['first_rank_loss'], s['last_rank_loss']]
    stats['angle_times'] = [s['first_angles'], s['last_angles']]
    stats['singular_times'] = [s['first_singular'], s['last_singular']]
    stats['stiff'] = None
    if s['stiff']:
        stats['stiff'] = {'time': s['stiff_at'], 'eigenvalue': s['stiff_eigenvalue'],
                          'step': s['stiff_step'], 'state': model.states[s['stiff_state'] - 1]}
    stats['jacobians'] = s['jacobians'] * (method in ('cvode', 'radau'))
    stats['newton'] = s['newton'] * (method in ('cvode', 'radau', 'gauss'))
    stats.update(method=method, seconds=seconds)
    return stats


def _samples(found):
    """t, memory (nxk, n), v (nv, n) after each instant; memory at the end; how many there were."""
    sizes, nxk = np.zeros(3, np.intc), SIZES['nxk']
    first = LIBRARY.gs_loop_samples(SCENE, found.pointer('ip'), found.pointer('rp'), at(sizes))
    places, count, memory = sizes.tolist()
    record = found.array('rp', (1 + nxk + NV, min(places, count)), first)
    return {'t': record[0], 'memory': record[1:1 + nxk], 'v': record[1 + nxk:],
            'end': found.array('rp', (nxk,), memory), 'count': count}


def _events(model, found):
    """t, number (from 0), device, mode after, states before and after, energy lost [J]."""
    sizes, nx = np.zeros(2, np.intc), found.nx
    first = LIBRARY.gs_loop_events(ctypes.c_int(nx), found.pointer('ip'), found.pointer('rp'),
                                   at(sizes))
    count = int(sizes.min())
    record = found.array('rp', (3 + 2 * nx, count), first)
    numbers = record[1].astype(int) - 1
    before, after = record[3:3 + NX], record[3 + nx:3 + nx + NX]
    loss = np.zeros(count)
    if 'ene' in ROUTINES and count:
        loss = (model.ene(record[0], before) - model.ene(record[0], after))[:3].sum(axis=0)
        loss[(before == after).all(axis=0)] = 0
    return {'t': record[0], 'number': numbers, 'mode': record[2].astype(int), 'before': before,
            'after': after, 'loss': loss, 'count': int(sizes[1]),
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
    for one in s.get('lost', ()):
        told.append('no derivatives by %(name)s from t = %(time).6g s on (event of %(event)s): '
                    '%(text)s' % one)
    told += sharp_friction(model, r, method)
    for text in told:
        warnings.warn('%s: %s' % (who, text), RunWarning, stacklevel=5)
