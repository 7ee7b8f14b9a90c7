"""The structures of host/optimize/optimize.h, by which a design goes to the engine and comes
back."""
import ctypes

import numpy as np

from ._library import LIBRARY, NAME
from ._structures import _AT, _INT, _REAL, _Structure, _TEXT

LIBRARY.gs_loop_design_words.restype = ctypes.c_char_p
WORDS, SOLVERS, CHOICES = (
    LIBRARY.gs_loop_design_words(ctypes.c_int(k)).decode().split() for k in range(3))


class Free(ctypes.Structure):
    """gs_free."""

    _fields_ = [('name', _TEXT), ('start', _REAL), ('low', _REAL), ('high', _REAL), ('own', _INT),
                ('nlist', _INT), ('list', _AT)]


class Row(ctypes.Structure):
    """gs_design_row."""

    _fields_ = [('word', _INT), ('relation', _INT), ('ncases', _INT), ('factor', _REAL),
                ('bound', _REAL), ('cases', _AT), ('text', _TEXT)]


class Times(ctypes.Structure):
    """gs_case_times."""

    _fields_ = [('nt', _INT), ('t', _AT), ('w', _AT), ('dt', _AT), ('dw', _AT)]


class Series(ctypes.Structure):
    """gs_series."""

    _fields_ = [('n', _INT), ('y', _AT), ('slopes', _AT)]


class Values(ctypes.Structure):
    """gs_design_values."""

    FOUND, FAILED, INTERRUPTED, LATE = range(4)
    _fields_ = [('times', ctypes.POINTER(Times)), ('series', ctypes.POINTER(Series)),
                ('rough', ctypes.POINTER(_INT)), ('functions', _INT),
                ('trouble', ctypes.c_char * 800)]


EVALUATE = ctypes.CFUNCTYPE(_INT, _AT, ctypes.POINTER(_REAL), ctypes.POINTER(_INT),
                            ctypes.POINTER(_INT), ctypes.POINTER(Values))


class Design(_Structure):
    """gs_design."""

    _fields_ = [('name', _TEXT), ('nfree', _INT), ('ngoal', _INT), ('ndemands', _INT),
                ('ncases', _INT), ('free', _AT), ('rows', _AT), ('bands', _AT), ('why', _TEXT),
                ('data', _AT), ('evaluate', _AT)]


class Options(_Structure):
    """gs_design_options."""

    _fields_ = [('solver', _INT), ('choices', _INT), ('nodes', _INT), ('iterations', _INT),
                ('nstarts', _INT), ('starts', _AT), ('tolerance', _REAL), ('evaluations', _REAL),
                ('seconds', _REAL), ('timeout', _REAL), ('ipopt', _AT), ('nlopt', _AT)]


class Active(ctypes.Structure):
    """gs_design_active."""

    _fields_ = [('demand', _INT), ('value', _REAL), ('bound', _REAL), ('multiplier', _REAL),
                ('text', ctypes.c_char * 400)]


class End(ctypes.Structure):
    """gs_design_end."""

    _fields_ = [('values', _AT), ('J', _REAL), ('violation', _REAL), ('solved', _INT),
                ('ended', ctypes.c_char * 400)]


class Found(_Structure):
    """gs_design_result."""

    FOUND, REFUSED, FAILED, STOPPED = range(4)
    _fields_ = [*((name, _INT) for name in ('verdict', 'info', 'stopped', 'solved', 'limit',
                                            'solver', 'evaluations', 'functions', 'iterations')),
                ('J', _REAL), ('violation', _REAL), ('optimality', _REAL),
                *((name, _AT) for name in ('values', 'rough', 'idle')),
                *((name, _INT) for name in ('nactive', 'nends', 'nconflict')),
                *((name, _AT) for name in ('active', 'ends', 'conflict')),
                *((name, _INT) for name in ('branched', 'choices_limit', 'choices_stopped',
                                            'problems')),
                ('combinations', _REAL), ('open', _REAL), ('ended', ctypes.c_char * 4800),
                ('derivatives', ctypes.c_char * 1600), ('report', _TEXT), ('room', _AT)]

    def rows(self, name, many, kind):
        """A list of structures or numbers."""
        return list((kind * many).from_address(getattr(self, name))) if many else []


for _k, _kind in enumerate((Free, Row, Times, Series, Values, Design, Options, Active, End, Found)):
    if LIBRARY.gs_loop_design_size(ctypes.c_int(_k)) != ctypes.sizeof(_kind):
        raise ImportError('%s: the library was built with another optimize.h' % NAME)


def weights(t):
    """Weights of an integral over the times, and how they change with the last one."""
    t = np.ascontiguousarray(t, float)
    w, slope = np.zeros(len(t)), np.zeros(len(t))
    at = [ctypes.c_void_p(a.ctypes.data) for a in (t, w, slope)]
    if LIBRARY.gs_integral_weights(ctypes.c_int(len(t)), *at):
        raise MemoryError('%s.optimize' % NAME)
    return w, slope


def differences(start, low, high, at):
    """Where differences of order 4 look for the derivative at a value, and their factors."""
    points, factors = np.zeros(5), np.zeros(5)
    variable = Free(start=start, low=low, high=high)
    n = LIBRARY.gs_difference_points(ctypes.byref(variable), ctypes.c_double(at),
                                     ctypes.c_void_p(points.ctypes.data),
                                     ctypes.c_void_p(factors.ctypes.data))
    return points[:n], factors[:n]
