"""samples.py SCENE FOLDER STANDARD REFERENCES LATE: the FMU of sampled_inputs, unpacked in FOLDER,
at communication points that are samples or not, in both kinds, where inputs change at every one of
them: against the exact motion of the wheel (a quadratic between instants) with the devices
calculated here, and against gsmbp_simulate (REFERENCES, by samples.m). LATE: the delay of the last
device [s]. Prints a line `ok` or `not ok` a check."""
import copy
import math
import sys

from instance import B, D, Instance, c, log, near, scene, standard, told

PERIOD, INERTIA = 0.1, 0.7
late = float(sys.argv[5])
NAMES = ('q', 'q_d', 'E.old', 'E.count', 'C.I', 'E.angle', 'E.speed', 'C.out', 'L.out', 'torque',
         'ahead')
START = {'late': late, 'q': 0.31, 'q_d': -0.2}


def inputs(k):
    return {'wanted': 0.5*math.sin(1.3*k), 'load': 0.4*math.cos(2.1*k)}


def rounded(x, step):
    return step*math.floor(x/step + 0.5)


class Wheel:
    """what the scene says, between and at instants"""

    def __init__(self):
        self.t, self.q, self.q_d = 0.0, START['q'], START['q_d']
        self.old, self.count, self.sum = 0.0, 0, 0.0
        self.angle = self.speed = self.C = self.L = 0.0
        self.samples, self.sent = 0, []

    def due(self):
        return min([PERIOD*self.samples] + [when for when, _ in self.sent])

    def on(self, t, u):
        a, h = (self.C + self.L + u['load'])/INERTIA, t - self.t
        self.q, self.q_d, self.t = self.q + h*self.q_d + h*h/2*a, self.q_d + h*a, t

    def instant(self, u):
        """delayed outputs that arrive, then the devices in their order"""
        for one in [one for one in self.sent if one[0] <= self.t + 1e-12]:
            self.L = one[1]
            self.sent.remove(one)
        if PERIOD*self.samples > self.t + 1e-12:
            return
        now = rounded(self.q, 0.001)
        self.angle, self.speed = now, self.count*(now - self.old)/PERIOD
        self.old, self.count = now, 1
        e = u['wanted'] - rounded(self.angle, 0.0003)
        raw = 6*e + self.sum
        self.C = rounded(max(-20, min(20, raw)), 0.0007)
        draw = (3*0.2)**2/((3*0.2)**2 + (6/100)**2)
        self.sum += 3*PERIOD*e + draw*PERIOD/0.2*(self.C - raw)
        if self.samples % 2 == 0:
            out = rounded(max(-20, min(20, 1.7*(0.3*self.C - rounded(self.q_d, 0.0011)))), 0.0013)
            if late > 0:
                self.sent.append((self.t + late, out))
            else:
                self.L = out
        self.samples += 1

    def to(self, t, u):
        """up to t, without what is due there"""
        while self.due() < t - 1e-12:
            self.on(self.due(), u)
            self.instant(u)
        self.on(t, u)

    def shown(self, u):
        """the values of NAMES where the inputs are u"""
        return [self.q, self.q_d, self.old, self.count, self.sum, self.angle, self.speed, self.C,
                self.L, self.C + self.L + u['load'], u['wanted'] - self.angle]


def exact(h, n):
    """at every point: the values before and after the change of the inputs there, both after the
    sample that is due"""
    wheel, u, rows = Wheel(), {'wanted': 0.0, 'load': 0.0}, []
    for k in range(n + 1):
        if k > 0:
            wheel.to(k*h, u)
        both = []
        for u in (u, inputs(k)):
            other = copy.deepcopy(wheel)
            while other.due() <= k*h + 1e-12:
                other.instant(u)
            both.append(other.shown(u))
        wheel = other
        rows.append(both)
    return rows


def read(a):
    return [a[name] for name in NAMES]


def cosimulation(h, n, reads=True, summed=False):
    a, t, rows = Instance(0, START), 0.0, []
    for k in range(n + 1):
        both = [read(a)] if reads else []
        a.put(inputs(k))
        rows.append(both + [read(a)] if reads or k == n else None)
        if k < n:
            a.step(t, h)
            t = t + h if summed else (k + 1)*h
    return a, rows


