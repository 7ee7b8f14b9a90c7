# gsmbp_fmu: a closed chain with ports that stick and hit a stop, events of the user, a sampled
# device (make test-whole), a cylinder:
# the archives are whole and the same twice, binaries export the functions of the standard and need
# libc and libm, the sources give the same bits whatever the order of calls, wrong calls are errors
# with a log line under the address sanitizer, also with a decimal comma. FMPy is in make check-fmu.
. tests/tools/check.sh
work_folder
has_all FMUs zip unzip || exit 0

share/fmu/derive tests/scenes/switch_circuit.mac "$work/fmu" >"$report" 2>&1
told $? 'switch_circuit becomes FMUs' "$report"
unzip -q -o "$work/fmu/switch_circuit_fmi2.fmu" -d "$work/switch"
to_the_end python3 tests/fmu/switch.py "$work/switch"
for scene in event_crank $(whole && echo sampled_drive); do
  share/fmu/derive tests/scenes/$scene.mac "$work/fmu" >"$report" 2>&1
  told $? "$scene becomes FMUs" "$report"
  tests/fmu/binaries "$work/fmu" $scene
  tests/fmu/drive "$work/fmu" $scene 0.4 40
done
# events of the user: reset and stop, switch, closed loops, samples
for scene in user_bounce user_thermostat user_crank event_instant; do
  share/fmu/derive tests/scenes/$scene.mac "$work/fmu" >"$report" 2>&1
  told $? "$scene becomes FMUs" "$report"
  for standard in 2 3; do
    unzip -q -o "$work/fmu/${scene}_fmi$standard.fmu" -d "$work/$scene$standard"
    to_the_end python3 tests/fmu/events.py $scene "$work/$scene$standard" $standard
  done
done
tests/fmu/drive "$work/fmu" user_bounce 0.4 40
whole && tests/fmu/drive "$work/fmu" user_crank 0.4 40
# margins: pressures and the stroke of a cylinder
cat >"$work/press.mac" <<'END'
scene : gsmbp_scene("press", link(ram, mass = 20*kg),
  prismatic(guide, ground, ram, axis = x, coordinate = s, start = 0.3*m),
  hydraulic_cylinder(cyl, joint = guide, l0 = 0.1*m, h = 0.5*m))$
END
if whole; then
  share/fmu/derive "$work/press.mac" "$work/fmu" >"$report" 2>&1
  told $? 'press becomes FMUs' "$report"
  tests/fmu/drive "$work/fmu" press 0.01 0 0
fi
# the rod is driven out of its stroke, back and out at the other end
cat >"$work/stroke.mac" <<'END'
scene : gsmbp_scene("stroke", link(ram, mass = 100*kg),
  prismatic(guide, ground, ram, axis = x, coordinate = s, start = 0.3*m), input(opening, unit = 1),
  hydraulic_cylinder(cyl, joint = guide, variant = static, u = opening))$
END
share/fmu/derive "$work/stroke.mac" "$work/fmu" >"$report" 2>&1
told $? 'stroke becomes FMUs' "$report"
tests/fmu/drive "$work/fmu" stroke 0.98 -1 0.001 | tee "$work/said"
grep -v ': 2 margins' "$work/said" >"$report"
result 'they are the two ends of the stroke'
tests/fmu/drive "$work/fmu" stroke 0.98 -1 0.003 | sed 's/not ok/said/' >"$work/said"
grep -v 'outside a margin: cyl: piston within its stroke, rod out' "$work/said" >"$report"
[ -s "$work/said" ] || echo 'nothing was said' >>"$report"
result 'a run that ends far beyond its stroke says so'
# a name that a file of all FMUs has, too; capitals
for scene in step $(whole && echo Fmi2 fmi2); do
  sed "s/@name@/$scene/" tests/data/rod.in >"$work/$scene.mac"
  share/fmu/derive "$work/$scene.mac" "$work/fmu" >"$report" 2>&1
  told $? "$scene becomes FMUs" "$report"
  tests/fmu/drive "$work/fmu" $scene 0.2 5
done
# what killed runs left is not used: objects of another scene, where they were once and are now
echo 'int another;' >"$work/another.c"
for left in step_fmu .new-99999999-step_fmu; do
  mkdir -p "$work/again/$left/linux"
  gcc -c -o "$work/again/$left/linux/step.c.o" "$work/another.c"
done
GSMBP_CACHE=none share/fmu/derive "$work/step.mac" "$work/again" >/dev/null 2>&1
rm -rf "$work/again/step_fmu"
for standard in 2 3; do
  cmp "$work/fmu/step_fmi$standard.fmu" "$work/again/step_fmi$standard.fmu"
done >"$report" 2>&1
result 'the same scene gives the same archives, without the cache of objects'
ls -A "$work/again" | grep -v -e '\.fmu$' -e '\.log$' >"$report"
result 'nothing is left beside the archives'
for standard in 2 3; do
  unzip -p "$work/fmu/event_crank_fmi$standard.fmu" modelDescription.xml >"$work/said.xml"
  /usr/bin/python3 -c 'import sys, xml.etree.ElementTree as e; e.parse(sys.argv[1])' \
    "$work/said.xml"
  grep -q 'name="S.mode"' "$work/said.xml" || echo 'no mode of the stop'
  grep -q 'unit="N\*m"' "$work/said.xml" || echo 'no unit of the input'
done >"$report" 2>&1
result 'the descriptions are XML with modes and units'
# a full disk; the folder of the binary is that of the machine for which gcc compiles
mkdir "$work/small" "$work/arm" "$work/gcc"
if mount -t tmpfs -o size=300k tmpfs "$work/small" 2>/dev/null; then
  share/fmu/derive "$work/step.mac" "$work/small" 2>"$work/error" && echo 'it succeeds' >"$report"
  grep -q 'derive: .*step.mac: gsmbp_fmu: ' "$work/error" || cat "$work/error" >>"$report"
  ls -A "$work/small" | grep -v '\.log$' >>"$report"
  umount "$work/small"
  result 'on a full disk there is an error, no archive and no part of one'
fi
printf '#!/bin/sh\n[ "$1" = -dumpmachine ] && echo aarch64-linux-gnu && exit\nexec %s "$@"\n' \
  "$(PATH=$plain_path command -v gcc)" >"$work/gcc/gcc"
chmod +x "$work/gcc/gcc"
PATH=$work/gcc:$plain_path \
  share/fmu/derive "$work/step.mac" "$work/arm" >"$report" 2>&1
for standard in 2 3; do
  unzip -l "$work/arm/step_fmi$standard.fmu" | grep -q ' binaries/aarch64-linux/step.so$' ||
    echo "not in version $standard"
done >"$report" 2>&1
result 'a compiler for ARM64 makes a binary in the folder of ARM64'
PATH=$work share/fmu/build 2>/dev/null
mkdir "$work/bare" "$work/empty"
ln -s /bin/* /usr/bin/* "$work/bare" 2>/dev/null
rm -f "$work/bare/zip" "$work"/bare/*mingw*
PATH=$work/bare share/fmu/derive "$work/step.mac" "$work/empty" 2>"$work/error"
grep -q 'the program zip is missing' "$work/error" || cat "$work/error"
ls "$work/empty" | grep fmu$
result 'without zip there is an error and no archive' >"$report"
