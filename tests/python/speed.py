"""Time of the inverse dynamics of 1e5 states in Python beside a loop in C: speed.py PROGRAM.

The two take turns; of each the least time counts, which what else runs on the machine does not make
smaller."""
import subprocess
import sys
import time

import numpy as np

import puma6

K = 100000
model = puma6.Model()
program = subprocess.Popen([sys.argv[1]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)


def in_c():
    program.stdin.write(b'\n')
    return float(program.stdout.readline())


def in_python(q, u, ud):
    begin = time.perf_counter()
    model.inv(0.0, q, u, ud)
    return time.perf_counter() - begin


rows = np.random.default_rng(1).random((3, 6, K))
columns = [np.asfortranarray(q) for q in rows]
times = {'C': [], 'columns': [], 'rows': []}
for _ in range(60):
    times['C'].append(in_c())
    times['columns'].append(in_python(*columns))
    times['rows'].append(in_python(*rows))
least = {what: min(t) for what, t in times.items()}
program.stdin.close()
for order in ('columns', 'rows'):
    ratio = least[order] / least['C']
    print('%sok 1e5 states of the PUMA, stored by %s: %.3f times the C (%.0f ns a state), at most '
          '1.1' % ('' if ratio <= 1.1 else 'not ', order, ratio, least['C'] / K * 1e9))
