# Maxima on another Lisp (Debian's maxima-sage is built on ECL, maxima on GCL) derives the same
# text, byte by byte.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
one=${MAXIMA:-maxima}
other=maxima-sage
[ "$one" = maxima-sage ] && other=maxima
has $other 'the same text on two Lisps' || exit 0
emitted=$GSMBP_TEST_DIR/fortran_out
names='case_01a case_03a electric_arms fluid_hydraulic sampled_crank redundant_tilted orient_angles'
# a start that comes from numbers: where a beam sags
sagged() {
  echo "kill(scene, requests)\$ load(\"$PWD/tests/scenes/flexible_mounted.mac\")\$
    gsmbp_fortran(scene, [kinematics], ['directory = \"$work/$1\"])\$"
}
load="load(\"$PWD/gsmbp/gsmbp.mac\")\$"
statements="$load $(sagged $other)"
for name in $names; do   # in one session
  statements="$statements kill(scene, requests)\$ load(\"$PWD/tests/scenes/$name.mac\")\$
    gsmbp_fortran(scene, if listp(requests) then requests else all, ['directory = \"$work\"])\$"
done
MAXIMA=$other share/make/maxima "$work/fortran.log" "$statements"
told $? "$other derives" "$work/fortran.log"
for name in $names; do
  cmp "$emitted/$name.f" "$work/$name.f" && cmp "$emitted/$name.json" "$work/$name.json"
  told $? "$name: $one and $other derive the same"
done
share/make/maxima "$work/sagged.log" "$load $(sagged $one)" &&
  cmp "$work/$one/flexible_mounted.json" "$work/$other/flexible_mounted.json"
told $? "flexible_mounted: $one and $other have the same sagged start" "$work/sagged.log"

# -- in C, packages, the texts of an FMU
whole || exit 0
in_c="$load for name in [sampled_crank, orient_angles, event_crank] do (
  load(sconcat(\"$PWD/tests/scenes/\", name, \".mac\")),
  gsmbp_c(scene, [all, batch], ['directory = folder]))\$
  load(\"$PWD/tests/scenes/event_ball.mac\")\$
  for l in [c, python] do
    gsmbp_package(scene, l, all, ['directory = sconcat(folder, \"/\", l)])\$
  gs__write_in(gs__fmu_language(), 'gs__fmu_files, scene, [gs__fmu_requests(scene),
    ['directory = sconcat(folder, \"/fmu\")]])\$"
for lisp in $one $other; do
  MAXIMA=$lisp share/make/maxima "$work/$lisp.log" "folder : \"$work/$lisp\"\$ $in_c"
  told $? "$lisp derives C" "$work/$lisp.log"
done
diff -r "$work/$one" "$work/$other" >"$work/differ"
told $? "$one and $other derive the same C, packages and FMU" "$work/differ"
[ -s "$work/$one/python/src/event_ball/table.json" ] && [ -s "$work/$one/fmu/event_ball_fmi3.xml" ]
told $? 'the packages are there'
