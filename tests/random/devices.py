"""The machines of the library from their laws, written without its files: what each gives at its
port, and its rates.

A machine has words: its elements as the scene writes them; states; given: {input: formula}; at(x,
v, s, w) => Result.
"""
import math


class Result:
    """drive: effort of the source; passive: friction; mass: of -s''; rates of states; stored,
    power, lost: energies"""

    def __init__(self, drive=0., passive=0., mass=0., rates=None, stored=0., power=0., lost=0.):
        self.drive, self.passive, self.mass, self.rates = drive, passive, mass, rates or {}
        self.stored, self.power, self.lost = stored, power, lost


class Machine:

    def __init__(self, words, states, law, given, ranges=None):
        self.words, self.states, self.at, self.given = words, states, law, given
        self.ranges = ranges or {}  # of states that cannot be anywhere in -1 .. 1


def given_by(r, name, source, keys):
    """words and formulas of several inputs, and what reads their values"""
    words, given = '', {}
    for key in keys:
        word, own = source(r, key, name)
        words, given = words + word, {**given, **own}
    return words, given, lambda inputs: [inputs[name + '_' + key] for key in keys]


def motor(name, k, v, rates):
    """(torque, power in, lost, stored) of the armature; k: numbers; v(x, inputs): voltage; rates
    get the current's"""

    def at(x, inputs, w):
        i, volts = x[name + '_i'], v(x, inputs)
        rates[name + '_i'] = (volts - k['R']*i - k['K']*w)/k['L']
        return k['K']*i, volts*i, k['R']*i*i + k['B']*w*w, k['L']*i*i/2

    return at


def motor_numbers(r):
    return {
        'R': round(r.uniform(.5, 2), 2), 'L': round(r.uniform(.01, .1), 3), 'K': round(
            r.uniform(.1, .9), 2), 'J': round(r.uniform(.01, .2), 3), 'B': round(
                r.uniform(.01, .2), 3)
    }


def options(k):
    return ''.join(', %s = %r' % x for x in k.items())


def dc_motor(r, name, stand, source):
    k = motor_numbers(r)
    variant = r.choice(['full', 'full', 'full', 'ideal', 'qs0', 'current'])
    key = {'full': 'v', 'qs0': 'v', 'ideal': 'tau', 'current': 'ic'}[variant]
    word, given = source(r, key, name)
    form = '' if variant == 'full' else ', variant = ' + variant
    text = 'dc_motor(%s, %s%s%s%s)' % (name, stand, options(k), form, word)
    read = reader(given, name, key)

    def at(x, inputs, s, w):
        rub, spin, rates = -k['B']*w, k['J']*w*w/2, {}
        if variant != 'full':
            torque, power, lost = without_inductance(variant, k, read(inputs), w)
            return Result(torque, rub, k['J'], {}, spin, power, lost)
        torque, power, lost, field = motor(name, k, lambda x, u: read(u), rates)(x, inputs, w)
        return Result(torque, rub, k['J'], rates, field + spin, power, lost)

    return Machine([text], [name + '_i'] if variant == 'full' else [], at, given)


def without_inductance(variant, k, v, w):
    """torque, power in, power lost; v: the torque, the current or the voltage that is given"""
    if variant == 'ideal':
        return v, v*w, k['B']*w*w
    i = v if variant == 'current' else (v - k['K']*w)/k['R']
    return k['K']*i, (k['R']*i + k['K']*w)*i, k['R']*i*i + k['B']*w*w


def reader(given, name, word):
    """value of an input: a formula's (under `name word`), or of the scene's input of its own"""
    key = name + '_' + word
    return lambda inputs: inputs[key]


GEARS = {
    'pinion_gear': {}, 'lossy_gear': {'ef': .8, 'Tc': .2, 'w0': 1.5}, 'harmonic_drive':
    {'K': 90., 'kappa': 1.5, 'c': 3., 'ke': .02, 'eta': .8, 'Tc': .2, 'w0': 1.5}, 'backlash':
    {'b': .2, 'K': 60., 'vd': 1.5, 'eps': .3}
}
# variants, with what each leaves out of its entry's numbers
LESS = {
    'pinion_gear': {'full': [], 'massless': ['J']}, 'lossy_gear': {'ideal': ['ef']},
    'harmonic_drive': {'full': [], 'elastic': ['c', 'ke']}, 'backlash':
    {'full': [], 'tight': []}
}


