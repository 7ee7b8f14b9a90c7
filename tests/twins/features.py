"""What is put on a mechanism: a function of a builder for each feature. False: it has no place
there."""
from scene import GROUND
from values import Quantity, vector


def simple(b, kind=None, plain=False):
    """a coordinate with a plain rate; plain: of a joint with only one"""
    some = [x for x in b.simple if kind in (None, x[1])
            and (not plain or x[2].word in ('revolute', 'prismatic'))
            and 'motion' not in x[2].options]
    return b.r.choice(some) if some else None


def port(J, name):
    """options of a port on a coordinate of a joint"""
    return {'joint': J.name, **({'coordinate': name} if len(J.coordinates()) > 1 else {})}


def beam(b):
    """a beam, a body at its end, or a joint in its middle"""
    r, parent, name = b.r, b.r.choice(b.links), b.named('B')
    L, modes = b.number(.5, 1, 'm', 1), r.choice([1, 1, 2])
    L = b.parameter(L) if r.random() < .3 else L
    options = {'length': L, 'mass': b.number(.5, 2, 'kg'), 'modes': str(modes)}
    options['bending'] = r.choice(['y', 'z', '[y, z]'])
    one = b.number(50, 200, 'N*m^2', 0)
    options['stiffness'] = one if r.random() < .7 or options['bending'] != '[y, z]' else [
        one, b.number(50, 200, 'N*m^2', 0)]
    options['assumptions'] = r.choice(['second', 'second', 'full', 'linear'])
    if r.random() < .3:
        options['torsion'] = b.number(20, 60, 'N*m^2', 0)
        options['section_inertia'] = vector(['.02', '.01', '.01'], 'kg*m')
    if r.random() < .3:
        options['damping'] = '0.02'
    b.put('beam', name, **options)
    kind = r.choice(['fixed', 'revolute', 'revolute'])
    b.joint(kind, parent, name, child_at=[Quantity(0)]*3, **(
        {'axis': r.choice('yz'), 'coordinate': b.named('q')} if kind == 'revolute' else {}))
    place = L if r.random() < .6 else Quantity(L.value/2, 'm', L.text and L.text + '/2')
    end = {'at': [place, Quantity(0), Quantity(0)]}
    if r.random() < .5:
        b.joint('fixed', name, b.link(), **end)
    else:
        b.joint('revolute', name, b.link(), axis=r.choice('xyz'), coordinate=b.named('q'), **end)


def motor_numbers(b):
    return {'R': b.number(.5, 2, 'ohm'), 'L': b.number(.02, .1, 'H'), 'K': b.number(.1, .9),
            'J': b.number(.02, .2, 'kg*m^2'), 'B': b.number(.02, .2)}


def supply(b, unit):
    """an input of a device: open, of the scene, a formula, one that switches"""
    kind = b.r.choice(['open', 'input', 'formula', 'switch'])
    if kind == 'input':
        name = b.named('v')
        b.scene.inputs[name] = unit
        return name
    return {'open': None, 'formula': '2*sin(3*t) + 1', 'switch': 'switch(0.3, 1, -2)'}[kind]


def given(key, value):
    return {} if value is None else {key: value}


def motor(b):
    """on a joint, or as a winch between points, or on an expression in two coordinates"""
    x, y = simple(b, 'r'), simple(b, 'r')
    if not x:
        return False
    kind = b.r.choice(['joint', 'joint', 'winch', 'length'])
    where = {'joint': port(x[2], x[0]), 'winch': stretch(b), 'length': {
        'length': '%s - 2*%s + 0.1*sin(%s)' % (x[0], y[0], x[0])}}[kind]
    variant = b.r.choice(['full', 'full', 'qs0', 'ideal', 'current'])
    key, unit = {'full': ('v', 'V'), 'qs0': ('v', 'V'), 'ideal': ('tau', 'N*m'), 'current':
                 ('ic', 'A')}[variant]
    ratio = b.number(2, 9, '1/m' if kind == 'winch' else '', digits=1)
    b.put('dc_motor', b.named('M'), **where, ratio=ratio, **motor_numbers(b), variant=variant,
          **given(key, supply(b, unit)))


