"""What a module does beside calling subroutines: runs, plans, parameters, refusals.

python3 runs.py: the modules that it imports must be installed."""
import ast
import copy
import inspect
import math
import multiprocessing
import os
import pickle
import re
import signal
import sys
import threading
import time
import warnings

import numpy as np

import event_ball
import own_events
import puma6
import robot_joint
import sampled_crank
import slider_crank
import spinning_top
import switch_circuit
from checks import close, holds, refuses


def ball():
    m = event_ball.Model()
    g = 9.81
    for method in ('dp853', 'rk4'):
        r = m.simulate([1, 0, 0, 3], np.arange(0, 6.1, 0.25), method=method, step=1e-2)
        on = r.events['number'] == 0
        n = np.arange(on.sum())
        first = math.sqrt(2 / g)
        close('ball, %s: times of the impacts [s]' % method, r.events['t'][on],
              first * (1 + 2 * 0.8 * (1 - 0.8 ** n) / 0.2), 1e-11)
        close('ball, %s: loses 1 - e^2 of its energy [J]' % method, r.events['loss'][on][:-1],
              0.36 * 2 * g * 0.64 ** n[:-1], 1e-12)
        holds('ball, %s: impacts until it rests' % method,
              on.sum() == math.ceil(math.log(1e-4 / math.sqrt(2 * g)) / math.log(0.8)))
        close('ball, %s: rests' % method, [r.x[0, -1], r.x[2, -1], r.v[0, -1] + 1], 0, 1e-12)
        holds('ball, %s: the device has its name' % method, r.events['device'][0] == 'ground_stop')
    r = m.simulate([1, 0, 0, 3], [0, 0.1], audit=20.0)
    holds('ball: its energy balance, %.1e' % r.audit['error'], r.audit['error'] < 1e-12)
    r = event_ball.Model(g=0).simulate([0.5, 0, 0, 0], [0, 0.1], audit=20.0)
    holds('no energy, no balance of it', math.isnan(r.audit['error']))
    refuses('a start beyond a stop', ValueError, ['stop'], m.simulate, [-1, 0, 0, 3], [0, 1])
    refuses('... with its ends and the place', ValueError, ['expected 0 to', 'found -1'],
            m.simulate, [-1, 0, 0, 3], [0, 1])
    refuses('... with start="project", too', ValueError, ['beyond an end of the stop'],
            m.simulate, [-1, 0, 0, 3], [0, 1], start='project')
    for name in ('cst', '_parameters', 'k'):
        refuses('a value for %s' % name, AttributeError, ['does not change'], setattr, m, name, 0)
    refuses('a linear model where there are events', AttributeError, ['JAC: the scene has events'],
            m.linearize, 0, [1, 0, 0, 3])
    for modes in ([2, 0], [0.5, 0], [0]):
        refuses('modes %s' % modes, ValueError, ['-1, 0 or 1', 'found [%g' % modes[0]], m.simulate,
                [1, 0, 0, 0], [0, 1], modes=modes)
    refuses('a mode among the inputs', ValueError, ['walls is no input', 'found 1'], m.simulate,
            [1, 0, 0, 0], [0, 1], input=[0, 1])
    for x0, modes, words in (
            ([1, 0, 0, 0], [-1, 0], ['expected 0 of ground_stop, which is at 1', 'found -1']),
            ([0, 2, 0, 1], [-1, 1], ['expected 0 of walls, which moves at 1', 'found 1'])):
        refuses('modes %s of %s' % (modes, x0), ValueError, words, m.simulate, x0, [0, 1],
                modes=modes)
    r = m.simulate([1, 0, 0, 3], [0, 5, 6])
    again = m.simulate(r.x[:, 1], [5, 6], modes=r.v[:2, 1].astype(int))
    close('a run goes on with the modes of another', again.x[:, -1], r.x[:, -1], 1e-9)
    x = np.array([1.0, 0, 0, 3])
    for what, v in (('one state', [0.5, 0]), ('many', [[0, 0, 0.5], [0, 0, 0]])):
        refuses('a mode of 0.5 among the inputs of %s' % what, ValueError,
                ['rhs: argument v: ground_stop.mode: expected -1, 0 or 1; found 0.5'], m.rhs, 0, x,
                v)
    refuses('a mode that is left out', TypeError, ['argument v is missing', 'ground_stop.mode'],
            m.rhs, 0, x)
    refuses('a mode that is no number', event_ball.Error, ['INFO = -3'], m.rhs, 0, x, [math.nan, 0])
    close('modes of many states', m.rhs(0, x, [[0, 1], [0, 0]])[2], [-9.81, 0], 1e-12)
    refuses('a mode of 2 of a subroutine', ValueError, ['argument mode', 'from -1 to 1; found 2'],
            m.evt, 0, x, [2, 0])
    refuses('... of 0.5', TypeError, ['argument mode', 'whole'], m.evt, 0, x, [0.5, 0])
    refuses('an event of no number', event_ball.Error, ['INFO = -5'], m.rst, 0, x, [0, 0], [0, 0],
            3)
    refuses('... of one beyond all integers', ValueError, ['argument k'], m.rst, 0, x, [0, 0],
            [0, 0], 2**32)


