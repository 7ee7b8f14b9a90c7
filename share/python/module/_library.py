"""The compiled scene: the library, and its subroutines as Python calls them."""
import collections
import ctypes
import json
import keyword
import os
import warnings

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))

with open(os.path.join(HERE, 'table.json'), encoding='utf-8') as _file:
    TABLE = json.load(_file)
NAME = TABLE['name']
SIZES = TABLE['dimensions']


class Error(ArithmeticError):
    """A subroutine has found that what it was asked for cannot be computed.

    info: its number, for many states an array of them; results: what it gave all the same.
    """

    def __init__(self, text, info=None, results=None):
        super().__init__(text)
        self.info = info
        self.results = results


class DependentWarning(RuntimeWarning):
    """The results are given, but INFO is not 0: dependent constraints, a singularity of angles."""


def _loaded():
    path = os.path.join(HERE, '_scene.so')
    if not os.path.exists(path):
        raise ImportError('%s is not built: python3 -m pip install the folder that holds it' % NAME)
    return ctypes.CDLL(path)


LIBRARY = _loaded()
LIBRARY.gs_loop_scene.restype = ctypes.c_void_p
LIBRARY.gs_instants.restype = ctypes.c_double
LIBRARY.gs_loop_table.restype = LIBRARY.gs_loop_meaning.restype = ctypes.c_char_p
SCENE = ctypes.c_void_p(LIBRARY.gs_loop_scene())


def address(array):
    return array.__array_interface__['data'][0]


def at(array, skip=0):
    """Its numbers from the one of this index on, as the run time takes them."""
    return ctypes.c_void_p(address(array) + 8 * skip)


def pointer(name):
    """A subroutine as an address, for the run time."""
    return ctypes.cast(getattr(LIBRARY, '%s_%s' % (NAME.lower(), name)), ctypes.c_void_p)


def python_name(name):
    return name + '_' if keyword.iskeyword(name) else name


MODES = [event['input'] - 1 for event in TABLE.get('events') or []   # places in v
         if event['input'] > 0]
# inputs where nothing else is said; a mode has to be said
NO_INPUTS = {'v': np.zeros(SIZES['nv'])} if MODES else {}
SAME_IN_ALL_MODES = ('ene', 'evt', 'hld', 'mar', 'rst')
# whole numbers that the subroutine does not check itself
RANGES = {'mode': (-1, 1), 'ctl.k': (0, SIZES['nctl'])}


# rows of coordinates that are Euler parameters
SETS = np.array(TABLE.get('orientation') or [], int).reshape(-1, 4) - 1


class Argument:
    """An argument that Python hands over: its name, kind, intent and sizes for one state."""

    def __init__(self, routine, name, shape, sizes, meaning):
        kind, _, rest = shape.rpartition(' ')
        self.name = python_name(name.lower())
        self.whole = kind == 'integer'
        self.type = np.dtype(np.intc if self.whole else np.float64)
        self.intent = rest.partition('(')[0]
        self.sizes = tuple(sizes)
        self.meaning = meaning
        self.given = self.intent in ('in', 'inout')
        self.result = self.intent in ('out', 'inout')
        self.optional = self.name == 'v' and self.intent == 'in'
        full = routine + '.' + self.name
        self.range = RANGES.get(self.name, RANGES.get(full, (-2**31, 2**31 - 1)))

    def text(self):
        shape = 'a number' if not self.sizes else 'shape (%s)' % ', '.join(map(str, self.sizes))
        return '%s: %s, %s' % (self.name, shape, self.meaning)

    def refuse(self, who, found):
        sizes = ', '.join(map(str, self.sizes))
        raise ValueError('%s: argument %s: expected the shape (%s), or (%s) for k states; found %s'
                         % (who, self.name, sizes, ', '.join(filter(None, (sizes, 'k'))), found))

    def array(self, who, value):
        """The value as an array of the right type and number of dimensions, read in place."""
        try:
            a = given = np.asarray(value)
            if a.dtype != self.type:
                a = a.astype(self.type, casting='same_kind' if a.dtype.kind != 'i' else 'unsafe')
        except (TypeError, ValueError):
            raise TypeError('%s: argument %s: expected %s numbers; found %s' % (
                who, self.name, 'whole' if self.whole else 'real',
                value.dtype if isinstance(value, np.ndarray) else repr(value)[:60])) from None
        if self.whole and a.size:
            self.within(who, given)
        n = len(self.sizes)
        if a.shape[:n] != self.sizes or a.ndim > n + 1:
            self.refuse(who, a.shape)
        if self.name == 't' and not np.isfinite(a).all():
            raise ValueError('%s: argument t: expected finite times [s]; found %s' % (
                who, np.array2string(a, threshold=6)))
        if MODES and self.name == 'v':
            self.modes(who, a)
        if SETS.size and self.name in ('q', 'x'):
            self.orientations(who, a)
        if n > 1 or not a.flags.aligned:
            a = np.asfortranarray(a)
        return a

    def within(self, who, a):
        """Whole numbers in their range."""
        for k in (a.min(), a.max()):
            if not self.range[0] <= k <= self.range[1]:
                raise ValueError('%s: argument %s: expected whole numbers from %d to %d; found %d'
                                 % (who, self.name, *self.range, k))

    def orientations(self, who, a):
        """Euler parameters that are all zero are no orientation."""
        for rows in SETS:
            if not np.any(a[rows] != 0, axis=0).all():
                raise ValueError('%s: argument %s: expected Euler parameters of length 1 in %s; '
                                 'found zeros, which are no orientation' % (
                                     who, self.name, ', '.join(
                                         '%s[%d]' % (self.name, k) for k in rows)))

    def modes(self, who, v):
        """The modes among the inputs; what is no number is the matter of the subroutine."""
        for k in MODES:
            mode = np.atleast_1d(v[k])
            wrong = mode[~(np.isin(mode, (-1, 0, 1)) | np.isnan(mode))]
            if wrong.size:
                raise ValueError('%s: argument v: %s: expected -1, 0 or 1; found %g' % (
                    who, TABLE['inputs'][k]['name'], wrong[0]))


