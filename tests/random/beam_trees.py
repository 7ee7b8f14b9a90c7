"""Trees of rigid links and beams in absolute places: every link has its place, its axes and, by
speed, its partial velocities and angular velocities in axes of ground; beams are sums over Gauss
points. With 19 digits; derivatives by coordinates are complex steps.

T of a beam by its model (second: cut at degree 2 in its own coordinates and rates) is u'M(q)u/2;
then bias = M'u - d(u'Mu/2)/dq + dV/dq + damping (Lagrange)."""
import numpy as np

L, C = np.longdouble, np.clongdouble
STEP = L('1e-40')
PI = L('3.14159265358979323846264338327950288')


def gauss(n):
    """points and weights on 0 to 1"""
    x = np.cos(PI*(np.arange(1, n + 1) - L('0.25'))/(n + L('0.5')))
    for _ in range(8):
        p, before = np.ones(n, L), np.zeros(n, L)
        for k in range(n):
            p, before = ((2*k + 1)*x*p - k*before)/(k + 1), p
        slope = n*(x*p - before)/(x*x - 1)
        x = x - p/slope
    return (1 - x)/2, 1/((1 - x*x)*slope*slope)


POINTS, WEIGHTS = gauss(36)


def root(ends, i):
    """beta of eigenfunction i of a beam"""
    s = 1 if ends == 'clamped_free' else -1
    b = (i - L(s)/2)*PI
    for _ in range(60):
        b = b - (np.cos(b) + s/np.cosh(b))/(-np.sin(b) - s*np.sinh(b)/np.cosh(b)**2)
    return b


def shape(ends, i, x):
    """value, first and second derivative of a shape at x = s/L"""
    if isinstance(ends, list):
        k = ends[i - 1]         # xi^k
        return x**k, k*x**(k - 1), k*(k - 1)*x**(k - 2)
    if ends == 'fixed_free' or ends == 'pinned_pinned' or ends == 'fixed_fixed':
        b = (i - L('0.5'))*PI if ends == 'fixed_free' else i*PI
        r = np.sqrt(L(2))
        return r*np.sin(b*x), r*b*np.cos(b*x), -r*b*b*np.sin(b*x)
    b, s = root(ends, i), 1 if ends == 'clamped_free' else -1
    g = (np.cosh(b) + s*np.cos(b))/(np.sinh(b) + s*np.sin(b))
    z = b*x
    return (np.cosh(z) - np.cos(z) - g*(np.sinh(z) - np.sin(z)),
            b*(np.sinh(z) + np.sin(z) - g*(np.cosh(z) - np.cos(z))),
            b*b*(np.cosh(z) + np.cos(z) - g*(np.sinh(z) + np.sin(z))))


def cross(a, b):
    """a x each column of b, or columns by columns"""
    a, b = (x if np.ndim(x) > 1 else x[:, None] for x in (a, b))
    a, b = np.broadcast_arrays(a, b)
    return np.stack([a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]])


def turn(e, q):
    """rotation about the unit vector e"""
    K = np.array([[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]], dtype=C)
    return np.eye(3, dtype=C) + np.sin(q)*K + (1 - np.cos(q))*(K @ K)


