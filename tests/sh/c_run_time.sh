# The run time in C (share/c): compiles without a warning, writes no data of its own, calls nothing
# but the mathematical library, and gives bit for bit, or to 1e-14 of the largest entry, what
# share/fortran gives: the drivers of tests/c call both. Every public routine is in a driver.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/report
mkdir "$work/c" "$work/fortran" "$work/clang"

c="-std=c99 -O2 -ffp-contract=off -I$root/share/c"
strict="-Wall -Wextra -pedantic -Werror"

# -- it compiles
(cd "$work/fortran" &&
  gfortran -O2 -ffp-contract=off -frecursive -c "$root"/share/fortran/*/*.f \
    "$root"/share/fortran/solve/plain/*.f) >"$report" 2>&1
told $? 'share/fortran compiles' "$report"
(cd "$work/c" && gcc $c $strict -c "$root"/share/c/*/*.c "$root"/share/c/*/*/*.c) >"$report" 2>&1
told $? 'gcc compiles share/c without a warning' "$report"
if command -v clang >/dev/null; then
  (cd "$work/clang" &&
    clang $c $strict -c "$root"/share/c/*/*.c "$root"/share/c/*/*/*.c) >"$report" 2>&1
  told $? 'clang compiles share/c without a warning' "$report"
fi
for header in share/c/gsmbp/*.h; do
  [ "$header" = share/c/gsmbp/arith.h ] && continue
  g++ -x c++ $strict -Wno-pragmas -Ishare/c -fsyntax-only -include "$header" - </dev/null
done >"$report" 2>&1
result 'the headers compile as C++'

# -- one file in C for each in Fortran, no more (arith.h and the like are headers)
for file in share/c/*/*.c share/c/*/*/*.c; do
  fortran=share/fortran${file#share/c}
  [ -f "${fortran%.c}.f" ] || echo "$file has no Fortran"
done >"$report"
result 'every file of share/c has its Fortran'

# -- what is in the objects
nm "$work"/c/*.o | awk '$2 ~ /^[bBdDC]$/ { print }' >"$report"
result 'share/c writes no data of its own'
nm -D --defined-only "$(gcc -print-file-name=libm.so.6)" | awk '{ sub(/@.*/, "", $3); print $3 }' \
  >"$work/library"
printf '%s\n' memcpy memmove memset __stack_chk_fail _GLOBAL_OFFSET_TABLE_ >>"$work/library"
nm "$work"/c/*.o | awk '$2 == "T" { print $3 }' >>"$work/library"
nm "$work"/c/*.o | awk '$1 == "U" { print $2 }' | sort -u | grep -vxFf "$work/library" >"$report"
result 'share/c calls nothing but itself and libm'

# -- the drivers
for driver in tests/c/*.c; do
  name=$(basename "$driver" .c)
  gcc $c $strict -o "$work/$name" "$driver" "$work"/c/*.o "$work"/fortran/*.o -lgfortran -lm \
    >"$report" 2>&1 || told 1 "$driver compiles" "$report"
  "$work/$name" || echo "not ok $driver ended with an error"
done
nm "$work"/c/*.o | awk '$2 == "T" { print $3 }' | while read -r routine; do
  grep -q "\b${routine}_\b" tests/c/*.c || echo "$routine"
done >"$report"
result 'every routine of share/c is called by a driver'

# -- the program of its README
awk '/^```c$/ { on = 1; next } /^```/ { on = 0 } on' share/c/README.md >"$work/main.c"
sed -n '/^    gcc /s/^    //p' share/c/README.md >"$work/command"
(cd "$work" && ln -s "$root/share" share && sh -eu command && ./main) >"$report" 2>&1
check 'the program of share/c/README.md prints what it says' \
  grep -qF "prints \`$(cat "$report")\`" share/c/README.md
