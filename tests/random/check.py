#!/usr/bin/python3
"""check.py FOLDER FIRST COUNT [JOBS]: COUNT scenes made by chance from the seed FIRST on, against
the independent formulation.

Each is derived by the way that its seed draws (ways.py), compiled and compared (compare.py).
Prints a line for each that is wrong, refused, crashed
or hangs, and counts by way, element and routine. Exit code 0 only if all that was not refused for
a good reason is right.
"""
import collections
import glob
import hashlib
import json
import os
import random
import subprocess
import sys
import time
import traceback
import numpy as np
from beside import holders
from compare import Comparison, Mixed, LIMITS, error
from emitted import Code, compiled, run_time
from mechanics import State, closing_rows
from scenes import Scene
from session import derive, dies_with_parent
from ways import Way, every_way

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CHUNK = 20
STATES = 3


def massless_end(scene):
    """a link without mass that one joint of the tree holds"""
    ends = [n for j in scene.m.joints if not j.cut for n in (j.parent, j.child)]
    return any(link['m'] == 0 and ends.count(link['name']) == 1 for link in scene.m.links)


# what the reasons say that a generator cannot foresee, and when they are justified
REFUSALS = {
    'nothing in it changes': lambda scene: scene.m.nu == 0,
    'nothing in the scene moves': lambda scene: scene.m.nu == 0,
    'a massless end link': massless_end
}


def holds(m, start):
    """whether loops and conditions take any freedom from the tree; rows of rounding errors (a disc
    that rolls on what it is fixed to) do not"""
    _, G, _ = closing_rows(m, start, m.bodies(start))
    sv, V = np.linalg.svd(G)[1:]
    free = V[int(np.sum(sv > 1e-9*max(1., sv[0]))):, :m.nu]
    return m.nu > 0 and np.linalg.matrix_rank(free, 1e-9) < m.nu


class Call:
    """what a session is asked for one scene"""

    def __init__(self, seed):
        self.way = Way(seed)
        literal = self.way.literal
        self.scene = Scene(seed, self.way.numbers == 'compiled', literal, self.way.long)
        m, words = self.scene.m, ['kinematics', 'inverse', 'mass', 'bias', 'forward'
                                  ] + self.way.requests
        if m.cuts or m.conditions:
            words += ['constraints', 'rhs'] if holds(m, self.scene.start) else ['rhs']
        if any(hasattr(getattr(e, 'machine', None), 'sampled') for e in m.elements):
            words += ['control', 'output']
        elif 'output(' not in self.scene.text and 'output' in words:
            words.remove('output')
        if holders(m):
            words = [w for w in words if w != 'jacobian'] + ['events', 'rhs']
        if self.scene.points:
            words += ['points', 'point_jacobians']
        self.requests = sorted(set(words))
        self.points, self.literal = '[]', None
        plain = not any('b' in j.letters()
                        for j in m.tree)  # distances of Euler parameters fill pages
        if literal and plain and not m.mixing and 0 < m.nu < 5:
            self.literal_point()

    def literal_point(self):
        scene, m, r = self.scene, self.scene.m, random.Random(self.scene.seed + 5)
        machines = [e.machine for e in m.elements if hasattr(e, 'machine')]
        x = {n: r.uniform(*scene.ranges.get(n, (-1, 1))) for k in machines for n in k.states}
        held = [n for k in machines for n in getattr(k, 'held', [])]
        v = {n: r.uniform(-1, 1) for n in scene.inputs + scene.open + held}
        s = State(.3,
                  scene.somewhere().q, np.array([r.gauss(0, 1) for _ in range(m.nu)]),
                  {j.name: (np.zeros(j.nq()), np.zeros(j.nu()))
                   for j in m.cuts}, x, v)
        from compare import natural_speeds
        s.threads = {j.name: (r.uniform(-2, 2), r.gauss(0, 1))
                     for j in m.cuts if j.type == 'helical'}
        turns = [(j.names[0] + end, a) for j in m.cuts if j.name in s.threads
                 for end, a in zip(('', '_d'), s.threads[j.name])]
        values = [('t', s.t), *zip(m.names(), s.q), *zip(natural_speeds(m), s.u), *turns,
                  *x.items(), *v.items(), *scene.run.items()]
        self.points = '[[' + ', '.join('%s = %r' % (n, float(a)) for n, a in values) + ']]'
        self.literal = s

    def literal_error(self, folder, order):
        """of M and of N + G - P; order: of the speeds in the code. Threads that were cut and count
        their turns are joints of the tree by now, behind the others (compare.with_nut)"""
        m, s, numbers = self.scene.m, self.literal, np.array(
            [float(line) for line in open(self.path(folder) + '.literal')])
        n = m.nu
        turns = [s.threads[j.name] for j in m.tree if j.name in s.threads]
        s.q, s.u = (np.append(a, [x[k] for x in turns]) for k, a in enumerate((s.q, s.u)))
        M, B, drive, _ = m.projected(s)
        rest = (B - drive)[order]
        N, G, P = numbers[n*n:].reshape(3, n)
        return {
            'literal M': error(numbers[:n*n].reshape(n, n), M[np.ix_(order, order)]),
            'literal N+G-P': error(N + G - P, rest, 1e-3*max(1., np.max(np.abs([N, G, P]))))
        }

    def path(self, folder):
        return os.path.join(folder, self.scene.name)


