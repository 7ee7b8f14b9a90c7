# gsmbp_package(scene, c): what is written is built by its own Makefile and CMakeLists.txt with gcc
# and clang without a warning, gives the values that Maxima computed, and runs; make test-whole: by
# cmake and with the sanitizers of gcc, too. A wrong value is found.
. tests/tools/check.sh
root=$PWD
work_folder
strict="-O1 -Wall -Wextra -pedantic -Wshadow -Wconversion -Wsign-conversion -Werror"
statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
others=$(whole && echo sampled_crank reach_scara)
for scene in examples/slider_crank/slider_crank tests/scenes/event_crank \
  $(for other in $others; do echo tests/scenes/$other; done) examples/rolling_disc/rolling_disc; do
  statements="$statements kill(scene)\$ load(\"$root/$scene.mac\")\$
    gsmbp_package(scene, c, directory = \"$work/${scene##*/}\")\$"
done
share/make/maxima "$work/log" "$statements
  errcatch(gsmbp_package(scene, pascal))\$
  errcatch(gsmbp_package(scene, c, folder = \"x\"))\$
  gsmbp_package(scene, c, ['directory = \"$work/again\"])\$" >"$report" 2>&1
told $? 'gsmbp_package(scene, c) of its scenes' "$report"
check 'another language is refused' grep -q 'must be c or python; found: pascal' "$work/log"
check 'an unknown option is refused' grep -q 'gsmbp_package: unknown option folder' "$work/log"
check 'the same scene, the same bytes' diff -r "$work/rolling_disc" "$work/again"

# builds FOLDER WHAT VARIABLE=VALUE...: make test, make example
builds() {
  folder=$work/$1 what=$2
  shift 2
  make --no-print-directory -C "$folder" test example "$@" >"$report" 2>&1
  told $? "${folder##*/}: make test, make example, $what" "$report"
  check "${folder##*/}: its values" grep -qE '^([6-9]|[1-9][0-9]) passed, 0 failed$' "$report"
  check "${folder##*/}: a run of two seconds" grep -q '^info 0, .* t = 2 s$' "$report"
  grep '^ [0-9.]* ' "$report" >"$work/explicit"
  "$folder/example/simulate" radau >"$work/radau" 2>&1
  tail -n 1 "$work/radau" | grep -q '^info 0, .* t = 2 s$' &&
    grep '^ [0-9.]* ' "$work/radau" | paste -d ' ' - "$work/explicit" | awk '
      { for (k = 1; k <= NF/2; k++) { d = $k - $(k + NF/2); n++
          if (d*d > 1e-8*(1 + $k*$k)) exit 1 } } END { exit n < 21 }'
  told $? "${folder##*/}: the same by radau" "$work/radau"
}
for name in rolling_disc $others; do
  check "$name: the run time of slider_crank" \
    diff -r "$work/slider_crank/runtime" "$work/$name/runtime"
done
builds slider_crank gcc CC=gcc CFLAGS="$strict"
cp "$report" "$work/by_gcc"
# which is compiled once
for name in rolling_disc event_crank $others; do
  cp -R "$work/slider_crank/runtime/." "$work/$name/runtime"
  builds $name gcc CC=gcc CFLAGS="$strict"
done
if whole; then
  make -s -C "$work/event_crank" clean
  builds event_crank 'sanitizers of gcc' CC=gcc \
    CFLAGS="-O0 -g -fsanitize=address,undefined -fno-sanitize-recover=all" \
    LDFLAGS=-fsanitize=address,undefined
fi
# what cannot be is refused
while read -r words wanted; do
  "$work/event_crank/example/simulate" $(echo "$words" | tr _ ' ') >"$report" 2>&1
  check "by $words: $wanted" grep -q "$wanted" "$report"
done <<EOF
gauss_13 maxorder: expected one of 4, 6, 8, found 13
radau_20 maxorder: expected one of 5, 9, 13, found 20
dp853_5 maxorder: method dp853 has one order alone, found 5
cvode method: method "cvode" needs SUNDIALS
euler method: expected one of dp853, rk4, .*, auto, found euler
EOF
if has clang 'packages by clang'; then
  make -s -C "$work/slider_crank" clean
  builds slider_crank clang CC=clang CFLAGS="$strict -O0"
fi
if whole && has cmake 'packages by cmake'; then
  (cd "$work/slider_crank" && cmake -B built && cmake --build built &&
    ctest --test-dir built) >"$report" 2>&1
  told $? 'cmake, ctest' "$report"
fi

# -- every routine of the header is called by the test
for name in slider_crank event_crank rolling_disc $others; do
  sed -n "s/^[a-z]* ${name}_\([a-z0-9]*\) (.*/\1/p" "$work/$name/$name.h" |
    grep -vxE 'par|pre' | while read -r routine; do
      grep -q "call_$routine (" "$work/$name/test/reference.h" || echo "$name: $routine"
    done
done >"$report"
result 'every routine is called by the test of its package'

# -- a value that is not right
sed -i '/^static const double inv_out/,/};/s/[1-8]/9/' "$work/slider_crank/test/reference.h"
make -C "$work/slider_crank" test >"$report" 2>&1
check 'a wrong value is found' grep -q '^not ok inv: ' "$report"
