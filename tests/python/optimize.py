"""Designs of modules beside those of Octave: a lamp with runs, positions, an equilibrium, every
word; closed forms, of events too; choices, contradictions, several starts; refusals; what ends them
from outside.

python3 optimize.py FILE: of optimize.m; the modules that it imports must be installed."""
import inspect
import json
import math
import os
import signal
import sys
import threading
import time
import warnings

import numpy as np

import design_fourbar
import design_lamp
import design_rotor
import sensitivity_bounce
import sensitivity_crank
from checks import close, holds, refuses

LAMP = design_lamp.Model()
TIMES = np.linspace(0, 2, 21)
RUN = ('run', TIMES, [0.5, 0])
GRAVITY = 9.81
WORDS = ('start', 'end', 'mean', 'integral', 'drawn', 'square', 'rms', 'peak', 'max', 'min',
         'settling')


def quiet(function, *values, **named):
    """Its result, without warnings, of a contradiction as well."""
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        try:
            return function(*values, **named)
        except ArithmeticError as error:
            return error.results


# ------------------------------------------------------------------------------ beside Octave

def problems():
    """The designs of optimize.m."""
    bare = LAMP.changed(k=0)
    found = {
        'damper': quiet(LAMP.optimize, ('d', 0.5, (0, 20)), ('square', 'q'), None, RUN),
        'held': quiet(LAMP.optimize, ('d', 0.5, (0, 20)), ('square', 'q'), [
            ('value', 'd', '<', 3), ('end', 'q', '<', 1)], RUN, solver='ipopt'),
        'two': quiet(LAMP.optimize, ('d', 2, (0.1, 20)), ('peak', 'q_d'), (
            'end', 'total', '<', 9), [('run', TIMES, [0.3, 0], {'input': 0, 'name': 'a'}),
                                      ('run', TIMES, [-0.3, 0], {'input': 0, 'name': 'b'})])}
    path = {'q': lambda t: -np.pi / 2 + 0.3 * np.exp(-2 * t)}
    for word in WORDS:
        found['word_' + word] = quiet(
            LAMP.optimize, ('d', 2, (0.1, 20)), (word, 'error.q*q'), ('value', 'd', '=', 2),
            (*RUN, {'target': path, 'band': 0.5}))
    found['rest'] = quiet(
        LAMP.changed(mc=8).optimize, ('k', 50, (1, 1000)), ('value', 'k'), [
            ('end', 'frequency1', '>', 4), ('end', 'decay', '>', 0)], ('rest', [0, 0], [0]))
    found['double_pole'] = quiet(
        design_rotor.Model().optimize, ('k', 20, (1, 1000)), ('value', 'k'),
        ('end', 'frequency1', '>', 30), ('rest', [0] * 6, [], {'hold': 's'}))
    found['branch'] = quiet(
        bare.optimize, [('mc', 1, set(0.3 + 0.13 * np.arange(50))),
                        ('lc', 0.1, set(0.05 + 0.0137 * np.arange(40)))],
        [('mass', 'weight', 1), ('value', 'lc', 8)], ('peak', 'effort.q', '<', 0.5),
        ('positions', 'q', 0))
    found['conflict'] = quiet(
        bare.optimize, [('mc', 1, (0.1, 10)), ('lc', 0.1, (0.01, 0.4))], ('end', 'total'),
        [('value', 'lc', '<', 0.39), ('peak', 'effort.q', '<', 1), ('end', 'total', '<', 3.5),
         ('value', 'mc', '>', 0.2)], ('positions', 'q', [-1, 0, 1]))
    m, times = sensitivity_crank.Model(), np.linspace(0, 0.2, 41)
    found['loops'] = quiet(
        m.optimize, ('n', 20, (2, 80)), ('rms', 'motor.i'), ('end', 'q1', '>', 0.8, 'one'),
        [('run', times, m.initial, {'input': 12, 'name': 'one'}),
         ('run', times, m.initial, {'input': -9, 'name': 'two'})])
    plan = sensitivity_crank.plan('septic', [0.3, 2.6], [0, 1.5])
    found['slider'] = quiet(m.changed(g=-9.81).optimize, ('m3', 2, (0, 50)), ('square', 'motor.i'),
                            None, ('inverse', plan, np.linspace(0, 1.5, 41)))
    return found


