"""Scenes derived in one session, compiled at once, judged one by one."""
import json
import os
import random
import subprocess
import traceback
import modules
from calls import calls_of
from compare import LIMITS, Beside
from emitted import FLAGS, Code, run_time
from session import derive
from states import drawn

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STATES = 3


def compiled(folder, names, library):
    """one shared object of all; what gfortran said"""
    if not names:
        return None, 'nothing is derived'
    out = os.path.join(folder, 'all%s.so' % names[0])
    said = subprocess.run(['gfortran'] + FLAGS + ['-shared', '-o', out] + [
        os.path.join(folder, n + '.f') for n in names] + [library, '-Wl,-rpath,' + folder],
        capture_output=True, text=True)
    return (out, '') if said.returncode == 0 else (None, said.stderr[-400:])


def code_of(folder, call, library):
    with open(call.path(folder) + '.json') as f:
        return Code(library, json.load(f), call.told.values() if call.told else {})


def judged(folder, seed, b, calls, library):
    """result of a scene and its twins"""
    r, one = random.Random('states %d' % seed), code_of(folder, calls[0], library)
    states = [s for s in (drawn(b, one, r) for _ in range(STATES)) if s]
    result = {'verdict': 'right' if states else 'no state', 'worst': {}, 'said': ''}
    for c in calls[1:]:
        beside = Beside(b, one, code_of(folder, c, library), c.told)
        for s in states:
            beside.at(*s)
        noted(result, beside.worst, ' + '.join(c.kinds))
    if calls[0].module and states:
        pair = (calls[0], calls[-1])
        codes = [code_of(folder, c, library) for c in pair]
        worst = modules.of_module(ROOT, folder, pair, codes, states, calls[-1].told)
        noted(result, worst, 'module')
    return result


def noted(result, worst, what):
    for k, e in worst.items():
        result['worst'][k] = max(result['worst'].get(k, 0.), e)
    wrong = ['%s %.1e' % (k, e) for k, e in worst.items() if not e <= limit(k)]
    if wrong:
        result['verdict'] = 'wrong'
        result['said'] += '(%s) %s; ' % (what, ', '.join(wrong))


def limit(word):
    return LIMITS.get(word, 1e-9)


def apart(folder, seed, b, calls, library):
    """judged in a process of its own: emitted code may end it"""
    path = calls[0].path(folder) + '.result'
    pid = os.fork()
    if pid == 0:
        try:
            found = judged(folder, seed, b, calls, library)
        except Exception:
            found = {'verdict': 'failed', 'worst': {}, 'said': traceback.format_exc()[-600:]}
        with open(path, 'w') as f:
            json.dump(found, f)
        os._exit(0)
    _, status = os.waitpid(pid, 0)
    if status:
        return {'verdict': 'crash', 'worst': {}, 'said': 'status %d' % status}
    with open(path) as f:
        return json.load(f)


def chunk(folder, seeds, path, kinds=None):
    """results of some scenes as lines of JSON"""
    library = run_time(ROOT, folder, '-O0')
    modules.run_time(ROOT, folder)
    scenes = {s: calls_of(s, kinds) for s in seeds}
    every = [c for _, calls in scenes.values() for c in calls]
    for c in every:
        c.write(folder)
    derived = derive(ROOT, folder, every, 'GCL')
    names = [c.scene.name for c in every if derived[c.scene.name][0] == 'done']
    whole, said = compiled(folder, names, library)
    with open(path, 'w') as out:
        for s, (b, calls) in scenes.items():
            out.write(json.dumps(result(folder, s, b, calls, derived, whole, said)) + '\n')
            out.flush()


def result(folder, seed, b, calls, derived, library, said):
    bad = [c for c in calls if derived[c.scene.name][0] != 'done']
    if bad:
        verdict = derived[bad[0].scene.name][0]
        found = {'verdict': verdict if bad[0] is not calls[0] else verdict + ' as it is',
                 'worst': {}, 'said': ' '.join(message(c, folder) for c in bad)}
    elif not library:
        found = {'verdict': 'does not compile', 'worst': {}, 'said': said}
    else:
        found = apart(folder, seed, b, calls, library)
    found.update({'seed': seed, 'features': b.scene.features, 'module': calls[0].module,
                  'twins': [k for c in calls[1:] for k in c.kinds]})
    return found


def message(call, folder):
    try:
        text = ' '.join(open(call.path(folder) + '.error').read().split())[:400]
    except OSError:
        text = ''
    return '(%s) %s' % (' + '.join(call.kinds), text)
