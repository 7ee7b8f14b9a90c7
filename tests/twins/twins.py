"""Twins of a scene: the same physics written otherwise. Each changes a copy of the scene, and adds
to the map what becomes of states and outputs."""
import re
from fractions import Fraction
from maps import Ball, Flight, Glide
from scene import GROUND, PLAIN, Element
from values import (OTHERS, Quantity, Rotation, any_rotation, identity, product, summed, transposed,
                    turned, vector)

AXES = {'x': (1, 0, 0), 'y': (0, 1, 0), 'z': (0, 0, 1)}
PLACES = {'parent': ('at', 'rotation'), 'child': ('child_at', 'child_rotation')}


def direction(value):
    """an axis as quantities"""
    if isinstance(value, str):
        value = AXES[value] if value in AXES else re.findall(r'-?\d+', value)
        return vector(value)
    return value


def zero():
    return vector([0, 0, 0], 'm')


def moved(at, R, p):
    """a place of the base, moved"""
    return [Quantity(x.value + y.value, 'm', x.text and '%s + (%s)' % (x.text, y.written()))
            for x, y in zip(turned(R, at), p)]


# ------------------------------------------------------------------------------------------- base

def base(scene, r, told):
    """everything that stands on ground is moved and turned; gravity turns with it"""
    R, p = any_rotation(r, 3), vector([round(r.uniform(-3, 3), 2) for _ in range(3)], 'm')
    scene.gravity = turned(R, scene.gravity)
    for e in scene.elements:
        if e.is_joint():
            for end, (at, rotation) in zip(e.ends, PLACES.values()):
                if end == GROUND:
                    on_base(e.options, at, rotation, R, p)
        elif e.word in ('force', 'torque') and e.options.get('frame') != 'link':
            e.options['vector'] = turned(R, e.options['vector'])
        elif e.word in ('point', 'frame') and e.ends == [GROUND]:
            on_base(e.options, 'at', 'rotation' if e.word == 'frame' else None, R, p)
        elif e.word == 'rolling':
            e.options['normal'] = turned(R, direction(e.options['normal']))
            e.options['at'] = moved(e.options.get('at', zero()), R, p)
        for end, (at, _) in PLACES.items():
            if e.options.get(end) == GROUND:
                on_base(e.options, at, None, R, p)
    in_old_axes(scene, R, p)
    told.base(R, p)


def on_base(options, at, rotation, R, p):
    options[at] = moved(options.get(at, zero()), R, p)
    if rotation:
        options[rotation] = options.get(rotation, Rotation(identity())).behind(R)


POINT = re.compile(r'(position|velocity|acceleration|angular_velocity)\((\w+)\)\[([123])\]')


def in_old_axes(scene, R, p):
    """components of points in expressions, as they were"""
    back = transposed(R)

    def one(found):
        word, point, k = found.group(1), found.group(2), int(found.group(3)) - 1
        new = ['%s(%s)[%d]' % (word, point, i + 1) for i in range(3)]
        if word == 'position':
            new = ['%s - (%s)' % (n, p[i].written()) for i, n in enumerate(new)]
        return summed(back[k], new)

    for e in scene.elements:
        for key in ('rest_', 'vector'):
            if key in e.options:
                e.options[key] = [POINT.sub(one, x) if isinstance(x, str) else x
                                  for x in e.options[key]]


# --------------------------------------------------------------------------------- reversed joints

def reverse(scene, r, told):
    """parent and child of joints swapped: their coordinates have the other sign. Some of those
    that can be"""
    able = [J for J in scene.joints() if J.word in PLAIN or J.word in ('fixed', 'spherical')
            or J.word in KINDS and alone(scene, J)]
    for J in r.sample(able, r.randint(1, len(able))) if able else []:
        o = J.options
        J.ends.reverse()
        for one, two in zip(*PLACES.values()):
            o[one], o[two] = o.get(two), o.get(one)
            for key in (one, two):
                if o[key] is None:
                    del o[key]
        told.reversed(J.name)
        # a cut joint that slides measures along axes of its parent
        told.other_rows |= 'cut' in o and J.word not in ('fixed', 'revolute', 'universal',
                                                         'spherical')
        if J.word in KINDS and 'orientation' not in o and J.coordinates():
            o.pop('start', None)
            told.balls.append(KINDS[J.word](J.name, J.coordinates()))
        else:
            signs_changed(scene, J, told)


# joints whose reversal does more than change signs
KINDS = {'spherical': Ball, 'free': Flight, 'planar': Glide}


def alone(scene, J):
    """no expression holds coordinates of the joint, and they are no angles in a row"""
    text = scene.text()
    return 'orientation' not in J.options and all(
        len(re.findall(r'\b%s(_d)?\b' % n, text)) == 1 for n in J.coordinates())


