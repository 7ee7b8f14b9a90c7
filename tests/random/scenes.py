"""Scenes made by chance: the mechanism of the independent formulation and the text of the scene."""
import math
import random
import numpy as np
import devices
import electric
import fluids
import signals
from beside import add_beside
from points import add_points
from elements import (Expression, Stand, Force, Gyroscope, Spring, Damper, Device, Law, Holonomic,
                      OfSpeeds, Rolling, ratio)
from joints import AXES, Joint, rodrigues
from ways import card
from mechanics import GROUND, Mechanism, State, closed, closing_rows

TYPES = ['revolute']*5 + ['prismatic']*3 + [
    'helical', 'cylindrical', 'universal', 'planar', 'spherical', 'fixed', 'free'
]
CUT_TYPES = [
    'revolute', 'prismatic', 'helical', 'cylindrical', 'universal', 'planar', 'spherical', 'fixed',
    'spherical'
]
LINEAR = [fluids.hydraulic_cylinder, fluids.pneumatic_cylinder, fluids.bellows]
# cards of the deck from which the first device of a scene comes; those that need a shaft that turns
TURNING = {
    devices.dc_motor: 3, devices.geared_motor: 5, devices.pmsm: 1, devices.controlled: 1,
    electric.warm_motor: 2, electric.synchronous: 3, electric.stepping_motor: 4,
    electric.induction_motor: 4, fluids.hydraulic_motor: 4, fluids.pneumatic_motor: 2,
    signals.axis: 8, signals.computer: 4
}
ANY = {
    devices.drive: 1, devices.rubbing: 2, devices.stop: 1, devices.duffing: 1,
    fluids.hydraulic_cylinder: 2, fluids.pneumatic_cylinder: 1, fluids.bellows: 1
}
KINDS = ['tree']*9 + ['loop']*7 + ['rolling']*2 + ['constrained']*2


def listed(numbers):
    return '[' + ', '.join(numbers) + ']'


def exact(x):
    return repr(float(x))


