"""slidercrank_casadi.py FOLDER: C code by CasADi of the slider-crank's rates, FOLDER/fd.c:
Lagrange's equations with multipliers of the pin, written with CasADi's derivatives; M by its LDL',
the two multipliers by their complement."""
import sys
import casadi as ca
from model import Model

def main(folder):
    model = Model(folder)
    (_, _, _, _, m1, c1, J1), (_, _, _, at, m2, c2, J2), (_, _, _, _, m3, _, _) = model.links
    q, v, tau, p = (ca.SX.sym(word, k) for word, k in (('q', 3), ('v', 3), ('a', 3), ('p', 0)))
    s, c, sb, cb = ca.sin(q[0]), ca.cos(q[0]), ca.sin(q[0] + q[1]), ca.cos(q[0] + q[1])
    centre1 = ca.vertcat(c1[0] * c, c1[0] * s)
    centre2 = ca.vertcat(at[0] * c + c2[0] * cb, at[0] * s + c2[0] * sb)
    speed = lambda r: ca.mtimes(ca.jacobian(r, q), v)
    square = lambda r: ca.dot(speed(r), speed(r))
    T = (m1 * square(centre1) + J1[2] * v[0]**2 + m2 * square(centre2) + J2[2] * (v[0] + v[1])**2
         + m3 * v[2]**2) / 2
    V = -model.gravity[1] * (m1 * centre1[1] + m2 * centre2[1])
    phi = ca.vertcat(at[0] * c + model.pin * cb - q[2], at[0] * s + model.pin * sb)
    M, momentum = ca.hessian(T, v)
    b = ca.mtimes(ca.jacobian(momentum, q), v) - ca.gradient(T, q) + ca.gradient(V, q)
    H = ca.jacobian(phi, q)
    gamma = -ca.mtimes(ca.jacobian(ca.mtimes(H, v), q), v)
    D, LT, order = ca.ldl(M)
    X = ca.ldl_solve(ca.horzcat(H.T, tau - b), D, LT, order)
    S, y = ca.mtimes(H, X[:, :2]), gamma - ca.mtimes(H, X[:, 2])
    d = S[0, 0] * S[1, 1] - S[0, 1]**2
    lam = ca.vertcat(S[1, 1] * y[0] - S[0, 1] * y[1], S[0, 0] * y[1] - S[0, 1] * y[0]) / d
    f = ca.Function('f_fd', [q, v, tau, p], [ca.cse(X[:, 2] + ca.mtimes(X[:, :2], lam))])
    code = ca.CodeGenerator('fd.c')
    code.add(f)
    with open(folder + '/fd.c', 'w') as file:
        file.write(code.dump())

main(sys.argv[1])
