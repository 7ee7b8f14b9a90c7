"""Hydraulic and pneumatic machines of the library from their balances of mass and energy.

Numbers are of the size of 1: what is judged are equations, and no corner is sharp.
"""
import math
from devices import Machine, Result, given_by, options

# ------------------------------------------------------------------------------------------- oil

VALVE = {'rho': 1.6, 'cd': .7, 'g': .9, 'ps': 6., 'pt': .5, 'dp': .8, 'eps': .3}
SPOOL = {'om': 3., 'dv': .9}
LEAKS = {'ci': .11, 'ce': .07}


def root(fall, k):
    """signed square root of a pressure drop, laminar below dp"""
    return fall/(fall*fall + k['dp']**2)**.25


def edges(x, k):
    """openings times the flow of a unit of root(drop): supply to side 1, side 1 to tank"""
    wide, unit = math.hypot(x, k['eps']), k['cd']*k['g']*math.sqrt(2/k['rho'])
    return unit*(wide + x)/2, unit*(wide - x)/2


class Four:
    """flows of a four-way valve and of the leaks at the pressures p1, p2"""

    def __init__(self, k, x, p1, p2):
        plus, minus = edges(x, k)
        self.s1, self.t1 = plus*root(k['ps'] - p1, k), minus*root(p1 - k['pt'], k)
        self.s2, self.t2 = minus*root(k['ps'] - p2, k), plus*root(p2 - k['pt'], k)
        self.t1, self.t2 = self.t1 + k['ce']*(p1 - k['pt']), self.t2 + k['ce']*(p2 - k['pt'])
        self.across = k['ci']*(p1-p2)
        self.into1 = self.s1 - self.t1 - self.across
        self.into2 = self.s2 - self.t2 + self.across


def spool(variant, k, name, x, u, rates):
    """where the spool stands: of second order, of first, at its command"""
    if variant not in ('full', 'spool1'):
        return u
    at = x[name + '_x']
    if variant == 'full':
        rates[name + '_x'] = x[name + '_y']
        rates[name + '_y'] = k['om']**2*(u-at) - 2*k['dv']*k['om']*x[name + '_y']
    else:
        rates[name + '_x'] = k['om']*(u-at)/(2*k['dv'])
    return at


OIL_STATES = {
    'full': ['p1', 'p2', 'x', 'y'], 'spool1': ['p1', 'p2', 'x'], 'static': ['p1', 'p2'], 'pl':
    ['pl'], 'incompressible': []
}
OIL_RANGES = {'p1': (1., 5.), 'p2': (1., 5.)}
OIL_START = {'p1': 3., 'p2': 2.5}


def fluid(kind, r, name, stand, source, variants, numbers, inputs, states, law, start, ranges):
    """a machine with one of the variants, its states started inside their ranges"""
    variant = r.choice(variants)
    words, given, read = given_by(r, name, source, inputs(variant))
    k, own = numbers(r), states(variant)
    begin = ['%s = %r' % (n, start[n]) for n in own if n in start]
    start_option = ', start = [%s]' % ', '.join(begin) if begin else ''
    text = '%s(%s, %s%s%s%s, variant = %s)' % (kind, name, stand, options(k), words, start_option,
                                               variant)
    at = lambda x, v, s, w: law(variant, k, name, x, read(v), s, w)
    return Machine([text], [name + '_' + n for n in own], at, given,
                   {name + '_' + n: ranges[n] for n in own if n in ranges})


def cylinder_numbers(r):
    return {
        **VALVE, **SPOOL, **LEAKS, 'a1': round(r.uniform(.6, 1.2), 2), 'a2': round(
            r.uniform(.3, .6), 2), 'vd1': 40., 'vd2': 50., 'l0': .1, 'h': .7, 'beta': 50., 'bv': .4
    }


def hydraulic_cylinder(r, name, stand, source):
    return fluid('hydraulic_cylinder', r, name, stand, source, list(OIL_STATES), cylinder_numbers,
                 lambda v: ['u'], OIL_STATES.get, cylinder, OIL_START, OIL_RANGES)


def cylinder(variant, k, name, x, u, s, w):
    rates, rub, volumes = {}, -k['bv']*w, (k['vd1'] + k['a1']*(s - k['l0']),
                                           k['vd2'] + k['a2']*(k['h'] - s + k['l0']))
    if variant in ('pl', 'incompressible'):
        r = one_pressure(variant, k, name, x, u[0], w, volumes)
        r.passive, r.lost = rub, float('nan') if variant == 'pl' else r.lost + k['bv']*w*w
        return r
    at, (p1, p2), (v1, v2) = spool(variant, k, name, x, u[0],
                                   rates), (x[name + '_p1'], x[name + '_p2']), volumes
    q, beta = Four(k, at, p1, p2), k['beta']
    rates[name + '_p1'] = beta/v1*(q.into1 - k['a1']*w)
    rates[name + '_p2'] = beta/v2*(q.into2 + k['a2']*w)
    held = lambda p: beta*(math.exp(p/beta) - 1 - p/beta)
    power, lost = enthalpies(k, q, p1, p2)
    return Result(k['a1']*p1 - k['a2']*p2, rub, 0., rates, v1*held(p1) + v2*held(p2), power,
                  lost + k['bv']*w*w)


