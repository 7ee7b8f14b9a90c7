"""States of a scene by chance, closed where it has loops."""
import re
import numpy as np
from routines import called, names

SPREAD = .3
MODAL = re.compile(r'B\d+_\d+$')


def drawn(builder, code, r):
    """t, {state: value}, {input: value}; None where no closed state is found near the start"""
    x = np.array(code.js['initial'], float)
    for reach in (SPREAD, SPREAD/5, 0.) if code.has('prj') else (SPREAD,):
        t, new = round(r.uniform(.05, .9), 2), disturbed(builder, code, r, x, reach)
        if not code.has('prj'):
            break
        done = called(code, 'prj', {'T': t, 'X': new})
        new = done['X']
        if done['INFO'] == 0 and np.all(np.isfinite(new)) and sound(code, t, new):
            break
    else:
        return None
    return t, dict(zip(names(code, 'states'), new)), inputs(builder, code, r)


def sound(code, t, x):
    """far from singular positions, at which the motion is not determined"""
    if not code.has('con'):
        return True
    q, u = code.d['nq'], code.d['nu']
    H = called(code, 'con', {'T': t, 'Q': x[:q], 'U': x[q:q + u]})['HC']
    size = np.linalg.svd(H, compute_uv=False)
    size = size/max(size[0], 1e-3)
    return np.sum(size > 1e-2) == code.js['mobility']['rank'] and not np.any(
        (size > 1e-10) & (size <= 1e-2))


def tangents(code, t, x, r):
    """some directions in which a state may change within the constraints"""
    step, found = 1e-5, []
    for _ in range(3):
        d = step*np.array([r.uniform(-1, 1) for _ in x])
        one, two = (called(code, 'prj', {'T': t, 'X': x + s*d})['X'] for s in (1, -1))
        found.append((one - two)/(2*step))
    return found


def disturbed(builder, code, r, x, reach):
    new, q, u = x.copy(), code.d['nq'], code.d['nu']
    for k, name in enumerate(names(code, 'states')):
        if MODAL.match(name):
            new[k] = r.uniform(-.02, .02)
        elif name.replace('.', '_') in builder.states:
            new[k] = r.uniform(*builder.states[name.replace('.', '_')])
        elif k < q:
            new[k] += r.uniform(-reach, reach)
        elif k < q + u:
            new[k] = r.gauss(0, .7)
        else:
            new[k] += r.uniform(-.2, .2)*code.js['nominal'][k]
    return new


def inputs(builder, code, r):
    """modes: a friction slides, a stop is free"""
    v = {}
    for name in names(code, 'inputs'):
        device, _, what = name.partition('.')
        if what == 'mode':
            v[name] = 0. if builder.scene.named(device).word == 'stop' else r.choice([-1., 1.])
        else:
            v[name] = r.uniform(-1, 1)
    return v
