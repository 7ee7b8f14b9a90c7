#!/usr/bin/python3
"""check.py FOLDER FIRST COUNT [JOBS]: COUNT scenes by chance from the seed FIRST on, each with some
features, beside twins of the same physics.

A scene is derived, and two twins (twins.py), in one session for some scenes; compiled at once;
compared at three states (compare.py). Some are modules of Python as well, whose values and runs
are compared (modules.py). Prints a line for each that is wrong, counts of features, twins and
routines. Exit code 0 only if all are right. GSMBP_TWINS=short: one twin each. check.py --one
FOLDER SEED base+units ...: one scene beside the twins that are told.
"""
import collections
import json
import os
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[1:1] = [os.path.join(os.path.dirname(HERE), 'random')]
import modules  # noqa: E402
from emitted import run_time  # noqa: E402
from judge import ROOT, chunk  # noqa: E402
from session import dies_with_parent  # noqa: E402

CHUNK = 5


def report(results):
    """prints counts; whether all is right"""
    for r in results:
        if r['verdict'] != 'right':
            print('%s seed %d: %s {%s}' % (r['verdict'], r['seed'], r['said'],
                                           ', '.join(r['features'])))
    for key in ('features', 'twins'):
        count = collections.Counter(w for r in results if r['verdict'] == 'right' for w in r[key])
        print(key + ': ' + ', '.join('%s %d' % x for x in sorted(count.items())))
    worst = collections.defaultdict(lambda: (0., 0))
    for r in results:
        for k, e in r['worst'].items():
            worst[k] = max(worst[k], (e, r['seed'])) if r['verdict'] == 'right' else worst[k]
    print('worst: ' + ', '.join('%s %.1e (%d)' % (k, *worst[k]) for k in sorted(worst)))
    wrong = [r for r in results if r['verdict'] not in ('right', 'no state')]
    states = sum(r['verdict'] == 'right' for r in results)
    print('%sok %d scenes and their twins are the same physics, %d modules of Python; %d without a '
          'state' % ('' if not wrong and states > .8*len(results) else 'not ', states,
                     sum(r['module'] for r in results), len(results) - states - len(wrong)))
    return not wrong and states > .8*len(results)


def started(folder, seeds):
    path = os.path.join(folder, 'twins_%d_%d.out' % (seeds[0], len(seeds)))
    command = [sys.executable, __file__, '--chunk', folder, str(seeds[0]), str(len(seeds)), path]
    env = {**os.environ, 'OMP_NUM_THREADS': '1', 'OPENBLAS_NUM_THREADS': '1'}
    return subprocess.Popen(command, env=env, preexec_fn=dies_with_parent), seeds, path


def collected(seeds, path):
    found = [json.loads(line) for line in open(path)] if os.path.exists(path) else []
    return found + [{'verdict': 'lost', 'seed': s, 'said': '', 'features': [], 'twins': [],
                     'worst': {}, 'module': False} for s in list(seeds)[len(found):]]


def main():
    folder, first, count = os.path.abspath(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    jobs = int(sys.argv[4]) if len(sys.argv) > 4 else 2
    os.makedirs(folder, exist_ok=True)
    run_time(ROOT, folder, '-O0')
    modules.run_time(ROOT, folder)
    end = first + count
    waiting = [range(s, min(s + CHUNK, end)) for s in range(first, end, CHUNK)]
    running, results = [], []
    while waiting or running:
        while waiting and len(running) < jobs:
            running.append(started(folder, waiting.pop(0)))
        for one in [x for x in running if x[0].poll() is not None]:
            running.remove(one)
            results += collected(*one[1:])
        time.sleep(.2)
    sys.exit(0 if report(sorted(results, key=lambda r: r['seed'])) else 1)


if __name__ == '__main__':
    if sys.argv[1] == '--chunk':
        first = int(sys.argv[3])
        chunk(sys.argv[2], range(first, first + int(sys.argv[4])), sys.argv[5])
    elif sys.argv[1] == '--one':
        os.makedirs(sys.argv[2], exist_ok=True)
        path = os.path.join(sys.argv[2], 'one.out')
        chunk(os.path.abspath(sys.argv[2]), [int(sys.argv[3])], path,
              [k.split('+') for k in sys.argv[4:]] or None)
        report(collected([int(sys.argv[3])], path))
    else:
        main()