class Beam:
    """length, mass by length, inertia of sections by length, model, modes: [kind, ends, number of
    the shape, rigidity, damping ratio]; kind y, z, twist, stretch"""

    def __init__(self, length, rho, inertia, model, modes):
        self.length, self.rho, self.inertia, self.model = L(length), L(rho), inertia, model
        self.modes = modes
        self.same = np.array([[a[0] == b[0] and a[0] in 'yz' for b in modes] for a in modes])
        self.at_points = [self.station(x) for x in POINTS]
        self.stiffness, self.damping = self.elastic()

    def station(self, x):
        """shapes and slopes at x, integral of slope times slope up to there"""
        v = np.array([shape(m[1], m[2], L(x))[:2] for m in self.modes])
        s = np.array([shape(m[1], m[2], L(x)*POINTS)[1] for m in self.modes])
        H = L(x)*np.einsum('ik,jk,k->ij', s, s, WEIGHTS)/self.length*self.same
        if self.model == 'linear':
            H = 0*H
        return v[:, 0], v[:, 1]/self.length, H

    def elastic(self):
        n, l = len(self.modes), self.length
        K, D = np.zeros((n, n), L), np.zeros(n, L)
        J = dict(zip(('twist', 'z', 'y'), self.inertia))
        for i, a in enumerate(self.modes):
            for j, b in enumerate(self.modes):
                if a[0] != b[0]:
                    continue
                f, g = (shape(m[1], m[2], POINTS) for m in (a, b))
                k = 2 if a[0] in 'yz' else 1
                K[i, j] = L(a[3])/l**(2*k - 1)*np.sum(WEIGHTS*f[k]*g[k])
                if i == j:
                    m = J['twist']*l if a[0] == 'twist' else self.rho*l
                    m = m*np.sum(WEIGHTS*f[0]*f[0])
                    if a[0] in 'yz':
                        m += J[a[0]]/l*np.sum(WEIGHTS*f[1]*f[1])
                    D[i] = 2*L(a[4])*np.sqrt(K[i, i]*m)
        return K, D

    def field(self, at, q):
        """displacement of degree 1 and 2, their partial velocities, angles about x, y, z by mode"""
        phi, slope, H = at
        n = len(self.modes)
        d, a = np.zeros((3, n), C), np.zeros((3, n), C)
        for k, m in enumerate(self.modes):
            if m[0] == 'twist':
                a[0, k] = phi[k]
            else:
                d[{'stretch': 0, 'y': 1, 'z': 2}[m[0]], k] = phi[k]
            if m[0] == 'y':
                a[2, k] = slope[k]
            if m[0] == 'z':
                a[1, k] = -slope[k]
        h = np.zeros((3, n), C)
        h[0] = -(H @ q)
        return d @ q, h @ q/2, d, h, a