def controller(b):
    """a continuous controller over an amplifier, of a sensor of the coordinate"""
    x, r = simple(b, 'r'), b.r
    if not x:
        return False
    M, A, C, S = (b.named(n) for n in 'MACS')
    where = port(x[2], x[0])
    b.put('dc_motor', M, **where, ratio=b.number(2, 9, digits=1), **motor_numbers(b), v=A)
    b.put('amplifier', A, u=C, gain=Quantity('1.5'), ta=Quantity('.05', 's'), Vm=Quantity('9'))
    b.put('pid', C, reference='0.5*sin(2*t/s)', measured=S, Kp=b.number(1, 4), Ki=Quantity('1.5'),
          Kd=Quantity('.4'), Tf=Quantity('.1', 's'), Tt=Quantity('.3', 's'), umax=Quantity(4))
    b.put('position_sensor', S, measure=x[0], gain=Quantity(2), wn=Quantity(20), variant='first')
    if r.random() < .5:
        b.put('output', b.named('O'), rest_=[M + '_i'])


def gear(b):
    x = simple(b, 'r')
    if not x:
        return False
    r, name = b.r, b.named('G')
    word = r.choice(['pinion_gear', 'lossy_gear', 'harmonic_drive', 'backlash'])
    more = {'pinion_gear': {}, 'lossy_gear': {'ef': '.8', 'Tc': '.2', 'w0': '1.5'},
            'harmonic_drive': {'K': '90', 'kappa': '1.5', 'c': '3', 'ke': '.02', 'eta': '.8',
                               'Tc': '.2', 'w0': '1.5'},
            'backlash': {'b': '.2', 'K': '60', 'vd': '1.5', 'eps': '.3'}}[word]
    b.put(word, name, **port(x[2], x[0]), n=b.number(2, 6, digits=1), J=b.number(.01, .1, 'kg*m^2'),
          B=b.number(.01, .1), **{k: Quantity(v) for k, v in more.items()})
    b.put('dc_motor', b.named('M'), shaft=name, **motor_numbers(b), **given('v', supply(b, 'V')))


def fluid(b):
    """a cylinder on a slide, or between points of two bodies"""
    x, r = simple(b, 'm'), b.r
    where = port(x[2], x[0]) if x and r.random() < .7 else stretch(b)
    k = {'a1': '0.9', 'a2': '.45', 'vd1': '40', 'vd2': '50', 'l0': '.1', 'h': '.7', 'beta': '50',
         'bv': '.4', 'rho': '1.6', 'cd': '.7', 'g': '.9', 'ps': '6', 'pt': '.5', 'dp': '.8',
         'eps': '.3', 'om': '3', 'dv': '.9', 'ci': '.11', 'ce': '.07'}
    variant = r.choice(['full', 'static'])
    name = b.named('H')
    b.put('hydraulic_cylinder', name, **where, **{n: Quantity(v) for n, v in k.items()},
          variant=variant, start='[p1 = 3, p2 = 2.5]', **given('u', supply(b, '1')))
    b.states.update({name + '_p1': (1, 5), name + '_p2': (1, 5)})


def stretch(b):
    """options of an element between points of two bodies"""
    one, two = b.r.sample([GROUND] + b.links, 2)
    return {'parent': one, 'at': b.place(.9), 'child': two, 'child_at': b.place(.9)}


def stop(b):
    x = simple(b)
    if not x:
        return False
    where, unit = port(x[2], x[0]), 'm' if x[1] == 'm' else 'rad'
    start = x[2].options.get('start', Quantity(0))
    middle = float(start.value) if isinstance(start, Quantity) else 0.
    ends = {'lo': b.number(middle - .9, middle - .2, unit),
            'hi': b.number(middle + .2, middle + .5, unit)}
    if b.r.random() < .5:
        b.put('stop', b.named('S'), **where, **ends, e=Quantity('.6'), vr=Quantity('.01'),
              variant='event')
    else:
        b.put('stop', b.named('S'), **where, **ends, K=b.number(5, 50), vd=Quantity('1.2'),
              eps=Quantity('.2'))


