# make install in a fresh home: load("gsmbp") works by name, from any folder, with the actuator
# library and the Fortran run time in place; what is installed may be read-only, what is emitted
# goes to the current folder, in Maxima and in Octave. make uninstall takes away what was installed,
# and nothing else.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
report=$work/out.txt
make_() { make -C "$root" --no-print-directory "$@" >"$report" 2>&1; }
says() { grep -qF -- "$1" "$report"; }
session() {
  cd "$work/user" && without_root_powers timeout 60 maxima --very-quiet \
    --userdir="$work/.maxima" --batch-string="$1" </dev/null >"$report" 2>&1 &&
    grep -q "$2" "$report"
}
listing() { (cd "$1" && find . ! -name out.txt | LC_ALL=C sort); }
mkdir "$work/user"
listing "$work" >"$work.before"

check 'make install' make_ install HOME="$work" MAXIMA_USERDIR="$work/.maxima"
check 'it says what to type in Maxima' says 'Maxima: load("gsmbp")$'
told_octave=$(sed -n 's/^Octave: //p' "$report")
check 'and in Octave' test "$told_octave" = "addpath (\"$work/.maxima/gsmbp-files/octave\")"
chmod -R a-w "$work/.maxima"
check 'load("gsmbp") by name, Fortran in the current folder' session 'load("gsmbp")$
  gsmbp_fortran(gsmbp_scene("rod", link(a, mass = m), prismatic(p, ground, a, axis = x,
    coordinate = s), input(f, unit = N), force(push, a, vector = [f, 0, 0]),
    parameters = [m = 2*kg]), [rhs]);' \
  '\[fortran_out/rod.f, fortran_out/rod.json\]'
check 'the run time came along' test -d "$work/.maxima/gsmbp-files/share/fortran"
check 'the manual came along' test -s "$work/.maxima/gsmbp-files/share/manual/gsmbp-index.lisp"
HOME=$work without_root_powers octave-cli -qf --no-history --eval "$told_octave;
  m = gsmbp_build ('rod'); puts ([m.file \"\\n\"])" </dev/null >"$report" 2>&1
check 'Octave builds it in the current folder' says "$PWD/fortran_out/build/double/rod/gsmbp_d_rod_"
cd "$root" || exit 1
chmod -R u+w "$work/.maxima"
check 'installing twice' make_ install MAXIMA_USERDIR="$work/.maxima"
rm -rf "$work/user/fortran_out"
check 'make uninstall' make_ uninstall MAXIMA_USERDIR="$work/.maxima"
listing "$work" | diff "$work.before" - >"$report"; result 'all is as it was before'
check 'a second make uninstall is an error' fails make_ uninstall MAXIMA_USERDIR="$work/.maxima"
check 'and says so' says 'has no list of what was installed there: nothing is removed'

mkdir -p "$work/stage/usr/local/share/other"
listing "$work" >"$work.before"
check 'make install PREFIX DESTDIR' make_ install PREFIX=/usr/local DESTDIR="$work/stage"
check 'it says what to tell Maxima' \
  says 'Maxima: push("/usr/local/share/gsmbp/###.mac", file_search_maxima)$ in maxima-init.mac'
check 'and Octave' says 'Octave: addpath ("/usr/local/share/gsmbp/octave")'
check 'stages below DESTDIR' test -s "$work/stage/usr/local/share/gsmbp/gsmbp/gsmbp.mac"
check 'nothing refers to DESTDIR' fails grep -rq "$work/stage" "$work/stage"
touch "$work/stage/usr/local/share/gsmbp/share/actuators/mine.mac"
check 'make uninstall PREFIX DESTDIR' make_ uninstall PREFIX=/usr/local DESTDIR="$work/stage"
check 'it names a file that was not installed, and leaves it' \
  says "$work/stage/usr/local/share/gsmbp/share/actuators/mine.mac"
check 'that alone' test "$(find "$work/stage" -type f)" = \
  "$work/stage/usr/local/share/gsmbp/share/actuators/mine.mac"
rm -rf "$work/stage/usr/local/share/gsmbp"
make_ install PREFIX=/opt/a DESTDIR="$work/stage" && make_ uninstall PREFIX=/opt/a \
  DESTDIR="$work/stage"
listing "$work" | diff "$work.before" - >"$report"; result 'all is as it was before, PREFIX too'
rm -f "$work.before"
