# Designs of modules of Python beside those of Octave (tests/python: optimize.m, optimize.py): a
# lamp, a rotor, a ball with events, a crank, a four-bar; closed forms; choices, contradictions;
# refusals; Ctrl-C, timeout.
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
for name in ipopt nlopt; do
  if ! gcc -E "share/engine/host/$name/header_$name.h" >/dev/null 2>&1; then
    echo "ok left out without $name: designs of modules"
    exit 0
  fi
done
python_packages ', requests' design_lamp design_fourbar design_rotor sensitivity_bounce \
  sensitivity_crank
python_modules 'gsmbp_package(scene, python) of five scenes'
octave-cli -qf --no-history --path "$root/octave" --path "$root/tests/octave" \
  --path "$root/tests/python" --eval "optimize (\"$work/octave.json\")" >"$report" 2>&1
told $? 'optimize.m ends' "$report"
PYTHONPATH="$work" timeout 200 $python tests/python/optimize.py "$work/octave.json"
told $? 'optimize.py ends'
mv "$work/design_lamp/_nlopt.so" "$work/none.so"
PYTHONPATH="$work" $python -c 'import design_lamp as d
d.Model().optimize(("k", 50, (1, 99)), ("value", "k"), solver="slsqp")' 2>&1 |
  grep -q 'NLopt is not installed'
told $? 'a module without NLopt reports it'
PYTHONPATH="$work" $python -c 'import design_lamp as d
assert d.Model().optimize(("k", 50, (1, 99)), ("value", "k")).solver == "ipopt"'
told $? '... and solves by Ipopt'
