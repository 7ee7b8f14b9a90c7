"""Events that a run with derivatives just misses, and starts on stops: where there are no
derivatives though the run itself saw nothing."""
import numpy as np

from ._library import SIZES, TABLE

NX, NV = SIZES['nx'], SIZES['nv']
EVENTS = TABLE.get('events') or []
# of each event function whether its event changes states, inputs or modes
CHANGES = np.array([e['kind'] != 'event' or bool(e.get('resets') or e.get('switches'))
                    for e in EVENTS] + [False], np.intc)


def starts_on_stops(who, model, t, x, names, S, sizes):
    """An error where a run starts at rest on a stop that moves with one of the parameters while
    the start, whose derivatives are S, does not."""
    for port in [k for k, e in enumerate(EVENTS) if e['kind'] == 'stop']:
        for side in (0, 1):
            gap, rate = _gap(model, t, x, port, side)
            if abs(gap) > 1e-9 or rate > 1e-9:
                continue
            for k, name in enumerate(names):
                step, other = 1e-6 * sizes[k], model
                if name in model.parameters:
                    other = model.changed(**{name: model.parameters[name] + step})
                slope = (_gap(other, t, x + step * S[:, k], port, side)[0] - gap) / step
                if abs(slope) * sizes[k] > 1e-6:
                    raise ValueError(
                        '%s: sensitivity: the run starts on the stop %s, whose place changes by %s '
                        'otherwise than the start: give dx0 so that they stay together' % (
                            who, EVENTS[port]['name'], name))


def _gap(model, t, x, port, side):
    """How far the port is from its lower (0) or upper (1) end, and how fast that grows."""
    held = model.hld(t, x, np.zeros(NV))
    way = 1 - 2 * side
    return way * (held.s[port] - held.prm[side, port]), way * held.sd[port]


def grazed(model, r, turns, run, atol):
    """The number (from 1) and the time of the first event that the run r just misses, or None.

    turns: rows, number and time, where an event function comes close to 0 and turns; each is looked
    at in run(times), of the states alone, by a parabola through three states there. These are 1e-4
    s apart, less where an event is nearer: beyond one the parabola says nothing.
    """
    d, happened = 1e-4, r.events['t']
    turns = turns[(turns[:, 1] > r.t[0] + d) & (turns[:, 1] < r.t[-1] - d)]
    if not len(turns):
        return None
    turns = turns[np.argsort(turns[:, 1], kind='stable')]
    steps = [min(d, max(1e-9, 0.4 * min([np.inf, *np.abs(t - happened)]))) for t in turns[:, 1]]
    places = [t + s * np.arange(-1, 2) for t, s in zip(turns[:, 1], steps)]
    times = np.unique(np.concatenate([[r.t[0], r.t[-1]], *places]))
    q = run(times)
    found = _unseen(_changing(r.events), _changing(q.events), 10 * d)
    for (number, t), step, place in zip(turns, steps, places):
        k = np.searchsorted(times, place)
        if k[-1] >= len(q.t):   # an event has ended that run
            continue
        g = np.array([_value(model, q, i, int(number)) for i in k])
        if g[0] < 0 and g[2] < 0:   # one of the user that does not rise above 0
            g = -g
        bend = g[0] - 2 * g[1] + g[2]
        if not (t < found[1] and bend > 0):
            continue
        low = g[1] - (g[2] - g[0]) ** 2 / (8 * bend)
        lowest = t + step * (g[0] - g[2]) / (2 * bend)
        beyond = ((happened - t) * (happened - lowest) < 0).any()
        if not beyond and low <= 10 * _size(model, q, k[1], int(number), atol):
            found = int(number), t
    return found if np.isfinite(found[1]) else None


def _changing(events):
    """Numbers (from 1) and times of the events that change what follows."""
    return [(int(k) + 1, t) for k, t in zip(events['number'], events['t']) if CHANGES[k]]


def _unseen(a, b, near):
    """Number and time of the first event that one of two runs has and the other has not."""
    n = min(len(a), len(b))
    k = next((i for i in range(n) if a[i][0] != b[i][0] or abs(a[i][1] - b[i][1]) > near), n)
    return min([one[k] for one in (a, b) if k < len(one)] + [(0, np.inf)], key=lambda e: e[1])


def _at(q, i):
    modes = [int(q.v[e['input'] - 1, i]) if e['input'] > 0 else 0 for e in EVENTS]
    return {'t': q.t[i], 'x': q.x[:, i], 'v': q.v[:, i], 'mode': modes}


def _value(model, q, i, number):
    return model.evt(**_at(q, i))[number - 1]


def _size(model, q, i, number, atol):
    """What the tolerances make of an event function."""
    return np.abs(model.evp(**_at(q, i), k=number)[:NX]) @ atol[:NX]