def geared_motor(r, name, stand, source):
    """a motor on the shaft of a gear: rigid, with loss in the mesh, compliant, or with play"""
    kind = r.choice(list(GEARS))
    g, k, n = name + 'g', motor_numbers(r), r.choice([2, 3, 5.5])
    p = {'n': n, 'J': round(r.uniform(.01, .1), 3), 'B': round(r.uniform(.01, .1), 3),
         **GEARS[kind]}
    # (a lossy mesh that depends on accelerations: tests/octave/test_lossy_gear.m)
    variant = r.choice([list(LESS[kind])[0], r.choice(list(LESS[kind]))])
    word, given = source(r, 'v', name)
    texts = [
        '%s(%s, %s%s, variant = %s)' % (kind, g, stand, options(p), variant),
        'dc_motor(%s, shaft = %s%s%s)' % (name, g, options(k), word)
    ]
    elastic = kind in ('harmonic_drive', 'backlash') and variant != 'tight'
    for left in LESS[kind][variant]:
        p[left] = 1. if left == 'ef' else 0.
    if variant == 'ideal':
        p['Tc'] = 0.
    law = rigid if not elastic else harmonic if kind == 'harmonic_drive' else backlash
    own = [g + '_theta', g + '_omega'] if elastic else []
    return Machine(texts, own + [name + '_i'], law(name, g, p, k, reader(given, name, 'v')), given)


def rigid(name, g, p, k, read):
    """a gear without compliance and friction in the mesh"""

    def at(x, inputs, s, w):
        n, rates = p['n'], {}
        torque, power, lost, field = motor(name, k, lambda x, u: read(u), rates)(x, inputs, n*w)
        load = torque - k['B']*n*w
        J = p['J'] + k['J']
        return Result(n*load, -n*n*p['B']*w, n*n*J, rates, field + J*(n*w)**2/2, power,
                      lost + p['B']*(n*w)**2)

    return at


def wave(p, x, g, s, w):
    """torque on the port, slope of the wave generator's law, twist of a harmonic drive"""
    theta, omega = x[g + '_theta'], x[g + '_omega']
    twist = theta/p['n'] + p['ke']*math.sin(2*theta) - s
    slope = 1/p['n'] + 2*p['ke']*math.cos(2*theta)
    slip = slope*omega - w
    return p['K']*twist*math.sqrt(1 + p['kappa']*twist**2) + p['c']*slip, slope, twist, slip


def harmonic(name, g, p, k, read):

    def at(x, inputs, s, w):
        omega, rates = x[g + '_omega'], {}
        load, slope, twist, slip = wave(p, x, g, s, w)
        torque, power, lost, field = motor(name, k, lambda x, u: read(u), rates)(x, inputs, omega)
        mu, J = 1/p['eta'] - 1, p['J'] + k['J']
        rub = math.tanh(omega/p['w0'])*math.sqrt((mu*slope*load)**2 + p['Tc']**2)
        rates[g + '_theta'] = omega
        rates[g + '_omega'] = (torque - k['B']*omega - slope*load - rub - p['B']*omega)/J
        spring = p['K']*((1 + p['kappa']*twist**2)**1.5 - 1)/(3*p['kappa'])
        return Result(load, 0., 0., rates, field + J*omega**2/2 + spring, power,
                      lost + p['c']*slip**2 + omega*rub + p['B']*omega**2)

    return at


def flank(x, eps):
    """force and energy of a smooth one-sided spring of stiffness 1 at the depth x"""
    root = math.sqrt(x*x + eps*eps)
    positive = (x+root)/2
    return positive**2/root, positive**2/2


