#!/usr/bin/python3 -B
"""Malformed scenes: each is valid (derives, compiles, gives a finite result), warned, or refused by
one clear error.

  judge.py hand [STEP [FROM]]   every STEP-th of the 300 scenes of hand.py, against the verdicts of
                                table.txt
  judge.py table [STEP [FROM]]  lines for table.txt
  judge.py mutants SEED COUNT   mutants of the examples and of tests/scenes: request [mass], no
                                verdicts to compare with

Verdicts: valid, warned, refused; syntax: Maxima's parser, GSMBP never saw it. The others are
faults: unnamed (an error of GSMBP that does not name the element), raw (Maxima's own error, or a
routine's name), trace (Maxima's list of the functions that were being called), lisp, hang (40 s),
asked (a question), half (half of a pair of files), silent (neither a word nor files), wrong
(accepted, but it does not compile or its result is not finite).
"""
import glob, json, os, re, select, shutil, subprocess, sys, tempfile, time
from hand import CASES
from mutants import mutants, ROOT
HERE = os.path.dirname(os.path.abspath(__file__))
TABLE = HERE + '/table.txt'
GOOD = ('valid', 'warned', 'refused', 'syntax')
QUESTION = (rb'positive, negative|Acceptable answers|positive or negative|zero or nonzero|'
            rb'an integer\?|;ask')

class Maxima:
    """a session that is asked again and again, and started anew when it hangs"""
    def __init__(self, folder):
        self.folder, self.count = folder, 0
        self.start()
    def start(self):
        command = [os.environ.get('MAXIMA', 'maxima'), '--very-quiet', '--init=none']
        self.p = subprocess.Popen(command, cwd=self.folder, stdin=subprocess.PIPE,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, bufsize=0)
        self.ask('load("%s/gsmbp/gsmbp.mac")$' % ROOT, 120)
    def stop(self):
        self.p.kill(); self.p.wait(); self.p.stdin.close(); self.p.stdout.close()
    def restart(self, text, why):
        self.stop(); self.start()
        return text.decode(errors='replace'), why
    def ask(self, text, limit=40):
        """(what Maxima printed, fault or "")"""
        self.count += 1
        mark = 'MARK%dEND' % self.count
        self.p.stdin.write((text + '\nprint("%s")$\n' % mark).encode())
        out, end = b'', time.time() + limit
        while time.time() < end:
            if not select.select([self.p.stdout], [], [], 1)[0]: continue
            b = os.read(self.p.stdout.fileno(), 65536)
            if not b: return self.restart(out, 'lisp')
            out += b
            if mark.encode() in out: return out.decode(errors='replace').replace(mark, ''), ''
            if re.search(QUESTION, out): return self.restart(out, 'asked')
        return self.restart(out, 'hang')

def first_error(out, name):
    """verdict on an output that holds an error"""
    if 'incorrect syntax' in out: return 'syntax'
    head = re.split(r'#0:|-- an error', out)[0]
    if not re.search(r'\bgsmbp(_\w+)?: ', head): return 'raw'
    if '#0:' in out: return 'trace'
    return 'refused' if not name or name.strip('"\'')[:100] in head else 'unnamed'

def verdict(out, fault, name, files):
    o = ' '.join(out.split())
    if fault: return fault
    if any(f.endswith(('.tmp', '_tmp')) for f in files): return 'half'
    if sum(f.endswith('.f') for f in files) != sum(f.endswith('.json') for f in files):
        return 'half'
    if re.search('Lisp error|MACSYMA restart|Unrecoverable|bind stack', o): return 'lisp'
    if '-- an error' in o or 'incorrect syntax' in o: return first_error(o, name)
    return 'warned' if re.search(r'warning: |removed: ', o) else 'valid'

