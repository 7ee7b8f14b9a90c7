# Runs that carry derivatives and their adjoint, in C (share/engine/host): emitted scenes against
# closed forms and differences, two runs at once, under the sanitizers (make test-whole: in quad
# precision, too).
. tests/tools/check.sh
root=$PWD
work_folder
cat >"$work/oscillator.mac" <<'M'
scene : gsmbp_scene("oscillator", link(block, mass = m),
  prismatic(rail, ground, block, axis = x, coordinate = x),
  spring(back, stiffness = c, joint = rail), damper(loss, joint = rail, damping = d),
  parameters = [m = 2*kg, c = 5*N/m, d = 0*N*s/m])$
requests : '[all, adjoint, sensitivity]$
M
statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
for scene in "$work/oscillator" tests/scenes/sensitivity_ball tests/scenes/sensitivity_bounce \
  tests/scenes/sensitivity_sampled tests/scenes/sensitivity_crank; do
  statements="$statements kill(scene, requests)\$ load(\"$(realpath $scene.mac)\")\$
    gsmbp_c(scene, requests, 'directory = \"$work\", precision = any)\$"
done
share/make/maxima "$work/log" "$statements" >"$report" 2>&1
told $? 'the scenes are emitted in C' "$report"

headers_in_cplusplus host/derivatives/derivatives.h host/adjoint.h
for kind in sane $(whole && echo quad); do
  engine_program $kind "$work/$kind" -I"$work" tests/c/host/carried_runs.c "$work"/*.c
  told $? "the program compiles, $kind" "$report"
  to_the_end "$work/$kind"
done