def signs_changed(scene, J, told):
    o = J.options
    names = J.coordinates()
    if J.word in ('universal', 'spherical') and 'orientation' in o or 'second_axis' in o:
        for key in ('coordinates', 'orientation', 'start'):
            if key in o:
                o[key] = o[key][::-1]
        o.update({'axis': o['second_axis'], 'second_axis': o['axis']} if 'second_axis' in o else {})
    if 'start' in o:
        o['start'] = negative(o['start'])
    if 'motion' in o:
        o['motion'] = '-(%s)' % o['motion']
    new = {n + end: '(-%s%s)' % (n, end) for n in names for end in ('', '_d', '_dd')}
    scene.expressions(lambda w: new.get(w, w))
    for e in scene.elements:
        if e.options.get('joint') == J.name or e.options.get('coordinate') in names:
            other_way(e)
        if e.word == 'event':
            e.options['rest_'][2] = reset_back(e.options['rest_'][2])
    told.signs.update({n + end: -1 for n in names for end in ('', '_d')})


def other_way(e):
    """an element on a coordinate that has the other sign"""
    o = e.options
    if e.word == 'spring' and 'rest' in o:
        o['rest'] = negative(o['rest'])
    elif e.word == 'motion':
        o['law'] = '-(%s)' % o['law']
    elif e.word not in ('spring', 'damper') and not e.is_joint():
        o['ratio'] = negative(o.get('ratio', Quantity(1)))


def negative(value):
    if isinstance(value, list):
        return [negative(x) for x in value]
    return Quantity(-value.value, value.unit, value.text and '-(%s)' % value.text)


def reset_back(action):
    return re.sub(r'reset\(\(-(\w+)\), (.*)\)$', r'reset(\1, -(\2))', action)


# ------------------------------------------------------------------------------- names and order

NAMES = ['a', 'Zeta', 'm', 'k', 'tau_', 'beta9', 'i', 'Nn', 'hub', 'u', 'o', 'w']


def rename(scene, r, told):
    """every name another one, everything in another order"""
    old = [e.name for e in scene.elements] + list(scene.parameters) + list(scene.inputs)
    old += list(scene.speeds) + [n for J in scene.joints() for n in J.coordinates()]
    numbers = r.sample(range(100, 999), len(old))
    new = {n: '%s%d' % (r.choice(NAMES), k) for n, k in zip(old, numbers)}
    told.names = new
    change = told.renamed
    for e in scene.elements:
        e.name, e.ends = new[e.name], [new.get(x, x) for x in e.ends]
        for key in ('coordinate', 'coordinates', 'joint'):
            if key in e.options:
                own = e.options[key]
                e.options[key] = [new[x] for x in own] if isinstance(own, list) else new[own]
    scene.expressions(change)
    scene.inputs = {new[n]: v for n, v in scene.inputs.items()}
    scene.speeds = {new[n]: v for n, v in scene.speeds.items()}
    scene.parameters = {new[n]: v for n, v in scene.parameters.items()}
    r.shuffle(scene.elements)
    for e in scene.elements:
        e.options = dict(r.sample(list(e.options.items()), len(e.options)))


# ------------------------------------------------------------------------------------------ units

def units(scene, r, told):
    """numbers in other units, some of them as parameters"""
    def other(value):
        if isinstance(value, list):
            return [other(x) for x in value]
        if not isinstance(value, Quantity) or value.text or value.unit not in OTHERS:
            return value
        return value.in_unit(*r.choice(OTHERS[value.unit])) if r.random() < .7 else value

    for e in scene.elements:
        e.options = {k: other(v) for k, v in e.options.items()}
    scene.gravity = other(scene.gravity)
    scene.parameters = {k: other(v) for k, v in scene.parameters.items()}


# ------------------------------------------------------------------------------------ split links

def split(scene, r, told):
    """a link in two, tied by a fixed joint; some of what stands on it moves to the second one"""
    some = [e for e in scene.of('link') if 'inertia' in e.options and not e.options['mass'].text]
    if not some:
        return
    L = r.choice(some)
    second = L.name + 'half'
    a, R = vector([round(r.uniform(-.4, .4), 2) for _ in range(3)], 'm'), any_rotation(r)
    there = split_inertia(L, r, a, R)
    scene.elements.append(Element('link', second, **there))
    ends, places = [L.name, second], {'at': a, 'rotation': Rotation(R)}
    if r.random() < .5:
        ends, places = ends[::-1], {'child_at': a, 'child_rotation': Rotation(R)}
    for e in list(scene.elements):
        if e is not L and r.random() < .5:
            carried(e, L.name, second, a, R)
    scene.elements.append(Element('fixed', L.name + 'tie', ends, **places))