MAIN = """      PROGRAM RUNS
      INTEGER I, INFO
      DOUBLE PRECISION PAR(%d), CST(%d), X(%d), V(%d), XD(%d), S
      CALL %s_PAR( PAR )
      CALL %s_PRE( PAR, CST, INFO )
      IF ( INFO.NE.0 ) STOP 1
%s
      DO 10 I = 1, %d
        V(I) = 0.2D0
   10 CONTINUE
      CALL %s_RHS( 0.1D0, X, V, CST, XD, INFO )
      IF ( INFO.NE.0 ) STOP 2
      S = 0.0D0
      DO 20 I = 1, %d
        S = S + ABS( XD(I) )
   20 CONTINUE
      IF ( .NOT.( S.LT.1.0D300 ) ) STOP 3
      END
"""
class Fortran:
    """compiles what was emitted and asks for the rates of the states near the start"""
    def __init__(self, folder):
        self.folder = folder
        os.makedirs(folder + '/lib')
        sources = [f for place in ('*', 'solve/plain')
                   for f in glob.glob('%s/share/fortran/%s/*.f' % (ROOT, place))]
        self.run(['gfortran', '-O0', '-w', '-c'] + sources, folder + '/lib')
        self.run(['sh', '-c', 'ar cr libgs.a *.o'], folder + '/lib')
    def run(self, command, folder):
        return subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, timeout=120).returncode
    def is_finite(self, folder, file):
        d = json.load(open('%s/%s.json' % (folder, file)))
        s, n = d['dimensions'], d['name'].upper()
        start = [x if d['loops'] or d['orientation'] else x + 0.3 for x in d['initial']]
        text = '\n'.join('      X(%d) = %.15E' % (k + 1, x) for k, x in enumerate(start))
        text = text.replace('E', 'D')
        sizes = tuple(max(1, s[k]) for k in ('npar', 'ncst', 'nx', 'nv', 'nx'))
        main = MAIN % (sizes + (n, n, text, max(1, s['nv']), n, s['nx']))
        open(folder + '/gsmbp-runs.f', 'w').write(main)
        if self.run(['gfortran', '-O0', '-w', 'gsmbp-runs.f', file + '.f', '-o', 'gsmbp-runs',
                     '-L' + self.folder + '/lib', '-lgs', '-llapack', '-lblas'], folder):
            return False
        return self.run(['./gsmbp-runs'], folder) == 0

def judged(cases, request, folder, fortran):
    """(verdict, what was printed) of each case"""
    m = Maxima(folder)
    for k, (cls, name, text) in enumerate(cases):
        d = '%s/c%03d' % (folder, k)
        os.makedirs(d)
        open(d + '/case.mac', 'w').write(text + '\n')
        out, fault = m.ask('kill(scene)$ load("%s/case.mac")$\n'
                           'gsmbp_fortran(scene, %s, directory = "%s/fo")$' % (d, request, d))
        # the load failed
        out = re.split(r'gsmbp_fortran: (?:expected a scene|the first argument)', out)[0]
        files = os.listdir(d + '/fo') if os.path.isdir(d + '/fo') else []
        v = verdict(out, fault, name, files)
        made = [f[:-2] for f in files if f.endswith('.f')]
        if v == 'valid' and not made: v = 'silent'
        if v == 'valid' and fortran and not fortran.is_finite(d + '/fo', made[0]): v = 'wrong'
        shutil.rmtree(d, ignore_errors=True)
        yield v, ' '.join(re.split(r'#0:|-- an error', out)[0].split())
    m.stop()

def line(k, case, v, text):
    said = re.sub(r'^gsmbp_scene: ', '', text)[:110]
    reason = said if v != 'valid' else 'derives, compiles, finite'
    return '%03d %-8s %-15s %-24s %s' % (k, v, case[0], ' '.join(case[1].split())[:24], reason)

def main(args, folder):
    if args[0] == 'mutants':
        cases, count = mutants(int(args[1]), int(args[2])), {}
        for case, (v, text) in zip(cases, judged(cases, '[mass]', folder, None)):
            count[v] = count.get(v, 0) + 1
            if v not in GOOD: print('not ok', v, case[0], case[1], '|', text[:300], flush=True)
        print('ok %d mutants:' % len(cases), count)
    else:
        step, first = (list(map(int, args[1:])) + [1, 0][len(args) - 1:])[:2]
        chosen = range(first, len(CASES), step)
        told = {}
        if args[0] == 'hand':
            told = {int(l[:3]): l.split()[1] for l in open(TABLE) if l[:3].isdigit()}
        results = judged([CASES[k] for k in chosen], 'all', folder, Fortran(folder))
        for k, (v, text) in zip(chosen, results):
            mark = ''
            if told:
                mark = 'ok ' if v == told.get(k) else 'not ok: expected %s, found ' % told.get(k)
            print(mark + line(k, CASES[k], v, text), flush=True)

if __name__ == '__main__':
    place = tempfile.mkdtemp()
    try: main(sys.argv[1:], place)
    finally: shutil.rmtree(place, ignore_errors=True)
