"""Operations of the two-link arm of arm.mac as CasADi and SymPy have them.

The energies of the model `second` are written by hand from the modal integrals, each product of a
mass and an integral one symbol, every number that the parameters decide once; the equations of
motion are their derivatives (Lagrange), with cse over each result. Prints for each peer and each of
inverse dynamics, mass matrix, forward dynamics: multiplications, additions, divisions, sines and
cosines. peers.py casadi | sympy"""
import sys


class Arm:
    """Energies over one algebra: symbol(name), sin, cos."""

    def __init__(self, symbol, sin, cos):
        self.sin, self.cos, self.symbol = sin, cos, symbol
        self.q = [symbol('q%d' % k) for k in range(6)]
        self.u = [symbol('u%d' % k) for k in range(6)]

    def beam(self, name, v, w, q, u, angle):
        """[T, V] of a beam whose root moves with v (its axes) and w; V without the root's height"""
        s = lambda word: self.symbol(name + word)
        m, h, J = s('m'), s('h'), s('J')
        b, c, k = [s('b1'), s('b2')], [s('c1'), s('c2')], [s('k1'), s('k2')]
        E, D = [[[s(x + '11'), s(x + '12')], [s(x + '12'), s(x + '22')]] for x in 'ED']
        form = lambda A, x, y: sum(A[i][j] * x[i] * y[j] for i in (0, 1) for j in (0, 1))
        dot = lambda x, y: x[0] * y[0] + x[1] * y[1]
        cx, cy = h - form(E, q, q) / 2, dot(b, q)
        T = (m * dot(v, v) / 2 + w * (v[1] * cx - v[0] * cy)
             + w * w * (J + m * dot(q, q) - form(D, q, q)) / 2
             - v[0] * form(E, q, u) + v[1] * dot(b, u) + w * dot(c, u) + m * dot(u, u) / 2)
        g = self.symbol('g')
        V = (g * (self.sin(angle) * cx + self.cos(angle) * cy)
             + (k[0] * q[0] * q[0] + k[1] * q[1] * q[1]) / 2)
        return T, V

    def tip(self, name, L, v, w, q, u):
        """[place, velocity, turn, rate] of the end in axes of the beam"""
        s = lambda word: self.symbol(name + word)
        G = [[s('g11'), s('g12')], [s('g12'), s('g22')]]
        form = lambda x, y: sum(G[i][j] * x[i] * y[j] for i in (0, 1) for j in (0, 1))
        x, y = L - form(q, q) / 2, 2 * q[0] - 2 * q[1]
        xd, yd = -form(q, u), 2 * u[0] - 2 * u[1]
        turn, rate = (s('s1') * a[0] + s('s2') * a[1] for a in (q, u))
        return [x, y], [v[0] - w * y + xd, v[1] + w * x + yd], turn, w + rate

    def turned(self, v, a):
        """a vector in axes turned by a"""
        s, c = self.sin(a), self.cos(a)
        return [c * v[0] + s * v[1], c * v[1] - s * v[0]]

    def energies(self):
        q, u, sym = self.q, self.u, self.symbol
        g = sym('g')
        w, angle = u[0], q[0]
        T = sym('Jh1') * w * w / 2
        a1 = sym('a1')
        t, V = self.beam('A', [0, w * a1], w, q[1:3], u[1:3], angle)
        T, V = T + t, V + sym('Am') * g * a1 * self.sin(angle)
        r, v, turn, w = self.tip('A', sym('L1'), [0, w * a1], w, q[1:3], u[1:3])
        height = self.sin(angle) * (a1 + r[0]) + self.cos(angle) * r[1]
        angle += turn
        ms = sym('ms')
        T += ms * (v[0] * v[0] + v[1] * v[1]) / 2 + sym('Js') * w * w / 2
        V += ms * g * height
        w, a2 = w + u[3], sym('a2')
        v = self.turned(v, turn + q[3])
        angle += q[3]
        T += sym('Jr') * w * w / 2
        v = [v[0], v[1] + w * a2]
        height += self.sin(angle) * a2
        t, more = self.beam('B', v, w, q[4:6], u[4:6], angle)
        T, V = T + t, V + more + sym('Bm') * g * height
        r, v, turn, w = self.tip('B', sym('L2'), v, w, q[4:6], u[4:6])
        height += self.sin(angle) * r[0] + self.cos(angle) * r[1]
        angle += turn
        v, dp, mp = self.turned(v, turn), sym('dp'), sym('mp')
        v = [v[0], v[1] + w * dp]
        T += mp * (v[0] * v[0] + v[1] * v[1]) / 2 + sym('Jp') * w * w / 2
        V += mp * g * (height + self.sin(angle) * dp)
        return T, V

    def damping(self):
        d = {1: 'Ad1', 2: 'Ad2', 4: 'Bd1', 5: 'Bd2'}
        return [self.symbol(d[k]) * self.u[k] if k in d else 0 for k in range(6)]


