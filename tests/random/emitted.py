"""The emitted Fortran, compiled and called."""
import ctypes
import glob
import os
import subprocess
import numpy as np

FLAGS = ['-O0', '-fPIC', '-frecursive', '-w']


def run_time(root, folder, optimized='-O1'):
    """the library of share/fortran as one shared object, made where it is older than its sources"""
    target = os.path.join(folder, 'libgs.so')
    sources = [f for folder in ('*', 'solve/lapack')
               for f in glob.glob('%s/share/fortran/%s/*.f' % (root, folder))]
    newest = max(os.path.getmtime(f) for f in sources)
    if not os.path.exists(target) or os.path.getmtime(target) < newest:
        new = '%s.%d' % (target, os.getpid())
        subprocess.run(['gfortran', optimized] + FLAGS[1:] + ['-shared', '-o', new] + sources +
                       ['-llapack', '-lblas'],
                       check=True)
        os.replace(new, target)
    return target


def compiled(folder, name, library):
    """the shared object of a scene, and what gfortran said"""
    out = os.path.join(folder, name + '.so')
    r = subprocess.run(['gfortran'] + FLAGS + [
        '-shared', '-o', out,
        os.path.join(folder, name + '.f'), library, '-Wl,-rpath,' + os.path.dirname(library)
    ],
                       capture_output=True,
                       text=True)
    return (out, '') if r.returncode == 0 else (None, r.stderr[-300:])


def zeros(*shape):
    return np.zeros([max(1, n) for n in shape], order='F')


class Code:
    """the subroutines of a scene; description: its JSON"""

    def __init__(self, path, description, values):
        self.lib, self.js, self.d = ctypes.CDLL(path), description, description['dimensions']
        self.prefix = description['name'].lower() + '_'
        self.routines = {s['name'].lower()[len(self.prefix):] for s in description['subroutines']}
        self.names = [p['name'] for p in description['parameters']]
        self.par, self.cst = zeros(self.d['npar']), zeros(self.d['ncst'])
        self.function('par')(self.par.ctypes)
        self.set(values)

    def function(self, word):
        return getattr(self.lib, self.prefix + word + '_')

    def set(self, values):
        for k, v in values.items():
            if k in self.names:
                self.par[self.names.index(k)] = v
        info = ctypes.c_int(99)
        self.function('pre')(self.par.ctypes, self.cst.ctypes, ctypes.byref(info))
        self.info = info.value

    def has(self, word):
        return word in self.routines

    def call(self, word, *args):
        """args: arrays, numbers; an INFO comes last or is left out; returns INFO"""
        kept, info = [], None
        for a in args:
            if isinstance(a, np.ndarray):
                kept.append(a.ctypes)
            elif isinstance(a, float):
                kept.append(ctypes.byref(ctypes.c_double(a)))
            else:
                info = ctypes.c_int(a)
                kept.append(ctypes.byref(info))
        self.function(word)(*kept)
        return info.value if info is not None else 0

    def call_jac(self, t, x, v, A, B, C, D):
        info, c = ctypes.c_int(99), ctypes.c_double(t)
        sizes = [ctypes.c_int(a.shape[0]) for a in (A, B, C, D)]
        arrays = [p for a, n in zip((A, B, C, D), sizes) for p in (a.ctypes, ctypes.byref(n))]
        self.function('jac')(ctypes.byref(c), x.ctypes, v.ctypes, self.cst.ctypes, *arrays,
                             ctypes.byref(info))
        return info.value