def enthalpies(k, q, p1, p2):
    """what supply and tank give, and what the edges lose; the density grows as exp(p/beta)"""
    beta = k['beta']
    h = lambda p: beta*(math.exp(p/beta) - 1)
    power = lost = 0.
    for p, supply, tank in ((p1, q.s1, q.t1), (p2, q.s2, q.t2)):
        for flow, far in ((supply, k['ps']), (-tank, k['pt'])):
            brought = flow*math.exp((p-far)/beta)*h(far)
            power, lost = power + brought, lost + brought - flow*h(p)
    return power, lost + q.across*(h(p1) - h(p2))


def one_pressure(variant, k, name, x, u, w, volumes):
    """both chambers on the line of a steady motion, whose flows are as the areas"""
    a1, a2, (plus, minus) = k['a1'], k['a2'], edges(u, k)
    push, pull = a1*k['ps'] - a2*k['pt'], a2*k['ps'] - a1*k['pt']
    area, unit = a1 + a2**3/a1**2, k['cd']*k['g']*math.sqrt(2/k['rho'])
    if variant == 'incompressible':
        both, flow = plus**2 + minus**2, a1*w
        drop = area*flow*math.sqrt(flow**2 + (unit*k['eps'])**2*k['dp'])/both
        held = (plus**2*push - minus**2*pull)/both
        return Result(held - drop, power=held*w, lost=drop*w)
    pl = x[name + '_pl']
    forth, back = plus*root((push - a1*pl)/area, k), minus*root((a1*pl + pull)/area, k)
    stiff = k['beta']*(a1**2/volumes[0] + a2**2/volumes[1])
    rate = stiff/a1*((forth-back)/a1 - (k['ci'] + k['ce']/2)*pl/a1 - w)
    return Result(a1*pl, rates={name + '_pl': rate}, stored=(a1*pl)**2/(2*stiff),
                  power=(forth*push + back*pull)/a1)


def motor_numbers(r):
    return {
        **VALVE, **SPOOL, **LEAKS, 'd': round(r.uniform(.3, .9), 2), 'v1': 3., 'v2': 4.,
        'beta': 50., 'cf': .1, 'wc': 1.5, 'bv': .2, 'jr': round(r.uniform(.02, .2), 2)
    }


def hydraulic_motor(r, name, stand, source):
    return fluid('hydraulic_motor', r, name, stand, source,
                 ['full', 'static', 'pl', 'incompressible'], motor_numbers, lambda v: ['u'],
                 OIL_STATES.get, oil_motor, OIL_START, OIL_RANGES)


def oil_motor(variant, k, name, x, u, s, w):
    rates, d, beta = {}, k['d'], k['beta']
    both, P = beta*(1/k['v1'] + 1/k['v2']), k['ps'] - k['pt']
    if variant in ('full', 'static'):
        at, p1, p2 = spool(variant, k, name, x, u[0], rates), x[name + '_p1'], x[name + '_p2']
        q = Four(k, at, p1, p2)
        rates[name + '_p1'] = beta/k['v1']*(q.into1 - d*w)
        rates[name + '_p2'] = beta/k['v2']*(q.into2 + d*w)
        pl, stored = p1 - p2, (k['v1']*p1*p1 + k['v2']*p2*p2)/(2*beta)
        power = k['ps']*(q.s1 + q.s2) - k['pt']*(q.t1 + q.t2)
        lost = power - p1*q.into1 - p2*q.into2
    elif variant == 'pl':
        pl, (plus, minus) = x[name + '_pl'], edges(u[0], k)
        up, down = (P-pl)/2, (P+pl)/2
        forth, back, leak = plus*root(up, k), minus*root(down, k), (k['ci'] + k['ce']/2)*pl
        rates[name + '_pl'] = both*(forth - back - leak - d*w)
        stored, power = pl*pl/(2*both), P*(forth+back)
        lost = 2*forth*up + 2*back*down + leak*pl
    else:
        plus, minus = edges(u[0], k)
        open_, unit = plus**2 + minus**2, k['cd']*k['g']*math.sqrt(2/k['rho'])
        drop = 2*d*w*math.sqrt((d*w)**2 + (unit*k['eps'])**2*k['dp'])/open_
        held = (plus**2 - minus**2)*P/open_
        pl, stored, power, lost = held - drop, 0., held*d*w, drop*d*w
    rub = d*k['cf']*math.tanh(w/k['wc'])*math.hypot(pl, k['dp'])
    return Result(d*pl - rub, -k['bv']*w, k['jr'], rates, stored + k['jr']*w*w/2, power,
                  lost + rub*w + k['bv']*w*w)


