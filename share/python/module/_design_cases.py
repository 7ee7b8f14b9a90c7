"""Load cases of a design at some values of its variables: what they give, and the derivatives of
it: of runs through the engine, else by differences of order 4."""
import types
import warnings

import numpy as np

from . import _inverse, _run
from ._arguments import nearest
from ._assemble import closed
from ._design import of_values
from ._design_slopes import (ACTUATED, fields_of, of_inverse, of_positions, parameters_by, PLANNED)
from ._design_structures import differences, weights
from ._derivatives import CHANGES, EVENTS, KNOWN
from ._library import Error, NAME, ROUTINES, SIZES, TABLE
from ._motion import Piecewise, as_piecewise
from ._sensitivity import oscillations

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))
ROWS = ('x', 'v', 'y', 'points', 'tau', 'lam', 'margins', 'state_margins')   # (rows, times)
COORDINATES = [row['name'] for row in TABLE['coordinates']]
ENDS = any(e.get('ends') for e in EVENTS)   # may an event end a run?


class Cases:
    """The load cases of a design."""

    def __init__(self, who, model, free, cases, fields):
        self.who, self.model, self.free, self.cases = who, model, free, cases
        self.exact = {case.name: _exact(model, free, case, fields[case.name]) for case in cases}

    def why(self):
        """Why derivatives are differences."""
        told = []
        for case in self.cases:
            exact, words = self.exact[case.name]
            if words:
                told.append(words)
        return '; '.join(told)

    def values(self, p):
        """The values by name."""
        return dict(zip((one.name for one in self.free), map(float, p)))

    def model_at(self, p):
        changed = {one.name: float(value) for one, value in zip(self.free, p)
                   if one.kind == 'parameter'}
        return self.model.changed(**changed) if changed else self.model

    def run(self, case, p, by=None):
        """What a case gives, R, its derivatives D by the variables of the mask by, with the last
        dimension for all of them, and the mask of those that are differences."""
        if by is None:
            return self._made(case, p, [])[0], {}, np.zeros(len(p), bool)
        rough = np.array(by) & ~self._exact_there(case, p)
        names = [one.name for one, k in zip(self.free, np.array(by) & ~rough)
                 if k and one.kind != 'own']
        R, parts = self._made(case, p, names)
        if case.kind == 'rest':
            rough |= [one.name in parts and _is_unknown(parts[one.name]) for one in self.free]
        D = {}
        if case.kind in _CHAINED and (by & ~rough).any():
            D = self._chained(case, p, R, by & ~rough)
        for k, one in enumerate(self.free):
            if rough[k]:
                _put(D, self.slope(k, p, lambda q: _numbers(self._made(case, q, [])[0])), k, len(p))
            elif one.name in parts:
                _put(D, parts[one.name], k, len(p))
        return R, D, rough

    def _chained(self, case, p, R, exact):
        """Derivatives by the variables of the mask exact, through the motion or the positions that
        a function of the values plans, and by parameters."""
        names = {one.name for one, k in zip(self.free, exact) if k}
        by = parameters_by(self.free, names)
        place = _CHAINED[case.kind]
        given = case.given[place]

        def planned(q):
            return {'at': _planned(case, given(self.values(q)) if of_values(given) else given,
                                   R.t)}
        changes = np.zeros(planned(p)['at'].shape + (len(p),))
        for k in np.flatnonzero(exact) if of_values(given) else ():
            changes[..., k] = self.slope(k, p, planned)['at']
        slopes = of_inverse if case.kind == 'inverse' else of_positions
        return slopes(self.who, self.model_at(p), R, changes, by)

    def slope(self, k, p, f):
        """The derivative of f (values), a dict of arrays, by variable k."""
        one = self.free[k]
        points, factors = differences(one.start, one.low, one.high, p[k])

        def at(value):
            q = np.array(p, float)
            q[k] = value
            return f(q)
        return _combined([at(value) for value in points], factors)

    def _exact_there(self, case, p):
        """The mask of variables that have exact derivatives: no function of the user's depends on
        them."""
        exact = self.exact[case.name][0].copy()
        told = [x for k, x in enumerate(case.given) if _CHAINED.get(case.kind) != k]
        told += [x for name, x in case.options.items() if name != 'guess']   # that tells a branch
        functions = [x for x in told if of_values(x)]
        for f in functions:
            here = f(self.values(p)) if exact.any() else None
            for k in np.flatnonzero(exact):
                one, q = self.free[k], np.array(p, float)
                q[k] = differences(one.start, one.low, one.high, p[k])[0][-1]
                exact[k] = _same(here, f(self.values(q)))
        return exact

    def _made(self, case, p, names):
        """R and the exact derivatives by names; errors name the case."""
        def filled(x):
            return x(self.values(p)) if of_values(x) else x
        try:
            with warnings.catch_warnings():
                warnings.simplefilter('ignore', _run.RunWarning)
                model = self.model_at(p)
                given = [filled(x) for x in case.given]
                options = {name: filled(x) for name, x in case.options.items()}
                starts = {one.name: value for one, value in zip(self.free, p)
                          if one.kind == 'state'}
                return _KINDS[case.kind](self.who, model, given, options, names, starts)
        except (ArithmeticError, ValueError) as problem:
            if str(problem).startswith(self.who + ': '):
                raise
            kind = Error if isinstance(problem, ArithmeticError) else ValueError
            raise kind('%s: case %s: %s' % (self.who, case.name, problem)) from problem


