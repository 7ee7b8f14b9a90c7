# make install in a fresh home: load("gsmbp") works by name, from any folder, with the actuator
# library and the Fortran run time in place.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out.txt
install() { make -C "$root" --no-print-directory install "$@" >"$report" 2>&1; }
session() {
  cd "$work" && timeout 60 maxima --very-quiet --userdir="$work/.maxima" --batch-string="$1" \
    </dev/null >"$report" 2>&1 && grep -q "$2" "$report"
}

check 'make install' install HOME="$work" MAXIMA_USERDIR="$work/.maxima"
check 'load("gsmbp") by name' session 'load("gsmbp")$
  print(loaded_is, not emptyp(sublist(functions, lambda([f], op(f) = gsmbp_fortran))))$' \
  'loaded_is true'
check 'the run time came along' test -d "$work/.maxima/gsmbp-files/share/fortran"
check 'the Octave functions came along' test -s "$work/.maxima/gsmbp-files/octave/gsmbp_build.m"
check 'installing twice' install MAXIMA_USERDIR="$work/.maxima"
check 'make install PREFIX DESTDIR' install PREFIX=/usr/local DESTDIR="$work/stage"
check 'stages below DESTDIR' test -s "$work/stage/usr/local/share/gsmbp/gsmbp/gsmbp.mac"
check 'nothing refers to DESTDIR' fails grep -rq "$work/stage" "$work/stage"