def exchange(h, n):
    """of model exchange: the steps of classical Runge-Kutta from instant to instant are exact"""
    a, t, rows = Instance(1, START), 0.0, []
    for k in range(n + 1):
        while k > 0 and t < k*h - 1e-12:
            a('EnterContinuousTimeMode')
            x, end = a.states(), min(k*h, a.next)
            if a.next < k*h + 1e-12:
                end = a.next
            d = [a.rates(t, x)]
            for part in (0.5, 0.5, 1):
                d.append(a.rates(t + part*(end - t),
                                 [p + part*(end - t)*q for p, q in zip(x, d[-1])]))
            a.at(end, [p + (end - t)/6*(q + 2*r + 2*s + u) for p, q, r, s, u in zip(x, *d)])
            a('CompletedIntegratorStep', *([] if standard == 2 else [B(1)]),
              *([1] if standard == 2 else []), c.byref(B()), c.byref(B()))
            a('EnterEventMode')
            t = end
            if t < k*h - 1e-12:
                a.events()
        a.put(inputs(k))
        a.events()
        rows.append([read(a)])
    return a, rows


def off(rows, wanted):
    return max(abs(p - q) for row, other in zip(rows, wanted) for p, q in zip(row, other))


def against(h, n, parts):
    """points are k*h, sums of steps, sums of steps of twelve decimals"""
    what = f'steps of a period{"/" + str(parts) if parts > 1 else ""}, delay {late:g} s'
    wanted = exact(h, n)
    before, after = [row[0] for row in wanted], [row[1] for row in wanted]
    simulated = [[float(word) for word in line.split()][1:]
                 for line in open(f'{sys.argv[4]}/{parts}.txt')]
    told(len(simulated) == n + 1, f'{n} points, {what}')
    near(off(simulated, after), 1e-9, 'gsmbp_simulate and the exact motion')
    for step, summed, said in ((round(h, 12), True, ', rounded'), (h, True, ', summed'),
                               (h, False, '')):
        rows = cosimulation(step, n, summed=summed)[1]
        near(off([row[0] for row in rows], before), 1e-9,
             f'co-simulation{said}, inputs not yet set')
        near(off([row[1] for row in rows], after), 1e-9, f'co-simulation{said}, inputs set')
    near(off([row[1] for row in rows], simulated), 1e-9, '... and gsmbp_simulate')
    rows = exchange(h, n)[1]
    near(off([row[0] for row in rows], after), 1e-9, 'model exchange')


def reading_leaves_nothing():
    h, n = PERIOD/2, 30
    told(cosimulation(h, n)[1][-1][1:] == cosimulation(h, n, reads=False)[1][-1],
         'a run in which nothing is read ends with the same bits')


def is_refused(a, what, *arguments):
    del log[:]
    told(a.status(*arguments) == 3 and len(log) == 1, what)


def saved():
    """states that are saved where the values are those after a sample"""
    h = PERIOD/2
    a, _ = cosimulation(h, 4)
    u, first = inputs(4), read(a)
    state = a.keep()
    copy_of = a.in_bytes(state)
    a.put({'wanted': 7.0})
    told(read(a) != first, 'an input that a sample reads changes what is held')
    a.put(u)
    told(read(a) == first, '... and set back it is as it was')
    a.put({'wanted': 7.0})
    a.take(state)
    told(read(a) == first, 'a saved state is as it was')
    b = Instance(0, {})
    b.take(copy_of)
    told(read(b) == first, '... in another instance, too, from its bytes')
    zero = [D(4*h), D(0), 1] if standard == 2 else [D(4*h), D(0), B(1)] + [
        c.byref(D()) for k in range(4)]
    is_refused(b, 'a step of the length 0 is refused', 'DoStep', *zero)
    told(read(b) == first, '... and changes nothing')
    a.put({'wanted': 7.0})
    both = []
    for k in range(4, 9):
        for one in (a, b):
            one.put(inputs(k))
            one.step(k*h, h)
        both.append(read(a) == read(b))
    told(all(both), 'both go on with the same bits')
    b('Terminate')
    told(read(a) == read(b), 'after its end an instance shows the same')
    is_refused(b, '... and takes no step', 'DoStep', *zero)


if scene != 'sampled_inputs':
    sys.exit('not ok samples.py: no checks of ' + scene)
for parts in (1, 2, 3):
    against(PERIOD/parts, 15*parts, parts)
reading_leaves_nothing()
saved()
