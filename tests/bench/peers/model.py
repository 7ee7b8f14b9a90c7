"""The system of a file model.txt (see rivals/model.hpp; a last number behind its links is the
length at which the last but one link, along its x, is pinned to the last one) for MuJoCo,
Pinocchio, Drake."""
import numpy as np

class Model:
    """gravity, links (parent, kind, R, at, mass, centre, inertia), pin; the start: T, q, v"""
    def __init__(self, folder):
        words = iter(open(folder + '/model.txt').read().split())
        take = lambda k: [float(next(words)) for _ in range(k)]
        self.n, self.gravity, self.links = int(next(words)), take(3), []
        for _ in range(self.n):
            parent, kind = int(next(words)), next(words)
            R = np.array(take(9)).reshape(3, 3)
            self.links.append((parent, kind, R, take(3), take(1)[0], take(3), take(6)))
        self.pin = next((float(w) for w in words), None)
        numbers = [float(w) for w in open(folder + '/start.txt').read().split()]
        self.end = numbers[0]
        self.q, self.v = (np.array(numbers[1 + k * self.n:1 + (k + 1) * self.n]) for k in (0, 1))

def body(model, i):
    """MJCF of a link and of those on it; one without mass, which turns about a fixed axis, gives
    its inertia to the joint"""
    text = lambda *x: ' '.join(repr(float(y)) for y in x)
    _, kind, R, at, mass, centre, J = model.links[i]
    armature = 0.0
    if mass == 0:
        armature, mass, J = J[2], 1e-14, [1e-14] * 3 + [0] * 3
    lines = ['<body name="b%d" pos="%s" xyaxes="%s">' % (i, text(*at), text(*R[:, 0], *R[:, 1])),
             '<joint type="%s" axis="0 0 1" armature="%r"/>'
             % ('hinge' if kind == 'R' else 'slide', armature),
             '<inertial pos="%s" mass="%r" fullinertia="%s"/>'
             % (text(*centre), mass, text(*J[:4], J[5], J[4]))]
    if model.pin is not None and i >= model.n - 2:
        lines.append('<site name="s%d" pos="%r 0 0"/>' % (i, model.pin if i == model.n - 2 else 0))
    lines += [body(model, k) for k in range(model.n) if model.links[k][0] == i]
    return '\n'.join(lines + ['</body>'])

def mjcf(model):
    """MJCF of the system; without a loop all that constrains is switched off"""
    off = ['contact', 'limit', 'frictionloss', 'sensor', 'warmstart', 'eulerdamp']
    equality = ''
    if model.pin is None:
        off += ['constraint', 'equality']
    else:
        equality = ('<equality><connect site1="s%d" site2="s%d" solimp="0.9999 0.9999 0.001"/>'
                    '</equality>' % (model.n - 2, model.n - 1))
    return '\n'.join(
        ['<mujoco><compiler angle="radian" autolimits="false" balanceinertia="false" '
         'inertiafromgeom="false"/><option gravity="%r %r %r"><flag %s/></option><worldbody>'
         % (*model.gravity, ' '.join('%s="disable"' % word for word in off))]
        + [body(model, k) for k in range(model.n) if model.links[k][0] < 0]
        + ['</worldbody>%s</mujoco>' % equality])

def row(method, setting, seconds, calls, q):
    """the line that peers.m reads"""
    print('ROW', method.replace(' ', '_'), '%.6g %.9g %d' % (setting, seconds, calls),
          ' '.join('%.17g' % x for x in q), flush=True)