class Scene:
    """name, text, m: Mechanism, start: State, run: parameter values at run time, tags: what is in
    it"""

    def __init__(self, seed, compiled, plain=False, few=False):
        self.r, self.seed, self.compiled = random.Random(seed), seed, compiled
        self.plain = plain   # its literal equations are asked for: axes and angles that a paper has
        self.few = few       # links
        self.kind = self.r.choice(KINDS)
        self.name = 'r%s%d' % (self.kind[0], seed)
        self.m, self.parameters, self.run, self.tags, self.words = Mechanism(), {}, {}, {self.kind
                                                                                         }, []
        self.ranges = {}   # of states of devices that cannot be anywhere in -1 .. 1
        self.open, self.inputs, self.symbolic, self.redundant = [], [], self.r.choice(
            [0, .2, .5, 1]), self.r.random() < .3
        self.bodies_and_joints()
        self.closures()
        self.loads()
        add_beside(self)
        add_points(self)
        self.write()

    # -------------------------------------------------------------------------------------- numbers

    def number(self, lo, hi, zero=.15, fixed=False, digits=2):
        """text and value at run time; fixed: what it is in the scene too (a scene with loops must
        close as it stands)"""
        r = self.r
        v = 0. if r.random() < zero else round(r.uniform(lo, hi), digits)
        if r.random() < self.symbolic and len(self.parameters) < 12:
            n = 'p%d' % (len(self.parameters) + 1)
            keep = self.compiled or r.random() < .4 or (fixed and self.kind != 'tree')
            self.parameters[n], self.run[n] = v, v if keep else round(r.uniform(lo, hi), digits)
            return n, self.run[n]
        return ('%d/100' % round(v*100), round(v*100)/100) if v and r.random() < .2 else (repr(v),
                                                                                          v)

    def vector(self, lo, hi, zero=.35, fixed=False):
        t = [self.number(lo, hi, zero, fixed) for _ in range(3)]
        return listed([x[0] for x in t]), np.array([x[1] for x in t])

    def axis(self):
        if self.r.random() < .75 or self.plain:
            a = self.r.choice('xyz')
            return a, AXES[a]
        a = [self.r.randint(-3, 3) for _ in range(3)]
        a[2] += not any(a)
        return str(a), np.array(a, float)/np.linalg.norm(a)

    def rotation(self):
        """text and matrix of a list of turns; no text for none"""
        r, R, parts = self.r, np.eye(3), []
        for _ in range(r.choice([0, 0, 1, 1, 2])):
            a = r.choice('xyz')
            if r.random() < .5 or self.plain:
                k, d = r.choice([-2, -1, 1, 2, 3, 4]), r.choice([2, 2, 2 if self.plain else 6])
                text, v = '%d*%%pi/%d' % (k, d), k*math.pi/d
            else:
                text, v = self.number(-3, 3, fixed=True)
            parts.append('[%s, %s]' % (a, text))
            R = R @ rodrigues(AXES[a], v)
        return (listed(parts) if parts else None), R

    # ----------------------------------------------------------------------------- links and joints

    def bodies_and_joints(self):
        r, m = self.r, self.m
        text, m.gravity = self.vector(-9.9, 9.9, .3)
        self.words.append('gravity = ' + text)
        many = [1, 1, 2, 2, 2, 3, 3, 4, 5] if self.kind == 'tree' else [2, 2, 2, 2, 3, 3, 4]
        n = r.choice([k for k in many if k < 3] if self.few else many)
        light = r.randint(1, n - 1) if n > 2 and r.random() < .1 else 0
        for b in range(1, n + 1):
            self.link('b%d' % b, b == light)
        for b in range(1, n + 1):
            near = GROUND if b == 1 else 'b%d' % r.randint(max(1, b - 2), b - 1)
            parent = near if r.random() < .8 else GROUND
            ends = [parent, 'b%d' % b]
            if r.random() < .25:
                ends.reverse()
                self.tags.add('towards ground')
            self.joint('J%d' % b, r.choice(TYPES if b != light else ['revolute', 'prismatic']),
                       ends)
        m.number()
        if not m.nu:
            self.kind = 'tree'

    def link(self, name, light):
        r = self.r
        if light:
            self.tags.add('without mass')
            self.m.links.append({
                'name': name, 'm': 0., 'centre': np.zeros(3), 'I': np.zeros((3, 3)), 'text':
                'link(%s, mass = 0)' % name
            })
            return
        (mass, m), (centre, c) = self.number(.2, 4, 0), self.vector(-.5, .5)
        I, text = self.inertia()
        text = 'link(%s, mass = %s, centre = %s, inertia = %s)' % (name, mass, centre, text)
        self.m.links.append({'name': name, 'm': m, 'centre': c, 'I': I, 'text': text})

    def inertia(self):
        """of points by chance, in one of three forms"""
        r = self.r
        points = np.array([[round(r.uniform(-.5, .5), 2) for _ in range(3)] for _ in range(3)])
        points = points @ points.T
        I = np.round(np.trace(points)*np.eye(3) - points + .02*np.eye(3), 4)
        form = r.choice(['three', 'six', 'matrix'])
        if form == 'matrix':
            rows = ', '.join(listed([exact(x) for x in row]) for row in I)
            return I, 'matrix(%s)' % rows
        if form == 'three':
            I = np.diag(np.diag(I))
            return I, listed([exact(x) for x in np.diag(I)])
        return I, listed([exact(x) for x in I[[0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]])

    def joint(self, name, type, ends):
        r, j = self.r, Joint(name, type, *ends)
        o = j.options
        if r.random() < .8:
            o['at'], j.at = self.vector(-.6, .6, fixed=True)
        if r.random() < .5:
            o['child_at'], j.child_at = self.vector(-.6, .6, fixed=True)
        for word, chance in (('rotation', .5), ('child_rotation', .35)):
            text, R = self.rotation()
            if text and r.random() < chance:
                o[word] = text
                j.R, j.child_R = (R, j.child_R) if word == 'rotation' else (j.R, R)
        self.axes_of(j)
        n = j.nq()
        named = n and r.random() < .5
        j.names = ['c%s%d' % (name.lower(), i) for i in range(n)] if named else default_names(j)
        if named:
            o['coordinates' if n > 1 or r.random() < .3 else 'coordinate'] = \
                listed(j.names) if n > 1 or 'coordinates' in o else j.names[0]
            if 'coordinates' in o and n == 1:
                o['coordinates'] = listed(j.names)
        self.m.joints.append(j)
        self.tags.add(type)
        return j

    def axes_of(self, j):
        r, o = self.r, j.options
        if j.type in ('revolute', 'prismatic', 'helical', 'cylindrical'):
            o['axis'], j.axis = self.axis()
        if j.type == 'planar':
            o['axis'] = r.choice('xyz')
            j.axis = AXES[o['axis']]
        if j.type == 'universal':
            o['axis'], o['second_axis'] = r.sample('xyz', 2)
            j.axis, j.second = AXES[o['axis']], AXES[o['second_axis']]
        if j.type == 'helical':
            o['pitch'], j.pitch = self.number(.05, .3, 0, True, 3)
        if j.type in ('spherical', 'free') and r.random() < .5:
            j.orientation = r.choice(['xyz', 'zyx', 'zxz', 'yxz', 'xzx'])
            o['orientation'] = listed(list(j.orientation))

    # ------------------------------------------------------------------------------------ positions

    def position(self, j):
        """of a joint, not near the singularity of its angles"""
        r, q = self.r, []
        for k, letter in enumerate(j.letters()):
            if letter == 'b':
                e = np.array([r.gauss(0, 1) for _ in range(4)])
                q += list(e/np.linalg.norm(e))
            else:
                q.append(r.uniform(-.5, .5) if letter == 's' else r.uniform(-math.pi, math.pi))
        if j.orientation:
            zero = 0 if j.orientation[0] != j.orientation[2] else math.pi/2
            q[-2] = r.choice([0, math.pi]) + zero + r.uniform(-1.1, 1.1)
        return np.array(q)

    def somewhere(self):
        m = self.m
        q = np.concatenate([[]] + [self.position(j) for j in m.tree])
        return State(0., q, np.zeros(m.nu), {}, {}, {})

    def closures(self):
        m = self.m
        self.start = self.somewhere()
        if self.kind == 'loop':
            for k in range(self.r.choice([1, 1, 1, 2])):
                self.close_loop('L%d' % (k+1))
        if self.kind == 'rolling':
            self.roll()
        if self.kind == 'constrained' or self.r.random() < .1:
            self.constrain()
        if self.r.random() < (.3 if self.kind == 'loop' else .12):
            self.drive_coordinate()
        m.number()
        self.start.u = np.zeros(m.nu)
        if m.cuts or m.conditions:
            for j in m.tree:
                if j.nq():
                    q = [exact(x) for x in self.start.q[m.q_of[j.name]]]
                    j.options['start'] = q[0] if len(q) == 1 else listed(q)

    def independent(self, more):
        """whether the mechanism still moves, the rank of its rows is beyond doubt, and the last
        condition is no consequence"""
        m = self.m
        m.number()
        s = State(0., self.start.q, np.zeros(m.nu), self.start.own, {}, {})
        _, G, _ = closing_rows(m, s, m.bodies(s))
        if not np.all(np.isfinite(G)):
            return False
        sv = np.linalg.svd(G, compute_uv=False)
        rank = int(np.sum(sv > .02*sv[0])) if len(sv) else 0
        doubt = rank < len(sv) and sv[rank] > 1e-9*sv[0]
        new = len(m.conditions[-1].rows(m, s, m.bodies(s)).gamma) if m.conditions else 0
        before = np.linalg.svd(G[:len(G) - new], compute_uv=False)
        depends = new and rank - int(np.sum(before > .02*sv[0])) < new
        redundant = rank < len(G)
        if doubt or depends or G.shape[1] - rank < more or (redundant
                                                            and not (m.cuts and self.redundant)):
            return False
        self.tags |= {'redundant'} if redundant else set()
        return True

    def close_loop(self, name):
        r, m = self.r, self.m
        for _ in range(25):
            state, count = list(self.start.own), len(m.joints)
            ends = r.sample([GROUND] + [l['name'] for l in m.links], 2)
            keep = dict(self.parameters), dict(self.run)
            j = self.joint(name, r.choice(CUT_TYPES), ends)
            self.place_cut(j)
            if self.independent(0 if r.random() < .2 else 1):
                self.tags.add('cut ' + j.type)
                return
            m.joints.pop()
            del self.start.own[name]
            self.parameters, self.run = keep
        m.number()

    def place_cut(self, j):
        """its place in the child such that the loop closes where the tree stands"""
        m, o = self.m, j.options
        j.orientation, j.cut, o['cut'] = None, True, 'true'
        for word in ('orientation', 'coordinate', 'coordinates', 'child_at', 'child_rotation'):
            o.pop(word, None)
        j.names = default_names(j)
        m.number()
        bodies = m.bodies(self.start)
        P, C = bodies[j.parent], bodies[j.child]
        j.child_at, j.child_R = np.zeros(3), np.eye(3)
        q = self.position(j)
        c = j.relative(q, np.zeros(j.nu()))
        R, p = P.R @ c.R, P.p + P.R @ c.p
        j.child_R, j.child_at = C.R.T @ R, C.R.T @ (p - C.p)
        o['child_rotation'] = 'matrix(%s)' % ', '.join(
            listed([exact(x) for x in row]) for row in j.child_R)
        texts = [exact(x) for x in j.child_at]
        if self.symbolic and self.r.random() < .5:
            names = ['w%s%d' % (j.name[1:], i) for i in range(3)]
            self.parameters.update(zip(names, map(float, j.child_at)))
            self.run.update(zip(names, map(float, j.child_at)))
            texts = names
        o['child_at'] = listed(texts)
        self.start.own[j.name] = (q, np.zeros(j.nu()))

    def roll(self):
        """a disc of one link on a plane of another or of ground, placed so that it touches"""
        r, m = self.r, self.m
        for _ in range(25):
            plane, disc = r.sample([GROUND] + [l['name'] for l in m.links], 2)
            if disc != GROUND and self.roll_on(plane, disc):
                self.tags.add('rolls')
                return

    def roll_on(self, plane, disc):
        r, m = self.r, self.m
        (normal, n), (axis, a) = self.axis(), self.axis()
        centre, c = self.vector(-.5, .5, fixed=True)
        one = Rolling(plane, np.zeros(3), n, disc, c, a, round(r.uniform(.2, .8), 2))
        m.number()
        self.start.u = np.zeros(m.nu)
        bodies = m.bodies(self.start)
        P, D = bodies[plane], bodies[disc]
        if abs((P.R @ n) @ (D.R @ a)) > .95:
            return False
        one.at = P.R.T @ (D.p + D.R @ c + one.contact(bodies)[0] - P.p)
        m.conditions.append(one)
        if not self.independent(1):
            m.conditions.pop()
            return False
        word = 'rolling(roll, %s, %s, at = %s, child_at = %s, normal = %s, axis = %s, radius = %r)'
        at = listed([exact(x) for x in one.at])
        self.words.append(word % (plane, disc, at, centre, normal, axis, one.radius))
        return True

    def ordinary(self):
        """[(coordinate, letter, joint)] that are no Euler parameters"""
        return [(n, k, j) for j in self.m.tree if 'b' not in j.letters()
                for n, k in zip(j.names, j.letters())]

    def coordinate(self, name):
        return float(self.start.q[self.m.names().index(name)])

    def constrain(self):
        r, m = self.r, self.m
        m.number()
        if len(self.ordinary()) < 3 - (self.kind == 'constrained'):
            return
        for _ in range(10):
            (x, k, _), (y, l, _) = r.sample(self.ordinary(), 2)
            if (k == 's') != (l == 's'):  # lengths and angles do not add up
                continue
            a, b, d = r.choice([1., -2., .5]), r.choice([1., .7, -1.3]), r.choice([0., .4])
            if r.random() < .5:
                d *= k != 's'
                q = self.coordinate(x), self.coordinate(y)
                one, word = Holonomic(x, y, a, b, d, a*q[0] + b*q[1] + d*q[0]*q[1]), 'holonomic'
            else:
                one, word = OfSpeeds(x, y, a, b, d, ratio(x, k)), 'of speeds'
            m.conditions.append(one)
            if self.independent(1):
                self.words.append('constraint(own%d, %s)' % (len(m.conditions), one.text))
                self.tags.add(word)
                return
            m.conditions.pop()

    def drive_coordinate(self):
        """by a law of time that starts where the mechanism stands"""
        r, m = self.r, self.m
        m.number()
        for _ in range(6 if self.ordinary() else 0):
            name, _, j = r.choice(self.ordinary())
            law = Law(name, self.coordinate(name), round(r.uniform(-1, 1), 2), .3,
                      float(r.randint(1, 4)))
            m.conditions.append(law)
            if self.independent(0 if r.random() < .3 else 1):
                if r.random() < .5 and j.nq() == 1:
                    j.options['motion'] = law.text
                else:
                    self.words.append('motion(law%d, coordinate = %s, law = %s)' %
                                      (len(m.conditions), name, law.text))
                self.tags.add('driven')
                return
            m.conditions.pop()

    # ---------------------------------------------------------------------------------------- loads

    def loads(self):
        r, m = self.r, self.m
        m.number()
        for j in m.tree:
            if j.nq() and 'b' not in j.letters() and r.random() < .3:
                self.rub(j)
        for k in range(r.choice([0, 1, 1, 2])):
            self.force('F%d' % k)
        for k in range(r.choice([0, 0, 1, 2])):
            self.spring('S%d' % k)
        for k in range(r.choice([0, 1, 1, 1, 2])):
            self.device('D%d' % k)
        if r.random() < .12 and len(self.ordinary()) > 1 and self.kind != 'rolling':
            self.mix()

    def rub(self, j):
        f = [self.number(.05, .5, 0) for _ in range(j.nq())]
        j.options['friction'] = f[0][0] if len(f) == 1 else listed([x[0] for x in f])
        self.m.elements += [Damper(Stand(n), x[1]) for n, x in zip(j.names, f)]
        self.tags.add('friction of joints')

    def formula(self):
        r, o = self.r, self.ordinary()
        kind = r.choice(['number', 'number', 'input', 'time', 'coordinate'])
        if kind == 'input':
            self.inputs.append('v%d' % (len(self.inputs) + 1))
            return Expression(self.inputs[-1])
        if kind == 'time':
            return Expression('2*sin(3*t)')
        if kind == 'coordinate' and o:
            (x, k, _), y = r.choice(o), r.choice(o)[0]
            return Expression('3*sin(%s) - 0.5*%s_d + 0.7*%s*%s' % (ratio(x, k), y, x, y))
        return Expression(repr(round(r.uniform(-5, 5), 2)))

    def force(self, name):
        r, m = self.r, self.m
        link, kind = r.choice(m.links)['name'], r.choice(
            ['force', 'torque', 'force', 'gyroscope', 'gyroscope'])
        self.tags.add(kind)
        if kind == 'gyroscope':
            (axis, a), (text, h) = self.axis(), self.number(.3, 2, 0)
            m.elements.append(Gyroscope(link, a, h))
            self.words.append(
                'gyroscope(%s, %s, axis = %s, momentum = %s)' % (name, link, axis, text))
            return
        vector, frame, at, point = [self.formula() for _ in range(3)], r.choice(
            ['ground', 'link']), '', np.zeros(3)
        if kind == 'force' and r.random() < .7:
            text, point = self.vector(-.5, .5)
            at = ', at = ' + text
        m.elements.append(Force(link, frame, point, vector, kind == 'torque'))
        word = ', frame = ' + frame if frame == 'link' or r.random() < .3 else ''
        self.tags.add(kind + ' in axes of ' + frame)
        self.words.append(
            '%s(%s, %s, vector = %s%s%s)' % (kind, name, link, listed([e.text
                                                                       for e in vector]), at, word))

    def ends(self):
        """text and data of two points that are not near each other"""
        r, names = self.r, [GROUND] + [l['name'] for l in self.m.links]
        a, b = r.sample(names, 2)
        (at, p), (to, q) = self.vector(-.9, .9, .1), self.vector(-.9, .9, .1)
        return 'parent = %s, at = %s, child = %s, child_at = %s' % (a, at, b, to), ((a, p), (b, q))

    def at_coordinate(self, some=None):
        """text, name and letter of a coordinate of a joint"""
        name, letter, j = self.r.choice(some or self.ordinary())
        more = ', coordinate = ' + name if j.nq() > 1 or self.r.random() < .3 else ''
        return 'joint = %s%s' % (j.name, more), name, letter

    def spring(self, name):
        r, kind = self.r, self.r.choice(['spring', 'damper'])
        if self.ordinary() and r.random() < .5:
            where, x, _ = self.at_coordinate()
            stand = Stand(x)
            self.tags.add(kind + ' at a joint')
        else:
            where, ends = self.ends()
            stand = Stand(ends=ends)
            self.tags.add(kind + ' between points')
        (text, k), (at, rest) = self.number(1, 20, 0), self.number(-.5, .5)
        if kind == 'spring':
            self.words.append('spring(%s, %s, stiffness = %s, rest = %s)' % (name, where, text, at))
            self.m.elements.append(Spring(stand, k, rest))
        else:
            self.words.append('damper(%s, %s, damping = %s)' % (name, where, text))
            self.m.elements.append(Damper(stand, k))

    def device(self, name):
        r = self.r
        wish = card({**TURNING, **ANY}, self.seed, 'device') if name == 'D0' else None
        where, stand, letter, measured = self.stand(wish in TURNING)
        turning = letter and letter != 's'
        make = r.choice(list(TURNING if turning and r.random() < .7 else ANY))
        if wish in ANY or turning and wish:
            make = wish
        if (turning or stand.angle) and make in LINEAR:  # an arm, from the angle to the length
            where, stand.ratio = where + ', ratio = 1.5', 1.5
        elif turning and make in TURNING and r.random() < .5:
            stand.ratio = r.choice([3., -2.5])
            where += ', ratio = %r' % stand.ratio
        self.source.__func__.measured = measured
        self.source.__func__.turn = ratio(measured, letter)
        machine = make(r, name, where, self.source)
        machine.given = {k: Expression(e) for k, e in machine.given.items()}
        self.m.elements.append(Device(machine, stand))
        self.words += machine.words
        self.ranges.update(machine.ranges)
        for w in machine.words:
            kind, variant = w.split('(')[0], w.split('variant = ')
            if kind != 'output':
                self.tags.add('device ' + kind)
                self.tags.add('variant %s %s' % (kind, variant[1].split(',')[0].rstrip(')')
                                                 if variant[1:] else 'full'))

    def stand(self, turning):
        """text and data of where a device stands; letter and name of the joint's coordinate;
        turning: on one that turns if there is any"""
        r, o = self.r, self.ordinary()
        shafts = [one for one in o if one[1] != 's'] if turning else []
        way = 'joint' if shafts else r.choice(['joint', 'joint', 'joint', 'ends', 'length'])
        if way == 'joint' and o:
            where, x, letter = self.at_coordinate(shafts or o)
            self.tags.add('device on a joint')
            return where, Stand(x), letter, x
        if way == 'length' and len(o) > 1:
            (x, kind, _), (y, _, _) = r.sample(o, 2)
            a, b = r.choice([1., -2.]), r.choice([0., .5])
            self.tags.add('device on an expression')
            stand = Stand(form=(x, y, a, b))
            stand.angle = kind != 's'
            return 'length = %r*%s + (%r)*%s*%s' % (a, x, b, x, y), stand, '', ''
        where, ends = self.ends()
        self.tags.add('device between points')
        return where, Stand(ends=ends), '', ''

    def source(self, r, word, name):
        """option and formula of an input of a device: of the scene's own, a formula, or left
        open"""
        kind = r.choice(['open', 'input', 'formula'])
        if kind == 'open':
            self.open.append(name + '_' + word)
            return '', {}
        if kind == 'input':
            self.inputs.append('v%d' % (len(self.inputs) + 1))
            return ', %s = %s' % (word, self.inputs[-1]), {name + '_' + word: self.inputs[-1]}
        text = '2*sin(%d*t) + 0.5' % r.randint(1, 3)
        return ', %s = %s' % (word, text), {name + '_' + word: text}

    def mix(self):
        """two speeds of the scene's own in place of two rates"""
        (x, k, _), (y, _, _) = self.r.sample(self.ordinary(), 2)
        a, b = round(self.r.uniform(-.5, .5), 2), round(self.r.uniform(-.5, .5), 2)
        self.m.mixing = (x, y, a, b)
        self.words.append('speeds = [mix1 = %s_d + (%r)*%s_d, mix2 = %s_d + (%r)*sin(%s)*%s_d]' %
                          (x, a, y, y, b, ratio(x, k), x))
        self.tags.add('speeds of its own')

    # ----------------------------------------------------------------------------------------- text

    def write(self):
        r, m = self.r, self.m
        links = [l['text'] for l in m.links]
        r.shuffle(links)  # the order of links need not be the tree's
        texts = links
        for j in m.joints:
            o = list(j.options.items())
            r.shuffle(o)
            texts.append(
                '%s(%s, %s, %s%s)' % (j.type, j.name, j.parent, j.child, ''.join(', %s = %s' % x
                                                                                 for x in o)))
        self.reactions = r.random() < .5
        if self.reactions:
            texts += ['output(r_%s, reaction(%s))' % (j.name, j.name) for j in m.joints]
        if self.ordinary():
            x = r.choice(self.ordinary())[0]
            texts.append('output(y0, 2*%s + %s_d)' % (x, x))
            self.output = Expression('2*%s + %s_d' % (x, x))
        texts += self.words + ['input(%s, unit = 1)' % n for n in self.inputs]
        if self.parameters:
            texts.append('parameters = ' + listed(['%s = %r' % x for x in self.parameters.items()]))
        self.text = 'scene : gsmbp_scene("%s",\n  %s)$\n' % (self.name, ',\n  '.join(texts))


def default_names(j):
    n, first = j.nq(), 0 if j.type == 'spherical' and not j.orientation else 1
    return ['q_' + j.name] if n == 1 else ['q_%s%d' % (j.name, k) for k in range(first, n + first)]
