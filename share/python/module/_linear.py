"""Linear models in independent states (host/linear/linear.h)."""
import collections
import ctypes
import warnings

import numpy as np

from . import _run, _start
from ._arguments import nearest
from ._library import DependentWarning, Error, LIBRARY, NAME, SIZES, TABLE, at
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
    t, x, v = numbers(who, self, t, x, v)
    x = on_constraints(who, self, t, x, start)
    return at_state(who, self, t, x, v, reduced, drop)


def at_state(who, self, t, x, v, reduced, drop):
    """The linear model, for what has these arguments as well."""
    asked = Asked(reduced=Asked.NAMED, running=_word(drop) == 'running')
    if _word(reduced) in ('auto', 'none'):
        asked.reduced = Asked.AUTO if reduced == 'auto' else Asked.NONE
    else:
        asked.nwanted = put_names(who, asked, 'wanted', 'reduced', reduced, self.states,
                                  '"auto", "none" or names of states')
    if not asked.running and listed(who, 'drop', drop):
        asked.ndrop = put_names(who, asked, 'drop', 'drop', drop, self.coordinates,
                                '"running" or names of coordinates')
    return _made(who, self, place(self, t, x, v), asked)


def _made(who, model, here, asked):
    ny = NY or NX
    found, told = Linear(), Told()
    sizes = {'a': NX * NX, 'b': NX * NV, 'c': ny * NX, 'd': ny * NV, 'tangent': NX * NX}
    for name, size in sizes.items():
        found.put(name, np.zeros(max(1, size)))
    for name, size in (('independent', NX), ('dropped', NX), ('seen', ny)):
        found.put(name, np.zeros(size), np.intc)
    LIBRARY.gs_loop_linear(here.address(), asked.address(), found.address(), told.address())
    heed(who, model, told)
    if found.row >= 0:
        warnings.warn('%s: %s' % (who, REFUSALS.no_derivative % (
            'output ' + model.outputs[found.row], _by(model, found.column))), _run.RunWarning,
                      stacklevel=5)
    n, m = found.n, found.m
    a, b, c, d, tangent = (matrix(found.kept[name], *shape) for name, shape in (
        ('a', (n, n)), ('b', (n, NV)), ('c', (m, n)), ('d', (m, NV)), ('tangent', (NX, n))))
    independent, dropped, seen = (found.kept[name][:many].astype(int) for name, many in (
        ('independent', n), ('dropped', found.ndropped), ('seen', m)))
    names = np.array(model.outputs if NY else model.states, object)
    dropped = tuple(model.states[k] for k in dropped)
    gone = [name for k, name in enumerate(names) if k not in seen]
    if NY and gone:
        warnings.warn('%s: left out, as they depend on %s: %s' % (
            who, ', '.join(dropped), ', '.join(gone)), _run.RunWarning, stacklevel=5)
    return LinearModel(a, b, c, d, tuple(model.states[k] for k in independent), model.inputs,
                       tuple(names[seen]), tangent, independent, dropped)


def matrix(numbers, rows, columns):
    """Numbers by columns, of which there may be more."""
    return numbers[:rows * columns].reshape((rows, columns), order='F').copy()


# ------------------------------------------------------------------------- what others use as well

def numbers(who, model, t, x, v):
    """The time, the states (or the coordinates, then at rest as the scene starts) and the inputs of
    a calculation at a state."""
    t = _run._vector(who, 't', [t] if np.ndim(t) == 0 else t, 1, 'time [s]')[0]
    if np.shape(x) == (NQ,) and NQ != NX:
        x = np.concatenate([x, np.zeros(NU), model.initial[NQ + NU:]])
    x = _run._vector(who, 'x', x, NX, 'numbers (the states of %s)' % NAME, model.states)
    v = np.zeros(NV) if v is None else _run._vector(
        who, 'v', v, NV, 'numbers (the inputs of %s)' % NAME, model.inputs)
    return t, x, v


