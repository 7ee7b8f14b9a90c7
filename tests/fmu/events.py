"""events.py SCENE FOLDER STANDARD [ERROR]: the FMU of a scene with events of the user, in FOLDER,
against closed forms (user_bounce, user_thermostat) or what holds (others), in both kinds:
co-simulation with steps that end nowhere near an event, model exchange by classical Runge-Kutta,
whose step ends where an indicator changes its sign. ERROR: of user_bounce in short steps where each
is a run of its own. Prints a line `ok` or `not ok` a check."""
import math
import sys

from instance import B, D, Instance, c, log, near, ref, scene, standard, told


def cosimulation(start, end, h, each, given=()):
    """a run in steps of h; each(instance, t) behind every step"""
    a, t = Instance(0, start), 0.0
    while t < end - 1e-9:
        for values in given:
            a.put(values)
        ended, last = a.step(t, h)
        if ended:
            return a, last
        t += h
        each(a, t)
    return a, t


def exchange(start, end, h, each):
    """a run of model exchange; each(instance, t) behind every event"""
    a, t = Instance(1, start), 0.0

    def moved(t, x, h):
        k = [a.rates(t, x)]
        for part in (0.5, 0.5, 1):
            k.append(a.rates(t + part*h, [p + part*h*q for p, q in zip(x, k[-1])]))
        return [p + h/6*(q + 2*r + 2*s + u) for p, q, r, s, u in zip(x, *k)]

    while t < end and not a.events():
        each(a, t)
        a('EnterContinuousTimeMode')
        x = a.states()
        signs = a.signs(t, x)
        while t < end:
            full = min(h, end - t, a.next - t)
            y = moved(t, x, full)
            low, high = 0.0, full
            if a.signs(t + full, y) != signs:
                for k in range(60):
                    middle = 0.5*(low + high)
                    if a.signs(t + middle, moved(t, x, middle)) != signs:
                        high = middle
                    else:
                        low = middle
                y = moved(t, x, high)
            event, terminate = B(), B()
            a.at(t + high, y)
            a('CompletedIntegratorStep', *([] if standard == 2 else [B(1)]),
              *([1] if standard == 2 else []), c.byref(event), c.byref(terminate))
            timed = high == full == a.next - t
            t, x = a.next if timed else t + high, y
            if event.value or timed or a.signs(t, x) != signs:
                break
        a.before = [a[name] for name in ('phi_d', 's_d') if name in ref]
        a('EnterEventMode')
    each(a, t)
    return a, t


def counted(name):
    """[function for each, times of the events of a name as they are told]"""
    times = []

    def each(a, t):
        if a[name + '.count'] > len(times):
            times.append(a[name + '.time'])
    return each, times


def bounce():
    g, e = 9.81, 0.8
    wanted = [math.sqrt(2/g)]
    v = g*wanted[0]
    while wanted[-1] < 3:
        v *= e
        wanted.append(wanted[-1] + 2*v/g)
    wanted.pop()
    for kind, run, h, most in (('co-simulation', cosimulation, 0.0713, 1e-12),
                               ('short steps', cosimulation, 0.0017,
                                float((sys.argv + [1e-12])[4])),
                               ('model exchange', exchange, 0.0113, 1e-9)):
        each, times = counted('hit')
        a, end = run({'y': 1.0}, 5.0, h, each)
        told(len(times) == len(wanted), '%d bounces, %s' % (len(times), kind))
        near(max(abs(p - q) for p, q in zip(times, wanted)), most, 'times of bounces, ' + kind)
        near(end - 3, most, 'the end, ' + kind)
        speed = g*wanted[0]*e**len(wanted)
        fallen = 3 - wanted[-1]
        near(a['y'] - (speed*fallen - g/2*fallen**2), 10*most, 'the place there, ' + kind)
    a, end = cosimulation({'y': 1.0}, 5.0, 1.0, lambda a, t: None)
    told(a['hit.count'] == len(wanted) and abs(a['hit.time'] - wanted[-1]) < 1e-12,
         'bounces in long steps')
    del log[:]
    told(a.status('DoStep', *([D(3), D(1), 1] if standard == 2 else
                              [D(3), D(1), B(1)] + [c.byref(D()) for k in range(4)])) == 3
         and 'event done has ended the run' in log[-1], 'a run that has ended does not go on')
    a = Instance(0, {'y': 1.0}, 3.0)
    ends = [a.step(k/2, 0.5) for k in range(6)]
    told(ends[-1] == (1, 3.0) and a['done.count'] == 1, 'an event at the end of the experiment')
    at_points()
    del log[:]
    a, end = cosimulation({'y': 1.0, 'e': 0.5, 'last': 10.0}, 5.0, 0.1, lambda a, t: None)
    told('failed with INFO = 10 at t = 1.3545709' in log[-1]
         and 'an event comes faster and faster' in log[-1], 'bounces that accumulate are an error')
    try:
        exchange({'y': 1.0, 'e': 0.5}, 2.0, 0.0113, lambda a, t: None)
        told(0, 'bounces that accumulate are an error, model exchange')
    except SystemExit as problem:
        told('an event, hit, failed with INFO = 10 at t = 1.354' in str(problem),
             'bounces that accumulate are an error, model exchange')