def friction(b):
    x = simple(b)
    if not x:
        return False
    variant = b.r.choice(['event', 'smooth', 'lugre'])
    more = {'smooth': {'vc': '.5'}, 'event': {}, 'lugre': {'k0': '40', 'k1': '3', 'vb': '.2'}}
    k = {'Fc': '.8', 'Fs': '1.3', 'Fv': '.3', 'vs': '.9', **more[variant]}
    name = b.named('F')
    b.put('friction', name, **port(x[2], x[0]), variant=variant,
          **{n: Quantity(v) for n, v in k.items()})
    b.states[name + '_z'] = (-.02, .02)


def gyroscope(b):
    b.put('gyroscope', b.named('Y'), [b.r.choice(b.links)],
          axis=vector(b.r.choice([(0, 0, 1), (1, 0, 0), (1, 2, 2), (0, 3, -4)])),
          momentum=b.number(.3, 2, 'kg*m^2/s'))


def own_speeds(b):
    some = [x for x in b.simple if 'motion' not in x[2].options]
    if len(some) < 2 or any('reset' in e.options['rest_'][2] for e in b.scene.of('event')):
        return False
    (x, kind, _), (y, _, _) = b.r.sample(some, 2)
    turn = x + '/m' if kind == 'm' else x
    b.scene.speeds = {b.named('w'): '%s_d + (0.3)*%s_d' % (x, y),
                      b.named('w'): '%s_d + (-0.4)*sin(%s)*%s_d' % (y, turn, x)}


def driven(b):
    """a coordinate that goes by a law of time"""
    x = simple(b, plain=True)
    if b.scene.closed and x:  # the crank: what it drives closes
        x = b.simple[0]
    if not x or b.scene.speeds or x[2].word not in ('revolute', 'prismatic'):
        return False
    law = b.r.choice(['0.5 + 0.8*t', '0.4 + 0.3*sin(2*t)', '0.6 + 0.1*t^2'])
    if b.r.random() < .5:
        x[2].options['motion'] = law
    else:
        b.put('motion', b.named('D'), coordinate=x[0], law=law)
    b.scene.closed = True
    b.simple.remove(x)
    x[2].options.setdefault('start', Quantity('.5'))


def samples(b):
    """a computer that reads an encoder, or the coordinate, and drives the joint; late by a delay"""
    x = simple(b)
    if not x:
        return False
    C, q, where = b.named('C'), x[0], port(x[2], x[0])
    reads = q
    if b.r.random() < .5:
        reads = b.named('E')
        b.put('encoder', reads, measure=q, res=Quantity('.001'), T=Quantity('.01', 's'))
    late = Quantity(b.r.choice(['0', '.004', '.01', '.025']), 's')
    b.put('digital_pid', C, reference='0.3*sin(2*t)', measured=reads, T=Quantity('.01', 's'),
          **({'delay': late} if late.value else {}),
          Kp=b.number(2, 9), Ki=Quantity(1), Kd=Quantity('.1'), Tf=Quantity('.02', 's'),
          Tt=Quantity('.3', 's'), umax=Quantity(5), variant=b.r.choice(['full', 'plain']))
    b.put('drive', b.named('A'), **where, effort=C)


def events(b):
    x = simple(b)
    if not x:
        return False
    free = not b.scene.closed and not b.scene.speeds
    action = b.r.choice(['report', 'reset(%s_d, -0.8*%s_d)' % (x[0], x[0])] if free else ['report'])
    what = b.r.choice(['%s - 0.1', '%s_d + 0.2*%s', '%s + sin(2*t)/5']).replace('%s', x[0])
    b.put('event', b.named('Z'), rest_=[what, b.r.choice(['rising', 'falling', 'both']), action])
    if b.r.random() < .4:
        name, tip = b.named('v'), b.r.choice(b.links)
        b.scene.inputs[name] = 'N'
        b.put('force', b.named('K'), [tip], vector=[name, '0', '2*' + name], at=b.place())
        b.put('event', b.named('Z'), rest_=['t - 0.2', 'rising', 'switch(%s, 3)' % name])