def _exact(model, free, case, fields):
    """A mask of the variables with exact derivatives, and why there are not all."""
    possible = _possible(case, fields)
    exact = np.array([possible and (one.kind == 'own' or one.name in KNOWN or (
        one.kind == 'state' and case.kind == 'run')) for one in free])
    why = ''
    if not possible:
        why = 'no exact derivatives of %s in case %s (%s)' % (
            ', '.join(sorted(fields)), case.name, case.kind)
    elif not exact.all():
        why = '%s was not derived for %s (request sensitivity)' % (
            NAME, ', '.join(one.name for one, k in zip(free, exact) if not k))
    return exact, why


def _possible(case, fields):
    """Are there exact derivatives of these fields?"""
    if case.kind == 'inverse':
        given = case.given[0]
        planned = of_values(given) or getattr(given, 'n', len(PLANNED)) == len(PLANNED)
        return planned and not case.options and fields_of('inverse', fields)
    if case.kind == 'positions':
        held = [case.given[0]] if isinstance(case.given[0], str) else list(case.given[0])
        planned = not NLAM or sorted(held) == sorted(COORDINATES[k] for k in PLANNED)
        return planned and fields_of('positions', fields)
    possible = (set(fields) <= {'x', 'y', 'v', 'extra'} and 'rhp' in ROUTINES
                and ('y' not in fields or {'jac', 'oup'} <= ROUTINES.keys()))
    if case.kind == 'rest':
        return possible and 'jac' in ROUTINES
    return (possible and case.kind == 'run' and _plain_run(case)
            and (not NLAM or ({'con', 'tan', 'cop'} <= ROUTINES.keys() and NQ == NU)))


# which argument plans: exact derivatives go through it
_CHAINED = {'inverse': 0, 'positions': 1}


def _planned(case, given, t):
    """A planned motion with its derivatives, (planned, 1 + order, nt), or positions of all planned
    coordinates, (planned, nt)."""
    if case.kind == 'inverse':
        poly = as_piecewise('optimize', 'the planned motion', given, len(PLANNED))
        order = max(2, TABLE['command_order'])
        return np.stack(poly.derivatives(t, range(order + 1), 1), axis=1)
    held = [case.given[0]] if isinstance(case.given[0], str) else list(case.given[0])
    values = np.asarray(given, float).reshape(len(held), -1)
    planned = np.zeros((len(PLANNED), values.shape[1]))
    for name, row in zip(held, values):
        planned[PLANNED.index(COORDINATES.index(name))] = row
    return planned


def _plain_run(case):
    """Does simulate carry derivatives in such a run?"""
    devices = TABLE.get('controllers') or []
    own = np.array([e['kind'] == 'event' for e in EVENTS], bool)
    needed = {'evp': bool(EVENTS), 'rsp': (~own).any(), 'urp': (own & CHANGES[:-1]).any(),
              'cmp': 'motion' in case.options, 'ctd': bool(devices)}
    given = case.options.get('input')
    plain = given is None or of_values(given) or not callable(given) or hasattr(given, 'breaks')
    still = not ENDS or ({'motion', 'gain'}.isdisjoint(case.options)
                         and not hasattr(given, 'breaks') and not hasattr(given, 'c'))
    return (all(name in ROUTINES for name, need in needed.items() if need) and plain and still
            and not any(d.get('rounds') for d in devices)
            and case.options.get('audit') is None
            and case.options.get('loops') in (None, 'baumgarte', 'projection'))


# ------------------------------------------------------------------------------------ kinds