class Routine:
    """A subroutine of the scene.

    Called for one state, or for k states where an argument has one more dimension of the size k at
    its end; arguments without it hold for all of them. Arrays of any order are read as they lie.
    """

    def __init__(self, row):
        self.name = row['name'][len(NAME) + 1:].lower()
        self.purpose = row['purpose']
        self.codes = {i['code']: i for i in row['info']}
        self.checked = 'INFO' in row['arguments']
        leading = {s[s.index('(') + 1:s.index(',')] for s in row['shapes'] if ',*)' in s}
        self.arguments = [
            Argument(self.name, *one) for one in zip(row['arguments'], row['shapes'], row['sizes'],
                                          row['meanings'])
            if one[0] not in ('CST', 'INFO') and one[0] not in leading]
        given = [a for a in self.arguments if a.given]
        self.given = [a for a in given if not a.optional] + [a for a in given if a.optional]
        self.results = [a for a in self.arguments if a.result]
        self.kind = collections.namedtuple(
            self.name.upper() + '_results', [a.name for a in self.results], rename=True)
        self.call = getattr(LIBRARY, '%s_%s_k' % (NAME.lower(), self.name))
        self.call.restype = ctypes.c_ssize_t
        self.call.argtypes = [ctypes.c_ssize_t] + [ctypes.c_void_p] * 5
        self.parts, self.size = [], 1   # of all arguments for one state, side by side
        for a in self.arguments:
            n = int(np.prod(a.sizes, dtype=int))
            self.parts.append((a, self.size, n))
            self.size += n
        self.frame = np.array([[8 * o for _, o, _ in self.parts],
                               [a.type.itemsize for a in self.arguments],
                               [0] * len(self.parts)], np.intp)
        self.nothing = {a.name: np.zeros(a.sizes, a.type) for a in self.arguments}

    def documentation(self):
        return '\n\n'.join([
            '%s(%s)' % (self.name, ', '.join(a.name for a in self.given)), self.purpose,
            '\n'.join(a.text() for a in self.given),
            'Results:\n' + '\n'.join(a.text() for a in self.results),
            'Arguments may have one more dimension, of k states, at their end.'])

    def __call__(self, model, *values, **named):
        who = '%s.%s' % (NAME, self.name)
        arrays = self.arrays(who, values, named)
        k = self.states(who, arrays)
        table, results = self.single(arrays) if k is None else self.many(arrays, k)
        info = np.zeros(1 if k is None else k, np.intc)
        start, width = address(table), table.strides[0]
        bad = self.call(len(info), start, start + width, start + 2 * width, address(model.cst),
                        address(info))
        out = self.kind(*[r if r.ndim else r[()] for r in results])
        if bad:
            self.tell(who, info, k is not None, bad, out)
        return out if len(out) != 1 else out[0]

    def single(self, arrays):
        """Where the arguments of one state lie (see many), and the results: in one new array."""
        flat = np.empty(self.size)
        wholes = flat.view(np.intc)
        results = []
        for a, o, n in self.parts:
            part = wholes[2 * o:2 * o + n] if a.whole else flat[o:o + n]
            if a.given:
                part[...] = arrays[a.name].ravel(order='F')
            if a.result:
                results.append(part.reshape(a.sizes, order='F'))
        table = self.frame.copy()
        table[0] += address(flat)
        return table, results

    def many(self, arrays, k):
        """Where arrays begin, how far apart their entries and their states lie, in bytes; the
        results."""
        first, entry, state, results = [], [], [], []
        for a in self.arguments:
            array = arrays.get(a.name)
            if a.result:
                array = self.room(a, array, k)
                results.append(array)
            n = len(a.sizes)
            first.append(address(array))
            entry.append(array.strides[0] if n else 0)
            state.append(array.strides[n] if array.ndim > n else 0)
        return np.array([first, entry, state], np.intp), results

    def arrays(self, who, values, named):
        """The given arguments by their names."""
        if len(values) > len(self.given):
            raise TypeError('%s: expected at most %d arguments (%s); found %d' % (
                who, len(self.given), ', '.join(a.name for a in self.given), len(values)))
        found = dict(zip((a.name for a in self.given), values))
        for name in named:
            if name in found or name not in [a.name for a in self.given]:
                raise TypeError('%s: argument %s is %s; expected %s' % (
                    who, name, 'given twice' if name in found else 'unknown',
                    ', '.join(a.name for a in self.given)))
        found.update(named)
        for a in self.given:
            if a.name not in found:
                if a.optional and MODES and self.name not in SAME_IN_ALL_MODES:
                    raise TypeError('%s: argument v is missing: expected the inputs; %s is a mode '
                                    '(-1, 0 or 1) of a device with events' % (
                                        who, TABLE['inputs'][MODES[0]]['name']))
                if not (a.optional or 0 in a.sizes):
                    raise TypeError('%s: argument %s is missing (%s)' % (who, a.name, a.text()))
                found[a.name] = self.nothing[a.name]
        return {a.name: a.array(who, found[a.name]) for a in self.given}

    def states(self, who, arrays):
        """The number of states, None for one without a dimension of its own."""
        k = None
        for a in self.given:
            array = arrays[a.name]
            if array.ndim > len(a.sizes):
                if k is not None and array.shape[-1] != k:
                    raise ValueError('%s: argument %s: expected %d states as before; found %d' % (
                        who, a.name, k, array.shape[-1]))
                k = array.shape[-1]
        return k

    @staticmethod
    def room(a, array, k):
        """Where a result is written: the states one after the other."""
        new = np.empty(a.sizes + (k,), a.type, order='F')
        if array is not None:
            new[...] = array[..., None] if array.ndim == len(a.sizes) else array
        return new

    def tell(self, who, info, many, bad, out):
        code = int(info[bad - 1])
        row = self.codes.get(code, self.codes.get(1) if code > 0 else None)
        place = ' (the first at state %d)' % (bad - 1) if many else ''
        text = '%s: INFO = %d%s: %s' % (who, code, place, row['meaning'] if row else 'failed')
        every = {int(i) for i in info if i}
        if all(self.codes.get(i, {}).get('results') for i in every):
            warnings.warn(text, DependentWarning, stacklevel=4)
        else:
            raise Error(text, info if many else code, out)