def own():
    """Events of the user: bounces, tops and the end in closed form, a cart between two speeds."""
    close('a start by a parameter', own_events.Model(h=2.0).initial, [2, 0, 0, 0], 0)
    m, g, e = own_events.Model(), 9.81, 0.8
    hits = [math.sqrt(2 / g)]
    speed, tops = g * hits[0], []
    while hits[-1] < 3:
        speed *= e
        tops.append(hits[-1] + speed / g)
        hits.append(hits[-1] + 2 * speed / g)
    cold = math.log(1.5) + math.log(4) * np.arange(2)
    wanted = {'hit': hits[:-1], 'top': [t for t in tops if t < 3], 'cold': cold, 'done': [3.0],
              'hot': (cold + math.log(2))[:2]}
    for method in ('dp853', 'rk4'):
        r = m.simulate([1, 0, 0, 1.5], [0, 1, 3], method=method, step=5e-3)
        holds('own events, %s: a stop at the last time' % method, r.stats['stopped'] == 'event done'
              and r.t[-1] == 3 and len(r.t) == 3 and r.events['device'][-1] == 'done')
    for method in ('dp853', 'rk4'):
        r = m.simulate([1, 0, 0, 1.5], np.arange(0, 5.1, 0.5), method=method, step=5e-3, rtol=1e-12)
        names = np.array(r.events['device'])
        for name, times in wanted.items():
            found = r.events['t'][names == name]
            holds('%s: %s happens %d times' % (method, name, len(times)), len(found) == len(times))
            close('%s: when %s happens [s]' % (method, name), found, times,
                  1e-12 if method == 'dp853' or name in ('hit', 'top', 'done') else 1e-10)
        holds('%s: what ended it is told' % method, r.stats['stopped'] == 'event done')
        close('%s: the last row is the end [s]' % method, r.t[-1], 3, 1e-12)
        hit = names == 'hit'
        close('%s: speeds behind the bounces [m/s]' % method, r.events['after'][2, hit],
              -e * r.events['before'][2, hit], 1e-15)
        close('%s: the force is held [N]' % method, r.v[0, 1:-1],
              3 * ((r.t[1:-1] - cold[0]) % math.log(4) < math.log(2)), 0)
        close('%s: the middle, both ways' % method, r.events['before'][3, names == 'middle'], 1.5,
              1e-10)
    m = m.changed(e=0.5, last=10.0)
    refuses('bounces that accumulate, with their event', own_events.Error,
            ['an event, ', 'failed', '1.3545709'], m.simulate, [1, 0, 0, 1.5], [0, 5])
    refuses('an unknown value of a speed behind a bounce', own_events.Error, ['INFO = -2'], m.rst,
            0, [1, 0, math.nan, 0], [0], np.zeros(7, np.intc), 1)


