"""mujoco_runs.py FOLDER PROGRAM: mj_step of MuJoCo in C (PROGRAM of mujoco_steps.c) with each of
its integrators and many steps; a ROW for each."""
import subprocess
import sys
from model import Model, mjcf, row

def main(folder, program):
    model = Model(folder)
    with open(folder + '/model.xml', 'w') as file:
        file.write(mjcf(model))
    for number, method in enumerate(('Euler', 'RK4', 'implicit', 'implicitfast')):
        for quarter in range(6, 25):
            step = 10 ** (-quarter / 4)
            run = subprocess.run([program, folder + '/model.xml', folder + '/start.txt',
                                  str(number), str(round(model.end / step))],
                                 capture_output=True, text=True)
            numbers = [float(w) for w in run.stdout.split()]
            if run.returncode or len(numbers) <= model.n:
                print('LEFT', method, step, run.stderr[:80])
                continue
            row('MuJoCo ' + method, step, numbers[0], round(model.end / step), numbers[1:])
            if numbers[0] > 0.5:
                break

main(*sys.argv[1:])
