"""Optimal motions by direct collocation (host/collocation/collocation.h)."""
import collections
import ctypes
import math
import os
import re
import threading
import warnings

import numpy as np

from . import _linear, _run
from ._arguments import nearest
from ._ends import Ends
from ._library import HERE, LIBRARY, NAME, SIZES, TABLE
from ._motion import Piecewise
from ._motion_structures import Arc, Bound, Guess, Mesh, Motion, Options, Problem, Product
from ._tables import REFUSALS, check, is_number

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))
NZ = NX + NU + NLAM + NV   # unknowns of a point: states, accelerations, multipliers, inputs
ONE_AT_A_TIME = threading.RLock()   # as MUMPS is; a goal of optimize may call collocate
COSTS = 'names of outputs, states or inputs, NAME^2, NAME*NAME, "final NAME" and "time"'

Collocation = collections.namedtuple(
    'Collocation', 't x v ud lam y costates goal T parameters input motion error meshes active '
    'switches singular solved ended stopped')
Collocation.__doc__ = """What collocate gives, of n points: t (n,) [s], x (nx, n), v, ud, lam, y;
costates (nx, n): derivatives of the least goal by the states; goal, T [s], parameters: free ones by
name; input: Piecewise, for simulate, None for a scene without inputs; motion: Piecewise, for
inverse, None where speeds are no rates; error: estimated, of the states; meshes: intervals,
iterations and error of each; active: bounds that hold the goal back; switches [s]: where inputs
jump; singular: arcs on which the goal does not determine an input; solved: within the accuracy;
ended: why it ended; stopped: "timeout" or ""."""


def collocate(self, x0, xf, *, time, goal='time', final=None, inputs=None, states=None,
              outputs=None, parameters=None, method='radau', intervals=20, accuracy=1e-6,
              refinements=6, guess=None, polish=True, regularize=1.0, tolerance=1e-9,
              iterations=500, seconds=60.0, timeout=0.0):
    """An optimal motion from the states x0 to xf (NaN where one is free), as gsmbp_collocate of
    Octave finds it; the scene has the request collocation, the module was built with Ipopt. In a
    closed chain what follows the actuated coordinates may be NaN in x0; in xf numbers for it are a
    guess, unless an actuated coordinate (or speed) is free there: then all are demanded.

    time [s]: the duration, or (least, largest). goal: what is least, "time", the name of an
    output, state or input, whose integral is meant, "NAME^2" or "NAME*NAME", "final NAME", or
    such words with weights, {"effort": 1, "final x": -3}. final: bounds of states at the end,
    {name: (least, largest)}; inputs, states, outputs: on the way, by default those of the scene;
    parameters: of those that are free. method: "radau" or "lobatto". intervals: of the first mesh;
    accuracy: of states, by their largest value or 1, above which intervals are cut, at most
    refinements times. guess: a former result, or (t, x, v). polish: solve once more with the
    instants at which inputs jump as unknowns. regularize: weight of the roughness of inputs on
    singular arcs. tolerance, iterations, seconds: of Ipopt for each mesh; timeout [s]: of all, 0:
    none. Result: a Collocation; that it is no solution is a warning.
    """
    who = NAME + '.collocate'
    needed(who, self)
    options = _options(who, method, intervals, accuracy, refinements, polish, regularize,
                       tolerance, iterations, seconds, timeout)
    p = Problem(t0=0)
    p.put('cst', self.cst)
    p.put('par', self._values)
    p.put_texts('inputs', self.inputs)
    p.put_texts('outputs', self.outputs)
    _ends(who, self, p, x0, xf, states)
    _bounds(who, self, p, time, final, inputs, states, outputs)
    _parameters(who, self, p, parameters)
    _goal(who, self, p, goal)
    start = _guess(who, self, p, guess)
    r = Motion()
    _solve(who, p, start, options, r)
    try:
        found = _result(self, p, r)
    finally:
        LIBRARY.gs_loop_motion_free(r.address())
    if not found.solved:
        warnings.warn('%s: %s' % (who, found.ended), _run.RunWarning, stacklevel=3)
    return found


