# The run time in C (share/engine/core): compiles without a warning, writes no data of its own,
# calls nothing but the mathematical library, and gives bit for bit, or to 1e-14 of the largest
# entry, what share/fortran gives, or gave at the commit of tests/data/before/base: the drivers of
# tests/c call both. Every public routine is in a driver.
. tests/tools/check.sh
root=$PWD
work_folder
mkdir "$work/c"

core=$root/share/engine/core
c="-std=c99 -O2 -ffp-contract=off -I$core"
strict="-Wall -Wextra -pedantic -Werror"
# those of the drivers, and more
strictest="$strict -Wshadow -Wconversion -Wsign-conversion"
# the drivers, and emitted subroutines that Fortran and C call alike: not optimized
driver="$c -O0 $strict"

# -- it compiles
base_fortran "$work/base"
fortran_objects "$work/fortran" "$work/base" >"$report" 2>&1
told $? 'share/fortran compiles' "$report"
(cd "$work/c" &&
  gcc $c $strictest -c "$core"/*/*.c "$core"/*/*/*.c) >"$report" 2>&1
told $? 'gcc compiles share/engine/core without a warning' "$report"
if command -v clang >/dev/null; then
  clang $c $strictest -fsyntax-only "$core"/*/*.c "$core"/*/*/*.c >"$report" 2>&1
  told $? 'clang compiles share/engine/core without a warning' "$report"
fi
for header in share/engine/core/gsmbp/*.h; do
  [ "$header" = share/engine/core/gsmbp/arith.h ] && continue
  g++ -x c++ $strict -Wno-pragmas -Ishare/engine/core -fsyntax-only -include "$header" - </dev/null
done >"$report" 2>&1
result 'the headers compile as C++'

# -- what is in the objects
nm "$work"/c/*.o | awk '$2 ~ /^[bBdDC]$/ { print }' >"$report"
result 'share/engine/core writes no data of its own'
nm -D --defined-only "$(gcc -print-file-name=libm.so.6)" | awk '{ sub(/@.*/, "", $3); print $3 }' \
  >"$work/library"
printf '%s\n' memcpy memmove memset __stack_chk_fail _GLOBAL_OFFSET_TABLE_ >>"$work/library"
nm "$work"/c/*.o | awk '$2 == "T" { print $3 }' >>"$work/library"
nm "$work"/c/*.o | awk '$1 == "U" { print $2 }' | sort -u | grep -vxFf "$work/library" >"$report"
result 'share/engine/core calls nothing but itself and libm'

# -- the drivers
for file in tests/c/*.c; do
  name=$(basename "$file" .c)
  gcc $driver -o "$work/$name" "$file" "$work"/c/*.o "$work"/fortran/*.o -lgfortran -lm \
    >"$report" 2>&1 || { unlinked "$file"; continue; }
  "$work/$name" || echo "not ok $file ended with an error"
done
# -- emitted scenes: the Fortran and the C call the same emitted subroutines
mkdir "$work/emitted"
scenes='four_bar slider_crank event_crank event_pendulum event_ball event_slide event_blocks
  sampled_crank passage_events parallelograms3 user_bounce user_count user_crank
  user_dips user_held user_wheel event_instant'
for scene in $scenes; do
  file=tests/scenes/$scene.mac out=$GSMBP_TEST_DIR/fortran_out
  [ -f "$file" ] || { file=examples/$scene/$scene.mac; out=$work/emitted; }
  [ -s "$out/$scene.f" ] || share/make/derive "$file" "$out" 2>/dev/null
  {
    echo "#define SCENE $scene"
    sed -n 's/^ *"\(n[a-z]*\)": \([0-9]*\),*$/#define SIZE_\1 \2/p' "$out/$scene.json"
    sed -n 's/^ *SUBROUTINE [A-Z0-9_]*_\([A-Z0-9]*\)(.*/\1/p' "$out/$scene.f" | tr A-Z a-z |
      sed 's/.*/#define HAS_&/'
    echo '#include "emitted_scene.h"'
  } >"$work/emitted/$scene.c"
  (cd "$work/emitted" &&
    $fortran_apart -O0 -c "$out/$scene.f" -o "$scene.f.o" &&
    gcc $driver -I"$root/tests/c/emitted" -c "$scene.c") >"$report" 2>&1 ||
    told 1 "the shims of $scene compile" "$report"
done
gcc $driver -o "$work/runs" tests/c/emitted/runs.c "$work"/emitted/*.o "$work"/c/*.o \
  "$work"/fortran/*.o -lgfortran -lm >"$report" 2>&1 || unlinked 'runs of emitted scenes'
[ ! -x "$work/runs" ] || check 'runs of emitted scenes' "$work/runs"

whole || exit 0

# -- no driver reads or writes beyond an array, or does what C leaves undefined
mkdir "$work/checked"
checks='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=undefined'
(cd "$work/checked" && gcc $c $checks -c "$core"/*/*.c "$core"/*/*/*.c) \
  >"$report" 2>&1
for file in tests/c/*.c tests/c/emitted/runs.c; do
  more=
  [ "$file" = tests/c/emitted/runs.c ] && more=$(ls "$work"/emitted/*.o)
  gcc $c $checks -o "$work/checks" "$file" $more "$work"/checked/*.o "$work"/fortran/*.o \
    -lgfortran -lm && "$work/checks" 2>&1 | grep -E '^(not ok|==|[^ ]*: runtime error)'
done >>"$report" 2>&1
result 'share/engine/core under the address and the undefined behaviour sanitizer'

# -- every function of share/engine/core, static ones too, is run by a driver
mkdir "$work/cover"
(cd "$work/cover" && gcc $c -O0 --coverage -c "$core"/*/*.c "$core"/*/*/*.c) \
  >"$report" 2>&1
for file in tests/c/*.c tests/c/emitted/runs.c; do
  more=
  [ "$file" = tests/c/emitted/runs.c ] && more=$(ls "$work"/emitted/*.o)
  gcc $c --coverage -o "$work/covered" "$file" $more "$work"/cover/*.o "$work"/fortran/*.o \
    -lgfortran -lm && (cd "$work" && ./covered) >"$work/said" 2>&1
done
(cd "$work/cover" && gcov -f *.gcda) 2>"$work/said" |
  awk '/^Function/ { name = $2 }
    /^Lines executed:0.00%/ && name { print name }
    /^File/ { name = "" }' \
  >"$report"
result 'every function of share/engine/core is run by a driver'
