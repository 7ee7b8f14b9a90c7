"""The implicit methods of runs: closed forms, other methods, refusals, failures.

python3 implicit.py: the modules that it imports must be installed; cvode is tested where the
modules were built with SUNDIALS."""
import math
import os
import signal
import threading
import time
import warnings

import numpy as np

import event_ball
import event_pulled
import own_events
import robot_joint
import sampled_crank
import slider_crank
import stiff_loop
import switch_circuit
from checks import close, holds, refuses

SUNDIALS = os.path.exists(os.path.join(os.path.dirname(stiff_loop.__file__), '_cvode.so'))
STIFF = ('radau', 'auto') + ('cvode',) * SUNDIALS
ALL = STIFF + ('gauss',)


def run(m, x0, times, **options):
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        return m.simulate(x0, times, **options)


def gap(r, exact):
    """The largest error of a state beside its largest and its nominal magnitude."""
    size = np.abs(exact.x).max(axis=1) + 1e-9
    return (np.abs(r.x - exact.x).max(axis=1) / size).max()


def ball():
    """Impacts in closed form."""
    m, g = event_ball.Model(), 9.81
    first = math.sqrt(2 / g)
    for method in ALL:
        r = run(m, [1, 0, 0, 3], np.arange(0, 6.1, 0.25), method=method, step=1e-2)
        on = r.events['number'] == 0
        n = np.arange(on.sum())
        close('ball, %s: times of the impacts [s]' % method, r.events['t'][on],
              first * (1 + 2 * 0.8 * (1 - 0.8 ** n) / 0.2), 1e-5 if method == 'cvode' else 1e-8)
        close('ball, %s: rests' % method, [r.x[0, -1], r.x[2, -1], r.v[0, -1] + 1], 0, 1e-12)


def own():
    """Events of the user in closed form: bounces, thresholds that switch a force, the end."""
    m, g, e = own_events.Model(), 9.81, 0.8
    hits = [math.sqrt(2 / g)]
    speed = g * hits[0]
    while hits[-1] < 3:
        speed *= e
        hits.append(hits[-1] + 2 * speed / g)
    cold = math.log(1.5) + math.log(4) * np.arange(2)
    wanted = {'hit': hits[:-1], 'cold': cold, 'hot': (cold + math.log(2))[:2], 'done': [3.0]}
    for method in ALL:
        r = run(m, [1, 0, 0, 1.5], np.arange(0, 5.1, 0.5), method=method, step=5e-3, rtol=1e-11)
        names = np.array(r.events['device'])
        for name, times in wanted.items():
            found = r.events['t'][names == name]
            holds('%s: %s happens %d times' % (method, name, len(times)), len(found) == len(times))
            close('%s: when %s happens [s]' % (method, name), found, times, 2e-8)
        holds('%s: what ended it is told' % method, r.stats['stopped'] == 'event done')


def sharp():
    """Where friction falls too steeply for an implicit method a warning says so; else the events
    are right."""
    for method, vs, atol, warns in (('radau', 1e-8, 1e-6, True), ('radau', 1e-8, 1e-9, False),
                                    ('radau', 1e-10, 1e-12, True), ('dp853', 1e-10, 1e-6, False)):
        m = event_pulled.Model(vs=vs)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter('always')
            r = m.simulate([0, 0], np.linspace(0, 3, 31), method=method, atol=atol,
                           errors='return')
        found = any('F falls from its breakaway within vs = %.3g' % vs in str(one.message)
                    for one in told)
        holds('%s, vs = %g, atol = %g: warned of, or 8 events' % (method, vs, atol),
              found == warns and (warns or len(r.events['t']) == 8))


def circuit():
    """A capacitor on a voltage that switches three times, in closed form."""
    m, tau = switch_circuit.Model(), 0.1
    t = np.linspace(0, 1.2, 25)
    levels = [(0, 0), (0.1, 5), (0.3, 0), (0.7, 10)]
    exact = np.zeros(len(t))
    for k, time_ in enumerate(t):
        u, last, level = 0.0, 0.0, 0.0
        for at, value in levels:
            if at < time_:
                u, last, level = level + (u - level) * math.exp(-(at - last) / tau), at, value
        exact[k] = level + (u - level) * math.exp(-(time_ - last) / tau)
    for method in ALL:
        r = run(m, [0, 0], t, method=method, rtol=1e-10)
        close('circuit, %s' % method, r.x[0], exact, 5e-8)