def needed(who, model):
    """What a scene must have, and must not."""
    model._has('dae', 'daj', 'dah')
    for row in TABLE.get('controllers') or []:
        raise ValueError('%s: expected a scene without sampled devices; found %s' % (
            who, row['name']))
    if SIZES.get('nsw'):
        raise ValueError('%s: expected a scene that does not switch; found a switch at t = %.9g s'
                         % (who, min(model.swi())))


def _ipopt(who):
    """Ipopt in C, which setup.py makes where it finds it."""
    path = os.path.join(HERE, '_ipopt.so')
    if not os.path.exists(path):
        raise ImportError('%s: %s: %s was built without it; install it, then the module again' % (
            who, REFUSALS.no_ipopt, NAME))
    try:
        return ctypes.cast(ctypes.CDLL(path).gs_ipopt, ctypes.c_void_p)
    except OSError as problem:
        raise ImportError('%s: %s: %s' % (who, REFUSALS.no_ipopt, problem)) from None


def _options(who, method, intervals, accuracy, refinements, polish, regularize, tolerance,
             iterations, seconds, timeout):
    _run._word(who, 'method', method, ('radau', 'lobatto'))
    for name, value, kind in (
            ('accuracy', accuracy, 'tolerance'), ('tolerance', tolerance, 'tolerance'),
            ('regularize', regularize, 'nonnegative'), ('timeout', timeout, 'nonnegative'),
            ('seconds', seconds, 'positive')):
        check(who, name, value, kind)
    for name, value, least in (('intervals', intervals, 1), ('refinements', refinements, 0),
                               ('iterations', iterations, 0)):
        if not (is_number(value) and least <= value < 1e6 and value == int(value)):
            raise ValueError('%s: %s: expected a whole number from %d on; found %r' % (
                who, name, least, value))
    return Options(
        method=Options.RADAU if method == 'radau' else Options.LOBATTO, intervals=int(intervals),
        accuracy=accuracy, refinements=int(refinements), polish=bool(polish),
        regularize=regularize, tolerance=tolerance, seconds=seconds, iterations=int(iterations),
        timeout=timeout, solver=_ipopt(who))


# --------------------------------------------------------------------------------- the problem

def _ends(who, model, p, x0, xf, states):
    limits = _limits(who, 'states', states, model.states)
    for name, given in (('x0', x0), ('xf', xf)):
        x = np.asarray(given, float)
        if x.shape != (NX,) or np.isinf(x).any():
            raise ValueError('%s: %s: expected %d numbers (%s), NaN where one is free; found %r' % (
                who, name, NX, ', '.join(model.states), given))
        for k in np.flatnonzero((x < limits[:, 0]) | (x > limits[:, 1])):
            raise ValueError('%s: %s: %s = %g is not within its bounds, %g to %g' % (
                who, name, model.states[k], x[k], *limits[k]))
        p.put(name, x)


def _actuated():
    return [k - 1 for k in np.atleast_1d(TABLE.get('actuated') or []).astype(int)]


def _pairs(who, option, given, known):
    """{name: (least, largest)} as [(number, least, largest)]."""
    if not isinstance(given or {}, dict):
        raise ValueError('%s: %s: expected {name: (least, largest)}; found %r' % (
            who, option, given))
    rows = []
    for name, pair in (given or {}).items():
        k, = _linear.places(who, option, [name], known, 'a name')
        bounds = np.asarray(pair, float)
        if bounds.shape != (2,) or not bounds[0] <= bounds[1]:
            raise ValueError('%s: %s: %s: expected the least and the largest value; found %r' % (
                who, option, name, pair))
        rows.append((k, *bounds))
    return rows


def _limits(who, option, given, names):
    """Rows (least, largest), those of the scene where none are given."""
    limits = np.tile([-np.inf, np.inf], (len(names), 1))
    for row in TABLE.get('limits') or []:
        if row['name'] in names:
            limits[names.index(row['name'])] = row['low'], row['high']
    for k, low, high in _pairs(who, option, given, names):
        limits[k] = low, high
    return limits


