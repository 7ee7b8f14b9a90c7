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
w = gsmbp_sweep (m, m.initial, [0 20], "input", 1, "maxstep", 1e-3, "timeout", 4, "chunk", 20, ...
                 "vary", struct ("m", [1 2]), "runs", 1e5, "keep", {"final q"});
gsmbp_derive ("$work/slider_crank.mac", "$work/out");
# what gsmbp_build runs its compilers by
gs.files.run_command ("gsmbp_build", "sleep 2.5", "compiling a scene", 4);
E1
# a derivation that tells every stage, not those alone that come after ten seconds
{ printf '?\\*gs\\-patience\\* : 0$\n'; cat examples/slider_crank/slider_crank.mac
} >"$work/slider_crank.mac"
script -qec "octave-cli -qf '$work/long.m'" "$work/terminal" >/dev/null 2>&1 </dev/null
check 'a run: its time and the time that is left' \
  grep -q 'motor_pendulum: [0-9.]* of 100000 s, [0-9]* s left' "$work/terminal"
check 'many runs: their number and the time that is left' \
  grep -q 'motor_pendulum: [0-9]* of 10000 runs, [0-9]* s left' "$work/terminal"
check 'a sweep: the same of all its runs' \
  grep -q 'gsmbp_sweep: motor_pendulum: [0-9]* of 100000 runs, [0-9]* s left' "$work/terminal"
check 'a derivation: its stage and its time' \
  grep -q 'gsmbp: [^:]*: .* ([0-9]* s so far' "$work/terminal"
check 'a compilation: the time that is left' \
  grep -q 'gsmbp_build: compiling a scene, about [0-9]* s left' "$work/terminal"
octave-cli -qf "$work/long.m" >"$work/log" 2>&1 </dev/null
check 'nothing of it in a log' fails grep -qE ' s left|[0-9] s so far' "$work/log"
check 'nor in the log of the derivation' fails grep -q 'so far' "$work/out/slider_crank.log"

# Ctrl-C in a derivation and in a compilation that Octave has started
ends() {
  ended=$1; shift
  python3 tests/tools/typed.py "$@" >"$work/typed" 2>&1
  sed 's/^/   /' "$work/typed"
  check "$ended: the prompt comes at once" grep -q 'prompt after [01]\.' "$work/typed"
  check "$ended: the session goes on" grep -q '^alive' "$work/typed"
  check "$ended: nothing of it goes on" grep -q '^left: 0' "$work/typed"
}
path="addpath (\"$root/octave\");"
ends 'Ctrl-C in a derivation' 0.8 "$path" \
  "gsmbp_derive (\"$root/examples/stewart/stewart.mac\", \"$work/cut\");"
check 'Ctrl-C in a derivation: nothing half-written' \
  test -z "$(ls "$work/cut" | grep -v '\.log$')"
cp "$work"/out/slider_crank.* "$work/cut"
ends 'Ctrl-C in a compilation' 0.5 "$path" \
  "m = gsmbp_build (\"slider_crank\", \"directory\", \"$work/cut\", \"precision\", \"quad\");"
check 'Ctrl-C in a compilation: its lock is let go' \
  timeout 5 flock "$work/cut/build/quad/slider_crank/lock" true
check 'Ctrl-C in a compilation: no module' \
  test -z "$(find "$work/cut" -name '*.oct')"
