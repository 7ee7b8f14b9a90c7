"""c_driver.py NAME.json: a program in C, on standard output, that calls every emitted routine in
Fortran and in C with the same random numbers and compares what they give.

It needs the two emitted sources and the run times; its argument is how many states. It prints a
line

    NAME calls entries same largest

with the number of entries compared, of those that are equal bit for bit, and the largest
difference beside the largest entry of its array; it ends with 1 where that is above 1e-14 (in quad
1e-30) or an INFO differs.
"""
import json
import re
import sys


def of(shape):
    """(whole, intent, dims) of a shape such as "integer in", "out(LDM,*)" """
    whole, intent, dims = re.fullmatch(r"(integer )?([a-z]+)(?:\((.*)\))?", shape).groups()
    return bool(whole), intent, dims.split(",") if dims else []


class Scene:
    def __init__(self, description):
        self.name = description["name"].lower()
        self.d = description["dimensions"]
        self.wide = sum(self.d.values()) + 8      # also the most states of a batch
        self.initial = description["initial"]
        self.routines = description["subroutines"]

    def extent(self, dim):
        if dim.isdigit():
            return int(dim)
        if ":" in dim:
            low, high = dim.split(":")
            return int(high) - int(low) + 1
        return self.wide      # a leading dimension, or *

    def size(self, name, dims):
        if name == "CST" and dims == ["*"]:
            return self.d["ncst"]
        n = 1
        for dim in dims:
            n *= self.extent(dim)
        return n


def whole_value(scene, routine, name):
    """a value of an integer argument"""
    if name.startswith("LD"):
        return str(scene.wide)
    if name == "K" and routine.endswith(("_V", "_W")):
        return f"1 + (19 * state) % {scene.wide}"
    if routine.endswith("_NIK"):
        return "1" if name == "K" else "state % 2"
    if name == "WAY":
        return "1 + state % 4"
    if name == "K":
        last = scene.d["nctl"] if routine.endswith("_CTL") else scene.d["nev"]
        least = 0 if routine.endswith("_CTL") else -1
        return f"{least} + state % {last + 1 - least}"
    return str(scene.wide)


def fill(name, n):
    kind = {"X": "state_like", "Q": "state_like", "QJ": "motion_like"}.get(name, "number")
    return f"fill_{kind} (f_{name}, {n});"


def argument(scene, routine, name, shape):
    """lines that declare and fill both, the arguments of Fortran and C, lines that compare"""
    whole, intent, dims = of(shape)
    n = scene.size(name, dims)
    if name == "INFO" and not dims:
        return ["int f_INFO = 0, c_INFO = 0;"], "&f_INFO", None, ["same_info (f_INFO, c_INFO);"]
    if whole and not dims and intent == "out":
        return [f"int f_{name} = -1, c_{name} = -1;"], f"&f_{name}", f"&c_{name}", [
            f"same_info (f_{name}, c_{name});"]
    if whole and not dims:
        value = whole_value(scene, routine, name)
        return [f"int f_{name} = {value};"], f"&f_{name}", f"f_{name}", []
    if not dims and intent == "in":
        return [f"gs_real f_{name} = number (1);"], f"&f_{name}", f"f_{name}", []
    if name == "CST" and not routine.endswith("_W"):
        return [], "cst_f", "cst_c", []
    kind = "int" if whole else "gs_real"
    lines = [f"static {kind} f_{name}[{n}], c_{name}[{n}];"]
    if name == "CST" and intent == "in":   # of each state
        lines.append(f"for (int i = 0; i < {n}; i++) f_CST[i] = cst_f[i/{scene.wide}];")
    elif whole:
        lines.append(f"for (int i = 0; i < {n}; i++) f_{name}[i] = (int)(3 * chance ()) - 1;")
    else:
        lines.append(fill(name, n))
    lines.append(f"memcpy (c_{name}, f_{name}, sizeof c_{name});")
    checks = [] if intent == "in" else [
        f"same_{'int' if whole else 'reals'} (f_{name}, c_{name}, {n}, \"{routine} {name}\");"]
    if name == "PAR" and not routine.endswith("_W"):
        return lines, f"f_{name}", f"(void *)c_{name}", checks
    return lines, f"f_{name}", f"c_{name}", checks


