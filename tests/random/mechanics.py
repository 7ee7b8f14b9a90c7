"""Newton and Euler for bodies that are free in space, a wrench for each joint, and the same
projected on the speeds."""
import numpy as np
from joints import cross, skew, rotation_vector

GROUND = 'ground'


class Body:
    """Motion of a link: R, p; J: columns [v; w] a speed of the tree; twist; bias: its rate where
    no speed changes."""

    def __init__(self, n):
        self.R, self.p = np.eye(3), np.zeros(3)
        self.J, self.twist, self.bias = np.zeros((6, n)), np.zeros(6), np.zeros(6)


class Relation:
    """A joint in ground axes: r from parent's to child's origin, S, relative twist, bias of the
    child's acceleration."""

    def __init__(self, parent_R, w, chain):
        turned = np.kron(np.eye(2), parent_R)
        self.R, self.r, self.S = chain.R, parent_R @ chain.p, turned @ chain.partial()
        self.twist, own = turned @ chain.twist, turned @ chain.bias
        self.bias = np.concatenate([
            cross(w, cross(w, self.r)) + 2*cross(w, self.twist[:3]) + own[:3],
            cross(w, self.twist[3:]) + own[3:]
        ])
        self.shift = np.eye(6)
        self.shift[:3, 3:] = -skew(self.r)


def child_of(P, chain, columns):
    s, C = Relation(P.R, P.twist[3:], chain), Body(P.J.shape[1])
    C.R, C.p = P.R @ s.R, P.p + s.r
    C.J = s.shift @ P.J
    C.J[:, columns] += s.S
    C.twist, C.bias = s.shift @ P.twist + s.twist, s.shift @ P.bias + s.bias
    return C


def parent_of(C, chain, columns):
    P = Body(C.J.shape[1])
    P.R = C.R @ chain.R.T
    w = C.twist[3:] - P.R @ chain.twist[3:]
    s = Relation(P.R, w, chain)
    back = np.linalg.inv(s.shift)
    P.p, J = C.p - s.r, C.J.copy()
    J[:, columns] -= s.S
    P.J, P.twist, P.bias = back @ J, back @ (C.twist - s.twist), back @ (C.bias - s.bias)
    return P


class State:
    """t, coordinates q and natural speeds u of the tree, own: {cut joint: (q, u)}, x: states of
    devices, v: inputs"""

    def __init__(self, t, q, u, own, x, v):
        self.t, self.q, self.u, self.own, self.x, self.v = t, q, u, own, x, v

    def with_speeds(self, u):
        return State(self.t, self.q, u, {k: (q, 0*w)
                                         for k, (q, w) in self.own.items()}, self.x, self.v)


class Mechanism:
    """links: dicts name, m, centre, I; joints; elements: what loads it (elements.py); conditions:
    laws, constraints"""

    def __init__(self):
        self.links, self.joints, self.elements, self.conditions = [], [], [], []
        self.gravity = np.zeros(3)
        self.mixing = None

    def number(self):
        self.tree, self.cuts = [j for j in self.joints
                                if not j.cut], [j for j in self.joints if j.cut]
        self.q_of, self.u_of, i, k = {}, {}, 0, 0
        for j in self.tree:
            self.q_of[j.name], self.u_of[j.name] = slice(i, i + j.nq()), slice(k, k + j.nu())
            i, k = i + j.nq(), k + j.nu()
        self.nq, self.nu, self.n_own = i, k, sum(j.nu() for j in self.cuts)

    def names(self):
        return [n for j in self.tree for n in j.names]

    def chain(self, j, s):
        if j.cut:
            return j.relative(*s.own[j.name])
        return j.relative(s.q[self.q_of[j.name]], s.u[self.u_of[j.name]])

    def bodies(self, s):
        found, todo = {GROUND: Body(self.nu)}, list(self.tree)
        while todo:
            j = next(j for j in todo if j.parent in found or j.child in found)
            todo.remove(j)
            if j.parent in found:
                found[j.child] = child_of(found[j.parent], self.chain(j, s), self.u_of[j.name])
            else:
                found[j.parent] = parent_of(found[j.child], self.chain(j, s), self.u_of[j.name])
        return found

    def rates(self, s):
        parts = [j.rates(s.q[self.q_of[j.name]], s.u[self.u_of[j.name]]) for j in self.tree]
        return np.concatenate([[]] + parts)

    def loads(self, s, bodies):
        loads = Loads(self)
        for e in self.elements:
            e.load(self, s, bodies, loads)
        return loads

    def inertia(self, link, b):
        """6x6 mass of a link about its origin, what its motion needs beside, its weight"""
        c, m = b.R @ link['centre'], link['m']
        C, w, turned = skew(c), b.twist[3:], b.R @ link['I'] @ b.R.T
        M = np.block([[m*np.eye(3), -m*C], [m*C, turned - m*C@C]])
        pull = m*cross(w, cross(w, c))
        beside = np.concatenate([pull, cross(w, turned @ w) + cross(c, pull)])
        return M, beside, np.concatenate([m*self.gravity, cross(c, m*self.gravity)])

    def projected(self, s):
        """mass matrix and bias forces of the tree, efforts of drives, loads"""
        bodies = self.bodies(s)
        loads = self.loads(s, bodies)
        M, B = np.zeros((self.nu, self.nu)), -loads.passive.copy()
        drive = loads.drive.copy()
        for l in self.links:
            b = bodies[l['name']]
            own, beside, weight = self.inertia(l, b)
            M += b.J.T @ own @ b.J
            B += b.J.T @ (own @ b.bias + beside - weight - loads.wrench[l['name']])
            drive += b.J.T @ loads.driven[l['name']]
        for k, port in loads.added:
            g, bend = port.in_tree(bodies)
            M += k*np.outer(g, g)
            B += k*g*bend
        return M, B, drive, loads