def _simulated(who, model, given, options, names, starts):
    times, x0 = given
    x0 = np.array(x0, float)
    for name, value in starts.items():
        x0[model.states.index(name)] = value
    fixed = options.pop('fixed', None)
    if NLAM:
        held = [COORDINATES[k] for k in PLANNED] if fixed is None else fixed
        x0 = closed(who, model, x0, held)[:, 0]
    if names:
        options.update(sensitivity=names, fixed=fixed)
    r = model.simulate(x0, times, **options)
    n, have = np.size(times), len(r.t)
    R = types.SimpleNamespace(
        t=r.t, x=r.x, v=r.v, y=r.y, events=r.events, stats=r.stats,
        extra={'end_time': float(r.t[-1])})
    _add_places(model, R)
    if 'mar' in ROUTINES:
        R.state_margins = _columns(model.mar(R.t, R.x, R.v), have)
    w, w_end = weights(R.t)
    R.w = np.append(w, np.zeros(n - have))
    parts = _end_slopes(model, r, names, w_end, n)
    for name in ('t', *ROWS):
        if getattr(R, name, None) is not None:
            setattr(R, name, _filled(getattr(R, name), n))
    return R, parts


def _columns(found, n):
    """What a subroutine gives at n times."""
    return np.asarray(getattr(found, 'g', found)).reshape(-1, n)


def _filled(a, n):
    """With the last time once more, up to n."""
    return a[..., np.minimum(np.arange(n), a.shape[-1] - 1)]


def _end_slopes(model, r, names, w_end, n):
    """Derivatives of a run by names; its end moves with the event that ends it."""
    ended = r.stats['stopped'] is not None
    parts = {}
    rates = _end_rates(model, r) if ended and names else None
    for name in names:
        x, y = r.dx[name].copy(), r.dy[name].copy()
        t, dt = np.zeros(len(r.t)), 0.0
        if ended:
            last = [k for k, (at, number) in enumerate(zip(r.events['t'], r.events['number']))
                    if at == r.t[-1] and EVENTS[number].get('ends')][0]
            dt = t[-1] = r.events['dt'][name][last]
            x[:, -1] += dt * rates[0]
            y[:, -1] += dt * rates[1]
        parts[name] = {
            'x': _filled(x, n), 'v': _filled(r.dv[name], n), 'y': _filled(y, n),
            't': _filled(t, n), 'w': np.append(dt * w_end, np.zeros(n - len(r.t))),
            'extra': {'end_time': dt}}
    return parts


def _end_rates(model, r):
    """Of states and outputs at the end, under inputs that stay as they are."""
    t, x, v = r.t[-1], r.x[:, -1], r.v[:, -1]
    rate = model.rhs(t, x, v)
    if not NY:
        return rate, np.zeros(0)
    h = 1e-3 * max(1.0, abs(t))
    y = [model.out(t + s * h, x, v) for s in (-2, -1, 1, 2)]
    return rate, model.linearize(t, x, v).c @ rate + (8 * (y[2] - y[1]) - y[3] + y[0]) / (12 * h)


def _along(who, model, given, options, names, starts):
    r = model.inverse(*given, **options)
    R = types.SimpleNamespace(**r._asdict(), w=weights(r.t)[0], extra={})
    if R.x is None and NX == NQ + NU:
        R.x = np.concatenate([R.q, R.u])
    _add_outputs(model, R)
    return R, {}


def _at_rest(who, model, given, options, names, starts):
    e = model.trim(*given, **options)
    R = types.SimpleNamespace(t=np.zeros(1), w=np.ones(1), x=e.x[:, None], v=e.v[:, None], extra={})
    _add_outputs(model, R)
    parts = {}
    if 'rhp' in ROUTINES:
        keep = {name: options[name] for name in ('hold', 'free', 'time') if name in options}
        s = model.sensitivity(e.x, e.v, **keep)
        R.extra = _of_vibrations(s.poles.real, s.frequency, s.damping)
        slow = np.argmax(s.poles.real) if s.poles.size else 0
        for name in names:
            parts[name] = {'x': s.dx[name][:, None], 'v': s.dv[name][:, None],
                           'y': s.dy[name][:, None], 'extra': _of_vibrations(
                               s.dpoles[name].real[slow:slow + 1], s.dfrequency[name],
                               s.ddamping[name])}
    else:
        a = model.linear(options.get('time', 0.0), e.x, e.v).a
        poles = np.linalg.eigvals(a) if a.size else np.zeros(0)
        poles = poles[np.argsort(np.abs(poles), kind='stable')]
        R.extra = _of_vibrations(poles.real, *oscillations(poles))
    return R, parts


def _is_unknown(part):
    """A multiple pole has no derivatives."""
    return bool(np.isnan([*part['extra'].values()]).any())


def _of_vibrations(decay, frequencies, dampings):
    """Numbers of an equilibrium by name."""
    extra = {'decay': -decay.max()} if decay.size else {}
    for k, (frequency, damping) in enumerate(zip(frequencies, dampings)):
        extra['frequency%d' % (k + 1)] = frequency
        extra['damping%d' % (k + 1)] = damping
    return extra


