"""rollout.py FOLDER STARTS STEP: mujoco.rollout with RK4, one thread, from the states of the file
STARTS (a row for each run); prints seconds a run, the least of five, and writes the coordinates at
the end, a row for each, to FOLDER/rollout.txt"""
import sys
import time
import mujoco
import numpy as np
from mujoco import rollout
from model import Model, mjcf

def main(folder, starts, step):
    model, least = Model(folder), np.inf
    m = mujoco.MjModel.from_xml_string(mjcf(model))
    m.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    steps = round(model.end / float(step))
    m.opt.timestep = model.end / steps
    x = np.loadtxt(starts)
    states = np.zeros((len(x), mujoco.mj_stateSize(m, mujoco.mjtState.mjSTATE_FULLPHYSICS)))
    states[:, 1:1 + 2 * model.n] = x
    with rollout.Rollout(nthread=0) as run:
        for _ in range(5):
            start = time.perf_counter()
            state, _ = run.rollout(m, mujoco.MjData(m), states, nstep=steps)
            least = min(least, time.perf_counter() - start)
    np.savetxt(folder + '/rollout.txt', state[:, -1, 1:1 + model.n], fmt='%.17g')
    print('%.9g' % (least / len(x)))

main(*sys.argv[1:])
