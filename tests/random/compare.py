"""The emitted code of a scene against the independent formulation, at states drawn by chance."""
import random
import numpy as np
from beside import draw_modes, holders
from emitted import zeros
from joints import Joint
from mechanics import State, closed, closing_rows, displaced, maximal, moving

# what a difference may be, relative to the largest number beside it
LIMITS = {
    'KIN': 1e-10, 'MAS': 1e-9, 'INV': 1e-9, 'BIA': 1e-9, 'FWD': 1e-9, 'CON phi': 1e-9, 'CON rates':
    1e-9, 'CON space': 1e-7, 'CON gamma': 1e-7, 'ACC': 1e-7, 'ACC balance': 1e-8, 'RHS': 1e-7,
    'PNT': 1e-13, 'JPT': 1e-13, 'JPT rate': 1e-12, 'OUT': 1e-7, 'EVT': 1e-7, 'CTL': 1e-12,
    'ENE': 1e-9, 'LIN': 1e-7, 'JAC': 1e-6,
    'JAC outputs': 1e-6, 'literal M': 1e-9, 'literal N+G-P': 1e-9,
    'INV_V': 1e-9, 'MAS_V': 1e-9, 'BIA_V': 1e-9, 'FWD_V': 1e-9, 'RHS_V': 1e-7,
    'INV_V beside single': 1e-11, 'MAS_V beside single': 1e-11, 'BIA_V beside single': 1e-11,
    'FWD_V beside single': 1e-10, 'RHS_V beside single': 1e-10
}
STEP = 1e-3  # the longer one of the differences


def error(found, wanted, scale=1e-9):
    found, wanted = np.asarray(found, float), np.asarray(wanted, float)
    if not found.size:
        return 0.
    if not np.all(np.isfinite(found)):
        return float('inf')
    return float(np.max(np.abs(found - wanted))/max(np.max(np.abs(wanted)), scale))


class Mixed:
    """the scene's own speeds A u, their rates A ud + rest; P: from the order of the mechanism to
    that of the code"""

    def __init__(self, m, s, order):
        self.A, self.rest = np.eye(m.nu), np.zeros(m.nu)
        if m.mixing:
            x, y, a, b = m.mixing
            (ix, kx), (_, ky) = places(m, x), places(m, y)
            self.A[kx, ky], self.A[ky, kx] = a, b*np.sin(s.q[ix])
            self.rest[ky] = b*np.cos(s.q[ix])*s.u[kx]**2
        self.A, self.rest = self.A[order], self.rest[order]
        self.back = np.linalg.inv(self.A)

    def speeds(self, u):
        return self.A @ u

    def rates(self, ud):
        return self.A @ ud + self.rest

    def natural(self, wd):
        return self.back @ (wd - self.rest)

    def efforts(self, tau):
        return self.back.T @ tau


def places(m, name):
    j = next(j for j in m.tree if name in j.names)
    i = j.names.index(name)
    return m.q_of[j.name].start + i, m.u_of[j.name].start + i


def natural_speeds(m):
    """names of the speeds as the code has them"""
    names = []
    for j in m.tree:
        ball = 'b' in j.letters()
        names += [n + '_d' for n in (j.names[:-4] if ball else j.names)]
        names += [j.name + '_w' + w for w in 'xyz'] if ball else []
    if m.mixing:
        names[names.index(m.mixing[0] + '_d')], names[names.index(m.mixing[1] +
                                                                  '_d')] = 'mix1', 'mix2'
    return names


def with_nut(m, start, j):
    """a thread that is cut and counts its turns: the scene has its nut as a link without mass,
    tied to the child; the name of that tie, which is no joint of the scene"""
    nut, tie = j.name + '_nut', Joint(j.name + '_tie', 'fixed', j.name + '_nut', j.child)
    m.links.append({'name': nut, 'm': 0., 'centre': np.zeros(3), 'I': np.zeros((3, 3))})
    tie.at = tie.child_at = j.child_at
    tie.R = tie.child_R = j.child_R
    tie.cut, j.cut, j.child = True, False, nut
    m.joints.append(tie)
    m.number()
    start.q = np.concatenate([start.q, start.own.pop(j.name)[0]])
    start.own[tie.name] = (np.zeros(0), np.zeros(0))
    return tie.name


