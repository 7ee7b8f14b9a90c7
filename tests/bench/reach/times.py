"""times.py CALLS [eaik]: all solutions of 1000 poses of the PUMA by chance: a call of IKN beside
one of INV and, where asked, of EAIK on the same poses: by a call for each pose and by its batch
on one thread; they take turns, the least of many rounds. EAIK's arm is that of the axes which
the emitted Jacobian has. Prints markdown; ends with 1 where the solutions are not the same."""
import ctypes
import random
import sys
import time
from math import inf, pi
from pathlib import Path

COUNT, ROUNDS = 1000, 60
SAME = 1e-6     # of an angle [rad]; the nearest singular pose of the 1000 is further off


def array(values):
    return (ctypes.c_double * len(values))(*values)


def library(path):
    calls = ctypes.CDLL(path)
    calls.solutions_time.restype = calls.inverse_time.restype = ctypes.c_double
    calls.start()
    return calls


def columns(a, k, size, rows):
    """the columns of matrix k, each `rows` long, of a flat array of matrices of `size` columns"""
    return [a[rows * (size * k + i):rows * (size * k + i + 1)] for i in range(size)]


class Ours:
    def __init__(self, path):
        rng = random.Random(7)
        self.calls = library(str(path))
        self.q, self.u, self.ud = (array([rng.uniform(-s, s) for _ in range(6 * COUNT)])
                                   for s in (pi, 2, 5))
        self.p, self.r = array([0] * 3 * COUNT), array([0] * 9 * COUNT)
        self.qs, self.tau = array([0] * 48 * COUNT), array([0] * 6 * COUNT)
        self.ns = (ctypes.c_int * COUNT)()
        self.calls.poses(COUNT, self.q, self.p, self.r)

    def ikn(self):
        return self.calls.solutions_time(COUNT, self.p, self.r, self.qs, self.ns)

    def inv(self):
        return self.calls.inverse_time(COUNT, self.q, self.u, self.ud, self.tau)

    def found(self, k):
        return columns(self.qs, k, 8, 6)[:self.ns[k]]


class Eaik:
    """EAIK's robot: axes, and steps from one axis to the next, at zero angles"""

    def __init__(self, ours):
        import numpy
        from eaik.IK_HP import HPRobot
        zero, p, r, jacobian = array([0] * 6), array([0] * 3), array([0] * 9), array([0] * 36)
        ours.calls.poses(1, zero, p, r)
        ours.calls.jacobian(zero, jacobian)
        J = numpy.array(jacobian).reshape(6, 6)          # a row for each joint
        axes = J[:, 3:]
        places = numpy.vstack([numpy.zeros(3), numpy.array(p) - numpy.cross(J[:, :3], axes), p])
        self.robot = HPRobot(axes, places[1:] - places[:-1])
        R0 = numpy.array(r).reshape(3, 3).T
        self.poses = []
        for k in range(COUNT):
            pose = numpy.eye(4)
            pose[:3, :3] = numpy.array(ours.r[9 * k:9 * k + 9]).reshape(3, 3).T @ R0.T
            pose[:3, 3] = ours.p[3 * k:3 * k + 3]
            self.poses.append(pose)

    def single(self):
        call, poses = self.robot.IK, self.poses
        begin = time.thread_time_ns()
        for pose in poses:
            call(pose)
        return (time.thread_time_ns() - begin) / COUNT

    def batch(self):
        begin = time.perf_counter_ns()
        self.robot.IK_batched(self.poses, 1)
        return (time.perf_counter_ns() - begin) / COUNT

    def found(self, k):
        solution = self.robot.IK(self.poses[k])
        return [q for q, squares in zip(solution.Q, solution.is_LS) if not squares]


def same(one, other):
    """the same solutions, whatever their order"""
    def near(a, b):
        return max(abs((x - y + pi) % (2 * pi) - pi) for x, y in zip(a, b)) < SAME
    return len(one) == len(other) and all(any(near(a, b) for b in other) for a in one)


def least(*timed):
    best = [inf] * len(timed)
    for _ in range(ROUNDS):
        best = [min(b, f()) for b, f in zip(best, timed)]
    return best


def main(path, peers):
    ours = Ours(path)
    rival = Eaik(ours) if peers else None
    ikn, inv, *others = least(ours.ikn, ours.inv, *([rival.single, rival.batch] if peers else []))
    print(f"# All solutions of the PUMA 560\n\n{COUNT} poses by chance, {sum(ours.ns)/COUNT:.2f} "
          f"solutions each; ns of a call, the least of {ROUNDS} rounds in which all take turns.\n")
    head = ["IKN", "INV", "IKN : INV"] + ["EAIK, a call", "EAIK, batch", "EAIK : IKN"][:3 * peers]
    row = [f"{ikn:.0f}", f"{inv:.1f}", f"{ikn/inv:.1f}"]
    wrong = 0
    if peers:
        from importlib.metadata import version
        row += [f"{x:.0f}" for x in others] + [f"{min(others)/ikn:.1f}"]
        wrong = sum(not same(ours.found(k), rival.found(k)) for k in range(COUNT))
    for line in (head, ["---"] * len(head), row):
        print("| " + " | ".join(line) + " |")
    if peers:
        print(f"\nEAIK {version('eaik')} from PyPI as it is compiled there, called from Python: "
              f"pose by pose, or all by its batch on one thread; the ratio is that of the faster "
              f"way. Poses whose solutions differ: {wrong}.")
    return wrong > 0


sys.exit(main(Path(sys.argv[1]).resolve(), sys.argv[2:] == ["eaik"]))