def rows():
    """A thousand rows cost at most twice the calls of two, and are those of a finer run."""
    for module in (slider_crank, spinning_top, robot_joint):
        m, t = module.Model(), np.linspace(0, 1, 1000)
        two = m.simulate(m.initial, [0, 1], rtol=1e-6)
        many = m.simulate(m.initial, t, rtol=1e-6)
        fine = m.simulate(m.initial, t, rtol=1e-11)
        calls = many.stats['calls'], two.stats['calls']
        holds('%s: 1000 rows, %d calls; 2 rows, %d' % (module.__name__, *calls),
              two.stats['accepted'] < 500 and calls[0] <= 2 * calls[1])
        scale = np.abs(fine.x).max(axis=1, keepdims=True) + np.array(m.nominal)[:, None]
        close('%s: all its rows' % module.__name__, many.x / scale, fine.x / scale, 1e-5)


def crank():
    m = slider_crank.Model()
    ends = []
    for way in ('baumgarte', 'projection', 'partitioning', 'nullspace', 'svd', 'kane'):
        r = m.simulate(m.initial, [0, 0.25, 0.5], input=12, loops=way, rtol=1e-11)
        ends.append(r.x[:, -1])
    close('crank: six ways of the loops', ends, ends[1], 1e-9)
    r = m.simulate(m.initial, [0, 0.5], input=12)
    table = slider_crank.table_of([0, 0.25, 1], [12, 12, 12])
    held = slider_crank.table_of([0, 0.25, 1], [12, 12, 12], 0)
    close('crank: a table', m.simulate(m.initial, [0, 0.5], input=table).x[:, -1], r.x[:, -1], 1e-7)
    close('crank: held values', m.simulate(m.initial, [0, 0.5], input=held).x[:, -1], r.x[:, -1],
          1e-7)
    close('crank: a function', m.simulate(m.initial, [0, 0.5], input=lambda t, x: 12).x[:, -1],
          r.x[:, -1], 1e-12)
    jump = [slider_crank.table_of([0, 0.13, 0.25], [12, -3, -3], 0),
            lambda t, x: 12 - 15 * (t > 0.13), lambda t, x: 12 - 15 * (t >= 0.13)]
    jump = [m.simulate(m.initial, [0, 0.13, 0.25], input=f, breaks=[0.13], method='rk4', step=1e-3)
            for f in jump]
    close('crank: functions that jump, as a table', [r.x for r in jump], jump[0].x, 1e-12)
    close('crank: ... from the left', [r.v for r in jump], jump[0].v, 0)
    move = slider_crank.plan('septic', [0, math.pi], [0, 1])
    i = m.inverse(move, np.linspace(0, 1, 9))
    p = m.simulate(i.x[:, 0], np.linspace(0, 1, 9), motion=move, rtol=1e-11)
    close('crank: a planned motion comes back', p.x[0], move(p.t)[0], 1e-8)
    close('crank: ... with the inputs of the inverse model', p.v[:, 1:], i.v[:, 1:], 1e-6)
    close('crank: ... and its states', p.x, i.x, 1e-7)
    gain, about = np.array([[5, 0, 0, 0.5, 0, 0, 0]]), m.initial
    free = m.simulate(i.x[:, 4], [0, 0.2], gain=gain, reference=about, input=3)
    own = m.simulate(i.x[:, 4], [0, 0.2], input=lambda t, x: 3 - gain @ (x - about))
    close('crank: state feedback', free.x[:, -1], own.x[:, -1], 1e-8)
    stop = m.simulate(i.x[:, 4], [0, 0.2], gain=gain, reference=about, input=3, limits=1.0)
    holds('crank: limits', np.abs(stop.v).max() == 1.0)
    apart = m.simulate(i.x[:, 4], [0, 0.2], gain=gain, reference=about, input=3,
                       limits=[[-0.5, 0.25]] * m.sizes['nv'])
    holds('crank: other limits', (apart.v == -0.5).all())
    for what, given in (('atol', [1.0, 2.0]), ('atol', -1.0), ('atol', 'small'),
                        ('limits', [1.0, 2.0, 3.0, 4.0, 5.0]), ('limits', 'wide')):
        refuses('%s %r' % (what, given), ValueError, ['simulate: %s: expected' % what], m.simulate,
                m.initial, [0, 1], gain=gain, reference=about, **{what: given})
    refuses('crank: a start beside the loop', ValueError, ['constraints', 'project'], m.simulate,
            m.initial + 0.1, [0, 1])
    moved = m.simulate(m.initial + 0.01, [0, 1e-3], start='project')
    con = m.con(0, moved.x[:3, 0], moved.x[3:6, 0])
    close('crank: a start that is moved', con.phi, 0, 1e-12)
    refuses('a function that gives a text', ValueError, ['input at t = 0 s', "found 'on'"],
            m.simulate, m.initial, [0, 1], input=lambda t, x: 'on')
    refuses('a parameter as an attribute', AttributeError, ["expected m.parameters['"], getattr, m,
            list(m.parameters)[0])
    refuses('a failing function', ZeroDivisionError, [], m.simulate, m.initial, [0, 1],
            input=lambda t, x: 1 / 0)
    refuses('an input that is not finite', ValueError, ['finite'], m.simulate, m.initial, [0, 1],
            input=lambda t, x: math.nan)
    refuses('too few steps', slider_crank.Error, ['maxsteps', 't = '], m.simulate, m.initial,
            [0, 1], maxsteps=3)
    r = m.simulate(m.initial, [0, 0.01, 1], maxsteps=3, errors='return')
    holds('... or returned', 'maxsteps' in r.stats['failure'] and r.x.shape[1] < 3)


