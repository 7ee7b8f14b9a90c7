"""Linear models, assemblies, equilibria, steady motions and modes of modules beside those of
Octave: an arm, a four-bar, a motor, a hydraulic cylinder, a disc that rolls, a bead on a disc that
spins, a free body in Euler parameters; closed forms; refusals.

python3 linear.py FILE: of linear.m; the modules that it imports must be installed."""
import importlib
import inspect
import json
import sys
import warnings

import numpy as np

from checks import close, holds, refuses


def matrix(part):
    """A matrix of Octave; null in JSON is NaN."""
    return np.reshape(np.array(part['numbers'], float), np.atleast_1d(part['size']).astype(int),
                      order='F')


def listed(names):
    return tuple([names] if isinstance(names, str) else names)


def beside_octave(name, one):
    m = importlib.import_module(name).Model()
    options = dict(zip(one['options'][::2], one['options'][1::2]))
    r = m.linear(0, one['x'], np.atleast_1d(one['v']) if np.size(one['v']) else None, **options)
    what = '%s%s beside Octave' % (name, ''.join(', %s %s' % o for o in options.items()))
    holds(what + ': states, outputs, what is dropped', (
        r.states == listed(one['states']) and r.outputs == listed(one['outputs'])
        and r.dropped == listed(one['dropped'])
        and r.independent.tolist() == np.atleast_1d(one['independent']).tolist()))
    for part in ('a', 'b', 'c', 'd', 'tangent'):
        wanted = matrix(one[part])
        size = np.abs(wanted).max(initial=1e-9)
        close('%s: %s' % (what, part), np.append(getattr(r, part) / size, 0),
              np.append(wanted / size, 0), 1e-13)


def mck_beside_octave(name, one):
    m = importlib.import_module(name).Model()
    options = dict(zip(one['options'][::2], one['options'][1::2]))
    r = m.mck(0, one['x'], np.atleast_1d(one['v']) if np.size(one['v']) else None, **options)
    what = 'mck of %s%s beside Octave' % (name, ''.join(', %s %s' % o for o in options.items()))
    holds(what + ': names', [list(k) for k in (r.coordinates, r.speeds, r.devices)] == [
        list(listed(k)) for k in one['mck']['names']])
    least = np.abs(r.M).max(initial=1e-9)   # the others are it times numbers: zeros are round-off
    for part in 'MCKBEDGSN':
        wanted, found = matrix(one['mck'][part]), getattr(r, part)
        if found is None:
            holds('%s: %s is empty' % (what, part), not wanted.size)
            continue
        size = np.abs(wanted).max(initial=least)
        close('%s: %s' % (what, part), np.append(found / size, 0), np.append(wanted / size, 0),
              1e-12)


def assembly_beside_octave(name, one):
    m = importlib.import_module(name).Model()
    options = dict(zip(one['options'][::2], one['options'][1::2]))
    x = m.assemble(one['guess'], **options)
    what = 'assemble of %s, %d numbers%s beside Octave' % (
        name, len(one['guess']), ''.join(', %s %s' % o for o in options.items()))
    wanted = matrix(one['x'])
    holds(what + ': how many', x.shape == (wanted.shape if 'branches' in options
                                           else wanted.shape[:1]))
    close(what, x.reshape(wanted.shape), wanted, 1e-14)


