"""Electric motors of the library from the equations of their circuits, and their amplifiers.

Two axes are one complex number; quasi-static variants solve the circuits with rates of zero.
"""
import math
import numpy as np
from devices import Machine, Result, given_by, options

NAN = float('nan')


def machine(kind, r, name, stand, source, numbers, forms, law):
    """forms: {variant: (inputs, states)}"""
    variant = r.choice(list(forms))
    (keys, own), k = forms[variant], numbers(r)
    words, given, read = given_by(r, name, source, keys)
    text = '%s(%s, %s%s%s, variant = %s)' % (kind, name, stand, options(k), words, variant)

    def at(x, v, s, w):
        res = law(variant, k, [x[name + '_' + n] for n in own], read(v), s, w)
        res.rates = dict(zip([name + '_' + n for n in own], res.rates or []))
        res.mass, rub = k['J'] if res.mass is None else res.mass, k['B']*w
        res.passive, res.lost = res.passive - rub, res.lost + rub*w
        res.stored += res.mass*w*w/2
        return res

    return Machine([text], [name + '_' + n for n in own], at, given)


def shaft(torque, rates=(), stored=0., power=0., lost=0., passive=0., mass=None):
    return Result(torque, passive, mass, list(rates), stored, power, lost)


def rotor(r):
    return {'J': round(r.uniform(.05, .2), 3), 'B': round(r.uniform(.01, .2), 3)}


# ----------------------------------------------------------------------------- direct current


def warm_motor(r, name, stand, source):
    """dc_motor with losses, and to first order in its inductance"""
    numbers = lambda r: {
        **rotor(r), 'R': 1.3, 'L': .02, 'K': round(r.uniform(.1, .6), 2), 'Vb': .6, 'ib': .7, 'tc':
        .3, 'wc': 1.4, 'al': .2, 'Cth': 1.7, 'Rth': .8
    }
    forms = {'losses': (['v'], ['i', 'Tw']), 'qs1': (['v', 'v_d'], [])}
    return machine('dc_motor', r, name, stand, source, numbers, forms, warm)


def warm(variant, k, x, v, s, w):
    K, R, L = k['K'], k['R'], k['L']
    if variant == 'qs1':
        # i = i0 - (L/R) i0', where the acceleration in i0' is inertia
        i = (v[0] - K*w)/R - L*v[1]/R**2
        return shaft(K*i, power=v[0]*i, lost=NAN, mass=k['J'] - K*K*L/R**2)
    i, T = x
    heat, brush = R*(1 + k['al']*T)*i*i, k['Vb']*math.tanh(i/k['ib'])
    rates = [(v[0] - R*(1 + k['al']*T)*i - K*w - brush)/L, (heat - T/k['Rth'])/k['Cth']]
    dry = k['tc']*math.tanh(w/k['wc'])
    return shaft(K*i, rates, L*i*i/2, v[0]*i, heat + brush*i + dry*w, -dry)


# ------------------------------------------------------------------------- synchronous motors


def synchronous(r, name, stand, source):
    numbers = lambda r: {
        **rotor(r), 'Rs': .9, 'Ld': .04, 'Lq': .07, 'flux': round(r.uniform(.1, .5), 2), 'np': r.
        choice([2, 3]), 'ti': .3
    }
    forms = {'dc': (['vq'], ['iq']), 'foc': (['iqr'], ['iq']), 'qs': (['vd', 'vq'], [])}
    return machine('pmsm', r, name, stand, source, numbers, forms, park)


def park(variant, k, x, v, s, w):
    R, Ld, Lq, flux, pole = k['Rs'], k['Ld'], k['Lq'], k['flux'], k['np']*w
    if variant == 'qs':
        d, q = np.linalg.solve([[R, -pole*Lq], [pole*Ld, R]], [v[0], v[1] - pole*flux])
        torque = 1.5*k['np']*(flux*q + (Ld-Lq)*d*q)
        return shaft(torque, [], 0., 1.5*(v[0]*d + v[1]*q), 1.5*R*(d*d + q*q))
    q = x[0]
    rate = (v[0] - R*q - pole*flux)/Lq if variant == 'dc' else (v[0] - q)/k['ti']
    voltage = R*q + Lq*rate + pole*flux
    return shaft(1.5*k['np']*flux*q, [rate], .75*Lq*q*q, 1.5*voltage*q, 1.5*R*q*q)


def stepping_motor(r, name, stand, source):
    numbers = lambda r: {
        **rotor(r), 'R': .8, 'L': .3, 'Km': round(r.uniform(.2, .9), 2), 'Nr': 3,
        'Td': .2, 'Ip': 1.4
    }
    forms = {
        'full': (['va', 'vb'], ['ia', 'ib']), 'dq': (['vd', 'vq'], ['id', 'iq']), 'qs':
        (['vd', 'vq'], []), 'microstep': (['sc'], [])
    }
    return machine('stepping_motor', r, name, stand, source, numbers, forms, steps)


