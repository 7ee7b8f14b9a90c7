# Emitted C99 (gsmbp_c): a sample of scenes compiles without a warning, calls nothing but
# share/engine/core and libm, writes no data of its own, and gives what the emitted Fortran gives
# (tests/tools/c_pair; `make test-c` takes all scenes). A constant that is changed in the C is
# found.
. tests/tools/check.sh
work_folder

# pairs WHAT FILE...: as the environment says
pairs() {
  what=$1
  shift
  GSMBP_STATES=5 tests/tools/c_pair "$work" "$@" >"$report" 2>&1
  told $? "$what" "$report"
}

# -- trees, loops, Euler parameters, devices, events, samples, inverse kinematics; beams, fluids,
# circuits, derivatives by parameters, events of the user
scenes='speeds_body event_crank sampled_crank reach_legs flexible_mounted fluid_pneumatic
  electric_others sensitivity_crank user_wheel mech_digital'
whole && scenes="$scenes case_03a own_words reach_parallel_apart"
pairs 'C and Fortran' $(printf 'tests/scenes/%s.mac ' $scenes)
(GSMBP_REQUESTS='[all, batch, lanes, regressor]' pairs 'batches, lanes and the regressor' \
  tests/scenes/batch_arm.mac tests/scenes/batch_bars.mac)
whole && (GSMBP_NUMBERS=compiled pairs 'parameters as numbers' tests/bench/systems/puma3.mac)

# -- names of C, of its library and of other alphabets; one that needs no parameter
cat >"$work/names.mac" <<'M'
scene : gsmbp_scene("names", gravity = [0, -double, 0],
  link(a, mass = auto, centre = [long, sin_, 0], inertia = [i, j, exp_1]),
  link(b, mass = mass_b, centre = [m, 0.1, 0], inertia = [1, 2, 3]),
  revolute(J1, ground, a, axis = z, coordinate = for_),
  revolute(J2, a, b, at = [cst, 0, 0], axis = x, coordinate = t1),
  input(register, unit = N*m), drive(D, joint = J1, effort = register),
  output(y1, mass_b*t1), output(info, for_^5 + abs(t1)^1.5 + (t1 + for_)^7),
  parameters = [double = 9.81, auto = 2, long = 0.1, sin_ = 0.2, i = 1, j = 2, exp_1 = 2.5,
    mass_b = 1,
    m = 0.2, cst = 0.4])$
M
pairs 'names of C' "$work/names.mac"
cat >"$work/bare.mac" <<'M'
scene : gsmbp_scene("bare", link(a, mass = 1), prismatic(P, ground, a, axis = x, coordinate = q))$
M
pairs 'a scene without parameters' "$work/bare.mac"

# -- what differs is found
sed 's/0\.5\*/0.50000000001*/' "$work/batch_arm.c" >"$work/changed.c"
cmp -s "$work/batch_arm.c" "$work/changed.c" && echo 'not ok there is no 0.5 to change'
mv "$work/changed.c" "$work/batch_arm.c"
tests/tools/c_pair "$work" tests/scenes/batch_arm.mac >"$report" 2>&1
check 'a changed constant is found' fails [ $? -eq 0 ]
