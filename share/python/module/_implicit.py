"""The implicit methods of a run: radau, gauss, cvode, and auto, which goes on with radau."""
import ctypes
import os

import numpy as np

from ._library import HERE, LIBRARY, NAME, SIZES, TABLE
from ._tables import REFUSALS, is_number

SPEEDS = slice(SIZES['nq'], SIZES['nq'] + SIZES['nu'])   # among the states
ORDERS = {'radau': (5, 9, 13), 'auto': (5, 9, 13), 'gauss': (4, 6, 8), 'cvode': (1, 2, 3, 4, 5)}


class Choice:
    """What a run by an implicit method is given beside the options of all (gs_implicit)."""

    def __init__(self, who, method, maxorder, index2):
        self.method, self.said = method, ctypes.create_string_buffer(400)
        self.address = _address(who, method)
        follows = TABLE.get('internal') or []
        self.numbers = np.array([_order(who, method, maxorder), index2, len(follows), *follows, 0],
                                np.intc)

    def taken(self, stats):
        """The method of the last step."""
        if self.method == 'auto':
            return 'radau' if stats['stiff'] else 'dp853'
        return self.method


def _order(who, method, order):
    if method not in ORDERS:
        if order is not None:
            raise ValueError('%s: maxorder: %s' % (who, REFUSALS.one_order % (method, order)))
        return 0
    if order is None:
        return ORDERS[method][-1 - (method == 'gauss')]
    if isinstance(order, bool) or not is_number(order) or order not in ORDERS[method]:
        numbers = ', '.join(map(str, ORDERS[method]))
        raise ValueError('%s: maxorder: %s' % (who, REFUSALS.order % (numbers, repr(order))))
    return int(order)


def _address(who, method):
    """The method in C, None where the run needs none."""
    if method not in ORDERS:
        return None
    if method == 'cvode':
        return ctypes.cast(_sundials(who).gs_cvode, ctypes.c_void_p)
    name = {'auto': 'gs_radau'}.get(method, 'gs_' + method)
    return ctypes.cast(getattr(LIBRARY, name), ctypes.c_void_p)


def _sundials(who):
    """The library of CVODE, which setup.py makes where it finds SUNDIALS."""
    path = os.path.join(HERE, '_cvode.so')
    if not os.path.exists(path):
        raise ImportError('%s: %s: %s was built without it; install it, then the module again' % (
            who, REFUSALS.no_sundials, NAME))
    try:
        return ctypes.CDLL(path)
    except OSError as problem:
        raise ImportError('%s: %s: %s' % (who, REFUSALS.no_sundials, problem)) from None


def check_index2(who, model, method):
    """What loops in index 2 need."""
    if SIZES['nlam'] == 0:
        raise ValueError('%s: loops: %s' % (who, REFUSALS.no_loops % NAME))
    if method not in ('radau', 'auto'):
        raise ValueError('%s: loops: %s' % (who, REFUSALS.index2_method % repr(method)))
    model._has('mas', 'con', 'tan')


def sharp_friction(model, r, method):
    """Ports whose friction falls from its breakaway within a speed that the method cannot resolve
    (gs.events.sharp_ports of Octave): a message for each."""
    events = TABLE.get('events') or []
    if method not in ('radau', 'cvode') or not events or not len(r.t):
        return []
    happened = {events[k]['name'] for k in r.events['number']}
    ports = [k for k, event in enumerate(events)
             if event['kind'] == 'stick' and event['name'] in happened]
    told = []
    held = model.hld(r.t[-1], r.x[:, -1], r.v[:, -1]) if ports else None
    for k in ports:
        row, vs = np.abs(held.row[k]), held.prm[1, k]
        atol, least = row @ r.stats['atol'][SPEEDS], 5e-9 * row @ model.nominal[SPEEDS]
        if 0 < vs and (vs <= atol or vs < least):
            told.append(REFUSALS.sharp_friction % (events[k]['name'], vs, atol, '', method, least))
    return told