# ------------------------------------------------------------------------------------------- gas

GAS = {
    'ps': 5., 'pa': 1., 't0': 2., 'k': 1.4, 'rg': .8, 'cf': .6, 'psi': .68, 'b': .5, 'dp': .6, 'ec':
    .4, 'eps': .3
}
GAS_RANGES = {n: (1.3, 4.5) for n in ('p', 'p1', 'p2')}
GAS_RANGES.update({n: (1.2, 3.) for n in ('t1', 't2', 'tc')})
GAS_START = {'p': 2., 'p1': 3., 'p2': 2.5, 't1': 2., 't2': 2., 'tc': 2.}


def nozzle(k, p, to, t, t_to):
    """mass flow of a unit of area, and its temperature: that of the upper side"""
    drop = math.hypot(p - to, k['dp'])
    upper, lower, side = (p+to+drop)/2, (p+to-drop)/2, (p-to)/drop
    beyond = lower - k['b']*upper
    seen = (beyond + math.sqrt(beyond**2 + k['ec']**2*upper*drop))/2
    warm = (t+t_to)/2 + (t-t_to)/2*side
    full = math.sqrt(upper**2 - (seen/(1 - k['b']))**2)
    return k['cf']*k['psi']*side*full/math.sqrt(k['rg']*warm), warm


class Valve:
    """a three-way valve: flow in from the supply, out to the ambient, and enthalpies they carry"""

    def __init__(self, k, u, p, t):
        wide = math.hypot(u, k['eps'])
        g, warm = nozzle(k, k['ps'], p, k['t0'], t)
        self.into, self.brought = (wide+u)/2*g, (wide+u)/2*g*warm
        g, warm = nozzle(k, p, k['pa'], t, k['t0'])
        self.out, self.taken = (wide-u)/2*g, (wide-u)/2*g*warm
        cp = k['k']*k['rg']/(k['k'] - 1)
        self.enthalpy = cp*(self.brought - self.taken)


def chamber(k, form, valve, p, t, V, swept):
    """rates of pressure and temperature, and heat from the wall; form: 'first law' or exponents
    of inflow, outflow and compression at the constant temperature t0"""
    n = k['k']
    if form == 'first law':
        heat = k['ha']*(k['t0'] - t)
        rate = ((n-1)*(valve.enthalpy + heat) - n*p*swept)/V
        mass = p*V/(k['rg']*t)
        return rate, t*(rate/p + swept/V - (valve.into - valve.out)/mass), heat
    a, b, c = form
    rate = (k['rg']*k['t0']*(a*valve.into - b*valve.out) - c*p*swept)/V
    # the heat that this takes
    return rate, 0., (rate*V + p*swept)/(n-1) - valve.enthalpy + p*swept


def gas_cylinder_numbers(r):
    return {
        **GAS, 'a1': round(r.uniform(.6, 1.2), 2), 'a2': round(r.uniform(.3, .6), 2), 'vd1': 40.,
        'vd2': 50., 'l0': .1, 'h': .7, 'ha': .3, 'bv': .4, 'ain': 1.35, 'aout': 1.1, 'al': 1.2
    }


GAS_FORMS = ['full', 'polytropic', 'isothermal', 'adiabatic', 'spool', 'spool_polytropic']


def pneumatic_cylinder(r, name, stand, source):
    return fluid('pneumatic_cylinder', r, name, stand, source, GAS_FORMS, gas_cylinder_numbers,
                 lambda v: ['u'] if 'spool' in v else ['u1', 'u2'], lambda v:
                 ['p1', 't1', 'p2', 't2'] if v in ('full', 'spool') else ['p1', 'p2'], gas_cylinder,
                 GAS_START, GAS_RANGES)


def gas_cylinder(variant, k, name, x, u, s, w):
    exponents = {'isothermal': (1., 1., 1.), 'adiabatic': (k['k'], )*3}
    form = 'first law' if variant in ('full', 'spool') else exponents.get(
        variant, (k['ain'], k['aout'], k['al']))
    u1, u2 = u if len(u) == 2 else (u[0], -u[0])
    n, rates, power = k['k'], {}, 0.
    sides = ((1, u1, k['vd1'] + k['a1']*(s - k['l0']), k['a1']*w),
             (2, u2, k['vd2'] + k['a2']*(k['h'] - s + k['l0']), -k['a2']*w))
    stored = k['pa']*(k['a1'] - k['a2'])*s
    for i, opening, V, swept in sides:
        p, t = x['%s_p%d' % (name, i)], x.get('%s_t%d' % (name, i), k['t0'])
        valve = Valve(k, opening, p, t)
        rates['%s_p%d' % (name, i)], warming, heat = chamber(k, form, valve, p, t, V, swept)
        if form == 'first law':
            rates['%s_t%d' % (name, i)] = warming
        power, stored = power + valve.enthalpy + heat, stored + p*V/(n-1)
    thrust = k['a1']*x[name + '_p1'] - k['a2']*x[name + '_p2'] - k['pa']*(k['a1'] - k['a2'])
    return Result(thrust, -k['bv']*w, 0., rates, stored, power, k['bv']*w*w)