def _bounds(who, model, p, time, final, inputs, states, outputs):
    times = np.atleast_1d(np.asarray(time, float))
    if times.shape not in ((1,), (2,)) or not (0 < times[0] <= times[-1] < math.inf):
        raise ValueError('%s: time: expected the duration, or the least and the largest; found %r'
                         % (who, time))
    p.duration[0], p.duration[1] = times[0], times[-1]
    inner = np.tile([-np.inf, np.inf], (NU + NLAM, 1))
    all_ = np.concatenate([_limits(who, 'states', states, model.states), inner,
                           _limits(who, 'inputs', inputs, model.inputs)])
    last = np.tile([-np.inf, np.inf], (NX, 1))
    for k, low, high in _pairs(who, 'final', final, model.states):
        last[k] = low, high
    rows = _pairs(who, 'outputs', outputs, model.outputs)
    p.nbounded = len(rows)
    p.put('bounded', [row[0] for row in rows] or [0], np.intc)
    for name, values in (('low', all_[:, 0]), ('high', all_[:, 1]), ('last_low', last[:, 0]),
                         ('last_high', last[:, 1]), ('output_low', [row[1] for row in rows] or [0]),
                         ('output_high', [row[2] for row in rows] or [0])):
        p.put(name, values)


def _free():
    return list((TABLE['collocation'] or {}).get('parameters') or [])


def _parameters(who, model, p, given):
    known = _free()
    if given and not known:
        raise ValueError('%s: parameters: expected names that %s was derived for (request '
                         'sensitivity(name, ...) beside collocation); found %s; it was derived for '
                         'none' % (who, NAME, list(given)[0]))
    rows = {known[k]: pair for k, *pair in _pairs(who, 'parameters', given, known)}
    for name in known:
        rows.setdefault(name, [model.parameters[name]] * 2)
    p.put('unknown_low', [rows[name][0] for name in known] or [0])
    p.put('unknown_high', [rows[name][1] for name in known] or [0])


def _goal(who, model, p, goal):
    """Weights of integrals of outputs, of the time, of states and outputs at the end, of integrals
    of states, inputs and products of them."""
    goal = {goal: 1} if isinstance(goal, str) else goal
    if not isinstance(goal, dict) or not goal:
        raise ValueError('%s: goal: expected a name, or {name: weight}; found %r' % (who, goal))
    weights = {name: np.zeros(n) for name, n in (
        ('output_weights', NY), ('final_states', NX), ('final_outputs', NY), ('linear', NZ))}
    products, ends = [], model.states + model.outputs
    for name, weight in goal.items():
        if not isinstance(name, str) or not is_number(weight):
            raise ValueError('%s: goal: expected a name, or {name: weight}; found %r: %r' % (
                who, name, weight))
        if name == 'time':
            p.time_weight += weight
        elif name.startswith('final '):
            k, = _linear.places(who, 'goal', [name[6:]], ends, 'a state or an output')
            at = 'final_states' if k < NX else 'final_outputs'
            weights[at][k if k < NX else k - NX] += weight
        elif name in model.outputs:
            weights['output_weights'][model.outputs.index(name)] += weight
        else:
            _integrand(who, model, name, weight, weights['linear'], products)
    for name, values in weights.items():
        p.put(name, values if len(values) else [0])
    p.nproducts = len(products)
    p.keep('products', (Product * (len(products) + 1))(*products))


def _integrand(who, model, name, weight, linear, products):
    """A term in the unknowns of a point."""
    names = model.states + model.inputs
    parts = [part.strip() for part in re.sub(r'^(.*)\^2$', r'\1*\1', name).split('*')]
    if len(parts) > 2 or not all(part in names for part in parts):
        raise ValueError('%s: goal: expected %s; found %r%s' % (
            who, COSTS, name, nearest(name, list(model.outputs + names))))
    places = sorted((k if k < NX else k + NU + NLAM for k in map(names.index, parts)),
                    reverse=True)
    if len(places) == 1:
        linear[places[0]] += weight
    else:
        products.append(Product(places[0], places[1], weight))