def sampled():
    m = sampled_crank.Model()
    x = m.simulate(m.initial, [0, 1e-6], start='project').x[:, 0]
    r = m.simulate(x, np.linspace(0, 0.1, 6))
    holds('sampled: 101 instants of two devices and more', r.samples['count'] >= 100)
    close('sampled: every millisecond', np.diff(np.unique(np.round(r.samples['t'], 9)))[:50], 1e-3,
          1e-12)
    on = m.simulate(r.x[:, 2], [0.04, 0.1], memory=None)
    v = r.v[:, 2]
    for what, given in (('constants', v), ('a table', sampled_crank.table_of(
            [0, 1], [[c, c] for c in v], 0)), ('a function', lambda t, x: v)):
        told = m.simulate(r.x[:, 2], [0.0405, 0.0407], input=given)
        close('sampled: what is held between samples is told by %s' % what, told.v[:, 0], v, 1e-15)
    holds('sampled: inputs are held outputs', np.isfinite(on.v).all() and on.v.shape[0] == 8)
    for k in (-1, m.sizes['nctl'] + 1):
        refuses('device %d' % k, ValueError, ['ctl: argument k: expected whole numbers from 0 to'],
                m.ctl, k, 0, m.out(0, x), np.zeros(m.sizes['nxk']), np.zeros(m.sizes['nv']))
    steps = r.samples['v'][0] / (2 * math.pi / 4096)
    close('sampled: the encoder counts whole steps', steps, np.round(steps), 1e-9)
    holds('... and it turned', np.abs(steps).max() > 3)
    refuses('memory of another size', ValueError, ['memory'], m.simulate, x, [0, 1], memory=[1])


def switched():
    """A row at a time at which the scene switches is from before, but for the first one."""
    m = switch_circuit.Model()
    t = np.array([0, 0.05, 0.1, 0.2, 0.3])
    jump = switch_circuit.table_of([0, 0.1], [1, 2], 0)
    for method in ('dp853', 'rk4'):
        r = m.simulate([3, 0], t, input=jump, method=method)
        close('outputs of a row at a switch by %s' % method, r.y[0], np.where(t <= 0.1, r.x[0], 1),
              0)
        close('... and inputs', r.v[0, 2], 1, 0)
    close('the first row is from behind', m.simulate([3, 0], [0.1, 0.2]).y[0], 1, 0)


