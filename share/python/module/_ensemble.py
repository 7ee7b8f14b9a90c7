"""Many runs of a scene on threads (host/ensemble/ensemble.h)."""
import ctypes
import os
import threading
import time
import warnings

import numpy as np

from . import _checks
from ._implicit import Choice
from ._library import LIBRARY, NAME, SCENE, SIZES, TABLE, address, at
from ._motion import Piecewise
from ._run import (ENDED, NQ, NU, NV, NX, NY, RunWarning, _Plan, _breaks, _options, _vector, _way,
                   free_inputs, meaning, rising)
from ._start import _REMEDIES
from ._tables import COUNTS, DEFAULT, REFUSALS, VALUES, VERDICTS, is_number

BEFORE_START = 9   # what failed was the start: GS_BEFORE_START of gsmbp/failures.h
INTERRUPTED = 9    # info of runs that are ended from outside


class Ensemble:
    """What many runs give: t (nt,), x (n, nx, nt) states, v (n, nv, nt) inputs, y (n, ny, nt)
    outputs (None where the scene has none), NaN where a run did not come to; ok (n,): whether a run
    is complete, reached (n,): the time that it reached, reason: why it failed, "" if it did not;
    stats: arrays of what each run counted and measured; parameters: as they were given; events:
    count, first, last (n, nev) of each event function, or None."""

    def __init__(self, **fields):
        self.__dict__.update(fields)

    def __repr__(self):
        return '<%d runs, %d complete>' % (len(self.ok), self.ok.sum())


class _Results(ctypes.Structure):
    """gs_results of ensemble.h."""

    _fields_ = [(name, ctypes.c_void_p) for name in (
        'x', 'v', 'y', 'counts', 'values', 'info', 'counted', 'margins', 'events', 'nevents',
        'said')] + [('no_memory', ctypes.c_int)]


if LIBRARY.gs_loop_results_size() != ctypes.sizeof(_Results):
    raise ImportError('%s: the library was built with another ensemble.h' % NAME)


# ----------------------------------------------------------------------------------- the rows

def _column(who, what, given):
    """Finite numbers, one for each run."""
    a = np.atleast_1d(np.asarray(given))
    if a.dtype.kind not in 'fiub' or a.ndim != 1 or not np.isfinite(a).all():
        raise ValueError('%s: %s: expected finite numbers, one for each run; found %s' % (
            who, what, a.tolist() if a.dtype.kind in 'fiub' and a.size < 6 else a.shape))
    return a.astype(float)


def _rows(who, what, given, width, names):
    """An array (n, width) of finite numbers, or None."""
    if given is None:
        return None
    a = np.asarray(given)
    if a.dtype.kind not in 'fiub' or a.ndim != 2 or a.shape[1] != width:
        raise ValueError('%s: %s: expected an array (n, %d), a row for each run (%s); found %s' % (
            who, what, width, ', '.join(names), a.shape))
    bad = np.argwhere(~np.isfinite(a))
    if len(bad):
        i, k = bad[0]
        raise ValueError('%s: %s[%d, %d], %s: expected a finite number; found %g' % (
            who, what, i, k, names[k], a[i, k]))
    return np.ascontiguousarray(a, float)


class _Differing:
    """What differs from run to run: n, how many; the parameters that do (which, from 1) and their
    values (n, varied), starts, inputs, why runs are not begun."""

    def __init__(self, who, model, parameters, starts, inputs):
        parameters = dict(parameters or {})
        names = list(model.parameters)
        for name in parameters:
            if name not in names:
                model.changed(**{name: 0.0})   # says what it is, or which one is meant
        self.columns = {name: _column(who, 'parameter ' + name, parameters[name])
                        for name in parameters}
        self.starts = _rows(who, 'starts', starts, NX, model.states)
        free = free_inputs()
        self.inputs = _rows(who, 'inputs', inputs, len(free), [model.inputs[k] for k in free])
        self.n = self._count(who)
        self.which = np.array([names.index(name) + 1 for name in self.columns] + [0], np.intc)
        self.table = np.ascontiguousarray(np.array(
            [np.broadcast_to(c, self.n) for c in self.columns.values()]).T, float)
        self.broken = self._broken(model)
        if self.inputs is not None and len(free) != NV:
            whole = np.zeros((self.n, NV))
            whole[:, free] = self.inputs
            self.inputs = whole

    def _count(self, who):
        sizes = {'parameter ' + name: len(c) for name, c in self.columns.items() if len(c) != 1}
        sizes.update({name: len(a) for name, a in (('starts', self.starts),
                                                   ('inputs', self.inputs)) if a is not None})
        if not sizes and not self.columns:
            raise ValueError('%s: expected parameters, starts or inputs: what differs from run to '
                             'run; found none' % who)
        n = max(sizes.values(), default=1)
        for name, size in sizes.items():
            if size != n or n < 1:
                raise ValueError('%s: %s: expected %d rows, one for each run; found %d' % (
                    who, name, n, size))
        return n

    def _broken(self, model):
        """Why the parameters of each run cannot be, or None."""
        if not self.columns:
            return [None] * self.n
        _checks.need_routines()
        values = model._values.copy()
        broken = []
        for row in self.table:
            values[self.which[:-1] - 1] = row
            broken.append(_checks.checked(values)[1])
        return broken


