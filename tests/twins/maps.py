"""What becomes of states, inputs and outputs of a scene in its twin."""
import numpy as np


def turn(e):
    """rotation by Euler parameters"""
    w, v = e[0], np.array(e[1:])
    cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return (w*w - v @ v)*np.eye(3) + 2*np.outer(v, v) + 2*w*cross


class Ball:
    """a reversed joint with Euler parameters: the inverse turn, seen from the other side"""

    def __init__(self, joint, names):
        self.names, self.speeds = names, [joint + '_w' + w for w in 'xyz']

    def apply(self, x, change, rates):
        """states `change`, or rates of them at the state x, all by name"""
        R = turn([x[n] for n in self.names])
        new = dict(zip(self.speeds, -R @ [change[n] for n in self.speeds]))
        new.update({n: -change[n] for n in self.names[1:]})
        return new


class Flight(Ball):
    """a reversed free joint with Euler parameters"""

    def __init__(self, joint, names):
        super().__init__(joint, names[3:])
        self.places = names[:3]

    def apply(self, x, change, rates):
        new, R = super().apply(x, change, rates), turn([x[n] for n in self.names]).T
        of = lambda values, end: R @ [values[n + end] for n in self.places]
        w = np.array([x[n] for n in self.speeds])
        p, v = of(x, ''), of(x, '_d')
        place, speed = -p, -v + np.cross(w, p)
        if rates:
            a, dw = of(change, '_d'), [change[n] for n in self.speeds]
            place, speed = speed, (-a + 2*np.cross(w, v) + np.cross(dw, p)
                                   - np.cross(w, np.cross(w, p)))
        new.update(zip(self.places, place))
        new.update(zip([n + '_d' for n in self.places], speed))
        return new


class Glide:
    """a reversed planar joint: places as complex numbers"""

    def __init__(self, joint, names):
        self.names = names

    def apply(self, x, change, rates):
        (a, b, turn), d = self.names, [n + '_d' for n in self.names]
        z, v, w = complex(x[a], x[b]), complex(x[d[0]], x[d[1]]), x[d[2]]
        back = -np.exp(-1j*x[turn])
        place, speed = back*z, back*(v - 1j*w*z)
        if rates:
            place, speed = speed, back*(complex(change[d[0]], change[d[1]]) - 2j*w*v
                                        - 1j*change[d[2]]*z - w*w*z)
        return {a: place.real, b: place.imag, turn: -change[turn], d[0]: speed.real,
                d[1]: speed.imag, d[2]: -change[d[2]]}


class Map:
    """names: {old: new}; signs: {old: -1}; R, p: of the base; joints: those that are reversed;
    run: {parameter: value} that are set when the code runs; other_rows: whether constraints have
    other values where they are not fulfilled"""

    def __init__(self):
        self.names, self.signs, self.balls, self.joints, self.run = {}, {}, [], set(), {}
        self.R, self.p, self.done, self.other_rows = np.eye(3), np.zeros(3), [], False

    def base(self, R, p):
        self.R = np.array([[float(x) for x in row] for row in R])
        self.p = np.array([float(x.value) for x in p])

    def reversed(self, joint):
        self.joints.add(joint)

    def values(self):
        return {self.renamed(n): v for n, v in self.run.items()}

    def renamed(self, word):
        """a word with the name in it: M4.i, q1_d"""
        for mark in ('.', '_'):
            head, found, rest = word.partition(mark)
            if head in self.names:
                return self.names[head] + found + rest
        return word

    def forth(self, x, change=None):
        """{new name: value} of states, or of rates at the state x"""
        rates, change = change is not None, x if change is None else change
        new = {n: self.signs.get(n, 1)*v for n, v in change.items()}
        for ball in self.balls:
            new.update(ball.apply(x, change, rates))
        return {self.renamed(n): v for n, v in new.items()}

    def output(self, name, joint, parts):
        """components {new name: value} of a reaction: of force and moment, in axes of ground"""
        sign = -1 if joint in self.joints else 1
        six = np.array([parts.get(k, 0.) for k in ('x', 'y', 'z', 'mx', 'my', 'mz')])
        six = sign*np.concatenate([self.R @ six[:3], self.R @ six[3:]])
        return {'%s.%s' % (self.renamed(name), k): v
                for k, v in zip(('x', 'y', 'z', 'mx', 'my', 'mz'), six)}