def others():
    m = puma6.Model()
    q, u, ud = np.random.default_rng(1).standard_normal((3, 6))
    tau = m.inv(0, q, u, ud)
    close('puma: M*ud + B is the inverse model', m.mas(0, q) @ ud + m.bia(0, q, u), tau, 1e-12)
    close('puma: forward is its inverse', m.fwd(0, q, u, tau=tau), ud, 1e-12)
    x = np.concatenate([q, u])
    a = m.linearize(0, x).a
    h = 1e-6
    central = np.stack([(m.rhs(0, x + h * e) - m.rhs(0, x - h * e)) / (2 * h)
                        for e in np.eye(12)], 1)
    close('puma: the linear model is the derivative', a / np.abs(a).max(),
          central / np.abs(a).max(), 1e-8)
    kept = m.kept('inv')
    kept.q[:], kept.u[:], kept.ud[:] = q, u, ud
    holds('puma: kept arrays', kept() == 0 and np.array_equal(kept.tau, tau))
    beyond = m.inverse(puma6.plan('quintic', np.outer(q, [0, 1]), [0, 1]), [-1, 2])
    close('puma: beyond its ends a motion rests there', beyond.q, np.outer(q, [0, 1]), 1e-14)
    close('puma: ... at rest', [beyond.u, beyond.ud], 0, 0)
    joint = robot_joint.Model()
    move = robot_joint.plan('septic', [0, 1], [0, 1])
    i = joint.inverse(move, np.linspace(0, 1, 5))
    holds('robot joint: internal states along a motion', np.isfinite(i.x).all())
    r = joint.simulate(i.x[:, 0], np.linspace(0, 1, 5), motion=move, rtol=1e-11)
    close('robot joint: the motion comes back', r.x, i.x, 1e-5 * max(1, np.abs(i.x).max()))
    top = spinning_top.Model()
    x = top.initial.copy()
    x[-3:] = [0.1, 0.2, 5]
    r = top.simulate(x, [0, 0.5], audit=1.0, start='project')
    holds('top: energy', r.audit['error'] < 1e-8)
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        for start in ('check', 'project'):
            refuses('top: no orientation, %s' % start, ValueError, [
                'expected Euler parameters of length 1, found (e0, e1, e2, e3) = [0 0 0 0], which '
                'is no orientation'], top.simulate, np.zeros(7), [0, 1], start=start)


def options():
    """Options, their defaults and the stub are those of the table of all hosts, statistics those of
    the stub."""
    from slider_crank import _tables
    simulate = inspect.signature(slider_crank.Model.simulate).parameters
    own = {name: p.default for name, p in simulate.items()
           if p.kind == p.KEYWORD_ONLY and name not in ('errors', 'breaks')}
    wanted = {name: getattr(_tables.DEFAULT, name) for name in own if name in _tables.KIND}
    holds('options of simulate: %s' % ', '.join(own), len(own) > 15 and own == wanted)
    with open(slider_crank.__file__ + 'i', encoding='utf-8') as stub:
        text = re.search(r'def simulate\((.*?)\) ->', stub.read(), re.S).group(1)
    holds('... those of the stub', set(re.findall(r'(\w+):', text)) | {'self'} == set(simulate))
    with open(slider_crank.__file__ + 'i', encoding='utf-8') as stub:
        classes = {one.name: one.body for one in ast.parse(stub.read()).body
                   if isinstance(one, ast.ClassDef)}
    stubbed, = (one.args for one in classes['Model'] if getattr(one, 'name', '') == 'simulate')
    holds('... with its defaults', all(
        ast.literal_eval(default) == simulate[one.arg].default
        for one, default in zip(stubbed.kwonlyargs, stubbed.kw_defaults)))
    words = {one.arg: [word.value for word in ast.walk(one.annotation)
                       if isinstance(word, ast.Constant)] for one in stubbed.kwonlyargs}
    holds('... and the words of methods and loops',
          words['method'] == list(_tables.METHODS) and words['loops'] == list(_tables.WAYS))
    m = slider_crank.Model()
    stats = m.simulate(m.initial, [0, 0.01]).stats
    typed = {one.target.id: one.annotation.id for one in classes['Statistics']
             if isinstance(one.annotation, ast.Name)}
    holds('statistics: those of the stub', stats.keys() == {
        one.target.id for one in classes['Statistics']} and all(
            type(stats[name]).__name__ == kind for name, kind in typed.items() if kind != 'Real'))


