# A whole run in C (share/engine/host/run), and one that its host continues step by step: an
# oscillator against closed forms by all methods, and every refusal, under the sanitizers; in quad
# precision, too.
. tests/tools/check.sh
work_folder
core=share/engine/core
c="-std=c99 -I$core -Ishare/engine"
g++ -x c++ -Wall -Wextra -Wno-pragmas -I$core -Ishare/engine -fsyntax-only \
  -include host/run/stepped.h - </dev/null >"$report" 2>&1
told $? 'the headers compile as C++' "$report"
for kind in double quad; do
  case $kind in
    double)
      flags='-fsanitize=address,undefined -fno-sanitize-recover=all' library=
      more=share/engine/host/implicit/*.c ;;
    quad) flags=-DGSMBP_QUAD library=-lquadmath more= ;;
  esac
  for program in run stepped; do
    gcc $c $flags -g -O0 -pthread -o "$work/$program" tests/c/host/$program.c \
      share/engine/host/run/*.c share/engine/host/derivatives/*.c share/engine/host/*.c $more \
      $core/*/*.c $core/*/*/*.c $library -lm >"$report" 2>&1
    told $? "the program $program compiles in $kind precision" "$report"
    to_the_end "$work/$program"
  done
done