def at_points():
    """An event at a time that is a communication point but for rounding, and the stop time or not:
    it has happened there, whatever the steps are and whoever sums them"""
    for last, stop in ((3, 3.0), (1, 10.0)):
        for n in (8, 10, 16, 20, 32, 48, 64, 100, 128, 1000):
            for summed in (0, 1):
                a, t, h, steps = Instance(0, {'y': 1.0, 'last': last}, stop), 0.0, 1/n, 0
                ended = 0
                while steps < n*last and not ended:
                    ended, end = a.step(t, h)
                    steps += 1
                    t = t + h if summed else steps*h
                told(ended == 1 and steps == n*last and a['done.count'] == 1
                     and abs(end - last) < 4e-15, 'an event at %d s, stop time %g, steps of 1/%d%s'
                     % (last, stop, n, ', summed' if summed else ''))


def thermostat():
    """v' = heat - v between 1 and 2, heated with 3 or not"""
    cold, hot = [math.log(1.5) + k*math.log(4) for k in range(4)], []
    hot = [t + math.log(2) for t in cold]
    for kind, run, h, most in (('co-simulation', cosimulation, 0.0713, 1e-9),
                               ('short steps', cosimulation, 0.0017, 1e-9),
                               ('model exchange', exchange, 0.0113, 1e-8)):
        for name, wanted in (('cold', cold), ('hot', hot)):
            each, times = counted(name)
            a, t = run({'x_d': 1.5}, 5.5, h, each)
            wanted = [w for w in wanted if w < t]
            told(len(times) == len(wanted), '%d times %s, %s' % (len(times), name, kind))
            near(max(abs(p - q) for p, q in zip(times, wanted)), most, name + ', ' + kind)
    a = Instance(0, {'x_d': 1.5, 'heat': 0.25})
    told((a['heat.held'], a['heat.used']) == (0, 0.25), 'an input is the importer\'s at first')
    t = math.log(1.25/0.75)
    a.step(0, 1)
    near(a['cold.time'] - t, 1e-9, 'it gets cold later with some heat')
    a.put({'heat': -7.0})
    told((a['heat'], a['heat.held'], a['heat.used']) == (-7, 1, 3),
         'an event holds it, whatever it is set to')


