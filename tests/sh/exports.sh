# A package of Python and an FMU, one small scene each, against closed forms (for make check; at
# length: python.sh, fmu.sh).
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
sed 's/@name@/swing/' tests/data/rod.in >"$work/swing.mac"
share/make/maxima "$work/log" "load(\"$root/gsmbp/gsmbp.mac\")\$ load(\"$work/swing.mac\")\$
  gsmbp_package(scene, python, directory = \"$work/package\")\$" >"$report" 2>&1 &&
  (cd "$work/package" && $python setup.py -q build_py -d "$work/built") >"$report" 2>&1
told $? 'gsmbp_package(scene, python) of a rod is built' "$report"
# the elliptic integral by the arithmetic-geometric mean
PYTHONPATH=$work/built $python - <<'END'
import math
import swing
model = swing.Model(self=2.0)
a, b = 1.0, math.cos(0.25)
for _ in range(6):
    a, b = (a + b)/2, math.sqrt(a*b)
half = math.pi/math.sqrt(1.5*9.81/0.5)/a
found = model.simulate([0.5, 0], [0, half]).x[:, 1]
off = max(abs(found[0] + 0.5), abs(found[1]))
print(f'{"ok" if off < 1e-8 else "not ok"} it swings to the other side in half a period: '
      f'{off:.1e} (at most 1e-08)')
END
told $? 'the module runs'

has_all FMUs zip unzip || exit 0
share/fmu/derive tests/scenes/switch_circuit.mac "$work/fmu" >"$report" 2>&1 &&
  unzip -q "$work/fmu/switch_circuit_fmi2.fmu" -d "$work/switch" >"$report" 2>&1
told $? 'switch_circuit becomes FMUs' "$report"
$python tests/fmu/switch.py "$work/switch"
told $? 'the FMU runs'
