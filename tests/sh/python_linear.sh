# Linear models, equilibria, modes and inverse kinematics of modules of Python beside those of
# Octave (tests/python: linear.m, linear.py): arms, a four-bar, a motor, a hydraulic cylinder,
# discs, a free body; refusals.
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
python_packages '' control_arm case_03a case_02a_motor trim_hydraulic steady_disc modes_arm \
  orient_free
python_packages ', requests' reach_puma reach_crank reach_seven
python_modules 'gsmbp_package(scene, python) of ten scenes'
octave-cli -qf --no-history --path "$root/octave" --path "$root/tests/octave" \
  --path "$root/tests/python" --eval "linear (\"$work/octave.json\")" >"$report" 2>&1
told $? 'linear.m ends' "$report"
PYTHONPATH="$work" timeout 200 $python tests/python/linear.py "$work/octave.json"
told $? 'linear.py ends'
stubs_are_python
