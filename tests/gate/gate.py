#!/usr/bin/python3
"""gate.py [SCENE ...]: may the run time in C take the place of the Fortran run time? Whole runs of
twelve scenes by dp853 and rk4, by the Fortran run time of the commit in tests/data/before/base,
which is built from git in a temporary folder, and by share/engine/core as it is here, both with the
same emitted Fortran, in turn in one process: the least of 40 processor times each. The table has
calls of RHS, instructions as valgrind counts them, where it is there, and the error of the last
state against quad precision in nominal magnitudes, too. The last line is "gate: passed" or what
missed. GSMBP_TEST_DIR, if given, keeps what is derived and compiled."""
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = ROOT / 'tests/gate'
CORE = ROOT / 'share/engine/core'
SCENES = ('ident_scara', 'examples/puma560', 'examples/four_bar', 'examples/balanced_linkage',
          'examples/stewart', 'event_arm', 'event_blocks', 'sampled_drive', 'saturated_digital',
          'fluid_hydraulic', 'flexible_full', 'flexible_slider_crank')
METHODS = 'dp853', 'rk4'
MEDIAN, WORST = 1.05, 1.15     # ratios of times
ERRORS, ROUNDING = 2, 1e-13    # errors may be this much larger; below this they are rounding


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f'gate: {" ".join(map(str, command[:6]))} ...:\n{done.stdout}{done.stderr}')
    return done.stdout


def source(name):
    if name.startswith('examples/'):
        return next(ROOT.glob(f'examples/*/{name[9:]}.mac'))
    return ROOT / f'tests/scenes/{name}.mac'


def derive(work, names):
    """The folder of each scene with its Fortran and JSON."""
    folder = {}
    os.environ.setdefault('GSMBP_CACHE', str(pathlib.Path(
        os.environ.get('XDG_CACHE_HOME') or pathlib.Path.home() / '.cache', 'gsmbp')))
    run(ROOT / 'share/make/compile')
    run(ROOT / 'share/make/maxima', work / 'maxima', 'print(build_info())$')
    os.environ['GSMBP_TEST_MAXIMA'] = '\n'.join(
        line for line in (work / 'maxima').read_text().splitlines()
        if re.match('(Maxima|Lisp|Host) ', line))
    for part, where in (False, 'fortran_out'), (True, 'examples'):
        chosen = [name for name in names if name.startswith('examples/') == part]
        files = [str(source(name).relative_to(ROOT)) for name in chosen]
        place = work / where
        place.mkdir(exist_ok=True)
        if files:
            kept = [ROOT / 'tests/tools/kept_scenes.py', 'fetch', place, work / 'keys', *files]
            run(*kept, cwd=ROOT)
            run(ROOT / 'tests/tools/derive_lot', place, work / 'derive', *files, cwd=ROOT)
            run(kept[0], 'keep', *kept[2:], cwd=ROOT)
        folder.update((name, place) for name in chosen)
    return folder


def jobs(work, names):
    """Their runs, in files; the compilers and options."""
    wanted = ', '.join(f'"{name}"' for name in names)
    run('octave-cli', '-qf', '--no-history', '--path', ROOT / 'octave', '--path', HERE, '--path',
        ROOT / 'tests/before', '--path', ROOT / 'tests/octave', '--eval',
        f'all = before_scenes ("{ROOT}", ""); gate_jobs (all(ismember ({{all.name}}, '
        f'{{{wanted}}})), "{work}/jobs");', env={**os.environ, 'GSMBP_TEST_DIR': str(work)})
    return dict(line.split(' ', 1) for line in (work / 'jobs/flags').read_text().splitlines())


def archives(work, flags, name, change):
    """The Fortran run time of the base and the one in C, a folder for each."""
    base = work / 'base'
    if not base.exists():
        commit = (ROOT / 'tests/data/before/base').read_text().strip()
        base.mkdir()
        packed = subprocess.run(['git', 'archive', commit, 'share/fortran'], cwd=ROOT,
                                capture_output=True, check=True).stdout
        subprocess.run(['tar', '-x', '-C', base], input=packed, check=True)
    fortran = [*base.glob('share/fortran/*/*.f'), *base.glob('share/fortran/solve/lapack/*.f')]
    c = [*CORE.glob('*/*.c'), *CORE.glob('*/*/*.c')]
    for part, words, sources in (('fortran', flags['fc'] + ' ' + flags['common'], fortran),
                                 ('c', f'{flags["cc"]} {flags["c"]} -I{CORE}', c)):
        place = work / name / part
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        run(*change(words).split(), '-c', *sources, cwd=place)
        run('ar', 'rcs', place / 'all.a', *place.glob('*.o'))


