"""Linear models in independent states (host/linear/linear.h)."""
import collections
import ctypes
import warnings

import numpy as np

from . import _run, _start
from ._arguments import nearest
from ._library import DependentWarning, Error, LIBRARY, MODES, NAME, SIZES, TABLE
from ._structures import Asked, Linear, Place, Taken, Told
from ._tables import REFUSALS

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))

LinearModel = collections.namedtuple(
    'LinearModel', 'a b c d states inputs outputs tangent independent dropped')
LinearModel.__doc__ = """What linear gives: deviations dz of the states obey dz' = a dz + b dv,
dy = c dz + d dv; states, inputs, outputs: their names, of the states the independent ones; tangent
(nx, n): dx = tangent dz; independent: which states they are; dropped: names of coordinates and
speeds that were taken out."""


def linear(self, t, x, v=None, *, reduced='auto', drop=(), start='check'):
    """The exact linear model about the states x and the inputs v (default zeros) at the time t, as
    gsmbp_linear of Octave has it.

    reduced: with loops or Euler parameters the states are not independent: the model is one of
    independent ones, chosen by the Jacobian ("auto"), or of the coordinates and speeds with these
    names; "none": the full model. drop: names of coordinates to take out, or "running": those that
    run at x; nothing else may depend on them. start: "check", x must be on the constraints, or
    "project", it is moved there. A scene without outputs has its states as outputs.
    Result: a LinearModel.
    """
    who = NAME + '.linear'
    self._has('jac')
    t, x, v = state(who, self, t, x, v, start)
    asked = Asked(reduced=Asked.NAMED, running=_word(drop) == 'running')
    if _word(reduced) in ('auto', 'none'):
        asked.reduced = Asked.AUTO if reduced == 'auto' else Asked.NONE
    else:
        asked.nwanted = put_names(who, asked, 'wanted', 'reduced', reduced, self.states,
                                  '"auto", "none" or names of states')
    if not asked.running and len(drop):
        asked.ndrop = put_names(who, asked, 'drop', 'drop', drop, self.coordinates,
                                '"running" or names of coordinates')
    return _made(who, self, place(self, t, x, v), asked)


def _made(who, model, at, asked):
    ny = NY or NX
    found, told = Linear(), Told()
    sizes = {'a': NX * NX, 'b': NX * NV, 'c': ny * NX, 'd': ny * NV, 'tangent': NX * NX}
    for name, size in sizes.items():
        found.put(name, np.zeros(max(1, size)))
    for name, size in (('independent', NX), ('dropped', NX), ('seen', ny)):
        found.put(name, np.zeros(size), np.intc)
    LIBRARY.gs_loop_linear(at.address(), asked.address(), found.address(), told.address())
    heed(who, model, told)
    if found.row >= 0:
        warnings.warn('%s: %s' % (who, REFUSALS.no_derivative % (
            'output ' + model.outputs[found.row], _by(model, found.column))), _run.RunWarning,
                      stacklevel=4)
    n, m = found.n, found.m
    a, b, c, d, tangent = (_matrix(found.kept[name], *shape) for name, shape in (
        ('a', (n, n)), ('b', (n, NV)), ('c', (m, n)), ('d', (m, NV)), ('tangent', (NX, n))))
    independent, dropped, seen = (found.kept[name][:many].astype(int) for name, many in (
        ('independent', n), ('dropped', found.ndropped), ('seen', m)))
    names = np.array(model.outputs if NY else model.states, object)
    dropped = tuple(model.states[k] for k in dropped)
    gone = [name for k, name in enumerate(names) if k not in seen]
    if NY and gone:
        warnings.warn('%s: left out, as they depend on %s: %s' % (
            who, ', '.join(dropped), ', '.join(gone)), _run.RunWarning, stacklevel=4)
    return LinearModel(a, b, c, d, tuple(model.states[k] for k in independent), model.inputs,
                       tuple(names[seen]), tangent, independent, dropped)


def _matrix(numbers, rows, columns):
    return numbers[:rows * columns].reshape((rows, columns), order='F').copy()


# ------------------------------------------------------------------------- what others use as well

def state(who, model, t, x, v, start):
    """The time, the states on the constraints, and the inputs of a calculation at a state."""
    t = _run._vector(who, 't', [t] if np.ndim(t) == 0 else t, 1, 'time [s]')[0]
    x = _run._vector(who, 'x', x, NX, 'numbers (the states of %s)' % NAME, model.states)
    if v is None and MODES:
        raise TypeError('%s: argument v is missing: expected the inputs; %s is a mode (-1, 0 or 1) '
                        'of a device with events' % (who, TABLE['inputs'][MODES[0]]['name']))
    v = np.zeros(NV) if v is None else _run._vector(
        who, 'v', v, NV, 'numbers (the inputs of %s)' % NAME, model.inputs)
    _run._word(who, 'start', start, ('check', 'project'))
    found, x = Taken(), np.ascontiguousarray(x)
    verdict = LIBRARY.gs_loop_start(
        ctypes.c_double(t), _run.at(model.cst), _run.at(model._values),
        ctypes.c_int(start == 'check'), _run.at(x), found.address())
    if verdict != 0:
        raise ValueError('%s: %s' % (who, _start.refusal(
            verdict, found.state, found.text.decode(), model).replace('x0[', 'x[')))
    return t, x, v


def place(model, t, x, v):
    at = Place(t=t)
    for name, numbers in (('cst', model.cst), ('x', x), ('v', v)):
        at.put(name, numbers if len(numbers) else np.zeros(1))
    return at


def _word(given):
    return given if isinstance(given, str) else None


def put_names(who, asked, member, option, given, known, expected):
    """Names as numbers into an array of the structure: how many."""
    names = [given] if isinstance(given, str) else list(given)
    for name in names:
        if name not in known:
            raise ValueError('%s: %s: expected %s; found %r%s' % (
                who, option, expected, name, nearest(str(name), known)))
    if not names:
        raise ValueError('%s: %s: expected %s; found none' % (who, option, expected))
    asked.put(member, [known.index(name) for name in names], np.intc)
    return len(names)


def _by(model, column):
    return (model.states + model.inputs)[column]


def heed(who, model, told):
    """Raise what is wrong with a calculation of host/linear/linear.h."""
    if told.verdict == Told.NO_MEMORY:
        raise MemoryError(who)
    routine = (told.routine or b'').decode()
    if told.verdict == Told.ABSENT:
        model._has(routine)
    if told.verdict == Told.REFUSED:
        raise ValueError('%s: %s' % (who, told.text.decode()))
    if told.verdict == Told.DERIVATIVE:
        raise Error('%s: %s' % (who, REFUSALS.no_derivative % (
            'rate of ' + model.states[told.row], _by(model, told.column))))
    if routine:
        text = '%s: %s: INFO = %d: %s' % (who, routine, told.info,
                                          _run.meaning(routine, told.info))
        if told.verdict == Told.FAILED:
            raise Error(text, told.info)
        warnings.warn(text, DependentWarning, stacklevel=5)
