# Loading GSMBP, and using it, changes no option, rule, operator or derivative of the user's session
# (tests/maxima/session.lisp tells).
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
share/make/maxima "$work/log" "
load(\"tests/maxima/session.lisp\")\$
printf(false, \"~a\", 1)\$ /* stringproc sets a few variables of its own when it loads */
snapshot : session_snapshot()\$
load(\"gsmbp/gsmbp.mac\")\$
sconcat(\"loading changes \", session_changes(snapshot));
load(\"tests/scenes/case_03a.mac\")\$
gsmbp_equations(scene)\$
gsmbp_linear(scene)\$
gsmbp_fortran(scene, all, ['directory = \"$work\"])\$
kill(scene)\$
sconcat(\"using changes \", session_changes(snapshot));
errcatch(gsmbp_scene(\"bad\", link(a, mas = 1)))\$
sconcat(\"an error changes \", session_changes(snapshot));
" || exit 1
for what in loading using 'an error'; do
  grep -q "^ *$what changes \[\]" "$work/log"; told $? "$what changes nothing" "$work/log"
done

# nor does what the session holds change the result: functions with names that a careless program
# would call by
for name in case_03a case_02a_motor; do
  share/make/maxima "$work/log" "
    f(x) := x^2\$ g([x]) := 7\$ h(x) := error(\"mine\")\$ value(x) := 7\$ key(x) := 7\$
    test(x) := 7\$ draft(x) := 7\$ way(x) := 7\$ rate(x) := 7\$
    load(\"gsmbp/gsmbp.mac\")\$ load(\"tests/scenes/$name.mac\")\$
    gsmbp_fortran(scene, all, ['directory = \"$work\"])\$" &&
    cmp "$GSMBP_TEST_DIR/fortran_out/$name.f" "$work/$name.f"
  told $? "$name: functions of the session do not matter"
done
