# gsmbp_import with lenient = true: each liberty of a URDF file is refused without it, with a
# message that names the option, and read with it, with one warning that has its line; the
# equations are those of the file that is meant. Hostile files are refused all the same. Robots of
# one link.
. tests/tools/check.sh
root=$PWD
dir=$(mktemp -d "${GSMBP_TEST_DIR:-/tmp}/lenient.XXXXXX")
cp tests/data/r3_urdf/bad/*.urdf "$dir"
cd "$dir" || exit 1
session() {
  "$root/share/make/maxima" "$1" "load(\"$root/gsmbp/gsmbp.mac\")\$ $2\$" >/dev/null 2>&1
}
body() {
  printf '<inertial><mass value="%s"/><inertia ixx="%s" iyy="1" izz="1" ixy="0" ixz="%s" ' "$@"
  printf 'iyz="0"/>'
  printf '</inertial>'
}
# line VERSION, TYPE, XACRO, SECOND AXIS, RESIDUE, MIMIC, TIP: a robot with or without each liberty
robot() {
  printf '<?xml version="%s"?>%s\n<robot name="r" xmlns:x="u">\n%s\n<link name="base"/>\n' \
    "$1" "$2" "$3"
  printf '<link name="a">%s</link>\n<link name="b">%s</link>\n' "$(body 1 1 0)" "$(body 1 0 "$5")"
  printf '<link name="tip">%s</link>\n' "$7"
  printf '<joint name="j" type="continuous"><parent link="base"/><child link="a"/>%s%s</joint>\n' \
    '<axis xyz="0 0 1"/>' "$4"
  printf '<joint name="k" type="continuous"><parent link="a"/><child link="b"/>%s%s</joint>\n' \
    '<origin xyz="0.5 0 0"/><axis xyz="0 0 1"/>' "$6"
  printf '<joint name="l" type="continuous"><parent link="b"/><child link="tip"/>%s</joint>\n' \
    '<origin xyz="0.5 0 0"/><axis xyz="0 1 0"/>'
  echo '</robot>'
}
tip=$(body 1 1 0)
robot 0.0 '' '' '' 0 '' "$tip" >version.urdf
robot 1.0 '<!DOCTYPE robot SYSTEM "no>where.dtd">' '' '' 0 '' "$tip" >type.urdf
robot 1.0 '' '<xacro:property name="p" value="1"/>' '' 0 '' "$tip" >template.urdf
robot 1.0 '' '' '<axis xyz="0 1 0"/>' 0 '' "$tip" >axes.urdf
robot 1.0 '' '' '' 1e-35 '' "$tip" >residue.urdf
robot 1.0 '' '' '' 0 '<mimic joint="gone"/>' "$tip" >leader.urdf
robot 1.0 '' '' '' 0 '' '' >light.urdf
cat >liberties <<'END'
version line 1: XML version 0.0: expected 1.0
type line 1: a document type (DOCTYPE)
template line 3: element xacro:property: a template: run xacro on it first
axes line 8, joint "j": element axis stands there 2 times
residue line 6, link "b": inertia: no body has it
leader line 9, joint "k": mimic: expected a joint of the file, found "gone"
light link "*tip"*: .*
END
# by hand: moments of inertia about the axes of the joints, b at 0.5 m, the tip at 1 m
statements='M : matrix([0, 0, 0], [0, 0, 0], [0, 0, 0])'
while read -r name words; do
  statements="$statements\$ errcatch(gsmbp_import(\"$name.urdf\", directory = \".\"))\$
    s : gsmbp_import(\"$name.urdf\", name = \"$name\", lenient = true)\$
    printf(true, \"mass ~a ~a~%\", \"$name\",
      string(expand(subst([sq_k = 0, cq_k = 1, sq_l = 0, cq_l = 1], gsmbp_mass_matrix(s)))))"
done <liberties
session log "$statements"
while read -r name words; do
  grep "^gsmbp_import: $name.urdf: " log | grep "$words" | grep -q 'remedy:.*lenient = true'
  told $? "$name is refused, with the remedy" log
  [ "$(grep -c "^gsmbp_import: warning: $name.urdf: " log)" -eq 1 ] &&
    grep "^gsmbp_import: warning: $name.urdf: line [0-9]*[:,] " log | grep -q "$words" &&
    grep -q '^   lenient: line [0-9]' "$name.mac"
  told $? "$name is read with lenient = true, with one warning, its line, a note in the file" log
  mass='matrix([17/4,5/2,0],[5/2,9/4,0],[0,0,1])'
  [ "$name" != light ] ||
    mass='matrix([no_mass+9/4,no_mass/2+1,0],[no_mass/2+1,no_mass/4+1,0],[0,0,0])'
  grep -qF "mass $name $mass" log
  told $? "$name has the mass matrix of what is meant" log
done <liberties

# hostile files, and what no other program reads either
printf '<?xml version="1.0"?>\n<!DOCTYPE r [<!ENTITY e SYSTEM "%s/secret">]>\n%s\n' \
  "$dir" '<robot name="&e;"/>' >external.urdf
echo secret >secret
printf '<?xml version="1.0"?>\n<!DOCTYPE r SYSTEM "%s/r.dtd">\n<robot name="&e;"/>\n' "$dir" \
  >dtd.urdf
echo '<!ENTITY e "secret">' >r.dtd
printf '<!DOCTYPE r><!DOCTYPE r [<!ENTITY e "secret">]><robot name="&e;"/>\n' >second.urdf
iconv -f utf-8 -t utf-16 b01_entity_bomb.urdf >wide.urdf
robot 1.0 '' '' '' 0 '' "$(body '${m}' 1 0)" >value.urdf
robot 1.0 '' '' '' 0 '' "$(body 1 -0.01 0)" >negative.urdf
robot 1.0 '' '' '' 0.01 '' "$tip" >large.urdf
sed 's|<child link="a"/>|&<child link="b"/>|' axes.urdf >children.urdf
cat >verdicts <<'END'
b01_entity_bomb line 2: a document type
external line 2: a document type
second line 1: a document type
wide line 2: a document type
dtd Entity 'e' not defined
value run xacro on it first
negative inertia: no body has it
large inertia: no body has it
children element child stands there 2 times
b04_cycle form a cycle
b07_nan mass value: expected a finite decimal number
b11_names line 10, link: expected a name
END
statements='0'
while read -r name words; do
  statements="$statements\$
    errcatch(gsmbp_import(\"$name.urdf\", name = \"n_$name\", lenient = true))"
done <verdicts
session log "$statements"
while read -r name words; do
  grep "^gsmbp_import: $name.urdf: " log | grep -qF "$words" && [ ! -e "n_$name.mac" ]
  told $? "$name is refused with lenient = true, too: $words" log
done <verdicts
! grep -q '^secret' log
told $? 'nothing else is read' log

# one link: ground, or a free body; in a session that has bound a symbol of the file, twice
printf '<robot name="one"><link name="base">%s</link></robot>\n' "$(body 2 1 0)" |
  sed 's/ixx="1"/ixx="0.5"/' >one.urdf
session log 's : 3$ still : gsmbp_import("one.urdf", name = "still")$
  loose : gsmbp_import("one.urdf", name = "loose", root = free)$
  printf(true, "still ~a loose ~a s ~a ~a~%", length(gsmbp_coordinates(still)),
    string(gsmbp_mass_matrix(loose)), s, member('"'s"', values))'
grep -qF 'still 0 loose matrix([2,0,0,0,0,0],[0,2,0,0,0,0],[0,0,2,0,0,0],[0,0,0,1/2,0,0],'\
'[0,0,0,0,1,0],[0,0,0,0,0,1]) s 3 true' log
told $? 'one link: fixed to ground, or a free body; the session stays' log
grep -q 'root = free makes it a free body' still.mac
told $? 'the file says how a link becomes a free body' still.mac
