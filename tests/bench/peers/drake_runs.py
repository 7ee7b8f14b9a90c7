"""drake_runs.py FOLDER: Drake's Simulator with its integrators at many accuracies; a loop is a ball
constraint, which Drake has in discrete mode alone. A ROW for each: the least of five runs."""
import sys
import time
import numpy as np
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.plant import DiscreteContactApproximation, MultibodyPlant
from pydrake.multibody.tree import (FixedOffsetFrame, PrismaticJoint, RevoluteJoint, SpatialInertia,
                                    UnitInertia)
from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator
from model import Model, row

def inertia(mass, c, J):
    """about the link's origin, by mass"""
    x, y, z = c
    unit = UnitInertia(J[0] / mass + y * y + z * z, J[1] / mass + x * x + z * z,
                       J[2] / mass + x * x + y * y, J[3] / mass - x * y, J[5] / mass - x * z,
                       J[4] / mass - y * z)
    return SpatialInertia(mass, np.array(c), unit, skip_validity_check=True)

def plant_of(model, step):
    plant, bodies = MultibodyPlant(step), []
    if step > 0:
        plant.set_discrete_contact_approximation(DiscreteContactApproximation.kSap)
    for i, (parent, kind, R, at, mass, c, J) in enumerate(model.links):
        rotor = 0
        if mass == 0:
            rotor, mass, J = J[2], 1e-12, [1e-12] * 3 + [0] * 3
        body = plant.AddRigidBody('b%d' % i, inertia(mass, c, J))
        before = plant.world_body() if parent < 0 else bodies[parent]
        place = RigidTransform(RotationMatrix(R), np.array(at))
        frame = plant.AddFrame(FixedOffsetFrame('f%d' % i, before.body_frame(), place))
        joint = plant.AddJoint({'R': RevoluteJoint, 'P': PrismaticJoint}[kind](
            'j%d' % i, frame, body.body_frame(), [0, 0, 1]))
        if rotor:
            motor = plant.AddJointActuator('a%d' % i, joint)
            motor.set_default_rotor_inertia(rotor)
            motor.set_default_gear_ratio(1.0)
        bodies.append(body)
    if model.pin is not None:
        plant.AddBallConstraint(bodies[-2], np.array([model.pin, 0, 0]), bodies[-1], np.zeros(3))
    plant.mutable_gravity_field().set_gravity_vector(np.array(model.gravity))
    plant.Finalize()
    return plant

def runs(model, plant, simulator):
    """least seconds and coordinates at the end"""
    least, spent = np.inf, 0
    for _ in range(5):
        context = simulator.get_mutable_context()
        context.SetTime(0.0)
        plant.SetPositionsAndVelocities(context, np.concatenate((model.q, model.v)))
        simulator.Initialize()
        simulator.get_mutable_integrator().ResetStatistics()
        start = time.perf_counter()
        simulator.AdvanceTo(model.end)
        least = min(least, time.perf_counter() - start)
        spent += time.perf_counter() - start
        if spent > 0.5:
            break
    return least, plant.GetPositions(simulator.get_context())

def by_accuracy(model, scheme):
    plant = plant_of(model, 0.0)
    simulator = Simulator(plant)
    ResetIntegratorFromFlags(simulator, scheme, 0.1)
    for half in range(4, 27):
        integrator = simulator.get_mutable_integrator()
        integrator.set_fixed_step_mode(False)
        integrator.set_target_accuracy(10 ** (-half / 2))
        integrator.request_initial_step_size_target(1e-3)
        try:
            seconds, q = runs(model, plant, simulator)
        except Exception as problem:
            print('LEFT', scheme, 10 ** (-half / 2), str(problem)[:80])
            break
        row('Drake ' + scheme, 10 ** (-half / 2), seconds,
            integrator.get_num_derivative_evaluations(), q)
        if seconds > 1:
            break

def by_step(model):
    for half in range(4, 11):
        step = 10 ** (-half / 2)
        plant = plant_of(model, model.end / round(model.end / step))
        simulator = Simulator(plant)
        seconds, q = runs(model, plant, simulator)
        row('Drake discrete (SAP)', step, seconds, round(model.end / step), q)
        if seconds > 2:
            break

def main(folder):
    model = Model(folder)
    if model.pin is not None:
        by_step(model)
        return
    for scheme in ('runge_kutta3', 'runge_kutta5', 'bogacki_shampine3', 'radau3', 'implicit_euler'):
        try:
            by_accuracy(model, scheme)
        except Exception as problem:
            print('LEFT', scheme, problem)

main(sys.argv[1])
