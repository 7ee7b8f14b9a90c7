# What gsmbp_tex writes, read back, has the values of gsmbp_equations: scenes with constraints of
# every kind (cut joints, motion laws, constraints, rolling, norms), devices, speeds of their own.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
names='written_names case_03a close_universal close_helical orient_free rolling_sleigh rolling_disc
  speeds_body driven_fourbar mech_joint mech_gyroscope electric_arms'
session="load(\"$PWD/gsmbp/gsmbp.mac\")\$ load(\"$PWD/tests/tools/printed.mac\")\$"
for name in $names; do
  session="$session load(\"$PWD/tests/scenes/$name.mac\")\$ printed(scene, \"$work/$name\")\$"
done
GSMBP_TIMEOUT=300 share/make/maxima "$work/log" "$session"
told $? 'the equations are written' "$work/log"
cd "$work" && "$OLDPWD/tests/tools/read_tex.py" $names
