# A routine is added by a row of gs__request_rows and its specification: tests/data/toy.diff does so
# in a copy (KEN, the kinetic energy alone); its handle in Octave, its prototype in C, its method
# and stub in Python are there by themselves.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out

cp -Rp gsmbp octave share "$work"
[ "$(grep -c '^diff' tests/data/toy.diff)" = 2 ] &&
  (cd "$work" && git apply "$root/tests/data/toy.diff") >"$report" 2>&1
told $? 'the diff of two files applies' "$report"
(cd "$work" && share/make/compile) >"$report" 2>&1
cp examples/slider_crank/slider_crank.mac "$work/toy.mac"
sed -i 's/"slider_crank"/"toy"/' "$work/toy.mac"
echo "requests : [kinetic, energy]\$" >>"$work/toy.mac"
(cd "$work" && share/make/derive toy.mac fortran_out) >"$report" 2>&1
told $? 'the routine is derived' "$report"
cat >"$work/toy.m" <<'A'
m = gsmbp_build ("toy");
q = [0.3; -0.2; 0.5]; u = [1; -2; 0.7];
e = m.ene (0, [q; u; 0.1]);
printf ("%d\n", abs (m.ken (0, q, u) - e(1)) <= 1e-14 * e(1) && e(1) > 0.1);
try
  m.ken (0, q);
catch problem
  printf ("%s\n", problem.message);
end
A
(cd "$work" && octave-cli -qf --path "$work/octave" toy.m) >"$work/said" 2>"$report"
sed 1q "$work/said" | grep -qx 1
told $? 'its handle gives the first of the energies' "$report"
grep -q 'toy.ken: argument u is missing; expected m.ken (t, q, u)' "$work/said"
told $? 'its handle says what it expects' "$work/said"

# C and Python: no line of theirs
whole || exit 0
(cd "$work" && share/make/maxima "$work/log" "load(\"gsmbp/gsmbp.mac\")\$ load(\"toy.mac\")\$
  gsmbp_c(scene, requests)\$ gsmbp_package(scene, python, directory = \"toy_python\")\$" &&
  cd toy_python && /usr/bin/python3 setup.py -q build_py -d ../module) >"$report" 2>&1
told $? 'C and a module of Python are made' "$report"
grep -qE '^(void|double|int)? *toy_ken \(' "$work"/fortran_out/toy.h
told $? 'its prototype is in the header' "$work/fortran_out/toy.h"
grep -q 'def ken(self, t: ' "$work"/module/toy/_routines.pyi
told $? 'its stub is in the module' "$work/module/toy/_routines.pyi"
PYTHONPATH=$work/module /usr/bin/python3 -c '
import toy, numpy
m = toy.Model()
q, u = [0.3, -0.2, 0.5], [1, -2, 0.7]
e = m.ene(0, numpy.concatenate([q, u, [0.1]]))
assert abs(m.ken(0, q, u) - e[0]) <= 1e-14 * e[0] and e[0] > 0.1
assert "kinetic" in toy.Model.ken.__doc__' >"$report" 2>&1
told $? 'its method gives the first of the energies' "$report"
