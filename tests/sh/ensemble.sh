# Ensembles in C (share/engine/host/ensemble, host/lanes): emitted scenes against single runs and a
# closed form, by several threads, interrupted, under the sanitizers (make test-whole: in quad
# precision, too).
. tests/tools/check.sh
root=$PWD
work_folder
cat >"$work/oscillator.mac" <<'M'
scene : gsmbp_scene("oscillator", link(block, mass = m),
  prismatic(rail, ground, block, axis = x, coordinate = x),
  spring(back, stiffness = c, joint = rail), damper(loss, joint = rail, damping = d),
  parameters = [m = 2*kg, c = 5*N/m, d = 0*N*s/m])$
requests : '[all]$
M
statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
for scene in "$work/oscillator" tests/scenes/sensitivity_bounce tests/scenes/sensitivity_crank; do
  statements="$statements kill(scene, requests)\$ load(\"$(realpath $scene.mac)\")\$
    gsmbp_c(scene, requests, 'directory = \"$work\", precision = any)\$"
done
share/make/maxima "$work/log" "$statements" >"$report" 2>&1
told $? 'the scenes are emitted in C' "$report"

headers_in_cplusplus host/ensemble/ensemble.h

for kind in sane threads $(whole && echo quad); do
  engine_program $kind "$work/$kind" -I"$work" -Itests/c/host tests/c/host/ensemble_runs.c \
    "$work"/*.c
  told $? "the program compiles, $kind" "$report"
  to_the_end "$work/$kind"
done
