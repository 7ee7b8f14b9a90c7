"""Runs that carry derivatives by parameters and start values: what is asked for, what is found."""
import ctypes
import re

import numpy as np

from ._library import LIBRARY, NAME, ROUTINES, SIZES, TABLE

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))
KNOWN = list(TABLE.get('sensitivity') or [])   # parameters of RHP, in its order
EVENTS = TABLE.get('events') or []
# of each event function whether its event changes states, inputs or modes
CHANGES = np.array([e['kind'] != 'event' or bool(e.get('resets') or e.get('switches'))
                    for e in EVENTS] + [False], np.intc)
LIBRARY.gs_derivatives_why.restype = ctypes.c_char_p
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


def need_rates(who):
    """Derivatives by parameters need RHP."""
    if 'rhp' not in ROUTINES:
        raise AttributeError('%s: sensitivity: %s was emitted without the subroutine RHP: derive '
                             'it with the request sensitivity of gsmbp_package' % (who, NAME))


def _refuse(who, model, motion, given):
    """What is not carried with derivatives."""
    devices = TABLE.get('controllers') or []
    bad = None
    need_rates(who)
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

    def ask(self, options):
        """These columns among the options of a run (gs_run_options)."""
        options.ncolumns = self.n
        options.put('columns', self.columns, np.intc)
        options.keep('names', (ctypes.c_char_p * self.n)(*[name.encode() for name in self.names]))
        options.put('fixed', self.fixed, np.intc)
        options.put('sizes', self.sizes)
        options.put('dx0', self.start)
        options.put('changes', CHANGES, np.intc)

    def found(self, r, result):
        """dx, dv, dy of the run r, and dt of its events: dicts by the names; result: that of the
        engine. stats['lost'] says where there are none."""
        run, n = result.pointer('derivatives'), len(r.t)
        columns = (('dx', NX, result.array('x', (result.nx, n))[NX:]),
                   ('dv', NV, result.array('dv', (NV * self.n, n))),
                   ('dy', NY, result.array('dy', (NY * self.n, n))))
        for name, rows, all_of in columns:
            setattr(r, name, {one: all_of[rows * k:rows * (k + 1)].copy()
                              for k, one in enumerate(self.names)})
        if EVENTS:
            numbers = _ADDRESS()
            count = LIBRARY.gs_derivatives_of_events(run, ctypes.byref(numbers))
            moved = (np.ctypeslib.as_array(numbers, (count, self.n)).T.copy() if count
                     else np.zeros((self.n, 0)))
            r.events['dt'] = dict(zip(self.names, moved))
        r.stats['lost'] = list(self._lost(run))

    def _lost(self, run):
        """The columns that were given up."""
        for k, name in enumerate(self.names):
            event, time = ctypes.c_int(), ctypes.c_double()
            why = LIBRARY.gs_derivatives_lost(run, ctypes.c_int(k), ctypes.byref(event),
                                              ctypes.byref(time))
            if why:
                yield {'name': name, 'time': time.value, 'event': EVENTS[event.value - 1]['name'],
                       'text': LIBRARY.gs_derivatives_why(ctypes.c_int(why)).decode()}
