"""SymPy: KanesMethod of a chain, cse, C code.

sympy_kane.py MODEL.txt lit|num FOLDER: writes FOLDER/id.c, fd.c, mm.c; prints a line for each:
word, CPU seconds up to its C code, mul, add, div, sqrt, trig. Forward dynamics is cse of M and the
forcing together with an unrolled LDL' behind it. lit: numbers that are not 0 are parameters."""
import re
import sys
import time
import sympy as sp
from sympy.physics.mechanics import (KanesMethod, Point, ReferenceFrame, RigidBody, dynamicsymbols,
                                     inertia)

PATTERNS = (('mul', r'\*'), ('add', r'(?<=[\w.)] )[-+]|(?<=[\w.)])[-+]'), ('div', r'/'),
            ('sqrt', r'sqrt\('), ('trig', r'sin\(|cos\(|tan\(|pow\('))
FUNCTION = """#include <math.h>
extern double p[];
void %s(const double *q, const double *v, const double *a, double *o) {
%s
}
"""

def read_model(path, parameter):
    """gravity, [(parent, type, rotation 3x3, place, mass, centre, inertia)] of model.txt (see
    model.hpp)"""
    words = iter(open(path).read().split())
    take = lambda k: [parameter(float(next(words))) for _ in range(k)]
    n, gravity, links = int(next(words)), take(3), []
    for _ in range(n):
        parent, kind = int(next(words)), next(words)
        rotation = sp.Matrix(3, 3, [int(float(next(words))) for _ in range(9)])
        links.append((parent, kind, rotation, take(3), take(1)[0], take(3), take(6)))
    return gravity, links

def derive(gravity, links):
    """M and forcing in plain symbols q_i, v_i"""
    n = len(links)
    q, u = dynamicsymbols('q1:%d' % (n + 1)), dynamicsymbols('u1:%d' % (n + 1))
    ground, origin = ReferenceFrame('N'), Point('O')
    origin.set_vel(ground, 0)
    vector = lambda frame, x: sum((c * e for c, e in zip(x, frame)), sp.S.Zero * frame.x)
    weight = vector(ground, gravity)
    frames, points, bodies, loads = [], [], [], []
    for i, (parent, kind, R, place, mass, centre, J) in enumerate(links):
        before, start = (ground, origin) if parent < 0 else (frames[parent], points[parent])
        fixed = before.orientnew('F%d' % i, 'DCM', R)
        fixed.set_ang_vel(before, 0)
        slide = q[i] * fixed.z if kind == 'P' else 0 * fixed.z
        point = start.locatenew('P%d' % i, vector(before, place) + slide)
        frame = fixed
        if kind == 'R':
            frame = fixed.orientnew('B%d' % i, 'Axis', [q[i], fixed.z])
            frame.set_ang_vel(fixed, u[i] * fixed.z)
            point.v2pt_theory(start, ground, before)
        else:
            point.set_vel(before, u[i] * fixed.z)
            point.v1pt_theory(start, ground, before)
        mid = point.locatenew('G%d' % i, vector(frame, centre))
        mid.v2pt_theory(point, ground, frame)
        bodies.append(RigidBody('L%d' % i, mid, frame, mass, (inertia(frame, *J), mid)))
        if mass != 0:
            loads.append((mid, mass * weight))
        frames.append(frame)
        points.append(point)
    kane = KanesMethod(ground, q, u, [a.diff() - b for a, b in zip(q, u)])
    kane.kanes_equations(bodies, loads)
    plain = dict(zip(q, sp.symbols('q_0:%d' % n)))
    plain.update(zip(u, sp.symbols('v_0:%d' % n)))
    return kane.mass_matrix.xreplace(plain), kane.forcing.xreplace(plain)

def product(power):
    """a*a*a for the match of pow(a, 3)"""
    factor = '(%s)' % power[1] if ' ' in power[1] else power[1]
    return '(' + '*'.join([factor] * int(power[2])) + ')'

