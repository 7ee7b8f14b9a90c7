"""Exact derivatives of inverse dynamics and of positions by a planned motion and by parameters, for
load cases of designs."""
import ctypes

import numpy as np

from ._derivatives import KNOWN
from ._library import Error, LIBRARY, NAME, NO_INPUTS, ROUTINES, SIZES, TABLE, at

NQ, NU, NX, NV, NY, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nx', 'nv', 'ny', 'nlam'))
ACTUATED = [int(k) - 1 for k in np.atleast_1d(TABLE.get('actuated') or [])]
PLANNED = ACTUATED if NLAM else list(range(NU))
INSIDE = bool(TABLE.get('internal'))   # states of devices that are integrated along a motion


def fields_of(kind, fields):
    """Has a case of this kind exact derivatives of these fields?"""
    fields, has = set(fields), ROUTINES.keys()
    tree = not NLAM and {'inv', 'lin', 'inp'} <= has
    loop = NLAM and 'ilp' in has and len(PLANNED) > 0
    if NQ != NU or not (tree or loop):
        return False
    outputs = 'y' not in fields or {'jac', 'oup'} <= has
    efforts = {'tau', 'lam', 'extra'} if NLAM else {'tau', 'extra'}
    if kind == 'positions':
        return outputs and fields <= efforts | {'x', 'y'}
    drives = 'cmj' in has and not INSIDE and outputs
    states = {'x'} if NX == NQ + NU else set()
    return fields <= efforts | (states if not drives else {'x', 'v', 'y'})


def motion_slopes(who, model, t, motion, efforts, changes, by):
    """Derivatives of a motion (q, u, ud: (nu, nt)) with its efforts (tau, lam): changes
    (planned, 3, nt, n) of the planned coordinates, their speeds and accelerations; by (npar, n):
    of the parameters. X (nu, 3, nt, n), tau, lam (rows, nt, n)."""
    nt, n = changes.shape[2:]
    if NLAM:
        return _of_loops(who, model, t, motion, efforts, changes, by)
    X = changes
    m, b, c = model.lin(t, *motion, **NO_INPUTS)
    T = sum(np.einsum('ijt,jtk->itk', matrix, X[:, k]) for k, matrix in enumerate((c, b, m)))
    if len(by) and by.any():
        T = T + np.einsum('ijt,jk->itk', model.inp(t, *motion, **NO_INPUTS), by)
    return X, T, np.zeros((0, nt, n))


def _of_loops(who, model, t, motion, efforts, changes, by):
    nt, n = changes.shape[2:]
    D = model.ilp(t, *motion, *efforts, np.zeros((NV, nt)))
    X, E = np.zeros((NU, 3, nt, n)), np.zeros((NU, nt, n))
    planned, P = np.array(PLANNED, np.intc), np.asfortranarray(by, float)
    for i in range(nt):
        d, q = np.asfortranarray(D[:, :, i]), np.asfortranarray(changes[:, :, i])
        x, e = np.zeros((NU, 3, n), order='F'), np.zeros((NU, n), order='F')
        bad = LIBRARY.gs_loop_slopes(
            *map(ctypes.c_int, (NU, len(by), len(d))), at(d), ctypes.c_int(len(planned)),
            at(planned), ctypes.c_int(n), at(q), at(P) if P.size else None, at(x), at(e))
        if bad:
            raise Error('%s: no derivatives by the loops at t = %.9g s: the position is singular '
                        'for %s' % (who, t[i], ', '.join(model.coordinates[k] for k in PLANNED)))
        X[:, :, i], E[:, i] = x, e
    return X, E[:len(PLANNED)], E[len(PLANNED):]


def of_inverse(who, model, R, jets, by):
    """Derivatives of an inverse run R; jets (planned, 1 + order, nt, n): of the motion with its
    derivatives."""
    nt, n = jets.shape[2:]
    X, T, L = motion_slopes(who, model, R.t, (R.q, R.u, R.ud), (R.tau, R.lam), jets[:, :3], by)
    x = np.zeros((NX, nt, n))
    x[:NU], x[NU:2 * NU] = X[:, 0], X[:, 1]
    D = {'tau': T, 'lam': L, 'x': x}
    if 'cmj' not in ROUTINES or R.x is None:
        return D
    given = np.concatenate([jets[:, :R.qj.shape[1]].reshape((-1, nt, n), order='F'),
                            np.repeat(by[:, None], nt, axis=1)])
    v, xa = model.cmj(R.t, R.qj, R.x[2 * NU:])
    D['v'] = np.einsum('ijt,jtk->itk', v, given)
    x[2 * NU:] = np.einsum('ijt,jtk->itk', xa, given)
    _outputs(model, R.t, R.x, R.v, D, by)
    return D


def of_positions(who, model, R, changes, by):
    """Derivatives of positions at rest; changes (planned, nt, n) of the held coordinates."""
    n = changes.shape[2]
    nt = len(R.t)
    still, t = np.zeros((NU, nt)), np.zeros(nt)
    jets = np.zeros((len(PLANNED), 3, nt, n))
    jets[:, 0] = changes
    X, T, L = motion_slopes(who, model, t, (R.x[:NQ], still, still),
                            (R.tau, getattr(R, 'lam', None)), jets, by)
    D = {'tau': T, 'lam': L, 'x': np.zeros((NX, nt, n))}
    D['x'][:NQ] = X[:, 0]
    _outputs(model, t, R.x, R.v, D, by)
    return D


def _outputs(model, t, x, v, D, by):
    if NY and {'jac', 'oup'} <= ROUTINES.keys():
        _, _, c, d = model.jac(t, x, v)
        D['y'] = np.einsum('ijt,jtk->itk', c, D['x']) + np.einsum(
            'ijt,jk->itk', model.oup(t, x, v), by)
        if 'v' in D and NV:
            D['y'] += np.einsum('ijt,jtk->itk', d, D['v'])


def parameters_by(free, names):
    """(npar, n): 1 where a variable of these names is the parameter."""
    by = np.zeros((len(KNOWN), len(free)))
    for k, one in enumerate(free):
        if one.name in KNOWN and one.name in names:
            by[KNOWN.index(one.name), k] = 1
    return by
