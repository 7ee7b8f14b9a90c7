"""The structures of host/run/run.h, host/linear/linear.h and host/assemble/assemble.h, by which
what is asked for goes to the engine and what is found comes back."""
import ctypes

import numpy as np

from ._library import LIBRARY, NAME, address
from ._tables import COUNTS, VALUES

_INT, _REAL, _TEXT, _AT = ctypes.c_int, ctypes.c_double, ctypes.c_char_p, ctypes.c_void_p


class _Structure(ctypes.Structure):
    """One whose arrays live as long as it does."""

    def __init__(self, **fields):
        super().__init__(**fields)
        self.kept = {}

    def address(self):
        return ctypes.byref(self)

    def keep(self, name, value):
        """A function or an array of ctypes as a member."""
        self.kept[name] = value
        setattr(self, name, ctypes.cast(value, _AT))

    def put_texts(self, name, texts):
        self.keep(name, (_TEXT * (len(texts) + 1))(*[text.encode() for text in texts]))

    def put(self, name, numbers, kind=float):
        """An array, by columns; None: a null pointer."""
        if numbers is not None:
            self.kept[name] = np.ascontiguousarray(
                np.asarray(numbers, kind).ravel(order='F'), kind)
            setattr(self, name, address(self.kept[name]))


class _Pieces(ctypes.Structure):
    _fields_ = [('nc', _INT), ('np', _INT), ('k', _INT), ('numbers', _AT)]


class Options(_Structure):
    """gs_run_options."""

    _fields_ = [('method', _TEXT), ('loops', _TEXT), ('step', _REAL), ('rtol', _REAL),
                ('atol', _AT), ('maxstep', _REAL), ('maxsteps', _REAL), ('maxorder', _REAL),
                ('drift', _INT), ('project', _INT), ('samples', _INT), ('audit', _REAL),
                ('ncolumns', _INT), ('columns', _AT), ('names', _AT), ('sizes', _AT), ('dx0', _AT),
                ('fixed', _AT), ('changes', _AT), ('cvode', _AT), ('ask', _AT), ('asked', _AT)]


class Start(_Structure):
    """gs_run_start."""

    _fields_ = [('nt', _INT), *((name, _AT) for name in (
        'times', 'x0', 'par', 'cst', 'modes', 'memory'))]


class Inputs(_Structure):
    """gs_run_inputs."""

    _fields_ = [('kind', _INT), ('constants', _AT), ('table', _Pieces), ('motion', _Pieces),
                ('planned', _AT), ('reference', _Pieces), ('gain', _Pieces), ('limits', _AT),
                ('function', _AT), ('data', _AT), ('nbreaks', _INT), ('breaks', _AT)]

    def put_pieces(self, name, poly):
        self.kept[name] = poly.flat()
        setattr(self, name, _Pieces(*poly.coefficients.shape, address(self.kept[name])))


class _Table(ctypes.Structure):
    _fields_ = [('x', _AT), ('row', ctypes.c_ssize_t), ('column', ctypes.c_ssize_t)]


class Rows(_Structure):
    """gs_rows of host/ensemble/ensemble.h."""

    _fields_ = [('n', _INT), ('par', _AT), ('varied', _INT), ('which', _AT), ('table', _Table),
                ('starts', _Table), ('inputs', _Table), ('broken', _AT)]

    def put_table(self, name, numbers):
        """An array with a row for each run; None: nothing differs."""
        if numbers is not None and numbers.size:
            self.kept[name] = np.ascontiguousarray(numbers, float)
            setattr(self, name, _Table(address(self.kept[name]), numbers.shape[1], 1))


class Results(_Structure):
    """gs_results of the same."""

    _fields_ = [(name, _AT) for name in (
        'x', 'v', 'y', 'counts', 'values', 'info', 'counted', 'margins', 'events', 'nevents',
        'reason')] + [('no_memory', _INT)]


