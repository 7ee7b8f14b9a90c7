# make install in a fresh home: load("gsmbp") works by name, from any folder, with the actuator
# library and the Fortran run time in place.
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
check() { what=$1; shift; if "$@" >"$work/out.txt" 2>&1; then echo "ok $what"; else echo "not ok $what"; tail -n 5 "$work/out.txt"; fi; }
session() { cd "$work" && timeout 60 maxima --very-quiet --userdir="$1" --batch-string="$2" </dev/null | grep -q "$3"; }

check 'make install' make -C "$root" --no-print-directory install HOME="$work" MAXIMA_USERDIR="$work/.maxima"
check 'load("gsmbp") by name' session "$work/.maxima" 'load("gsmbp")$ print(loaded_is, not emptyp(sublist(functions, lambda([f], op(f) = gsmbp_fortran))))$' 'loaded_is true'
check 'the run time came along' test -d "$work/.maxima/gsmbp-files/share/fortran"
check 'the Octave functions came along' test -s "$work/.maxima/gsmbp-files/octave/gsmbp_build.m"
check 'installing twice' make -C "$root" --no-print-directory install MAXIMA_USERDIR="$work/.maxima"
check 'make install PREFIX DESTDIR' make -C "$root" --no-print-directory install PREFIX=/usr/local DESTDIR="$work/stage"
check 'stages below DESTDIR' test -s "$work/stage/usr/local/share/gsmbp/gsmbp/gsmbp.mac"
check 'nothing refers to DESTDIR' sh -c "! grep -rq '$work/stage' '$work/stage'"
