# Loading GSMBP, and using it, changes no option, rule, operator or derivative of the user's session (tests/maxima/session.lisp tells).
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
  grep -q "^ *$what changes \[\]" "$work/log" && echo "ok $what changes nothing" || { echo "not ok $what changes nothing"; grep -A2 "changes \[" "$work/log"; }
done