def crank():
    for kind, run, h in (('co-simulation', cosimulation, 1/14),
                         ('model exchange', exchange, 0.0113)):
        speeds = {}

        def each(a, t):
            if a['kick.count'] == 1 and 1 not in speeds and run is exchange:
                near(max(abs(a['phi_d'] - 2*a.before[0]), abs(a['s_d'] - 2*a.before[1])), 1e-9,
                     'a kick that doubles a speed doubles those of the loop')
            speeds[a['kick.count']] = a['phi_d'], a['phi'], a['s'], a['beta']
        a, t = run({'phi': 0.5, 'beta': -0.6, 's': 0.38, 'phi_d': 3.0}, 1.0, h, each)
        told(a['kick.count'] == 1, 'one kick, ' + kind)
        speed, phi, s, beta = speeds[1]
        near(max(abs(s - 0.1*math.cos(phi) - 0.3*math.cos(phi + beta)),
                 abs(0.1*math.sin(phi) + 0.3*math.sin(phi + beta))), 1e-10,
             'the loop is closed, ' + kind)
        yield kind, a['kick.time'], speed, a['phi']


def instant():
    """A switch and a sample at one instant, which is a communication point or not: what the switch
    alone brings about is no event"""
    names = 'between', 'risen', 'switched', 'sampled', 'clock'
    seen = []

    def at_once(a, t):
        """at 0.5 s, which is a sample: what has happened, also by the sample"""
        if abs(t - 0.5) < 1e-9:
            seen.append([round(a[name + '.count']) for name in names] + [a['x'], a['x_d']])
    for t1, wanted in ((0.5, [0, 0, 1, 1, 1]), (0.52, [1, 0, 1, 0, 1])):
        ends = []
        for kind, run, h in (('co-simulation', cosimulation, 0.8), ('0.1 s', cosimulation, 0.1),
                             ('0.01 s', cosimulation, 0.01), ('0.05 s', cosimulation, 0.05),
                             ('1/64 s', cosimulation, 1/64), ('model exchange', exchange, 0.0113)):
            a, t = run({'t1': t1}, 0.8, h, at_once)
            counts = [round(a[name + '.count']) for name in names]
            told(counts == wanted, 'a switch at %g s, %s: %s' % (t1, kind, counts))
            ends += [a['x'], a['x_d']] if h != 1/64 or t1 > 0.5 else []
        counts = [0, 0, 1, 1, 1] if t1 <= 0.5 else [0, 0, 0, 0, 0]
        told(len(seen) == 5 and all(row[:5] == counts for row in seen),
             f'... and at once where 0.5 s is a communication point: {[row[:5] for row in seen]}')
        near(max(abs(p - q) for row in seen for p, q in zip(row, seen[-1])), 1e-8, '... the state')
        del seen[:]
        first = ends[:2]*(len(ends)//2)
        near(max(abs(p - q) for p, q in zip(ends, first)), 1e-8, '... the state at the end')


def slides():
    """A cart that sticks until a sample pushes it: what both kinds show at samples, its mode and
    its acceleration among it. The last point of model exchange is read before its event"""
    names = 'q', 'q_d', 's', 's_d', 'der(q_d)', 'der(s_d)', 'S.mode', 'F.mode', 'C.out', 'C.I'
    start, period, seen = {'s': 0.012, 'q': 0.8}, 0.002, []
    for run, h in ((exchange, 1e-4), (cosimulation, period)):
        rows = {}

        def each(a, t):
            k = round(t/period)
            if abs(t - k*period) < 1e-9 and 0 < k < 150:
                rows[k] = [a[name] for name in names]
        run(start, 0.3, h, each)
        seen.append(rows)
    told(len(seen[0]) == 149 and seen[0].keys() == seen[1].keys(), '149 samples')
    near(max(abs(p - q) for k in seen[0] for p, q in zip(seen[0][k], seen[1][k])), 1e-9,
         'model exchange and co-simulation at samples')
    modes = [row[names.index('F.mode')] for row in seen[1].values()]
    told(set(modes) == {0, -1}, 'it sticks at some, slides at others')


if scene == 'user_bounce':
    bounce()
elif scene == 'event_pendulum':
    slides()
elif scene == 'event_instant':
    instant()
elif scene == 'user_thermostat':
    thermostat()
else:
    (_, t1, _, phi1), (_, t2, _, phi2) = crank()
    near(t1 - t2, 1e-7, 'the kick of both kinds')
    near(phi1 - phi2, 1e-6, 'the angle of both kinds')
