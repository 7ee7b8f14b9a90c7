# gsmbp_import: the scene files of tests/scenes byte for byte; hostile and wrong URDF files: one
# error that names line and element, nothing written, nothing else read, nothing executed, in no
# time.
. tests/tools/check.sh
root=$PWD
dir=$(mktemp -d "${GSMBP_TEST_DIR:-/tmp}/urdf.XXXXXX")
mkdir "$dir/out"
cp tests/data/r3_urdf/bad/*.urdf "$dir"
cd "$dir" || exit 1
session() {
  "$root/share/make/maxima" "$1" "load(\"$root/gsmbp/gsmbp.mac\")\$ $2\$" >/dev/null 2>&1
}

# what is imported is what the scenes of the tests are
statements=
for name in origins fixed tilted mimic floating; do
  statements="$statements gsmbp_import(\"$root/tests/data/r3_urdf/$name/model.urdf\",
    directory = \"out\", name = \"urdf_$name\")\$"
done
session log "$statements gsmbp_import(\"$root/tests/data/r3_urdf/fixed/model.urdf\", fixed = merge,
    directory = \"out\", name = \"urdf_merged\")"
told $? 'five robots are imported' log
for name in origins fixed tilted mimic floating merged; do
  cmp -s "out/urdf_$name.mac" "$root/tests/scenes/urdf_$name.mac"
  told $? "urdf_$name.mac as it is in tests/scenes" log
done

# each bad file, and words that its error must hold
one='<link name="base"/><link name="a"/>'
limit='<limit effort="1" velocity="1"/>'
joint() {
  printf '<joint name="j" type="%s"><parent link="base"/><child link="a"/>%s</joint>' "$1" "$2"
}
robot() { printf '<?xml version="1.0"?>\n<robot name="r">\n%s\n</robot>\n' "$*"; }
echo secret >secret
printf '<?xml version="1.0"?>\n<!DOCTYPE r [<!ENTITY e SYSTEM "%s/secret">]>\n%s\n' \
  "$dir" '<robot name="&e;"/>' >b02_external.urdf
iconv -f utf-8 -t utf-16 b01_entity_bomb.urdf >b01_wide.urdf
head -c 100000000 /dev/zero | tr '\0' ' ' >b03_large.urdf
robot "$one" '<link name="a"/>' "$(joint fixed '')" >b05_twice.urdf
robot "$one" >b06_roots.urdf
robot "$one" "$(joint revolute "$limit<axis xyz='0 0 0'/>")" >b08_axis.urdf
robot "$one" "$(joint revolute '')" >b09_limit.urdf
robot "$one" "$(joint hinge '')" >b10_type.urdf
robot '<link name="base"/><link name="a"><inertial><mass value="-1"/><inertia ixx="1" iyy="1"
  izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>' "$(joint fixed '')" >b12_mass.urdf
robot '<link name="base"/><link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1"
  izz="1" ixy="3" ixz="0" iyz="0"/></inertial></link>' "$(joint fixed '')" >b13_inertia.urdf
robot "$one" "$(joint continuous '<mimic joint="j"/>')" >b14_ring.urdf
robot "$one" "$(joint continuous '<origin xyz="1 2"/>')" >b15_two.urdf
robot "$one" '<xacro:arm/>' "$(joint fixed '')" >b16_template.urdf
robot "$one" "$(joint continuous '<origin xyz="${l} 0 0"/>')" >b17_template.urdf
robot "$one" "$(joint continuous '<origin xyz="1e999999999 0 0"/>')" >b18_power.urdf
robot "$one" "$(joint continuous '<parent link="c"/>')" >b19_parents.urdf
printf '<robot name="r"><link name="a">\n</robot>\n' >b20_open.urdf
: >b21_empty.urdf
awk 'BEGIN { for (i = 0; i < 11000; i++) printf "<a>" }' >b22_deep.urdf
awk 'BEGIN { print "<robot name=\"r\">"; for (i = 0; i < 500000; i++) printf "<link name=\"a\"/>"
  print "</robot>" }' >b23_many.urdf
awk 'BEGIN { print "<robot name=\"r\">"; for (i = 0; i < 11000; i++) printf "<link name=\"a\"/>"
  print "</robot>" }' >b24_links.urdf
awk 'BEGIN { printf "<robot name=\"r\"><link name=\"a\""
  for (i = 0; i < 500000; i++) printf " a%d=\"\"", i
  print "/></robot>" }' >b25_attributes.urdf
awk 'BEGIN { print "<robot name=\"r\"><link name=\"l0\"/>"; for (i = 1; i < 400; i++) {
    printf "<link name=\"l%d\"/><joint name=\"j%d\" type=\"continuous\"><mimic joint=\"j%d\"/>",
      i, i, i % 399 + 1
    printf "<parent link=\"l%d\"/><child link=\"l%d\"/></joint>\n", i - 1, i }
  print "</robot>" }' >b26_followers.urdf
cat >verdicts <<'END'
b01_entity_bomb line 2: a document type
b01_wide line 2: a document type
b02_external line 2: a document type
b03_large expected at most 10 MB
b04_cycle links "a", "b" form a cycle and hang on no root: joints "j1" (line 8), "j2" (line 9)
b05_twice line 3, link "a": a link of this name is on line 3, too
b06_roots expected one tree of links, found 2 roots: "base", "a"
b07_nan line 4, link "a": mass value: expected a finite decimal number, found "nan"; line 7
b08_axis line 3, joint "j": axis: expected a direction
b09_limit line 3, joint "j": expected the element limit
b10_type line 3, joint "j": type: expected one of revolute
b11_names line 10, link: expected a name
b12_mass line 3, link "a": mass: expected a number that is not negative
b13_inertia line 3, link "a": inertia: no body has it
b14_ring line 3, joint "j": mimic: joints follow each other in a ring: "j", "j"
b15_two line 3, joint "j": origin xyz: expected 3 numbers, found 2
b16_template element xacro:arm: a template
b17_template run xacro on it first
b18_power origin xyz: expected finite decimal numbers, found "1e999999999"
b19_parents element parent stands there 2 times
b20_open line 2: Opening and ending tag mismatch
b21_empty the file is empty
b22_deep line 1: Excessive depth
b23_many expected at most 12000 elements, found more
b24_links line 1: expected at most 500 elements link, found 11000
b25_attributes line 1: expected at most 1000 attributes of an element
b26_followers line 2, joint "j1": mimic: joints follow each other in a ring: "j1", "j2"
END
statements="t0 : elapsed_real_time()"
while read -r name words; do
  statements="$statements\$ errcatch(gsmbp_import(\"$name.urdf\", directory = \"out\"))"
done <verdicts
ls out >before
session log "$statements\$ printf(true, \"seconds ~,2f~%\", elapsed_real_time() - t0)"
while read -r name words; do
  grep -F "gsmbp_import: $name.urdf: " log | grep -qF "$words"
  told $? "$name: $words" log
done <verdicts
ls out | cmp -s - before && [ ! -e owned ] && ! grep -q '^secret' log
told $? 'nothing is written, executed or read' log
awk '/^seconds/ { exit !($2 < 27) } END { if (!NR) exit 1 }' log
told $? "$(grep '^seconds' log) for all, less than one for each expected" log

# hostile names that can be renamed: all distinct, and the scene is loaded
sed '/<link name=""/d; /link=""/d' b11_names.urdf >renamed.urdf
grep -q 'link=""' renamed.urdf && echo 'not ok b11 without its empty name'
session log 'errcatch(gsmbp_import("renamed.urdf", directory = "out", name = "renamed"))'
[ -s out/renamed.mac ] && [ ! -e owned ] && grep -q 'u00e9_u4e2d' out/renamed.mac
told $? 'hostile names are renamed, with a table' log

# values that the session has given to symbols of the file are the session's alone
sed 's/"origins"/"s"/' "$root/tests/data/r3_urdf/origins/model.urdf" >values.urdf
session log "s : 3\$ g : [1]\$ kg : 5\$ m : x\$ x : 2\$ scene : 7\$
  imported : gsmbp_import(\"values.urdf\", directory = \"out\", name = \"with_values\")\$
  if [s, g, kg, m, x, scene] # [3, [1], 5, 'x, 2, 7] then error(\"values are lost\")\$
  kill(s, g, kg, m, x)\$ load(\"out/with_values.mac\")\$
  if gsmbp_parameters(scene) # gsmbp_parameters(imported)
      or gsmbp_coordinates(scene) # gsmbp_coordinates(imported) then error(\"another robot\")"
told $? 'a robot is imported where the session has bound its symbols' log

# what is exported and imported again is exported as before
statements=
for name in origins fixed tilted mimic floating; do
  statements="$statements load(\"$root/tests/scenes/urdf_$name.mac\")\$
    gsmbp_export(scene, \"$name.1.urdf\")\$ kill(scene)\$
    gsmbp_export(gsmbp_import(\"$name.1.urdf\", directory = \".\", name = \"urdf_$name\"),
      \"$name.2.urdf\")\$"
done
session log "$statements load(\"$root/examples/four_bar/four_bar.mac\")\$
  printf(true, \"~{~a~%~}\", gsmbp_export(scene, \"bar.urdf\"))"
told $? 'six scenes are exported' log
for name in origins fixed tilted mimic floating; do
  cmp -s "$name.1.urdf" "$name.2.urdf" && [ -s "$name.2.urdf" ]
  told $? "$name: exported, imported, exported again" log
done
grep -q '^joint .*, which closes a loop' log && grep -q 'left out: joint' bar.urdf
told $? 'what a URDF cannot hold is said' log

# limits and stops are intersected, frictions added; the rest of a scene is told
statements="gsmbp_export(gsmbp_scene(\"rich\",
    link(a, mass = 1, inertia = [1, 1, 1]), link(b, mass = 1, inertia = [1, 1, 1]),
    revolute(J, ground, a, axis = z, coordinate = q1, limits = [-1, 1], start = 0.1,
      friction = 0.5),
    universal(K, a, b, axis = x, second_axis = y, coordinates = [q2, q3],
      limits = [[-1, 1], [-2, 2]]),
    stop(s, joint = J, lo = -2, hi = 0.5), friction(f1, joint = J, Fc = 0.5, Fv = 2),
    friction(f2, joint = J, Fc = 1, Fv = 4), point(tip, b), input(u, unit = N),
    force(F, tip, vector = [u, 0, 0]), output(y, q1),
    link(c, mass = 1, inertia = [1, 1, 1]), revolute(L, b, c, axis = z, coordinate = q4),
    constraint(c1, q4 = q1), constraint(c2, q4 = 2*q1)), \"rich.urdf\")"
session log "$statements"
for words in 'lower="-1" upper="0.5"' 'damping="6.5" friction="1.5"' 'left out: point tip' \
  'left out: input u' 'left out: output y' 'left out: force F' 'left out: start of joint J' \
  'left out: limits of joint K' 'left out: constraint c2'; do
  grep -qF "$words" rich.urdf
  told $? "exported: $words" rich.urdf
done
! grep -q 'left out: gravity' rich.urdf && ! grep -q 'left out: constraint c1' rich.urdf
told $? 'no gravity where there is none, the first of two followings is kept' rich.urdf

# limits that leave no room, with stops asked for
robot '<link name="base"/><link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1"
  izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>' \
  "$(joint revolute '<limit lower="1" upper="1" effort="1" velocity="1"/>')" >room.urdf
session log 'gsmbp_import("room.urdf", directory = "out", name = "room",
  stops = true)'
[ -s out/room.mac ] && ! grep -q 'stop(' out/room.mac && grep -q 'leave it no room' out/room.mac
told $? 'limits that leave no room make no stop, and are told' log
! grep -q 'limits = ' out/room.mac && grep -q 'limits 1 to 1 rad are left out' out/room.mac
told $? 'nor are they limits of the scene' log

# rounding of the file: as typed, or with `snap` the angle, the place and the axis that are meant
body='<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
  </inertial>'
robot "<link name=\"base\"/><link name=\"a\">$body</link>" "$(joint continuous \
  '<origin xyz="5.5e-17 1 0.25" rpy="1.5708 -1e-15 3e-9"/><axis xyz="1 0 2e-16"/>')" >round.urdf
session log 'gsmbp_import("round.urdf", directory = "out", name = "typed")$
  gsmbp_import("round.urdf", directory = "out", name = "snapped", snap = 1e-4)'
grep -q '\[z, 3e-9\], \[y, -1e-15\], \[x, 1.5708\]' out/typed.mac &&
  grep -q 'at = \[5.5e-17, 1, 0.25\]' out/typed.mac
told $? 'angles and places as typed' out/typed.mac
grep -q 'at = \[0, 1, 0.25\]\*m, rotation = \[x, %pi/2\], axis = x,' out/snapped.mac &&
  grep -q 'the number 5.5e-17 is taken as 0' out/snapped.mac &&
  grep -q 'the angle 3e-9 is taken as 0' out/snapped.mac
told $? 'snapped angles, places and axes, with a note of each' out/snapped.mac

# limits of position and effort come back as they were; a follower that starts outside of its own
robot '<link name="base"/><link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1"
  izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link><link name="b"><inertial><mass value="1"/>
  <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>' \
  "$(joint revolute '<limit lower="-1.5" upper="0.75" effort="12.5" velocity="1"/>')" \
  '<joint name="k" type="prismatic"><parent link="a"/><child link="b"/>
  <limit lower="0" upper="0.25" effort="8" velocity="1"/><mimic joint="j" offset="0.5"/></joint>' \
  >kept.urdf
session log 'gsmbp_export(gsmbp_import("kept.urdf", directory = "out", name = "kept",
  drives = true), "kept.1.urdf")'
grep -q 'lower="-1.5" upper="0.75" effort="12.5"' kept.1.urdf
told $? 'limits of position and effort, imported and exported' kept.1.urdf
grep -q 'joint "*k"*: limits 0 to 0.25 m are left out: they do not hold its start' out/kept.mac
told $? 'limits that do not hold the start are told' out/kept.mac

# the welding arm of the examples is what is imported, and more
session log "gsmbp_import(\"$root/examples/welding_arm/welding_arm.urdf\", directory = \"out\")"
own=$root/examples/welding_arm/welding_arm.mac
diff out/welding_arm.mac "$own" | grep '^<' >missing
[ -s out/welding_arm.mac ] && printf '<   parameters = [g = 9.81*m/s^2])$\n' | cmp -s - missing
told $? 'the scene of the welding arm is its URDF, with lines added' missing