def on_constraints(who, model, t, x, start):
    """The states as every calculation takes them."""
    _run._word(who, 'start', start, ('check', 'project'))
    found, x = Taken(), np.ascontiguousarray(x)
    verdict = LIBRARY.gs_loop_start(
        ctypes.c_double(t), at(model.cst), at(model._values), ctypes.c_int(start == 'check'), at(x),
        found.address())
    if verdict != 0:
        raise ValueError('%s: %s' % (who, _start.refusal(
            verdict, found.state, found.text.decode(), model).replace('x0[', 'x[')))
    warn_of_rank(who, model, t, x, REFUSALS.singular_linear)
    return x


def general_rank():
    """How many constraints are independent in general, 0 where the scene does not say it."""
    return (TABLE.get('mobility') or {}).get('rank', 0)


def warn_of_rank(who, model, t, x, what):
    """A warning where constraints that are independent elsewhere are not so; (nlam,): true for
    those whose multipliers nothing determines there."""
    loose = np.zeros(max(1, NLAM), np.intc)
    text = ctypes.create_string_buffer(1000)
    found = LIBRARY.gs_loop_lost_rank(
        ctypes.c_double(t), at(model.cst), ctypes.c_int(general_rank()), at(model.initial), at(x),
        at(loose), text, ctypes.c_int(len(text)))
    if found < 0:
        raise MemoryError(who)
    if found:
        warnings.warn('%s: at this position %s: %s' % (who, text.value.decode(), what),
                      _run.RunWarning, stacklevel=5)
    return loose[:NLAM] != 0


def place(model, t, x, v):
    """It as the calculations of host/linear take it."""
    here = Place(t=t)
    for name, given in (('cst', model.cst), ('x', x), ('v', v)):
        here.put(name, given if len(given) else np.zeros(1))
    here.put_texts('inputs', model.inputs)
    here.put_texts('units', [model.units['states'][name] for name in model.states])
    here.put_texts('constraints', [{'N': 'm', 'N*m': 'rad'}.get(
        model.units['multipliers'][name], '') for name in model.multipliers])
    return here


def _word(given):
    return given if isinstance(given, str) else None


def put_names(who, asked, member, option, given, known, expected):
    """Names as numbers into an array of the structure: how many."""
    names = listed(who, option, given)
    if not names:
        raise ValueError('%s: %s: expected %s; found none' % (who, option, expected))
    places_ = places(who, option, names, known, expected)
    asked.put(member, places_, np.intc)
    return len(places_)


def listed(who, option, given):
    """Names as a list, of one name too."""
    names = [given] if isinstance(given, str) else given
    if not isinstance(names, (list, tuple)) or not all(isinstance(n, str) for n in names):
        raise ValueError('%s: %s: expected names; found %r' % (who, option, given))
    return list(names)


def places(who, option, given, known, expected):
    """Where names stand among those that are known."""
    names = listed(who, option, given)
    for name in names:
        if name not in known:
            raise ValueError('%s: %s: expected %s; found %r%s' % (
                who, option, expected, name, nearest(name, known)))
    return [known.index(name) for name in names]


def _by(model, column):
    return (model.states + model.inputs)[column]


def speed_of(who, model, option, name):
    """Where a coordinate stands and the speed that is its rate."""
    q, = places(who, option, [name], model.coordinates, 'the name of a coordinate')
    if name + '_d' in model.speeds:
        return q, model.speeds.index(name + '_d')
    if NQ == NU and not TABLE.get('angles'):
        return q, q
    raise ValueError('%s: %s: %s has no speed of its own; expected a coordinate of a joint whose '
                     'speeds are rates of coordinates' % (who, option, name))


def heed(who, model, told, kind=ValueError):
    """Raise what is wrong with a calculation of host/linear/linear.h: kind, what it refuses."""
    if told.verdict == Told.NO_MEMORY:
        raise MemoryError(who)
    routine = (told.routine or b'').decode()
    if told.verdict == Told.ABSENT:
        model._has(routine)
    if told.verdict == Told.REFUSED:
        raise kind('%s: %s' % (who, told.text.decode()))
    if told.verdict in (Told.DERIVATIVE, Told.MARGIN):
        raise Error('%s: %s' % (who, told.text.decode()))
    if routine:
        text = '%s: %s: INFO = %d: %s' % (who, routine, told.info,
                                          _run.meaning(routine, told.info))
        if told.verdict == Told.FAILED:
            raise Error(text, told.info)
        warnings.warn(text, DependentWarning, stacklevel=5)