def judged(call, folder, library):
    """{'worst': errors, 'notes': ...} of a scene that was derived"""
    scene = call.scene
    path, said = compiled(folder, scene.name, library)
    if not path:
        return {'verdict': 'does not compile', 'said': said}
    with open(call.path(folder) + '.json') as f:
        code = Code(path, json.load(f), scene.run)
    if code.info:
        return {'verdict': 'wrong', 'said': 'PRE gives INFO = %d' % code.info}
    c = Comparison(scene, code, call.requests)
    states = c.run(STATES)
    if call.literal and os.path.exists(call.path(folder) + '.literal'):
        c.worst.update(call.literal_error(folder, c.u_order))
    wrong = [k for k, e in c.worst.items() if not e <= LIMITS[k]]
    return {
        'verdict': 'wrong' if wrong else 'right', 'worst': c.worst, 'notes': c.notes, 'states':
        states, 'said': ' '.join('%s %.1e' % (k, c.worst[k]) for k in wrong)
    }


def apart(call, folder, library):
    """judged in a process of its own: emitted code may end it"""
    path = call.path(folder) + '.result'
    pid = os.fork()
    if pid == 0:
        with open(path, 'w') as f:
            json.dump(judged_or_failed(call, folder, library), f)
        os._exit(0)
    _, status = os.waitpid(pid, 0)
    if status:
        return {'verdict': 'crash of the emitted code', 'said': 'status %d' % status}
    with open(path) as f:
        return json.load(f)


def judged_or_failed(call, folder, library):
    try:
        return judged(call, folder, library)
    except Exception:
        text = traceback.format_exc().strip().split('\n')
        return {'verdict': 'wrong', 'said': text[-1] + ' at ' + text[-2].strip()}


def sources():
    """a word that changes with the package, the library, the Fortran and this comparison"""
    ends = ('gsmbp/**/*.mac', 'gsmbp/**/*.lisp', 'share/*/*.mac', 'share/fortran/**/*.f',
            'tests/random/*')
    word = hashlib.sha256()
    for path in sorted(p for e in ends for p in glob.glob(os.path.join(ROOT, e), recursive=True)):
        if os.path.isfile(path):
            word.update(path[len(ROOT):].encode() + open(path, 'rb').read())
    return word.hexdigest()[:12]


SOURCES = sources()


def results_file(folder, seeds):
    return os.path.join(folder, 'chunk_%d_%d_%s.out' % (seeds[0], len(seeds), SOURCES))


