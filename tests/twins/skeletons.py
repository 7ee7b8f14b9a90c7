"""Mechanisms by chance, on which features are put: trees, loops, rolling discs, flying bodies."""
import random
from fractions import Fraction
from scene import GROUND, PLAIN, Element, Scene
from values import (Quantity, Rotation, any_rotation, identity, product, transposed, turned,
                    vector)

AXES = ['x', 'y', 'z', 'z', '[1, 2, 2]', '[0, 3, -4]']


class Builder:
    """a scene and what features may stand on: links, `simple`: coordinates (name, 'r' or 'm',
    joint) with a plain rate"""

    def __init__(self, seed, name):
        self.r, self.scene = random.Random(seed), Scene(name)
        self.links, self.simple, self.count = [], [], 0
        self.states = {}  # their ranges
        self.scene.gravity = self.place(9, 'm/s^2')

    def number(self, low, high, unit='', digits=2):
        return Quantity(round(self.r.uniform(low, high), digits), unit)

    def place(self, size=.5, unit='m'):
        return [self.number(-size, size, unit) for _ in range(3)]

    def named(self, word):
        self.count += 1
        return '%s%d' % (word, self.count)

    def put(self, word, name, ends=(), /, **options):
        """an element; some numbers become parameters"""
        for k, v in options.items():
            if isinstance(v, Quantity) and k != 'length' and self.r.random() < .3:
                options[k] = self.parameter(v)
        e = Element(word, name, ends, **options)
        self.scene.elements.append(e)
        return e

    def parameter(self, q):
        name = self.named('par')
        self.scene.parameters[name] = Quantity(q.value, q.unit)
        return Quantity(q.value, q.unit, name)

    def link(self, mass=None, centre=None, inertia=None):
        """a link whose inertia a body of its size can have"""
        r = self.r
        name, m = self.named('L'), mass or self.number(.5, 4, 'kg')
        a = [r.uniform(.05, .4) for _ in range(3)]
        I = [round(a[1] + a[2], 3), round(a[0] + a[2], 3), round(a[0] + a[1], 3)]
        I += [round(r.uniform(-.02, .02), 3) for _ in range(3)]
        self.put('link', name, mass=m, centre=centre or self.place(.3),
                 inertia=inertia or vector(I, 'kg*m^2'))
        self.links.append(name)
        return name

    def joint(self, word, parent, child, **options):
        """with a place by chance unless it is given; returns its element"""
        r = self.r
        for key, odds in (('at', .9), ('child_at', .4)):
            if key not in options and r.random() < odds:
                options[key] = self.place()
        for key, odds in (('rotation', .4), ('child_rotation', .2)):
            if key not in options and r.random() < odds:
                options[key] = self.rotation()
        J = self.put(word, self.named('J'), [parent, child], **options)
        for name, kind in zip(J.coordinates(), PLAIN.get(word, '')):
            self.simple.append((name, kind, J))
        return J

    def rotation(self):
        axis = self.r.choice('xyz')
        if self.r.random() < .5:
            R = {'x': [[1, 0, 0], [0, 0, -1], [0, 1, 0]], 'y': [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
                 'z': [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}[axis]
            return Rotation([[Fraction(x) for x in row] for row in R], '[%s, %%pi/2]' % axis)
        return Rotation(any_rotation(self.r))

    def any_joint(self, parent, child, words):
        """one of the joints `words`, with what it needs"""
        r, word = self.r, self.r.choice(words)
        q = [self.named('q') for _ in range({'cylindrical': 2, 'universal': 2}.get(word, 1))]
        if word == 'universal':
            first, second = r.sample('xyz', 2)
            return self.joint(word, parent, child, axis=first, second_axis=second, coordinates=q)
        if word in ('spherical', 'free'):
            return self.ball(word, parent, child)
        options = {'axis': r.choice(AXES)}
        if word == 'helical':
            options['pitch'] = self.number(.05, .3, 'm/rad')
        if word == 'planar':
            return self.joint(word, parent, child, axis=r.choice('xyz'),
                              coordinates=q + [self.named('q'), self.named('q')])
        if word in ('revolute', 'prismatic') and r.random() < .3:
            options['friction'] = self.number(.1, 1)
        key = 'coordinates' if len(q) > 1 else 'coordinate'
        return self.joint(word, parent, child, **options, **{key: q if len(q) > 1 else q[0]})

    def ball(self, word, parent, child):
        r, places = self.r, [self.named('x') for _ in range(3 if word == 'free' else 0)]
        if r.random() < .6:
            return self.joint(word, parent, child, coordinates=places + [
                self.named('e') for _ in range(4)])
        first, second, third = r.sample('xyz', 3)
        angles = [self.named('a') for _ in range(3)]
        self.states[angles[1]] = (.3, .8) if third == first else (-.5, .5)
        return self.joint(word, parent, child, orientation=[first, second, third],
                          coordinates=places + angles)


def tree(b):
    """two or three links, each on one before it or on ground"""
    words = ['revolute']*4 + ['prismatic']*3 + ['universal', 'cylindrical', 'helical', 'spherical',
                                                'planar']
    for k in range(b.r.choice([2, 2, 3])):
        parent = b.r.choice(b.links or [GROUND])
        b.any_joint(parent, b.link(), words if k else words[:8])


def flying(b):
    """a free body with a link on it"""
    body = b.link()
    b.any_joint(GROUND, body, ['free'])
    b.any_joint(body, b.link(), ['revolute', 'prismatic', 'universal'])


def closed_chain(b):
    """links in a chain in space, whose last one a cut joint holds where it is at the start"""
    words = ['universal', 'spherical', 'cylindrical', 'revolute', 'prismatic']
    parent, poses = GROUND, {GROUND: ([Fraction(0)]*3, identity())}
    b.scene.closed = True
    for k in range(3):
        link = b.link()
        J = b.any_joint(parent, link, words[:3] if k < 2 else words)
        poses[link] = beyond(poses[parent], J.options)
        parent = link
    place, R = [Fraction(b.r.randint(-5, 5), 10) for _ in range(3)], any_rotation(b.r)
    word, first = b.r.choice(['spherical', 'universal', 'planar']), b.r.choice([GROUND, b.links[0]])
    places, ends = [('at', 'rotation'), ('child_at', 'child_rotation')], {}
    for link, (at, rotation) in zip((first, parent), places):
        p, A = poses[link]
        back = transposed(A)
        ends[at] = turned(back, [Quantity(x - y, 'm') for x, y in zip(place, p)])
        ends[rotation] = Rotation(product(back, R))
    axes = {'universal': {'axis': 'z', 'second_axis': 'x'}, 'planar': {'axis': 'z'}}
    b.joint(word, first, parent, cut='true', **ends, **axes.get(word, {}))


def beyond(pose, o):
    """place and axes of the child of a joint at rest, from those of its parent"""
    (p, A), zero = pose, [Quantity(0)]*3
    rotations = [o.get(k, Rotation(identity())).R for k in ('rotation', 'child_rotation')]
    R = product(product(A, rotations[0]), transposed(rotations[1]))
    at, own = turned(A, o.get('at', zero)), turned(R, o.get('child_at', zero))
    return [x + y.value - z.value for x, y, z in zip(p, at, own)], R


def lengths(b):
    """crank, coupler, rocker, ground of a four-bar that turns around"""
    return [Fraction(x) for x in b.r.choice([
        ('.1', '.32', '.28', '.36'), ('.15', '.4', '.35', '.45'), ('.12', '.5', '.4', '.5')])]


def bar(b, length):
    across = [b.number(-.05, .05, 'm') for _ in range(2)]
    return b.link(centre=[Quantity(length/2, 'm')] + across)


def along(length):
    return [Quantity(length, 'm'), Quantity(0), Quantity(0)]


def four_bar(b):
    """a plane four-bar, cut at the last hinge; its loop has redundant rows"""
    a, l, c, d = lengths(b)
    at, b.scene.closed = b.place(), True
    far = [Quantity(at[0].value + d, 'm')] + at[1:]
    crank, coupler, rocker = (bar(b, x) for x in (a, l, c))
    q = [b.named('q') for _ in range(3)]
    plain = {'rotation': Rotation(identity()), 'child_rotation': Rotation(identity()), 'axis': 'z'}
    b.joint('revolute', GROUND, crank, at=at, child_at=along(0), coordinate=q[0],
            start=b.number(.5, 1.2, 'rad'), **plain)
    b.joint('revolute', crank, coupler, at=along(a), child_at=along(0), coordinate=q[1],
            start=b.number(0, .2, 'rad'), **plain)
    b.joint('revolute', GROUND, rocker, at=far, child_at=along(0), coordinate=q[2],
            start=b.number(1.3, 1.6, 'rad'), **plain)
    b.joint('revolute', coupler, rocker, at=along(l), child_at=along(c), cut='true', **plain)


def parallelogram(b):
    """three equal cranks with one coupler: the third loop is redundant"""
    at, b.scene.closed = b.place(), True
    a, d = Fraction(str(round(b.r.uniform(.1, .3), 2))), Fraction('.4')
    plain = {'rotation': Rotation(identity()), 'child_rotation': Rotation(identity()), 'axis': 'z'}
    coupler, start = bar(b, 2*d), b.number(.5, 1.2, 'rad')
    for k in range(3):
        crank, place = bar(b, a), [Quantity(at[0].value + k*d, 'm')] + at[1:]
        b.joint('revolute', GROUND, crank, at=place, child_at=along(0), coordinate=b.named('q'),
                start=start, **plain)
        rest = {'cut': 'true'} if k else {'coordinate': b.named('q'),
                                          'start': Quantity(-start.value, 'rad')}
        b.joint('revolute', crank, coupler, at=along(a), child_at=along(k*d), **rest, **plain)


def slider_crank(b):
    """crank, rod on a ball in space, slider: cut at a ball of the slider"""
    a, l = Fraction('.1'), Fraction('.4')
    at, b.scene.closed = b.place(), True
    off = [Quantity(x.value + y, 'm') for x, y in zip(at, (0, 0, Fraction('.05')))]
    crank, rod, slider = bar(b, a), bar(b, l), b.link(centre=along(0))
    plain = {'rotation': Rotation(identity()), 'child_rotation': Rotation(identity())}
    b.joint('revolute', GROUND, crank, at=at, child_at=along(0), coordinate=b.named('q'), axis='z',
            start=b.number(.5, 1.2, 'rad'), **plain)
    b.joint('universal', crank, rod, at=along(a), child_at=along(0), axis='z', second_axis='y',
            coordinates=[b.named('q'), b.named('q')], start=vector([-.8, -.12], 'rad'), **plain)
    b.joint('prismatic', GROUND, slider, at=off, child_at=along(0), coordinate=b.named('q'),
            axis='x', start=b.number(.42, .46, 'm'), **plain)
    b.joint('spherical', rod, slider, at=along(l), child_at=along(0), cut='true', **plain)


def disc(b):
    """a disc that rolls on a plane, free in space or in its plane, with a link on it"""
    wheel, R, r = b.link(centre=along(0)), b.number(.2, .4, 'm'), b.r
    plain = {'rotation': Rotation(identity()), 'child_rotation': Rotation(identity()),
             'child_at': along(0)}
    b.scene.closed = True
    if r.random() < .5:
        x = [b.named('x') for _ in range(3)]
        b.joint('planar', GROUND, wheel, axis='z', coordinates=x, at=along(0),
                start=[Quantity(0), R, Quantity(0)], **plain)
        b.put('rolling', b.named('C'), [GROUND, wheel], axis='z', radius=R, normal='y')
    else:
        x = [b.named('x') for _ in range(7)]
        b.joint('free', GROUND, wheel, at=along(0), coordinates=x,
                start=[Quantity(0), Quantity(0), R, Quantity('.8'), Quantity('.6'), Quantity(0),
                       Quantity(0)], **plain)
        b.put('rolling', b.named('C'), [GROUND, wheel], axis='z', radius=R, normal='z')
    b.any_joint(wheel, b.link(), ['revolute', 'prismatic'])


SKELETONS = {
    'tree': tree, 'flying body': flying, 'four-bar': four_bar, 'redundant loops': parallelogram,
    'slider-crank': slider_crank, 'rolling': disc, 'closed chain': closed_chain
}
