"""Optimal motions of modules beside those of Octave: a block, an arm, a cart with a pole, a gear
with a free ratio, a slider-crank with a motor; closed forms; refusals; what ends them from outside.

python3 collocate.py FILE: of collocate.m; the modules that it imports must be installed."""
import importlib
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

from checks import close, holds, refuses

BOUNDS = ('inputs', 'outputs', 'states', 'parameters', 'final')


def matrix(part):
    return np.reshape(np.array(part['numbers'], float), np.atleast_1d(part['size']).astype(int),
                      order='F')


def options_of(given):
    """Words and values of Octave as named arguments."""
    options = dict(zip(given[::2], given[1::2]))
    for name in BOUNDS:
        if name in options:
            row = options[name]
            least = -np.inf if row[1] is None else row[1]
            options[name] = {row[0]: (least, row[2])}
    if 'goal' in options:
        options['goal'] = dict(zip(options['goal'][::2], options['goal'][1::2]))
    return options


def beside_octave(name, one):
    m = importlib.import_module(name).Model()
    x0, xf = (np.array(one[k], float) for k in ('x0', 'xf'))
    options = options_of(one['options'])
    r = m.collocate(x0, xf, **options)
    what = '%s, %s beside Octave' % (name, options)
    holds(what + ': meshes, what is active, why it ended', (
        r.solved == one['solved'] and r.ended == one['ended']
        and [mesh['intervals'] for mesh in r.meshes] == np.atleast_1d(one['intervals']).tolist()
        and [bound['name'] for bound in r.active] == list(one['active'])
        and r.parameters.keys() == one['parameters'].keys()))
    close(what + ': goal, duration, times', [r.goal, r.T, *r.t], [one['goal'], one['T'], *one['t']],
          1e-9 * max(1, abs(one['goal'])))
    for part in ('x', 'v', 'ud', 'lam', 'y', 'costates'):
        wanted, found = matrix(one[part]), getattr(r, part)
        size = max(1e-9, np.abs(wanted).max(initial=0))
        close('%s: %s' % (what, part), np.append(found / size, 0), np.append(wanted / size, 0),
              1e-6)
    close(what + ': switches, parameters', [0, *r.switches, *r.parameters.values()],
          [0, *np.atleast_1d(one['switches']), *one['parameters'].values()], 1e-7)
    for part in ('input', 'motion'):
        wanted, found = matrix(one[part]), getattr(r, part)(np.array(one['at']))
        size = np.abs(wanted).max()
        close('%s: %s between the points' % (what, part), found / size, wanted / size, 1e-6)


def closed_forms():
    """Rest to rest over 1 m in 1 s: 12, 6 - 12 t; in the least time with 2 N: sqrt (2) s."""
    m = importlib.import_module('optimal_block').Model()
    for method in ('radau', 'lobatto'):
        r = m.collocate([0, 0], [1, 0], time=1, goal='effort', method=method)
        close('block, %s: goal 12' % method, r.goal, 12, 1e-9)
        close('... 6 - 12 t', r.v[0], 6 - 12 * r.t, 1e-7)
        close('... 3 t^2 - 2 t^3', r.x[0], 3 * r.t**2 - 2 * r.t**3, 1e-9)
        close('... costates -24, -12 + 24 t', r.costates, [0 * r.t - 24, -12 + 24 * r.t], 1e-8)
    again = m.collocate([0, 0], [1, 0], time=1, goal='effort', guess=r)
    close('a guess', again.goal, 12, 1e-9)
    heavy = m.changed(m=2).collocate([0, 0], [1, 0], time=1, goal='effort')
    close('twice the mass: goal 48', heavy.goal, 48, 1e-8)
    r = m.collocate([0, 0], [1, 0], time=(0.1, 5), inputs={'F': (-2, 2)})
    close('the least time, where the force jumps', [r.T, *r.switches], [2**0.5, 0.5**0.5], 1e-12)
    uneven = m.collocate([0, 0], [1, 0], time=(0.1, 5), inputs={'F': (-1, 3)})
    gains = {one['bound']: one['multiplier'] for one in uneven.active}   # T^2 = 2/1 + 2/3
    close('what a unit of each limit gains', [gains['least'], gains['largest']],
          [1 / uneven.T, 1 / (9 * uneven.T)], 1e-9)
    s = m.simulate([0, 0], [0, r.T], input=r.input)
    close('a run with the inputs ends there', s.x[:, -1], [1, 0], 1e-6)
    i = m.inverse(r.motion, [0.1, 0.6])
    close('inverse takes the motion', i.tau, [[2, 2]], 1e-6)