def parameters():
    m = slider_crank.Model(l1=0.1)
    holds('parameters by name', m.parameters['l1'] == 0.1
          and slider_crank.Model().parameters['l1'] == 0.2)
    close('... reach the equations', m.mas(0, [0.1, 0.2, 0.3])[2, 2], 1.0, 1e-15)
    holds('... of another model', m.changed(m2=3).parameters['l1'] == 0.1)
    refuses('an unknown parameter', KeyError, ['unknown', 'm1'], slider_crank.Model, m_1=3)
    refuses('a negative mass', ValueError, ['must not be negative', 'm1 = -1'], slider_crank.Model,
            m1=-1)
    refuses('a mass that is no number', ValueError, ['m1', 'finite'], slider_crank.Model,
            m1=math.inf)
    refuses('a parameter in another case', KeyError, ['did you mean m1?'], slider_crank.Model, M1=3)
    refuses('a parameter unlike all', KeyError, ['known: ', 'm1'], slider_crank.Model,
            stiffness=3)
    refuses('a value put into a model', AttributeError, ['does not change', 'changed(l1='],
            setattr, m, 'l1', 3)
    refuses('a state that is none', TypeError, ['argument x', 'found None'], m.rhs, 0, None)
    plain = slider_crank.Model()
    for times in ([0, math.nan], [0, math.inf], [1, 0], [[0, 1]], ['0', '1'], None):
        refuses('times %r' % times, ValueError, ['the times must be'], plain.simulate,
                plain.initial, times)
    for given in (0, 1, 1.5, -1e-6, math.nan, 'small'):
        refuses('rtol %r' % given, ValueError, ['simulate: rtol: expected a number above 0 and '
                'below 1; found'], plain.simulate, plain.initial, [0, 1], rtol=given)
    for given, words in (({'rtol': 1e-20}, 'rtol = 1e-20 is below'),
                         ({'atol': 0}, 'atol = 0 of q1 is below')):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter('always')
            r = plain.simulate(plain.initial, [0, 1e-3], **given)
        holds('%s is raised, with a warning' % given, len(told) == 1 and words in str(
            told[0].message) and told[0].category is slider_crank.RunWarning
              and told[0].filename == __file__)
    least = 10 * np.finfo(float).eps
    holds('the tolerances that were kept', (r.stats['atol'] == least * plain.nominal).all()
          and r.stats['rtol'] == 1e-10)
    for what, given in (('input', {'v': 1}), ('breaks', 'late'),
                        ('maxsteps', 0.5), ('maxsteps', 2**31), ('audit', -1.0), ('errors', 'no')):
        refuses('%s %r' % (what, given), ValueError, ['simulate: %s: expected' % what],
                plain.simulate, plain.initial, [0, 1], **{what: given})
    refuses('a state of another shape', ValueError, ['argument x', '(7)', '(2,)'], m.rhs, 0, [1, 2])
    for t in (math.nan, [0, math.inf, 0]):
        refuses('a time of %s' % t, ValueError, ['argument t', 'finite times'], m.rhs, t, m.initial)
    refuses('complex numbers', TypeError, ['argument x'], m.rhs, 0, [1j] * 7)
    refuses('text', TypeError, ['argument x'], m.rhs, 0, ['a'] * 7)
    words = [('simulate(mehtod=)', ['argument mehtod is unknown', 'did you mean method?'],
              lambda: m.simulate(m.initial, [0, 1], mehtod='rk4')),
             ('simulate(inputs=)', ['argument inputs is unknown', 'did you mean input?'],
              lambda: m.simulate(m.initial, [0, 1], inputs=[0])),
             ('linearize(x)', ['linearize: argument x is missing', 'linearize(t, x, v=None)'],
              lambda: m.linearize(m.initial)),
             ('inverse(3)', ['inverse: argument times is missing', 'inverse(motion, times, '],
              lambda: m.inverse(3)),
             ('simulate, the times twice', ['argument times is given twice'],
              lambda: m.simulate(m.initial, [0, 1], times=[0, 1])),
             ('simulate, three without names', ['at most 2 arguments', '(x0, times)', 'found 3'],
              lambda: m.simulate(m.initial, [0, 1], 'rk4')),
             ('Model(3)', ['.Model: expected at most 0', 'found 1', 'Model(NAME=value)'],
              lambda: type(m)(3))]
    for what, texts, call in words:
        refuses(what, TypeError, texts, call)
    refuses('too many arguments', TypeError, ['at most'], m.rhs, 0, m.initial, [0], 1)
    refuses('an argument twice', TypeError, ['twice'], m.rhs, 0, m.initial, x=m.initial)
    refuses('a missing argument', TypeError, ['missing'], m.rhs, 0)
    refuses('states that differ', ValueError, ['3 states'], m.inv, 0, np.zeros((3, 3)),
            np.zeros((3, 2)), np.zeros(3))
    refuses('NaN', slider_crank.Error, ['INFO = -2', 'argument 2, X'], m.rhs, 0, [math.nan] * 7)
    holds('each INFO has its own meaning', all(
        slider_crank._run.meaning(row['name'][len('slider_crank_'):], i['code']) == i['meaning']
        for row in slider_crank._run.TABLE['subroutines'] for i in row['info']))
    try:
        m.rhs(0, np.array([[0.0, math.nan]] * 7))
    except slider_crank.Error as error:
        holds('... of one state of two', list(error.info) == [0, -2] and 'state 1' in str(error))
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter('always')
        m.acd(0, [math.pi, 0, 0.3, 0, 0, 0, 0], 1)
        holds('INFO > 0 with results is a warning or nothing', all(
            issubclass(w.category, slider_crank.DependentWarning) for w in told))
    for what, change in (
            ('a state more', lambda: m.states.append('a')),
            ('another unit', lambda: m.units['states'].update(q1='furlong')),
            ('another usual size', lambda: m.nominal.fill(2)),
            ('another parameter', lambda: m.parameters.update(l1=3))):
        refuses('%s of all models' % what, (AttributeError, ValueError), [], change)
    holds('docstrings with units and shapes', all(
        'shape (7)' in getattr(slider_crank.Model, f).__doc__ and '[A]'
        in getattr(slider_crank.Model, f).__doc__ for f in ('rhs', 'out', 'jac')))
    holds('attributes that are not there', 'did you mean' in _text(lambda: m.rhz))
    holds('every public function says what it does', all(
        inspect.getdoc(getattr(slider_crank, f)) for f in slider_crank.__all__ if f != 'table'))


