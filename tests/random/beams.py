#!/usr/bin/python3
"""beams.py FOLDER FIRST COUNT: COUNT trees and loops with beams made by chance from the seed FIRST
on, against an absolute Lagrange formulation with the same shapes (beam_trees.py).

One session of Maxima evaluates with 30 digits what is on the tape of each scene (beams.mac): mass
matrix, bias, inverse dynamics, accelerations by every way, energies, rows of the loop. Prints a
line for each that is wrong. Exit code 0 only if all are right to 1e-10 of the largest entry."""
import os
import random
import subprocess
import sys
import numpy as np
from beam_trees import Beam, Tree, solve, STEP, L, C

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
LIMIT = 1e-10
AXES = ([0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, -1], [1, 0, 1], [1, 2, 2])


def vector(v):
    return '[%s]' % ', '.join(str(x) for x in v)


class Drawn:
    """a scene from a seed: its text, its tree, a state"""

    def __init__(self, seed):
        self.seed, r = seed, random.Random(seed)
        self.r, self.flat = r, r.random() < 0.4
        self.bodies, self.elements, self.joints, self.names = [], [], [], []
        for k in range(r.choice((2, 2, 3, 4))):
            self.add_body(k)
        gravity = [self.number(3), -9.0, 0 if self.flat else self.number(3)]
        self.tree = Tree(len(self.names), gravity, self.bodies)
        modal = [k for b in self.bodies for k in b.get('coordinates', [])]
        self.q = [self.number(0.04 if k in modal else 1.2) for k in range(len(self.names))]
        self.u = [self.number(0.5 if k in modal else 2) for k in range(len(self.names))]
        self.ud = [self.number(3) for _ in self.names]
        self.tau = [self.number(5) for _ in self.names]
        self.gravity, self.loop = gravity, None
        if r.random() < 0.6:
            self.close()

    def number(self, size):
        """decimals are exact on both sides: a multiple of 2^-20"""
        return round(self.r.uniform(-size, size)*2**20)/2**20

    def place(self, size):
        return [self.number(size), self.number(size), 0 if self.flat else self.number(size)]

    def add_body(self, k):
        r = self.r
        parent = None if k == 0 else r.choice([k - 1]*5 + list(range(-1, k)))
        parent = None if parent == -1 else parent
        beam = k == 0 or r.random() < 0.6
        b = {'parent': parent, 'station': None, 'at': self.place(0.3), 'child_at': [0, 0, 0],
             'child_station': None, 'sign': r.choice((1, 1, 1, -1)),
             'kind': r.choice(('turn', 'turn', 'turn', 'slide', 'fixed')), 'coordinate': None,
             'axis': [0, 0, 1] if self.flat else r.choice(AXES), 'name': 'abcd'[k]}
        if b['kind'] == 'slide' and self.flat:
            b['axis'] = r.choice(([1, 0, 0], [3, 4, 0]))
        if parent is not None and 'beam' in self.bodies[parent]:
            b['station'] = r.choice((None, 1, 1, 0.5, 0.25))
        if b['kind'] != 'fixed':
            b['coordinate'] = len(self.names)
            self.names.append('q%d' % (k + 1))
        if beam:
            self.add_beam(b)
        else:
            self.add_rigid(b)
        self.bodies.append(b)
        self.joints.append(self.joint(b, k))

    def add_rigid(self, b):
        m = abs(self.number(2)) + 0.25
        d = [abs(self.number(0.3)) + 0.5 for _ in range(3)]
        o = [0, 0, 0] if self.flat else [self.number(0.1) for _ in range(3)]
        b.update(mass=m, centre=self.place(0.3), child_at=self.place(0.2),
                 inertia=[[d[0], o[0], o[2]], [o[0], d[1], o[1]], [o[2], o[1], d[2]]])
        self.elements.append('link(%s, mass = %r, centre = %s, inertia = %s)' % (
            b['name'], m, vector(b['centre']), vector([d[0], d[1], d[2], o[0], o[1], o[2]])))

    def add_beam(self, b):
        r = self.r
        length, rho = 0.5 + abs(self.number(1)), 0.5 + abs(self.number(2))
        bending = ['y'] if self.flat else r.choice((['y'], ['z'], ['y', 'z'], ['z', 'y'], []))
        ends = r.choice(('clamped_free',)*3 + ('pinned_pinned', 'clamped_clamped', [2, 3]))
        twist = not self.flat and (bending == [] or r.random() < 0.3)
        stretch = r.random() < 0.3
        inertia = [0.0, 0.0, 0.0]
        if twist or (not self.flat and r.random() < 0.3):
            inertia = [abs(self.number(0.1)) + 0.0625 for _ in range(3)]
        model = r.choice(('second', 'second', 'full', 'linear'))
        if not bending and not isinstance(ends, str):   # own shapes are those of bending
            ends = 'clamped_free'
        families = [(d, ends, 20*(k + 1)) for k, d in enumerate(bending)]
        far = 'fixed_fixed' if ends in ('pinned_pinned', 'clamped_clamped') else 'fixed_free'
        families += [('twist', far, 30)]*twist + [('stretch', far, 400)]*stretch
        counts = [r.choice((1, 2)) for _ in families]
        ratio = r.choice((0, 0.0625))
        modes = [[f[0], f[1], i + 1, f[2], ratio] for f, n in zip(families, counts)
                 for i in range(n)]
        b['coordinates'] = list(range(len(self.names), len(self.names) + len(modes)))
        b['model'] = model
        self.names += ['%s_%d' % (b['name'], i + 1) for i in range(len(modes))]
        b['beam'] = Beam(length, rho, [L(x) for x in inertia], model, modes)
        # held at a section of its own
        if b['parent'] is not None and r.random() < 0.4:
            b['child_station'] = r.choice((1, 0.5))
        words = ['length = %r' % length, 'mass_per_length = %r' % rho,
                 'bending = [%s]' % ', '.join(bending), 'modes = %s' % counts,
                 'ends = %s' % (ends if isinstance(ends, str) else
                                vector('xi^%d' % k for k in ends)), 'assumptions = %s' % model]
        if bending:
            words.append('stiffness = %s' % [f[2] for f in families[:len(bending)]])
        words += ['torsion = 30']*twist + ['stretch = 400']*stretch
        if any(inertia):
            words.append('section_inertia = %s' % inertia)
        if ratio:
            words.append('damping = %r' % ratio)
        self.elements.append('beam(%s, %s)' % (b['name'], ', '.join(words)))

    def at_of(self, body, station, at):
        """the place of an element on a link, as it is written"""
        if station is not None:
            length = float(self.bodies[body]['beam'].length) if body < len(self.bodies) else None
            return [station*length, at[1], at[2]]
        return at

    def joint(self, b, k):
        if b['parent'] is None:
            before, at = 'ground', b['at']
        else:
            before = self.bodies[b['parent']]['name']
            if b['station'] is not None:
                b['at'] = [0, b['at'][1], b['at'][2]]
            elif 'beam' in self.bodies[b['parent']]:
                b['at'] = [0, 0, 0]
            at = self.at_of(b['parent'], b['station'], b['at'])
        own = b['child_at']
        if b['child_station'] is not None:
            own = self.at_of(k, b['child_station'], own)
        links = [(before, at), (b['name'], own)][::b['sign']]
        word = {'turn': 'revolute', 'slide': 'prismatic', 'fixed': 'fixed'}[b['kind']]
        more = '' if b['kind'] == 'fixed' else ', axis = %s, coordinate = q%d' % (
            vector(b['axis']), k + 1)
        return '%s(j%s, %s, %s, at = %s, child_at = %s%s)' % (
            word, b['name'], links[0][0], links[1][0], vector(links[0][1]), vector(links[1][1]),
            more)

    def close(self):
        """a ball between the last link and ground, or between a beam and a rigid link, where they
        are; speeds that keep it closed"""
        k = len(self.bodies) - 1
        station = self.r.choice((1, 0.5)) if 'beam' in self.bodies[k] else None
        at = [0, 0.0625, 0] if station is not None else self.place(0.2)
        frames = self.tree.frames(np.array(self.q, C))
        R, p, _, _ = self.tree.mounting(frames, k, station, np.array(self.q, C))
        where_ = (p + R @ np.array(at, C)).real
        other = [j for j, b in enumerate(self.bodies[:k]) if 'mass' in b]
        other = self.r.choice(other) if other and self.r.random() < 0.5 else None
        if other is not None:
            R, p, _, _ = frames[other]
            where_ = (R.T @ (where_ - p)).real
        where_ = [float(x) for x in where_]
        if self.flat:
            where_[2] = 0
        self.loop = [(other, None, where_), (k, station, at)]
        J = self.tree.gap(self.loop, self.q)[1].real.astype(float)
        J = J[:2] if self.flat else J
        if np.linalg.matrix_rank(J, 1e-2) < len(J) or len(J) >= self.tree.n:
            self.loop = None
            return
        u = np.array(self.u)
        self.u = [float(x) for x in u - np.linalg.pinv(J) @ (J @ u)]
        name = 'ground' if other is None else self.bodies[other]['name']
        self.joints.append('%s(close, %s, %s, at = %s, child_at = %s%s, cut = true)' % (
            'revolute' if self.flat else 'spherical', name, self.bodies[k]['name'],
            vector(where_), vector(self.at_of(k, station, at)), ', axis = z'*self.flat))

    def text(self):
        return 'scene : gsmbp_scene("beams%d", gravity = %s,\n  %s)$\n' % (
            self.seed, vector(self.gravity), ',\n  '.join(self.elements + self.joints))

    def state(self):
        pairs = lambda prefix, v: ', '.join('%s%s = %r' % (prefix, n, x)
                                            for n, x in zip(self.names, v))
        return '[[%s], [%s], [%s], [%s]]' % (pairs('', self.q), pairs('', self.u),
                                             pairs('', self.ud), pairs('', self.tau))

    def expected(self):
        M, bias, T, V = self.tree.terms(self.q, self.u)
        ud, tau = np.array(self.ud, L), np.array(self.tau, L)
        e = {'M': M, 'bias': bias, 'inverse': M @ ud + bias, 'energies': np.array([T, V])}
        n = self.tree.n
        e['forward'] = solve(M, tau - bias)
        if self.loop:
            J = self.tree.gap(self.loop, self.q)[1].real
            z = np.array(self.q, C) + 1j*STEP*np.array(self.u, L)
            rate = np.imag(self.tree.gap(self.loop, z)[1])/STEP @ np.array(self.u, L)
            m = 2 if self.flat else 3
            A = np.block([[M, J[:m].T], [J[:m], np.zeros((m, m), L)]])
            e['closed'] = solve(A, np.concatenate([tau - bias, -rate[:m]]))[:n]
        return e