class Comparison:

    def __init__(self, scene, code, requests):
        self.scene, self.m, self.code, self.requests = scene, scene.m, code, requests
        self.r, self.worst, self.notes = random.Random(scene.seed + 1), {}, []
        self.names_agree()

    def names_agree(self):
        m, js = self.m, self.code.js
        q, u = [c['name'] for c in js['coordinates']], [c['name'] for c in js['speeds']]
        self.ties = [with_nut(m, self.scene.start, j) for j in list(m.cuts)
                     if j.type == 'helical' and j.names[0] in q]
        if sorted(q) != sorted(m.names()) or sorted(u) != sorted(natural_speeds(m)):
            raise ValueError('names: %s %s, expected %s %s' % (q, u, m.names(), natural_speeds(m)))
        self.q_order = [m.names().index(n) for n in q]
        self.u_order = [natural_speeds(m).index(n) for n in u]
        self.x_names = [x['name'].replace('.', '_') for x in js['states']][len(q) + len(u):]
        self.v_names = [x['name'].replace('.', '_') for x in js['inputs']]
        self.loops = js['dimensions']['nlam'] > 0

    def note(self, what, value):
        self.worst[what] = max(self.worst.get(what, 0.), value) if value == value else float('inf')

    # --------------------------------------------------------------------------------------- states

    def state(self):
        """closed, with speeds that keep it so; and what is known of its freedom. None where none
        is found"""
        m, r = self.m, self.r
        x = {n: r.uniform(*self.scene.ranges.get(n, (-1, 1))) for n in self.x_names}
        v = {n: r.uniform(-1, 1) for n in self.v_names}
        start = self.scene.start
        s = State(0., start.q, np.zeros(m.nu), start.own, x, v)
        if not m.cuts and not m.conditions:
            s.q, s.t = self.scene.somewhere().q, r.uniform(0, 1)
        else:
            s = self.near(s)
        if s is None:
            return None, None
        wish = np.array([r.gauss(0, 1.5) for _ in range(m.nu + m.n_own)])
        s, f = moving(m, s, wish)
        draw_modes(m, s, r, closing_rows(m, s, m.bodies(s))[1])
        return s, f

    def near(self, start):
        m, r = self.m, self.r
        for reach in (.6, .3, .1, 0.):
            s = displaced(m, start, np.array([r.gauss(0, reach) for _ in range(m.nu + m.n_own)]))
            s.t = r.uniform(0, .5) if reach else 0.
            s, gap = closed(m, s)
            if gap < 1e-12 and np.all(np.isfinite(s.q)) and self.angles_good(s):
                return s
        return None

    def angles_good(self, s):
        for j in self.m.tree:
            if j.orientation:
                two = s.q[self.m.q_of[j.name]][-2]
                if abs(np.sin(two) if j.orientation[0] == j.orientation[2] else np.cos(two)) < .15:
                    return False
        return True

    # ----------------------------------------------------------------------------------- everything

    def run(self, count):
        m, done = self.m, []
        for _ in range(count):
            s, f = self.state()
            if s is None or not f.met or f.gap < 1e-4:
                self.notes.append('no state' if s is None else 'near a singular position')
                continue
            done.append((s, self.one(s, f)))
        if done and 'batch' in self.requests:
            self.batches(done)
        return len(done)

    def one(self, s, f):
        m, code = self.m, self.code
        mixed = Mixed(m, s, self.u_order)
        M, B, drive, loads = m.projected(s)
        q, w, v = s.q[self.q_order].copy(), mixed.speeds(s.u), self.inputs(s)
        B_own = mixed.efforts(B - M @ mixed.back @ mixed.rest)
        M_own = mixed.back.T @ M @ mixed.back
        self.effort_size, self.loose = self.scale(s, mixed), 1.
        self.kinematics(s, q, w)
        self.tree(s, mixed, q, w, v, M_own, B_own)
        if code.has('jpt'):
            self.places(s, mixed, q, w)
        sv = np.linalg.svd(M_own, compute_uv=False) if m.nu else np.ones(1)
        self.condition = sv[0]/max(sv[-1], 1e-300)
        if self.condition < 1e10 and m.nu:
            self.forward(s, q, w, v, M_own, B_own)
        elif not (m.cuts or m.conditions):
            return M_own, B_own, None
        xd = self.whole(s, f, mixed, q, w, v, M_own, B_own, mixed.efforts(drive), loads)
        if 'linear' in self.requests:
            self.linear(s)
        if 'jacobian' in self.requests and f.rank == f.rows:
            self.jacobian(s)
        return M_own, B_own, xd

    def inputs(self, s):
        return np.array([s.v[n] for n in self.v_names] or [0.])

    def kinematics(self, s, q, w):
        qdot = zeros(self.m.nq)
        self.code.call('kin', s.t, q, w, self.code.cst, qdot)
        self.note('KIN', error(qdot[:self.m.nq], self.m.rates(s)[self.q_order], 1.))

    def tree(self, s, mixed, q, w, v, M, B):
        m, code = self.m, self.code
        found, bias, tau = zeros(m.nu, m.nu), zeros(m.nu), zeros(m.nu)
        code.call('mas', s.t, q, code.cst, found, max(1, m.nu))
        code.call('bia', s.t, q, w, v, code.cst, bias)
        wd = np.array([self.r.gauss(0, 3) for _ in range(m.nu)])
        code.call('inv', s.t, q, w, wd, v, code.cst, tau)
        scale = self.scale(s, mixed)
        self.note('MAS', error(found, M))
        self.note('BIA', error(bias, B, scale))
        self.note('INV', error(tau, M@wd + B, scale))

    def places(self, s, mixed, q, w):
        """points and frames, Jacobians, (dJ/dt) u"""
        code, nu, points = self.code, self.m.nu, self.scene.points
        bodies, n = self.m.bodies(s), len(points)
        P, R, J, bias = zeros(3, n), zeros(3, 3*n), zeros(6, nu*n), zeros(6, n)
        code.call('pnt', s.t, q, code.cst, P, R)
        code.call('jpt', s.t, q, w, code.cst, J, bias)
        order = [p['name'] for p in code.js['points']]
        for one in points:
            k = order.index(one.name)
            p, axes, own, beside = one.seen(bodies)
            self.note('PNT', max(error(P[:, k], p, 1.), error(R[:, 3*k:3*k + 3], axes, 1.)))
            self.note('JPT', error(J[:, nu*k:nu*k + nu], own @ mixed.back, 1.))
            rate = beside - own @ mixed.back @ mixed.rest
            self.note('JPT rate', error(bias[:, k], rate, 1.))

    def scale(self, s, mixed):
        """of efforts: what single bodies need, which may cancel"""
        M, B, _, _ = self.m.projected(s)
        parts = [
            np.abs(b.J).T @ np.abs(self.m.inertia(l, b)[1]) for l in self.m.links
            for b in [self.m.bodies(s)[l['name']]]
        ]
        return 1e-3*max([1e-3] + [np.max(p) for p in parts if p.size])

    def forward(self, s, q, w, v, M, B):
        m, code = self.m, self.code
        tau, wd = np.array([self.r.uniform(-5, 5) for _ in range(m.nu)]), zeros(m.nu)
        info = code.call('fwd', s.t, q, w, v, tau, code.cst, wd, 99)
        wanted = np.linalg.solve(M, tau - B)
        wanted += np.linalg.solve(M, tau - B - M@wanted)
        self.note('FWD',
                  error(wd, wanted)/max(1, self.condition*1e-4) if info == 0 else float('inf'))

    def x(self, s, q, w):
        return np.concatenate([q, w, [s.x[n] for n in self.x_names]])

    def whole(self, s, f, mixed, q, w, v, M, B, drive, loads):
        """constraints, accelerations, the state space, outputs, energies"""
        m, code = self.m, self.code
        sol = maximal(m, s, np.zeros(m.nu))
        wd, x = mixed.rates(sol.ud), self.x(s, q, w)
        loose = self.loose = max(1., 1e-4/f.gap, 1e-5/max(sol.gap, 1e-12))
        if sol.residual > 1e-8:
            self.notes.append('the independent equations have no solution (%.0e)' % sol.residual)
            return None
        if self.loops:
            H = self.constraints(s, f, mixed, q, w, wd, loose)
            if code.has('acc'):
                hold = mixed.efforts(self.holding(s, sol))
                self.accelerations(s, x, v, wd, M, B - drive - hold, H, loose)
        elif (m.cuts or m.conditions) and self.free_directions(s, mixed).shape[1] < m.nu:
            self.note('CON space', float('inf'))
        wanted = np.concatenate(
            [m.rates(s)[self.q_order], wd, [sol.loads.rates[n] for n in self.x_names]])
        if code.has('rhs'):
            self.state_space('rhs', s, x, v, wanted, loose, f.rank < f.rows)
        if code.has('evt'):
            self.events(s, x, v, sol, loose)
        if code.has('out'):
            self.outputs(s, x, v, sol, loose)
        if code.has('ctl'):
            self.samples(s, v)
        if code.has('ene'):
            self.energies(s, x, v, M, w, loads)
        return wanted

    def constraints(self, s, f, mixed, q, w, wd, loose):
        m, code, nl = self.m, self.code, self.code.d['nlam']
        phi, phit, H, gamma = zeros(nl), zeros(nl), zeros(nl, m.nu), zeros(nl)
        code.call('con', s.t, q, w, code.cst, phi, phit, H, nl, gamma, 99)
        self.note('CON phi', float(np.max(np.abs(phi))))
        size = max(1., np.max(np.abs(w)), np.max(np.abs(wd)))*max(1., np.max(np.abs(H)))
        self.note('CON rates', float(np.max(np.abs(H@w + phit)))/size)
        self.note('CON gamma', float(np.max(np.abs(H@wd - gamma)))/size/loose)
        free = self.free_directions(s, mixed)
        rank = np.linalg.matrix_rank(H, 1e-9*max(1., np.max(np.abs(H))))
        self.note('CON space',
                  float(np.max(np.abs(H @ free), initial=0.)) + (m.nu - rank != free.shape[1]))
        return H

    def free_directions(self, s, mixed):
        still = s.with_speeds(0*s.u)
        _, G, _ = closing_rows(self.m, still, self.m.bodies(still))
        U, sv, V = np.linalg.svd(G)
        rank = int(np.sum(sv > 1e-9*max(1., sv[0])))
        Z = mixed.A @ V[rank:].T[:self.m.nu]
        U, sv, _ = np.linalg.svd(Z, full_matrices=False) if Z.size else (Z, np.zeros(0), 0)
        return U[:, sv > 1e-9]

    def accelerations(self, s, x, v, wd, M, B, H, loose):
        m, code = self.m, self.code
        if 'loop_method' not in code.names:
            raise ValueError('no parameter loop_method')
        for way in (1, 2, 3, 4):
            code.set({'loop_method': float(way)})
            found, lam = zeros(m.nu), zeros(code.d['nlam'])
            info = code.call('acc', s.t, x, v, code.cst, found, lam, 99)
            if info not in (0, 2):
                self.note('ACC', float('inf'))
                continue
            self.note('ACC', error(found, wd, 1.)/loose)
            pull = M@found + B
            self.note('ACC balance',
                      float(np.max(np.abs(pull - H.T @ lam)))/max(1., np.max(np.abs(pull)))/loose)
        code.set({'loop_method': 1.})

    def state_space(self, word, s, x, v, wanted, loose, deficient):
        found = zeros(len(x))
        info = self.code.call(word, s.t, x, v, self.code.cst, found, 99)
        bad, known = info not in ((0, 3, 2) if deficient else (0, 3)), ~np.isnan(wanted)
        self.note('RHS', float('inf') if bad else error(found[known], wanted[known], 1.)/loose)

    def holding(self, s, sol):
        """efforts of the ports that are held, on the speeds of the tree"""
        bodies = self.m.bodies(s)
        return sum((sol.holding[name]*port.in_tree(bodies)[0] for name, port in sol.loads.held),
                   np.zeros(self.m.nu))

    def events(self, s, x, v, sol, loose):
        """event functions, with any modes in V"""
        m, code, bodies, wanted = self.m, self.code, self.m.bodies(s), {}
        names, any_v = [e['name'] for e in code.js['events']], v.copy()
        mode, found = np.zeros(len(names), dtype=np.int32), zeros(len(names))
        for holder, stand in holders(m):
            p, own = stand.port(m, s, bodies), s.v[holder.mode]
            mode[names.index(holder.name)] = own
            any_v[self.v_names.index(holder.mode)] = self.r.choice([-1, 0, 1])
            wanted[holder.name] = holder.event(own, p.s, p.w, sol.holding.get(holder.name))
        code.call('evt', s.t, x, any_v, mode, code.cst, found)
        self.note('EVT', error(found, [wanted[n] for n in names], 1.)/loose)

    def outputs(self, s, x, v, sol, loose):
        code, y = self.code, zeros(self.code.d['ny'])
        code.call('out', s.t, x, v, code.cst, y, 99)
        self.note('OUT', self.output_error(y, self.wanted_outputs(s, sol), sol)/loose)

    def samples(self, s, v):
        """what sampled devices give, and what they keep, of any reading and memory"""
        code, names = self.code, [o['name'] for o in self.code.js['outputs']]
        y = np.array([self.r.uniform(-1, 1) for _ in names] or [0.])
        keeps = [n for d in code.js['controllers'] for n in d['memory']]
        kept = np.array([self.r.uniform(-1, 1) for _ in keeps] or [0.])
        for i, n in enumerate(keeps):
            if n.endswith('.count'):
                kept[i] = self.r.choice([0., 1.])
        held, wanted_held, wanted = v.copy(), v.copy(), kept.copy()
        for e in self.m.elements:
            if hasattr(getattr(e, 'machine', None), 'sampled'):
                name, keys, law = e.machine.sampled
                given = {k: y[names.index(name + '.' + k)] for k in keys}
                memory = {n.split('.')[1]: a for n, a in zip(keeps, kept)
                          if n.startswith(name + '.')}
                out, new = law(given, memory)
                for k, a in out.items():
                    wanted_held[self.v_names.index(name + '_' + k)] = a
                for k, a in new.items():
                    wanted[keeps.index(name + '.' + k)] = a
        code.call('ctl', np.zeros(1, dtype=np.int32), s.t, y, kept, code.cst, held)
        self.note('CTL', max(error(held, wanted_held), error(kept, wanted)))

    def wanted_outputs(self, s, sol):
        wanted = dict(sol.loads.signals)
        if self.scene.reactions:
            for j in (j for j in self.m.joints if j.name not in self.ties):
                parts = zip(('x', 'y', 'z', 'mx', 'my', 'mz'), sol.reactions[j.name])
                wanted.update({'r_%s.%s' % (j.name, k): f for k, f in parts})
        if hasattr(self.scene, 'output'):
            wanted['y0'] = self.scene.output.value(self.m, s)
        return wanted

    def output_error(self, y, wanted, sol):
        """what is always zero is no output; reactions that are not unique are left out"""
        names = [o['name'] for o in self.code.js['outputs']]
        if sol.missing:
            wanted = {k: f for k, f in wanted.items() if not k.startswith('r_') and f == f}
        found = {k: y[names.index(k)] if k in names else 0. for k in wanted}
        scale = max([1.] + [abs(f) for f in wanted.values()])
        return max([0.] + [abs(found[k] - wanted[k])/scale for k in wanted])

    def energies(self, s, x, v, M, w, loads):
        m, E = self.m, zeros(5)
        self.code.call('ene', s.t, x, v, self.code.cst, E)
        bodies = m.bodies(s)
        kinetic, fall = 0., loads.potential
        for l in m.links:
            b = bodies[l['name']]
            kinetic += b.twist @ m.inertia(l, b)[0] @ b.twist/2
            fall -= l['m']*m.gravity @ (b.p + b.R @ l['centre'])
        rotor = sum(k*p.w**2/2 for k, p in loads.added)
        wanted = [kinetic + rotor, fall, loads.stored - rotor, loads.power, loads.lost]
        # what a reduced variant loses is not told by its law: there the balance has a defect
        known = 5 if loads.lost == loads.lost else 4
        self.note('ENE', error(E[:known], wanted[:known], 1.))

    # ---------------------------------------------------------------------------------- derivatives

    def linear(self, s):
        """along a curve through the state: M wd' + B w' + C q' = tau'"""
        m, code, n = self.m, self.code, max(1, self.m.nu)
        step, more, wd0 = (np.array([self.r.gauss(0, 1) for _ in range(m.nu)]) for _ in range(3))

        def at(h):
            p = displaced_tree(m, s, h*step, h*more)
            mixed = Mixed(m, p, self.u_order)
            M, B, _, _ = m.projected(p)
            ud = mixed.natural(wd0*(1+h))
            return p.q[self.q_order], mixed.speeds(p.u), wd0*(1+h), mixed.efforts(M@ud + B)

        (dq, dw, dwd, dtau), _ = slopes(at)
        M, B, C = zeros(m.nu, m.nu), zeros(m.nu, m.nu), zeros(m.nu, m.nq)
        q, w, wd, tau = at(0.)
        code.call('lin', s.t, q, w, wd, self.inputs(s), code.cst, M, B, C, n)
        found = M@dwd + B@dw + C@dq
        self.note('LIN', error(found, dtau, .01*max(1., np.max(np.abs(B)), np.max(np.abs(C)))))

    def jacobian(self, s):
        m, code = self.m, self.code
        n = m.nu + m.n_own
        step, more = (np.array([self.r.gauss(0, 1) for _ in range(n)]) for _ in range(2))
        dx, dv = ({k: self.r.gauss(0, 1) for k in names} for names in (self.x_names, self.v_names))
        wish = np.concatenate([s.u] + [s.own[j.name][1] for j in m.cuts])

        def at(h):
            p = displaced(m, s, h*step)
            p.x, p.v = ({k: a[k] + h*d[k] for k in d} for a, d in ((s.x, dx), (s.v, dv)))
            p, _ = closed(m, p)
            p, _ = moving(m, p, wish + h*more)
            return self.point(p)

        (X, V, XD, Y), ((dX, dV, dXD, dY), apart) = at(0.), slopes(at)
        if apart > .01:
            self.notes.append('too steep for differences')
            return
        nx, nv, ny = len(X), len(V), len(Y)
        A, B, C, D = zeros(nx, nx), zeros(nx, nv), zeros(ny, nx), zeros(ny, nv)
        info = code.call_jac(s.t, X, V, A, B, C, D)
        if info not in (0, 3):
            self.note('JAC', float('inf'))
            return
        size = .01*max(1., np.max(np.abs(A)), np.max(np.abs(C)))
        known = ~np.isnan(dXD)   # rates that read reactions which are not unique are not
        self.note('JAC', error((A@dX + B@dV)[known], dXD[known], size))
        if ny and not np.any(np.isnan(dY)):
            self.note('JAC outputs', error((C@dX + D@dV)[:ny], dY, size))

    def point(self, p):
        """states, inputs, their rates, outputs at a point of a curve"""
        m = self.m
        sol, mixed = maximal(m, p, np.zeros(m.nu)), Mixed(m, p, self.u_order)
        q, w = p.q[self.q_order], mixed.speeds(p.u)
        xd = np.concatenate([
            m.rates(p)[self.q_order],
            mixed.rates(sol.ud), [sol.loads.rates[n] for n in self.x_names]
        ])
        wanted = self.wanted_outputs(p, sol)
        names = [o['name'] for o in self.code.js['outputs']]
        y = np.array(
            [float('nan') if sol.missing and k.startswith('r_') else wanted[k] for k in names])
        return self.x(p, q, w), self.inputs(p), xd, y

    # -------------------------------------------------------------------------------------- batches

    def batches(self, done):
        """eleven states at once: each against the independent values and against the single
        routine; done: [(state, judged)]"""
        m, code, K, LD = self.m, self.code, 11, 12
        some = [done[k % len(done)] for k in range(K)]
        rows = {k: [] for k in ('T', 'Q', 'U', 'UD', 'V', 'X', 'TAU')}
        wanted = {k: [] for k in ('inv', 'bia', 'mas', 'fwd', 'rhs')}
        for s, (M, B, xd) in some:
            mixed = Mixed(m, s, self.u_order)
            q, w = s.q[self.q_order], mixed.speeds(s.u)
            wd, tau = (np.array([self.r.gauss(0, 2) for _ in range(max(1, m.nu))]) for _ in '12')
            for k, a in zip(rows, ([s.t], q, w, wd, self.inputs(s), self.x(s, q, w), tau)):
                rows[k].append(a)
            n = m.nu
            accelerations = np.linalg.solve(M, tau[:n] - B) if self.condition < 1e10 else None
            for k, a in zip(wanted, (M @ wd[:n] + B, B, M, accelerations, xd)):
                wanted[k].append(a)
        many = {k: wide(a, LD) for k, a in rows.items()}
        n, nx = m.nu, len(rows['X'][0])
        self.batch('inv', ['T', 'Q', 'U', 'UD', 'V'], (n, ), rows, many, wanted, K, LD)
        self.batch('bia', ['T', 'Q', 'U', 'V'], (n, ), rows, many, wanted, K, LD)
        self.batch('mas', ['T', 'Q'], (n, n), rows, many, wanted, K, LD)
        if self.condition < 1e10:
            self.batch('fwd', ['T', 'Q', 'U', 'V', 'TAU'], (n, ), rows, many, wanted, K, LD)
            if code.has('rhs'):
                self.batch('rhs', ['T', 'X', 'V'], (nx, ), rows, many, wanted, K, LD)

    def batch(self, word, given, shape, rows, many, wanted, K, LD):
        import ctypes
        code, tells = self.code, word in ('fwd', 'rhs')
        out, info = zeros(LD, *shape), np.zeros(LD, dtype=np.int32)
        k, ld = ctypes.c_int(K), ctypes.c_int(LD)
        arrays = [many[g].ctypes
                  for g in given] + [code.cst.ctypes, out.ctypes] + ([info.ctypes] if tells else [])
        code.function(word + '_v')(*arrays, ctypes.byref(k), ctypes.byref(ld))
        for i in range(K):
            one = zeros(*shape)
            args = [float(rows['T'][i][0])] + [np.array(rows[g][i], float)
                                               for g in given[1:]] + [code.cst, one]
            code.call(word, *args, *([99] if tells else [shape[0]] if word == 'mas' else []))
            true = wanted[word][i]
            # what is all zero is computed as the rounding of forces that cancel
            efforts = self.effort_size if word in ('inv', 'bia') else 1e-9
            still = word == 'rhs' and true is not None and np.max(np.abs(true)) < 1e-12
            self.note(word.upper() + '_V beside single',
                      error(out[i], one, 1. if still else efforts))
            if true is not None and self.m.nu:
                size = 1. if word == 'rhs' else efforts
                loose = {'fwd': max(1, self.condition*1e-4), 'rhs': self.loose}.get(word, 1)
                known = ~np.isnan(true)
                self.note(word.upper() + '_V', error(out[i][known], true[known], size)/loose)


def wide(rows, ld):
    a = np.zeros((ld, len(rows[0])), order='F')
    a[:len(rows)] = rows
    return a


def slopes(at):
    """derivatives of a tuple of arrays at 0, of sixth order: extrapolated from two steps, as some
    curves are steep; and what they leave open beside the largest: of a curve beside a singular
    position, much"""
    fine, coarse = differences(at, STEP/4), differences(at, STEP)
    apart = max(error(c, f, 1.) for f, c in zip(fine, coarse) if f.size and np.all(np.isfinite(f)))
    return [(256*f - c)/255 for f, c in zip(fine, coarse)], apart


def differences(at, step):
    """of fourth order"""
    a, b, c, d = at(step), at(-step), at(2*step), at(-2*step)
    return [(8*(p-q) - (u-v))/(12*step) for p, q, u, v in zip(a, b, c, d)]


def displaced_tree(m, s, step, more):
    p = displaced(m, s, np.concatenate([step, np.zeros(m.n_own)]))
    p.u = s.u + more
    return p
