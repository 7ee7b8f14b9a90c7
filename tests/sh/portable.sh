# What keeps the program the same in other systems (make check-portable tries them): stable sorts,
# one way of writing a minus, Ubuntu's table of packages without a gap, a wrong syntax in one line.
. tests/tools/check.sh
work_folder

# GCL 2.7 sorts lists with equal keys in another order than GCL 2.6, SBCL and ECL
grep -rn "(sort " --include=*.lisp gsmbp >"$report"
result 'Lisp sorts by stable-sort'
# GCL 2.7.1 compiles inlined recursive functions wrongly
grep -rn "(labels " --include=*.lisp gsmbp | grep -v 'kernel/lists.lisp:.*`(labels' >"$report"
result 'local recursive functions are those of gs-rec'

# a minus in text binds with 100 in Maxima 5.46, with 134 in 5.47
cat >"$work/scene.mac" <<'M'
scene : gsmbp_scene("minus", link(a, mass = m0, inertia = [1, 1, 1]),
  prismatic(J, ground, a, axis = x, coordinate = q), output(y, b - c/2 - b*c*b_e),
  parameters = [m0 = 1*kg, b = 1, c = 2, b_e = 3])$
M
emit="load(\"$PWD/gsmbp/gsmbp.mac\")\$ load(\"$work/scene.mac\")\$
  for n in [100, 134] do (?putprop(?mminus, n, ?rbp),
    gsmbp_fortran(scene, [rhs, output], 'directory = sconcat(\"$work/\", n)))\$
  if ?get(?mminus, ?rbp) = 134 then printf(true, \"own again~%\")\$"
share/make/maxima "$work/log" "$emit"
told $? 'emitted with a minus of either kind' "$work/log"
diff -r "$work/100" "$work/134" >"$report"
result 'a minus that binds otherwise: the same Fortran and JSON'
report=$work/log
check 'how a minus binds in the session is as it was' grep -q '^own again' "$work/log"
check 'the text has such a minus' grep -q '"expression": ".*-' "$work/100/minus.json"

# GCL 2.7 takes a name with two slashes for none
report=$work/log
share/make/maxima "$work/log" "load(\"$PWD/gsmbp/gsmbp.mac\")\$ load(\"$work/scene.mac\")\$
  gsmbp_fortran(scene, [rhs], 'directory = \"$work//twice//\")\$
  gsmbp_package(scene, c, [rhs], 'directory = \"$work//package/\")\$"
told $? 'folders whose names have two slashes' "$work/log"
check 'their files are there' test -s "$work/twice/minus.f" -a -s "$work/package/minus.h"

# every package that is installed has its line in Ubuntu's table
share/make/packages list test manual pdf report screen mpi slurm fmu | tr ' ' '\n' | sort -u \
  >"$work/wanted"
sed '/^#/d; s/ .*//' tests/portable/ubuntu-24.04.txt | sort -u >"$work/known"
report=$work/report
diff "$work/wanted" "$work/known" >"$report"
result 'the table of packages of Ubuntu is that of share/make/packages'

# 5.47 writes file and place ahead of a wrong syntax
printf '%s\n' 'load("x")' "/tmp/a b/s.mac:1:122:incorrect syntax: Too many )'s" 'axis = z))' \
  '   ^' >"$work/new"
sed 's/^.*:incorrect/incorrect/' "$work/new" >"$work/before"
for log in new before; do
  check "a wrong syntax in one line, log $log" \
    test "$(share/make/error_in_log "$work/$log")" = "incorrect syntax: Too many )'s: axis = z))"
done
