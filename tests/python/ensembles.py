"""Many runs of a module: against single ones, threads, rows that fail, refusals, Ctrl-C.

python3 ensembles.py: the modules that it imports must be installed."""
import math
import os
import signal
import threading
import time
import warnings

import numpy as np

import event_ball
import puma6
import robot_joint
import slider_crank
from checks import close, holds, refuses

RNG = np.random.default_rng(4)


def same(what, m, e, i, x0, times, named, **options):
    """Run i of an ensemble is that of simulate, bit for bit."""
    one = m.changed(**{k: v[i] for k, v in named.items()})
    r = one.simulate(x0, times, **options)
    y = r.y is None or np.array_equal(e.y[i], r.y)
    holds('%s: run %d as by simulate, bit for bit' % (what, i),
          np.array_equal(e.x[i], r.x) and np.array_equal(e.v[i], r.v) and y
          and e.stats['calls'][i] == r.stats['calls'] and e.stats['accepted'][i]
          == r.stats['accepted'])


def arm():
    m = puma6.Model()
    n, times = 23, [0, 0.1, 0.25]
    name = next(iter(m.parameters))
    value = m.parameters[name]
    named = {name: value * (1 + 0.05 * RNG.random(n))}
    starts = 0.3 * (2 * RNG.random((n, m.sizes['nx'])) - 1)
    for method, options in (('dp853', {'rtol': 1e-9}), ('rk4', {'step': 2e-3}), ('radau', {})):
        what = 'arm, ' + method
        e = m.ensemble(times, parameters=named, starts=starts, threads=1, method=method, **options)
        holds(what + ': all are complete', e.ok.all() and (e.reached == 0.25).all()
              and e.x.shape == (n, m.sizes['nx'], 3) and e.reason == [''] * n)
        for i in (0, 11, 22):
            same(what, m, e, i, starts[i], times, named, method=method, **options)
        order = RNG.permutation(n)
        f = m.ensemble(times, parameters={name: named[name][order]}, starts=starts[order],
                       threads=3, method=method, **options)
        holds(what + ': in another order, by three threads, bit for bit',
              np.array_equal(f.x, e.x[order]) and np.array_equal(f.v, e.v[order]))


def crank():
    m = slider_crank.Model()
    n, times = 9, np.linspace(0, 0.4, 5)
    inputs = np.linspace(6, 24, n)[:, None]
    e = m.ensemble(times, inputs=inputs, start='project')
    holds('crank: all are complete', e.ok.all())
    for i in (0, 8):
        same('crank', m, e, i, m.initial, times, {}, start='project', input=inputs[i])
    drive = robot_joint.Model()
    e = drive.ensemble([0, 0.05], starts=[drive.initial] * 3, input=None)
    same('a sampled controller', drive, e, 2, drive.initial, [0, 0.05], {})


def ball():
    m = event_ball.Model()
    g = np.linspace(5, 15, 11)
    e = m.ensemble([0, 1.0], parameters={'g': g}, x0=[1, 0, 0, 3])
    close('ball: the first impacts [s]', e.events['first'][:, 0], np.sqrt(2 / g), 1e-11)
    holds('ball: how many events there were', e.events['count'].shape == (11, 2)
          and (e.events['count'][:, 0] >= 1).all())


def failing():
    m = puma6.Model()
    starts = np.zeros((5, m.sizes['nx']))
    good = m.ensemble([0, 0.1], starts=starts, threads=2)
    starts[3, -1] = 1e160
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter('always')
        e = m.ensemble([0, 0.1], starts=starts, threads=2)
    holds('one that fails ends alone: ' + e.reason[3], e.ok.tolist() == [True] * 3 + [False, True]
          and np.array_equal(e.x[[0, 1, 2, 4]], good.x[[0, 1, 2, 4]]) and e.reason[3] != ''
          and np.isnan(e.x[3, :, 1:]).all())
    holds('... and a warning says so', len(heard) == 1 and '1 of 5 runs failed' in str(
        heard[0].message))
    b = event_ball.Model()
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        e = b.ensemble([0, 0.1], x0=[-1, 0, 0, 3], parameters={'g': [9, 10]})
    holds('a start beyond a stop: ' + e.reason[0], not e.ok.any() and 'stop' in e.reason[0])


def refusals():
    m = puma6.Model()
    x = np.zeros((2, m.sizes['nx']))
    refuses('nothing that differs', ValueError, ['what differs from run to run'], m.ensemble,
            [0, 1])
    refuses('an unknown parameter', KeyError, ['unknown parameter "nothing"'], m.ensemble, [0, 1],
            parameters={'nothing': [1]})
    refuses('starts of another width', ValueError, ['starts: expected an array (n, '], m.ensemble,
            [0, 1], starts=x[:, 1:])
    refuses('as many rows', ValueError, ['starts: expected 3 rows', 'found 2'], m.ensemble, [0, 1],
            starts=x, inputs=np.zeros((3, m.sizes['nv'])))
    bad = x.copy()
    bad[1, 0] = math.nan
    refuses('a start that is no number', ValueError, ['starts[1, 0]', 'found nan'], m.ensemble,
            [0, 1], starts=bad)
    refuses('threads', ValueError, ['threads: expected a whole number from 0'], m.ensemble, [0, 1],
            starts=x, threads=-1)
    refuses('a function of inputs', ValueError, ['cannot run on several threads'], m.ensemble,
            [0, 1], starts=x, input=lambda t, x: np.zeros(6))
    refuses('both', ValueError, ['input or inputs'], m.ensemble, [0, 1], starts=x,
            inputs=np.zeros((2, m.sizes['nv'])), input=np.zeros(m.sizes['nv']))


def interrupted():
    """Ctrl-C ends all runs soon; meanwhile other threads of Python run."""
    m = puma6.Model()
    starts = 0.3 * (2 * RNG.random((2000, m.sizes['nx'])) - 1)
    turns, over = [0], threading.Event()

    def count():
        while not over.is_set():
            turns[0] += 1
            time.sleep(1e-3)
    other = threading.Thread(target=count)
    alarm = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    begun = time.perf_counter()
    other.start()
    alarm.start()
    stopped = False
    try:
        m.ensemble([0, 1000], starts=starts, threads=2)
    except KeyboardInterrupt:
        stopped = True
    took = time.perf_counter() - begun
    over.set()
    other.join()
    holds('Ctrl-C ends 2000 long runs, after %.2f s' % took, stopped and took < 10)
    holds('other threads run meanwhile: %d turns' % turns[0], turns[0] > 50)


if __name__ == '__main__':
    arm()
    crank()
    ball()
    failing()
    refusals()
    interrupted()
