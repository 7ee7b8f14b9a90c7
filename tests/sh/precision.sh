# The run time in C in another precision than double (share/c/gsmbp/real.h).
# Quad: what share/fortran gives in quad precision, to 1e-30 of the largest entry: the drivers of
# tests/c call both. What the Fortran gives is compared with closed forms in run_time.sh and
# order.sh.
. tests/tools/check.sh
root=$PWD
work_folder

# objects FOLDER FLAGS...: those of share/c in a new folder; quad precision is computed by a library:
# no level of optimization matters
objects() {
  into=$1
  shift
  mkdir "$into" && (cd "$into" && gcc -std=c99 -O0 -Wall -Wextra "$@" -I"$root/share/c" \
    -c "$root"/share/c/*/*.c "$root"/share/c/*/*/*.c)
}

quad() {
  has_all 'share/c in quad precision' gfortran || return
  echo '#include <quadmath.h>' | gcc -E -o "$work/seen" - 2>"$report" ||
    { echo 'ok left out without quadmath.h: share/c in quad precision'; return; }
  objects "$work/quad" -DGSMBP_QUAD -Wshadow -Wconversion -Werror >"$report" 2>&1
  told $? 'share/c compiles in quad precision without a warning' "$report"
  mkdir "$work/fortran" && (cd "$work/fortran" && gfortran -O0 -frecursive -freal-8-real-16 \
    -c "$root"/share/fortran/*/*.f "$root"/share/fortran/solve/plain/*.f) >"$report" 2>&1
  told $? 'share/fortran compiles in quad precision' "$report"
  drivers='functions inputs plan project sensitivity events'
  whole && drivers="$drivers solve loops reach run"
  for name in $drivers; do
    gcc -std=c99 -O0 -Wall -Wextra -Werror -DGSMBP_QUAD -Ishare/c -o "$work/$name" \
      "tests/c/$name.c" "$work"/quad/*.o "$work"/fortran/*.o -lgfortran -lquadmath -lm \
      >"$report" 2>&1 || told 1 "tests/c/$name.c compiles in quad precision" "$report"
    echo "quad precision, tests/c/$name.c:"
    "$work/$name" || echo "not ok $name ended with an error"
  done
}

quad
