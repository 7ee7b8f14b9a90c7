"""Joints as chains of elementary motions: pose, partial velocities, velocity, bias of the
acceleration."""
import math
import numpy as np

AXES = {'x': np.array([1., 0, 0]), 'y': np.array([0, 1., 0]), 'z': np.array([0, 0, 1.])}
# one letter a coordinate: s slides, t turns about the axis, h screws, u turns about the second
# axis, b: a ball with
# Euler parameters (four coordinates, three speeds: the angular velocity in axes of the child)
LETTERS = {
    'revolute': 't', 'prismatic': 's', 'helical': 'h', 'cylindrical': 'st', 'universal': 'tu',
    'planar': 'sst', 'fixed': '', 'spherical': 'b', 'free': 'sssb'
}


def skew(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def cross(a, b):
    return np.array([a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]])


def rodrigues(axis, angle):
    K = skew(axis)
    return np.eye(3) + math.sin(angle)*K + (1 - math.cos(angle))*K @ K


def of_quaternion(e):
    v = e[1:]
    return (e[0]*e[0] - v@v)*np.eye(3) + 2*np.outer(v, v) + 2*e[0]*skew(v)


def quaternion_product(p, q):
    return np.concatenate([[p[0]*q[0] - p[1:] @ q[1:]],
                           p[0]*q[1:] + q[0]*p[1:] + cross(p[1:], q[1:])])


def rotation_vector(R):
    """axis times angle, of a small rotation"""
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])/2


class Chain:
    """A frame that elementary motions carry along: R, p; S: columns [v; w] a speed; twist; bias
    of its rate."""

    def __init__(self):
        self.R, self.p = np.eye(3), np.zeros(3)
        self.columns, self.twist, self.bias = [], np.zeros(6), np.zeros(6)

    def go(self, step):
        r, w = self.R @ step, self.twist[3:]
        self.p = self.p + r
        self.columns = [np.concatenate([c[:3] + cross(c[3:], r), c[3:]]) for c in self.columns]
        self.bias[:3] += cross(self.bias[3:], r) + cross(w, cross(w, r))
        self.twist[:3] += cross(w, r)

    def rotate(self, R):
        self.R = self.R @ R

    def slide(self, axis, s, speed):
        e = self.R @ axis
        self.go(axis*s)
        self.bias[:3] += 2*cross(self.twist[3:], e)*speed
        self.twist[:3] += e*speed
        self.columns.append(np.concatenate([e, np.zeros(3)]))

    def turn(self, axis, angle, speed):
        e = self.R @ axis
        self.bias[3:] += cross(self.twist[3:], e)*speed
        self.twist[3:] += e*speed
        self.columns.append(np.concatenate([np.zeros(3), e]))
        self.R = self.R @ rodrigues(axis, angle)

    def screw(self, axis, pitch, angle, speed):
        self.slide(axis, pitch*angle, pitch*speed)
        self.turn(axis, angle, speed)
        turned, moved = self.columns.pop(), self.columns.pop()
        self.columns.append(turned + pitch*moved)

    def ball(self, e, w):
        self.R = self.R @ of_quaternion(e)
        own = self.R @ w
        self.bias[3:] += cross(self.twist[3:], own)
        self.twist[3:] += own
        self.columns += [np.concatenate([np.zeros(3), self.R[:, k]]) for k in range(3)]

    def partial(self):
        return np.array(self.columns).T.reshape(6, len(self.columns))


class Joint:
    """A joint with numbers; names: of its coordinates; options: what the scene writes of it."""

    def __init__(self, name, type, parent, child):
        self.name, self.type, self.parent, self.child = name, type, parent, child
        self.pitch, self.orientation, self.cut = 0., None, False
        self.axis, self.second = AXES['z'], AXES['x']
        self.at, self.child_at, self.R, self.child_R = np.zeros(3), np.zeros(3), np.eye(3), np.eye(
            3)
        self.names, self.options = [], {}

    def letters(self):
        word = LETTERS[self.type]
        return word.replace('b', 'ttt') if self.orientation else word

    def nq(self):
        return sum(4 if k == 'b' else 1 for k in self.letters())

    def nu(self):
        return sum(3 if k == 'b' else 1 for k in self.letters())

    def directions(self):
        """axes of the letters, one each"""
        if self.type == 'planar':
            n = next(w for w in 'xyz' if AXES[w] @ self.axis == 1)
            turn = 'xyz'.index(n)
            return [AXES['xyz'[(turn+1) % 3]], AXES['xyz'[(turn+2) % 3]], self.axis]
        axes = list(AXES.values()) if self.type == 'free' else []
        if self.orientation:
            return axes + [AXES[w] for w in self.orientation]
        return axes or [self.second if k == 'u' else self.axis for k in self.letters()]

    def relative(self, q, u):
        """the child's frame in the parent's"""
        c, axes, i, k = Chain(), self.directions(), 0, 0
        c.go(self.at)
        c.rotate(self.R)
        for n, letter in enumerate(self.letters()):
            if letter == 'b':
                c.ball(q[i:i + 4], u[k:k + 3])
            elif letter == 's':
                c.slide(axes[n], q[i], u[k])
            elif letter == 'h':
                c.screw(axes[n], self.pitch, q[i], u[k])
            else:
                c.turn(axes[n], q[i], u[k])
            i, k = (i + 4, k + 3) if letter == 'b' else (i + 1, k + 1)
        c.rotate(self.child_R.T)
        c.go(-self.child_at)
        return c

    def rates(self, q, u):
        """rates of the coordinates from the speeds"""
        if 'b' not in self.letters():
            return np.array(u, float)
        half = .5*quaternion_product(q[-4:], np.concatenate([[0.], u[-3:]]))
        return np.concatenate([u[:-3], half])

    def advanced(self, q, du):
        """the position that the small displacement du leads to (exact in the first order, of norm
        1)"""
        q = q + self.rates(q, du)
        if 'b' in self.letters():
            q[-4:] = q[-4:]/np.linalg.norm(q[-4:])
        return q
