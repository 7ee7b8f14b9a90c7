"""The scene with its parameters."""
import collections
import types
import warnings

import numpy as np

from . import (_adjoint, _assemble, _checks, _collocate, _ensemble, _inverse, _linear, _mck, _modes,
               _optimize, _reach, _run, _sensitivity, _start, _trim)
from ._arguments import explained, guessed, nearest
from ._library import Error, Kept, LIBRARY, NAME, ROUTINES, SIZES, TABLE, at
from ._routines import Routines
from ._tables import REFUSALS

Linear = collections.namedtuple('Linear', 'a b c d')


def _names(part):
    return tuple(row['name'] for row in TABLE.get(part) or [])


def _units(part):
    return types.MappingProxyType({row['name']: row['unit'] for row in TABLE.get(part) or []})


class Model(Routines):
    """The scene with values of its parameters, which stay as they are: changed() gives another.

    Parameters are named arguments; those that are not named are as the scene has them.
    """

    name = NAME
    sizes = types.MappingProxyType(SIZES)
    coordinates, speeds, states = map(_names, ('coordinates', 'speeds', 'states'))
    inputs, outputs, multipliers = map(_names, ('inputs', 'outputs', 'multipliers'))
    units = types.MappingProxyType({part: _units(part) for part in (
        'coordinates', 'speeds', 'states', 'inputs', 'outputs', 'parameters', 'multipliers')})
    nominal = np.array(TABLE.get('nominal') or [1.0] * SIZES['nx'], float)
    nominal.flags.writeable = False

    @explained
    def __init__(self, /, **parameters):
        names = _names('parameters')
        values = np.zeros(max(1, len(names)))
        LIBRARY.gs_loop_par(at(values))
        stated = values.copy()
        for name, given in parameters.items():
            if name not in names:
                raise KeyError(_unknown(name, names))
            values[names.index(name)] = _number(name, given)
        object.__setattr__(self, '_parameters', types.MappingProxyType(
            dict(zip(names, values[:len(names)].tolist()))))
        if (values != stated).any():
            _checks.need_routines()
        if parameters:
            self._check(values, parameters)
        values.flags.writeable = False
        object.__setattr__(self, '_values', values)
        object.__setattr__(self, 'cst', np.zeros(max(1, SIZES['ncst'])))
        info = LIBRARY.gs_loop_pre(at(values), at(self.cst))
        if info != 0:
            raise Error('%s: the parameters: INFO = %d: %s' % (NAME, info, _run.meaning(
                'pre', info)), info)
        self.cst.flags.writeable = False

    @staticmethod
    def _check(values, given):
        results, sentence = _checks.checked(values)
        if sentence:
            raise ValueError('%s: %s' % (NAME, sentence))
        for place, value in _checks.negative(results, given):
            warnings.warn('%s: %s is negative, it gives energy to the motion: %g' % (
                NAME, place, value), RuntimeWarning, stacklevel=4)

    @property
    def parameters(self):
        """The values of the parameters by their names, in SI units (units['parameters'])."""
        return self._parameters

    @explained
    def changed(self, /, **parameters):
        """The scene with other values of some parameters."""
        return Model(**{**self._parameters, **parameters})

    def __copy__(self):
        return self

    def __deepcopy__(self, memo):
        return self

    def __reduce__(self):
        return _again, (dict(self._parameters),)

    def __repr__(self):
        return '<%s: %d states, %d inputs, %d outputs>' % (
            NAME, SIZES['nx'], SIZES['nv'], SIZES['ny'])

    def _has(self, *names):
        for name in names:
            if name not in ROUTINES:
                raise AttributeError('%s was emitted without the subroutine %s%s' % (
                    NAME, name.upper(), _why(name)))

    def __setattr__(self, name, value):
        raise AttributeError('%s: a model does not change: expected changed(%s=...), another '
                             'one; found a value for %s' % (NAME, name, name))

    def __getattr__(self, name):
        if name.startswith('_'):
            raise AttributeError(name)
        if name in _REQUESTS:
            self._has(name)
        if name in self._parameters:
            raise AttributeError("%s: %s is a parameter: expected m.parameters['%s']" % (
                NAME, name, name))
        raise AttributeError('%s has no subroutine or attribute %s%s' % (NAME, name, guessed(
            name, list(ROUTINES))))

    def kept(self, name):
        """A subroutine with its arrays kept, for many calls of one state each; see Kept."""
        self._has(name)
        return Kept(ROUTINES[name], self)

    @property
    def initial(self):
        """The states where the scene starts."""
        return _start.initial(self)

    @explained
    def linearize(self, t, x, v=None):
        """The exact linear model at a state: a = dxd/dx, b = dxd/dv, c = dy/dx, d = dy/dv."""
        self._has('jac')
        return Linear(*(self.jac(t, x) if v is None else self.jac(t, x, v)))

    simulate = explained(_run.simulate)
    ensemble = explained(_ensemble.ensemble)
    adjoint = explained(_adjoint.adjoint)
    assemble = explained(_assemble.assemble)
    inverse = explained(_inverse.inverse)
    linear = explained(_linear.linear)
    trim = explained(_trim.trim)
    modes = explained(_modes.modes)
    campbell = explained(_modes.campbell)
    sensitivity = explained(_sensitivity.sensitivity)
    mck = explained(_mck.mck)
    reach = explained(_reach.reach)
    collocate = explained(_collocate.collocate)
    optimize = explained(_optimize.optimize)


def _again(parameters):
    """A model that has been pickled; what its parameters warn of was told when it was made."""
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        return Model(**parameters)


# the requests of subroutines
_REQUESTS = {
    'rhs': 'rhs', 'out': 'output', 'jac': 'jacobian', 'kin': 'kinematics', 'inv': 'inverse',
    'mas': 'mass', 'bia': 'bias', 'fwd': 'forward', 'lin': 'linear', 'con': 'constraints',
    'inl': 'inverse_loops', 'acc': 'accelerations', 'clo': 'closure', 'prj': 'projection',
    'tan': 'tangent', 'cmd': 'command', 'rha': 'audit', 'ene': 'energy', 'pnt': 'points',
    'jpt': 'point_jacobians', 'pnj': 'pose_jacobians', 'pnr': 'pose_rates', 'gra': 'gravity',
    'cor': 'coriolis', 'ske': 'skeleton', 'reg': 'regressor', 'rhp': 'sensitivity',
    'adj': 'adjoint', 'dae': 'collocation', 'daj': 'collocation', 'dah': 'collocation'}


def _why(name):
    """Why the scene was emitted without a subroutine, or how to have it."""
    request = _REQUESTS.get(name)
    for row in TABLE.get('left_out') or []:
        if row['request'] == request and 'made on request' not in row['reason']:
            return ': ' + row['reason']
    return ': derive it with the request %s of gsmbp_fortran' % request if request else ''


def _unknown(name, names):
    for row in TABLE.get('dependent') or []:
        if row['name'] == name:
            return '%s: parameter %s is made of others, %s' % (NAME, name, row['expression'])
    return '%s: unknown parameter "%s"%s' % (NAME, name, nearest(name, names))


def _number(name, given):
    x = np.asarray(given)
    if x.shape != () or x.dtype.kind not in 'fiub' or not np.isfinite(x):
        raise ValueError('%s: %s' % (NAME, REFUSALS.parameter % (name, repr(given))))
    return float(x)
