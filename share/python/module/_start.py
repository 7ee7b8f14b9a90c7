"""How a run starts (host/start.h): settled states, constraints, stops, margins of devices."""
import ctypes

import numpy as np

from . import _checks
from ._library import LIBRARY, NAME, SIZES, TABLE, at
from ._tables import VERDICTS

_SIZE = 2400
# what a call of Python may do about a verdict of gsmbp/failures.h
_REMEDIES = {'OFF': '; start="project" moves it onto them',
             'FAR': '; start="project" moves it onto them',
             'NONE': '; try another start, or check the lengths',
             'DEVICE': '; start="project" takes devices as they are'}


def _text():
    return ctypes.create_string_buffer(_SIZE), ctypes.c_int(_SIZE)


def initial(model):
    """The states where the scene starts."""
    x = _checks.start(model._values)
    LIBRARY.gs_loop_settle(at(model.cst), at(x))
    return x


def _modes(given):
    """Modes that can be, as whole numbers; others are refused with the plan."""
    given = np.asarray(0 if given is None else given)
    fits = given.shape == (SIZES['nev'],) and np.isin(given, (-1, 0, 1)).all()
    return np.ascontiguousarray(given, np.intc) if fits else None


def take(who, model, t, x, check, modes):
    """The state x (an array, changed) as a run takes it at t; modes of the ports, or None."""
    text, state = _text(), ctypes.c_int()
    given = _modes(modes)
    verdict = LIBRARY.gs_loop_start(
        ctypes.c_double(t), at(model.cst), at(model._values), ctypes.c_int(check),
        given if given is None else at(given), at(x), ctypes.byref(state), *text)
    word = VERDICTS[verdict]
    if word == 'ANGLE':
        who += ': x0[%d], %s' % (state.value, model.states[state.value])
    if word != 'TAKEN':
        raise ValueError('%s: %s%s' % (who, text[0].value.decode(), _REMEDIES.get(word, '')))


def samples(who, model, t, ip, rp):
    """The first samples of the sampled devices into the plan of a run from t on."""
    text = _text()
    if LIBRARY.gs_loop_samples_from(ctypes.c_double(t), at(model.cst), at(ip), at(rp), *text):
        raise ValueError('%s: %s' % (who, text[0].value.decode()))


def wrong_mode(model, t, x, modes, k):
    """Why the mode of event k (from 0), of those that are given, contradicts the state."""
    text, given = _text(), np.ascontiguousarray(modes, np.intc)
    LIBRARY.gs_loop_wrong_mode(ctypes.c_double(t), at(model.cst), at(given), at(x),
                               ctypes.c_int(k), *text)
    return 'modes: ' + text[0].value.decode()


def _leading(a):
    return ctypes.c_int(a.strides[1] // 8)


def margins(model, t, x, v):
    """[(sentence, time)]: margins of devices that are passed at the times, in the columns x, v."""
    most = len(TABLE.get('state_margins') or [])
    if not most or not len(t):
        return []
    first, texts = np.zeros(most, np.intc), ctypes.create_string_buffer(most * _SIZE)
    many = LIBRARY.gs_loop_margins(
        ctypes.c_int(len(t)), at(t), at(x), _leading(x), at(v), _leading(v), at(model.cst),
        at(model._values), at(first), texts, ctypes.c_int(_SIZE))
    if many < 0:
        raise MemoryError('%s: margins of devices' % NAME)
    return [(texts[_SIZE * i:_SIZE * (i + 1)].split(b'\0')[0].decode(), t[first[i]])
            for i in range(many)]


def outside(model, t, x, v):
    """What is added to a failure where devices are outside their margins at t, x, v."""
    text = _text()
    LIBRARY.gs_loop_outside(ctypes.c_double(t), at(x), at(v), at(model.cst), at(model._values),
                            *text)
    return text[0].value.decode()