# ------------------------------------------------------------------------------------- the runs

def ensemble(self, times, *, x0=None, parameters=None, starts=None, inputs=None, threads=0,
             method=DEFAULT.method, rtol=DEFAULT.rtol, atol=DEFAULT.atol, step=DEFAULT.step,
             maxstep=DEFAULT.maxstep, maxsteps=DEFAULT.maxsteps, maxorder=DEFAULT.maxorder,
             loops=DEFAULT.loops, drift=DEFAULT.drift, start=DEFAULT.start, input=DEFAULT.input,
             breaks=()):
    """Many runs over the same times, on threads; what differs from run to run is in arrays.

    parameters: a dict of arrays (n,), one value for each run; starts (n, nx): initial states, where
    they differ, otherwise x0 (default: that of the scene); inputs (n, nv): constant inputs, where
    they differ, otherwise input, constants or a Piecewise.
    threads: how many, 0 for all processors. A run is the same, bit for bit, by any number of them.
    Other options are those of simulate. A run that fails ends alone: ok and reason say so.
    Ctrl-C ends all runs; meanwhile other threads of Python run.
    """
    who = NAME + '.ensemble'
    times = rising(who, times)
    if len(times) < 2:
        raise ValueError('%s: %s' % (who, REFUSALS.one_time % ('%.15g alone' % times[0])))
    if start not in ('check', 'project'):
        raise ValueError('%s: start: expected one of "check", "project", found %r' % (who, start))
    if isinstance(threads, bool) or not is_number(threads) or threads != int(threads) \
            or not 0 <= threads <= 10000:
        raise ValueError('%s: threads: expected a whole number from 0 (all processors) to 10000; '
                         'found %r' % (who, threads))
    if callable(input) and not isinstance(input, Piecewise) and not hasattr(input, 'c'):
        raise ValueError('%s: input: expected constants or a piecewise polynomial; a function of '
                         'Python cannot run on several threads' % who)
    if input is not None and inputs is not None:
        raise ValueError('%s: give input or inputs, not both' % who)
    model, way, index2 = _way(who, self, loops, method)
    rows = _Differing(who, model, parameters, starts, inputs)
    x = _vector(who, 'x0', model.initial if x0 is None else x0, NX,
                'numbers (the states of %s)' % NAME, model.states)
    iopt, ropt, atol = _options(who, model, times[-1] - times[0], method, way, rtol, atol, step,
                                maxstep, maxsteps, drift)
    p = _Plan(who, model, NX)
    p.inputs(input, times[0], x)
    p.samples(times, None, False)
    p.events(None)
    stops = sorted({b for b in [*p.breaks, *_breaks(who, breaks)] if times[0] < b < times[-1]})
    options = iopt, ropt, np.ascontiguousarray(atol)
    choice = Choice(who, method, maxorder, index2)
    run = _run_all(model, p, rows, x, times, stops, options, choice, start == 'check',
                   int(threads) or _processors())
    return _told(who, _result(rows, times, run))


def _processors():
    """Those that this process may use."""
    if hasattr(os, 'sched_getaffinity'):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _arrays(n, nt):
    """What gs_results is filled with."""
    nev, nmargins = SIZES['nev'], len(TABLE.get('state_margins') or [])
    a = {'x': np.full((n, NX, nt), np.nan), 'v': np.full((n, NV, nt), np.nan),
         'y': np.full((n, NY, nt), np.nan), 'counts': np.zeros((n, len(COUNTS))),
         'values': np.zeros((n, len(VALUES))), 'info': np.zeros((n, 2)),
         'counted': np.zeros((n, 3, nev)), 'margins': np.zeros((n, 2, nmargins)),
         'said': np.zeros(n, np.uintp)}
    a['margins'][:, 1] = np.inf
    return a


