"""Forces, springs, dampers, gyroscopes, devices on ports; driven coordinates and constraints."""
import math
import numpy as np
from joints import cross
from mechanics import GROUND


def ratio(name, letter):
    """Return what may stand in a sine: an angle, or a length over 1 m."""
    return name + '/m' if letter == 's' else name


class Expression:
    """A formula of the scene, evaluated in Python: t, coordinates c, rates c_d, inputs, metre m"""

    def __init__(self, text):
        self.text = text
        self.code = compile(text.replace('^', '**'), text, 'eval')

    def value(self, m, s):
        names = {'t': s.t, 'm': 1., 'sin': math.sin, 'cos': math.cos, **s.v}
        for j in m.tree:
            if 'b' not in j.letters():
                names.update(zip(j.names, s.q[m.q_of[j.name]]))
                names.update(zip([n + '_d' for n in j.names], s.u[m.u_of[j.name]]))
        return eval(self.code, names)


def place_of(m, name):
    """index among coordinates and among speeds, of an ordinary coordinate"""
    j = next(j for j in m.tree if name in j.names)
    i = j.names.index(name)
    return m.q_of[j.name].start + i, m.u_of[j.name].start + i


# -------------------------------------------------------------------------------------------- ports


class Port:
    """s, its rate w; g: how body accelerations (wrench {link: 6}) and accelerations of
    coordinates enter s''; bend: rest"""

    def in_tree(self, bodies):
        g, bend = self.on_speeds.copy(), self.bend
        for name, row in self.on_bodies.items():
            g += row @ bodies[name].J
            bend += row @ bodies[name].bias
        return g, bend

    def in_all(self, link, first, n):
        g = np.zeros(n)
        g[first:first + len(self.on_speeds)] = self.on_speeds
        for name, row in self.on_bodies.items():
            if name != GROUND:
                g[link[name]:link[name] + 6] += row
        return g

    def times(self, n):
        self.s, self.w, self.bend = n*self.s, n*self.w, n*self.bend
        self.on_speeds = n*self.on_speeds
        self.on_bodies = {k: n*v for k, v in self.on_bodies.items()}
        return self


def coordinate_port(m, s, name):
    p, (iq, iu) = Port(), place_of(m, name)
    p.s, p.w, p.bend, p.on_bodies, p.on_speeds = s.q[iq], s.u[iu], 0., {}, np.zeros(m.nu)
    p.on_speeds[iu] = 1
    return p


def distance_port(m, s, bodies, ends):
    p = Port()
    (a, at), (b, to) = ends
    A, B = bodies[a], bodies[b]
    ra, rb = A.R @ at, B.R @ to
    d = B.p + rb - A.p - ra
    p.s = np.linalg.norm(d)
    e = d/p.s
    v = B.twist[:3] + cross(B.twist[3:], rb) - A.twist[:3] - cross(A.twist[3:], ra)
    p.w = v @ e
    fall = cross(B.twist[3:], cross(B.twist[3:], rb)) - cross(A.twist[3:], cross(A.twist[3:], ra))
    p.bend = e@fall + (v - e*p.w) @ v/p.s
    p.on_bodies = {a: -np.concatenate([e, cross(ra, e)]), b: np.concatenate([e, cross(rb, e)])}
    p.on_speeds = np.zeros(m.nu)
    return p


def length_port(m, s, form):
    """a*x + b*x*y of the coordinates x, y"""
    x, y, a, b = form
    (ix, kx), (iy, ky) = place_of(m, x), place_of(m, y)
    p = Port()
    p.s, p.bend = a*s.q[ix] + b*s.q[ix]*s.q[iy], 2*b*s.u[kx]*s.u[ky]
    p.on_bodies, p.on_speeds = {}, np.zeros(m.nu)
    p.on_speeds[kx] += a + b*s.q[iy]
    p.on_speeds[ky] += b*s.q[ix]
    p.w = p.on_speeds @ s.u
    return p