def formula(b, unit='N'):
    """an expression in coordinates and rates, each divided by its unit"""
    names = [(x[0] + k, x[0] + '_d*s' + k) for x in b.simple for k in ['/m' if x[1] == 'm' else '']]
    if not names:
        return b.r.choice(['2*sin(3*t/s)*', '-1.5*']) + unit
    (x, rate), (y, _) = b.r.choice(names), b.r.choice(names)
    return b.r.choice(['(3*sin(%s) - 0.5*%s + 0.7*(%s)*(%s))' % (x, rate, x, y), '2*sin(3*t/s)',
                       '(-1.5)', '2*exp((%s)/3)*cos(%s)' % (x, y),
                       '(2*atan(%s) + 3*sqrt(1 + (%s)^2))' % (x, y)]) + '*' + unit


def forces(b):
    kind = b.r.choice(['force', 'torque'])
    options = {'at': b.place()} if kind == 'force' else {}
    if b.r.random() < .5:
        options['frame'] = 'link'
    unit = 'N' if kind == 'force' else 'N*m'
    b.put(kind, b.named('K'), [b.r.choice(b.links)], vector=[formula(b, unit) for _ in range(3)],
          **options)


def switches(b):
    text = b.r.choice(['switch(0.3, 2, -1)*N', '3*after(0.4)*N', 'switch(0.2, 1, 2)*sin(3*t/s)*N'])
    b.put('force', b.named('K'), [b.r.choice(b.links)], vector=[text, '0', formula(b)],
          at=b.place())


def springs(b):
    x = simple(b)
    if x and b.r.random() < .5:
        b.put('spring', b.named('S'), **port(x[2], x[0]), stiffness=b.number(5, 40),
              rest=b.number(-.3, .3))
        b.put('damper', b.named('S'), **port(x[2], x[0]), damping=b.number(.2, 2))
    else:
        b.put('spring', b.named('S'), **stretch(b), stiffness=b.number(5, 40, 'N/m'),
              rest=b.number(.1, .5, 'm'))


def points(b):
    """a frame and a point: what is said of them in outputs and a force"""
    P, Q, link = b.named('P'), b.named('Q'), b.r.choice(b.links)
    b.put('point', P, [link], at=b.place())
    b.put('frame', Q, [b.r.choice([GROUND] + b.links)], at=b.place(), rotation=b.rotation())
    for what in ('distance(%s, %s)' % (P, Q), 'position(%s)[2]' % P, 'velocity(%s)[1]' % P,
                 'acceleration(%s)[3]' % P, 'velocity(%s, frame = %s)[1]' % (P, Q),
                 'angular_velocity(%s)[1]' % link):
        b.put('output', b.named('O'), rest_=[what])
    pull = ['-2*velocity(%s)[1]' % P, '3*position(%s)[3]' % P, '1']
    b.put('force', b.named('K'), [P], vector=pull)


def mount(b):
    """a link on the springs of an elastic joint"""
    k = b.named('J')
    b.put('elastic_joint', k, [b.r.choice([GROUND] + b.links), b.link()], at=b.place(),
          rotation=b.rotation(), stiffness=vector([200, 300, 250], 'N/m'),
          turning_stiffness=b.number(40, 90, 'N*m/rad'), damping=b.number(1, 4, 'N*s/m'),
          coordinates=[b.named('y') for _ in range(6)])


def constraint(b):
    """one more row between coordinates"""
    some = [x for x in b.simple if 'motion' not in x[2].options]
    if len(some) < 2 or b.scene.closed:
        return False
    x, y = (n + ('/m' if kind == 'm' else '') for n, kind, _ in b.r.sample(some, 2))
    b.put('constraint', b.named('R'), rest_=['%s - 0.5*sin(%s) - 0.1*t/s' % (x, y)])
    b.scene.closed = True


def reactions(b):
    J = b.r.choice([J for J in b.scene.joints() if J.word in ('revolute', 'spherical', 'universal')]
                   or [None])
    if not J:
        return False
    b.put('output', b.named('O'), rest_=['reaction(%s)' % J.name])


FEATURES = {
    'beam': beam, 'gear': gear, 'motor': motor, 'controller': controller, 'fluid': fluid,
    'stop': stop, 'friction': friction, 'gyroscope': gyroscope, 'driven': driven,
    'samples': samples, 'events': events, 'switches': switches, 'forces': forces,
    'springs': springs, 'points': points, 'elastic joint': mount, 'constraint': constraint,
    'reactions': reactions, 'own speeds': own_speeds
}
