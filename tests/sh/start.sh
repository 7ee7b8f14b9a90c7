# How a run starts, in C (share/engine/host): a particle on a circle against closed forms, under the
# sanitizers, in quad precision too.
. tests/tools/check.sh
root=$PWD
work_folder
core=$root/share/engine/core
c="-std=c99 -I$core -I$root/share/engine"
for header in host/start.h host/failure.h; do
  g++ -x c++ -Wall -Wextra -Wno-pragmas -I"$core" -Ishare/engine -fsyntax-only -include $header - \
    </dev/null
done >"$report" 2>&1
result 'the headers compile as C++'
for kind in double quad; do
  case $kind in
    double) flags='-fsanitize=address,undefined -fno-sanitize-recover=all' library= ;;
    quad) flags=-DGSMBP_QUAD library=-lquadmath ;;
  esac
  gcc $c $flags -g -Wall -Wextra -Werror -o "$work/$kind" tests/c/host/start.c \
    share/engine/host/start.c share/engine/host/residuals.c share/engine/host/settled.c \
    share/engine/host/margins.c "$core"/inputs/lay_plan.c "$core"/solve/solve_general.c \
    "$core"/solve/lu_pivoted.c "$core"/solve/plain/lu_factor.c "$core"/functions/not_finite.c \
    "$core"/functions/epsilon.c $library -lm >"$report" 2>&1
  told $? "the program compiles in $kind precision" "$report"
  to_the_end "$work/$kind"
done
