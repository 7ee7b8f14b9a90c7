"""Runs of modules that carry derivatives, and the adjoint: a pendulum against reference values of
28 digits, a closed chain and a digital controller against differences of whole runs, events against
closed forms, the adjoint beside the columns; refusals; threads.

python3 derivatives.py REFERENCE: the modules that it imports must be installed."""
import inspect
import json
import sys
import threading
import warnings

import numpy as np

import case_d1a
import sensitivity_ball
import sensitivity_bounce
import sensitivity_crank
import sensitivity_sampled
from checks import close, holds, refuses


def pendulum(reference):
    m = case_d1a.Model()
    names = reference['parameters']
    r = m.simulate([1.2, -0.5], [0, 0.5, 1, 2], sensitivity=names, rtol=1e-12)
    for i, at in enumerate(reference['at'], 1):
        wanted = np.array([[float(a) for a in row] for row in at['dxdp']])
        found = np.array([r.dx[name][:, i] for name in names]).T
        close('pendulum at t = %g s: dx/dp, relative to the largest' % r.t[i],
              found / abs(wanted).max(), wanted / abs(wanted).max(), 1e-11)
    step = 1e-4
    for name in names:
        two = [m.changed(**{name: m.parameters[name] + s * step}).simulate(
            [1.2, -0.5], [0, 2], rtol=1e-13).y[:, -1] for s in (-2, -1, 1, 2)]
        wanted = (two[0] - 8 * two[1] + 8 * two[2] - two[3]) / (12 * step)
        close('pendulum: dy/d%s beside differences' % name, r.dy[name][:, -1], wanted,
              1e-7 * (1 + abs(wanted).max()))
    s = m.simulate([1.2, -0.5], [0, 1, 2], sensitivity='theta', rtol=1e-12)
    ends = [m.simulate([1.2 + h, -0.5], [0, 2], rtol=1e-13).x[:, -1] for h in (-step, step)]
    close('pendulum: by the start of the angle', s.dx['theta'][:, -1],
          (ends[1] - ends[0]) / (2 * step), 1e-7)
    for method in ('radau', 'auto', 'rk4', 'gauss'):
        q = m.simulate([1.2, -0.5], [0, 2], sensitivity=['l', 'g'], method=method, step=1e-3)
        close('pendulum: by %s' % method, q.dx['l'][:, -1], r.dx['l'][:, -1], 1e-7)
    return r


def chain():
    """A slider-crank with a motor: the crank keeps its angle at the start."""
    m = sensitivity_crank.Model()
    names = ['g', 'l1', 'l2', 'm1', 'rho', 'n', 'la', 'km']
    x0 = [0.5, -0.7, 0.66, 0, 0, 0, *m.initial[6:]]
    arguments = dict(input=12.0, rtol=1e-12, start='project')
    r = m.simulate(x0, [0, 0.1, 0.3], sensitivity=names, **arguments)
    constraints = [np.abs(m.tan(0.0, r.x[:, 0]).dp @ r.dx[name][:3, 0] + m.cop(
        0.0, r.x[:, 0]).pp[:, names.index(name)]).max() for name in names]
    close('slider-crank: the start keeps its constraints by all parameters', constraints, 0, 1e-13)
    close('... and its crank its angle', [r.dx[name][0, 0] for name in names], 0, 0)
    holds('... while the slider follows its length', r.dx['l1'][2, 0] > 0.5)
    for name in ('l1', 'rho', 'la'):
        step = 1e-4 * m.parameters[name]
        ends = []
        for s in (-2, -1, 1, 2):
            x = r.x[:, 0] + s * step * r.dx[name][:, 0]
            ends.append(m.changed(**{name: m.parameters[name] + s * step}).simulate(
                x, [0, 0.3], **arguments).x[:, -1])
        wanted = (ends[0] - 8 * ends[1] + 8 * ends[2] - ends[3]) / (12 * step)
        close('slider-crank: dx/d%s beside differences' % name, r.dx[name][:, -1], wanted,
              3e-6 * abs(wanted).max())
    refuses('too many coordinates that are fixed', ValueError,
            ['fixed: expected 1 of the coordinates', 'q1, q3'],
            m.simulate, x0, [0, 0.1], sensitivity='l1', fixed=['q1', 'q3'], **arguments)
    refuses('the way partitioning with derivatives', ValueError, ['projection', 'baumgarte'],
            m.simulate, x0, [0, 0.1], sensitivity='l1', loops='partitioning', **arguments)