class Writer:
    """C text of assignments with its operations: squares are products, x**-1 a division"""
    def __init__(self):
        self.lines, self.count = [], dict.fromkeys(('mul', 'add', 'div', 'sqrt', 'trig'), 0)

    def text(self, e):
        e = re.sub(r'pow\(([^(),]+), (\d)\)', product, sp.ccode(e))
        return re.sub(r'\b([qvap])_(\d+)', r'\1[\2]', e)

    def line(self, left, right):
        text = right if isinstance(right, str) else self.text(right)
        bare = re.sub(r'\d[\d.]*e[-+]?\d+', '1', re.sub(r'\[[^]]*\]', '', text))
        for word, pattern in PATTERNS:
            self.count[word] += len(re.findall(pattern, bare))
        self.lines.append(('' if '[' in left else 'double ') + '%s = %s;' % (left, text))

    def shared(self, left, right):
        """cse of the expressions, each on its left side"""
        named, right = sp.cse(right, symbols=sp.numbered_symbols('z'))
        for name, e in named:
            self.line(str(name), e)
        for name, e in zip(left, right):
            self.line(name, e)

    def solve(self, n):
        """unrolled LDL' of m_i_j (i >= j) and right side b_i"""
        minus = lambda terms: ''.join(' - %s*%s' % t for t in terms)
        for j in range(n):
            for k in range(j):
                self.line('w_%d_%d' % (j, k), 'l_%d_%d*d_%d' % (j, k, k))
            for i in range(j, n):
                top = 'm_%d_%d' % (i, j) + minus(
                    ('l_%d_%d' % (i, k), 'w_%d_%d' % (j, k)) for k in range(j))
                if i == j:
                    self.line('d_%d' % j, top)
                    self.line('e_%d' % j, '1.0/d_%d' % j)
                else:
                    self.line('l_%d_%d' % (i, j), '(%s)*e_%d' % (top, j))
        for i in range(n):
            known = (('l_%d_%d' % (i, k), 'y_%d' % k) for k in range(i))
            self.line('y_%d' % i, 'b_%d' % i + minus(known))
        for i in reversed(range(n)):
            known = (('l_%d_%d' % (k, i), 'x_%d' % k) for k in range(i + 1, n))
            self.line('x_%d' % i, 'y_%d*e_%d' % (i, i) + minus(known))
            self.line('o[%d]' % i, 'x_%d' % i)

def main(path, mode, folder):
    values = []
    def parameter(x):
        if mode == 'num' or x == 0:
            return sp.Float(x, 17) if x else sp.S.Zero
        values.append(x)
        return sp.Symbol('p_%d' % (len(values) - 1))
    start = time.process_time()
    gravity, links = read_model(path, parameter)
    n = len(links)
    M, f = derive(gravity, links)
    kane = time.process_time() - start
    half = [(i, j) for i in range(n) for j in range(i + 1)]
    named = ['m_%d_%d' % ij for ij in half]
    entries = [M[ij] for ij in half]
    a = sp.Matrix(sp.symbols('a_0:%d' % n))
    numbers = ', '.join(map(repr, values + [0.0]))
    open(folder + '/par.c', 'w').write('double p[] = {%s};\n' % numbers)
    for word in ('fd', 'mm', 'id'):
        start, w = time.process_time(), Writer()
        if word == 'fd':
            w.shared(named + ['b_%d' % i for i in range(n)], entries + list(f + a))
            w.solve(n)
        elif word == 'mm':
            w.shared(named, entries)
            w.lines += ['o[%d] = m_%d_%d;' % (i * n + j, max(i, j), min(i, j))
                        for i in range(n) for j in range(n)]
        else:
            w.shared(['o[%d]' % i for i in range(n)], list(M * a - f))
        text = FUNCTION % (word, '\n'.join(w.lines))
        open('%s/%s.c' % (folder, word), 'w').write(text)
        print(word, kane + time.process_time() - start, *w.count.values(), flush=True)

main(*sys.argv[1:4])
