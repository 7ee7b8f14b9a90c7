"""Maxima sessions that derive scenes one after the other: a crash or a hang is that of one scene,
the others go on."""
import ctypes
import os
import shutil
import subprocess
import sys
import time

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'tools'))
from maxima import maxima  # noqa: E402
CPU_LIMIT = 60.
TICKS = os.sysconf('SC_CLK_TCK')


def dies_with_parent():
    """no session outlives who started it (PR_SET_PDEATHSIG, SIGKILL)"""
    os.setpgid(0, 0)
    ctypes.CDLL(None).prctl(1, 9)


def cpu_of_group(pid):
    """processor seconds of the processes of a group"""
    total = 0
    for p in os.listdir('/proc'):
        if p.isdigit():
            try:
                fields = open('/proc/%s/stat' % p).read().rsplit(')', 1)[1].split()
            except OSError:
                continue
            if int(fields[2]) == pid:
                total += int(fields[11]) + int(fields[12])
    return total/TICKS


def command(root, folder, call):
    words = {'passes': call.way.passes, 'requests': call.requests}
    listed = {k: '[' + ', '.join(v) + ']' for k, v in words.items()}
    return 'random_derive("%s", "%s", \'%s, \'%s, \'%s, \'%s, %s)$' % (
        folder, call.scene.name, listed['passes'], call.way.forward, call.way.numbers,
        listed['requests'], call.points)


def derive(root, folder, calls, lisp):
    """{name: (verdict, seconds)} of the scenes: done, refused, crashed, hangs"""
    found, left, k = {}, list(calls), 0
    while left:
        log = os.path.join(folder, 'session_%s_%d.log' % (left[0].scene.name, k))
        session(root, folder, left, lisp, log, found)
        left, k = [c for c in left if c.scene.name not in found], k + 1
    for c in calls:
        path = os.path.join(folder, c.scene.name)
        verdict, seconds = found[c.scene.name]
        if verdict == 'done' and os.path.exists(path + '.error'):
            found[c.scene.name] = ('refused', seconds)
        elif verdict == 'done' and not os.path.exists(path + '.json'):
            found[c.scene.name] = ('crashed', seconds)
    return found


def session(root, folder, calls, lisp, log, found):
    batch = log[:-4] + '.batch'
    ecl = lisp == 'ECL' and shutil.which('maxima-sage')
    words, loaded = maxima(root, image=not ecl)
    if ecl:
        words[0] = ecl
    with open(batch, 'w') as f:
        if not loaded:
            f.write('load("%s/gsmbp/gsmbp.mac")$\n' % root)
        f.write('load("%s/tests/random/derive.mac")$\n' % root)
        f.write('\n'.join(command(root, folder, c) for c in calls) + '\n')
    with open(log, 'w') as out:
        p = subprocess.Popen([*words, '--very-quiet', '-b', batch],
                             stdin=subprocess.DEVNULL,
                             stdout=out,
                             stderr=subprocess.STDOUT,
                             preexec_fn=dies_with_parent,
                             env={
                                 **os.environ, 'GCL_GC_ALLOC_MIN': '0.5',
                                 'GC_INITIAL_HEAP_SIZE': '512m',
                                 'GC_MARKERS': '1'
                             })
    watch(p, calls, log, found)


def watch(p, calls, log, found):
    """follows the log until the session ends; what was begun and not done is what ended it"""
    began, name = {}, None
    while True:
        over = p.poll() is not None
        with open(log, errors='replace') as f:
            name = followed(f.read(), p.pid, began, name, found)
        if over:
            break
        if name and name not in found and cpu_of_group(p.pid) - began[name] > CPU_LIMIT:
            os.killpg(p.pid, 9)
            p.wait()
            found[name] = ('hangs', CPU_LIMIT)
            return
        time.sleep(.2)
    name = name or calls[0].scene.name
    if name in found and any(c.scene.name not in found for c in calls):
        name = next(c.scene.name for c in calls if c.scene.name not in found)
    found.setdefault(name, ('crashed', 0.))


def followed(text, pid, began, name, found):
    """the scene that was begun last; began: processor time at that, found: what is done"""
    for line in text.split('\n'):
        word = line.split()
        if len(word) == 2 and word[0] == 'BEGIN' and word[1] not in began:
            if name and name not in found:
                found[name] = ('Lisp error', 0.)
            name, began[word[1]] = word[1], cpu_of_group(pid)
        if len(word) == 3 and word[0] == 'DONE':
            found[word[1]] = ('done', float(word[2]))
    return name
