"""states.py FOLDER [NAME ...]: mass matrix and bias of robots of the PyPI package
example-robot-data (those of ROBOTS, or named), by Pinocchio, at five states by chance; for each
FOLDER/NAME.json with the path of its URDF, the coordinates in the order of the file, q, u, M, bias.
Joints that mimic others count as independent, continuous joints by their angle."""
import json
import random
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import pinocchio

ROBOTS = """a1 anymal b1 baxter centauro finger_edu g1_29dof_rev_1_0 go2 hyq_no_sensors kinova
laikago panda pr2 so101 solo12 talos_left_arm talos_full_v2 simple_humanoid ur5_robot xarm7 z1
romeo_small allegro_right_hand tiago_pro""".split()
MOVING = ("revolute", "continuous", "prismatic")


def folder_of_robots():
    site = Path(pinocchio.__file__).resolve()
    while not (site / "share/example-robot-data").is_dir():
        site = site.parent
    return site / "share/example-robot-data/robots"


def state(model, joints, rng):
    """q and u by the names of the joints; the same as Pinocchio's vectors"""
    q, u = pinocchio.neutral(model), pinocchio.utils.zero(model.nv)
    by_name = {}
    for name in joints:
        joint = model.joints[model.getJointId(name)]
        angle, speed = rng.uniform(-1, 1), rng.uniform(-1, 1)
        u[joint.idx_v] = speed
        if joint.nq == 2:
            import math
            q[joint.idx_q], q[joint.idx_q + 1] = math.cos(angle), math.sin(angle)
        else:
            q[joint.idx_q] = angle
        by_name[name] = (angle, speed)
    return q, u, by_name


def case(path):
    robot = xml.parse(path).getroot()
    joints = [j.get("name") for j in robot.findall("joint") if j.get("type") in MOVING]
    model = pinocchio.buildModelFromUrdf(str(path))
    data = model.createData()
    places = [model.joints[model.getJointId(name)].idx_v for name in joints]
    assert len(places) == model.nv, path
    rng = random.Random(len(joints))
    states = []
    for _ in range(5):
        q, u, by_name = state(model, joints, rng)
        M = pinocchio.crba(model, data, q)
        M = [[max(M[i, k], M[k, i], key=abs) for k in places] for i in places]
        bias = pinocchio.nonLinearEffects(model, data, q, u)
        states.append({"q": [by_name[n][0] for n in joints], "u": [by_name[n][1] for n in joints],
                       "M": M, "bias": [bias[i] for i in places]})
    return {"urdf": str(path), "joints": joints, "states": states}


def main(folder, names):
    robots = folder_of_robots()
    for name in names or ROBOTS:
        path = sorted(robots.rglob(name + ".urdf"))[0]
        Path(folder, name + ".json").write_text(json.dumps(case(path)))
        print(name, flush=True)


main(sys.argv[1], sys.argv[2:])
