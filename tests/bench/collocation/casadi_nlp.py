"""The swing-up of a cart with a pole by Hermite and Simpson in CasADi (SX) with its Ipopt: for each
number of intervals a line `N, ms to build, ms for one evaluation of all derivatives, ms of
processor time of a solution, iterations, goal`. Unknowns and equations as gsmbp_collocate hands
them to its solver, without accelerations, states and forces at the middles among them."""
import sys
import time
import casadi as ca


def rates(x, f):
    m1, m2, length, g = 1.0, 0.3, 0.5, 9.81
    s, c = ca.sin(x[1]), ca.cos(x[1])
    below = m1 + m2*s*s
    p = (length*m2*s*x[3]**2 + f + m2*g*c*s)/below
    th = -(length*m2*c*s*x[3]**2 + f*c + (m1 + m2)*g*s)/(length*below)
    return ca.vertcat(x[2], x[3], p, th)


def program(n):
    h = 2.0/n
    points = 2*n + 1
    x = ca.SX.sym('x', 4, points)
    f = ca.SX.sym('f', points)
    rate = [rates(x[:, i], f[i]) for i in range(points)]
    g, goal = [], 0
    for k in range(n):
        i, m, j = 2*k, 2*k + 1, 2*k + 2
        g.append(x[:, m] - x[:, i] - h*(5*rate[i]/24 + rate[m]/3 - rate[j]/24))
        g.append(x[:, j] - x[:, i] - h*(rate[i] + 4*rate[m] + rate[j])/6)
        goal += h*(f[i]**2 + 4*f[m]**2 + f[j]**2)/6
    return {'x': ca.vertcat(ca.vec(x), f), 'f': goal, 'g': ca.vertcat(*g)}, points


def bounds(points):
    low = [-2, -ca.inf, -ca.inf, -ca.inf]*points + [-20]*points
    high = [2, ca.inf, ca.inf, ca.inf]*points + [20]*points
    low[:4] = high[:4] = [0, 0, 0, 0]
    low[4*(points - 1):4*points] = high[4*(points - 1):4*points] = [1, ca.pi, 0, 0]
    return low, high


def evaluation(solver, nlp):
    """least time of one evaluation of goal, gradient, equations, Jacobian, Hessian"""
    x = [0.1]*nlp['x'].size1()
    least = 0
    for name, more in (('nlp_f', []), ('nlp_grad_f', []), ('nlp_g', []), ('nlp_jac_g', []),
                       ('nlp_hess_l', [1, [0.3]*nlp['g'].size1()])):
        function = solver.get_function(name)
        buffers = [ca.DM(x), ca.DM(0, 1)] + [ca.DM(v) for v in more]
        best = 1e9
        for _ in range(40):
            begin = time.perf_counter()
            function(*buffers)
            best = min(best, time.perf_counter() - begin)
        least += best
    return least


for n in [int(word) for word in sys.argv[1:]]:
    build = 1e9
    for _ in range(3):
        begin = time.perf_counter()
        nlp, points = program(n)
        solver = ca.nlpsol('solver', 'ipopt', nlp,
                           {'print_time': 0, 'ipopt': {'print_level': 0, 'tol': 1e-9, 'sb': 'yes'}})
        build = min(build, time.perf_counter() - begin)
    low, high = bounds(points)
    line = [v*k/(points - 1) for k in range(points) for v in (1, ca.pi, 0, 0)]
    whole = 1e9
    for _ in range(5):
        begin = time.process_time()
        sol = solver(x0=line + [0]*points, lbx=low, ubx=high, lbg=0, ubg=0)
        whole = min(whole, time.process_time() - begin)
    print(n, '%.3f %.4f %.1f' % (1e3*build, 1e3*evaluation(solver, nlp), 1e3*whole),
          solver.stats()['iter_count'], '%.14g' % sol['f'])
