#!/usr/bin/python3
"""c_speed.py [FLAGS]: emitted C beside emitted Fortran, single calls: for every system of
tests/bench/systems both compiled with the same flags (default -O2), in one process, by turns (gcc
-std=c99 contracts nothing by itself, gfortran does). Prints nanoseconds a call and their ratio for
each routine, and the median of the ratios. c_speed.py --systems NAME,NAME [FLAGS] takes these only.
"""
import json
import os
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CORE = f"{ROOT}/share/engine/core"
ROUTINES = ("INV", "MAS", "BIA", "FWD", "RHS")

PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "%(name)s.h"
%(prototypes)s
enum { STATES = 64, ROUNDS = 25 };
static double par[%(npar)d + 1], cst[%(ncst)d], in[STATES][%(most)d], out[4096];
static double now (void)
{
  struct timespec t;
  clock_gettime (CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1e9 + t.tv_nsec;
}
static double sink;
%(functions)s
static void compare (const char *what, void (*f) (int), void (*c) (int))
{
  int n = 200;
  double best_f = 1e30, best_c = 1e30;
  for (double t = 0; t < 2e6; n *= 2)
    {
      t = now ();
      f (n);
      t = now () - t;
    }
  for (int r = 0; r < ROUNDS; r++)
    {
      double t = now ();
      f (n);
      double between = now ();
      c (n);
      double end = now ();
      if (between - t < best_f) best_f = between - t;
      if (end - between < best_c) best_c = end - between;
    }
  printf ("%%s %%.1f %%.1f\\n", what, best_f / n, best_c / n);
}
int main (void)
{
  int info;
  for (int i = 0; i < STATES; i++)
    for (int j = 0; j < %(most)d; j++)
      in[i][j] = 2.0 * rand () / RAND_MAX - 1;
  %(lower)s_par_ (par);
  %(lower)s_pre_ (par, cst, &info);
%(calls)s
  return sink == 1;
}
"""


def functions(scene, routine):
    """the loops over one routine in both languages"""
    name, lower = routine["name"], routine["name"].lower()
    fortran, c = [], []
    for argument, shape in zip(routine["arguments"], routine["shapes"]):
        whole = shape.startswith("integer")
        read = "out" not in shape
        if argument == "INFO":
            fortran.append("&info")
        elif argument == "CST":
            fortran.append("cst")
            c.append("cst")
        elif argument == "T":
            fortran.append("&t")
            c.append("t")
        elif whole:
            fortran.append("&ld")
            c.append("ld")
        else:
            place = f"in[s] + {scene['offset'][argument]}" if read else "out"
            fortran.append(place)
            c.append(place)
    head = ("(int n) { double t = 0; int info = 0, ld = %d; (void)t; (void)info; (void)ld; "
            "for (int i = 0; i < n; i++) { int s = i %% STATES; " % max(1, scene["nu"]))
    tail = " } sink += out[0]; }"
    return (f"static void f_{lower} {head}{lower}_ ({', '.join(fortran)});{tail}\n"
            f"static void c_{lower} {head}{lower} ({', '.join(c)});{tail}")


def program(description):
    dimensions = description["dimensions"]
    width = {"Q": "nq", "U": "nu", "UD": "nu", "V": "nv", "TAU": "nu", "X": "nx"}
    scene = {"nu": dimensions["nu"], "offset": {}}
    at = 0
    for argument, size in width.items():
        scene["offset"][argument] = at
        at += dimensions[size]
    routines = [r for r in description["subroutines"] if r["name"].split("_")[-1] in ROUTINES]
    constant = [r for r in description["subroutines"] if r["name"].endswith(("_PAR", "_PRE"))]
    return PROGRAM % {
        "name": description["name"], "lower": description["name"].lower(),
        "npar": dimensions["npar"], "ncst": dimensions["ncst"], "most": at + 1,
        "prototypes": "\n".join(
            f"void {r['name'].lower()}_ ("
            + ", ".join("int *" if s.startswith("integer") else "double *" for s in r["shapes"])
            + ");" for r in constant + routines),
        "functions": "\n".join(functions(scene, r) for r in routines),
        "calls": "\n".join(f'  compare ("{r["name"]}", f_{r["name"].lower()}, '
                           f'c_{r["name"].lower()});' for r in routines)}


def run(*command, **more):
    return subprocess.run(command, check=True, text=True, capture_output=True, **more).stdout


def ratios(system, folder, flags):
    requests = "[inverse, mass, bias, forward, rhs]"
    file = f"{ROOT}/tests/bench/systems/{system}.mac"
    run(f"{ROOT}/share/make/maxima", f"{folder}/log",
        f'load("{ROOT}/gsmbp/gsmbp.mac")$ load("{file}")$ '
        f"for f in [gsmbp_fortran, gsmbp_c] do f(scene, {requests}, ['directory = \"{folder}\"])$",
        env={**os.environ, "GSMBP_TIMEOUT": "1200"})
    name = system.replace("+", "").replace("-", "m")
    description = json.load(open(f"{folder}/{name}.json"))
    with open(f"{folder}/time.c", "w") as f:
        f.write(program(description))
    run("gfortran", *flags, "-frecursive", "-c", f"{name}.f", "-o", "f.o", cwd=folder)
    run("gcc", "-std=c99", *flags, f"-I{CORE}", "-c", f"{name}.c", "-o", "c.o", cwd=folder)
    run("gcc", "-O1", f"-I{CORE}", "time.c", "f.o", "c.o", "fortran.a", "c.a",
        "-lgfortran", "-lm", "-o", "timed", cwd=folder)
    for line in run(f"{folder}/timed").splitlines():
        routine, fortran, c = line.split()
        yield routine, float(fortran), float(c)


def libraries(folder, flags):
    """the run times in both languages, as archives"""
    for archive, compiler, sources in (
            ("c.a", ["gcc", "-std=c99", f"-I{CORE}"],
             "share/engine/core/*/*.c share/engine/core/*/*/*.c"),
            ("fortran.a", ["gfortran", "-frecursive"],
             "share/fortran/*/*.f share/fortran/solve/plain/*.f")):
        os.makedirs(f"{folder}/{archive}.d")
        run("sh", "-c", " ".join(compiler + flags + ["-c"])
            + "".join(f" {ROOT}/{s}" for s in sources.split()) + f" && ar rcs ../{archive} *.o",
            cwd=f"{folder}/{archive}.d")


def main():
    arguments = sys.argv[1:]
    files = os.listdir(f"{ROOT}/tests/bench/systems")
    systems = sorted(f[:-4] for f in files if f.endswith(".mac"))
    if arguments[:1] == ["--systems"]:
        systems, arguments = arguments[1].split(","), arguments[2:]
    flags = arguments or ["-O2"]
    all_ratios = []
    with tempfile.TemporaryDirectory() as folder:
        libraries(folder, flags)
        for system in systems:
            for routine, fortran, c in ratios(system, folder, flags):
                all_ratios.append(c / fortran)
                print(f"{routine:24} {fortran:10.1f} ns {c:10.1f} ns {c / fortran:6.3f}",
                      flush=True)
    print(f"{' '.join(flags)}: median of {len(all_ratios)} ratios "
          f"{statistics.median(all_ratios):.3f}, {min(all_ratios):.3f} to {max(all_ratios):.3f}")


if __name__ == "__main__":
    main()
