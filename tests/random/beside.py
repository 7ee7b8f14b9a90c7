"""Ports that stick or hit a stop, and sensors of reactions.

They are drawn from a stream of their own, behind everything else: without them a scene is what it
was. A holder has name, kind, k: its numbers, and a mode that the scene knows as a hidden input.
"""
import math
import random
import numpy as np
from devices import Machine, Result, options
from elements import Device
from signals import sensed

COMPONENTS = {'force_sensor': (1, 2, 3), 'torque_sensor': (4, 5, 6)}
AXES = ['', ', ground', ', parent', ', child']


class Holder:
    """friction that sticks where its mode is 0; stops, of which one is in contact where it is
    not"""

    def __init__(self, name, kind, k):
        self.name, self.kind, self.k = name, kind, k
        self.mode = name + '_mode'

    def holds(self, mode):
        return (mode == 0) == (self.kind == 'friction')

    def event(self, mode, s, w, effort):
        """the event function: above 0 until something happens"""
        k = self.k
        if self.kind == 'friction':
            return k['Fs'] - abs(effort) if mode == 0 else mode*w + 1e-9*k['vs']
        if mode == 0:
            return (k['hi'] - s)*(s - k['lo'])/(k['hi'] - k['lo'])
        return -mode*effort


def sticking(r, name, stand):
    k = {'Fc': .8, 'Fs': round(r.uniform(.9, 2), 2), 'Fv': .3, 'vs': .9}

    def at(x, v, s, w):
        mode = v[name + '_mode']
        dry = k['Fc'] + (k['Fs'] - k['Fc'])*math.exp(-(w/k['vs'])**2)
        return Result(passive=-mode*dry - k['Fv']*w, lost=mode*dry*w + k['Fv']*w*w)

    return held_machine('friction', name, stand, k, at)


def rigid_stop(r, name, stand):
    k = {'lo': round(r.uniform(-.9, -.1), 2), 'hi': .4, 'e': .6, 'vr': .01}
    return held_machine('stop', name, stand, k, lambda x, v, s, w: Result())


def held_machine(kind, name, stand, k, at):
    text = '%s(%s, %s%s, variant = event)' % (kind, name, stand, options(k))
    machine = Machine([text], [], at, {})
    machine.holder, machine.held = Holder(name, kind, k), [name + '_mode']
    return machine


class ReactionSensor:
    """a sensor of one component of the reaction of a joint, in axes of ground or of a link"""

    def __init__(self, r, name, j):
        self.name, self.joint = name, j.name
        kind, axes = r.choice(list(COMPONENTS)), r.choice(AXES)
        self.k = r.choice(COMPONENTS[kind])
        self.link = {', parent': j.parent, ', child': j.child}.get(axes, 'ground')
        measure = 'reaction(%s%s)[%d]' % (j.name, axes, self.k)
        text, self.law = sensed(r, kind, name, measure)
        self.words = [text, 'output(o_%s, %s)' % (name, name)]
        self.tags = {'sensor of a reaction', 'device ' + kind}

    def load(self, m, s, bodies, loads):
        pass

    def read(self, s, bodies, solution):
        """rates and signals, behind the solution; nan where the reaction is not unique"""
        parts = solution.reactions[self.joint].reshape(2, 3) @ bodies[self.link].R
        measure = float('nan') if solution.missing else parts.flat[self.k - 1]
        loads = solution.loads
        loads.signals['o_' + self.name] = self.law(s.x, {self.name + '_measure': measure},
                                                   loads.rates)


def add_holders(scene, r):
    for k in range(r.choice([1, 1, 2])):
        where, stand, letter, _ = scene.stand(False)
        if letter and r.random() < .4:
            stand.ratio = r.choice([3., -2.5])
            where += ', ratio = %r' % stand.ratio
        machine = r.choice([sticking, rigid_stop])(r, 'E%d' % k, where)
        scene.m.elements.append(Device(machine, stand))
        scene.words += machine.words
        scene.tags |= {'device ' + machine.holder.kind, 'variant %s event' % machine.holder.kind}


def add_sensors(scene, r):
    joints = [j for j in scene.m.joints if not (j.cut and j.type == 'helical')]
    for k in range(r.choice([1, 1, 2])):
        one = ReactionSensor(r, 'R%d' % k, r.choice(joints))
        scene.m.elements.append(one)
        scene.words += one.words
        scene.tags |= one.tags


def add_beside(scene):
    r = random.Random('beside %d' % scene.seed)
    events, sensors = r.random() < .2, r.random() < .2
    kept, scene.r = scene.r, r
    if events and scene.m.nu:
        add_holders(scene, r)
    if sensors and scene.m.joints:
        add_sensors(scene, r)
    scene.r = kept


def holders(m):
    """[(holder, stand)]"""
    return [(e.machine.holder, e.stand) for e in m.elements
            if hasattr(getattr(e, 'machine', None), 'holder')]


def draw_modes(m, s, r, rows):
    """modes of all holders by chance; a port is held only where that is independent of the rows
    and of the ports held before. rows: of loops and conditions on the speeds at s"""
    bodies, n = m.bodies(s), m.nu + m.n_own
    rows = np.reshape(rows, (-1, n))
    for holder, stand in holders(m):
        mode = r.choice([-1., 0., 1.])
        if holder.holds(mode):
            g = np.zeros(n)
            g[:m.nu] = stand.port(m, s, bodies).in_tree(bodies)[0]
            if beyond(rows, g):
                rows = np.vstack([rows, g])
            else:
                mode = 1. if holder.kind == 'friction' else 0.
        s.v[holder.mode] = mode


def beyond(rows, g):
    """whether a good part of the row g is none of the others'"""
    if np.linalg.norm(g) < 1e-6:
        return False
    if len(rows):
        _, sv, V = np.linalg.svd(rows)
        free = V[int(np.sum(sv > 1e-9*sv[0])):]
    else:
        free = np.eye(len(g))
    return np.linalg.norm(free @ g) > .1*np.linalg.norm(g)