def judged_before(folder, seeds):
    """whether an earlier run on the same sources has left the results of every scene"""
    path = results_file(folder, seeds)
    return os.path.exists(path) and len(open(path).readlines()) == len(seeds)


def chunk(folder, seeds, path):
    """results of some scenes as lines of JSON"""
    os.makedirs(folder, exist_ok=True)
    library, calls = run_time(ROOT, folder), [Call(s) for s in seeds]
    for c in calls:
        with open(c.path(folder) + '.mac', 'w') as f:
            f.write(c.scene.text)
    derived = {}
    for lisp in ('GCL', 'ECL'):
        derived.update(derive(ROOT, folder, [c for c in calls if c.way.lisp == lisp], lisp))
    with open(path, 'w') as out:
        for c in calls:
            out.write(json.dumps(result(c, folder, library, *derived[c.scene.name])) + '\n')
            out.flush()


def result(call, folder, library, verdict, seconds):
    r = {'verdict': verdict, 'said': said(call, folder)}
    if verdict == 'done':
        r = apart(call, folder, library)
    if verdict == 'refused' and any(k in r['said'] and f(call.scene) for k, f in REFUSALS.items()):
        r['verdict'] = 'refused rightly'
    way = call.way.names()
    if os.path.exists(call.path(folder) + '.cheapest'):
        way = [w.replace('forward: articulated', 'forward: cheapest') for w in way]
        way += ['forward: not as asked']
    r.update({'name': call.scene.name, 'seconds': seconds, 'way': way})
    r['tags'] = sorted(call.scene.tags)
    if call.way.literal and not call.literal:
        r['literal'] = 'left out'
    if r['verdict'] == 'right':
        for end in ('.f', '.so'):
            os.remove(call.path(folder) + end)
    return r


def said(call, folder):
    try:
        return ' '.join(open(call.path(folder) + '.error').read().split())[:400]
    except OSError:
        return ''


def failed(r):
    return r['verdict'] not in ('right', 'refused rightly')


def table(results):
    """what became of the scenes of each way"""
    print('%-26s %7s %8s %7s   %s' % ('', 'judged', 'refused', 'failed', 'longest derivation'))
    for way in sorted({w for r in results for w in r['way']}):
        own = [r for r in results if way in r['way']]
        slow = max(own, key=lambda r: r['seconds'])
        count = collections.Counter(r['verdict'] for r in own)
        right, refused = count['right'], count['refused rightly']
        print('%-26s %7d %8d %7d   %.1f s (%s)' % (way, right, refused, len(own) - right - refused,
                                                   slow['seconds'], slow['name']))


def report(results):
    """prints the counts; returns those that are wrong"""
    bad = [r for r in results if failed(r)]
    right = [r for r in results if r['verdict'] == 'right']
    count = collections.Counter(w for r in right for w in r['tags'])
    print('elements: ' + ', '.join('%s %d' % x for x in sorted(count.items())))
    routines, worst = collections.Counter(), {}
    for r in results:
        for k, e in r.get('worst', {}).items():
            routines[k] += 1
            if r['verdict'] == 'right' and e >= worst.get(k, (-1, ''))[0]:
                worst[k] = (e, r['name'])
    for k in sorted(worst):
        print('%s: %d scenes, worst %.1e (%s), may be %.0e' %
              (k, routines[k], worst[k][0], worst[k][1], LIMITS[k]))
    notes = collections.Counter(n.split('(')[0] for r in results for n in r.get('notes', []))
    print('notes: ' + ', '.join('%s %d' % x for x in notes.items()))
    table(results)
    verdicts = collections.Counter(r['verdict'] for r in results)
    left = sum(r.get('literal', '') == 'left out' for r in results)
    print('%d scenes: %s; literal equations left out of %d that have Euler parameters or speeds '
          'of their own' % (len(results), ', '.join('%s %d' % x for x in verdicts.items()), left))
    return bad + enough(right, routines, count)


