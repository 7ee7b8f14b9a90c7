# The C of the hosts of the run time compiles without a warning: share/engine/host (lanes as for
# OpenMP too), share/python/c, share/fmu; as share/engine/core does (c_run_time.sh) and packages of
# C do (package_c.sh). Their headers stand alone; the hosts have no data of their own.
. tests/tools/check.sh
work_folder
folders="-Ishare/engine/core -Ishare/engine -Ishare/engine/host/implicit -Ishare/fmu
  -Ishare/fmu/fmi"
c="-std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion -Werror
  $folders"
# compiled SOURCE OPTION...: by $compiler, tables of texts as constants (-fno-pie); clang warns of
# nothing more where it optimizes
compiled() {
  source=$1
  shift
  case $compiler in
    gcc) gcc $c "$@" -O2 -fno-pie -c -o "$work/objects/$(echo "$source" | tr / -).o" "$source" ;;
    clang) clang $c "$@" -fsyntax-only "$source" ;;
  esac
}
mkdir "$work/objects"
for compiler in gcc clang; do
  command -v $compiler >/dev/null || continue
  for file in share/engine/host/lanes/*.c; do
    compiled $file -O3 -fopenmp-simd -DGS_OPENMP_SIMD
  done >"$report" 2>&1
  result "$compiler: lanes for OpenMP without a warning"
  for folder in share/engine/host share/engine/host/*/ share/fmu share/python/c; do
    folder=${folder%/}
    if [ $folder = share/engine/host/cvode ] &&
      ! echo '#include <cvode/cvode_proj.h>' | $compiler -E - >/dev/null 2>&1; then
      echo "ok left out without SUNDIALS: $folder without a warning"
      continue
    fi
    name=${folder##*/}
    case $name in ipopt | nlopt)
      $compiler -E $folder/header_$name.h >/dev/null 2>&1 || {
        echo "ok left out, not installed: $folder without a warning"
        continue
      } ;;
    esac
    for file in $folder/*.c; do
      compiled $file
    done >"$report" 2>&1
    result "$compiler: $folder without a warning"
    for header in $folder/*.h; do
      test -e $header || continue
      echo "#include \"$header\"" | $compiler -std=c99 -fsyntax-only -I. $folders -x c - ||
        echo "$header"
    done >"$report" 2>&1
    result "$compiler: the headers of $folder need no other before them"
  done
done
nm "$work"/objects/share-engine-host*.o | awk '$2 ~ /^[bBdDC]$/' >"$report"
result 'the hosts have no data of their own'
