"""Many runs of a scene on threads (host/ensemble/ensemble.h)."""
import ctypes
import os
import threading
import time
import warnings

import numpy as np

from . import _checks
from ._library import LIBRARY, NAME, SIZES, TABLE, address, at
from ._motion import Piecewise
from ._run import (NV, NX, NY, RunWarning, _Plan, _breaks, _options, _refuse, _vector, _word,
                   free_inputs, rising)
from ._start import _REMEDIES
from ._structures import Result as Found, Results, Rows, Start
from ._tables import COUNTS, DEFAULT, REFUSALS, VALUES, VERDICTS, is_number

ROUTINE_FAILED = 3   # of gsmbp/failures.h: info where a routine failed,
BEFORE_START = 9   # ... or, by its count, the start was refused: GS_BEFORE_START
INTERRUPTED = 9    # info of runs that are ended from outside
ENDED = 11         # of one that an event of the user has ended


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

    def structure(self):
        """As the engine takes them (gs_rows)."""
        rows = Rows(n=self.n, varied=len(self.columns))
        rows.put('which', self.which, np.intc)
        for name in 'table', 'starts', 'inputs':
            rows.put_table(name, getattr(self, name))
        texts = (ctypes.c_char_p * self.n)(*[b and b.encode() for b in self.broken])
        rows.keep('broken', texts)
        return rows

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
    _word(who, 'start', start, ('check', 'project'))
    if isinstance(threads, bool) or not is_number(threads) or threads != int(threads) \
            or not 0 <= threads <= 10000:
        raise ValueError('%s: threads: expected a whole number from 0 (all processors) to 10000; '
                         'found %r' % (who, threads))
    if callable(input) and not isinstance(input, Piecewise) and not hasattr(input, 'c'):
        raise ValueError('%s: input: expected constants or a piecewise polynomial; a function of '
                         'Python cannot run on several threads' % who)
    if input is not None and inputs is not None:
        raise ValueError('%s: give input or inputs, not both' % who)
    rows = _Differing(who, self, parameters, starts, inputs)
    x = _vector(who, 'x0', self.initial if x0 is None else x0, NX,
                'numbers (the states of %s)' % NAME, self.states)
    options = _options(who, self, method, rtol, atol, step, maxstep, maxsteps, maxorder, loops,
                       drift, None)
    options.project = start == 'project'
    given = Start(nt=len(times))
    for name, value in (('times', times), ('x0', x), ('par', self._values), ('cst', self.cst)):
        given.put(name, value)
    p = _Plan(who, self)
    p.inputs(input, times[0], x)
    p.given.put('breaks', _breaks(who, breaks))
    p.given.nbreaks = len(p.given.kept['breaks'])
    run = _run_all(who, self, options, given, p.given, rows, int(threads) or _processors())
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
         'reason': np.zeros(n, np.uintp)}
    a['margins'][:, 1] = np.inf
    return a


def _run_all(who, model, options, start, inputs, rows, threads):
    """The arrays of all runs, with reasons of those that failed, and how long they took."""
    a = _arrays(rows.n, start.nt)
    results = Results(**{name: address(array) for name, array in a.items()})
    texts, begun, over, found = a.pop('reason'), time.perf_counter(), np.zeros(1, np.intc), Found()
    try:
        _in_a_thread(over, LIBRARY.gs_loop_ensemble, (
            options.address(), start.address(), inputs.address(), rows.structure().address(),
            ctypes.c_int(threads), at(over), results.address(), found.address()))
        a['reason'] = [ctypes.string_at(int(text)).decode() if text else '' for text in texts]
    finally:
        LIBRARY.gs_loop_forget(at(texts), ctypes.c_int(rows.n))
        LIBRARY.gs_free_result(found.address())
    a['seconds'] = time.perf_counter() - begun
    _refuse(who, model, found)
    if found.info:
        raise MemoryError('%s: %d runs of %d times' % (who, rows.n, start.nt))
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

def _reason(i, run):
    """Why run i failed, and what a call may do about it."""
    remedy = ''
    if run['info'][i, 0] == ROUTINE_FAILED and run['counts'][i, COUNTS.index('failed')] == \
            BEFORE_START:
        verdict = VERDICTS[int(run['counts'][i, COUNTS.index('failed_info')])]
        remedy = _REMEDIES.get(verdict, '')
    return run['reason'][i] + remedy


def _result(rows, times, run):
    ended = run['info'][:, 0] == ENDED
    ok = np.array([not text for text in run['reason']])
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
    reason = ['' if good else _reason(i, run) for i, good in enumerate(ok)]
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
