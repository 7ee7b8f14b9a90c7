# gsmbp_fmu: at a communication point that is a sample of a digital device both kinds of both
# standards show the values after the sample, taken with the inputs that are set there, as
# gsmbp_simulate takes it (scene sampled_inputs);
# ports stick and slide as the sample pushes them (event_pendulum).
. tests/tools/check.sh
work_folder
has_all FMUs zip unzip || exit 0
root=$PWD
export GSMBP_TEST_DIR=${GSMBP_TEST_DIR:-$work}

share/fmu/derive tests/scenes/sampled_inputs.mac "$work/fmu" >"$report" 2>&1
told $? 'sampled_inputs becomes FMUs' "$report"
for standard in 2 3; do
  unzip -q -o "$work/fmu/sampled_inputs_fmi$standard.fmu" -d "$work/unpacked$standard"
done
# ports that stick: modes after the sample
share/fmu/derive tests/scenes/event_pendulum.mac "$work/fmu" >"$report" 2>&1
told $? 'event_pendulum becomes FMUs' "$report"
for standard in 2 3; do
  unzip -q -o "$work/fmu/event_pendulum_fmi$standard.fmu" -d "$work/pendulum$standard"
  to_the_end python3 tests/fmu/events.py event_pendulum "$work/pendulum$standard" $standard
done
# delays: none; an output that comes between points; one that comes at points of half a period
for late in 0 0.03 0.05; do
  mkdir "$work/$late"
  octave-cli -qf --no-history --path "$root/octave" --path "$root/octave/hand" \
    --path "$root/tests/octave" "$root/tests/fmu/samples.m" "$work/$late" $late >"$report" 2>&1
  told $? "gsmbp_simulate runs with the delay $late s" "$report"
  for standard in 2 3; do
    to_the_end python3 tests/fmu/samples.py sampled_inputs "$work/unpacked$standard" $standard \
      "$work/$late" $late
  done
done