def found_alone(report):
    """without why it ended and how often it looked: rounding says both"""
    first, *lines, last = report.strip().split('\n')
    return first.split(',')[0], lines, last.split('evaluations')[1]


def beside_octave(wanted):
    for name, r in problems().items():
        one = wanted[name]
        close('%s beside Octave: values, goal' % name, [*r.values.values(), r.J],
              [*one['values'].values(), one['J']], 1e-9)
        holds('... info, solver, what is active, contradictions, problems', (
            r.info == one['info'] and r.solver == one['solver']
            and [a['text'] for a in r.active] == list(one['texts'])
            and r.conflict == list(one['conflict']) and r.choices['solved'] == one['problems']))
        holds('... derivatives: ' + r.derivatives, r.derivatives == one['derivatives'])
        if name in ('damper', 'held', 'two'):
            holds('... the report', found_alone(r.report) == found_alone(one['report']))
        close('... multipliers', [0, *(a['multiplier'] for a in r.active)],
              [0, *one['multipliers']], 1e-7 * max(1, abs(one['J'])))


def complex_numbers(part):
    return np.ravel(part['re']) + 1j * np.ravel(part['im'])


def sensitivity_beside_octave(wanted):
    """Of equilibria: a lamp, a crank that its motor holds; by all parameters."""
    for module in (design_lamp, sensitivity_crank):
        one = wanted[module.__name__]
        options = dict(zip(one['options'][::2], one['options'][1::2]))
        s = module.Model().sensitivity(np.ravel(one['x']), np.ravel(one['v']), **options)
        what = 'sensitivity of %s beside Octave: ' % module.__name__
        holds(what + 'names', list(s.names) == list(np.ravel(one['names'])))
        poles = complex_numbers(one['poles'])
        close(what + 'poles, frequency, damping', [*s.poles, *s.frequency, *s.damping],
              [*poles, *np.ravel(one['frequency']), *np.ravel(one['damping'])],
              1e-9 * np.abs(poles).max())
        for part in ('dx', 'dv', 'dy', 'dpoles', 'dfrequency', 'ddamping'):
            exact = part in ('dx', 'dv', 'dy')
            found = np.concatenate([[0], *(getattr(s, part)[name] for name in s.names)])
            beside = np.concatenate([[0], *map(complex_numbers, one[part])])
            size = np.abs(beside).max(initial=1)
            close(what + part, found / size, beside / size, 1e-12 if exact else 1e-8)
    at, h = LAMP.trim([0.0, 0.0]).x, 1e-3
    s = LAMP.sensitivity(at)
    k = LAMP.parameters['k']
    ends = [LAMP.changed(k=k + sign * h).modes(at).frequency for sign in (1, -1)]
    close('the frequency of the lamp by its spring, beside differences of modes',
          s.dfrequency['k'], (ends[0] - ends[1]) / (2 * h), 1e-8)
    crank = sensitivity_crank.Model()
    x, v = (np.ravel(wanted['sensitivity_crank'][name]) for name in 'xv')
    refuses('an equilibrium that a state holds fast', ValueError,
            ['sensitivity_crank.sensitivity', 'no equilibrium near this one'], crank.sensitivity,
            x, v, hold='q1')
    refuses('an equilibrium that does not stand alone', ValueError, ['does not stand alone: q1'],
            crank.sensitivity, x, v, free='motor.v')
    refuses('no equilibrium', ValueError, ['expected an equilibrium'], crank.sensitivity, x,
            [0], hold='q1', free='motor.v')
    refuses('a state that is none', ValueError, ["hold: expected the name of a state; found 'q9'"],
            crank.sensitivity, x, v, hold='q9')


# ------------------------------------------------------------------------------ closed forms

