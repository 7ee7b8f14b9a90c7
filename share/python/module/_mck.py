"""The matrices of small motions (host/linear/linear.h, and the mass matrix)."""
import collections

import numpy as np

from . import _linear
from ._library import NAME, SIZES

NQ, NU = SIZES['nq'], SIZES['nu']

Mck = collections.namedtuple(
    'Mck', 'M C K B E D G S N coordinates speeds inputs devices')
Mck.__doc__ = """What mck gives: M u' + C u + K q = B v + E z for deviations u, q of the independent
speeds and coordinates, v of the inputs, z of the states of devices; D, G: damping and gyroscopic
part of C = D + G, symmetric and skew; S, N: conservative and circulatory part of K = S + N, None
where coordinates and speeds do not go in pairs; coordinates, speeds, inputs, devices: names of q,
u, v, z."""


def mck(self, t, x, v=None, *, reduced='auto', drop=(), start='check'):
    """The matrices of small motions about an equilibrium or a steady motion at the states x and the
    inputs v (default zeros) at the time t, as gsmbp_mck of Octave has them:
    M u' + C u + K q = B v + E z.

    Arguments as of linear. Result: an Mck, in SI units.
    """
    who = NAME + '.mck'
    self._has('jac', 'mas')
    t, x, v = _linear.numbers(who, self, t, x, v)
    x = _linear.on_constraints(who, self, t, x, start)
    found = _linear.at_state(who, self, t, x, v, reduced, drop)
    k = found.independent
    q, u, z = k < NQ, (k >= NQ) & (k < NQ + NU), k >= NQ + NU
    V = found.tangent[NQ:NQ + NU, u]
    M = V.T @ self.mas(t, x[:NQ]) @ V
    M = (M + M.T) / 2
    C, K = -M @ found.a[np.ix_(u, u)], -M @ found.a[np.ix_(u, q)]
    paired = NQ == NU and np.array_equal(k[q] + NQ, k[u])
    names = [tuple(self.states[i] for i in k[which]) for which in (q, u, z)]
    return Mck(M, C, K, M @ found.b[u], M @ found.a[np.ix_(u, z)], (C + C.T) / 2, (C - C.T) / 2,
               (K + K.T) / 2 if paired else None, (K - K.T) / 2 if paired else None,
               names[0], names[1], self.inputs, names[2])
