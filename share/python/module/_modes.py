"""Small vibrations about a state (host/linear/linear.h)."""
import collections
import warnings

import numpy as np

from . import _linear, _run
from ._assemble import closed
from ._library import Error, LIBRARY, NAME, SIZES, at
from ._structures import Modes as Found, ModesOfSpeeds, Told, Vibrations, VibrationsAsked

NQ, NX, NLAM = (SIZES[k] for k in ('nq', 'nx', 'nlam'))

Modes = collections.namedtuple('Modes', 'frequency damping shapes eigenvalues real rigid x')
Modes.__doc__ = """What modes gives: frequency (n,) [rad/s], ascending, and damping (n,) of each
mode that oscillates; shapes (nq, n): complex amplitudes of the coordinates (of the states, where
there are none), the largest one 1; eigenvalues (n,) [1/s] with positive imaginary parts; real:
those that are real, ascending; rigid: how many are zero; x (nx,): the state about which they
are."""


Campbell = collections.namedtuple(
    'Campbell', 'speeds frequency damping shapes eigenvalues real rigid x')
Campbell.__doc__ = """What campbell gives: speeds (k,); frequency, damping, eigenvalues (n, k): a
row follows one mode by its shape from speed to speed, NaN where it is none; shapes (nq, n, k);
real: k arrays; rigid (k,); x (nx, k): the states about which they are. The rest as of Modes."""


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
    found, doubt = _at(who, self, (t, x, v), _held(who, self, hold), steady, start)
    _tell(who, doubt)
    return found


def campbell(self, x, spin, speeds, v=None, *, hold=(), steady=False, time=0.0, start='check'):
    """The modes about the states x at each of the speeds of the coordinate spin, which is held, as
    gsmbp_modes of Octave has them with its option "spin". Each speed begins at the state of the one
    before. Other arguments as of modes. Result: a Campbell.
    """
    who = NAME + '.campbell'
    self._has('jac')
    t, x, v = _linear.numbers(who, self, time, x, v)
    held = _held(who, self, [name for name in _linear.listed(who, 'hold', hold) if name != spin])
    own = _linear.speed_of(who, self, 'spin', spin)
    speeds = _speeds(who, speeds)
    found, doubts = [], []
    for speed in speeds:
        x = x.copy()
        x[NQ + own[1]] = speed
        if NLAM and start == 'project':
            x = closed(who, self, x, spin, t)[:, 0]
        one, doubt = _at(who, self, (t, x, v), [*held, own], steady, start)
        found.append(one)
        doubts.append(doubt)
        x = one.x
    _tell(who, next((doubt for doubt in doubts if doubt), ''))
    return _followed(speeds, found)


def _speeds(who, given):
    speeds = np.atleast_1d(np.asarray(given))
    if (speeds.dtype.kind not in 'fiu' or speeds.ndim != 1 or not speeds.size
            or not np.isfinite(speeds).all()):
        raise ValueError('%s: speeds: expected finite numbers [rad/s or m/s]; found %r' % (
            who, given))
    return speeds.astype(float)


def _held(who, model, names):
    return [_linear.speed_of(who, model, 'hold', name)
            for name in _linear.listed(who, 'hold', names)]


def _tell(who, doubt):
    if doubt:
        warnings.warn('%s: expected an equilibrium or a steady motion; found %s; trim finds one, '
                      'or steady=True' % (who, doubt), _run.RunWarning, stacklevel=4)


def _at(who, model, state, pairs, steady, start):
    """The modes of one state, and why it is no equilibrium."""
    t, x, v = state
    x = _linear.on_constraints(who, model, t, x, start)
    if not isinstance(steady, (bool, np.bool_)):
        raise ValueError('%s: steady: expected True or False; found %r' % (who, steady))
    asked = VibrationsAsked(steady=bool(steady), nheld=len(pairs))
    asked.put('held', [k for pair in pairs for k in pair] or [0], np.intc)
    here, found, told = _linear.place(model, t, x, v), Vibrations(), Told()
    for name in ('independent', 'felt'):
        found.put(name, np.zeros(NX + 1), np.intc)
    for name in ('a', 'square', 'tangent'):
        found.put(name, np.zeros(NX * NX + 1))
    found.put('x', np.zeros(NX))
    LIBRARY.gs_loop_vibrate(here.address(), asked.address(), found.address(), told.address())
    _linear.heed(who, model, told, Error)
    return _of(who, model, here, found), found.doubt.decode()


def _followed(speeds, found):
    """Modes from speed to speed (gs_follow_modes)."""
    many = [len(one.frequency) for one in found]
    total, k = sum(many), len(speeds)
    asked = ModesOfSpeeds(rows=NQ or NX, nspeeds=k, total=total)
    asked.put('many', many, np.intc)
    asked.put('frequency', np.concatenate([one.frequency for one in found] + [[0]]))
    asked.put('shapes', np.concatenate([_pairs(one.shapes)[:-2] for one in found] + [[0]]))
    row = np.zeros(total + 1, np.intc)
    n = LIBRARY.gs_follow_modes(asked.address(), at(row))
    if n < 0:
        raise MemoryError(NAME + '.campbell')
    r = Campbell(speeds, np.full((n, k), np.nan), np.full((n, k), np.nan),
                 np.full((NQ or NX, n, k), np.nan + 0j), np.full((n, k), np.nan + 0j),
                 tuple(one.real for one in found), np.array([one.rigid for one in found]),
                 np.stack([one.x for one in found], axis=1))
    ends = np.cumsum([0, *many])
    for i, one in enumerate(found):
        own = row[ends[i]:ends[i + 1]]
        for name in ('frequency', 'damping', 'eigenvalues'):
            getattr(r, name)[own, i] = getattr(one, name)
        r.shapes[:, own, i] = one.shapes
    return r


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