class Loads:
    """wrench, driven: on links about their origins, given and passive, and of drives; passive,
    drive: on the coordinates;
    added: [(mass, port)]; rates of device states; energies [potential of springs, stored, power
    in, power lost]"""

    def __init__(self, m):
        self.wrench = {l['name']: np.zeros(6) for l in m.links}
        self.wrench[GROUND] = np.zeros(6)
        self.driven = {k: np.zeros(6) for k in self.wrench}
        self.passive, self.drive, self.added, self.rates = np.zeros(m.nu), np.zeros(m.nu), [], {}
        self.signals = {}  # of sensors, controllers, amplifiers
        self.held = []     # [(device, port)]: their accelerations are 0
        self.potential = self.stored = self.power = self.lost = 0.

    def at_port(self, port, passive, drive=0.):
        for name, g in port.on_bodies.items():
            self.wrench[name] += passive*g
            self.driven[name] += drive*g
        self.passive += passive*port.on_speeds
        self.drive += drive*port.on_speeds


class Solution:
    """ud of the tree, reactions {joint: force and moment on the child at its joint point}, missing:
    0 if they are unique, holding: efforts of ports that are held"""


def maximal(m, s, tau):
    """accelerations and reactions from the equations of all bodies and all joints at once"""
    bodies = m.bodies(s)
    loads = m.loads(s, bodies)
    A, B, place = maximal_equations(m, s, bodies, loads, tau)
    scale = np.max(np.abs(A), axis=1)
    scale[scale == 0] = 1
    As, Bs = A/scale[:, None], B/scale
    x, _, rank, sv = np.linalg.lstsq(As, Bs, rcond=1e-12)
    for _ in range(2):
        x = x + np.linalg.lstsq(As, Bs - As@x, rcond=1e-12)[0]
    r = Solution()
    r.residual = np.max(np.abs(As@x - Bs))/max(1, np.max(np.abs(Bs)))
    r.ud, r.missing, r.loads = x[place['ud']:place['ud'] + m.nu], len(x) - rank, loads
    r.holding = dict(zip([name for name, _ in loads.held], x[place['held']:]))
    r.gap = sv[rank - 1]/sv[0]
    r.reactions = {}
    for i, j in enumerate(m.joints):
        f = x[place['wrench'] + 6*i:place['wrench'] + 6*i + 6]
        point = bodies[j.child].R @ j.child_at
        r.reactions[j.name] = np.concatenate([f[:3], f[3:] - cross(point, f[:3])])
    for e in m.elements:
        if hasattr(e, 'read'):
            e.read(s, bodies, r)
    return r


def maximal_equations(m, s, bodies, loads, tau):
    nb, nj = len(m.links), len(m.joints)
    place = {'wrench': 6*nb, 'ud': 6*nb + 6*nj, 'own': 6*nb + 6*nj + m.nu}
    place['more'] = place['own'] + m.n_own
    rows = [c.rows(m, s, bodies) for c in m.conditions]
    place['held'] = place['more'] + sum(len(r.gamma) for r in rows)
    N = place['held'] + len(loads.held)
    A, B = np.zeros((N, N)), np.zeros(N)
    link = {l['name']: 6*k for k, l in enumerate(m.links)}
    for l in m.links:
        k = slice(link[l['name']], link[l['name']] + 6)
        own, beside, weight = m.inertia(l, bodies[l['name']])
        A[k, k], B[k] = own, weight - beside + loads.wrench[l['name']] + loads.driven[l['name']]
    B[place['ud']:place['own']] = loads.passive + loads.drive + tau
    own = place['own']
    for i, j in enumerate(m.joints):
        column = own if j.cut else place['ud'] + m.u_of[j.name].start
        own += j.nu() if j.cut else 0
        P = bodies[j.parent]
        joint_equations(A, B, link, place['wrench'] + 6*i, column, j,
                        Relation(P.R, P.twist[3:], m.chain(j, s)))
    add_conditions(A, B, link, place, loads, rows)
    return A, B, place


