# A terminal is told how far long work is and the time that is left; a log is not.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
has script 'what a terminal is told' || exit 0
cat >"$work/long.m" <<E1
addpath ("$root/octave", "$root/octave/hand");
m = gsmbp_hand ("motor_pendulum");
[r, info] = gsmbp_simulate (m, m.initial, 0:1e5, "input", 1, "maxstep", 1e-3, "timeout", 3);
e = gsmbp_ensemble (m, m.initial, [0 100], "input", 1, "maxstep", 1e-3, "timeout", 3, ...
                    "parameters", struct ("m", linspace (1, 2, 1e4)));
E1
script -qec "octave-cli -qf '$work/long.m'" "$work/terminal" >/dev/null 2>&1 </dev/null
check 'a run: its time and the time that is left' \
  grep -q 'motor_pendulum: [0-9.]* of 100000 s, [0-9]* s left' "$work/terminal"
check 'many runs: their number and the time that is left' \
  grep -q 'motor_pendulum: [0-9]* of 10000 runs, [0-9]* s left' "$work/terminal"
octave-cli -qf "$work/long.m" >"$work/log" 2>&1 </dev/null
check 'nothing of it in a log' fails grep -q 'left' "$work/log"
