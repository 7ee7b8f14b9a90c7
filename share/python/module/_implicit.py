"""The implicit methods of a run: radau, gauss, cvode, and auto, which goes on with radau."""
import ctypes
import os

import numpy as np

from ._library import HERE, NAME, SIZES, TABLE
from ._tables import PLACE, REFUSALS

SPEEDS = slice(SIZES['nq'], SIZES['nq'] + SIZES['nu'])   # among the states


def cvode(who, method):
    """CVODE in C for a run by this method, None where it needs none."""
    if PLACE[method] != 'library':
        return None
    return ctypes.cast(_sundials(who).gs_cvode, ctypes.c_void_p)


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
