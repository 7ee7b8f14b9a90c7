"""The structures of host/collocation/collocation.h, by which an optimal motion goes to the engine
and comes back."""
import ctypes

import numpy as np

from ._library import LIBRARY, NAME
from ._structures import _AT, _INT, _REAL, _Structure, _TEXT


class Problem(_Structure):
    """gs_motion_problem."""

    _fields_ = [*((name, _AT) for name in ('cst', 'par', 'x0', 'xf', 'last_low', 'last_high')),
                ('t0', _REAL), ('duration', _REAL * 2),
                *((name, _AT) for name in ('low', 'high', 'unknown_low', 'unknown_high')),
                ('nbounded', _INT),
                *((name, _AT) for name in ('bounded', 'output_low', 'output_high')),
                ('time_weight', _REAL),
                *((name, _AT) for name in ('output_weights', 'final_states', 'final_outputs',
                                           'linear')),
                ('nproducts', _INT), ('products', _AT), ('narcs', _INT),
                *((name, _AT) for name in ('arcs', 'inputs', 'outputs', 'held'))]

    def put_texts(self, name, texts):
        self.keep(name, (_TEXT * (len(texts) + 1))(*[text.encode() for text in texts]))


class Guess(_Structure):
    """gs_motion_guess."""

    _fields_ = [('n', _INT), ('t', _AT), ('x', _AT), ('v', _AT), ('duration', _REAL),
                ('start', _AT), ('nactuated', _INT), ('actuated', _AT)]


class Options(_Structure):
    """gs_motion_options."""

    RADAU, LOBATTO = range(2)
    _fields_ = [('method', _INT), ('intervals', _INT), ('accuracy', _REAL),
                ('refinements', _INT), ('polish', _INT), ('regularize', _REAL),
                ('tolerance', _REAL), ('seconds', _REAL), ('iterations', _INT),
                ('timeout', _REAL), ('solver', _AT), ('ask', _AT), ('asked', _AT)]


class Product(ctypes.Structure):
    """gs_cost_product."""

    _fields_ = [('a', _INT), ('b', _INT), ('weight', _REAL)]


class Bound(ctypes.Structure):
    """gs_active_bound."""

    STATE, INPUT, OUTPUT, TIME, PARAMETER = range(5)
    _fields_ = [('of', _INT), ('number', _INT), ('largest', _INT),
                *((name, _REAL) for name in ('value', 'from', 'until', 'multiplier'))]


class Arc(ctypes.Structure):
    """gs_singular_arc."""

    _fields_ = [('input', _INT), ('held', _INT),
                *((name, _REAL) for name in ('from', 'until', 'ringing', 'weight'))]


class Mesh(ctypes.Structure):
    """gs_mesh_report."""

    _fields_ = [('intervals', _INT), ('iterations', _INT), ('error', _REAL),
                ('ended', ctypes.c_char * 200)]


class Motion(_Structure):
    """gs_motion."""

    _fields_ = [('solved', _INT), ('stopped', _INT), ('ended', ctypes.c_char * 2400),
                ('goal', _REAL), ('duration', _REAL), ('error', _REAL), ('n', _INT),
                *((name, _AT) for name in ('t', 'x', 'v', 'ud', 'lambda', 'y', 'costates',
                                           'unknown')),
                ('pieces', _INT), ('breaks', _AT), ('input', _AT), ('nplanned', _INT),
                ('planned', _AT), ('motion', _AT),
                *((name, _INT) for name in ('nmeshes', 'nactive', 'nswitches', 'narcs')),
                *((name, _AT) for name in ('meshes', 'active', 'switches', 'arcs', 'room'))]

    def array(self, name, *shape):
        """A copy of the numbers of this shape, by columns."""
        n = int(np.prod(shape))
        if n == 0:
            return np.zeros(shape)
        room = (ctypes.c_double * n).from_address(getattr(self, name))
        return np.frombuffer(room).reshape(shape, order='F').copy(order='F')

    def rows(self, name, many, kind):
        """A list of structures."""
        return list((kind * many).from_address(getattr(self, name))) if many else []


for _k, _kind in enumerate((Problem, Guess, Options, Motion, Product, Bound, Arc, Mesh)):
    if LIBRARY.gs_loop_motion_size(ctypes.c_int(_k)) != ctypes.sizeof(_kind):
        raise ImportError('%s: the library was built with another collocation.h' % NAME)
