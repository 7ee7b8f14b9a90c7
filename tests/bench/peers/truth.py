"""truth.py FOLDER: the coordinates at the end by equations and an integrator of their own, in 25
digits: Newton's and Euler's equations of every body in ground axes, projected on partial velocities
(mpmath), loops by multipliers; extrapolation by Gragg, Bulirsch and Stoer in two step sizes. Prints
a ROW whose setting is the difference of the two."""
import hashlib
import os
import sys
import mpmath as mp
from model import Model, row
mp.mp.dps = 25
ZERO = mp.matrix(3, 1)

def cross(a, b):
    return mp.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]])

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

class Bodies:
    """the links in exact numbers"""
    def __init__(self, model):
        self.n = model.n
        self.gravity = mp.matrix(model.gravity)
        self.pin = None if model.pin is None else mp.mpf(model.pin)
        self.links = [(parent, kind, mp.matrix(R.tolist()), mp.matrix(at), mp.mpf(mass),
                       mp.matrix(centre),
                       mp.matrix([[J[0], J[3], J[5]], [J[3], J[1], J[4]], [J[5], J[4], J[2]]]))
                      for parent, kind, R, at, mass, centre, J in model.links]

    def place(self, i, q, v, before):
        """R, origin, w, w', v', partial (linear at the origin, angular) of link i"""
        _, kind, R0, at, *_ = self.links[i]
        R, o, w, wd, a, partial = before
        r = R * at
        R = R * R0
        z = R[:, 2]
        if kind == 'P':
            r = r + q * z
        a = a + cross(wd, r) + cross(w, cross(w, r))
        partial = [(vl + cross(vw, r), vw) for vl, vw in partial]
        o = o + r
        if kind == 'R':
            c, s = mp.cos(q), mp.sin(q)
            R = R * mp.matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])
            wd, w = wd + v * cross(w, z), w + v * z
            partial[i] = (ZERO, z)
        else:
            a = a + 2 * v * cross(w, z)
            partial[i] = (z, ZERO)
        return R, o, w, wd, a, partial

    def accelerations(self, q, v):
        n = self.n
        M, b, places = mp.matrix(n, n), mp.matrix(n, 1), []
        ground = (mp.eye(3), ZERO, ZERO, ZERO, ZERO, [(ZERO, ZERO)] * n)
        for i, (parent, _, _, _, mass, centre, J) in enumerate(self.links):
            before = ground if parent < 0 else places[parent]
            places.append(self.place(i, q[i], v[i], before[:5] + (list(before[5]),)))
            R, _, w, wd, a, partial = places[i]
            c, J = R * centre, R * J * R.T
            force = mass * (a + cross(wd, c) + cross(w, cross(w, c)) - self.gravity)
            moment = J * wd + cross(w, J * w)
            moved = [(vl + cross(vw, c), vw, J * vw) for vl, vw in partial]
            for j in range(n):
                b[j] += dot(moved[j][0], force) + dot(moved[j][1], moment)
                for k in range(j + 1):
                    M[j, k] += mass * dot(moved[j][0], moved[k][0]) + dot(moved[j][1], moved[k][2])
        for j in range(n):
            for k in range(j):
                M[k, j] = M[j, k]
        if self.pin is None:
            return mp.lu_solve(M, -b)
        return self.closed(M, b, places)

    def closed(self, M, b, places):
        """the pin of the last but one link stays on the last one's origin, in x and y"""
        n = self.n
        R, _, w, wd, a, partial = places[n - 2]
        r = self.pin * R[:, 0]
        rate = a + cross(wd, r) + cross(w, cross(w, r)) - places[n - 1][4]
        K, y = mp.matrix(n + 2, n + 2), mp.matrix(n + 2, 1)
        for j in range(n):
            y[j] = -b[j]
            d = partial[j][0] + cross(partial[j][1], r) - places[n - 1][5][j][0]
            for k in range(n):
                K[j, k] = M[j, k]
            for k in (0, 1):
                K[j, n + k] = K[n + k, j] = d[k]
        for k in (0, 1):
            y[n + k] = -rate[k]
        return mp.lu_solve(K, y)[:n]

def extrapolated(rates, y, end, steps, order):
    """modified midpoint rule, extrapolated, equal large steps"""
    big = mp.mpf(end) / steps
    for _ in range(steps):
        first, table = rates(y), []
        for k in range(order):
            count = 2 * (k + 1)
            h = big / count
            old, new = y, [a + h * d for a, d in zip(y, first)]
            for _ in range(count - 1):
                old, new = new, [a + 2 * h * d for a, d in zip(old, rates(new))]
            line = [[(a + c + h * d) / 2 for a, c, d in zip(old, new, rates(new))]]
            for j in range(k):
                w = (mp.mpf(count) / (2 * (k - j))) ** 2 - 1
                line.append([a + (a - c) / w for a, c in zip(line[j], table[-1][j])])
            table.append(line)
        y = table[-1][-1]
    return y

def main(folder):
    """what was found once for these files stays in truth.txt"""
    key = hashlib.md5(b''.join(open(folder + file, 'rb').read()
                               for file in ('/model.txt', '/start.txt'))).hexdigest()
    kept = folder + '/truth.txt'
    words = open(kept).read().split() if os.path.exists(kept) else ['']
    if words[0] == key:
        row('mpmath', float(words[1]), 0, 0, [float(w) for w in words[2:]])
        return
    model = Model(folder)
    bodies, n = Bodies(model), model.n
    rates = lambda y: list(y[n:]) + list(bodies.accelerations(y[:n], y[n:]))
    start = [mp.mpf(float(x)) for x in (*model.q, *model.v)]
    coarse, fine = (extrapolated(rates, start, model.end, steps, 9)
                    for steps in ((36, 48) if model.pin is None else (100, 128)))
    certain = float(max(abs(a - b) for a, b in zip(coarse[:n], fine[:n])))
    row('mpmath', certain, 0, 0, fine[:n])
    with open(kept, 'w') as file:
        file.write(' '.join([key, repr(certain)] + ['%.17g' % x for x in fine[:n]]))

main(sys.argv[1])