def table(json_file):
    """gate_scene.h: the scene as both run times take it."""
    d = json.loads(json_file.read_text())
    header = (ROOT / 'share/engine/host/fortran_scene.h').read_text()
    members = (CORE / 'gsmbp/scene.h').read_text()
    known = {*re.findall(r'#define GS_FORTRAN_([a-z]\w+)', header)} & {
        *re.findall(r'^  gs_\w+ \*(\w+);', members, re.M)}
    there = {row['name'].lower()[len(d['name']) + 1:]: row['name'].lower() + '_'
             for row in d['subroutines']}
    called = 'rhs prj con kin cmd clo vin out ctl evt rst'.split()
    sizes = [f'.{n} = {d["dimensions"].get(n, 0)}'
             for n in 'nq nu nx nv ny nlam nsw nev nctl nxk'.split()]
    members = [f'.{n} = run_{n}' for n in there if n in known]
    lines = [f'GS_FORTRAN_{n} (run_{n}, {there[n]})' for n in there if n in known]
    subs = ', '.join(f'(subroutine *) {there[n]}' if n in there else 'absent' for n in called)
    return '\n'.join(lines + [f'static const gs_scene scene = {{ {", ".join(sizes + members)} }};',
                              f'static subroutine *const subroutines[] = {{ {subs} }};', ''])


def program(work, flags, build, folder, name, change):
    """The program of a scene."""
    short = name.split('/')[-1]
    place = work / build / short
    place.mkdir(exist_ok=True)
    (place / 'gate_scene.h').write_text(table(folder / f'{short}.json'))
    run(*change(f'{flags["fc"]} {flags["scene"]}').split(), '-c', '-o', place / 'scene.o',
        folder / f'{short}.f')
    run(*change(f'{flags["cc"]} {flags["c"]}').replace('-std=c99', '-std=gnu11').split(),
        f'-I{place}', f'-I{CORE}', f'-I{ROOT}/share/engine', '-c', '-o', place / 'gate.o',
        HERE / 'gate.c')
    run(*flags['fc'].split(), '-o', place / 'gate', place / 'gate.o', place / 'scene.o',
        work / build / 'fortran/all.a', work / build / 'c/all.a', '-llapack', '-lblas', '-lm')
    return place / 'gate'


def instructions(gate, job, who):
    text = subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null',
                           '--collect-atstart=no', f'--toggle-collect=by_{who}', gate, job, who],
                          capture_output=True, text=True).stderr
    found = re.search(r'Collected : (\d+)', text)
    return int(found.group(1)) if found else 0


def counting_processor():
    """Valgrind knows no AVX-512."""
    cpu = pathlib.Path('/proc/cpuinfo')
    wide = cpu.exists() and 'avx512' in cpu.read_text()
    return (lambda words: words.replace('-march=native', '-march=x86-64-v3')) if wide else None


def measure(work, names):
    """A row for each run: name, words of gate.c for both, instructions of both."""
    folder = derive(work, names)
    (work / 'jobs').mkdir(exist_ok=True)
    flags = jobs(work, names)
    same, change = (lambda words: words), counting_processor()
    archives(work, flags, 'timed', same)
    counted = 'timed'
    if shutil.which('valgrind') and change:
        counted = 'counted'
        archives(work, flags, counted, change)
    for name in names:
        gate = program(work, flags, 'timed', folder[name], name, same)
        count = gate
        if counted != 'timed':
            count = program(work, flags, counted, folder[name], name, change)
        for method in METHODS:
            job = work / 'jobs' / f'{name.split("/")[-1]}.{method}'
            words = run(gate, job).split()
            found = {words[k]: [float(x) for x in words[k + 1:k + 5]] for k in (0, 5)}
            counts = [0, 0]
            if shutil.which('valgrind'):
                counts = [instructions(count, job, who) for who in ('fortran', 'c')]
            yield f'{name.split("/")[-1]} {method}', found['fortran'], found['c'], counts


def judged(rows):
    """What missed."""
    missed = []
    ratios = [c[0] / f[0] for _, f, c, _ in rows]
    if statistics.median(ratios) > MEDIAN:
        missed.append(f'median {statistics.median(ratios):.3f} above {MEDIAN}')
    for (name, f, c, _), ratio in zip(rows, ratios):
        if ratio > WORST:
            missed.append(f'{name}: {ratio:.3f} above {WORST}')
        if f[2] != c[2]:
            missed.append(f'{name}: INFO {c[2]:.0f} instead of {f[2]:.0f}')
        if not c[3] <= max(ERRORS * f[3], ROUNDING):
            missed.append(f'{name}: error {c[3]:.2g} instead of {f[3]:.2g}')
    print(f'median {statistics.median(ratios):.3f}, worst {max(ratios):.3f}')
    return missed


def main():
    names = [name for name in SCENES if not sys.argv[1:] or name in sys.argv[1:]]
    kept = os.environ.get('GSMBP_TEST_DIR')
    with tempfile.TemporaryDirectory() as own:
        work = pathlib.Path(kept or own)
        work.mkdir(exist_ok=True)
        print(f'{"run":32}{"Fortran":>9} {"C [us]":>9} {"C/F":>6}{"calls":>8}{"of C":>8}'
              f'{"instructions C/F":>18}{"error":>10}{"of C":>10}')
        rows = []
        for row in measure(work, names):
            name, f, c, (i, k) = row
            rows.append(row)
            print(f'{name:32}{1e6 * f[0]:9.1f} {1e6 * c[0]:9.1f} {c[0] / f[0]:6.3f}{f[1]:8.0f}'
                  f'{c[1]:8.0f}{k / i if i else float("nan"):18.3f}{f[3]:10.1e}{c[3]:10.1e}',
                  flush=True)
        missed = judged(rows)
    print('gate: ' + ('; '.join(missed) or 'passed'))
    sys.exit(bool(missed))


if __name__ == '__main__':
    main()
