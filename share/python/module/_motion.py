"""Motions and tables as piecewise polynomials."""
import numpy as np


class Piecewise:
    """A piecewise polynomial of n quantities.

    breaks: shape (pieces + 1,), rising [s]; coefficients: shape (n, pieces, order), the highest
    power of (t - break) first. Beyond its ends the value is held and its derivatives are zero.
    """

    def __init__(self, breaks, coefficients):
        self.breaks = np.array(breaks, float)
        self.coefficients = np.array(coefficients, float)
        pieces = len(self.breaks) - 1
        if self.breaks.ndim != 1 or pieces < 1 or not (np.diff(self.breaks) > 0).all():
            raise ValueError('breaks: expected two or more rising times')
        if self.coefficients.ndim != 3 or self.coefficients.shape[1] != pieces:
            raise ValueError('coefficients: expected the shape (n, %d, order); found %s' % (
                pieces, self.coefficients.shape))
        if not (np.isfinite(self.coefficients).all() and np.isfinite(self.breaks).all()):
            raise ValueError('a piecewise polynomial must be finite')

    @property
    def n(self):
        return self.coefficients.shape[0]

    def __call__(self, t, derivative=0, side=1):
        """Values at the times t, shape (n,) or (n, k); side -1: from the left at a break."""
        return self.derivatives(t, (derivative,), side)[0]

    def derivatives(self, t, orders, side=1):
        """A list: the derivative of each of the rising orders."""
        t = np.asarray(t, float)
        first, last = self.breaks[0], self.breaks[-1]
        piece = np.searchsorted(self.breaks, t, 'right' if side > 0 else 'left') - 1
        piece = np.minimum(np.maximum(piece, 0), len(self.breaks) - 2)   # np.clip is slower
        h = np.minimum(np.maximum(t, first), last) - self.breaks[piece]
        outside = (t < first) | (t > last)
        c = self.coefficients[:, piece]
        found = []
        for order in range(orders[-1] + 1):
            if order:
                powers = np.arange(c.shape[-1] - 1, 0, -1)
                c = c[..., :-1] * powers if len(powers) else np.zeros(c.shape[:-1] + (1,))
            if order in orders:
                total = np.zeros((self.n,) + t.shape)
                for j in range(c.shape[-1]):
                    total = total * h + c[..., j]
                found.append(np.where(outside, 0.0, total) if order else total)
        return found

    def flat(self):
        """The numbers as the run time has them: breaks, coefficients."""
        return np.concatenate([self.breaks, self.coefficients.ravel(order='F')])


_SHAPES = {'quintic': [6, -15, 10, 0, 0, 0], 'septic': [-20, 70, -84, 35, 0, 0, 0, 0]}


def plan(kind, q, times):
    """A motion from rest to rest: "quintic" (speed and acceleration vanish at both ends) or
    "septic" (jerk as well). q: shape (n, m), or (m,) for one coordinate, a column for each of the
    m times."""
    if kind not in _SHAPES:
        raise ValueError('plan: expected "quintic" or "septic"; found %r' % (kind,))
    shape = np.array(_SHAPES[kind], float)
    times = np.asarray(times, float)
    q = np.atleast_2d(np.asarray(q, float))
    if times.ndim != 1 or q.shape[1] != len(times):
        raise ValueError('plan: expected a column of q for each of the %d times; found %s' % (
            times.size, q.shape))
    order = len(shape)
    coefficients = np.zeros((q.shape[0], len(times) - 1, order))
    for p in range(len(times) - 1):
        scale = (times[p + 1] - times[p]) ** -np.arange(order - 1, -1, -1.0)
        coefficients[:, p, :] = np.outer(q[:, p + 1] - q[:, p], shape * scale)
        coefficients[:, p, -1] = q[:, p]
    return Piecewise(times, coefficients)


def table(times, values, order=1):
    """Quantities through values at times; values: shape (n, m), or (m,) for one. order 0 holds each
    value until the next time, 1 is linear."""
    times = np.asarray(times, float)
    values = np.atleast_2d(np.asarray(values, float))
    if times.ndim != 1 or values.shape[1] != len(times) or len(times) < 2:
        raise ValueError('table: expected a column of values for each of the %d times (two or '
                         'more); found %s' % (times.size, values.shape))
    h = np.diff(times)
    if order == 0:
        return Piecewise(np.append(times, times[-1] + h.max()), values[:, :, None])
    if order == 1:
        slope = np.diff(values) / h
        return Piecewise(times, np.stack([slope, values[:, :-1]], axis=2))
    raise ValueError('table: order must be 0 or 1; found %r' % (order,))


def as_piecewise(who, what, given, n):
    """A Piecewise of n quantities; a PPoly of SciPy is one too."""
    if not isinstance(given, Piecewise) and hasattr(given, 'x') and hasattr(given, 'c'):
        c = np.asarray(given.c)
        given = Piecewise(given.x, c.reshape(c.shape[0], c.shape[1], -1).transpose(2, 1, 0))
    if not isinstance(given, Piecewise):
        raise TypeError('%s: %s: expected a piecewise polynomial (plan, table); found %s' % (
            who, what, type(given).__name__))
    if given.n != n:
        raise ValueError('%s: %s: expected %d components; found %d' % (who, what, n, given.n))
    return given