class Stand:
    """where a spring or device stands: coordinate, ends or form (angle: in rad), and its ratio"""

    def __init__(self, coordinate=None, ends=None, form=None, ratio=1.):
        self.coordinate, self.ends, self.form, self.ratio = coordinate, ends, form, ratio
        self.angle = False  # whether the form is one

    def port(self, m, s, bodies):
        if self.coordinate:
            return coordinate_port(m, s, self.coordinate).times(self.ratio)
        if self.ends:
            return distance_port(m, s, bodies, self.ends).times(self.ratio)
        return length_port(m, s, self.form).times(self.ratio)


# -------------------------------------------------------------------------------------------- loads


class Force:

    def __init__(self, link, frame, at, vector, torque=False):
        self.link, self.frame, self.at, self.vector, self.torque = link, frame, at, vector, torque

    def load(self, m, s, bodies, loads):
        b = bodies[self.link]
        f = np.array([e.value(m, s) for e in self.vector], float)
        if self.frame == 'link':
            f = b.R @ f
        r = b.R @ self.at
        wrench = np.concatenate([0*f, f]) if self.torque else np.concatenate([f, cross(r, f)])
        loads.wrench[self.link] += wrench
        loads.power += wrench @ b.twist


class Gyroscope:

    def __init__(self, link, axis, momentum):
        self.link, self.axis, self.momentum = link, axis, momentum

    def load(self, m, s, bodies, loads):
        b = bodies[self.link]
        loads.wrench[self.link][3:] -= cross(b.twist[3:], b.R @ self.axis)*self.momentum


class Spring:

    def __init__(self, stand, stiffness, rest):
        self.stand, self.stiffness, self.rest = stand, stiffness, rest

    def load(self, m, s, bodies, loads):
        p = self.stand.port(m, s, bodies)
        loads.at_port(p, -self.stiffness*(p.s - self.rest))
        loads.potential += self.stiffness*(p.s - self.rest)**2/2


class Damper:

    def __init__(self, stand, damping):
        self.stand, self.damping = stand, damping

    def load(self, m, s, bodies, loads):
        p = self.stand.port(m, s, bodies)
        loads.at_port(p, -self.damping*p.w)
        loads.lost += self.damping*p.w**2


class Device:
    """machine: see devices.py; its inputs are formulas, or inputs of the scene under their own
    names"""

    def __init__(self, machine, stand):
        self.machine, self.stand = machine, stand

    def load(self, m, s, bodies, loads):
        p = self.stand.port(m, s, bodies) if self.stand else None
        given = {k: e.value(m, s) for k, e in self.machine.given.items()}
        r = self.machine.at(s.x, {**s.v, **given}, p.s if p else 0., p.w if p else 0.)
        if p:
            loads.at_port(p, r.passive, r.drive)
            if r.mass:
                loads.added.append((r.mass, p))
            holder = getattr(self.machine, 'holder', None)
            if holder and holder.holds(s.v[holder.mode]):
                loads.held.append((holder.name, p))
        loads.rates.update(r.rates)
        loads.signals.update(getattr(r, 'signals', {}))
        loads.stored += r.stored
        loads.power += r.power
        loads.lost += r.lost


# --------------------------------------------------------------------------------------- conditions


class Rows:
    """gap; rows on the bodies {link: k x 6} and on the speeds; wanted: their rates; gamma: their
    values of the second"""

    def __init__(self, gap, on_bodies, on_speeds, wanted, gamma):
        self.gap, self.on_bodies, self.on_speeds = np.array(
            gap, float), on_bodies, np.atleast_2d(on_speeds)
        self.wanted, self.gamma = np.array(wanted, float), np.array(gamma, float)

    def in_tree(self, bodies, n):
        G = self.on_speeds.copy()
        for name, rows in self.on_bodies.items():
            G = G + rows @ bodies[name].J
        return G

    def in_all(self, link, first, n):
        G = np.zeros((len(self.gamma), n))
        G[:, first:first + self.on_speeds.shape[1]] = self.on_speeds
        for name, rows in self.on_bodies.items():
            if name != GROUND:
                G[:, link[name]:link[name] + 6] += rows
        return G


