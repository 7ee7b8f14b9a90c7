# The entry that share/README.md shows works as it stands, and balances its power.
. tests/tools/check.sh
dir=$(mktemp -d "${GSMBP_TEST_DIR:-/tmp}/share.XXXXXX")
sed -n '/^```maxima$/,/^```$/p' share/README.md | sed '/^```/d' >"$dir/entry.mac"
sed -n '/^    coil : /,/;$\|\$$/p' share/README.md >"$dir/scene.mac"
share/make/maxima "$dir/log" "load(\"$PWD/gsmbp/gsmbp.mac\")\$
  load(\"$dir/entry.mac\")\$ load(\"$dir/scene.mac\")\$
  gs__check_entry(voice_coil, gs__entry(voice_coil))\$
  gsmbp_fortran(coil, all, ['directory = \"$dir\"])\$
  printf(true, \"mass ~a rates ~a~%\", gsmbp_mass_matrix(coil)[1,1],
    rhs(gsmbp_statespace(coil)[7]))\$" >/dev/null
[ -s "$dir/coil.f" ]; told $? 'the entry of share/README.md derives' "$dir/log"
grep -q 'mass V1_m+1/50 rates' "$dir/log"; told $? 'its mass is added' "$dir/log"
lines=$(wc -l <"$dir/entry.mac")
[ "$lines" -le 30 ]; told $? "it has $lines lines, at most 30 expected"

# the program that share/fortran/README.md shows, linked as it says
sed -n '/^```fortran$/,/^```$/p' share/fortran/README.md | sed '/^```/d' >"$dir/main.f"
sed -n '/^    gfortran /,/-lblas$/s/^    //p' share/fortran/README.md |
  sed "s|fortran_out/|$dir/|; s|main main.f|$dir/main $dir/main.f|" >"$dir/link.sh"
share/make/derive examples/puma560/puma560.mac "$dir" 2>"$dir/log" &&
  sh "$dir/link.sh" 2>"$dir/log" && "$dir/main" | grep -q '^ *0 *3[.]500420310463'
told $? 'a program of your own' "$dir/log"
