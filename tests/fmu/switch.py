"""switch.py FOLDER: the FMU 2.0 of switch_circuit, unpacked in FOLDER, against the closed form, in
both kinds: co-simulation with steps that do not end where it switches, model exchange by classical
Runge-Kutta from event time to event time."""
import ctypes as c
import glob
import math
import re
import sys

folder = sys.argv[1]
text = open(folder + '/modelDescription.xml').read()
guid = re.search('guid="([^"]*)"', text).group(1)
variable = '<ScalarVariable name="([^"]*)" valueReference="(\\d+)"'
ref = {n: int(r) for n, r in re.findall(variable, text)}
so = c.CDLL(glob.glob(folder + '/binaries/*/*.so')[0])
so.fmi2Instantiate.restype = c.c_void_p
P, D = c.c_void_p, c.c_double


class Callbacks(c.Structure):
    LOG = c.CFUNCTYPE(None, P, c.c_char_p, c.c_int, c.c_char_p, c.c_char_p)
    _fields_ = [('logger', LOG), ('allocate', P), ('free', P), ('finished', P), ('env', P)]


class Events(c.Structure):
    _fields_ = [(n, c.c_int) for n in ('needed', 'terminate', 'nominals', 'values', 'defined')]
    _fields_.append(('next', D))


libc = c.CDLL(None)
log = Callbacks.LOG(lambda e, n, s, k, m: print('log:', m.decode()))
callbacks = Callbacks(log, c.cast(libc.calloc, P), c.cast(libc.free, P), None, None)


def exact(t):
    def rise(t0):
        return 1 - math.exp(-max(0.0, t - t0)/0.1)
    return 5*(rise(0.1) - rise(0.3) + 2*rise(0.7))


def call(name, *arguments):
    if getattr(so, name)(*arguments) != 0:
        sys.exit('not ok %s failed' % name)


def begun(kind):
    m = P(so.fmi2Instantiate(b'one', kind, guid.encode(), b'', c.byref(callbacks), 0, 0))
    call('fmi2SetupExperiment', m, 1, D(1e-10), D(0), 0, D(0))
    call('fmi2EnterInitializationMode', m)
    call('fmi2ExitInitializationMode', m)
    return m


def value(m, name):
    v = D()
    call('fmi2GetReal', m, c.byref(c.c_uint(ref[name])), c.c_size_t(1), c.byref(v))
    return v.value


def told(error, most, what):
    print('%s %s: %.1e (at most %.0e)' % ('ok' if error <= most else 'not ok', what, error, most))


def cosimulation():
    m, worst = begun(1), 0
    for k in range(100):
        call('fmi2DoStep', m, D(k*0.01 + 0.0), D(0.01), 1)
        worst = max(worst, abs(value(m, 'A.u') - exact((k + 1)*0.01)))
    told(worst, 1e-8, 'co-simulation of a scene that switches')
    m, worst = begun(1), 0
    for k in range(6):
        call('fmi2DoStep', m, D(k*0.17), D(0.17), 1)
        worst = max(worst, abs(value(m, 'A.u') - exact((k + 1)*0.17)))
    told(worst, 1e-8, '... with steps over where it switches')


def exchange():
    m, e, t, times = begun(0), Events(), 0.0, []
    x, d = (D*2)(), (D*2)()

    def rates(t, y):
        call('fmi2SetTime', m, D(t))
        call('fmi2SetContinuousStates', m, (D*2)(*y), c.c_size_t(2))
        call('fmi2GetDerivatives', m, d, c.c_size_t(2))
        return list(d)

    while t < 1:
        call('fmi2NewDiscreteStates', m, c.byref(e))
        call('fmi2EnterContinuousTimeMode', m)
        call('fmi2GetContinuousStates', m, x, c.c_size_t(2))
        end = min(1.0, e.next if e.defined else 1.0)
        times += [e.next] if e.defined else []
        y, n = list(x), 200
        h = (end - t)/n
        for k in range(n):
            a, b = t + k*h, end if k == n - 1 else t + (k + 1)*h
            k1 = rates(a, y)
            k2 = rates(a + h/2, [p + h/2*q for p, q in zip(y, k1)])
            k3 = rates(a + h/2, [p + h/2*q for p, q in zip(y, k2)])
            k4 = rates(b, [p + h*q for p, q in zip(y, k3)])
            y = [p + h/6*(q + 2*r + 2*s + u) for p, q, r, s, u in zip(y, k1, k2, k3, k4)]
        t = end
        rates(t, y)
        call('fmi2EnterEventMode', m)
        told(abs(y[0] - exact(t)), 1e-8, 'model exchange up to t = %g' % t)
    told(max(abs(p - q) for p, q in zip(times, (0.1, 0.3, 0.7))) + abs(len(times) - 3), 1e-15,
         'its time events')


def by_name():
    """states set by their value references are those of fmi2SetContinuousStates"""
    m, e, found = begun(0), Events(), []
    call('fmi2NewDiscreteStates', m, c.byref(e))
    call('fmi2EnterContinuousTimeMode', m)
    numbers = [int(k) - 1 for k in re.findall('derivative="(\\d+)"', text)]
    references, x, d = (c.c_uint*2)(*numbers), (D*2)(0.25, -0.5), (D*2)()
    for how in ('fmi2SetContinuousStates', 'fmi2SetReal'):
        call('fmi2SetContinuousStates', m, (D*2)(0, 0), c.c_size_t(2))
        if how == 'fmi2SetReal':
            call(how, m, references, c.c_size_t(2), x)
        else:
            call(how, m, x, c.c_size_t(2))
        call('fmi2GetDerivatives', m, d, c.c_size_t(2))
        found.append(list(d))
    told(max(abs(p - q) for p, q in zip(*found)) + (found[0] == [0, 0]), 0,
         'states are set by name in model exchange')


cosimulation()
exchange()
by_name()
