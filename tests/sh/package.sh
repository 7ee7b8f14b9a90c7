# make package: the same tree gives the same bytes; installed by pkg where nobody may write, it
# works from another folder with nothing else of the tree: pkg load, pkg test, a scene derived,
# compiled, run and reported, what was emitted in the current folder; doctest of the help texts.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
report=$work/out.txt
octave_run() {   # in the user's folder, with a home and packages of its own
  (cd "$work/user" && HOME=$work/home without_root_powers timeout 200 octave-cli -qf --no-history \
    --eval "pkg ('prefix', '$work/pkg', '$work/pkg'); pkg ('local_list', '$work/list');
      pkg ('global_list', '$work/all'); $1" \
    </dev/null) >"$report" 2>&1
}
says() { grep -q -- "$1" "$report"; }
mkdir "$work/home" "$work/user" "$work/tree"
# the packages of the system, in a list of its own: root installs for everybody
all=$(octave-cli -qf --eval 'printf ("%s", pkg ("global_list"))' 2>/dev/null)
[ ! -f "$all" ] || cp "$all" "$work/all"
version=$(sed -n 's/.*gsmbp_version, "\([^"]*\)".*/\1/p' gsmbp/kernel/version.mac)

# in copies of the tree: what lies there beside it does not count, nor do times, nor the umask
copy() {
  mkdir -p "$2" && (cd "$1" && tar -cf - --exclude=gsmbp/compiled/*/image \
    --exclude=share/package gsmbp octave share [C-M]*) | tar -xmf - -C "$2"
}
copy . "$work/tree/a" && copy . "$work/tree/b" && touch "$work"/tree/b/octave/*.m
make --no-print-directory -C "$work/tree/a" package >"$report" 2>&1
told $? 'make package' "$report"
(umask 077 && touch "$work/tree/b/octave/junk" && sleep 1.1 && make -C "$work/tree/b" package) \
  >"$report" 2>&1
file=share/package/gsmbp-$version.tar.gz
check 'the version of CITATION.cff is that of version.mac' \
  grep -qx "version: \"$version\"" CITATION.cff
check 'the same tree, the same bytes' cmp "$work/tree/a/$file" "$work/tree/b/$file"
mv "$work/tree/a/$file" "$work"
rm -rf "$work/tree"

# without its cache for lookfor, one call of makeinfo a function (their Texinfo: manual.sh)
octave_run "before = makeinfo_program ('true'); pkg ('install', '$work/${file##*/}');
  makeinfo_program (before); pkg ('describe', '-verbose', 'gsmbp');"
told $? 'pkg install' "$report"
check 'its version is that of version.mac' says "^[[:space:]]$version$"
ls octave/gsmbp_*.m | sed 's,.*/\(.*\)\.m,\1,' | while read -r name; do
  says "^[[:space:]]$name$" || echo "$name"
done >"$work/lost"
[ ! -s "$work/lost" ]; told $? 'every function is in the index of the package' "$work/lost"

chmod -R a-w "$work/pkg"
sums() { (cd "$work/pkg" && find . -type f | LC_ALL=C sort | xargs md5sum); }
sums >"$work/before"
# the blocks of every sixth function (make test-whole: of all, by pkg test)
sample=$(ls octave/gsmbp_*.m | sed 's,.*/\(.*\)\.m,\1,' | sed -n '3~6p' | tr '\n' ' ')
if [ -n "${GSMBP_WHOLE:-}" ]; then
  octave_run 'pkg load gsmbp; pkg test gsmbp'
  check 'pkg test gsmbp' says '^ *FAIL *0$'
  passed=$(sed -n 's/^ *PASS *//p' "$report")
  check "pkg test gsmbp: $passed blocks pass" test "${passed:-0}" -ge 90
else
  octave_run "pkg load gsmbp
    for name = strsplit (strtrim ('$sample'))
      [n, total] = test (name{1}, 'quiet'); printf ('%s: %d of %d\n', name{1}, n, total);
      if (n < total || total == 0) disp ('failed'); end
    end"
  check "blocks of $sample" fails says '^failed\|^error'
  check 'they ran' test "$(grep -c ': [1-9][0-9]* of ' "$report")" -eq "$(echo $sample | wc -w)"
fi

# a scene of the user's
mkdir "$work/user/examples" && cd "$work/user" || exit 1
for name in slider_crank puma560 spinning_top rotating_blade; do
  cp -R "$root/examples/$name" examples
done
mkdir elsewhere
octave_run 'pkg load gsmbp; scene = "examples/slider_crank/slider_crank.mac";
  gsmbp_derive (scene, "fortran_out");
  m = gsmbp_build ("slider_crank"); puts ([m.file "\n"]);
  r = gsmbp_simulate (m, m.initial, 0:0.1:0.5, "input", 12);
  gsmbp_report (m, r, "page.html", "scene", scene);'
told $? 'a scene is derived, compiled, run and reported' "$report"
check 'the module is below fortran_out of the current folder' \
  says "^$work/user/fortran_out/build/double/slider_crank/.*oct$"
check 'so is what Maxima emitted' test -s fortran_out/slider_crank.f
check 'Maxima wrote the page' grep -q 'id="drawing"' page.html
chmod a-w fortran_out fortran_out/build
octave_run 'cd elsewhere; pkg load gsmbp; m = gsmbp_build ("slider_crank", "directory", ...
  "../fortran_out"); puts ([m.file "\n"]);'
check 'Fortran in a folder where one must not write: modules go to the current folder' \
  says "^$work/user/elsewhere/fortran_out/build/double/slider_crank/.*oct$"
chmod u+w fortran_out fortran_out/build

cat >doctests.m <<'END'
functions = cellfun (@(part) part.functions, pkg ("describe", "gsmbp"){1}.provides, ...
                     "UniformOutput", false);
functions = [functions{:}];
if (! isempty (getenv ("SAMPLE")))
  functions = strsplit (strtrim (getenv ("SAMPLE")));
end
doctest (functions);
END
# those that build a scene which the manual's session has emitted before are typed by sessions_*.sh
export SAMPLE="$(cd "$root" && grep -LE 'gsmbp_build \("(pinned|swing|turret)"' octave/gsmbp_*.m |
  sed 's,.*/,,; s,\.m$,,' | { [ -n "${GSMBP_WHOLE:-}" ] && cat || grep -wF "$(echo $sample |
  tr ' ' '\n')"; } | tr '\n' ' ')"
if octave_run 'exit (isempty (pkg ("list", "doctest")));'; then
  octave_run 'pkg load gsmbp; pkg load doctest; doctests'
  n=$(echo $SAMPLE | wc -w)
  check "the examples of $n help texts pass doctest" says "^$n/$n targets passed, 0 without"
else
  echo 'ok left out without octave-doctest: the examples of the help texts in its form'
fi

sums | cmp -s - "$work/before"
told $? 'nothing is written into the installed package'
chmod -R u+w "$work/pkg"
octave_run 'pkg uninstall gsmbp; pkg list gsmbp'
find "$work/pkg" -type f >"$report"; result 'pkg uninstall leaves no file'
