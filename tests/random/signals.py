"""Sensors, controllers, amplifiers and sampled devices of the library, in chains that end in a
motor or an ideal drive.

A block: words of its elements; states; signals: {output of the scene: value}; its law (x, inputs)
=> output, where x are states of devices, inputs the formulas' values, and rates are left in a dict.
"""
import math
from devices import (Machine, Result, given_by, motor, motor_numbers, options, saturated)


def entry(kind, name, numbers, words, variant):
    return '%s(%s%s, variant = %s%s)' % (kind, name, words, variant, options(numbers))


# ---------------------------------------------------------------------------------------- sensors

# what each measures of a joint's coordinate, with its unit
SENSORS = {
    'position_sensor': '%s', 'velocity_sensor': '%s_d', 'acceleration_sensor':
    '2*m/s^2*sin(%s)', 'force_sensor': '2*N*sin(%s)', 'torque_sensor': '2*N*m*sin(%s)',
    'pressure_sensor': '2*Pa*sin(%s)'
}


def sensor(r, name, x, turn):
    """Return (words, formula, states, law) of a sensor of the coordinate x: a lag with gain, offset
    and range, or an encoder; turn: what may stand in a sine."""
    if r.random() < .15:
        return encoder(r, name, x)
    kind, variant = r.choice(list(SENSORS)), r.choice(list(LAGS))
    sine = 'sin' in SENSORS[kind]
    measure = SENSORS[kind] % (turn if sine else x)
    formula = '2*sin(%s)' % turn if sine else measure
    words, law = lagging(kind, name, measure, variant)
    return words, formula, [name + '_' + n for n in LAGS[variant]], law


def sensed(r, kind, name, measure):
    """(words, law) of a sensor of any measure"""
    return lagging(kind, name, measure, r.choice(list(LAGS)))


LAGS = {'second': ['y', 'v'], 'first': ['y'], 'ideal': []}  # variants of sensors: states


def lagging(kind, name, measure, variant):
    """(words, law) of a sensor that lags as its variant does"""
    k = {'gain': 1.3, 'offset': .2, 'wn': 2.5, 'zeta': .7, 'range': 3.}

    def law(x, inputs, rates):
        signal = k['gain']*inputs[name + '_measure'] + k['offset']
        if variant == 'ideal':
            return signal
        y = x[name + '_y']
        if variant == 'first':
            rates[name + '_y'] = k['wn']*(signal-y)/(2*k['zeta'])
            return y
        v = x[name + '_v']
        rates[name + '_y'], rates[name + '_v'] = v, k['wn']**2*(signal-y) - 2*k['zeta']*k['wn']*v
        return saturated(y, k['range'])

    return entry(kind, name, k, ', measure = ' + measure, variant), law


def encoder(r, name, x):
    """as seen over many periods"""
    k = {'res': .01, 'offset': .3, 'T': .2}

    def law(x, inputs, rates):
        angle = inputs[name + '_measure'] + k['offset']
        rates[name + '_y'] = 2*(angle - x[name + '_y'])/k['T']
        return angle

    return entry('encoder', name, k, ', measure = ' + x, 'ideal'), x, [name + '_y'], law


# ------------------------------------------------------------------------------------ controllers


def pid(r, name):
    k = {
        'Kp': 2., 'Ki': r.choice([0, 1.5]), 'Kd': .4, 'Tf': .3, 'Tt': .3, 'umax': 4., 'bp': .7,
        'bd': .2
    }
    variant = r.choice(['full', 'linear', 'pid', 'pd', 'pi', 'p'])
    integral, slope = variant not in ('pd', 'p'), variant not in ('pi', 'p')
    own = ['I']*integral + ['xd']*slope

    def law(x, v, rates):
        ref, meas, raw = v['reference'], v['measured'], 0.
        raw = k['Kp']*(k['bp']*ref - meas)
        if slope:
            rates['xd'] = (k['bd']*ref - meas - x['xd'])/k['Tf']
            raw += k['Kd']*rates['xd']
        if integral:
            raw += x['I']
        out = raw if variant == 'linear' else saturated(raw, k['umax'])
        if integral:
            # drawn back only as far as the integral could come back by itself
            g = (100*k['Ki']*k['Tt']/k['Kp'])**2
            rates['I'] = k['Ki']*(ref-meas) + g/(1+g)*(out-raw)/k['Tt']
        return out

    unused = ['Ki', 'Tt']*(not integral) + ['Kd', 'Tf', 'bd']*(not slope)
    told = {x: k[x] for x in k if x not in unused}  # a gain that a variant does not use is refused
    return 'pid', told, variant, own, ['reference', 'measured'], law


