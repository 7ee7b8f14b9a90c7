# Modules for Python whose runs carry derivatives, and the adjoint (tests/python/derivatives.py):
# a pendulum against reference values, a closed chain, a digital controller, events.
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
for scene in case_d1a sensitivity_crank sensitivity_sampled sensitivity_bounce sensitivity_ball; do
  statements="$statements kill(scene, requests)\$ load(\"$root/tests/scenes/$scene.mac\")\$
    gsmbp_package(scene, python, requests, directory = \"$work/folders/$scene\")\$"
done
share/make/maxima "$work/log" "$statements" >"$report" 2>&1
told $? 'gsmbp_package(scene, python, [all, adjoint, sensitivity]) of five scenes' "$report"
for folder in "$work"/folders/*; do
  name=${folder##*/}
  sed -i 's/-O2/-O0/' "$folder/setup.py"
  (cd "$folder" && $python setup.py -q build_py -d built && mv "built/$name" "$work/$name") \
    >"$report" 2>&1 || told 1 "$name builds" "$report"
done
export PYTHONPATH="$work"
timeout 200 $python tests/python/derivatives.py tests/data/D1a_pendulum/reference.json
told $? 'derivatives.py ends'
for stub in "$work"/*/__init__.pyi; do
  $python -m py_compile "$stub" || echo "$stub"
done >"$report" 2>&1
result 'their stubs are Python'