def backlash(name, g, p, k, read):

    def at(x, inputs, s, w):
        theta, omega, rates = x[g + '_theta'], x[g + '_omega'], {}
        gap, slip = theta/p['n'] - s, omega/p['n'] - w
        (ahead, e1), (behind, e2) = flank(gap - p['b'], p['eps']), flank(-gap - p['b'], p['eps'])
        side = math.tanh(slip/p['vd'])
        load = p['K']*(ahead*(1+side) - behind*(1-side))
        torque, power, lost, field = motor(name, k, lambda x, u: read(u), rates)(x, inputs, omega)
        rates[g + '_theta'] = omega
        J = p['J'] + k['J']
        rates[g + '_omega'] = (torque - k['B']*omega - load/p['n'] - p['B']*omega)/J
        return Result(load, 0., 0., rates, field + J*omega**2/2 + p['K']*(e1+e2), power,
                      lost + p['K']*(ahead+behind)*slip*side + p['B']*omega**2)

    return at


def pmsm(r, name, stand, source):
    k = {
        'Rs': .9, 'Ld': .04, 'Lq': .07, 'flux': round(r.uniform(.1, .5), 2), 'np': r.choice([2, 3]),
        'J': round(r.uniform(.01, .2), 3), 'B': .05
    }
    (w1, g1), (w2, g2) = source(r, 'vd', name), source(r, 'vq', name)
    read_d, read_q = reader(g1, name, 'vd'), reader(g2, name, 'vq')

    def at(x, inputs, s, w):
        d, q, vd, vq = x[name + '_id'], x[name + '_iq'], read_d(inputs), read_q(inputs)
        pole = k['np']*w
        rates = {
            name + '_id': (vd - k['Rs']*d + pole*k['Lq']*q)/k['Ld'], name + '_iq':
            (vq - k['Rs']*q - pole*(k['Ld']*d + k['flux']))/k['Lq']
        }
        torque = 1.5*k['np']*(k['flux']*q + (k['Ld'] - k['Lq'])*d*q)
        return Result(torque, -k['B']*w, k['J'], rates,
                      .75*(k['Ld']*d*d + k['Lq']*q*q) + k['J']*w*w/2, 1.5*(vd*d + vq*q),
                      1.5*k['Rs']*(d*d + q*q) + k['B']*w*w)

    return Machine(['pmsm(%s, %s%s%s%s)' % (name, stand, options(k), w1, w2)],
                   [name + '_id', name + '_iq'], at, {**g1, **g2})


def drive(r, name, stand, source):
    word, given = source(r, 'effort', name)
    read = reader(given, name, 'effort')
    return Machine(['drive(%s, %s%s)' % (name, stand, word)], [],
                   lambda x, v, s, w: Result(read(v), power=read(v)*w), given)


def saturated(raw, most):
    return raw/(1 + (raw/most)**8)**.125


def controlled(r, name, stand, source):
    """motor, amplifier with lag and limit, PID controller of the port's own coordinate"""
    k, a, c = motor_numbers(r), name + 'a', name + 'c'
    amp = {'gain': 1.5, 'ta': .05, 'Vm': 9.}
    pid = {
        'Kp': 2., 'Ki': r.choice([0, 1.5]), 'Kd': .4, 'Tf': .1, 'Tt': .3, 'umax': 4., 'bp': .7,
        'bd': .2
    }
    measured = source.measured
    reference = '0.5*sin(2*t)'
    texts = [
        'dc_motor(%s, %s%s, v = %s)' % (name, stand, options(k), a),
        'amplifier(%s, u = %s%s)' % (a, c, options(amp)),
        'pid(%s, reference = %s, measured = %s%s)' % (c, reference, measured, options(pid))
    ]
    given = {c + '_reference': reference, c + '_measured': measured}
    return Machine(texts, [name + '_i', a + '_x', c + '_I', c + '_xd'],
                   control(name, k, amp, pid), given)