def slopes():
    """Of all words, as prices of an equation, beside differences of what they say."""
    bare = LAMP.changed(k=0)
    case = ('run', TIMES, [-np.pi / 2 + 0.5, 0],
            {'target': {'q': -np.pi / 2}, 'band': 0.2, 'rtol': 1e-12})
    for word in WORDS:
        row = (word, 'error.q')

        def at(d):
            return quiet(bare.optimize, ('d', d, {d}), row, None, case).J
        r = quiet(bare.optimize, ('d', 2, (0.1, 20)), row, ('value', 'd', '=', 2), case)
        wanted = (8 * (at(2.001) - at(1.999)) - at(2.002) + at(1.998)) / 0.012
        close('the slope of %s, %.6g' % (word, wanted), r.active[0]['multiplier'], wanted,
              1e-6 * max(1, abs(wanted)))
        holds('... inside', word != 'settling' or 0 < r.J < 1.9)


def whirl():
    """The rotor: w^2 + Jp*W/Jd*w - k/Jd = 0 of backward, with the other sign of forward whirl."""
    m, W = design_rotor.Model(), np.array([0.0, 10.0, 30.0, 60.0])
    half = m.parameters['Jp'] * W / m.parameters['Jd'] / 2
    middle = np.sqrt(m.parameters['k'] / m.parameters['Jd'] + half ** 2)
    found = m.campbell(np.zeros(6), 's', W).frequency
    close('a Campbell diagram by hand', found, [middle - half, middle + half], 1e-12 * 100)


def balance():
    """k*h*r = m*g*l - mc*g*lc; the lightest counterweight mc*lc = m*l at the longest arm."""
    still = ('positions', 'q', np.linspace(-1.2, 1.3, 7))
    k = (2 * 0.4 - 0.1) * GRAVITY / (0.3 * 0.2)
    for word in ('square', 'peak'):
        r = LAMP.optimize(('k', 50, (1, 1000)), (word, 'effort.q'), None, still)
        close('a spring balances the arm, by ' + word, r.values['k'] / k, 1, 1e-6)
        holds('... with exact derivatives', r.derivatives == 'exact')
    bare = LAMP.changed(k=0)
    free = [('mc', 1, (0.1, 10)), ('lc', 0.1, (0.01, 0.4))]
    r = bare.optimize(free, ('end', 'total'), ('each', 'effort.q', '=', 0), still)
    close('the lightest counterweight', [*r.values.values()], [2, 0.4], 1e-6)
    close('its multiplier at the longest arm, mc/lc',
          [a['multiplier'] for a in r.active if a['kind'] == 'bound'], 5, 1e-5)
    r = bare.optimize(free, ('mass', 'all'), ('each', 'effort.q', '=', 0), still, starts=3, seed=2)
    close('by its mass, from three starts', [r.J, *r.values.values()], [4, 2, 0.4], 1e-6)
    holds('all ends are told', len(r.starts) == 3 and 'best of 3 ends (3 starts' in r.report)
    r = bare.optimize(free, ('mass', 'all'), ('each', 'effort.q', '=', 0), still,
                      starts=[[3, 0.2], [4, 0.1]], solver='ipopt')
    holds('starts that are given', r.solved and len(r.starts) == 3)


def least_effort():
    """Rest to rest without forces: the cubic; its coefficients as free variables of one's own."""
    free_arm = LAMP.changed(g=0, k=0, d=0)

    def plan(values):
        return design_lamp.Piecewise([0, 0.8], [[[values['a'], values['b'], 0, 0]]])
    r = free_arm.optimize(
        [('a', -1, (-99, 99)), ('b', 2, (-99, 99))], ('integral', 'effort.q*effort.q'),
        [('end', 'q', '=', 1.2), ('end', 'q_d', '=', 0)],
        ('inverse', plan, np.linspace(0, 0.8, 9)))
    close('the motion of least effort: 3 s^2 - 2 s^3', [*r.values.values()],
          1.2 * np.array([-2 / 0.8**3, 3 / 0.8**2]), 1e-6)