def entries():
    """the library's, by the names of their files"""
    groups = ('actuators', 'amplifiers', 'controllers', 'passive', 'sensors', 'transmissions')
    return sorted(f[:-4] for g in groups for f in os.listdir(os.path.join(ROOT, 'share', g))
                  if f.endswith('.mac'))


def enough(right, routines, elements):
    """in a long run every way has a tenth of what was judged, every entry of the library and
    every routine its turn; returns what was too seldom"""
    if len(right) < 1500:
        return []
    ways = collections.Counter(w for r in right for w in r['way'])
    wanted = {w: len(right)/10 for w in every_way()}
    few = ['%s %d' % (w, ways[w]) for w, n in wanted.items() if ways[w] < n]
    few += ['%s %d' % (k, routines[k]) for k in LIMITS if routines[k] < (10 if k == 'CTL' else 100)]
    few += ['%s %d' % (e, elements['device ' + e]) for e in entries()
            if elements['device ' + e] < 10]
    say(not few, 'every way, every routine and every entry of the library often enough ' +
        ', '.join(few))
    return few


def say(good, what):
    print(('ok ' if good else 'not ok ') + what)


def main():
    folder, first, count = os.path.abspath(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    jobs = int(sys.argv[4]) if len(sys.argv) > 4 else 2
    os.makedirs(folder, exist_ok=True)
    run_time(ROOT, folder)
    size, end = min(CHUNK, -(-count//jobs)), first + count
    waiting = [range(s, min(s + size, end)) for s in range(first, end, size)]
    done = [seeds for seeds in waiting if judged_before(folder, seeds)]
    waiting = [seeds for seeds in waiting if seeds not in done]
    running = []
    results = [r for seeds in done for r in collected(folder, seeds)]
    if done:
        print('%d scenes were judged before' % len(results))
    progress = Progress(len(results), count)
    while waiting or running:
        while waiting and len(running) < jobs:
            running.append(started(folder, waiting.pop(0)))
        for p, seeds in list(running):
            if p.poll() is not None:
                running.remove((p, seeds))
                results += collected(folder, seeds)
                progress.show(results)
        time.sleep(.2)
    bad = report(results)
    say(not bad, '%d scenes of chance are right' % len(results))
    sys.exit(1 if bad else 0)


def started(folder, seeds):
    command = [
        sys.executable, __file__, '--chunk', folder,
        str(seeds[0]),
        str(len(seeds)),
        results_file(folder, seeds)
    ]
    env = {**os.environ, 'OMP_NUM_THREADS': '1', 'OPENBLAS_NUM_THREADS': '1'}
    return subprocess.Popen(command, env=env, preexec_fn=dies_with_parent), seeds


class Progress:

    def __init__(self, before, count):
        self.before, self.count, self.began = before, count, time.time()

    def show(self, results):
        used, n = os.times(), len(results)
        print('%d of %d scenes, %d failed; %.1f CPU seconds a scene, %.0f min' %
              (n, self.count, sum(failed(r) for r in results),
               (used.children_user + used.children_system)/(n - self.before),
               (time.time() - self.began)/60))
        sys.stdout.flush()


def collected(folder, seeds):
    """results of a chunk; those that its process did not reach are lost"""
    path = results_file(folder, seeds)
    found = [json.loads(line) for line in open(path)] if os.path.exists(path) else []
    for seed in list(seeds)[len(found):]:
        found.append({'verdict': 'lost', 'name': 'seed %d' % seed, 'said': '', 'way': [],
                      'tags': [], 'seconds': 0.})
    for r in found:
        if failed(r):
            print('%s %s: %s [%s] {%s}' %
                  (r['verdict'], r['name'], r['said'], ', '.join(r['way']), ', '.join(r['tags'])))
    return found


if __name__ == '__main__':
    if sys.argv[1] == '--chunk':
        chunk(sys.argv[2], range(int(sys.argv[3]), int(sys.argv[3]) + int(sys.argv[4])),
              sys.argv[5])
    else:
        main()