def loops():
    """A loop on a spring of 1e8 N/m: the work of radau, all methods of the constraints."""
    m, t = stiff_loop.Model(), np.linspace(0, 0.3, 6)
    exact = run(m, m.initial, t, start='project', rtol=1e-12)
    ways = {'radau': ('projection', 'baumgarte', 'partitioning', 'index2'),
            'cvode': ('projection', 'partitioning')}
    for method in ways if SUNDIALS else ['radau']:
        for way in ways[method]:
            r = run(m, m.initial, t, start='project', rtol=1e-10, method=method, loops=way)
            close('stiff loop, %s, %s' % (method, way), gap(r, exact), 0,
                  1e-4 if method == 'radau' else 1e-3)
            s = r.stats
            holds('... %d calls, %d Jacobians, %d iterations' % (
                s['calls'], s['jacobians'], s['newton']),
                s['method'] == method and 0 < s['jacobians'] <= s['newton'])
    steps = [run(m, m.initial, t, start='project', rtol=1e-8, method=method).stats['accepted']
             for method in ('radau', 'dp853')]
    holds('radau takes %d steps, dp853 %d' % tuple(steps), 2 * steps[0] < steps[1])
    for order in (5, 9, 13):
        r = run(m, m.initial, t, start='project', method='radau', maxorder=order, rtol=1e-8)
        close('radau up to order %d, %d steps' % (order, r.stats['accepted']), gap(r, exact), 0,
              1e-3)
    for way in ('projection', 'index2'):
        r = run(m, m.initial, [0, 0.5, 1], start='project', method='auto', loops=way, rtol=1e-8)
        holds('auto, %s, reports when it went on with radau' % way, r.stats['method'] == 'radau'
              and 0 < r.stats['jacobians'] <= r.stats['newton']
              and 0 < r.stats['stiff']['time'] < 1)
        close('... loops closed', m.con(1, r.x[:4, 2], r.x[4:, 2]).phi, 0, 1e-12)
    easy = event_ball.Model()
    r = run(easy, [1, 0, 0, 3], [0, 0.1], method='auto')
    holds('auto stays with dp853 where nothing is stiff', r.stats['method'] == 'dp853'
          and r.stats['jacobians'] == r.stats['newton'] == 0)


def inputs():
    """Functions, tables, planned motions, feedback, samples: as dp853 has them."""
    m = slider_crank.Model()
    t = np.linspace(0, 0.5, 6)
    about = m.initial
    gain = np.array([[5, 0, 0, 0.5, 0, 0, 0]])
    table = slider_crank.table_of([0, 0.13, 0.5], [12, -3, -3], 0)
    joint = robot_joint.Model()
    move = robot_joint.plan('septic', [0, 1], [0, 1])
    start = joint.inverse(move, [0]).x[:, 0]
    sampled = sampled_crank.Model()
    x = sampled.simulate(sampled.initial, [0, 1e-6], start='project').x[:, 0]
    for what, model, x0, options in (
            ('a function', m, about, {'input': lambda t, x: 12 * math.sin(20 * t) - 0.1 * x[3]}),
            ('a table that jumps', m, about, {'input': table}),
            ('feedback', m, about, {'input': 3, 'gain': gain, 'reference': about}),
            ('a planned motion', joint, start, {'motion': move}),
            ('samples', sampled, x, {})):
        exact = run(model, x0, t, rtol=1e-12, **options)
        for method in ALL:
            r = run(model, x0, t, rtol=1e-9, method=method, **options)
            close('%s, %s' % (what, method), gap(r, exact), 0, 1e-5)
    r = run(m, about, t, input=12, method='radau', audit=1.0)
    holds('the audit of a run by radau: %.1e' % r.audit['error'], r.audit['error'] < 1e-7)