def motions():
    """Slopes along motions and of positions of a closed chain, by its parameters and the motion, as
    prices of equations, beside differences of goals."""
    m = sensitivity_crank.Model()
    times = np.linspace(0.1, 0.9, 5)

    def plan(p):
        return sensitivity_crank.plan('septic', [0.3, 0.3 + p['s']], [0, 1])
    places = ('positions', 'q1', lambda p: [0.3 + p['s'], 1.0])
    for case, names in ((('inverse', plan, times),
                         ('effort.q1', 'motor.v', 'motor.i', 'q3', m.multipliers[0])),
                        (places, ('effort.q1', 'q3', 'q2', m.multipliers[1]))):
        for name in names:
            row = ('integral', name + '*' + name)
            for free in (('l1', m.parameters['l1']), ('n', 20.0), ('s', 0.4)):
                rows = [(*free, (0.01, 90))] + [('s', 0.4, (0.1, 2))] * (free[0] != 's')
                held = [('value', one[0], '=', one[1]) for one in rows]

                def at(x):
                    now = [(rows[0][0], x, {x}), *((*one[:2], {one[1]}) for one in rows[1:])]
                    return quiet(m.optimize, now, row, None, case).J
                r = quiet(m.optimize, rows, row, held, case)
                h = 1e-3 * free[1]
                wanted = (8 * (at(free[1] + h) - at(free[1] - h)) - at(free[1] + 2 * h)
                          + at(free[1] - 2 * h)) / (12 * h)
                found = [a['multiplier'] for a in r.active if 'value %s ' % free[0] in a['text']]
                close('%s of %s by %s, %.6g' % (name, case[0], free[0], wanted), [*found, 0],
                      [wanted, 0], 1e-7 * max(abs(wanted), abs(r.J)))
                holds('... exact', r.derivatives == 'exact')


def four_bar():
    """Ten unknowns of a four-bar from twelve places of its coupler point."""
    m, turns = design_fourbar.Model(), np.arange(12) * np.pi / 6
    names = ['xa', 'ya', 'a', 'b', 'c', 'dx', 'dy', 'cx', 'cy', 'th']
    made = np.array([*(m.parameters[name] for name in names[:-1]), 0.4])

    def positions(**more):
        return ('positions', 'q1', lambda p: turns + p['th'], more)
    path = m.optimize(('th', 0.4, {0.4}), None, None, positions()).results['case1'].y
    start = made + [0.02, -0.02, 0.01, 0.02, -0.02, 0.015, -0.02, 0.01, -0.015, 0.1]
    r = m.optimize([(name, x, (-2, 2)) for name, x in zip(names, start)],
                   [('square', 'error.px'), ('square', 'error.py')], None,
                   positions(target={'px': path[0], 'py': path[1]}))
    close('a four-bar by its timed path', [*r.values.values()], made, 1e-7)
    holds('... with exact derivatives', r.derivatives == 'exact')
    x = quiet(m.optimize, ('own', 1, {1}), None, None,
              ('positions', 'q2', [1.0, 1.1])).results['case1'].x
    close('positions held by another coordinate', m.con([0, 0], x[:3], x[3:6]).phi,
          np.zeros((2, 2)), 1e-12)
    holds('... stays', x[1].tolist() == [1.0, 1.1])
    r = quiet(m.optimize, ('a', m.parameters['a'], (0.01, 1)), ('end', 'py'), None,
              ('positions', 'q2', [1.0]), evaluations=3)
    holds('... its derivatives are differences', 'no exact derivatives' in r.derivatives)
    refuses('a coordinate that it has not', ValueError, ["'q9'", 'known: q1, q2, q3'],
            m.optimize, ('xa', 0.1, (0, 1)), ('end', 'py'), None, ('positions', 'q9', [1.0]))