class Kept:
    """A call of a subroutine for one state with its arrays kept: the quickest way, of one thread.

    The arguments are attributes, arrays to be filled in place (numbers are arrays without
    dimensions: call.t[...] = 0.5); call() computes and returns INFO. Only the subroutine looks at
    what they hold; it takes a mode as the nearest whole number.
    """

    def __init__(self, routine, model):
        self._table = np.zeros((3, max(1, len(routine.arguments))), np.intp)
        for i, a in enumerate(routine.arguments):
            array = np.zeros(a.sizes, a.type, order='F')
            setattr(self, a.name, array)
            self._table[:, i] = address(array), array.strides[0] if a.sizes else 0, 0
        self._info = np.zeros(1, np.intc)
        start, width = address(self._table), self._table.strides[0]
        self._cst = model.cst
        pack = [ctypes.c_void_p(start + i * width) for i in range(3)]
        self._arguments = (ctypes.c_ssize_t(1), *pack, ctypes.c_void_p(address(self._cst)),
                           ctypes.c_void_p(address(self._info)))
        self._call = routine.call

    def __call__(self):
        return 0 if self._call(*self._arguments) == 0 else int(self._info[0])


ROUTINES = {}
for _row in TABLE['subroutines']:
    if not _row['name'].endswith(('_V', *(NAME.upper() + s for s in (
            '_PAR', '_PRE', '_CHK', '_INI')))):
        _routine = Routine(_row)
        ROUTINES[_routine.name] = _routine
        globals()[_routine.kind.__name__] = _routine.kind   # where pickle looks for it
