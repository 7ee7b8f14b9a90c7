# A whole run in C (share/engine/host/run): compiles without a warning; an oscillator against closed
# forms by all methods, and every refusal, under the sanitizers; in quad precision, too.
. tests/tools/check.sh
work_folder
core=share/engine/core
c="-std=c99 -I$core -Ishare/engine"
strict="-Wall -Wextra -pedantic -Wshadow -Wconversion -Wsign-conversion -Werror"
for compiler in gcc clang; do
  command -v $compiler >/dev/null || continue
  for file in share/engine/host/run/*.c; do
    $compiler $c $strict -O2 -c -o "$work/run.o" "$file"
  done >"$report" 2>&1
  told $? "$compiler compiles it without a warning" "$report"
done
g++ -x c++ -Wall -Wextra -Wno-pragmas -I$core -Ishare/engine -fsyntax-only -include host/run/run.h \
  - </dev/null >"$report" 2>&1
told $? 'the header compiles as C++' "$report"
for kind in double quad; do
  case $kind in
    double)
      flags='-fsanitize=address,undefined -fno-sanitize-recover=all' library=
      more=share/engine/host/implicit/*.c ;;
    quad) flags=-DGSMBP_QUAD library=-lquadmath more= ;;
  esac
  gcc $c $flags -g -O0 -pthread -o "$work/$kind" tests/c/host/run.c \
    share/engine/host/run/*.c share/engine/host/derivatives/*.c share/engine/host/*.c $more \
    $core/*/*.c $core/*/*/*.c $library -lm >"$report" 2>&1
  told $? "the program compiles in $kind precision" "$report"
  to_the_end "$work/$kind"
done
