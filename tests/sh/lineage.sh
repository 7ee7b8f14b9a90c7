# Programs in Fortran alone: gfortran with no compiler of C in its PATH builds emitted scenes with
# the driver of share/fortran/drive and with nothing of share/fortran but what emitted routines and
# the driver call (tests/tools/closure.py). Inverse dynamics and runs against what the emitted C
# gives, scenes that the driver cannot run refused (a part of the scenes; all of the examples and
# tests: `make test-lineage`); the driver against closed forms.
. tests/tools/check.sh
root=$PWD
work_folder

# -- trees, loops, Euler parameters, devices, beams, switches; events, samples
scenes='examples/four_bar/four_bar examples/hooke/hooke examples/lead_screw/lead_screw
  examples/spinning_top/spinning_top examples/bending_rod/bending_rod_linear
  tests/scenes/switch_circuit tests/scenes/event_arm tests/scenes/user_wheel
  examples/robot_joint/robot_joint_sampled'
files=$(printf '%s.mac ' $scenes)
whole && files=$(ls examples/*/*.mac tests/scenes/*.mac)
echo $files | xargs -n 12 tests/lineage/run "$work/scenes" 2>&1 | grep -E '^(ok|not ok) '

# -- the driver
(cd "$work" && PATH=$work/scenes/alone gfortran -std=legacy -O1 -fcheck=bounds -frecursive -w \
  -o drive "$root/tests/lineage/drive.f" scenes/fortran/*.o) >"$report" 2>&1 && "$work/drive"
told $? 'the driver against closed forms' "$report"

# -- an error is found: a rate that is not that of the scene
cd "$work/scenes" || exit 1
sed 's/XD(4) = THETA_DD/XD(4) = 1.0000001D0*THETA_DD/' four_bar.f >changed.f
cmp -s four_bar.f changed.f && echo 'not ok there is no rate to change'
PATH=$work/scenes/alone gfortran -std=legacy -frecursive -o changed four_bar_main.f changed.f \
  fortran/*.o >"$report" 2>&1 && ./changed >four_bar.fortran
"$root/tests/lineage/program.py" . four_bar answers >"$report"
check 'a changed rate is found' grep -q '^not ok four_bar: expected INFO 0' "$report"
