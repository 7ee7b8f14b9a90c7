"""Calls of emitted routines by the names of their arguments, in Fortran and in a module of
Python."""
import ctypes
import numpy as np


def called(code, word, given):
    """{argument: array} of a routine: what it gives, INFO too. code: emitted.Code"""
    row = next(s for s in code.js['subroutines'] if s['name'].lower() == code.prefix + word)
    shapes = dict(zip(row['arguments'], row['shapes']))
    sizes = {k: extent(code, n) for k, n in zip(row['arguments'], row['sizes'])}
    arrays = {k: argument(code, k, shapes, sizes, given) for k in shapes}
    code.function(word)(*[a.ctypes.data_as(ctypes.c_void_p) for a in arrays.values()])
    return {k: a if k == 'INFO' else cut(a, sizes[k]) for k, a in arrays.items()}


def argument(code, name, shapes, sizes, given):
    """an array for it, which is given or to be filled"""
    kind = np.intc if shapes[name].startswith('integer') else float
    led = [a for a, s in shapes.items() if '(%s,' % name in s]
    if led:
        return np.array(max(1, sizes[led[0]][0]), np.intc)
    if name == 'CST':
        return code.cst
    if name in given:
        return np.array(given[name], kind) if np.size(given[name]) else np.zeros(1, kind)
    return np.zeros([max(1, n) for n in sizes[name]], kind, order='F')


def extent(code, size):
    return [code.d[n] if isinstance(n, str) else n for n in size]


def cut(a, size):
    """without the elements that stand there because an array has one at least"""
    return a[tuple(slice(0, n) for n in size)] if size and a.ndim == len(size) else a


def names(code, key):
    return [x['name'] for x in code.js[key]]


def named(code, key, values):
    return dict(zip(names(code, key), np.ravel(values)))