def cascade(r, name):
    k = {'kp': 1.4, 'ks': .8, 'Ti': .5, 'Tt': r.choice([.3, .004]), 'umax': 3.}
    variant = r.choice(['full', 'linear', 'p'])

    def law(x, v, rates):
        ev = k['kp']*(v['reference'] - v['measured']) + v['forward'] - v['speed']
        raw = k['ks']*(ev + (x['I'] if variant != 'p' else 0))
        out = raw if variant == 'linear' else saturated(raw, k['umax'])
        if variant != 'p':
            g = (100*k['Tt']/k['Ti'])**2
            rates['I'] = ev/k['Ti'] + g/(1+g)*(out-raw)/(k['ks']*k['Tt'])
        return out

    own = [] if variant == 'p' else ['I']
    told = {x: k[x] for x in k if variant != 'p' or x not in ('Ti', 'Tt')}
    return 'cascade', told, variant, own, ['reference', 'measured', 'speed', 'forward'], law


def state_feedback(r, name):
    k = {'k1': 1.5, 'k2': .8, 'l1': 2., 'l2': 3., 'a0': .7, 'a1': .2, 'b': 1.1, 'umax': 2.}
    variant = r.choice(['full', 'linear'])

    def law(x, v, rates):
        raw = k['k1']*(v['reference'] - x['xe']) - k['k2']*x['ve']
        out = raw if variant == 'linear' else saturated(raw, k['umax'])
        miss = v['measured'] - x['xe']
        rates['xe'] = x['ve'] + k['l1']*miss
        rates['ve'] = k['b']*out - k['a1']*x['ve'] - k['a0']*x['xe'] + k['l2']*miss
        return out

    return 'state_feedback', k, variant, ['xe', 've'], ['reference', 'measured'], law


def delayed(raw, z, lag, rates):
    """a delay as an all-pass of first order"""
    rates['z'] = (raw-z)/(lag/2)
    return 2*z - raw


def slow_pid(r, name):
    """a sampled controller as seen over many periods"""
    k = {'T': .1, 'delay': .05, 'Kp': 2., 'Ki': 1.5, 'Kd': .4, 'Tf': .3, 'Tt': .3, 'umax': 4.}

    def law(x, v, rates):
        T, e = k['T'], v['reference'] - v['measured']
        filter = k['Tf'] + T/2  # of a backward difference
        rates['xd'], rates['I'] = (e - x['xd'])/filter, k['Ki']*e
        # the sum of a forward difference is half a period behind
        raw = k['Kp']*e + x['I'] - T/2*rates['I'] + k['Kd']*rates['xd']
        return delayed(raw, x['z'], k['delay'] + T/2, rates)

    return 'digital_pid', k, 'continuous', ['I', 'xd', 'z'], ['reference', 'measured'], law


def slow_cascade(r, name):
    k = {'T': .1, 'delay': .05, 'kp': 1.4, 'ks': .8, 'Ti': .5, 'Tt': .3, 'umax': 3.}

    def law(x, v, rates):
        ev = k['kp']*(v['reference'] - v['measured']) + v['forward'] - v['speed']
        rates['I'] = ev/k['Ti']
        raw = k['ks']*(ev + x['I'] - k['T']/2*rates['I'])
        return delayed(raw, x['z'], k['delay'] + k['T']/2, rates)

    keys = ['reference', 'measured', 'speed', 'forward']
    return 'digital_cascade', k, 'continuous', ['I', 'z'], keys, law


CONTROLLERS = [pid, pid, cascade, state_feedback, slow_pid, slow_cascade]

# ------------------------------------------------------------------------------------- amplifiers