def _guess(who, model, p, guess):
    g = Guess(duration=1, nactuated=len(_actuated()))
    g.put('start', model.initial)
    g.put('actuated', _actuated() or [0], np.intc)
    if guess is None:
        return g
    if isinstance(guess, Collocation):
        guess = guess.t, guess.x, guess.v
    try:
        t, x, v = (np.asarray(part, float) for part in guess)
    except (TypeError, ValueError):
        raise ValueError('%s: guess: expected a Collocation or (t, x, v); found %r' % (
            who, guess)) from None
    n = t.size
    good = t.ndim == 1 and n > 1 and x.shape == (NX, n) and v.shape == (NV, n)
    if not (good and (np.diff(t) >= 0).all() and t[-1] > t[0]
            and np.isfinite(x).all() and np.isfinite(v).all()):
        raise ValueError('%s: guess: expected rising times and finite x (%d, n) and v (%d, n); '
                         'found the shapes %s, %s and %s' % (who, NX, NV, t.shape, x.shape,
                                                              v.shape))
    last = np.append(np.diff(t) > 0, True)   # of equal times
    g.n, g.duration = int(last.sum()), t[-1] - t[0]
    g.put('t', (t[last] - t[0]) / g.duration)
    g.put('x', x[:, last])
    g.put('v', v[:, last] if NV else [0])
    return g


# ---------------------------------------------------------------------------------- the result

def _solve(who, p, start, options, r):
    ends = Ends()
    with ONE_AT_A_TIME, ends:
        bad = LIBRARY.gs_loop_collocate(p.address(), start.address(), options.address(), ends.ask,
                                        r.address())
    if ends.failure is not None:
        LIBRARY.gs_loop_motion_free(r.address())
        raise ends.failure
    if bad == 1:
        raise MemoryError(who)
    if bad == 3:
        raise ValueError('%s: %s' % (who, r.ended.decode()))
    if bad:
        raise RuntimeError('%s: %s' % (who, r.ended.decode()))


def _named(model, one):
    names = {Bound.STATE: model.states, Bound.INPUT: model.inputs, Bound.OUTPUT: model.outputs,
             Bound.PARAMETER: _free()}
    return names[one.of][one.number] if one.of in names else 'time'


def _result(model, p, r):
    n, m = r.n, len(_free())
    rows = {name: r.array(name, size, n) for name, size in (
        ('x', NX), ('v', NV), ('ud', NU), ('lambda', NLAM), ('y', NY), ('costates', NX))}
    t = r.array('t', n)
    plans = {name: Piecewise(breaks, r.array(name, size, len(breaks) - 1, order)) if size else None
             for name, breaks, size, order in (
                 ('input', r.array('breaks', r.pieces + 1), NV, 3),
                 ('motion', t, r.nplanned, 6))}
    active = [{'name': _named(model, one), 'bound': 'largest' if one.largest else 'least',
               **{name: getattr(one, name) for name in ('value', 'from', 'until', 'multiplier')}}
              for one in r.rows('active', r.nactive, Bound)]
    arcs = [{'input': model.inputs[one.input],
             **{name: getattr(one, name) for name in ('from', 'until', 'ringing', 'weight')}}
            for one in r.rows('arcs', r.narcs, Arc)]
    meshes = [{'intervals': one.intervals, 'iterations': one.iterations, 'error': one.error,
               'ended': one.ended.decode()} for one in r.rows('meshes', r.nmeshes, Mesh)]
    return Collocation(
        t, rows['x'], rows['v'], rows['ud'], rows['lambda'], rows['y'], rows['costates'], r.goal,
        r.duration, dict(zip(_free(), r.array('unknown', m).tolist())), plans['input'],
        plans['motion'], r.error, meshes, active, r.array('switches', r.nswitches), arcs,
        bool(r.solved), r.ended.decode(), 'timeout' if r.stopped else '')