def assembly():
    """A four-bar closed from a rough pose: its constraints, coordinates that are held; what is
    refused and warned of."""
    m = importlib.import_module('case_03a').Model()
    for held in ('theta', 'psi'):
        x = m.assemble([1.1, -0.6, 1.4, 1.5, 0.2, -0.1], hold=held)
        con = m.con(0, x[:3], x[3:])
        close('the loop closed with %s held' % held,
              np.concatenate([con.phi, con.hc @ x[3:] + con.phit]), np.zeros(4), 1e-12)
        k = m.coordinates.index(held)
        holds('... %s stays' % held, x[k] == (1.1, -0.6, 1.4)[k])
    both = m.assemble([1.1, -0.6, 1.4], hold='theta', branches=12)
    close('both ways to assemble it', m.con(0, both[:3], both[3:]).phi, np.zeros((2, 2)), 1e-12)
    holds('... differ', both.shape == (6, 2) and abs(both[1, 0] - both[1, 1]) > 0.1)
    refuses('a coordinate that it has not', ValueError, ['hold', "'thet'", 'did you mean theta',
                                                         'known: theta'],
            m.assemble, m.initial, hold='thet')
    refuses('too many held', ArithmeticError, ['leave 1 degree(s) of freedom to theta, psi'],
            m.assemble, [1.1, -0.6, 1.4], hold=('theta', 'psi'))
    refuses('branches', ValueError, ['branches', '-1'], m.assemble, m.initial, branches=-1)
    refuses('a guess of another size', ValueError, ['guess', 'expected 6', '3 coordinates'],
            m.assemble, [1.0, 2.0])
    refuses('an angle without a sine', ArithmeticError, ['theta', 'at most 1e15 rad, found 1e+16'],
            m.assemble, [1e16, -0.6, 1.4], hold='theta')
    free = importlib.import_module('orient_free').Model()
    refuses('one Euler parameter held', ArithmeticError, ['hold all four, or none'],
            free.assemble, free.initial, hold=free.coordinates[3])


def trim_beside_octave(name, one):
    m = importlib.import_module(name).Model()
    options = dict(zip(one['options'][::2], one['options'][1::2]))
    r = m.trim(one['guess'], **options)
    what = 'trim of %s%s beside Octave' % (name, ''.join(', %s %s' % o for o in options.items()))
    holds(what + ': way, what runs, what can be moved', (
        r.way == one['way'] and r.running == listed(one['running'])
        and r.indifferent == listed(one['indifferent'])
        and r.unique.tolist() == [bool(k) for k in np.atleast_1d(one['unique'])]))
    for part, found in (('x', r.x), ('v', r.v), ('lambda', r.lam)):
        wanted = np.atleast_1d(np.array(one[part], float))
        size = np.abs(wanted).max(initial=1e-9)
        close('%s: %s' % (what, part), np.append(found / size, 0), np.append(wanted / size, 0),
              1e-11)
    rates = m.rhs(0, r.x, r.v)[m.sizes['nq']:]
    holds(what + ': nothing is accelerated', r.running
          or np.abs(rates / m.nominal[m.sizes['nq']:]).max() < 1e-7)


def modes_beside_octave(name, one):
    m = importlib.import_module(name).Model()
    options = dict(zip(one['options'][::2], one['options'][1::2]))
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        r = m.modes(one['guess'], np.atleast_1d(one['inputs']) if np.size(one['inputs']) else None,
                    **options)
    what = 'modes of %s%s beside Octave' % (name, ''.join(', %s %s' % o for o in options.items()))
    holds(what + ': how many', r.rigid == one['rigid'] and r.frequency.size + r.real.size > 0)
    for part in ('x', 'frequency', 'damping', 'real', 'eigenvalues', 'shapes'):
        wanted = one[part]
        if isinstance(wanted, dict):
            wanted = np.array(wanted['re'], float) + 1j * np.array(wanted['im'], float)
        wanted = np.ravel(np.array(wanted, complex))
        found = getattr(r, part).ravel(order='F')
        size = np.abs(wanted).max(initial=1e-9)
        close('%s: %s' % (what, part), np.append(found / size, 0), np.append(wanted / size, 0),
              1e-9)


def campbell_beside_octave(name, one):
    m = importlib.import_module(name).Model()
    options = dict(zip(one['options'][::2], one['options'][1::2]))
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        r = m.campbell(one['guess'], one['spin'], one['speeds'], **options)
    what = 'campbell of %s by %s%s beside Octave' % (
        name, one['spin'], ''.join(', %s %s' % o for o in options.items()))
    holds(what + ': rigid modes, sizes', (
        r.rigid.tolist() == np.ravel(one['rigid']).tolist()
        and r.shapes.shape == tuple([*np.ravel(one['shapes']['size']), 1][:3])))
    for part in ('frequency', 'damping', 'eigenvalues', 'shapes', 'x'):
        wanted = (np.ravel(np.array(one[part]['re'], float))
                  + 1j * np.ravel(np.array(one[part]['im'], float)))
        found = np.ravel(getattr(r, part), order='F').astype(complex)
        holds('%s: %s is known where it is' % (what, part),
              (np.isnan(found) == np.isnan(wanted)).all())
        size = np.nanmax(np.abs(np.append(wanted, 1)))
        close('%s: %s' % (what, part), np.append(np.nan_to_num(found / size), 0),
              np.append(np.nan_to_num(wanted / size), 0), 1e-9)
    held = [one['spin'], *listed(options.get('hold', ()))]
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        one_by_one = [m.modes(x, hold=held).frequency for x in r.x.T if not options.get('steady')]
    for k, frequency in enumerate(one_by_one):
        column = r.frequency[:, k]
        close(what + ': as one by one', np.sort(column[~np.isnan(column)]), frequency,
              1e-12 * np.max(frequency, initial=1))