def controller():
    m = sensitivity_sampled.Model()
    names = ['J', 'kp', 'ki']
    x0, times = [0, 0.3], [0, 0.25, 0.75]
    r = m.simulate(x0, times, sensitivity=names, input=[2.0], rtol=1e-12)
    for name in names:
        step = 1e-4 * m.parameters[name]
        ends = [m.changed(**{name: m.parameters[name] + s * step}).simulate(
            x0, times, input=[2.0], rtol=1e-12) for s in (-2, -1, 1, 2)]
        for what, found in (('x', r.dx), ('v', r.dv), ('y', r.dy)):
            a = [getattr(e, what)[:, -1] for e in ends]
            wanted = (a[0] - 8 * a[1] + 8 * a[2] - a[3]) / (12 * step)
            close('controller: d%s/d%s beside differences' % (what, name), found[name][:, -1],
                  wanted, 1e-7 * (1 + abs(wanted).max()))
    refuses('a parameter that moves samples', ValueError, ['period', 'instants'], m.simulate, x0,
            times, sensitivity='period')
    refuses('the adjoint through samples', ValueError, ['samples', '(C)'], m.adjoint, x0, times,
            lambda r: (0, r.x))


def backwards():
    m = case_d1a.Model()
    x0, times = [1.2, -0.5], [0, 0.5, 1, 2]

    def goal(r):
        return (np.array([r.x[0, -1], (r.x ** 2).sum(), r.y[0].sum()]),
                np.stack([np.eye(2, 4, 3)[:, :] * [[1], [0]], 2 * r.x, 0 * r.x], axis=2),
                np.stack([0 * r.y, 0 * r.y, np.outer(np.eye(len(r.y))[0], np.ones(4))], axis=2))

    a = m.adjoint(x0, times, goal, rtol=1e-13)
    names = [*a.dJ, 'theta', 'theta_d']
    r = m.simulate(x0, times, sensitivity=names, rtol=1e-13)
    for name in names:
        wanted = np.array([r.dx[name][0, -1], 2 * (r.x * r.dx[name]).sum(), r.dy[name][0].sum()])
        found = a.dJ[name] if name in a.dJ else a.dx0[m.states.index(name)]
        close('pendulum, backwards: by %s as the columns' % name, found, wanted,
              1e-8 * (1 + abs(wanted).max()))
    close('... and the run is the same', a.run.x, r.x, 1e-10)
    one = m.adjoint(x0, times, lambda r: (r.x[1, -1], np.eye(2, 4, 2) * [[0], [1]]), rtol=1e-13)
    close('one goal alone', one.dJ['g'], r.dx['g'][1, -1], 1e-8)
    c = sensitivity_crank.Model()
    x0, times = c.simulate(c.initial, [0, 1e-9], start='project').x[:, 0], [0, 0.1]
    last = np.zeros((c.sizes['nx'], 2))
    last[0, 1] = 1
    a = c.adjoint(x0, times, lambda r: (r.x[0, -1], last), input=12.0, rtol=1e-12)
    r = c.simulate(x0, times, input=12.0, rtol=1e-12, sensitivity=list(a.dJ), loops='baumgarte')
    for name in a.dJ:
        wanted = r.dx[name][0, -1]
        close('slider-crank, backwards: by %s as the columns' % name, a.dJ[name], wanted,
              1e-7 * (1 + abs(wanted)))
    refuses('a goal of another shape', ValueError, ['goal', 'Jx', '2 x 4 x 1'], m.adjoint,
            [1.2, -0.5], [0, 0.5, 1, 2], lambda r: (0.0, np.zeros((2, 3))))


def refusals():
    m = case_d1a.Model()
    x0, times = [1.2, -0.5], [0, 1]
    refuses('an unknown name', ValueError, ['m, l, I, g, d, k', 'found mass'], m.simulate, x0,
            times, sensitivity=['mass'])
    refuses('a name twice', ValueError, ['l is given twice'], m.simulate, x0, times,
            sensitivity=['l', 'l'])
    refuses('dx0 of another shape', ValueError, ['dx0', '2 x 1'], m.simulate, x0, times,
            sensitivity='l', dx0=[0.0])
    refuses('dx0 alone', ValueError, ['dx0 needs sensitivity'], m.simulate, x0, times,
            dx0=[[0.0], [0.0]])
    refuses('an audit beside', ValueError, ['audit'], m.simulate, x0, times, sensitivity='l',
            audit=1.0)
    for word in ('sensitivity', 'fixed', 'dx0'):
        holds('simulate has the argument %s' % word,
              word in inspect.signature(case_d1a.Model.simulate).parameters)
    holds('adjoint has a text', 'goal:' in case_d1a.Model.adjoint.__doc__)