def gas_motor_numbers(r):
    return {
        **GAS, 'd': round(r.uniform(.3, .9), 2), 'v1': 3., 'v2': 4., 'ha': .3, 'wc': 1.5, 'bv': .2,
        'jr': round(r.uniform(.02, .2), 2)
    }


def pneumatic_motor(r, name, stand, source):
    return fluid('pneumatic_motor', r, name, stand, source, ['full', 'isothermal'],
                 gas_motor_numbers, lambda v: ['u'], lambda v: ['p1', 't1', 'p2', 't2']
                 if v == 'full' else ['p1', 'p2'], gas_motor, GAS_START, GAS_RANGES)


def gas_motor(variant, k, name, x, u, s, w):
    """the volume d w leaves the side that it is taken from, and comes into the other less its
    work"""
    n, rates, side, power = k['k'], {}, math.tanh(w/k['wc']), 0.
    p = [x[name + '_p1'], x[name + '_p2']]
    t = [x.get(name + '_t1', k['t0']), x.get(name + '_t2', k['t0'])]
    of = lambda a, b: (a+b)/2 + (a-b)/2*side
    upper, swept = of(*p), k['d']*w
    mass = of(p[0]/t[0], p[1]/t[1])/k['rg']*swept
    for i, sign, V, opening in ((0, -1, k['v1'], u[0]), (1, 1, k['v2'], -u[0])):
        valve = Valve(k, opening, p[i], t[i])
        key = '%s_p%d' % (name, i+1)
        if variant == 'full':
            heat = k['ha']*(k['t0'] - t[i])
            rates[key] = ((n-1)*(valve.enthalpy + heat) + sign*((n-1)*p[i] + upper)*swept)/V
            own = p[i]*V/(k['rg']*t[i])
            change = valve.into - valve.out + sign*mass
            rates['%s_t%d' % (name, i+1)] = t[i]*(rates[key]/p[i] - change/own)
            power += heat
        else:
            rates[key] = (k['rg']*k['t0']*(valve.into - valve.out) + sign*upper*swept)/V
            power += V*rates[key]/(n-1) - valve.enthalpy
        power += valve.enthalpy
    work = k['d']*(p[0] - p[1])
    if variant != 'full':
        power += work*w
    stored = (p[0]*k['v1'] + p[1]*k['v2'])/(n-1) + k['jr']*w*w/2
    return Result(work, -k['bv']*w, k['jr'], rates, stored, power, k['bv']*w*w)


def bellows_numbers(r):
    return {
        **GAS, 'ae': .8, 'da': .05, 'v0': 40., 'l0': .1, 'kw': round(r.uniform(1, 9), 1), 'bw': .4,
        'ha': .3, 'p0': 2.5, 'n': 1.2
    }


def bellows(r, name, stand, source):
    return fluid('bellows', r, name, stand, source, ['full', 'isothermal', 'sealed'],
                 bellows_numbers, lambda v: [] if v == 'sealed' else ['u'], {
                     'full': ['p', 'tc'], 'isothermal': ['p'], 'sealed': []
                 }.get, bag, GAS_START, GAS_RANGES)


def bag(variant, k, name, x, u, s, w):
    d, n, rates, power = s - k['l0'], k['k'], {}, 0.
    V, A = k['v0'] + k['ae']*d + k['da']*d*d/2, k['ae'] + k['da']*d
    if variant == 'sealed':
        n, p = k['n'], k['p0']*(k['v0']/V)**k['n']
    else:
        p, t = x[name + '_p'], x.get(name + '_tc', k['t0'])
        valve = Valve(k, u[0], p, t)
        form = 'first law' if variant == 'full' else (1., 1., 1.)
        rates[name + '_p'], warming, heat = chamber(k, form, valve, p, t, V, A*w)
        if variant == 'full':
            rates[name + '_tc'] = warming
        power = valve.enthalpy + heat
    stored = p*V/(n-1) + k['pa']*V + k['kw']*d*d/2
    return Result((p - k['pa'])*A, -k['kw']*d - k['bw']*w, 0., rates, stored, power, k['bw']*w*w)