def split_inertia(L, r, a, R):
    """the first half stays in L; options of the second one, whose axes stand at a, R"""
    o = L.options
    m, I = o['mass'].value, [q.value for q in o['inertia']]
    c = [q.value for q in o['centre']]
    part = m*Fraction(r.randint(5, 30), 100)
    far = [x + Fraction(r.randint(-5, 5), 100) for x in c]
    own = [Fraction(r.randint(20, 30), 10000) for _ in range(3)]
    left, near = m - part, [(m*x - part*y)/(m - part) for x, y in zip(c, far)]
    whole = [[I[0], I[3], I[5]], [I[3], I[1], I[4]], [I[5], I[4], I[2]]]
    I2 = [[own[i] if i == j else Fraction(0) for j in range(3)] for i in range(3)]
    s1, s2 = (steiner(n, [x - y for x, y in zip(place, c)])
              for n, place in ((left, near), (part, far)))
    I1 = [[whole[i][j] - I2[i][j] - s1[i][j] - s2[i][j] for j in range(3)] for i in range(3)]
    o.update({'mass': Quantity(left, 'kg'), 'centre': vector(near, 'm'), 'inertia': packed(I1)})
    back = transposed(R)
    d = [Quantity(x - y.value, 'm') for x, y in zip(far, a)]
    return {'mass': Quantity(part, 'kg'), 'centre': turned(back, d), 'inertia':
            packed(product(product(back, I2), R))}


def steiner(m, d):
    square = sum(x*x for x in d)
    return [[m*(square*(i == j) - d[i]*d[j]) for j in range(3)] for i in range(3)]


def packed(I):
    pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]
    return [Quantity(I[i][j], 'kg*m^2') for i, j in pairs]


def carried(e, first, second, a, R):
    """what stands on the first half is put on the second one"""
    back, o = transposed(R), e.options
    shift = [Quantity(-x.value, 'm') for x in a]
    for end, (at, rotation) in PLACES.items():
        k = list(PLACES).index(end)
        on = e.ends[k:k + 1] if e.is_joint() else [o.get(end)]
        if on == [first]:
            o[at] = turned(back, moved(o.get(at, zero()), identity(), shift))
            if e.is_joint():
                e.ends[k] = second
                o[rotation] = o.get(rotation, Rotation(identity())).behind(back)
            else:
                o[end] = second
    if e.ends == [first] and e.word in ('force', 'torque', 'gyroscope', 'point', 'frame'):
        e.ends = [second]
        if e.word in ('force', 'point', 'frame'):
            o['at'] = turned(back, moved(o.get('at', zero()), identity(), shift))
        if e.word == 'frame':
            o['rotation'] = o.get('rotation', Rotation(identity())).behind(back)
        if o.get('frame') == 'link':
            o['vector'] = turned(back, o['vector'])
        if e.word == 'gyroscope':
            o['axis'] = turned(back, o['axis'])


def floor(scene, r, told):
    """a link without mass, tied to ground, in the place of ground"""
    p, R = vector([round(r.uniform(-2, 2), 2) for _ in range(3)], 'm'), any_rotation(r)
    for e in scene.elements:
        carried(e, GROUND, 'floor', p, R)
        if e.word == 'rolling':
            back, shift = transposed(R), [Quantity(-x.value, 'm') for x in p]
            e.ends[0] = 'floor'
            e.options['normal'] = turned(back, direction(e.options['normal']))
            e.options['at'] = turned(back, moved(e.options.get('at', zero()), identity(), shift))
    tie = {'at': p, 'rotation': Rotation(R)}
    scene.elements += [Element('link', 'floor', mass=Quantity(0)),
                       Element('fixed', 'tie', [GROUND, 'floor'], **tie)]


def values(scene, r, told):
    """parameters have other values in the scene, and theirs when the code runs"""
    for name, q in scene.parameters.items():
        told.run[name] = float(q.value)
        scene.parameters[name] = Quantity(q.value*Fraction(r.randint(80, 125), 100), q.unit)


def same(scene, r, told):
    """the same text: only the way of derivation differs"""


def heavier(scene, r, told):
    """no twin: a mass is larger by a ten millionth"""
    mass = scene.of('link')[-1].options
    mass['mass'] = Quantity(mass['mass'].value*Fraction(10000001, 10000000), 'kg')


TWINS = {'values': values, 'base': base, 'floor': floor, 'split': split, 'reversed': reverse,
         'units': units, 'renamed': rename, 'forward': same}
