"""A scene derived by GSMBP, compiled.

    m = Model(l1=0.3)             parameters by name, the others as the scene has them
    m.inv(t, q, u, ud)            every subroutine of the scene is a method, help(m.inv)
    m.simulate(x0, times)         m.linearize(t, x, v), m.inverse(motion, times)
    m.ensemble(times, parameters={'l1': [0.3, 0.4]})   many runs on threads
    m.adjoint(x0, times, goal)    derivatives of goals of a run, backwards
    m.linear(t, x, v)             a linear model in independent states
    m.trim(x, v)                  an equilibrium or a steady motion
    m.modes(x)                    small vibrations
    m.mck(t, x, v)                their matrices of mass, damping and stiffness
    m.campbell(x, spin, speeds)   those of a spinning machine, by its speed
    m.sensitivity(x, v)           an equilibrium, poles and frequencies by parameters
    m.reach(name, P, R)           inverse kinematics
    m.collocate(x0, xf, time=T)   an optimal motion
    m.optimize(free, goal, demands, cases)   a design
    m.states, m.units, ...        names and units

All numbers are in SI units. An argument may have one more dimension, of k states, at its end.
"""
from ._adjoint import Adjoint
from ._collocate import Collocation
from ._ensemble import Ensemble
from ._library import DependentWarning, Error, TABLE as table
from ._linear import LinearModel
from ._mck import Mck
from ._model import Model
from ._modes import Campbell, Modes
from ._motion import Piecewise, plan, table as table_of
from ._optimize import Optimum
from ._reach import Reach
from ._run import Result, RunWarning
from ._sensitivity import Sensitivity
from ._trim import Trim

__all__ = ['Model', 'Error', 'DependentWarning', 'RunWarning', 'Result', 'Ensemble', 'Adjoint',
           'LinearModel', 'Trim', 'Modes', 'Campbell', 'Sensitivity', 'Mck', 'Reach',
           'Collocation', 'Optimum', 'Piecewise', 'plan', 'table_of', 'table']
__version__ = table['gsmbp_version']
for _one in (Model, Error, DependentWarning, RunWarning, Result, Ensemble, Adjoint, LinearModel,
             Trim, Modes, Campbell, Sensitivity, Mck, Reach, Collocation, Optimum, Piecewise):
    _one.__module__ = __name__