def add_conditions(A, B, link, place, loads, rows):
    """added masses of devices; rows of laws, constraints and ports that are held, with
    their multipliers"""
    for k, port in loads.added:
        g = port.in_all(link, place['ud'], len(B))
        A += k*np.outer(g, g)
        B -= k*g*port.bend
    more = place['more']
    for r in rows:
        G = r.in_all(link, place['ud'], len(B))
        k = slice(more, more + len(r.gamma))
        A[k], A[:, k], B[k] = A[k] + G, A[:, k] - G.T, r.gamma
        more += len(r.gamma)
    for k, (_, port) in enumerate(loads.held, place['held']):
        g = port.in_all(link, place['ud'], len(B))
        A[k], A[:, k], B[k] = A[k] + g, A[:, k] - g, -port.bend


def joint_equations(A, B, link, row, column, j, s):
    """rows: child's acceleration from the parent's; columns: the wrench on the child, its
    opposite on the parent"""
    n = s.S.shape[1]
    k = slice(row, row + 6)
    if j.child in link:
        c = slice(link[j.child], link[j.child] + 6)
        A[k, c] += np.eye(6)
        A[c, k] -= np.eye(6)
    if j.parent in link:
        p = slice(link[j.parent], link[j.parent] + 6)
        A[k, p] -= s.shift
        A[p, k] += s.shift.T
    A[k, column:column + n] -= s.S
    A[column:column + n, k] += s.S.T
    B[k] = s.bias


def closing_rows(m, s, bodies):
    """gap of positions, matrix on [speeds of the tree, own speeds of cut joints], wanted rates"""
    gaps, G, wanted, own = [], [], [], 0
    for j in m.cuts:
        P, C = bodies[j.parent], bodies[j.child]
        c = Relation(P.R, P.twist[3:], m.chain(j, s))
        turn = rotation_vector(C.R @ (P.R @ c.R).T)
        gaps.append(np.concatenate([C.p - P.p - c.r, turn]))
        block = np.zeros((6, m.nu + m.n_own))
        block[:, :m.nu] = C.J - c.shift @ P.J
        block[:, m.nu + own:m.nu + own + j.nu()] = -c.S
        own += j.nu()
        G.append(block)
        wanted.append(np.zeros(6))
    for c in m.conditions:
        r = c.rows(m, s, bodies)
        gaps.append(r.gap)
        G.append(np.hstack([r.in_tree(bodies, m.nu), np.zeros((len(r.gamma), m.n_own))]))
        wanted.append(r.wanted)
    if not G:
        return np.zeros(0), np.zeros((0, m.nu)), np.zeros(0)
    return np.concatenate(gaps), np.vstack(G), np.concatenate(wanted)


def closed(m, s, tries=40):
    """the position near s where the loops close, and how far they are from it"""
    gap = np.zeros(1)
    for _ in range(tries):
        gap, G, _ = closing_rows(m, s, m.bodies(s))
        if not len(gap) or np.max(np.abs(gap)) < 1e-14:
            break
        step = np.linalg.lstsq(G, -gap, rcond=1e-9)[0]
        step = step/max(1, np.max(np.abs(step))/.5)
        s = displaced(m, s, step)
    return s, (np.max(np.abs(gap)) if len(gap) else 0.)


def displaced(m, s, step):
    q, own, k = s.q.copy(), {}, m.nu
    for j in m.tree:
        q[m.q_of[j.name]] = j.advanced(s.q[m.q_of[j.name]], step[m.u_of[j.name]])
    for j in m.cuts:
        own[j.name] = (j.advanced(s.own[j.name][0], step[k:k + j.nu()]), s.own[j.name][1])
        k += j.nu()
    return State(s.t, q, s.u, own, s.x, s.v)


class Freedom:
    """how speeds may be: free directions, rank, smallest kept over largest singular value,
    whether the rows are met"""


def moving(m, s, wish):
    """s with speeds nearest to wish (tree, then cut joints) that keep the loops closed, and its
    Freedom"""
    _, G, wanted = closing_rows(m, s.with_speeds(0*s.u), m.bodies(s.with_speeds(0*s.u)))
    f = Freedom()
    if len(G):
        sv = np.linalg.svd(G, compute_uv=False)
        f.rank = int(np.sum(sv > 1e-9*sv[0]))
        f.gap, f.lowest = sv[f.rank - 1]/sv[0] if f.rank else 1., sv[f.rank - 1] if f.rank else 1.
        wish = wish - np.linalg.lstsq(G, G@wish - wanted, rcond=1e-9)[0]
        f.met = np.max(np.abs(G@wish - wanted)) < 1e-9*max(1, np.max(np.abs(wish)))
    else:
        f.rank, f.gap, f.lowest, f.met = 0, 1., 1., True
    f.free, f.rows = len(wish) - f.rank, len(G)
    own, k = {}, m.nu
    for j in m.cuts:
        own[j.name] = (s.own[j.name][0], wish[k:k + j.nu()])
        k += j.nu()
    return State(s.t, s.q, wish[:m.nu], own, s.x, s.v), f
