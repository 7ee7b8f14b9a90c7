"""A scene as a module of Python (C inside) beside its Fortran, and its run beside that of its
twin."""
import glob
import importlib
import json
import os
import subprocess
import sys
import warnings

import numpy as np
from routines import called, names

FLAGS = ['gcc', '-std=c99', '-O0', '-fPIC', '-ffp-contract=off', '-shared']
DURATION, ROWS = .4, 5


def run_time(root, folder):
    """the C that all modules have in common, made once"""
    target, home = os.path.join(folder, 'libmodules.so'), os.path.join(root, 'share')
    if not os.path.exists(target):
        sources = glob.glob(home + '/engine/core/**/*.c', recursive=True)
        for part in ('', 'run/', 'implicit/', 'derivatives/', 'ensemble/', 'lanes/'):
            sources += glob.glob(home + '/engine/host/' + part + '*.c')
        folders = ['-I' + home + place for place in ('/engine/core', '/engine', '/python/c')]
        subprocess.run(FLAGS + ['-o', target] + folders + sources, check=True)
    return target


def built(root, folder, name):
    """the module, from its folder"""
    home = os.path.join(folder, name + '_module')
    sys.path[:0] = [os.path.join(home, 'src'), os.path.join(root, 'share', 'python')]
    render = importlib.import_module('render')
    table = os.path.join(home, 'src', name, 'table.json')
    with open(table) as f:
        render.write(os.path.join(home, 'loops.c'), render.loops(json.load(f)))
    c = os.path.join(home, 'c')
    target = os.path.join(home, 'src', name, '_scene.so')
    sources = [os.path.join(home, 'loops.c'), *glob.glob(os.path.join(c, 'scene', '*.c')),
               *glob.glob(os.path.join(c, '*.c'))]   # what asks for the scene
    subprocess.run(FLAGS + ['-o', target, '-I' + c, '-I' + c + '/scene'] + sources + [
        os.path.join(folder, 'libmodules.so'), '-Wl,-rpath,' + folder, '-lm'], check=True)
    return importlib.import_module(name)


def of_module(root, folder, calls, codes, states, told):
    """{what: error} of the modules of the first call and of the last one"""
    one, two = (built(root, folder, c.scene.name) for c in calls)
    worst = {}
    for t, x, v in states:
        given = {'t': t, 'x': list(x.values()), 'v': list(v.values())}
        values(worst, one, one.Model(), codes[0], given)
    models = one.Model(), two.Model(**told.values())
    for t, x, v in states[:2]:
        runs(worst, models, codes, told, t, x, v)
    return worst


def values(worst, module, model, code, given):
    """every routine that only takes time, state and inputs"""
    for row in code.js['subroutines']:
        word = row['name'].lower()[len(code.prefix):]
        takes = [a for a in of_kind(row, ('in',)) if a != 'CST' and a[:2] != 'LD']
        if not hasattr(model, word) or not set(takes) <= {'T', 'X', 'V'} or 'X' not in takes:
            continue
        wanted = called(code, word, {a.upper(): b for a, b in given.items()})
        found, info = asked(module, model, word, {a.lower(): given[a.lower()] for a in takes})
        keys = [a for a in of_kind(row, ('out', 'inout')) if a != 'INFO']
        for key, value in zip(keys, found):
            a, b = np.asarray(value, float), wanted[key]
            error = np.max(np.abs(a - b), initial=0)/max(1., np.max(np.abs(b), initial=0))
            what = 'C ' + word.upper()
            worst[what] = max(worst.get(what, 0.), error if error == error else np.inf)


def of_kind(row, kinds):
    """arguments that are read, or written"""
    return [a for a, s in zip(row['arguments'], row['shapes'])
            if s.split('(')[0].split()[-1] in kinds]


def asked(module, model, word, arguments):
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        try:
            found, info = getattr(model, word)(**arguments), 0
        except module.Error as error:
            found, info = error.results, error.info
    return found if isinstance(found, tuple) else (found,), info


def runs(worst, models, codes, told, t, x, v):
    """both from one state on"""
    v = {n: 0. if n.endswith('.mode') else a for n, a in v.items()}  # a run finds them itself
    times = np.linspace(t, t + DURATION, ROWS)
    new, other = told.forth(x), {told.renamed(n): a for n, a in v.items()}
    starts = [(list(x.values()), list(v.values())),
              ([new[n] for n in names(codes[1], 'states')],
               [other[n] for n in names(codes[1], 'inputs')])]
    done = [run(m, times, *s) for m, s in zip(models, starts)]
    failed = [r for r in done if isinstance(r, str)]
    if failed:
        worst['runs that fail ' + failed[0]] = 0. if len(failed) == 2 else np.inf
        return
    one, two = (r.x.T for r in done)
    rows = min(len(one), len(two))
    wanted = [told.forth(dict(zip(names(codes[0], 'states'), row))) for row in one[:rows]]
    wanted = np.array([[w[n] for n in names(codes[1], 'states')] for w in wanted])
    error = np.max(np.abs(two[:rows] - wanted)/np.maximum(1., np.abs(wanted)), initial=0)
    worst['run'] = max(worst.get('run', 0.), error if len(one) == len(two) else np.inf)


def run(model, times, x, v):
    """what comes of it, or why there is nothing"""
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        try:
            return model.simulate(x, times, input=v, rtol=1e-11, start='project')
        except Exception as error:
            return '%s %s' % (type(error).__name__, str(error)[:60])
