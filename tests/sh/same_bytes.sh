# The same scene with the same switches gives the same bytes, whatever the session was asked for
# before: one session derives a list of files, a second one the same list from the end, others one
# each from nothing.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# job NUMBER: a scene, switches, and a request; its files go to FOLDER/NUMBER
cat >"$work/jobs.mac" <<'M'
load("gsmbp/gsmbp.mac")$
fewer : delete('group, delete('short, gsmbp_passes))$
arm : gsmbp_scene("arm", gravity = [0, -g, 0],
  link(a, mass = m1, centre = [0.1, 0.2, 0], inertia = [1, 2, 3]),
  link(b, mass = 2, centre = [0.3, 0.1, d0], inertia = [0.3, 0.4, 0.5]),
  revolute(J1, ground, a, axis = z, coordinate = z1),
  revolute(J2, a, b, at = [0.5, 0.1, 0], axis = x, coordinate = k5),
  gyroscope(G, b, axis = y, momentum = h),
  dc_motor(M1, joint = J1, ratio = 9),
  parameters = [g = 9.81*m/s^2, m1 = 3*kg, h = 0.3*N*m*s, d0 = 0])$
load("tests/scenes/case_03a.mac")$ four_bar : scene$
load("tests/bench/systems/puma3.mac")$ puma : scene$
load("tests/scenes/event_arm.mac")$ events : scene$
lean : block([s], with_stdout("/dev/null",
  s : gsmbp_abbreviate(puma, 0.01, [speeds = 2, accelerations = 5])), s)$
jobs : [[arm, gsmbp_passes, 'cheapest, '[forward], 'literal],
  [arm, gsmbp_passes, 'cheapest, 'all, 'literal],
  [arm, fewer, 'cheapest, '[inverse, forward], 'literal],
  [arm, gsmbp_passes, 'articulated, '[forward], 'literal],
  [arm, [], 'mass, '[inverse, forward], 'compiled],
  [arm, delete('zeros, gsmbp_passes), 'cheapest, '[inverse, linear], 'literal],
  [arm, gsmbp_all_passes, 'cheapest, '[inverse, batch], 'compiled],
  [four_bar, gsmbp_passes, 'cheapest, '[rhs], 'literal],
  [four_bar, gsmbp_passes, 'cheapest, 'all, 'literal],
  [four_bar, fewer, 'cheapest, '[rhs, projection], 'compiled],
  [puma, gsmbp_passes, 'cheapest, '[inverse], 'literal],
  [puma, gsmbp_passes, 'cheapest, '[inverse, linear, batch, regressor], 'literal],
  [puma, fewer, 'articulated, '[forward], 'compiled],
  [events, gsmbp_passes, 'cheapest, '[events], 'literal],
  [lean, gsmbp_passes, 'cheapest, '[inverse, forward], 'literal],
  [lean, gsmbp_passes, 'mass, '[forward, bias], 'compiled]]$
job(folder, k) := block([j : jobs[k], gsmbp_passes, gsmbp_forward],
  gsmbp_passes : j[2], gsmbp_forward : j[3],
  gsmbp_fortran(j[1], j[4], directory = sconcat(folder, "/", k), numbers = j[5]))$
/* what else may be asked for in between */
others(s) := (gsmbp_mass_matrix(s), gsmbp_gravity(s), gsmbp_linear(s), gsmbp_energy(s))$
M
count=16

# session STATEMENTS: with the jobs
session() { share/make/maxima "$work/log" "batchload(\"$work/jobs.mac\")\$ $1" || exit 1; }
session "for k thru $count do job(\"$work/forth\", k)\$"
session "others(arm)\$ others(puma)\$
  for k : $count step -1 thru 1 do job(\"$work/back\", k)\$
  for k in [2, 15] do job(\"$work/again\", k)\$"
session "job(\"$work/alone\", 9)\$"

cd "$work" || exit 1
for other in back again alone; do
  for file in "$other"/*/*; do
    cmp "$file" "forth/${file#*/}" || echo "$file" >>differ
  done >>differ 2>&1
  n=$(ls "$other"/*/* | wc -l)
  [ ! -s differ ] && [ "$n" -ge 2 ]
  told $? "$other: the same bytes in $n files" differ
  : >differ
done
# the switches are not ignored: what they change is changed
counts() { cat forth/[134]/arm.f | grep -A1 OPERATIONS | grep mul | sort -u; }
[ "$(counts | wc -l)" -gt 4 ] &&
  ! cmp -s forth/1/arm.f forth/4/arm.f && ! cmp -s forth/11/puma3.f forth/13/puma3.f
told $? "switches change what they should"
# temporaries are numbered by routine, from 1 on without a gap but for names of the scene
cat forth/*/*.f | awk '/^      SUBROUTINE/ { last = 0 }
  !/^C/ && match($0, /^      Z[0-9]+ = /) {
    n = substr($0, 8, RLENGTH - 10) + 0
    if (n > last + 2) print FILENAME ": Z" n " behind Z" last
    if (n > last) last = n
  }' >gaps
[ ! -s gaps ]; told $? "temporaries are numbered in the order of each routine" gaps
