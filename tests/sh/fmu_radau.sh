# gsmbp_fmu(scene, method = radau): co-simulation of a stiff closed chain as gsmbp_simulate runs it
# by radau, events of the user, under the address sanitizer; others do without the files of radau.
. tests/tools/check.sh
work_folder
has_all FMUs zip unzip || exit 0
root=$PWD
export GSMBP_TEST_DIR=${GSMBP_TEST_DIR:-$work}

# fmus SCENE METHOD: derived into the folder METHOD, unpacked in METHOD/SCENE2 and SCENE3
fmus() {
  share/fmu/derive tests/scenes/$1.mac "$work/$2" $2 >"$report" 2>&1
  told $? "$1 becomes FMUs with method $2" "$report"
  for standard in 2 3; do
    unzip -q -o "$work/$2/$1_fmi$standard.fmu" -d "$work/$2/$1$standard"
  done
}
fmus stiff_loop radau
fmus stiff_loop dp853
tests/fmu/binaries "$work/radau" stiff_loop
octave-cli -qf --no-history --path "$root/octave" --path "$root/octave/hand" \
  --path "$root/tests/octave" "$root/tests/fmu/stiff.m" "$work/reference" >"$report" 2>&1
told $? 'gsmbp_simulate runs stiff_loop by radau' "$report"
for standard in 2 3; do
  to_the_end python3 tests/fmu/stiff.py stiff_loop "$work/radau/stiff_loop$standard" $standard \
    "$work/reference" "$work/dp853/stiff_loop$standard"
  find "$work/dp853/stiff_loop$standard" -path '*implicit*.c' >"$report"
  grep -rl host/implicit --include=*.xml "$work/dp853/stiff_loop$standard" \
    >>"$report"
  result "FMI $standard.0: an FMU with dp853 has no file of radau"
  find "$work/radau/stiff_loop$standard" -name 'gauss_*' ! -name gauss_points.c >"$report"
  result "FMI $standard.0: one with radau has none of gauss"
done
fmus user_bounce radau
# Newton's method ends at a part of the tolerance, which is 1e-10
to_the_end python3 tests/fmu/events.py user_bounce "$work/radau/user_bounce3" 3 1e-10
tests/fmu/drive "$work/radau" user_bounce 0.4 10