def pose(scene, routine):
    """lines that make a pose to be reached that of the last frame at coordinates by chance, where
    the scene has PNT"""
    reached = routine["name"].endswith(("_IKN", "_NIK", "_IKA", "_IKB", "_IKU"))
    for points in scene.routines:
        if reached and points["name"].endswith("_PNT"):
            shapes = dict(zip(points["arguments"], points["shapes"]))
            np, nr = [scene.size(a, of(shapes[a])[2]) for a in "PR"]
            return [f"gs_real pose_T = 0, pose_Q[{scene.d['nq']}], pose_P[{np}], pose_R[{nr}];",
                    f"fill_state_like (pose_Q, {scene.d['nq']});",
                    f"{points['name'].lower()}_ (&pose_T, pose_Q, cst_f, pose_P, pose_R);"] + [
                    f"memcpy (f_{a}, pose_{a} + {n - k}, sizeof f_{a}); "
                    f"memcpy (c_{a}, f_{a}, sizeof c_{a});"
                    for a, n, k in (("P", np, 3), ("R", nr, 9)) if a in routine["arguments"]]
    return []


def prototype(routine):
    types = ["int *" if of(s)[0] else "gs_real *" for s in routine["shapes"]]
    return f"extern void {routine['name'].lower()}_ ({', '.join(types) or 'void'});"


def call(scene, routine):
    lines, fortran, c, checks = [], [], [], []
    for name, shape in zip(routine["arguments"], routine["shapes"]):
        declared, in_fortran, in_c, check = argument(scene, routine["name"], name, shape)
        lines += declared
        fortran.append(in_fortran)
        c += [in_c] if in_c else []
        checks += check
    lines += pose(scene, routine)
    name = routine["name"].lower()
    tells = "c_INFO = " if ("INFO", "integer out") in zip(
        routine["arguments"], routine["shapes"]) else ""
    return (["{"] + ["  " + s for s in lines]
            + [f"  {name}_ ({', '.join(fortran)});", f"  {tells}{name} ({', '.join(c)});"]
            + ["  " + s for s in checks] + ["  calls++;", "}"])


def main():
    scene = Scene(json.load(open(sys.argv[1])))
    d = scene.d
    initial = scene.initial + [0] * (d["nx"] + 1)
    constant = [r for r in scene.routines if r["name"].endswith(("_PAR", "_PRE"))]
    others = [r for r in scene.routines if r not in constant]
    print('#include "emitted_pair.h"')
    print(f'#include "{scene.name}.h"')
    print("\n".join(prototype(r) for r in scene.routines))
    print(f"static gs_real par[{d['npar'] + 1}], cst_f[{d['ncst'] + 1}], cst_c[{d['ncst'] + 1}];")
    print(f"static const gs_real initial[] = {{ {', '.join(map(repr, initial))} }};")
    print("static void\nfill_state_like (gs_real *x, int n)\n{\n  for (int i = 0; i < n; i++)\n"
          f"    x[i] = i < {d['nx']} ? near (initial[i]) : number (1);\n}}")
    print("static void\nfill_motion_like (gs_real *x, int n)\n{\n  for (int i = 0; i < n; i++)\n"
          f"    x[i] = i < {d['nq']} ? near (initial[i]) : number (1);\n}}")
    print("int\nmain (int argc, char **argv)\n{\n  int states = argc > 1 ? atoi (argv[1]) : 10;")
    print(f"  static gs_real par_c[{d['npar'] + 1}];")
    print(f"  {scene.name}_par_ (par);\n  {scene.name}_par ((void *)par_c);")
    print(f'  same_reals (par, par_c, {d["npar"]}, "PAR");')
    print(f"  int info_f = 0;\n  {scene.name}_pre_ (par, cst_f, &info_f);")
    print(f"  int info_c = {scene.name}_pre ((void *)par_c, cst_c);\n  same_info (info_f, info_c);")
    print(f'  same_reals (cst_f, cst_c, {d["ncst"]}, "CST");')
    print("  for (int state = 0; state < states; state++)\n    {")
    for r in others:
        for line in call(scene, r):
            print("      " + line)
    print(f'    }}\n  return told ("{scene.name}");\n}}')


main()
