# Without some of the passes, and without any, every routine of a scene with a loop, a device and
# inputs is Fortran that compiles.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/scene.mac" <<'E2'
pass_scene(name) := gsmbp_scene(name,
  link(b1, mass = m1, centre = [1/5, 0, 0], inertia = [1, 1, 1]),
  link(b2, mass = 1, centre = [1/3, 0, 0]),
  link(b3, mass = 2),
  revolute(J1, ground, b1, axis = z, start = 1),
  revolute(J2, b1, b2, axis = z, at = [2/5, 0, 0], start = -2),
  prismatic(J3, ground, b3, axis = x, start = 1),
  revolute(J4, b2, b3, axis = z, at = [1, 0, 0], cut = true),
  gravity = [0, -9, 0], force(F, b3, vector = [f, 0, 0]), input(f, unit = N),
  dc_motor(M, joint = J1, ratio = 3), output(r, reaction(J1)), parameters = [m1 = 3*kg])$
pass_emit(off, k) := block(
  [gsmbp_passes : if off = 'none then [] else delete(off, gsmbp_all_passes)],
  gsmbp_fortran(pass_scene(sconcat("p", k)), [all, batch], ['directory = work]))$
E2
share/make/maxima "$work/log" "load(\"gsmbp/gsmbp.mac\")\$ load(\"$work/scene.mac\")\$
  work : \"$work\"\$ k : 0\$
  for off in '[none, dead, order, hoist] do pass_emit(off, k : k + 1)\$" ||
  echo 'not ok passes: all derive'
cd "$work" && for file in p*.f; do
  gfortran -fsyntax-only "$file" 2>errors || { echo "$file"; head -n 3 errors; }
done >wrong
[ "$(ls p*.f | wc -l)" -eq 4 ] && [ ! -s wrong ]
told $? 'passes: without one, and without any, all routines compile' wrong
