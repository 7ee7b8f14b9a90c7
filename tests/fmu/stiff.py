"""stiff.py SCENE FOLDER STANDARD REFERENCE OTHER: co-simulation by the FMU of stiff_loop with
method radau, unpacked in FOLDER: against gsmbp_simulate by radau (REFERENCE, by stiff.m) in steps
of several lengths, from saved states; its time against that of the FMU with dp853, unpacked in
OTHER. Prints a line `ok` or `not ok` a check."""
import subprocess
import sys
import time

from instance import Instance, log, near, told

reference, other = sys.argv[4], (sys.argv[5:] or [None])[0]
DAMPED = {'c': 1e6}   # beside which dp853 takes some 100 times the steps
STATES = ('q1', 'q2', 's', 'q3', 'q1_d', 'q2_d', 's_d', 'q3_d')


def states(a):
    return [a[name] for name in STATES]


def gap(x, y):
    return max(abs(p - q)/max(1, abs(q)) for p, q in zip(x, y))


def run(parts):
    """the states at the points of the reference in steps of a part of its intervals"""
    a, rows, n = Instance(0, DAMPED), [], 0
    for k in range(20):
        for i in range(parts):
            if a.step(n*0.05/parts, 0.05/parts)[0]:
                sys.exit('not ok a step fails: %s' % log[-1:])
            n += 1
        rows.append(states(a))
    return rows


if reference == 'time':   # of a run, alone: processor time [s]
    begun = time.process_time()
    run(1)
    print(time.process_time() - begun)
    sys.exit()
rows = [list(map(float, line.split())) for line in open(reference)]
for parts in (1, 3, 20):
    near(max(gap(x, row[1:]) for x, row in zip(run(parts), rows[1:])), 1e-6,
         'radau in steps of 1/%d s, gsmbp_simulate' % (20*parts))

a = Instance(0, DAMPED)
a.step(0, 0.5)
kept = a.keep()
a.step(0.5, 0.25)
one = states(a)
a.take(a.in_bytes(kept))
a.step(0.5, 0.25)
told(one == states(a), 'a saved state goes on with the same bits')
near(gap(states(a), rows[15][1:]), 1e-6, 'after steps of 0.5 and 0.25 s')
exchange = Instance(1, DAMPED)
told(not exchange.events() and len(exchange.states()) == exchange.n, 'model exchange begins')

spent = [float(subprocess.check_output([sys.executable, __file__, sys.argv[1], place, sys.argv[3],
                                        'time'])) for place in (sys.argv[2], other)]
told(spent[0] < 0.5*spent[1], 'radau takes %.2f s, dp853 %.2f s' % tuple(spent))
