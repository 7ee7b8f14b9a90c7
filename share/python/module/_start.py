"""How a run starts (host/start.h): settled states, constraints, stops, margins of devices."""
import ctypes

import numpy as np

from . import _checks
from ._library import LIBRARY, NAME, TABLE, at
from ._tables import VERDICTS

_SIZE = 2400
# what a call of Python may do about a verdict of gsmbp/failures.h
_REMEDIES = {'OFF': '; start="project" moves it onto them',
             'FAR': '; start="project" moves it onto them',
             'NONE': '; try another start, or check the lengths',
             'DEVICE': '; start="project" takes devices as they are'}


def initial(model):
    """The states where the scene starts."""
    x = _checks.start(model._values)
    LIBRARY.gs_loop_settle(at(model.cst), at(x))
    return x


def refusal(verdict, state, text, model):
    """A verdict on a start, which is not TAKEN, in words."""
    word = VERDICTS[verdict]
    if word == 'ANGLE':
        text = 'x0[%d], %s: %s' % (state, model.states[state], text)
    return text + _REMEDIES.get(word, '')


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