def elsewhere():
    """Models and results go to other processes and come back; copies of a model are the model."""
    m = slider_crank.Model(l1=0.1)
    again = pickle.loads(pickle.dumps(m))
    holds('a model can be pickled', again.parameters == m.parameters
          and np.array_equal(again.cst, m.cst) and again.parameters['l1'] == 0.1)
    holds('a model can be copied', copy.copy(m) is m and copy.deepcopy([m])[0] is m)
    models = [slider_crank.Model(l1=l) for l in (0.1, 0.15, 0.2)]
    starts = [k.simulate(k.initial, [0, 1e-3], start='project').x[:, 0] for k in models]
    wanted = [k.simulate(x, [0, 0.1], input=12) for k, x in zip(models, starts)]
    with multiprocessing.get_context('fork').Pool(2) as pool:
        found = pool.starmap(_simulated, zip(models, starts))
        rates = pool.starmap(slider_crank.Model.con, [(k, 0, x[:3], x[3:6]) for k, x in
                                                      zip(models, starts)])
        try:
            pool.apply(m.rhs, (0, [math.nan] * 7))
        except slider_crank.Error as error:
            holds('an error of another process', error.info == -2)
    holds('runs of other processes, bit for bit', all(
        np.array_equal(a.x, b.x) and a.stats['calls'] == b.stats['calls']
        for a, b in zip(found, wanted)))
    holds('results of subroutines there', all(
        np.array_equal(r.phi, k.con(0, x[:3], x[3:6]).phi)
        for r, k, x in zip(rates, models, starts)))


