# Linear models, equilibria, modes and inverse kinematics of modules of Python beside those of
# Octave (tests/python: linear.m, linear.py): arms, a four-bar, a motor, a hydraulic cylinder,
# discs, a free body; refusals.
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
for scene in control_arm case_03a case_02a_motor trim_hydraulic steady_disc modes_arm \
  orient_free; do
  statements="$statements kill(scene, requests)\$ load(\"$root/tests/scenes/$scene.mac\")\$
    gsmbp_package(scene, python, directory = \"$work/folders/$scene\")\$"
done
for scene in reach_puma reach_crank reach_seven; do
  statements="$statements kill(scene, requests)\$ load(\"$root/tests/scenes/$scene.mac\")\$
    gsmbp_package(scene, python, requests, directory = \"$work/folders/$scene\")\$"
done
share/make/maxima "$work/log" "$statements" >"$report" 2>&1
told $? 'gsmbp_package(scene, python) of ten scenes' "$report"
for folder in "$work"/folders/*; do
  name=${folder##*/}
  sed -i 's/-O2/-O0/' "$folder/setup.py"
  (cd "$folder" && $python setup.py -q build_py -d built && mv "built/$name" "$work/$name") \
    >"$report" 2>&1 || told 1 "$name builds" "$report"
done
octave-cli -qf --no-history --path "$root/octave" --path "$root/tests/octave" \
  --path "$root/tests/python" --eval "linear (\"$work/octave.json\")" >"$report" 2>&1
told $? 'linear.m ends' "$report"
PYTHONPATH="$work" timeout 200 $python tests/python/linear.py "$work/octave.json"
told $? 'linear.py ends'
for stub in "$work"/*/__init__.pyi; do
  $python -m py_compile "$stub" || echo "$stub"
done >"$report" 2>&1
result 'their stubs are Python'