def branches():
    """The crank at rest at places all around, from the guess of the scene: the rocker is on the
    branch of the guess, by the law of cosines, and has not turned."""
    m, turns = design_fourbar.Model(), np.linspace(-3, 3, 25)
    p, worst = m.parameters, 0.0
    for q in turns:
        motion = design_fourbar.plan('quintic', [q, q], [0, 1])
        found = m.inverse(motion, [0.0]).q[2, 0]
        bx, by = p['a'] * math.cos(q) - p['dx'], p['a'] * math.sin(q) - p['dy']
        d = math.hypot(bx, by)
        opened = math.acos((p['c'] ** 2 + d ** 2 - p['b'] ** 2) / (2 * p['c'] * d))
        worst = max(worst, abs(found - (math.atan2(by, bx) % (2 * math.pi) - opened)))
    close('inverse from a guess far away stays on its branch', worst, 0, 1e-12)
    r = m.optimize(('own', 1, {1}), None, None,
                   ('positions', 'q1', turns[::-1, None], {'name': 'back'}))
    close('positions in any order too', r.results['back'].x[2, 0], m.inverse(
        design_fourbar.plan('quintic', [3, 3], [0, 1]), [0.0]).q[2, 0], 1e-12)


def functions():
    """The least of (a - 1)^2 + (b - 2)^2 on a + b = 1: (0, 1), price of the equation -2."""
    rows = [('a', 0.5, (-5, 5)), ('b', 0.5, (-5, 5))]
    for given in (False, True):
        def goal(p):
            a, b = p['a'] - 1, p['b'] - 2
            return (a * a + b * b, [2 * a, 2 * b]) if given else a * a + b * b

        def line(p):
            return p['a'] + p['b']
        for solver in ('slsqp', 'mma', 'cobyla', 'ipopt'):
            demand = (line, '<', 1) if solver in ('mma', 'cobyla') else (line, '=', 1)
            r = quiet(LAMP.optimize, rows, goal, demand, solver=solver,
                      tolerance=1e-8 if solver == 'cobyla' else 1e-10)
            size = 1e-4 if solver == 'cobyla' else 1e-6
            close('of functions, %s, derivatives given: %s' % (solver, given),
                  [*r.values.values(), r.J, abs(r.active[0]['multiplier'])], [0, 1, 2, 2], size)
    lamp = LAMP.changed(k=0.7 * GRAVITY / 0.06)
    r = lamp.optimize(('kp', 5, (0, 50)), ('value', 'kp'), ('end', 'q', '<', 0.05), (
        'run', TIMES[:11], [0.2, 0], {'gain': lambda p: [[p['kp'], 2]], 'reference': [0, 0]}))
    late = lamp.simulate([0.2, 0], TIMES[:11], gain=[[r.values['kp'], 2]],
                         reference=[0, 0]).x[0, -1]
    close('a gain, by differences, and it is told: ' + r.derivatives, late, 0.05, 1e-7)
    holds('... by kp', 'differences of order 4 by kp' in r.derivatives)
    r = LAMP.optimize(('a', 2, (1, 9)), lambda p: (LAMP.optimize(
        ('b', 1, (0, 9)), lambda q: (q['b'] - p['a'])**2).values['b'] - 3)**2)
    close('a design within a design', r.values['a'], 3, 1e-4)
    r = LAMP.optimize(('d', 2, (0.1, 20)), lambda p, results: results['case1'].x[0, -1]**2,
                      None, RUN)
    q = LAMP.optimize(('d', 2, (0.1, 20)), ('end', 'q*q'), None, RUN)
    close('a function of results', r.values['d'], q.values['d'], 1e-4)


def met():
    """Demands that a first solver does not meet: 5/k < 0.05 from k = 100 on, 1/(1 + k^2)."""
    k = ('k', 40, (1, 500))
    for f, bound in ((lambda p: 5 / p['k'], 0.05), (lambda p: 1 / (1 + p['k']**2), 1e-4)):
        r = quiet(LAMP.optimize, k, None, (f, '<', bound))
        holds('a demand that can be met, by k = %g' % r.values['k'], (
            r.info == 0 and f(r.values) <= bound and r.starts[0]['solved']))
        r = quiet(LAMP.optimize, k, lambda p: p['k'], (f, '<', bound))
        close('... with nothing to spare', f(r.values) / bound, 1, 1e-6)

    def hills(p):
        return (1 / (1 + ((p['k'] - 5) / 2)**2) + 2 / (1 + ((p['k'] - 60) / 3)**2)
                + (p['c'] - 1)**2 / 100)
    free = [('k', 4, (0.1, 100)), ('c', 0.5, (0.1, 2))]
    r = quiet(LAMP.optimize, free, None, (hills, '>', 1.9))
    holds('a demand that is met behind a valley alone, by k = %g' % r.values['k'], (
        r.info == 0 and hills(r.values) >= 1.9))
    r = quiet(LAMP.optimize, free, None, [(hills, '>', 1.9), (lambda p: p['k'], '<', 20)])
    holds('two that are met, but not together', r.info == 2 and len(r.conflict) == 2)
    seen = []

    def goal(p):
        seen.append(p['a'])
        return p['a']
    LAMP.optimize(('a', 2, (0, 5)), goal, solver='ipopt')
    holds('no value beyond a bound is tried: %g' % min(seen), min(seen) == 0)
    r = LAMP.optimize(('a', 2, (1, math.inf)), lambda p: (p['a'] - 3)**2)
    holds('no infinite bound is active', r.active == [])