def reach_beside_octave(name, one):
    m = importlib.import_module(name).Model()
    options = dict(zip(one['options'][::2], one['options'][1::2]))
    if 'given' in options:
        options['given'] = [options['given']]
    R = matrix(one['R']) if np.size(one['R']['numbers']) else None
    r = m.reach(one['name'], matrix(one['P']), R, **options)
    what = 'reach of %s, %s beside Octave' % (name, ', '.join(options))
    holds(what + ': status, branches, how many solutions', (
        r.status == listed(one['status'])
        and r.branch.tolist() == np.atleast_1d(one['branch']).tolist()
        and [s.shape[1] for s in r.solutions] == np.atleast_1d(one['solutions']).tolist()))
    for part, found in (('q', r.q), ('distance', r.distance), ('free', np.abs(r.free))):
        wanted = matrix(one[part])
        holds(what + ': %s is known where it is' % part,
              (np.isnan(found) == np.isnan(wanted)).all())
        close('%s: %s' % (what, part), np.nan_to_num(found), np.nan_to_num(wanted), 1e-9)
    for k, q in enumerate(r.q.T):
        if np.isfinite(q).all():
            close(what + ': the tool is there', np.ravel(m.pnt(0, q)[0])[:3],
                  matrix(one['P'])[:, k], 1e-9)


def shapes():
    import case_03a
    m = case_03a.Model()
    x = np.array(m.simulate(m.initial, [0, 0.1], start='project').x[:, -1])
    r, h = m.linear(0, x), 1e-6
    ends = [m.rhs(0, x[:, None] + s * h * r.tangent)[r.independent] for s in (1, -1)]
    close('four-bar: its rates along the tangent beside differences', r.a,
          (ends[0] - ends[1]) / (2 * h), 1e-7 * np.abs(r.a).max())
    signature = str(inspect.signature(m.linear))
    holds('inspect knows the arguments of linear', signature == (
        "(t, x, v=None, *, reduced='auto', drop=(), start='check')"))
    holds('linear has a help text', 'gsmbp_linear' in m.linear.__doc__)
    signature = str(inspect.signature(m.trim))
    holds('inspect knows the arguments of trim', signature == (
        "(x, v=None, *, hold=(), free=(), steady=(), time=0.0, tolerance=1e-09, "
        "margins='check')"))
    signature = str(inspect.signature(m.modes))
    holds('inspect knows the arguments of modes', signature == (
        "(x, v=None, *, hold=(), steady=False, time=0.0, start='check')"))


def pendulum():
    """The arm hanging down, its elbow held: a compound pendulum."""
    import control_arm
    m = control_arm.Model()
    p = m.parameters
    length = p['l1'] + p['l2'] / 2
    inertia = (p['m1'] * p['l1'] ** 2 / 3 + p['m2'] * (p['l2'] ** 2 / 12 + length ** 2))
    torque = p['g'] * (p['m1'] * p['l1'] / 2 + p['m2'] * length)
    r = m.modes([-np.pi / 2, 0], hold='q2')
    close('arm, elbow held: frequency', r.frequency, np.sqrt(torque / inertia), 1e-12)
    close('arm, elbow held: damping', r.damping * 2 * r.frequency * inertia, p['d'], 1e-12)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter('always')
        m.modes([0, 0])
    holds('no equilibrium is a warning', 'found q1_d with an acceleration of -' in str(
        told[0].message) and 'rad/s^2' in str(told[0].message))


