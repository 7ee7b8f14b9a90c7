# gsmbp_package(scene, python): twelve scenes become modules; one is installed by pip as its README
# says, without network, its wheel is for every Python 3; what they compute is what the Fortran of
# the scene gives, bit for bit; runs, refusals, threads: tests/python/runs.py, many of them:
# tests/python/ensembles.py, by implicit methods: tests/python/implicit.py; where GSMBP_TIMES is
# set, how long 1e5 states take beside a loop in C.
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
scenes='tests/scenes/event_ball tests/scenes/sampled_crank tests/scenes/switch_circuit
  tests/scenes/stiff_loop tests/scenes/event_pulled
  examples/slider_crank/slider_crank examples/robot_joint/robot_joint
  examples/spinning_top/spinning_top tests/bench/systems/puma6'

# -- the folders, in one session; again: the same bytes
statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
for scene in $scenes; do
  statements="$statements kill(scene)\$ load(\"$root/$scene.mac\")\$
    gsmbp_package(scene, python, directory = \"$work/folders/${scene##*/}\")\$"
done
statements="$statements gsmbp_package(scene, python, ['directory = \"$work/again/puma6\"])\$"
for name in c run; do   # names that something else has as well
  sed "s/@name@/$name/" tests/data/rod.in >"$work/$name.mac"
  statements="$statements kill(scene)\$ load(\"$work/$name.mac\")\$
    gsmbp_package(scene, python, directory = \"$work/folders/$name\")\$"
done
sed 's/@name@/own_events/' tests/data/own_events.in >"$work/own_events.mac"
statements="$statements kill(scene)\$ load(\"$work/own_events.mac\")\$
  gsmbp_package(scene, python, directory = \"$work/folders/own_events\")\$"
share/make/maxima "$work/log" "$statements" >"$report" 2>&1
told $? 'gsmbp_package(scene, python) of twelve scenes' "$report"
check 'the same scene, the same bytes' diff -r "$work/folders/puma6" "$work/again/puma6"
grep -rlE "$root|$work" "$work/folders" >"$report"
result 'nothing of this machine is in them'

# -- installed as a stranger would, in an environment of its own without network
cp -R "$work/folders/slider_crank" "$work/installed"
chmod -R u+w "$work/installed"
(cd "$work" && $python -m venv --system-site-packages --without-pip environment &&
  unset PIP_FIND_LINKS PIP_INDEX_URL && cd installed &&
  PIP_NO_INDEX=1 ../environment/bin/python -m pip install -q --no-build-isolation .) \
  >"$report" 2>&1
told $? 'pip install --no-build-isolation of a folder' "$report"
check 'its wheel is for every Python 3 of the platform' \
  grep -q '^Tag: py3-none-linux_' "$work"/environment/lib/python3*/site-packages/*/WHEEL
(cd / && "$work/environment/bin/python" -c \
  'import slider_crank as s; m = s.Model(); m.simulate(m.initial, [0, 0.1])') >"$report" 2>&1
told $? 'it runs from elsewhere' "$report"
for stub in "$work"/environment/lib/python3*/site-packages/slider_crank/*.pyi; do
  $python -m py_compile "$stub" || echo "$stub"
done >"$report" 2>&1
result 'its stubs are Python'

# -- the others are built in place, quickly; one as where SUNDIALS is missing
echo exit 1 >"$work/folders/run/find_header"
build_modules
export PYTHONPATH="$work"

for name in c run; do
  (cd / && $python -c \
    "import $name; m = $name.Model(self=2.0); print(m.simulate(m.initial, [0, 0.1]))") \
    >"$report" 2>&1
  told $? "the scene $name, as another folder or file is called" "$report"
done
(cd / && $python -c 'import run
m = run.Model()
try:
    m.simulate(m.initial, [0, 0.1], method="cvode")
except ImportError as error:
    print(error)') >"$report" 2>&1
grep -q '^run.simulate: method "cvode" needs SUNDIALS 6 or 7, .*libsundials-dev' "$report"
told $? 'method cvode of a module that was built without SUNDIALS names the package' "$report"
$python -c 'import keyword, sys
taken = set(open("share/python/taken").read().split())
names = [*sys.stdlib_module_names, *keyword.kwlist]
print(*[n for n in names if n[0] != "_" and n not in taken])' |
  sed "/^$/d" >"$report"
result 'share/python/taken has all words and modules of this Python'

# -- every subroutine against the Fortran of the scene
fortran_objects "$work/fortran" >"$report" 2>&1
told $? 'share/fortran compiles' "$report"
for scene in tests/scenes/event_ball tests/scenes/sampled_crank \
  examples/slider_crank/slider_crank; do
  name=${scene##*/} out=$GSMBP_TEST_DIR/fortran_out
  [ -s "$out/$name.f" ] || { out=$work/fortran; share/make/derive "$scene.mac" "$out"; } \
    >"$report" 2>&1
  $fortran_apart -fPIC -shared -o "$work/fortran/$name.so" \
    "$out/$name.f" "$work"/fortran/*.o >"$report" 2>&1 &&
    timeout 100 $python tests/python/against_fortran.py "$name" "$work/fortran/$name.so"
  told $? "$name against its Fortran" "$report"
done

timeout 200 $python tests/python/runs.py
told $? 'runs.py ends'
timeout 200 $python tests/python/ensembles.py
told $? 'ensembles.py ends'
timeout 200 $python tests/python/implicit.py
told $? 'implicit.py ends'

# -- 1e5 states beside a loop in C, where times are asked for (make bench-c)
[ -n "${GSMBP_TIMES:-}" ] || exit 0
core=share/engine/core
gcc -std=c99 -O2 -ffp-contract=off -I$core -I"$work/folders/puma6/c/scene" -o "$work/loop" \
  tests/python/loop.c "$work/folders/puma6/c/scene/puma6.c" $core/*/*.c $core/*/*/*.c -lm \
  >"$report" 2>&1 && timeout 100 $python tests/python/speed.py "$work/loop"
told $? 'speed.py ends' "$report"
