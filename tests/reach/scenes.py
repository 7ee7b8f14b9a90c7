"""scenes.py ARMS FOLDER [NAME ...]: a scene FOLDER/NAME.mac for every arm of the table ARMS (or
those named), and FOLDER/NAME.h, what round_trips.c has to know of it."""
import sys
from pathlib import Path


def joint(k, text):
    kind, *numbers = text.split()
    slides = kind == "P"
    return (f"{'prismatic' if slides else 'revolute'}(j{k}, {'ground' if k == 1 else f'b{k - 1}'}, "
            f"b{k}, at = [{', '.join(numbers[3:])}], axis = [{', '.join(numbers[:3])}], "
            f"coordinate = q{k})")


def scene(line):
    name, joints, tool, *given = [part.strip() for part in line.split(";")]
    joints = [part.strip() for part in joints.split(",")]
    n = len(joints)
    point = tool.startswith("POINT")
    at = ", ".join(tool.split()[-3:])
    tool = f"point(tool, b{n}, at = [{at}])" if point else (
        f"frame(tool, b{n}, at = [{at}], rotation = [y, %pi/2])")
    given = int(given[0].split()[1]) if given else 0
    asked = f"inverse_kinematics(tool, given = [q{given}])" if given else "inverse_kinematics"
    links = [f"link(b{k}, mass = 1, inertia = [1, 1, 1])" for k in range(1, n + 1)]
    body = links + [joint(k + 1, text) for k, text in enumerate(joints)] + [tool]
    inside = ",\n  ".join(body)
    text = (f'scene : gsmbp_scene("{name}", gravity = [0, 0, -9.81],\n  {inside})$\n'
            f"requests : [points, point_jacobians, {asked}]$\n")
    turns = ", ".join("0" if j.startswith("P") else "1" for j in joints)
    head = (f"#define NAME(x) {name}_##x\n#define NQ {n}\n#define GIVEN {given}\n"
            f"#define WHOLE {int(not point)}\nstatic const int turns[NQ] = {{{turns}}};\n")
    return name, text, head


def main(arms, folder, names):
    lines = [line for line in Path(arms).read_text().splitlines() if line and line[0] != "#"]
    unknown = set(names) - {line.split(";")[0].strip() for line in lines}
    if unknown:
        sys.exit("not ok no arm of the table is named " + ", ".join(sorted(unknown)))
    for line in lines:
        name, text, head = scene(line)
        if not names or name in names:
            Path(folder, name + ".mac").write_text(text)
            Path(folder, name + ".h").write_text(head)
            print(name)


main(sys.argv[1], sys.argv[2], sys.argv[3:])