class Law:
    """x = c + b*t + a*sin(w*t)"""

    def __init__(self, name, c, b, a, w):
        self.name, self.c, self.b, self.a, self.w = name, c, b, a, w
        self.text = '%r + (%r)*t + (%r)*sin(%r*t)' % (c, b, a, w)

    def rows(self, m, s, bodies):
        iq, iu = place_of(m, self.name)
        row, p = np.zeros(m.nu), self.w*s.t
        row[iu] = 1
        return Rows([s.q[iq] - self.c - self.b*s.t - self.a*math.sin(p)], {}, row,
                    [self.b + self.a*self.w*math.cos(p)], [-self.a*self.w**2*math.sin(p)])


class Holonomic:
    """a*x + b*y + d*x*y = c"""

    def __init__(self, x, y, a, b, d, c):
        self.x, self.y, self.a, self.b, self.d, self.c = x, y, a, b, d, c
        self.text = '%r*%s + (%r)*%s + (%r)*%s*%s - (%r)' % (a, x, b, y, d, x, y, c)

    def rows(self, m, s, bodies):
        (ix, kx), (iy, ky) = place_of(m, self.x), place_of(m, self.y)
        x, y, row = s.q[ix], s.q[iy], np.zeros(m.nu)
        row[kx], row[ky] = self.a + self.d*y, self.b + self.d*x
        return Rows([self.a*x + self.b*y + self.d*x*y - self.c], {}, row, [0.],
                    [-2*self.d*s.u[kx]*s.u[ky]])


class OfSpeeds:
    """a*x' + (b + d*sin(x))*y' = 0"""

    def __init__(self, x, y, a, b, d, turn):
        self.x, self.y, self.a, self.b, self.d = x, y, a, b, d
        self.text = '%r*%s_d + (%r + (%r)*sin(%s))*%s_d' % (a, x, b, d, turn, y)

    def rows(self, m, s, bodies):
        (ix, kx), (_, ky) = place_of(m, self.x), place_of(m, self.y)
        row = np.zeros(m.nu)
        row[kx], row[ky] = self.a, self.b + self.d*math.sin(s.q[ix])
        return Rows([0.], {}, row, [0.], [-self.d*math.cos(s.q[ix])*s.u[kx]*s.u[ky]])


class Rolling:
    """the disc (centre, axis, radius) of a link rolls on the plane (at, normal) of another,
    without slip"""

    def __init__(self, plane, at, normal, disc, centre, axis, radius):
        self.plane, self.at, self.normal = plane, at, normal
        self.disc, self.centre, self.axis, self.radius = disc, centre, axis, radius

    def contact(self, bodies):
        """from the disc's centre to the contact, and its rate"""
        P, D = bodies[self.plane], bodies[self.disc]
        n, a = P.R @ self.normal, D.R @ self.axis
        nd, ad = cross(P.twist[3:], n), cross(D.twist[3:], a)
        d = (n@a)*a - n
        dd = (nd@a + n@ad)*a + (n@a)*ad - nd
        e = d/np.linalg.norm(d)
        return self.radius*e, self.radius*(dd - e*(e@dd))/np.linalg.norm(d), n

    def rows(self, m, s, bodies):
        P, D = bodies[self.plane], bodies[self.disc]
        rho, rate, n = self.contact(bodies)
        c = D.R @ self.centre
        rd, rp = c + rho, D.p + c + rho - P.p
        wd, wp = D.twist[3:], P.twist[3:]
        rd_rate, rp_rate = cross(wd, c) + rate, D.twist[:3] + cross(wd, c) + rate - P.twist[:3]
        E = np.eye(3)
        across = [cross(n, E[np.argmin(np.abs(n))])]
        across.append(cross(n, across[0]))
        W = np.array([n] + across)
        gamma = -W @ (cross(wd, rd_rate) - cross(wp, rp_rate))
        gap = n @ (rp - P.R @ self.at)
        wrench = lambda r: np.array([np.concatenate([w, cross(r, w)]) for w in W])
        return Rows([gap, 0., 0.], {self.disc: wrench(rd), self.plane: -wrench(rp)},
                    np.zeros((3, m.nu)), [0., 0., 0.], gamma)
