"""simulate.py CASES FMUS REFERENCES FORTRAN [SCENE ...]: the FMUs of the cases in FMPy against the
references; prints a line `ok` or `not ok` for each check.

Co-simulation: all states within 100 times the tolerance, 1e-10 (1e-8), of the reference, each
beside the largest value it takes, at least its nominal one. Model exchange: FMPy's CVODE at the
tolerance 1e-8, the error at most twice that of the same CVODE on the emitted right-hand side, which
Octave's handles call, at the same tolerance, or 1e-9. With events, which CVODE on the handles does
not have, 1e-6 at the tolerance 1e-10."""

import ctypes
import json
import os
import sys

import fmpy
import numpy as np
from fmpy import simulate_fmu
from fmpy.sundials import CVodeSolver
from fmpy.validation import validate_fmu

TIGHT, LOOSE = 1e-10, 1e-8


def cases(path, wanted):
    for line in open(path):
        words = line.split()
        if words and words[0][0] != '#' and (not wanted or words[0] in wanted):
            values = dict(word.split('=') for word in words[3:])
            yield words[0], float(words[1]), words[2], {k: float(v) for k, v in values.items()}


def told(good, text):
    print(('ok ' if good else 'not ok ') + text, flush=True)


def difference(x, reference, nominal):
    """the largest difference of the states, each beside the largest value it takes"""
    scale = np.maximum(np.abs(reference).max(axis=0), nominal)
    return (np.abs(x - reference) / scale).max()


def run(path, kind, end, start, names, tolerance):
    fine = 10 if kind == 'ModelExchange' else 1
    result = simulate_fmu(path, fmi_type=kind, stop_time=end, relative_tolerance=tolerance,
                          output_interval=end / 40 / fine, start_values=start, output=names,
                          record_events=False)
    t = result['time']
    at = [int(np.argmin(np.abs(t - end * k / 40))) for k in range(41)]
    if np.abs(t[at] - np.linspace(0, end, 41)).max() > 1e-9 * end:
        raise Exception('an output time is missing')
    return np.array([[result[name][k] for name in names] for k in at])


class Emitted:
    """the emitted right-hand side, as FMPy's CVodeSolver wants it"""

    def __init__(self, library, description, inputs, x):
        d, name = description['dimensions'], description['name']
        self.rhs = getattr(library, name + '_rhs_')
        self.x, self.t = np.array(x), np.zeros(1)
        self.nominal = np.array(description['nominal'], float)
        self.v = np.array(inputs + [0.0])
        par, self.cst = np.zeros(d['npar'] + 1), np.zeros(d['ncst'] + 1)
        self.info = ctypes.c_int()
        getattr(library, name + '_par_')(self.pointer(par))
        getattr(library, name + '_pre_')(self.pointer(par), self.pointer(self.cst),
                                         ctypes.byref(self.info))

    @staticmethod
    def pointer(a):
        return a.ctypes.data_as(ctypes.c_void_p)

    def get_x(self, p, n):
        ctypes.memmove(p, self.pointer(self.x), 8 * n)

    def set_x(self, p, n):
        ctypes.memmove(self.pointer(self.x), p, 8 * n)

    def get_dx(self, p, n):
        self.rhs(self.pointer(self.t), self.pointer(self.x), self.pointer(self.v),
                 self.pointer(self.cst), p, ctypes.byref(self.info))

    def get_nominals(self, p, n):
        ctypes.memmove(p, self.pointer(self.nominal), 8 * n)

    def set_time(self, t):
        self.t[0] = t

    def apply(self, t):
        pass


def on_handles(emitted, end, tolerance, held=None):
    """the states at 41 times by FMPy's CVODE; held: a row of inputs for each of equal parts of the
    run, behind which the integration starts again where they change"""
    parts = 400 if held is None else len(held)
    n = len(emitted.x)
    solver = CVodeSolver(nx=n, nz=0, get_x=emitted.get_x, set_x=emitted.set_x,
                         get_dx=emitted.get_dx, get_z=lambda z, n: None,
                         get_nominals=emitted.get_nominals, set_time=emitted.set_time,
                         input=emitted, startTime=0.0, maxStep=end / 50,
                         relativeTolerance=tolerance)
    rows, t = [emitted.x.copy()], 0.0
    for k in range(parts):
        if held is not None and np.any(held[k] != emitted.v[:-1]):
            emitted.v[:-1] = held[k]
            solver.reset(t)
        _, _, t = solver.step(t, end * (k + 1) / parts)
        if (k + 1) * 40 % parts == 0:
            rows.append(emitted.x.copy())
    return np.array(rows)


def held_inputs(path, description, end, start, parts):
    """the inputs in each of equal parts of a run of sampled devices, whose samples and delays are
    multiples of such a part: from co-simulation, which has them after the sample at its start"""
    names = [one['name'] for one in description['inputs']]
    result = simulate_fmu(path, fmi_type='CoSimulation', stop_time=end, relative_tolerance=TIGHT,
                          output_interval=end / parts, start_values=start, output=names)
    return np.array([[row[name] for name in names] for row in result[:-1]])


def one(scene, end, kind, start, fmus, references, fortran):
    description = json.load(open(f'{fortran}/{scene}.json'))
    names = [state['name'] for state in description['states']]
    nominal = np.array(description['nominal'], float)
    reference = np.loadtxt(f'{references}/{scene}.txt')[:, 1:1 + len(names)]
    inputs = [start.get(one['name'], 0.0) for one in description['inputs']]
    handles = None
    if kind not in ('passage', 'events'):
        library = ctypes.CDLL(os.path.abspath(f'{fortran}/{scene}.so'))
        held = None
        if kind == 'sampled':
            held = held_inputs(f'{fmus}/{scene}_fmi3.fmu', description, end, start,
                               40 * round(end / 40 / 5e-5))
        handles = difference(on_handles(Emitted(library, description, inputs, reference[0]), end,
                                        LOOSE, held), reference, nominal)
    for version in (2, 3):
        path = f'{fmus}/{scene}_fmi{version}.fmu'
        problems = validate_fmu(path)
        told(not problems, f'{scene} {version}.0 is valid' + ''.join(f'; {p}' for p in problems))
        said = f'{scene} {version}.0'
        error = difference(run(path, 'CoSimulation', end, start, names, TIGHT), reference, nominal)
        told(error <= 100 * TIGHT, f'{said} co-simulation: {error:.1e}')
        if kind == 'passage':
            continue
        tolerance = TIGHT if kind == 'events' else LOOSE
        error = difference(run(path, 'ModelExchange', end, start, names, tolerance), reference,
                           nominal)
        if handles is None:
            told(error <= 1e-6, f'{said} model exchange: {error:.1e}')
        else:
            told(error <= max(2 * handles, 1e-9),
                 f'{said} model exchange: {error:.1e}, on handles {handles:.1e}')


def main(path, fmus, references, fortran, *wanted):
    for scene, end, kind, start in cases(path, wanted):
        try:
            one(scene, end, kind, start, fmus, references, fortran)
        except Exception as problem:
            told(False, f'{scene}: {problem}'.replace('\n', ' ')[:300])


main(*sys.argv[1:])