class Taken(_Structure):
    """gs_start."""

    _fields_ = [('verdict', _INT), ('residual', _REAL), ('moved', _REAL), ('state', _INT),
                ('row', ctypes.c_char * 300), ('text', ctypes.c_char * 2400)]


class Result(_Structure):
    """gs_run_result; refused: 0, or as below."""

    OPTION, ROUTINE, START, MODE, SAMPLES, COLUMNS = range(1, 7)
    _fields_ = [('refused', _INT), ('info', _INT), ('option', _TEXT),
                ('text', ctypes.c_char * 2400), ('warning', ctypes.c_char * 400),
                ('start', Taken), ('method', _TEXT),
                *((name, _INT) for name in ('ended', 'nx', 'nt', 'ldv', 'rows')),
                ('rtol', _REAL), *((name, _AT) for name in ('atol', 'times', 'x', 'v', 'y', 'cst')),
                ('loop_method', _INT), ('in_lanes', _INT), ('dv', _AT), ('dy', _AT),
                ('istat', _INT * len(COUNTS)), ('rstat', _REAL * len(VALUES)),
                *((name, _AT) for name in ('ip', 'rp', 'derivatives', 'room'))]

    def pointer(self, name):
        return ctypes.c_void_p(getattr(self, name))

    def array(self, name, shape, first=0):
        """A copy of the numbers of this shape, by columns, from the one of index FIRST on."""
        n = int(np.prod(shape))
        if n == 0:
            return np.zeros(shape)
        room = (ctypes.c_double * n).from_address(getattr(self, name) + 8 * first)
        return np.frombuffer(room).reshape(shape, order='F').copy(order='F')

    def statistics(self):
        return dict(zip(COUNTS + VALUES, [*self.istat, *self.rstat]))


class Place(_Structure):
    """gs_linear_place of host/linear/linear.h."""

    _fields_ = [('t', _REAL), *((name, _AT) for name in (
        'cst', 'x', 'v', 'inputs', 'units', 'constraints'))]


class Asked(_Structure):
    """gs_linear_asked of the same."""

    NAMED, AUTO, NONE = range(3)
    _fields_ = [('reduced', _INT), ('nwanted', _INT), ('wanted', _AT), ('running', _INT),
                ('ndrop', _INT), ('drop', _AT)]


class Linear(_Structure):
    """gs_linear_model of the same."""

    _fields_ = [('n', _INT), ('m', _INT), ('ndropped', _INT), *((name, _AT) for name in (
        'independent', 'dropped', 'seen', 'a', 'b', 'c', 'd', 'tangent')),
                ('row', _INT), ('column', _INT)]


class Told(_Structure):
    """gs_linear_told of the same."""

    FOUND, NO_MEMORY, ABSENT, FAILED, DERIVATIVE, MARGIN, REFUSED = range(7)
    _fields_ = [('verdict', _INT), ('info', _INT), ('routine', _TEXT),
                ('text', ctypes.c_char * 2400)]


class TrimAsked(_Structure):
    """gs_trim_asked of the same."""

    _fields_ = [('nhold', _INT), ('ninputs', _INT), ('nspeeds', _INT), ('hold', _AT),
                ('inputs', _AT), ('speeds', _AT), ('steady', _INT), ('nrunning', _INT),
                ('running', _AT), ('nmodes', _INT), ('modes', _AT), ('margins', _INT),
                ('tolerance', _REAL), ('par', _AT)]


class TrimFound(_Structure):
    """gs_trim_found of the same."""

    _fields_ = [('x', _AT), ('v', _AT), ('residual', _REAL), ('way', _INT), ('running', _AT),
                ('indifferent', _AT), ('warning', ctypes.c_char * 400)]


class VibrationsAsked(_Structure):
    """gs_vibrations_asked of the same."""

    _fields_ = [('steady', _INT), ('nheld', _INT), ('held', _AT)]