def control(name, k, amp, pid):
    a, c = name + 'a', name + 'c'

    def at(x, v, s, w):
        ref, meas, rates = v[c + '_reference'], v[c + '_measured'], {}
        e = pid['bd']*ref - meas - x[c + '_xd']
        raw = pid['Kp']*(pid['bp']*ref - meas) + x[c + '_I'] + pid['Kd']*e/pid['Tf']
        out = saturated(raw, pid['umax'])
        # drawn back only as far as the integral could come back by itself
        own = (pid['Ki']*pid['Tt'])**2
        back = own/(own + (pid['Kp']/100)**2)
        rates[c + '_I'] = pid['Ki']*(ref-meas) + back*(out-raw)/pid['Tt']
        rates[c + '_xd'] = e/pid['Tf']
        rates[a + '_x'] = (saturated(amp['gain']*out, amp['Vm']) - x[a + '_x'])/amp['ta']
        torque, power, lost, field = motor(name, k, lambda x, u: x[a + '_x'], rates)(x, v, w)
        return Result(torque, -k['B']*w, k['J'], rates, field + k['J']*w*w/2, power, lost)

    return at


def rubbing(r, name, stand, source):
    k = {'Fc': .8, 'Fs': round(r.uniform(.9, 2), 2), 'Fv': .3, 'vs': .9, 'vc': .5}
    variant = r.choice(['smooth', 'coulomb', 'viscous', 'lugre'])
    if variant == 'lugre':
        k.update({'k0': 40., 'k1': 3., 'vb': .2})

    def at(x, v, s, w):
        dry = k['Fc'] + (k['Fs'] - k['Fc'])*math.exp(-(w/k['vs'])**2)
        if variant == 'lugre':
            return bristles(k, name, x[name + '_z'], dry, w)
        force = {'smooth': dry, 'coulomb': k['Fc'], 'viscous': 0.}[variant]*math.tanh(
            w/k['vc']) + k['Fv']*w
        return Result(passive=-force, lost=force*w)

    form = '' if variant == 'smooth' else ', variant = ' + variant
    return Machine(['friction(%s, %s%s%s)' % (name, stand, options(k), form)],
                   [name + '_z'] if variant == 'lugre' else [], at, {})


def bristles(k, name, z, dry, w):
    p = k['k0']*math.sqrt(w*w + k['vb']**2)/dry
    d = k['k1']/(1 + k['k1']*p/(4*k['k0']))
    rate = w - p*z
    force = k['k0']*z + d*rate
    return Result(-force, -k['Fv']*w, 0., {name + '_z': rate}, k['k0']*z*z/2, 0.,
                  force*w + k['Fv']*w*w - k['k0']*z*rate)


def stop(r, name, stand, source):
    k = {'lo': -.3, 'hi': .4, 'K': round(r.uniform(5, 50), 1), 'vd': 1.2, 'eps': .2}
    variant = r.choice(['full', 'elastic', 'none'])

    def at(x, v, s, w):
        if variant == 'none':
            return Result()
        (above, e1), (below, e2) = flank(s - k['hi'], k['eps']), flank(k['lo'] - s, k['eps'])
        side = math.tanh(w/k['vd']) if variant == 'full' else 0.
        force = k['K']*(below*(1-side) - above*(1+side))
        return Result(passive=force, stored=k['K']*(e1+e2), lost=k['K']*(above+below)*w*side)

    if variant != 'full':
        words = {n: k[n] for n in ('lo', 'hi', 'K', 'eps')}
        text = 'stop(%s, %s%s, variant = %s)' % (name, stand, options(words), variant)
        return Machine([text], [], at, {})
    return Machine(['stop(%s, %s%s)' % (name, stand, options(k))], [], at, {})


def duffing(r, name, stand, source):
    k = {'k1': round(r.uniform(-3, 9), 1), 'k3': round(r.uniform(1, 9), 1), 'c': .6, 's0': .2}

    def at(x, v, s, w):
        d = s - k['s0']
        return Result(passive=-k['k1']*d - k['k3']*d**3 - k['c']*w,
                      stored=k['k1']*d*d/2 + k['k3']*d**4/4,
                      lost=k['c']*w*w)

    return Machine(['duffing_spring(%s, %s%s)' % (name, stand, options(k))], [], at, {})


TURNING = [dc_motor, dc_motor, geared_motor, geared_motor, pmsm, controlled]  # ports that turn
ANY = [drive, rubbing, stop, duffing]
