"""states.py FOLDER [NAME ...]: for tests/bench/robots.m, two kinds of files. Mass matrix and bias
of robots of the PyPI package example-robot-data (those of ROBOTS, or named), by Pinocchio, at
five states by chance; for each FOLDER/NAME.json with the path of its URDF, the coordinates in
the order of the file, q, u, M, bias. Joints that mimic others count as independent, continuous
joints by their angle. And FOLDER/reach/NAME.json for the arms and legs of TOOLS: 1000 positions
by chance of the joints that lead to a link, and where Pinocchio has it at the first 20."""
import json
import math
import random
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import pinocchio

ROBOTS = """a1 anymal b1 baxter centauro finger_edu g1_29dof_rev_1_0 go2 hyq_no_sensors kinova
laikago panda pr2 so101 solo12 talos_left_arm talos_full_v2 simple_humanoid ur5_robot xarm7 z1
romeo_small allegro_right_hand tiago_pro""".split()
# robot: link whose pose (legs of three joints: place) is asked for, joints whose values are given
TOOLS = {"ur3_robot": ["tool0"], "ur5_robot": ["tool0"], "ur10_robot": ["tool0"],
         "panda": ["panda_hand_tcp", "panda_joint7"], "z1": ["link06"],
         "kinova": ["j2s6s200_end_effector"], "so101": ["gripper_frame_link"],
         "xarm7": ["link_eef", "joint1"], "talos_left_arm": ["arm_left_7_link"],
         "talos_full_v2": ["left_sole_link"],
         "pr2": ["r_wrist_roll_link", "torso_lift_joint", "r_shoulder_pan_joint"],
         "tiago_pro": ["arm_left_7_link", "torso_lift_joint", "arm_left_1_joint"],
         "baxter": ["right_gripper", "right_s0"], "romeo_small": ["l_sole"],
         "simple_humanoid": ["l_ankle"], "g1_29dof_rev_1_0": ["left_ankle_roll_link"],
         "a1": ["FR_foot"], "anymal": ["LF_FOOT"], "solo12": ["FL_FOOT"],
         "hyq_no_sensors": ["lf_foot"]}
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


def joints_to(robot, link):
    """the moving joints from the root to a link"""
    above = {j.find("child").get("link"): j for j in robot.findall("joint")}
    chain = []
    while link in above:
        if above[link].get("type") in MOVING:
            chain.insert(0, above[link].get("name"))
        link = above[link].find("parent").get("link")
    return chain


def placement(model, data, chain, values, link):
    q = pinocchio.neutral(model)
    for name, angle in zip(chain, values):
        joint = model.joints[model.getJointId(name)]
        q[joint.idx_q:joint.idx_q + joint.nq] = (
            [math.cos(angle), math.sin(angle)] if joint.nq == 2 else [angle])
    pinocchio.framesForwardKinematics(model, data, q)
    at = data.oMf[model.getFrameId(link)]
    return at.translation.tolist(), at.rotation.tolist()


def reach_case(path, link, *given):
    robot = xml.parse(path).getroot()
    joints = [j.get("name") for j in robot.findall("joint") if j.get("type") in MOVING]
    chain = joints_to(robot, link)
    slides = {j.get("name") for j in robot.findall("joint") if j.get("type") == "prismatic"}
    rng = random.Random(11)
    q = [[rng.uniform(-.5, .5) if n in slides else rng.uniform(-math.pi, math.pi) for n in chain]
         for _ in range(1000)]
    model = pinocchio.buildModelFromUrdf(str(path))
    data = model.createData()
    P, R = zip(*[placement(model, data, chain, values, link) for values in q[:20]])
    return {"urdf": str(path), "link": link, "chain": [joints.index(n) for n in chain],
            "given": [joints.index(n) for n in given], "q": q, "P": P, "R": R}


def main(folder, names):
    robots = folder_of_robots()
    Path(folder, "reach").mkdir(exist_ok=True)
    for name in names or ROBOTS + [n for n in TOOLS if n not in ROBOTS]:
        path = sorted(robots.rglob(name + ".urdf"))[0]
        if name in ROBOTS:
            Path(folder, name + ".json").write_text(json.dumps(case(path)))
        if name in TOOLS:
            file = Path(folder, "reach", name + ".json")
            file.write_text(json.dumps(reach_case(path, *TOOLS[name])))
        print(name, flush=True)


main(sys.argv[1], sys.argv[2:])