def _run_all(model, p, rows, x, times, stops, options, choice, check, threads):
    """The arrays of all runs, with reasons of those that were refused, and how long they took."""
    a = _arrays(rows.n, len(times))
    results = _Results(**{name: address(array) for name, array in a.items()})
    ip, rp = p.laid()
    room = max(LIBRARY.gs_loop_room(SCENE, ctypes.c_int(NX), ctypes.c_int(p.given.derivatives)), NU)
    sizes = np.array([len(model.parameters), SIZES['ncst'], len(ip), len(rp), rows.n,
                      len(rows.columns), threads, check], np.intc)
    broken = (ctypes.c_char_p * rows.n)(*[b and b.encode() for b in rows.broken])
    over, stops, x = np.zeros(1, np.intc), np.array(stops + [0.0]), np.ascontiguousarray(x)

    def where(array):
        return None if array is None or not array.size else at(array)
    arguments = (
        SCENE, at(sizes), at(over), ctypes.c_double(times[0]), at(x), ctypes.c_int(len(times)),
        at(times), ctypes.c_int(len(stops) - 1), at(stops), *map(at, options), at(ip), at(rp),
        at(model.cst), ctypes.c_int(room + 20), choice.address, at(choice.numbers),
        at(model._values), at(rows.which), where(rows.table), where(rows.starts),
        where(rows.inputs), broken, ctypes.byref(results))
    said, begun = a.pop('said'), time.perf_counter()
    try:
        failed = _in_a_thread(over, LIBRARY.gs_loop_ensemble, arguments)
        a['said'] = [ctypes.string_at(int(text)) if text else b'' for text in said]
    finally:
        LIBRARY.gs_loop_forget(at(said), ctypes.c_int(rows.n))
    a['seconds'] = time.perf_counter() - begun
    if failed:
        raise MemoryError('%s: %d runs of %d times' % (p.who, rows.n, len(times)))
    return a


def _in_a_thread(over, function, arguments):
    """What the function gives, called while this thread looks after signals: what their handlers
    raise (Ctrl-C: KeyboardInterrupt) ends all runs, then it is raised. An Event says when they have
    ended: join of Python 3.11 takes a thread for ended where a signal interrupts it."""
    found, done = [], threading.Event()

    def call():
        try:
            found.append(function(*arguments))
        finally:
            done.set()
    threading.Thread(target=call).start()
    try:
        while not done.wait(0.1):
            pass
    except BaseException:
        over[0] = INTERRUPTED
        while not done.is_set():   # the arrays are those of the runs until then
            try:
                done.wait(0.1)
            except BaseException:
                pass
        raise
    return found[0]


# ----------------------------------------------------------------------------- what comes back

def _reason(i, run, rows):
    """Why run i failed."""
    info, pre = run['info'][i].astype(int)
    if rows.broken[i]:
        return rows.broken[i]
    if pre:
        return 'its parameters cannot be: ' + meaning('pre', int(pre))
    counts = np.ascontiguousarray(run['counts'][i], np.intc)
    text = ctypes.create_string_buffer(2400)
    LIBRARY.gs_loop_failure(
        ctypes.c_int(int(info)), at(counts), ctypes.c_double(run['values'][i, VALUES.index(
            'reached')]), run['said'][i], text, ctypes.c_int(len(text)))
    remedy = ''
    if counts[COUNTS.index('failed')] == BEFORE_START:
        remedy = _REMEDIES.get(VERDICTS[counts[COUNTS.index('failed_info')]], '')
    return text.value.decode() + remedy


def _result(rows, times, run):
    info, pre = run['info'].T.astype(int)
    ended = info == ENDED
    ok = ((info == 0) | ended) & (pre == 0) & np.array([b is None for b in rows.broken])
    reached = run['values'][:, VALUES.index('reached')].copy()
    reached[ok & ~ended] = times[-1]
    for i in np.flatnonzero(~ok):   # a state where a run ended is none at a time asked for
        first = int(run['counts'][i, COUNTS.index('outputs')])
        for name in 'xvy':
            run[name][i, :, first:] = np.nan
    stats = {name: run['counts'][:, k].astype(int) for k, name in enumerate(COUNTS)}
    stats.update({name: run['values'][:, k] for k, name in enumerate(VALUES)})
    stats['seconds'] = run['seconds']
    counted = run['counted']
    events = None
    if SIZES['nev']:
        never = np.where(counted[:, 0] > 0, 0.0, np.nan)
        events = {'count': counted[:, 0].astype(int), 'first': counted[:, 1] + never,
                  'last': counted[:, 2] + never}
    reason = ['' if good else _reason(i, run, rows) for i, good in enumerate(ok)]
    return Ensemble(t=times, x=run['x'], v=run['v'], y=run['y'] if NY else None, ok=ok,
                    reached=reached, reason=reason, stats=stats, parameters=rows.columns,
                    events=events)


def _told(who, result):
    """A warning where runs failed."""
    failed = np.flatnonzero(~result.ok)
    if len(failed):
        warnings.warn('%s: %d of %d runs failed; the first, run %d: %s' % (
            who, len(failed), len(result.ok), failed[0], result.reason[failed[0]]), RunWarning,
            stacklevel=4)
    return result
