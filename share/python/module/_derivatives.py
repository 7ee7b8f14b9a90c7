"""Runs that carry derivatives by parameters and start values: what is asked for, what is found."""
import ctypes
import re

import numpy as np

from ._grazing import CHANGES, EVENTS, grazed
from ._library import LIBRARY, NAME, ROUTINES, SIZES, TABLE

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))
KNOWN = list(TABLE.get('sensitivity') or [])   # parameters of RHP, in its order
WHY = (
    '', 'the motion only grazes there',
    'another event at the same instant would come at another time',
    'the equations there have no derivatives',
    'what it resets is moved onto the constraints of a loop, which leave a choice')
_ADDRESS = ctypes.POINTER(ctypes.c_double)


def named(who, given):
    """Names as a list; one may stand alone."""
    names = [given] if isinstance(given, str) else list(given)
    for name in names:
        if not isinstance(name, str):
            raise ValueError('%s: sensitivity: expected names; found %r' % (who, name))
        if names.count(name) > 1:
            raise ValueError('%s: sensitivity: %s is given twice' % (who, name))
    return names


def _refuse(who, model, motion, given):
    """What is not carried with derivatives."""
    devices = TABLE.get('controllers') or []
    bad = None
    if 'rhp' not in ROUTINES:
        raise AttributeError('%s: sensitivity: %s was emitted without the subroutine RHP: derive '
                             'it with the request sensitivity of gsmbp_package' % (who, NAME))
    model._has(*('con', 'tan', 'cop') * (NLAM > 0), *('ctd',) * bool(devices),
               *('cmp',) * motion, *('evp',) * bool(EVENTS))
    if any(d.get('rounds') for d in devices):
        bad = ('device %s, which rounds (the derivative of a step is 0, or none); expected a '
               'variant without rounding, as plain' % next(
                   d['name'] for d in devices if d.get('rounds')))
    elif callable(given) and not hasattr(given, 'c') and not hasattr(given, 'breaks'):
        bad = ('an input that may depend on the states; expected constants or a piecewise '
               'polynomial')
    if bad:
        raise ValueError('%s: sensitivity: no derivatives with %s' % (who, bad))


def _moves_samples(name):
    """Is a parameter in the period or delay of a sampled device?"""
    texts = [str(d[k]) for d in TABLE.get('controllers') or [] for k in ('period', 'delay')]
    word = r'(?<!\w)%s(?!\w)' % re.escape(name)
    return any(re.search(word, text) for text in texts)


def _columns(who, model, names):
    """Of each name the number of the parameter (0: a start value) and its size."""
    columns, sizes = [], []
    for name in names:
        if name in KNOWN:
            if _moves_samples(name):
                raise ValueError('%s: sensitivity: %s moves the instants of sampled devices: there '
                                 'are no derivatives by it' % (who, name))
            columns.append(1 + KNOWN.index(name))
            sizes.append(abs(model.parameters[name]) or 1.0)
        elif name in model.states:
            columns.append(0)
            sizes.append(model.nominal[model.states.index(name)])
        else:
            raise ValueError(
                '%s: sensitivity: expected parameters that %s was derived for (request '
                'sensitivity: %s) or states, for their start values; found %s' % (
                    who, NAME, ', '.join(KNOWN), name))
    return columns, sizes


def _fixed(who, model, fixed):
    """1 for each coordinate of a closed chain that keeps its derivatives at the start."""
    names = [fixed] if isinstance(fixed, str) else fixed
    if names is None:
        names = [model.coordinates[k - 1] for k in TABLE.get('actuated') or []]
    for name in names:
        if name not in model.coordinates:
            raise ValueError('%s: fixed: expected names of coordinates (%s); found %r' % (
                who, ', '.join(model.coordinates), name))
    return np.array([name in names for name in model.coordinates] + [0], np.intc)


