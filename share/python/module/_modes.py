"""Small vibrations about a state (host/linear/linear.h)."""
import collections
import warnings

import numpy as np

from . import _linear, _run
from ._library import Error, LIBRARY, NAME, SIZES, at
from ._structures import Modes as Found, Told, Vibrations, VibrationsAsked

NQ, NX = SIZES['nq'], SIZES['nx']

Modes = collections.namedtuple('Modes', 'frequency damping shapes eigenvalues real rigid x')
Modes.__doc__ = """What modes gives: frequency (n,) [rad/s], ascending, and damping (n,) of each
mode that oscillates; shapes (nq, n): complex amplitudes of the coordinates (of the states, where
there are none), the largest one 1; eigenvalues (n,) [1/s] with positive imaginary parts; real:
those that are real, ascending; rigid: how many are zero; x (nx,): the state about which they
are."""


def modes(self, x, v=None, *, hold=(), steady=False, time=0.0, start='check'):
    """Frequencies, damping ratios and shapes of small vibrations about the states x (or the
    coordinates, at rest) and the inputs v (default zeros), as gsmbp_modes of Octave has them.

    hold: names of coordinates that keep their motion; steady: the state is first moved to where
    nothing but what is held moves at other than constant speed; time [s]: of what depends on it;
    start: "check", x must be on the constraints, or "project", it is moved there.
    Elsewhere than at an equilibrium or a steady motion a RunWarning tells the largest acceleration.
    Result: Modes.
    """
    who = NAME + '.modes'
    self._has('jac')
    t, x, v = _linear.numbers(who, self, time, x, v)
    x = _linear.on_constraints(who, self, t, x, start)
    if not isinstance(steady, (bool, np.bool_)):
        raise ValueError('%s: steady: expected True or False; found %r' % (who, steady))
    pairs = [_linear.speed_of(who, self, 'hold', name)
             for name in _linear.listed(who, 'hold', hold)]
    asked = VibrationsAsked(steady=bool(steady), nheld=len(pairs))
    asked.put('held', [k for pair in pairs for k in pair] or [0], np.intc)
    here, found, told = _linear.place(self, t, x, v), Vibrations(), Told()
    for name in ('independent', 'felt'):
        found.put(name, np.zeros(NX + 1), np.intc)
    for name in ('a', 'square', 'tangent'):
        found.put(name, np.zeros(NX * NX + 1))
    found.put('x', np.zeros(NX))
    LIBRARY.gs_loop_vibrate(here.address(), asked.address(), found.address(), told.address())
    _linear.heed(who, self, told, Error)
    if found.doubt:
        warnings.warn('%s: expected an equilibrium or a steady motion; found %s; trim finds one, '
                      'or steady=True' % (who, found.doubt.decode()), _run.RunWarning, stacklevel=3)
    return _of(who, self, here, found)


def _of(who, model, here, found):
    """The modes of the eigenvalues and eigenvectors, which NumPy finds."""
    k, rows = found.nfelt, NQ or NX
    values, vectors = np.linalg.eig(
        found.kept['square'][:k * k].reshape((k, k), order='F')) if k else (np.zeros(0),) * 2
    m, told = Found(), Told()
    for name, size in (('eigenvalues', 2), ('frequency', 1), ('damping', 1), ('shapes', 2 * rows),
                       ('real', 1)):
        m.put(name, np.zeros(size * k + 1))
    pairs = [_pairs(a) for a in (values, vectors)]
    LIBRARY.gs_loop_modes(here.address(), found.address(), *map(at, pairs), m.address(),
                          told.address())
    _linear.heed(who, model, told, Error)
    n = m.n
    shapes = m.kept['shapes'][:2 * rows * n].view(complex).reshape((rows, n), order='F')
    return Modes(m.kept['frequency'][:n], m.kept['damping'][:n], shapes,
                 m.kept['eigenvalues'][:2 * n].view(complex), m.kept['real'][:m.nreal], m.rigid,
                 found.kept['x'])


def _pairs(a):
    """Complex numbers by columns, as pairs of real ones."""
    return np.append(np.asarray(a, complex).ravel(order='F'), 0).view(float)