def energy():
    """Gauss keeps the energy of a free loop without a drift: symplectic."""
    m = stiff_loop.Model(c=0.0, k=1e3)
    x = run(m, m.initial, [0, 1e-9], start='project').x[:, 0]
    t = np.linspace(0, 40, 401)
    for order, most in ((4, 1e-6), (6, 1e-10), (8, 1e-12)):
        r = run(m, x, t, method='gauss', maxorder=order, step=2e-3)
        e = m.ene(r.t, r.x)[:3].sum(axis=0)
        size = np.ptp(m.ene(r.t, r.x)[0])
        late, early = (np.abs(part - e[0]).max() / size for part in (e[300:], e[:100]))
        holds('energy, order %d: %.1e at first, %.1e at last' % (order, early, late),
              late < most and late < 3 * early)


def refused():
    m, ball_ = slider_crank.Model(), event_ball.Model()
    t = [0, 0.1]
    refuses('an unknown method', ValueError, ['"dp853", "rk4", "cvode", "radau", "gauss", "auto"'],
            m.simulate, m.initial, t, method='bdf')
    for method, order in (('radau', 4), ('auto', 6), ('gauss', 5), ('cvode', 6), ('radau', True),
                          ('gauss', '6')):
        if method != 'cvode' or SUNDIALS:
            wanted = 'one of' if type(order) is int else 'a whole number'
            refuses('order %r of %s' % (order, method), ValueError,
                    ['maxorder: expected %s' % wanted, 'found %r' % (order,)], m.simulate,
                    m.initial, t, method=method, maxorder=order)
    refuses('an order of dp853', ValueError, ['method dp853 has one order alone, found 5'],
            m.simulate, m.initial, t, maxorder=5)
    refuses('index 2 by dp853', ValueError, ['"index2"', 'is for method "radau"'], m.simulate,
            m.initial, t, loops='index2')
    refuses('index 2 without loops', ValueError, ['event_ball has no loops'], ball_.simulate,
            [1, 0, 0, 3], t, loops='index2', method='radau')
    refuses('gauss without a step', ValueError, ['step', 'above 0'], m.simulate, m.initial, t,
            method='gauss', step=0)
    if not SUNDIALS:
        refuses('cvode without SUNDIALS', ImportError, ['libsundials-dev'], m.simulate, m.initial,
                t, method='cvode')
    for method in STIFF:
        refuses('%s: too few steps' % method, slider_crank.Error, ['maxsteps', 't = '], m.simulate,
                m.initial, [0, 1], input=12, method=method, maxsteps=3)
        refuses('%s: a failing function' % method, ZeroDivisionError, [], m.simulate, m.initial, t,
                method=method, input=lambda t, x: 1 / (t < 0.05))
    stiff = stiff_loop.Model()
    r = run(stiff, stiff.initial, [0, 0.5], start='project', method='gauss', step=0.1,
            errors='return')
    holds('gauss: %s' % r.stats['failure'], 'shorter step' in (r.stats['failure'] or ''))


def ends():
    """Ctrl-C and threads, as by other methods."""
    m, loop = slider_crank.Model(), stiff_loop.Model(c=0.0, k=1e3)   # gauss: by momenta
    closed = run(loop, loop.initial, [0, 1e-9], start='project').x[:, 0]
    old = signal.signal(signal.SIGINT, signal.default_int_handler)
    for model, x, method, options in ((m, m.initial, 'radau', {'input': 12}),
                                      (m, m.initial, 'gauss', {'input': 12, 'step': 1e-4}),
                                      (loop, closed, 'gauss', {'step': 1e-3})):
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        begun = time.monotonic()
        try:
            run(model, x, np.linspace(0, 3600, 601), method=method, **options)
            seconds = 'a result'
        except KeyboardInterrupt:
            seconds = time.monotonic() - begun - 0.2
        timer.join()
        holds('Ctrl-C ends a run of %s by %s at once (%s s)' % (
            type(model).__module__, method, seconds),
              seconds != 'a result' and seconds < 1)
    signal.signal(signal.SIGINT, old)
    wanted = run(m, m.initial, [0, 0.5], input=12, method='radau').x
    found = [None] * 4

    def one(k):
        found[k] = m.simulate(m.initial, [0, 0.5], input=12, method='radau').x
    threads = [threading.Thread(target=one, args=(k,)) for k in range(4)]
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    holds('four threads, the same bits', all(np.array_equal(x, wanted) for x in found))


for test in (ball, own, sharp, circuit, loops, inputs, energy, refused, ends):
    test()