def numbers(folder, drawn):
    """{seed: {word: values}} by Maxima; what a session says where it fails"""
    for d in drawn:
        with open('%s/beams%d.mac' % (folder, d.seed), 'w') as f:
            f.write(d.text() + 'state_ : %s$\n' % d.state())
    with open(folder + '/all.mac', 'w') as f:
        f.write('load("%s/tests/random/beams.mac")$\n' % ROOT)
        for d in drawn:
            f.write('beams_values("%s", "beams%d")$\n' % (folder, d.seed))
    subprocess.run(
        [ROOT + '/share/make/maxima', folder + '/all.log',
         'load("%s/gsmbp/gsmbp.mac")$ batchload("%s/all.mac")$' % (ROOT, folder)], check=False,
        stderr=subprocess.DEVNULL, cwd=folder, env={**os.environ, 'GSMBP_TIMEOUT': '36000'})
    return {d.seed: values('%s/beams%d.values' % (folder, d.seed)) for d in drawn}


def values(path):
    found = {}
    if os.path.exists(path):
        for line in open(path):
            word, *rest = line.split()
            found[word] = rest
    return found


def judge(d, found):
    """[what is wrong, largest difference]"""
    if 'NAMES' not in found:
        return ['no values: %s' % ' '.join(found.get('ERROR', ['the session failed']))[:400]]
    order = [d.names.index(n.lower()) for n in found['NAMES']]
    wrong, e, n = [], d.expected(), len(order)
    for word, v in found.items():
        if word in ('NAMES', 'ERROR'):
            continue
        key = 'forward' if word.startswith('FORWARD') else word.lower()
        want = e['M'][np.ix_(order, order)].ravel() if key == 'm' else \
            e[key] if key == 'energies' else e[key][order]
        got = np.array([L(x.lower().replace('b', 'e')) for x in v])
        off = np.max(np.abs(got - want))/np.max(np.abs(want))
        if key == 'forward' and off > LIMIT and np.linalg.cond(e['M'].astype(float)) > 1e6:
            a = np.zeros(n, L)
            a[order] = got
            parts = e['M']*a
            off = np.max(np.abs(parts.sum(1) - e['M'] @ e['forward']))/np.max(np.abs(parts))
        judge.worst[word] = max(judge.worst.get(word, 0), off)
        judge.count[word] = judge.count.get(word, 0) + 1
        if not off <= LIMIT:
            wrong.append('%s %.1e' % (word, off))
    missing = [w for w in ('M', 'BIAS', 'INVERSE', 'ENERGIES', 'FORWARD_mass') +
               ('CLOSED',)*bool(d.loop) if w not in found]
    return wrong + ['no %s' % w for w in missing]


judge.worst, judge.count = {}, {}


def main(folder, first, count):
    os.makedirs(folder, exist_ok=True)
    drawn = [Drawn(s) for s in range(first, first + count)]
    for d in drawn:
        path = '%s/beams%d.values' % (folder, d.seed)
        if os.path.exists(path):
            os.remove(path)
    found, bad = numbers(folder, drawn), 0
    for d in drawn:
        wrong = judge(d, found[d.seed])
        if wrong:
            bad += 1
            print('not ok beams of seed %d: %s' % (d.seed, '; '.join(wrong)))
    kinds = '%d beams, %d held at a section, %d loops' % (
        sum('beam' in b for d in drawn for b in d.bodies),
        sum(b['child_station'] is not None for d in drawn for b in d.bodies),
        sum(d.loop is not None for d in drawn))
    print('   # %s; largest differences: %s' % (kinds, ', '.join(
        '%s %.0e (%d)' % (w, x, judge.count[w]) for w, x in sorted(judge.worst.items()))))
    print('%s %d scenes of beams by chance from seed %d: all values within %g' % (
        'not ok' if bad else 'ok', count, first, LIMIT))
    return bad > 0


if __name__ == '__main__':
    sys.exit(main(os.path.abspath(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])))