def events():
    """A ball thrown back at 0.1 m by e: 0.4 m at 1 s; the top by the end of a run: v/g."""
    m = sensitivity_bounce.Model()
    r = m.optimize(('e', 0.7, (0.5, 0.95)), ('value', 'e'), ('end', 'y', '=', 0.4),
                   ('run', [0, 0.5, 1], [1, 0], {'rtol': 1e-12}))
    fall = math.sqrt(2 * 0.9 / GRAVITY)
    e = (0.3 + GRAVITY / 2 * (1 - fall)**2) / ((1 - fall) * GRAVITY * fall)
    close('restitution for a height', r.values['e'], e, 1e-9)
    run = ('run', np.linspace(0, 1, 21), [1, 3])
    for goal in (('end', 'y', -1), ('integral', 'y_d', -1)):
        r = m.optimize(('last', 0.2, (0.1, 0.5)), goal, None, run)
        close('the top, by %s' % goal[0], r.values['last'], 3 / GRAVITY, 1e-9)
        holds('... exact, as many times as given', (
            r.derivatives == 'exact' and r.results['case1'].x.shape == (2, 21)
            and r.results['case1'].t[-1] == r.values['last']))
    early = (3 - math.sqrt(9 - 2 * GRAVITY * 0.4)) / GRAVITY
    r = m.optimize(('last', 0.2, (0.1, 0.5)), ('end', 'end_time'), ('end', 'y', '>', 1.4), run)
    close('the earliest end above 1.4 m', r.values['last'], early, 1e-8)


# ------------------------------------------------------------------------------- refusals