class Carried:
    """The columns of a run: names, their start, what the run found."""

    @classmethod
    def of(cls, who, model, sensitivity, fixed, dx0, motion, given):
        """None where nothing is asked for."""
        if sensitivity is not None and len(sensitivity):
            return cls(who, model, named(who, sensitivity), fixed, dx0, motion, given)
        for option, value in (('fixed', fixed), ('dx0', dx0)):
            if value is not None:
                raise ValueError('%s: %s needs sensitivity' % (who, option))
        return None

    def __init__(self, who, model, names, fixed, dx0, motion, given):
        self.who, self.model, self.names, self.n = who, model, names, len(names)
        _refuse(who, model, motion, given)
        columns, self.sizes = _columns(who, model, names)
        self.columns = np.array(columns, np.intc)
        self.fixed = _fixed(who, model, fixed)
        self.start = np.zeros((NX, self.n), order='F')
        if dx0 is not None:
            given = np.asarray(dx0, float)
            if given.shape != (NX, self.n) or not np.isfinite(given).all():
                raise ValueError('%s: dx0: expected %d x %d finite numbers (states by names), '
                                 'found %s' % (who, NX, self.n, given.shape))
            self.start[:] = given
        for k, name in enumerate(names):
            if not columns[k]:
                self.start[model.states.index(name), k] += 1
        self.run = None

    def ask(self, options):
        """These columns among the options of a run (gs_run_options)."""
        options.ncolumns = self.n
        options.put('columns', self.columns, np.intc)
        options.put('fixed', self.fixed, np.intc)
        options.put('sizes', self.sizes)
        options.put('dx0', self.start)
        options.put('changes', CHANGES, np.intc)

    def found(self, r, result, times, alone):
        """dx, dv, dy of the run r, and dt of its events: dicts by the names; result: that of the
        engine; times: those that stand for its rows; alone: the run of the states alone, at other
        times. stats['lost'] says where there are none."""
        n, self.run = len(r.t), result.pointer('derivatives')
        S = result.array('x', (result.nx, n))[NX:].reshape(NX, self.n, n, order='F')
        V = self._inputs(r, result)
        Y = self._outputs(r, S, V, times)
        moved = self._moved(r)
        lost = self._lost(r, alone)
        r.stats['lost'] = [
            {'name': self.names[k], 'time': t, 'text': WHY[why],
             'event': EVENTS[number - 1]['name'] if EVENTS else ''}
            for k, (why, number, t) in enumerate(lost) if why]
        for k, (why, _, t) in enumerate(lost):   # NaN where a column was lost
            if why:
                for a in (S, V, Y):
                    a[:, k, r.t >= t] = np.nan
                moved[k, r.events['t'] >= t if EVENTS else []] = np.nan
        if EVENTS:
            r.events['dt'] = dict(zip(self.names, moved))
        r.dx, r.dv, r.dy = ({name: a[:, k].copy() for k, name in enumerate(self.names)}
                            for a in (S, V, Y))

    def _moved(self, r):
        """Derivatives of the times of the events, a row for each column."""
        n, numbers = len(r.events['t']) if EVENTS else 0, _ADDRESS()
        count = LIBRARY.gs_derivatives_of_events(self.run, ctypes.byref(numbers))
        if not count:
            return np.zeros((self.n, n))
        return np.ctypeslib.as_array(numbers, (count, self.n)).T.copy()

    def _lost(self, r, alone):
        """Of each column why it was given up (0: it was not), at which event, when."""
        lost = []
        for k in range(self.n):
            event, time = ctypes.c_int(), ctypes.c_double()
            why = LIBRARY.gs_derivatives_lost(self.run, ctypes.c_int(k), ctypes.byref(event),
                                              ctypes.byref(time))
            lost.append((why, event.value, time.value))
        numbers = _ADDRESS()
        count = LIBRARY.gs_derivatives_turns(self.run, ctypes.byref(numbers))
        if not count or len(r.t) < 2:
            return lost
        turns = np.ctypeslib.as_array(numbers, (count, 2)).copy()
        found = grazed(self.model, r, turns, alone, r.stats['atol'])
        if found:
            lost = [one if one[0] and one[2] <= found[1] else (1, *found) for one in lost]
        return lost

    def _inputs(self, r, result):
        """Those of held outputs, and of inputs that follow a motion or feedback."""
        n = len(r.t)
        V = np.zeros((NV, self.n, n), order='F')
        if result.dv:
            V = result.array('dv', (NV, self.n, n))
        numbers = _ADDRESS()
        count = LIBRARY.gs_derivatives_held(self.run, ctypes.byref(numbers))
        if count < 0:
            raise MemoryError('%s: sensitivity' % self.who)
        if count == 0:
            return V
        held = np.ctypeslib.as_array(numbers, (count, 1 + NV * self.n))
        for i, t in enumerate(r.t):
            late = np.flatnonzero((held[:, 0] < t - 1e-12 * abs(t))
                                  | ((i == 0) & (held[:, 0] <= t)))
            if len(late):
                V[:, :, i] += held[late[-1], 1:].reshape(NV, self.n, order='F')
        return V

    def _outputs(self, r, S, V, times):
        """C*S + D*V + what the parameters do by themselves; NaN where that was not emitted."""
        Y = np.full((NY, self.n, len(r.t)), np.nan)
        if NY == 0 or not {'oup', 'jac'} <= ROUTINES.keys():
            return Y
        for i, t in enumerate(times):
            linear = self.model.linearize(t, r.x[:, i], r.v[:, i])
            alone = np.column_stack([np.zeros(NY), self.model.oup(t, r.x[:, i], r.v[:, i])])
            Y[:, :, i] = linear.c @ S[:, :, i] + alone[:, self.columns]
            if NV:
                Y[:, :, i] += linear.d @ V[:, :, i]
        return Y
