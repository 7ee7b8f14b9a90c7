"""scipy_runs.py FOLDER LIBRARY|- NAME NCST: solve_ivp on right-hand sides of MuJoCo (mj_forward),
Pinocchio (aba, or with a loop its constraint dynamics), and of GSMBP (LIBRARY, through ctypes); of
the slider-crank also on its equation in the crank's angle alone, derived by hand. A ROW for each:
the least of three runs that take together at most two seconds."""
import ctypes
import math
import sys
import time
import numpy as np
from scipy.integrate import solve_ivp
from model import Model, mjcf, row

def by_mujoco(model):
    import mujoco
    m = mujoco.MjModel.from_xml_string(mjcf(model))
    if model.pin is not None:                  # the loop as stiff as DOP853's steps stand
        m.opt.timestep, m.eq_solref[0, 0] = 1e-5, 2e-5
    d, n = mujoco.MjData(m), model.n
    q, v, a, forward = d.qpos, d.qvel, d.qacc, mujoco.mj_forward
    def rates(t, x):
        q[:] = x[:n]
        v[:] = x[n:]
        forward(m, d)
        return np.concatenate((v, a))
    return rates

def by_pinocchio(model):
    import pinocchio as pin
    m = pin.Model()
    m.gravity.linear = np.array(model.gravity)
    for i, (parent, kind, R, at, mass, c, J) in enumerate(model.links):
        joint = pin.JointModelRZ() if kind == 'R' else pin.JointModelPZ()
        k = m.addJoint(parent + 1, joint, pin.SE3(R, np.array(at)), 'j%d' % i)
        J = np.array([[J[0], J[3], J[5]], [J[3], J[1], J[4]], [J[5], J[4], J[2]]])
        m.inertias[k] = pin.Inertia(mass, np.array(c), J)
    d, n, none, aba = m.createData(), model.n, np.zeros(model.n), pin.aba
    if model.pin is None:
        return lambda t, x: np.concatenate((x[n:], aba(m, d, x[:n], x[n:], none)))
    at = pin.SE3(np.eye(3), np.array([model.pin, 0, 0]))
    pins, data = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    pins.append(pin.RigidConstraintModel(pin.ContactType.CONTACT_3D, m, n - 1, at, n,
                                         pin.SE3.Identity(), pin.LOCAL_WORLD_ALIGNED))
    data.append(pins[0].createData())
    pin.initConstraintDynamics(m, d, pins, data)
    settings = pin.ProximalSettings(1e-14, 1e-12, 20)   # in a plane: a row is dependent
    return lambda t, x: np.concatenate((x[n:], pin.constraintDynamics(
        m, d, x[:n], x[n:], none, pins, data, settings)))

def by_ours(library, name, ncst, n):
    lib = ctypes.CDLL(library)
    cst, v, out, t = np.zeros(ncst + 1), np.zeros(8), np.zeros(2 * n), np.zeros(1)
    par, info = np.zeros(400), ctypes.c_int(0)
    pointer = lambda a: a.ctypes.data_as(ctypes.c_void_p)
    getattr(lib, name + '_par_')(pointer(par))
    getattr(lib, name + '_pre_')(pointer(par), pointer(cst), ctypes.byref(info))
    f, given = getattr(lib, name + '_rhs_'), np.zeros(2 * n)
    fixed = (pointer(t), pointer(given), pointer(v), pointer(cst), pointer(out),
             ctypes.byref(info))
    def rates(t, x):
        given[:] = x
        f(*fixed)
        return out.copy()
    return rates

def by_hand(model):
    """the crank's angle alone: m(q) q'' + m'(q) q'^2/2 + V'(q) = 0"""
    (_, _, _, _, m1, c1, J1), (_, _, _, at, m2, c2, J2), (_, _, _, _, m3, _, _) = model.links
    a, b, g, c1, c2, J1, J2 = at[0], model.pin, -model.gravity[1], c1[0], c2[0], J1[2], J2[2]
    sin, cos, sqrt, k, far = math.sin, math.cos, math.sqrt, a / b, c2 / b
    def rates(t, x):
        s, c, w = sin(x[0]), cos(x[0]), x[1]
        sb = -k * s
        cb = sqrt(1 - sb * sb)
        r = -k * c / cb                            # rod's rate beside the crank's
        rd = (k * s + r * r * sb) / cb             # and its derivative by the angle
        vx, vxd = -a * s - b * sb * r, -a * c - b * (cb * r * r + sb * rd)
        px, pxd = -a * s - c2 * sb * r, -a * c - c2 * (cb * r * r + sb * rd)
        py, pyd = a * c * (1 - far), -a * s * (1 - far)
        m = m1 * c1 * c1 + J1 + m2 * (px * px + py * py) + J2 * r * r + m3 * vx * vx
        half = m2 * (px * pxd + py * pyd) + J2 * r * rd + m3 * vx * vxd
        return (w, -(half * w * w + g * (m1 * c1 * c + m2 * py)) / m)
    return rates

def closed(model, q):
    """all coordinates of the slider-crank from the crank's angle"""
    a, b = model.links[1][3][0], model.pin
    rod = -math.asin(a * math.sin(q) / b)
    return [q, rod - q, a * math.cos(q) + b * math.cos(rod)]

def measured(rates, x, end, method, tolerance):
    spent, least = 0, math.inf
    for _ in range(3):
        start = time.perf_counter()
        run = solve_ivp(rates, (0, end), x, method=method, rtol=tolerance, atol=tolerance)
        least = min(least, time.perf_counter() - start)
        spent += time.perf_counter() - start
        if spent > 0.5:
            break
    return run, least

def main(folder, library, name, ncst):
    model = Model(folder)
    x, n = np.concatenate((model.q, model.v)), model.n
    ways = {'MuJoCo': lambda: by_mujoco(model), 'Pinocchio': lambda: by_pinocchio(model),
            'GSMBP': lambda: by_ours(library, name, int(ncst), n)}
    if model.pin is not None:
        ways['hand'] = lambda: by_hand(model)
    for way, make in ways.items():
        try:
            rates = make()
        except Exception as problem:
            print('LEFT', way, problem)
            continue
        for method in ('DOP853', 'RK45', 'LSODA', 'Radau'):
            for half in range(4, 27):
                if half % 2 and method != 'DOP853':
                    continue
                tolerance = 10 ** (-half / 2)
                start = x[[0, n]] if way == 'hand' else x
                run, least = measured(rates, start, model.end, method, tolerance)
                q = closed(model, run.y[0, -1]) if way == 'hand' else run.y[:n, -1]
                if run.status == 0:
                    row('SciPy %s on %s' % (method, way), tolerance, least, run.nfev, q)
                if least > 1:
                    break

main(*sys.argv[1:])