def steps(variant, k, x, v, s, w):
    R, L, K, N, Td = (k[n] for n in ('R', 'L', 'Km', 'Nr', 'Td'))
    detent, field = -Td*math.sin(4*N*s), Td*(1 - math.cos(4*N*s))/(4*N)
    if variant == 'microstep':
        torque, heat = K*k['Ip']*math.sin(N*(v[0] - s)), R*k['Ip']**2
        return shaft(torque, [], field, heat + torque*w, heat, detent)
    # currents of the windings a, b as one complex number; the rotor's flux induces j K w e^(jNs)
    volt = complex(*v)
    if variant == 'full':
        i, turn = complex(*x), complex(math.cos(N*s), math.sin(N*s))
        rate = (volt - R*i - 1j*K*w*turn)/L
    elif variant == 'dq':
        i, turn = complex(*x), 1.
        rate = (volt - R*i - 1j*N*w*L*i - 1j*K*w)/L
    else:
        i, turn, rate = (volt - 1j*K*w)/(R + 1j*N*w*L), 1., 0j
    torque = K*(i*np.conj(turn)).imag
    rates = [rate.real, rate.imag] if x else []
    stored = L*abs(i)**2/2 if x else 0.
    return shaft(torque, rates, stored + field, (volt*i.conjugate()).real, R*abs(i)**2, detent)


# --------------------------------------------------------------------------- induction motor


def induction_motor(r, name, stand, source):
    numbers = lambda r: {
        **rotor(r), 'Rs': .6, 'Rr': .7, 'Lls': .2, 'Llr': .3, 'Lm': round(r.uniform(.5, 2), 2),
        'np': 2, 'flux': .8, 'ti': .4
    }
    both = ['vd', 'vq', 'wk']
    forms = {
        'full': (both, ['psd', 'psq', 'prd', 'prq']), 'no_stator': (both, ['prd', 'prq']), 'curve':
        (both, []), 'foc': (['cr'], ['cq'])
    }
    return machine('induction_motor', r, name, stand, source, numbers, forms, cage)


def cage(variant, k, x, v, s, w):
    Rs, Rr, Lm, p = k['Rs'], k['Rr'], k['Lm'], k['np']
    Ls, Lr = k['Lls'] + Lm, k['Llr'] + Lm
    if variant == 'foc':
        return oriented(k, x[0], v[0], w, Ls, Lr)
    volt, wk = complex(v[0], v[1]), v[2]
    slip, L = wk - p*w, np.array([[Ls, Lm], [Lm, Lr]])
    if variant == 'full':
        psi = np.array([complex(*x[:2]), complex(*x[2:])])
        i = np.linalg.solve(L, psi)
        i_s, i_r = i
        rate = [volt - Rs*i_s - 1j*wk*psi[0], -Rr*i_r - 1j*slip*psi[1]]
    elif variant == 'no_stator':
        psi_r, sigma = complex(*x), Ls - Lm**2/Lr
        i_s = (volt - 1j*wk*Lm/Lr*psi_r)/(Rs + 1j*wk*sigma)
        i_r = (psi_r - Lm*i_s)/Lr
        rate = [-Rr*i_r - 1j*slip*psi_r]
    else:
        A = np.diag([Rs, Rr]) + 1j*np.diag([wk, slip]) @ L
        i_s, i_r = np.linalg.solve(A, [volt, 0])
        rate = []
    psi_s, psi_r = L @ [i_s, i_r]
    torque = 1.5*p*(psi_s.conjugate()*i_s).imag
    field = .75*(psi_s*np.conj(i_s) + psi_r*np.conj(i_r)).real if rate else 0.
    lost = 1.5*Rs*abs(i_s)**2 + 1.5*Rr*abs(i_r)**2
    return shaft(torque, [a for z in rate for a in (z.real, z.imag)], field,
                 1.5*(volt*np.conj(i_s)).real, NAN if variant == 'no_stator' else lost)


def oriented(k, q, wish, w, Ls, Lr):
    """the rotor's flux is held on the first axis: what the current loop and the circuits need"""
    Lm, flux, sigma = k['Lm'], k['flux'], Ls - k['Lm']**2/Lr
    i_s, rate = complex(flux/Lm, q), (wish - q)/k['ti']
    i_r = (flux - Lm*i_s)/Lr
    turn = k['np']*w - k['Rr']*i_r.imag/flux
    volt = k['Rs']*i_s + 1j*sigma*rate + 1j*turn*(Ls*i_s + Lm*i_r)
    lost = 1.5*(k['Rs']*abs(i_s)**2 + k['Rr']*abs(i_r)**2)
    return shaft(1.5*k['np']*Lm/Lr*flux*q, [rate], .75*sigma*q*q,
                 1.5*(volt*i_s.conjugate()).real, lost)


MOTORS = [warm_motor, synchronous, stepping_motor, induction_motor]