def solved(M, b, n):
    """M x = b by L D L'"""
    M, b = [[M[i][j] for j in range(n)] for i in range(n)], list(b)
    L, d = [[0] * n for _ in range(n)], []
    for j in range(n):
        C = [M[i][j] - sum((L[i][k] * d[k] * L[j][k] for k in range(j)), 0) for i in range(j, n)]
        d.append(C[0])
        for i in range(j + 1, n):
            L[i][j] = C[i - j] / d[j]
    for i in range(n):
        b[i] = b[i] - sum((L[i][k] * b[k] for k in range(i)), 0)
    b = [b[i] / d[i] for i in range(n)]
    for i in reversed(range(n)):
        b[i] = b[i] - sum((L[k][i] * b[k] for k in range(i + 1, n)), 0)
    return b


def casadi_counts():
    import casadi as ca
    known = {}

    def symbol(name):
        return known.setdefault(name, ca.SX.sym(name))
    arm = Arm(symbol, ca.sin, ca.cos)
    T, V = arm.energies()
    q, u = ca.vertcat(*arm.q), ca.vertcat(*arm.u)
    a, tau = ca.SX.sym('a', 6), ca.SX.sym('tau', 6)
    p = ca.gradient(T, u)
    rest = ca.gradient(V - T, q) + ca.vertcat(*arm.damping())
    M, bias = ca.hessian(T, u)[0], ca.jtimes(p, q, u) + rest
    efforts = ca.jtimes(p, q, u) + ca.jtimes(p, u, a) + rest
    lower = [M[i, j] for i in range(6) for j in range(i + 1)]
    full = [[M[max(i, j), min(i, j)] for j in range(6)] for i in range(6)]
    ud = ca.vertcat(*solved(full, ca.vertsplit(tau - bias), 6))
    counted = {ca.OP_MUL: 0, ca.OP_SQ: 0, ca.OP_TWICE: 0, ca.OP_ADD: 1, ca.OP_SUB: 1, ca.OP_DIV: 2,
               ca.OP_INV: 2, ca.OP_SIN: 3, ca.OP_COS: 3}
    inputs = [q, u, a, tau, ca.vertcat(*(s for n, s in known.items() if n[0] not in 'qu'))]
    for word, result in (('inverse', efforts), ('mass', ca.vertcat(*lower)), ('forward', ud)):
        f = ca.Function('f', inputs, ca.cse([result]))
        count = [0] * 4
        for k in range(f.n_instructions()):
            if f.instruction_id(k) in counted:
                count[counted[f.instruction_id(k)]] += 1
        print('CasADi', word, *count, flush=True)


def sympy_counts():
    import sympy as sp

    def symbol(name):
        return sp.Symbol(name)
    arm = Arm(symbol, sp.sin, sp.cos)
    T, V = arm.energies()
    q, u, n = arm.q, arm.u, range(6)
    a, tau = sp.symbols('a0:6'), sp.symbols('tau0:6')
    p = [sp.diff(T, x) for x in u]
    rest = [sp.diff(V - T, q[i]) + arm.damping()[i] for i in n]
    M = [[sp.diff(p[i], u[j]) for j in range(i + 1)] for i in n]
    pd = [sum(sp.diff(p[i], q[j]) * u[j] for j in n) for i in n]
    bias = [pd[i] + rest[i] for i in n]
    efforts = [bias[i] + sum(M[max(i, j)][min(i, j)] * a[j] for j in n) for i in n]
    lower = [M[i][j] for i in n for j in range(i + 1)]
    for word, result in (('inverse', efforts), ('mass', lower), ('forward', lower + bias)):
        steps, out = sp.cse(result)
        count = [0] * 4
        for e in [s[1] for s in steps] + out:
            count_sympy(sp, e, count)
        if word == 'forward':       # L D L' of 6 equations, unrolled
            count = [x + y for x, y in zip(count, solution_counts(6))]
        print('SymPy', word, *count, flush=True)


def count_sympy(sp, e, count):
    """operations of a tree: powers by repeated squaring, x**-1 a division"""
    if isinstance(e, (sp.Mul, sp.Add)):
        factors = [x for x in e.args if x not in (-1,)]
        count[0 if isinstance(e, sp.Mul) else 1] += len(factors) - 1
    elif isinstance(e, sp.Pow):
        k = int(e.exp)
        count[2] += k < 0
        count[0] += abs(k).bit_length() - 1 + bin(abs(k)).count('1') - 1
    elif isinstance(e, (sp.sin, sp.cos)):
        count[3] += 1
    for x in e.args:
        count_sympy(sp, x, count)


def solution_counts(n):
    """multiplications, additions, divisions of a solution by L D L', and the n of tau - bias"""
    square = sum(1 for j in range(n) for i in range(j, n) for k in range(j))
    tall = n * (n - 1) // 2
    return [square + 2 * tall + tall + n, square + 2 * tall + n, n, 0]


if __name__ == '__main__':
    casadi_counts() if sys.argv[1] == 'casadi' else sympy_counts()
