# The run time in C and emitted C in another precision than double (share/engine/core/gsmbp/real.h).
# Quad: what share/fortran gives in quad precision, to 1e-30 of the largest entry: the drivers of
# tests/c call both, and those of c_pair emitted routines; closed forms (those of the Fortran:
# run_time.sh, order.sh).
# Single: share/engine/core without a warning, constants within range; runs to 1e-3 (at length);
# inverse dynamics of the PUMA 560 to 1e-6 of the largest generalized force, here and, where
# compilers and emulators are installed, on a Cortex-M4F, without arithmetic in double precision,
# and on an AVR, where double is single.
. tests/tools/check.sh
root=$PWD
work_folder
strict='-std=c99 -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion -Werror'
core=$root/share/engine/core
sources="$(echo "$core"/*/*.c "$core"/*/*/*.c)"

# quad precision is computed by a library: no level of optimization matters
quad_run_times() {
  mkdir -p "$work/pair/time/c" "$work/pair/time/fortran"
  (cd "$work/pair/time/c" && gcc $strict -O0 -DGSMBP_QUAD -I"$core" -c $sources &&
    ar rcs ../c.a ./*.o) >"$report" 2>&1
  told $? 'share/engine/core compiles in quad precision without a warning' "$report"
  nm "$work"/pair/time/c/*.o | awk '$2 ~ /^[bBdDC]$/ { print }' >"$report"
  result 'share/engine/core in quad precision writes no data of its own'
  base_fortran "$work/base"
  (cd "$work/pair/time/fortran" && gfortran -O0 -frecursive -freal-8-real-16 \
    -c "$root"/share/fortran/*/*.f "$root"/share/fortran/solve/plain/*.f \
    $(find "$work/base" -name '*.f') &&
    ar rcs ../fortran.a ./*.o) >"$report" 2>&1
  told $? 'share/fortran compiles in quad precision' "$report"
}
has_quadmath() {
  echo '#include <quadmath.h>' | gcc -E -o "$work/seen" - 2>"$report" && return
  echo "ok left out without quadmath.h: $1"
  return 1
}
quad() {
  has_quadmath 'share/engine/core in quad precision' || return 0
  quad_run_times
  drivers='functions inputs plan project sensitivity events' scenes=tests/scenes/event_crank.mac
  if whole; then
    drivers="$drivers solve loops reach run"
    scenes="$scenes tests/scenes/sampled_crank.mac tests/scenes/reach_legs.mac"
  fi
  gcc -std=c99 -O0 -Wall -Wextra -Werror -DGSMBP_QUAD -I$core -o "$work/order" \
    tests/c/precision/order.c "$work/pair/time/c.a" -lquadmath -lm >"$report" 2>&1 && "$work/order"
  told $? 'quad precision: closed forms' "$report"
  for name in $drivers; do
    gcc -std=c99 -O0 -Wall -Wextra -Werror -DGSMBP_QUAD -I$core -o "$work/$name" \
      "tests/c/$name.c" "$work/pair/time/c.a" "$work/pair/time/fortran.a" -lgfortran -lquadmath \
      -lm >"$report" 2>&1 || { unlinked "tests/c/$name.c in quad precision"; continue; }
    echo "quad precision, tests/c/$name.c:"
    "$work/$name" || echo "not ok $name ended with an error"
  done
  GSMBP_STATES=5 GSMBP_PRECISION=quad tests/tools/c_pair "$work/pair" $scenes >"$report" 2>&1
  told $? 'emitted C and emitted Fortran in quad precision' "$report"
}

# -- single precision
float_warnings() {
  for compiler in gcc clang; do
    [ $compiler = gcc ] || whole || continue
    has $compiler 'warnings of share/engine/core in single precision' || continue
    $compiler $strict -pedantic -fsyntax-only -DGSMBP_FLOAT -I$core $sources >"$report" 2>&1
    result "$compiler: share/engine/core in single precision without a warning"
  done
}
puma() {
  mkdir "$work/puma"
  share/make/maxima "$report" "load(\"$root/gsmbp/gsmbp.mac\")\$
    load(\"$root/tests/bench/systems/puma6.mac\")\$
    gsmbp_c(scene, [inverse], ['directory = \"$work/puma\", 'precision = any])\$"
  told $? 'the PUMA 560 is emitted for any precision' "$report"
  routines="tests/c/precision/inverse.c $work/puma/puma6.c $(echo share/engine/core/functions/*.c)"
  flags="-std=c99 -O2 -Wall -Wextra -Werror -I$core -I$work/puma"
  gcc $flags -pedantic -DREFERENCE -o "$work/reference" $routines -lm >"$report" 2>&1 &&
    "$work/reference" >"$work/puma/reference.h"
  told $? 'its inverse dynamics in double precision' "$report"
}
# exact WHERE MOST: the last line of $report is a number of 0 to MOST
exact() {
  worst=$(sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' "$report" | grep -E '^-?[0-9]+$' | tail -n 1)
  [ -n "$worst" ] && [ "$worst" -ge 0 ] && [ "$worst" -le "$2" ]
  told $? "inverse dynamics, $1: error ${worst:-none} of 1e-9, at most $2" "$report"
}
here() {
  gcc $flags -pedantic -DGSMBP_FLOAT -o "$work/single" $routines -lm >"$report" 2>&1 &&
    "$work/single" >"$report" 2>&1
  exact 'single precision' 1000
  mkdir "$work/for_double"
  for file in puma6.c puma6.h; do
    sed 's/gs_real/double/g; s/GS_R (\([^)]*\))/\1/g' "$work/puma/$file" >"$work/for_double/$file"
  done
  gcc -std=c99 -fsyntax-only -I$core "$work/for_double/puma6.c" >"$report" 2>&1
  told $? 'C for double compiles' "$report"
  check 'C for double is refused in single precision' fails \
    gcc -std=c99 -fsyntax-only -DGSMBP_FLOAT -I$core "$work/for_double/puma6.c" 2>"$report"
  has_quadmath 'inverse dynamics in quad precision' || return 0
  gcc $flags -DGSMBP_QUAD -o "$work/quad_puma" $routines -lquadmath -lm >"$report" 2>&1 &&
    "$work/quad_puma" >"$report" 2>&1
  exact 'quad precision' 0
}
cortex() {
  has_all 'single precision on a Cortex-M4F' arm-none-eabi-gcc qemu-system-arm || return 0
  arm="arm-none-eabi-gcc $flags -pedantic -Wdouble-promotion -DGSMBP_FLOAT -mcpu=cortex-m4
    -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard"
  $arm --specs=rdimon.specs -nostartfiles -o "$work/cortex" \
    -Wl,--section-start=.vectors=0,-Ttext=0x400,-Tdata=0x20000000,-ereset \
    tests/c/precision/cortex_m.c $routines -lm >"$report" 2>&1 &&
    timeout 60 qemu-system-arm -M mps2-an386 -nographic -kernel "$work/cortex" \
      -semihosting-config enable=on,target=native </dev/null >"$report" 2>&1
  exact 'a Cortex-M4F' 1000
  mkdir "$work/arm"
  units=$work/puma/puma6.c
  whole && units="$units $sources"
  for file in $units; do
    $arm -Wno-maybe-uninitialized -c -o "$work/arm/$(basename "$file").o" "$file"
  done >"$report" 2>&1
  arm-none-eabi-nm "$work"/arm/*.o | grep -E ' [bBdDC] | U __aeabi_(d|f2d)' >>"$report"
  result 'no arithmetic in double precision and no data of its own on a Cortex-M4F'
}
avr() {
  has_all 'single precision on an AVR' avr-gcc simavr || return 0
  for precision in -DGSMBP_FLOAT ''; do   # an AVR's double is single
    avr-gcc $flags -Os -mmcu=atmega2560 $precision -o "$work/avr" $routines -lm >"$report" 2>&1 &&
      timeout 60 simavr -m atmega2560 -f 16000000 "$work/avr" >"$report" 2>&1
    exact "an AVR${precision:+, $precision}" 1000
  done
}

# runs of a tree, a loop and a port that sticks: states after 1 s beside those in double precision
runs() {
  mkdir "$work/runs" "$work/runs/single" "$work/runs/double"
  files='tests/bench/systems/pend4 examples/four_bar/four_bar tests/scenes/event_slide'
  share/make/maxima "$report" "load(\"$root/gsmbp/gsmbp.mac\")\$ $(for file in $files; do
    echo "load(\"$root/$file.mac\")\$
      gsmbp_c(scene, all, ['directory = \"$work/runs\", 'precision = any])\$"
  done)"
  told $? 'scenes are emitted for any precision' "$report"
  (cd "$work/runs/double" && gcc $strict -O1 -I"$core" -c $sources && cd ../single &&
    gcc $strict -O1 -DGSMBP_FLOAT -I"$core" -c $sources) >"$report" 2>&1
  told $? 'share/engine/core compiles in double and in single precision' "$report"
  for file in $files; do
    scene=${file##*/}
    for key in initial nominal; do
      tr -d '\n' <"$work/runs/$scene.json" |
        sed "s/.*\"$key\": *\[\([^]]*\)\].*/static const double $key[] = { \1 };\n/"
    done >"$work/runs/start.h"
    for method in 4 8; do
      for way in 2 3; do run "$scene" $method $way; done
    done
  done
}
# run SCENE METHOD WAY
run() {
  for precision in double single; do
    macro= rtol=1e-9
    [ $precision = double ] || { macro=-DGSMBP_FLOAT rtol=1e-4; }
    gcc -std=c99 -O1 -Wall -Wextra $macro -DSCENE="$1" -DMETHOD="$2" -DWAY="$3" -DRTOL=$rtol \
      -I$core -I"$work/runs" -o "$work/run" tests/c/precision/run.c "$work/runs/$1.c" \
      "$work/runs/$precision"/*.o -lm && "$work/run" || echo failed
  done >"$report" 2>&1
  awk 'NR == 1 { n = NF; for (i = 1; i <= n; i++) x[i] = $i }
    NR == 2 { for (i = 3; i <= n; i++) {
        d = $i - x[i]; if (d < 0) d = -d; if (d > off) off = d
        s = x[i] < 0 ? -x[i] : x[i]; if (s > most) most = s }
      good = NF == n && n > 3 && $1 == "0" && x[1] == "0" && off <= 1e-3*most }
    END { exit ! good }' "$report"
  told $? "$1 in single precision, method $2, way $3: within 1e-3" "$report"
}

quad
float_warnings
whole && runs
puma
here
cortex
avr