def ball(name, m, x0, event):
    """It falls from rest at 1 m above lo, at 0.9 s it is on its way up."""
    g, e, t = 9.81, 0.8, 0.9
    t1 = np.sqrt(2 / g)
    s = t - t1
    by_t1 = e * g * s - e * g * t1 + g * s
    r = m.simulate(x0, [0, 0.3, t], sensitivity=['g', 'lo', 'e'], rtol=1e-12)
    wanted = {'g': e * t1 * s - s ** 2 / 2 - by_t1 * t1 / (2 * g), 'lo': 1 - by_t1 / (g * t1),
              'e': g * t1 * s}
    times = {'g': -t1 / (2 * g), 'lo': -1 / (g * t1), 'e': 0}
    first = [EVENT['name'] for EVENT in sensitivity_of(m)['events']].index(event)
    k = list(r.events['number']).index(first)
    for p in wanted:
        close('%s: its height by %s' % (name, p), r.dx[p][0, -1], wanted[p], 1e-9)
        close('%s: its impact by %s' % (name, p), r.events['dt'][p][k], times[p], 1e-9)
    holds('%s: nothing is lost' % name, r.stats['lost'] == [])


def sensitivity_of(m):
    return sys.modules[type(m).__module__].table


def through_events():
    ball('a ball on a stop', sensitivity_ball.Model(), [1.1, 0, 0, 0], 'floor')
    ball('a ball that an event throws back', sensitivity_bounce.Model(), [1.1, 0], 'hit')
    m = sensitivity_ball.Model(g=-9.81, lo=-2)
    for off in (0, 1e-9, -1e-11):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter('always')
            r = m.simulate([0, 0, -np.sqrt(4 * 9.81) * (1 + off), 0], [0, 0.2, 1],
                           sensitivity=['g', 'e'])
        holds('grazing the floor within %g: told by name, no numbers from there on' % off,
              np.isnan(r.dx['g'][:, 2]).all() and np.isfinite(r.dx['g'][:, 1]).all()
              and abs(r.stats['lost'][0]['time'] - np.sqrt(4 / 9.81)) < 1e-3
              and any('no derivatives by g' in str(w.message) and 'event of floor' in str(w.message)
                      and 'only grazes' in str(w.message) for w in told))
    r = m.simulate([0, 0, -np.sqrt(4 * 9.81) * (1 - 1e-6), 0], [0, 1], sensitivity='g')
    close('passing above the floor is none', r.dx['g'][:, 1], [-0.5, 0, -1, 0], 1e-12)
    m = sensitivity_ball.Model()
    refuses('a start on a stop that moves with a parameter', ValueError,
            ['starts on the stop floor'], m.simulate, [0.1, 0, 0, 0], [0, 1], sensitivity='lo')
    r = m.simulate([0.1, 0, 0, 0], [0, 1], sensitivity='lo', dx0=[[1], [0], [0], [0]])
    close('... and where the start moves with it', r.dx['lo'][:, 1], [1, 0, 0, 0], 1e-12)
    refuses('the adjoint through events', (ValueError, AttributeError), ['sensitivity_ball'],
            m.adjoint, [1.1, 0, 0, 0], [0, 1], lambda r: (0, r.x))


def at_once(alone):
    """Runs of several threads find what one alone finds."""
    found = [None] * 4

    def run(k):
        found[k] = case_d1a.Model(g=9.81 + k % 2).simulate(
            [1.2, -0.5], [0, 0.5, 1, 2], sensitivity=list(alone.dx), rtol=1e-12)
    threads = [threading.Thread(target=run, args=(k,)) for k in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    holds('four runs at once, to the bit', all(
        (found[k].dx[name] == found[k + 2].dx[name]).all() for k in (0, 1) for name in alone.dx)
        and all((found[0].dx[name] == alone.dx[name]).all() for name in alone.dx)
        and (found[1].dx['l'] != alone.dx['l']).any())


with open(sys.argv[1], encoding='utf-8') as file:
    carried = pendulum(json.load(file))
chain()
controller()
backwards()
through_events()
refusals()
at_once(carried)