def closed_chain():
    """A slider-crank past its dead centre; what follows the crank, a parameter that stays."""
    m = importlib.import_module('optimal_crank').Model()
    nan = math.nan
    options = {'time': 0.5, 'goal': m.inputs[0] + '^2'}
    start = m.assemble([-1, 1.4, 0.5, 0, 0, 0, 0], hold='q1')
    end = m.assemble([1, -1.4, 0.5, 0, 0, 0, 0], hold='q1')
    r = m.collocate([-1, nan, nan, 0, nan, nan, 0], [1, nan, nan, 0, nan, nan, nan], **options)
    holds('a crank past its dead centre: ' + r.ended, r.solved)
    close('it begins on the loop', r.x[:, 0], start, 1e-9)
    s = m.simulate(start, [0, 0.5], input=r.input, rtol=1e-9)
    close('a run ends there', s.x[:6, -1], end[:6], 1e-5)
    light = m.collocate(start, [1, nan, nan, 0, nan, nan, nan], parameters={'m3': (0.9, 1.1)},
                        guess=r, **options)
    holds('one parameter is free, the other stays', (
        light.solved and light.goal <= r.goal * (1 + 1e-9)
        and light.parameters['l1'] == m.parameters['l1']))
    refuses('a start off the loop', ValueError,
            ['x0: expected a state on the constraints, found C.'], m.collocate,
            [-1, 1.4, 0.5, 0, 0, 0, 0], end, **options)


def refusals():
    m = importlib.import_module('optimal_block').Model()
    ends = [0, 0], [1, 0]
    refuses('states of another size', ValueError,
            ['x0: expected 2 numbers (x_b, x_b_d), NaN where one is free'], m.collocate, [0],
            [1, 0], time=1)
    for options, said in (
            ({'time': 0}, 'time: expected the duration, or the least and the largest; found 0'),
            ({'time': 1, 'goal': 'efort'}, "found 'efort'; did you mean effort?"),
            ({'time': 1, 'goal': 'F^3'}, 'NAME^2, NAME*NAME'),
            ({'time': 1, 'goal': 'final q'}, 'goal: expected a state or an output'),
            ({'time': 1, 'inputs': {'F': (2, 1)}}, 'inputs: F: expected the least and the largest'),
            ({'time': 1, 'outputs': {'x': (0, 1)}}, "outputs: expected a name; found 'x'"),
            ({'time': 1, 'parameters': {'m': (1, 2)}}, 'it was derived for none'),
            ({'time': 1, 'states': {'x_b': (-1, 0.5)}}, 'xf: x_b = 1 is not within its bounds'),
            ({'time': 1, 'method': 'euler'}, 'expected one of "radau", "lobatto"'),
            ({'time': 1, 'intervals': 0}, 'intervals: expected a whole number from 1 on'),
            ({'time': 1, 'guess': 3}, 'guess: expected a Collocation or (t, x, v)')):
        refuses('%s' % options, ValueError, [said], m.collocate, *ends, **options)
    refuses('no request collocation', AttributeError, ['without the subroutine DAE'],
            importlib.import_module('case_d1a').Model().collocate, *ends, time=1)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter('always')
        r = m.collocate(*ends, time=0.1, inputs={'F': (-1, 1)})
    holds('what cannot be is told', (
        not r.solved and 'the equations miss by' in str(told[0].message)
        and '(state %s)' % m.states[0] in str(told[0].message)))


def ended_from_outside():
    m = importlib.import_module('optimal_cart').Model()
    options = {'time': 2, 'goal': 'effort', 'states': {'p': (-2, 2)}, 'accuracy': 1e-13,
               'refinements': 20}
    begin = time.time()
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        r = m.collocate([0] * 4, [1, np.pi, 0, 0], timeout=1, **options)
    holds('timeout: %s, %.1f s' % (r.ended, time.time() - begin), (
        r.stopped == 'timeout' and not r.solved and abs(r.goal - 58.8077) < 0.01
        and 'ended by option timeout; solved on' in r.ended))
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    begin = time.time()
    try:
        m.collocate([0] * 4, [1, np.pi, 0, 0], **options)
        holds('Ctrl-C is an exception', False)
    except KeyboardInterrupt:
        holds('Ctrl-C is an exception, after %.1f s' % (time.time() - begin), True)
    r = m.collocate([0] * 4, [1, np.pi, 0, 0], time=2, goal='effort', states={'p': (-2, 2)})
    holds('... and the next one is solved', r.solved)


def signatures():
    m = importlib.import_module('optimal_block')
    names = list(inspect.signature(m.Model.collocate).parameters)[3:]
    stub = open(os.path.join(os.path.dirname(m.__file__), '__init__.pyi'), encoding='utf-8').read()
    part = stub[stub.index('def collocate('):stub.index('-> Collocation')]
    holds('the stub has all options', all(' %s: ' % name in part for name in names))
    documented = m.Model.collocate.__doc__
    holds('the docstring has all options', all(name in documented for name in names))


if __name__ == '__main__':
    with open(sys.argv[1], encoding='utf-8') as file:
        motions = json.load(file)
    for scene, several in motions.items():
        for motion in several:
            beside_octave(scene, motion)
    closed_forms()
    closed_chain()
    refusals()
    ended_from_outside()
    signatures()