def amplifier(r, name):
    """of a voltage, or of a current"""
    kind = r.choice(['amplifier', 'current_amplifier'])
    variant = r.choice(['full', 'saturating', 'lag', 'linear'])
    lag, most = ('ta', 'Vm') if kind == 'amplifier' else ('ti', 'Im')
    k = {'gain': 1.5, lag: .3, most: 3.}
    if kind == 'current_amplifier':
        k['slew'] = 5.

    def law(x, u, rates):
        wish = k['gain']*u
        if variant in ('full', 'saturating'):
            wish = saturated(wish, k[most])
        if variant in ('saturating', 'linear'):
            return wish
        rate = (wish - x['x'])/k[lag]
        bounded = kind == 'current_amplifier' and variant == 'full'
        rates['x'] = saturated(rate, k['slew']) if bounded else rate
        return x['x']

    return kind, k, variant, ['x'] if variant in ('full', 'lag') else [], law


# ------------------------------------------------------------------------------------------ chains


def under(name, x):
    """states of one device, by their own names"""
    return {n[len(name) + 1:]: a for n, a in x.items() if n.startswith(name + '_')}


def axis(r, name, stand, source):
    """a motor, fed by an amplifier, a controller and perhaps sensors"""
    c, a, s, k = name + 'c', name + 'a', name + 's', motor_numbers(r)
    kind, kc, variant, own, keys, control = r.choice(CONTROLLERS)(r, c)
    akind, ka, avariant, aown, amplify = amplifier(r, a)
    q, given, words, states = source.measured, {}, [], []
    wired = {'reference': '0.5*sin(2*t)', 'measured': q, 'speed': q + '_d', 'forward': 'cos(2*t)'}
    sense = None
    if 'speed' not in keys and r.random() < .9:
        text, formula, states, sense = sensor(r, s, q, source.turn)
        words, given = [text], {s + '_measure': formula}
    given.update({c + '_' + n: wired[n] for n in keys if not (sense and n == 'measured')})
    links = ''.join(', %s = %s' % (n, s if sense and n == 'measured' else wired[n]) for n in keys)
    current = akind == 'current_amplifier'
    form = ', ic = %s, variant = current' % a if current else ', v = ' + a
    words += [
        entry(kind, c, kc, links, variant), entry(akind, a, ka, ', u = ' + c, avariant),
        'dc_motor(%s, %s%s%s)' % (name, stand, options(k), form)
    ] + ['output(o_%s, %s)' % (n, n) for n in [c, a] + [s]*bool(sense)]
    states += [c + '_' + n for n in own] + [a + '_' + n for n in aown]
    states += [] if current else [name + '_i']

    def at(x, v, pos, w):
        rates, signals, inputs = {}, {}, {n: v[c + '_' + n] for n in keys if c + '_' + n in v}
        if sense:
            inputs['measured'] = signals['o_' + s] = sense(x, v, rates)
        crates, arates = {}, {}
        out = signals['o_' + c] = control(under(c, x), inputs, crates)
        fed = signals['o_' + a] = amplify(under(a, x), out, arates)
        rates.update({c + '_' + n: f for n, f in crates.items()})
        rates.update({a + '_' + n: f for n, f in arates.items()})
        if current:
            res = Result(k['K']*fed, -k['B']*w, k['J'], rates, k['J']*w*w/2,
                         fed*(k['R']*fed + k['K']*w), k['R']*fed**2 + k['B']*w*w)
        else:
            torque, power, lost, field = motor(name, k, lambda x, u: fed, rates)(x, v, w)
            res = Result(torque, -k['B']*w, k['J'], rates, field + k['J']*w*w/2, power, lost)
        res.signals = signals
        return res

    return Machine(words, states, at, given)


# ----------------------------------------------------------------------------------------- sampled


def rounded(x, step):
    return step*math.floor(x/step + .5)


def within(x, most):
    return max(-most, min(most, x))