def _positions(who, model, given, options, names, starts):
    """Coordinates that are held, one position after the other, at rest."""
    held = [given[0]] if isinstance(given[0], str) else list(given[0])
    places = _run_places(who, held)
    values = np.asarray(given[1], float)
    values = values.reshape(1, -1) if len(held) == 1 else values
    if values.ndim != 2 or values.shape[0] != len(held) or not np.isfinite(values).all():
        raise ValueError('%s: expected finite values of the held coordinates, the shape (%d, k); '
                         'found %s' % (who, len(held), np.shape(given[1])))
    q = _run._vector(who, 'guess', options.get('guess', model.initial[:NQ]), NQ).copy()
    n = values.shape[1]
    x = np.zeros((NX, n))
    x[NQ + NU:] = model.initial[NQ + NU:, None]
    for i in range(n):
        q = _held(who, model, q, places, values[:, i])
        x[:NQ, i] = q
    R = types.SimpleNamespace(t=np.arange(1.0, n + 1), w=np.full(n, 1 / n), x=x,
                              v=np.zeros((NV, n)), extra={})
    still = np.zeros((NU, n))
    if NLAM and 'inl' in ROUTINES:
        R.tau, R.lam = model.inl(np.zeros(n), x[:NQ], still, still)
    elif 'inv' in ROUTINES:
        R.tau = model.inv(np.zeros(n), x[:NQ], still, still)
    _add_outputs(model, R, np.zeros(n))
    return R, {}


def _run_places(who, held):
    for name in held:
        if name not in COORDINATES:
            raise ValueError('%s: unknown coordinate %r%s' % (
                who, name, nearest(name, COORDINATES)))
    return [COORDINATES.index(name) for name in held]


def _held(who, model, q, places, values):
    if not NLAM or sorted(places) != sorted(ACTUATED):
        q = q.copy()
        q[places] = values
        x = np.concatenate([q, model.initial[NQ:]])
        return closed(who, model, x, [COORDINATES[k] for k in places])[:NQ, 0] if NLAM else q
    planned, at = sorted(places), dict(zip(places, values))
    motion = Piecewise([0, 1], np.array([at[k] for k in planned])[:, None, None])
    return _inverse.along(who, model, motion, [k + 1 for k in planned], [0.0], 1, q)[:, 0, 0]


_KINDS = {'run': _simulated, 'inverse': _along, 'rest': _at_rest, 'positions': _positions}


def _add_places(model, R, t=None):
    """Places of points and frames: three rows each."""
    if 'pnt' in ROUTINES and R.x is not None:
        p = model.pnt(R.t if t is None else t, R.x[:NQ])
        p = getattr(p, 'p', p)
        R.points = np.asarray(p).reshape((-1, len(R.t)), order='F')


def _add_outputs(model, R, t=None):
    t = R.t if t is None else t
    R.y = None
    if NY and 'out' in ROUTINES and R.x is not None:
        v = R.v if R.v is not None else np.zeros((NV, len(t)))
        R.y = np.asarray(model.out(t, R.x, v)).reshape(NY, len(t))
    _add_places(model, R, t)


# ---------------------------------------------------------------------------- numbers of results

def _numbers(R):
    """The fields that are numbers, as a dict."""
    found = {name: np.asarray(getattr(R, name)) for name in (*ROWS, 't', 'w')
             if getattr(R, name, None) is not None}
    found['extra'] = dict(R.extra)
    return found


def _combined(values, factors):
    """Less the first value: of numbers that do not change exactly 0."""
    first = values[0]
    if isinstance(first, dict):
        return {name: _combined([one[name] for one in values], factors) for name in first
                if all(name in one for one in values)}
    return sum(factor * (np.asarray(value) - first)
               for factor, value in zip(factors[1:], values[1:]))


def _put(D, one, k, n):
    """Variable k of n of the derivatives."""
    for name, value in one.items():
        if isinstance(value, dict):
            _put(D.setdefault(name, {}), value, k, n)
        else:
            D.setdefault(name, np.zeros(np.shape(value) + (n,)))[..., k] = value


def _same(a, b):
    """Are two values of a function of the user's the same?"""
    if isinstance(a, dict):
        return isinstance(b, dict) and a.keys() == b.keys() and all(_same(a[k], b[k]) for k in a)
    if isinstance(a, Piecewise):
        return isinstance(b, Piecewise) and np.array_equal(a.flat(), b.flat())
    if callable(a) or callable(b):
        return False
    return np.array_equal(np.asarray(a), np.asarray(b))