class Tree:
    """gravity; bodies in order, dictionaries with parent (number or None), at, station (of a parent
    that is a beam, or None), kind (turn, slide, fixed), axis, sign, coordinate, child_at,
    child_station; mass, centre, inertia or beam with coordinates"""

    def __init__(self, n, gravity, bodies):
        self.n, self.gravity, self.bodies = n, np.array(gravity, L), bodies

    def section(self, b, x, q):
        """place, axes, partial velocities, angular velocities of a section in its beam's frame"""
        own = q[b['coordinates']]
        r1, r2, d, h, a = b['beam'].field(b['beam'].station(x), own)
        turns, R, w = a @ own, np.eye(3, dtype=C), np.zeros((3, len(own)), C)
        for k in (2, 1, 0):
            e = np.eye(3, dtype=C)[k]
            w = w + np.outer(R @ e, a[k])
            R = R @ turn(e, turns[k])
        place = r1 + r2
        place[0] += L(x)*b['beam'].length
        V, W = np.zeros((3, self.n), C), np.zeros((3, self.n), C)
        V[:, b['coordinates']], W[:, b['coordinates']] = d + h, w
        return place, R, V, W

    def mounting(self, frames, b, station, q):
        """frame [R, p, V, W] of body number b, or of a section of it"""
        if b is None:
            return np.eye(3, dtype=C), np.zeros(3, C), np.zeros((3, self.n), C), \
                np.zeros((3, self.n), C)
        R, p, V, W = frames[b]
        if station is None:
            return R, p, V, W
        s, S, v, w = self.section(self.bodies[b], station, q)
        return R @ S, p + R @ s, V + cross(W, R @ s) + R @ v, W + R @ w

    def frames(self, q):
        out = []
        for b in self.bodies:
            R, p, V, W = self.mounting(out, b['parent'], b['station'], q)
            at = np.array(b['at'], C)
            e, s = np.array(b['axis'], L), b['sign']
            e = e/np.sqrt(e @ e)
            if b['kind'] == 'slide':
                at = at + s*q[b['coordinate']]*e
            x = R @ at
            p, V = p + x, V + cross(W, x)
            V, W = V.copy(), W.copy()
            if b['kind'] == 'slide':
                V[:, b['coordinate']] += s*(R @ e)
            if b['kind'] == 'turn':
                W[:, b['coordinate']] += s*(R @ e)
                R = R @ turn(e, s*q[b['coordinate']])
            x = -(R @ np.array(b['child_at'], C))
            p, V = p + x, V + cross(W, x)
            if b['child_station'] is not None:
                t, S, v, w = self.section(b, b['child_station'], q)
                R = R @ S.T
                W = W - R @ w
                x = -(R @ t)
                p, V = p + x, V + cross(W, x) - R @ v
            out.append((R, p, V, W))
        return out

    def mass(self, q):
        M = np.zeros((self.n, self.n), C)
        for b, (R, _, V, W) in zip(self.bodies, self.frames(q)):
            V, W = R.T @ V, R.T @ W
            if 'beam' in b:
                M += self.mass_of_beam(b, V, W, q[b['coordinates']])
            else:
                v = V + cross(W, np.array(b['centre'], C))
                M += L(b['mass'])*v.T @ v + W.T @ np.array(b['inertia'], C) @ W
        return M

    def mass_of_beam(self, b, V, W, q):
        beam, M = b['beam'], 0
        for x, weight, at in zip(POINTS, WEIGHTS, beam.at_points):
            r1, r2, d, h, a = beam.field(at, q)
            v0 = V + cross(W, np.array([x*beam.length, 0, 0], C))
            v1, v2, w = cross(W, r1), cross(W, r2), W.copy()
            v1[:, b['coordinates']] += d
            v2[:, b['coordinates']] += h
            w[:, b['coordinates']] += a
            v = v0 + v1
            add = v.T @ v + v0.T @ v2 + v2.T @ v0
            if beam.model == 'full':
                add = (v + v2).T @ (v + v2)
            M = M + weight*beam.length*(beam.rho*add + w.T @ np.diag(beam.inertia).astype(C) @ w)
        return M

    def potential(self, q):
        V = 0
        for b, (R, p, _, _) in zip(self.bodies, self.frames(q)):
            if 'beam' in b:
                own, beam = q[b['coordinates']], b['beam']
                V = V + own @ beam.stiffness @ own/2
                for x, weight, at in zip(POINTS, WEIGHTS, beam.at_points):
                    r1, r2 = beam.field(at, own)[:2]
                    r = p + R @ (r1 + r2 + np.array([x*beam.length, 0, 0], C))
                    V = V - weight*beam.length*beam.rho*(self.gravity @ r)
            else:
                V = V - L(b['mass'])*(self.gravity @ (p + R @ np.array(b['centre'], C)))
        return V

    def terms(self, q, u):
        """M, bias, kinetic and potential energy"""
        q, u = np.array(q, C), np.array(u, L)
        M, bias = self.mass(q).real, np.imag(self.mass(q + 1j*STEP*u))/STEP @ u
        for k in range(self.n):
            z = q.copy()
            z[k] += 1j*STEP
            bias[k] += np.imag(self.potential(z) - u @ self.mass(z) @ u/2)/STEP
        for b in self.bodies:
            if 'beam' in b:
                c = b['coordinates']
                bias[c] += b['beam'].damping*u[c]
        return M, bias, u @ M @ u/2, self.potential(q).real

    def gap(self, loop, q):
        """[distance, its rates by speed] of the two points of a loop, in axes of ground"""
        frames = self.frames(np.array(q, C))
        ends = []
        for body, station, at in loop:
            R, p, V, W = self.mounting(frames, body, station, np.array(q, C))
            x = R @ np.array(at, C)
            ends.append((p + x, V + cross(W, x)))
        return ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]


def solve(A, b):
    """A x = b by elimination with pivots, in the numbers of A"""
    A, b, n = A.copy(), b.copy(), len(b)
    for k in range(n):
        p = k + int(np.argmax(np.abs(A[k:, k])))
        A[[k, p]], b[[k, p]] = A[[p, k]], b[[p, k]]
        for i in range(k + 1, n):
            f = A[i, k]/A[k, k]
            A[i, k:] -= f*A[k, k:]
            b[i] -= f*b[k]
    for k in reversed(range(n)):
        b[k] = (b[k] - A[k, k + 1:] @ b[k + 1:])/A[k, k]
    return b