def sampled_pid(r):
    k = {
        'T': .1, 'delay': .05, 'Kp': 2., 'Ki': r.choice([0, 1.5]), 'Kd': .4, 'Tf': .3, 'Tt': .3,
        'umax': 4., 'qm': .013, 'qu': .017
    }
    variant = r.choice(['full', 'plain', 'pid', 'pd', 'pi', 'p'])
    integral, slope = variant not in ('pd', 'p'), variant not in ('pi', 'p')

    def law(v, m):
        fine = variant == 'plain'
        e = v['reference'] - (v['measured'] if fine else rounded(v['measured'], k['qm']))
        raw, new = k['Kp']*e, {}
        if slope:
            step = e - m['old'] if m['count'] else 0.
            new = {'d': (k['Tf']*m['d'] + k['Kd']*step)/(k['Tf'] + k['T']), 'old': e, 'count': 1.}
            raw += new['d']
        raw += m['I'] if integral else 0.
        out = within(raw, k['umax']) if fine else rounded(within(raw, k['umax']), k['qu'])
        if integral:
            g = (100*k['Ki']*k['Tt']/k['Kp'])**2
            new['I'] = m['I'] + k['Ki']*k['T']*e + g/(1+g)*k['T']/k['Tt']*(out-raw)
        return {'out': out}, new

    unused = ['Ki', 'Tt']*(not integral) + ['Kd', 'Tf']*(not slope)
    told = {x: k[x] for x in k if x not in unused}
    return 'digital_pid', told, variant, ['reference', 'measured'], law


def sampled_cascade(r):
    k = {
        'T': .1, 'delay': .05, 'kp': 1.4, 'ks': .8, 'Ti': .5, 'Tt': r.choice([.3, .004]),
        'umax': 3., 'qu': .017
    }
    variant = r.choice(['full', 'plain', 'p'])

    def law(v, m):
        ev = k['kp']*(v['reference'] - v['measured']) + v['forward'] - v['speed']
        raw, new = k['ks']*(ev + m.get('I', 0.)), {}
        out = within(raw, k['umax'])
        out = out if variant == 'plain' else rounded(out, k['qu'])
        if variant != 'p':
            g = (100*k['Tt']/k['Ti'])**2
            new['I'] = m['I'] + k['T']*(ev/k['Ti'] + g/(1+g)*(out-raw)/(k['ks']*k['Tt']))
        return {'out': out, 'error': v['reference'] - v['measured']}, new

    told = {x: k[x] for x in k if variant != 'p' or x not in ('Ti', 'Tt')}
    return 'digital_cascade', told, variant, ['reference', 'measured', 'speed', 'forward'], law


def sampled_encoder(r):
    k = {'res': .01, 'offset': .3, 'T': .2, 'delay': .01}

    def law(v, m):
        angle = rounded(v['measure'] + k['offset'], k['res'])
        speed = (angle - m['old'])/k['T'] if m['count'] else 0.
        return {'angle': angle, 'speed': speed}, {'old': angle, 'count': 1.}

    return 'encoder', k, 'full', ['measure'], law


def computer(r, name, stand, source):
    """an ideal drive that a sampled device commands; or one beside an encoder, which gives no
    effort"""
    c, q = name + 'c', source.measured
    kind, k, variant, keys, law = r.choice([sampled_pid, sampled_cascade, sampled_encoder])(r)
    wired = {
        'reference': '0.5*sin(2*t)', 'measured': q, 'measure': q, 'speed': q + '_d', 'forward':
        'cos(2*t)'
    }
    out, effort = c + '_out', c
    if kind == 'encoder':
        out = effort = '2*sin(3*t) + 0.5'
    words = [
        entry(kind, c, k, ''.join(', %s = %s' % (n, wired[n]) for n in keys), variant),
        'drive(%s, %s, effort = %s)' % (name, stand, effort)
    ]
    given = {c + '_' + n: wired[n] for n in keys}
    given[name + '_effort'] = out

    def at(x, v, pos, w):
        res = Result(v[name + '_effort'], power=v[name + '_effort']*w)
        res.signals = {c + '.' + n: v[c + '_' + n] for n in keys}
        return res

    m = Machine(words, [], at, given)
    m.sampled, m.held = (c, keys, law), [c + '_angle' if kind == 'encoder' else out]
    return m


CHAINS = [axis, axis, axis, computer]