class Vibrations(_Structure):
    """gs_vibrations of the same."""

    _fields_ = [('n', _INT), ('nfelt', _INT), *((name, _AT) for name in (
        'independent', 'felt', 'x', 'a', 'square', 'tangent')), ('doubt', ctypes.c_char * 300)]


class Modes(_Structure):
    """gs_modes of the same."""

    _fields_ = [('n', _INT), ('nreal', _INT), ('rigid', _INT), *((name, _AT) for name in (
        'eigenvalues', 'frequency', 'damping', 'shapes', 'real'))]


class ModesOfSpeeds(_Structure):
    """gs_campbell of the same."""

    _fields_ = [('rows', _INT), ('nspeeds', _INT), ('total', _INT), *((name, _AT) for name in (
        'many', 'frequency', 'shapes'))]


class SlopesAsked(_Structure):
    """gs_slopes_asked of the same."""

    _fields_ = [('nhold', _INT), ('ninputs', _INT), ('hold', _AT), ('inputs', _AT),
                ('names', _AT)]


class RestSlopes(_Structure):
    """gs_rest_slopes of the same."""

    _fields_ = [('outputs', _INT), ('dx', _AT), ('dv', _AT), ('dy', _AT)]


class PoleSlopes(_Structure):
    """gs_pole_slopes of the same."""

    _fields_ = [('poles', _AT), ('frequency', _AT), ('damping', _AT)]


class PlannedAsked(_Structure):
    """gs_planned_asked of host/planned.h."""

    _fields_ = [('cst', _AT), ('side', _INT), ('order', _INT), ('nplanned', _INT),
                ('planned', _AT), ('pieces', _INT), ('powers', _INT), ('breaks', _AT),
                ('coefficients', _AT), ('guess', _AT), ('devices', _AT), ('carry', _INT),
                ('n', _INT), ('t', _AT)]


class Planned(_Structure):
    """gs_planned_found of the same."""

    _fields_ = [('qj', _AT), ('devices', _AT), ('done', _INT), ('text', ctypes.c_char * 1000)]


class AssemblyAsked(_Structure):
    """gs_assembly_asked of host/assemble/assemble.h."""

    _fields_ = [('t', _REAL), ('cst', _AT), ('held', _AT), ('branches', _INT), ('longest', _REAL),
                ('tolerance', _REAL), ('settle', _INT), ('rank', _INT), ('limits', _AT)]


class Assembly(_Structure):
    """gs_assembly of the same."""

    _fields_ = [('n', _INT), ('text', ctypes.c_char * 2400), ('beyond', ctypes.c_char * 800),
                ('lost', ctypes.c_char * 1200)]


for _k, _kind in enumerate((Options, Start, Inputs, Result, PlannedAsked, Planned)):
    if LIBRARY.gs_loop_size(ctypes.c_int(_k)) != ctypes.sizeof(_kind):
        raise ImportError('%s: the library was built with another run.h' % NAME)
for _k, _kind in enumerate((Rows, Results)):
    if LIBRARY.gs_loop_rows_size(ctypes.c_int(_k)) != ctypes.sizeof(_kind):
        raise ImportError('%s: the library was built with another ensemble.h' % NAME)
for _k, _kind in enumerate((AssemblyAsked, Assembly)):
    if LIBRARY.gs_loop_assembly_size(ctypes.c_int(_k)) != ctypes.sizeof(_kind):
        raise ImportError('%s: the library was built with another assemble.h' % NAME)
for _k, _kind in enumerate((Place, Asked, Linear, Told, Taken, TrimAsked, TrimFound,
                             VibrationsAsked, Vibrations, Modes, ModesOfSpeeds, SlopesAsked,
                             RestSlopes, PoleSlopes)):
    if LIBRARY.gs_loop_linear_size(ctypes.c_int(_k)) != ctypes.sizeof(_kind):
        raise ImportError('%s: the library was built with another linear.h' % NAME)