def refusals():
    still, k = ('positions', 'q', [-1, 0, 1]), ('k', 50, (1, 1000))
    for free, goal, demands, cases, options, said in (
            (('k', 50), ('peak', 'q'), None, still, {}, 'expected a row (name, start, (low,'),
            (('k', 50, (1, 2)), ('peak', 'q'), None, still, {}, 'a start from 1 to 2; found 50'),
            (('k', 50, (2, 1)), ('peak', 'q'), None, still, {}, 'expected bounds (low, high)'),
            ([k, k], ('peak', 'q'), None, still, {}, 'k is given twice'),
            (('kk', 50, (1, 99)), ('peak', 'q'), None, still, {}, 'nothing depends on kk'),
            (k, ('peek', 'q'), None, still, {}, "unknown word 'peek'; did you mean peak"),
            (k, ('peak', 'effort.w'), None, still, {}, "'effort.w'; did you mean effort.q"),
            (k, ('peak', 'q'), ('peak', 'q', '<=', 3), still, {}, 'relation: expected one of'),
            (k, ('peak', 'q'), None, ('ran', 1, 2), {}, "unknown kind 'ran'; did you mean run"),
            (k, ('peak', 'q'), None, ('loop', 1), {}, 'gsmbp_optimize of Octave alone'),
            (k, ('peak', 'q'), None, (*RUN, {'imput': 1}), {}, 'did you mean input'),
            (k, ('peak', 'q'), None, None, {}, 'needs a load case'),
            (k, ('each', 'q'), None, still, {}, 'each is a word of demands'),
            (k, ('peak', 'q'), ('value', 'k', '=', 9), still, {'solver': 'mma'},
             'mma takes no equations'),
            (k, ('peak', 'error.q'), None, still, {}, 'option target'),
            (('d', 2, (0.1, 20)), ('settling', 'q'), None, ('run', TIMES, [0, 1]), {},
             'settling q: its band is a share of the first value'),
            (k, None, ('settling', 'q', '<', 1), ('rest', [0, 0], [0]), {},
             'settling q < 1: expected a case of several times, found one'),
            (k, ('mass', 'arms'), None, None, {}, "unknown link 'arms'; did you mean arm"),
            (k, lambda p: 'a', None, None, {}, 'expected finite numbers'),
            (k, lambda p: [1, 2], None, None, {}, 'expected one number; found 2'),
            (k, ('peak', 'q'), None, still, {'solver': 'snopt'}, 'expected one of "auto", "slsqp"'),
            (('k', 50, (1, math.inf)), ('peak', 'q'), None, still, {'starts': 3},
             'expected finite bounds of k'),
            (k, ('end', 'q'), None, ('run', [1, 0], [0, 0], {'name': 'back'}), {}, 'case back')):
        refuses(said, ValueError, ['design_lamp.optimize: ', said], LAMP.optimize, free, goal,
                demands, cases, **options)
    refuses('an unknown keyword', TypeError, ['did you mean starts'], LAMP.optimize, k, start=3)
    refuses('an error of the function is raised as it is', KeyError, ['kp'], LAMP.optimize, k,
            lambda p: p['kp'])
    refuses('a contradiction', design_lamp.Error, ['this demand cannot be met: peak effort.q < -1'],
            LAMP.optimize, k, None, ('peak', 'effort.q', '<', -1), still)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter('always')
        r = LAMP.optimize(k, ('peak', 'effort.q'), None, still, evaluations=3)
    holds('a limit is told: ' + r.ended, r.limit and r.info == 1 and (
        'stopped at the limit of 3 evaluations' in str(told[-1].message)))


def ended_from_outside():
    def slow():
        time.sleep(0.02)
    rows = [('a', 0.5, (-5, 5)), ('b', 0.5, (-5, 5))]

    def goal(p):
        slow()
        return (1 - p['a'])**2 + 100 * (p['b'] - p['a']**2)**2
    counted = []
    threading.Thread(target=lambda: [(counted.append(1), time.sleep(0.01)) for _ in range(20)]
                     ).start()
    begin = time.time()
    r = quiet(LAMP.optimize, rows, goal, timeout=0.5)
    holds('timeout: %s after %.2f s' % (r.ended, time.time() - begin), (
        r.stopped == 'timeout' and r.ended == 'ended by option timeout' and r.info == 1
        and r.J <= goal({'a': 0.5, 'b': 0.5})))
    holds('other threads run meanwhile', len(counted) > 10)
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    try:
        quiet(LAMP.optimize, rows, goal)
        holds('Ctrl-C is an exception', False)
    except KeyboardInterrupt:
        holds('Ctrl-C is an exception', True)


def signatures():
    names = list(inspect.signature(design_lamp.Model.optimize).parameters)[1:]
    holds('the signature', names[:4] == ['free', 'goal', 'demands', 'cases'] and 'nodes' in names)
    stub = open(os.path.join(os.path.dirname(design_lamp.__file__), '__init__.pyi'),
                encoding='utf-8').read()
    part = stub[stub.index('def optimize('):stub.index('-> Optimum')]
    holds('the stub has all options', all(' %s: ' % name in part or '(self, %s: ' % name in part
                                          for name in names))
    holds('the docstring has all options', all(
        name in design_lamp.Model.optimize.__doc__ for name in names))


if __name__ == '__main__':
    with open(sys.argv[1], encoding='utf-8') as file:
        FOUND = json.load(file)
    beside_octave(FOUND['designs'])
    sensitivity_beside_octave(FOUND['sensitivity'])
    slopes()
    whirl()
    balance()
    least_effort()
    motions()
    four_bar()
    branches()
    functions()
    met()
    events()
    refusals()
    ended_from_outside()
    signatures()