def _simulated(model, x):
    return model.simulate(x, [0, 0.1], input=12)


def _text(function):
    try:
        function()
    except Exception as error:
        return str(error)
    return ''


def threads():
    """Another thread goes on while a batch is computed."""
    m = puma6.Model()
    q = np.asfortranarray(np.zeros((6, 100000)))
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
    thread = threading.Thread(target=count)
    old = sys.getswitchinterval()
    sys.setswitchinterval(0.3)   # so long Python itself does not change threads
    thread.start()
    before = counted[0]
    m.inv(0, q, q, q)
    after = counted[0]
    stop.set()
    sys.setswitchinterval(old)
    thread.join()
    holds('a batch lets other threads run (%d turns)' % (after - before), after - before > 1000)


def interrupted():
    """Ctrl-C ends a run at once, whatever its inputs are; handlers of signals stay as they were."""
    def late(signum, frame):
        raise TimeoutError('late')

    def nested(t, x):
        return m.simulate(m.initial, long, input=12).x[0, -1]

    def asleep(t, x):
        time.sleep(10 * (t > 0.01))
        return 12

    def wait(after, number, inputs, **options):
        """The seconds from the signal until the run has ended, or what came instead."""
        timer = threading.Timer(after, os.kill, (os.getpid(), number))
        timer.start()
        begun = time.monotonic()
        try:
            m.simulate(m.initial, long, input=inputs, **options)
            return 'a result'
        except kinds[number]:
            return time.monotonic() - begun - after
        finally:
            timer.join()

    m, long = slider_crank.Model(), np.linspace(0, 1800, 601)
    kinds = {signal.SIGINT: KeyboardInterrupt, signal.SIGALRM: TimeoutError}
    old = {signal.SIGINT: signal.signal(signal.SIGINT, signal.default_int_handler),
           signal.SIGALRM: signal.signal(signal.SIGALRM, late)}
    own = {number: signal.getsignal(number) for number in old}
    waits = {'a function, %d' % k: wait(0.1 + 0.01 * k, signal.SIGINT, lambda t, x: 12)
             for k in range(12)}
    waits['a function that sleeps'] = wait(0.1, signal.SIGINT, asleep)
    waits['a run within'] = wait(0.1, signal.SIGINT, nested)
    for number in own:
        for method in ('dp853', 'rk4'):
            waits['a constant, %s, %s' % (method, number)] = wait(
                0.1, number, 12, method=method, step=1e-4)
    for what, seconds in waits.items():
        holds('Ctrl-C ends a run at once, inputs: %s (%s s)' % (what, seconds),
              seconds != 'a result' and seconds < 1)
    holds('handlers of signals stay', own == {k: signal.getsignal(k) for k in own})
    calls = []
    signal.signal(signal.SIGINT, lambda *_: calls.append(1))
    threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT)).start()
    r = m.simulate(m.initial, np.linspace(0, 300, 301), input=12)
    holds('a handler that raises nothing lets a run go on', calls == [1] and r.t[-1] == 300)
    for number, handler in old.items():
        signal.signal(number, handler)


for test in (ball, own, rows, crank, sampled, switched, others, options, parameters, elsewhere,
             threads, interrupted):
    test()
