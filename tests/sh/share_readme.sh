# The entry that share/README.md shows works as it stands, and balances its power.
dir=$(mktemp -d "${GSMBP_TEST_DIR:-/tmp}/share.XXXXXX")
sed -n '/^```maxima$/,/^```$/p' share/README.md | sed '/^```/d' >"$dir/entry.mac"
sed -n '/^    coil : /,/;$\|\$$/p' share/README.md >"$dir/scene.mac"
share/make/maxima "$dir/log" "load(\"$PWD/gsmbp/gsmbp.mac\")\$ load(\"$dir/entry.mac\")\$ load(\"$dir/scene.mac\")\$ gsmbp__check_entry(voice_coil, gsmbp__entry(voice_coil))\$
  gsmbp_fortran(coil, all, ['directory = \"$dir\"])\$ printf(true, \"mass ~a rates ~a~%\", gsmbp_mass_matrix(coil)[1,1], rhs(gsmbp_statespace(coil)[7]))\$" >/dev/null
[ -s "$dir/coil.f" ] && echo 'ok the entry of share/README.md derives' || { echo 'not ok the entry of share/README.md derives'; tail -20 "$dir/log"; }
grep -q 'mass V1_m+1/50 rates' "$dir/log" && echo 'ok its mass is added' || { echo 'not ok its mass is added'; tail -5 "$dir/log"; }
lines=$(wc -l <"$dir/entry.mac")
[ "$lines" -le 30 ] && echo "ok it has $lines lines" || echo "not ok it has $lines lines, at most 30 expected"