def refused():
    import case_03a
    import control_arm
    m, arm = case_03a.Model(), control_arm.Model()
    x = m.initial
    refuses('a state off the constraints', ValueError, ['linear', 'on the constraints', 'project'],
            m.linear, 0, x + 0.1)
    refuses('an unknown option', TypeError, ['linear: argument reduce ', 'did you mean reduced'],
            m.linear, 0, x, reduce='auto')
    refuses('an unknown state', ValueError, ['reduced: expected', 'found', 'did you mean'],
            m.linear, 0, x, reduced='tetha', start='project')
    refuses('too many independent states', ValueError, ['do not determine the motion here'],
            m.linear, 0, x, reduced=list(m.coordinates), start='project')
    refuses('a part of the coordinates of a tree', ValueError, ['without constraints all', 'q2'],
            arm.linear, 0, arm.initial, reduced='q1')
    refuses('a coordinate on which something depends', ValueError,
            ['q1 cannot be dropped: the rate of q1_d depends on it'],
            arm.linear, 0, [0.4, -0.7, 0, 0], drop='q1')
    refuses('a coordinate that is none', ValueError, ['drop: expected "running"', "'q3'"],
            arm.linear, 0, arm.initial, drop=['q3'])
    refuses('a state that is too short', ValueError, ['x: expected 4 numbers'],
            arm.linear, 0, arm.initial[:3])
    refuses('an equilibrium that is none', ArithmeticError,
            ['no equilibrium found near the guess', 'acceleration of q1_d = -', 'rad/s^2',
             'these inputs act on it: t1, t2, push'],
            arm.trim, [0.4, -0.7], hold=['q1', 'q2'])
    refuses('an input that is none', ValueError,
            ["free: expected the name of an input; found 'T1'; did you mean t1"],
            arm.trim, x[:2], free='T1')
    refuses('names that are none', ValueError, ['hold: expected names; found 1'],
            arm.trim, x[:2], hold=1)
    refuses('a tolerance that is none', ValueError, ['tolerance: expected', '2'],
            arm.trim, x[:2], tolerance=2)

    refuses('speeds that are none', ValueError, ['campbell: speeds: expected finite numbers'],
            arm.campbell, [0, 0], 'q1', [1, np.nan])
    refuses('a coordinate that spins and is none', ValueError, ["spin: expected", "'q3'"],
            arm.campbell, [0, 0], 'q3', [1])
    refuses('matrices off the constraints', ValueError, ['case_03a.mck', 'on the constraints'],
            m.mck, 0, m.initial + 0.1)
    refuses('names of matrices that are none', ValueError, ['case_03a.mck', 'reduced: expected'],
            m.mck, 0, m.initial, reduced='tetha', start='project')

    import reach_puma
    import reach_crank
    m = reach_puma.Model()
    refuses('a tool that is none', ValueError, ["unknown point 'tol'; did you mean tool"],
            m.reach, 'tol', [0, 0, 0])
    refuses('axes that are no rotation', ValueError, ['axes of pose 0', 'rotation matrix', 'det 8'],
            m.reach, 'tool', [0.3, 0, 0.5], 2 * np.eye(3))
    refuses('places of another shape', ValueError, ['P: expected places', '(2,)'],
            m.reach, 'tool', [0, 0])
    refuses('a branch that is none', ValueError, ['branch: expected one of the 8 branches', '9'],
            m.reach, 'tool', [0.3, 0, 0.5], np.eye(3), branch=9)
    refuses('axes of a point', ValueError, ['pin is a point, not a frame'],
            reach_crank.Model().reach, 'pin', [0.3, 0, 0], np.eye(3))
    refuses('an unknown option', TypeError, ['argument limit is unknown', 'did you mean limits'],
            m.reach, 'tool', [0, 0, 0], limit=0)


with open(sys.argv[1], encoding='utf-8') as file:
    FOUND = json.load(file)
for part, beside in (('linear', beside_octave), ('trim', trim_beside_octave),
                     ('modes', modes_beside_octave), ('reach', reach_beside_octave),
                     ('campbell', campbell_beside_octave), ('assemble', assembly_beside_octave)):
    for scene, models in FOUND[part].items():
        for one in [models] if isinstance(models, dict) else models:
            beside(scene, one)
            if 'mck' in one:
                mck_beside_octave(scene, one)
shapes()
pendulum()
assembly()
refused()
