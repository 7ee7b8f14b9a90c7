"""Every subroutine of a module against the Fortran of the scene, which the same table describes,
and one state against many: python3 against_fortran.py MODULE FORTRAN.so"""
import ctypes
import importlib
import sys
import warnings

import numpy as np

warnings.simplefilter('ignore')
np.seterr(all='ignore')

name, library = sys.argv[1:3]
scene = importlib.import_module(name)
fortran = ctypes.CDLL(library)
model = scene.Model()
random = np.random.default_rng(20240229)
MODES = [i for i, name in enumerate(model.inputs) if name.endswith('.mode')]


def sizes_of(row, k):
    return [model.sizes[s] if isinstance(s, str) else s for s in row['sizes'][k]]


def value(argument, shape, whole):
    """Numbers for an argument: states and coordinates close to the start."""
    n = int(np.prod(shape, dtype=int))
    start = model.initial
    if whole:
        return np.zeros(shape, np.intc) if argument == 'MODE' else np.ones(shape, np.intc)
    x = 0.1 * random.standard_normal(n)
    if argument in ('X', 'Q', 'QJ'):
        m = min(n, model.sizes['nq'] if argument == 'QJ' else len(start))
        scale = np.append(model.nominal, [1.0, 1.0])[:n] if argument == 'X' else 1.0
        x[:len(x)] *= np.resize(scale, n)
        x[:m] += start[:m]
    if argument == 'V':
        x[MODES] = random.integers(-1, 2, len(MODES))
    return x.reshape(shape, order='F')


def by_fortran(row, given):
    """The results of the Fortran, by the names of the arguments."""
    arrays, leading = {}, {}
    for shape, size in zip(row['shapes'], row['sizes']):
        if ',*)' in shape:
            leading[shape[shape.index('(') + 1:shape.index(',')]] = max(1, size[0])
    for k, (argument, shape) in enumerate(zip(row['arguments'], row['shapes'])):
        kind = np.intc if shape.startswith('integer') else np.float64
        if argument == 'CST':
            arrays[argument] = model.cst.copy()
        elif argument in leading:
            arrays[argument] = np.array(leading[argument], np.intc)
        elif argument in given:
            arrays[argument] = np.array(given[argument], kind, order='F', copy=True)
        else:
            arrays[argument] = np.zeros(sizes_of(row, k), kind, order='F')
        if arrays[argument].size == 0:
            arrays[argument] = np.zeros(1, kind)
    call = getattr(fortran, row['name'].lower() + '_')
    call(*[ctypes.c_void_p(a.__array_interface__['data'][0]) for a in arrays.values()])
    return arrays


def check(short, row):
    given = {}
    for k, (argument, shape) in enumerate(zip(row['arguments'], row['shapes'])):
        intent = shape.split('(')[0].split()[-1]
        leading = any('(%s,' % argument in s for s in row['shapes'])
        if intent in ('in', 'inout') and argument != 'CST' and not leading:
            given[argument] = value(argument, sizes_of(row, k), shape.startswith('integer'))
    wanted = by_fortran(row, given)
    arguments = {a.lower(): v for a, v in given.items()}
    try:
        found = getattr(model, short)(**arguments)
        info = 0
    except scene.Error as error:
        found, info = error.results, error.info
    found = found if isinstance(found, tuple) else (found,)
    results = [a for a, s in zip(row['arguments'], row['shapes'])
               if s.split('(')[0].split()[-1] in ('out', 'inout') and a != 'INFO']
    off = 0.0
    for argument, got in zip(results, found):
        w = wanted[argument].ravel(order='F')[:np.size(got)]
        g = np.ravel(got, order='F')
        if info < 0:
            continue
        most = np.abs(w).max(initial=0)
        off = max(off, np.abs(g - w).max(initial=0) / (most or 1.0))
    told = int(wanted['INFO']) if 'INFO' in wanted else 0
    good = off <= 1e-14 and (info == told or told in (2, 3))
    print('%sok %s.%s as the Fortran: %.1e, INFO = %d, %d' % (
        '' if good else 'not ', name, short, off, info, told))
    return many(short, row, arguments)


def many(short, row, arguments):
    """Several states at once, in three orders of storage, give what each gives by itself."""
    routine = getattr(model, short)
    k = 21   # more than are brought side by side at once
    spread = {}
    for argument, v in arguments.items():
        whole = v.dtype == np.intc
        spread[argument] = np.stack([v if whole else v * (1 + 1e-3 * j) for j in range(k)], axis=-1)
    if 'v' in spread:
        spread['v'][MODES] = np.arange(k) % 3 - 1
    try:
        each = [routine(**{a: v[..., j] for a, v in spread.items()}) for j in range(k)]
        orders = [routine(**spread),
                  routine(**{a: np.asfortranarray(v) for a, v in spread.items()}),
                  routine(**{a: np.concatenate([v, v], axis=-1)[..., ::2][..., :19]
                             for a, v in spread.items()})]
    except scene.Error:
        return
    good = True
    for result in orders:
        for i, part in enumerate(result if isinstance(result, tuple) else (result,)):
            for j in range(part.shape[-1]):
                one = each[2 * j % k if part.shape[-1] == 19 else j]
                one = one[i] if isinstance(one, tuple) else one
                good = good and np.array_equal(part[..., j], one, equal_nan=True)
    if spread:
        print('%sok %s.%s of many states' % ('' if good else 'not ', name, short))


for one in scene.table['subroutines']:
    word = one['name'][len(scene.table['name']) + 1:].lower()
    if word not in ('par', 'pre', 'chk', 'ini') and not word.endswith(('_v', '_w')):
        check(word, one)
