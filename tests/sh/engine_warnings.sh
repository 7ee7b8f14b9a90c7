# The C of the hosts of the run time compiles without a warning: share/engine/host, share/python/c,
# share/fmu; as share/engine/core does (c_run_time.sh) and packages of C do (package_c.sh). Their
# headers stand alone.
. tests/tools/check.sh
work_folder
folders="-Ishare/engine/core -Ishare/engine -Ishare/engine/host/implicit -Ishare/fmu
  -Ishare/fmu/fmi"
c="-std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion -Werror -fsyntax-only
  $folders"
for compiler in gcc clang; do
  command -v $compiler >/dev/null || continue
  for folder in engine/host engine/host/implicit engine/host/cvode fmu python/c; do
    if [ $folder = engine/host/cvode ] &&
      ! echo '#include <cvode/cvode_proj.h>' | $compiler -E - >/dev/null 2>&1; then
      echo "ok left out without SUNDIALS: share/$folder without a warning"
      continue
    fi
    for file in share/$folder/*.c; do
      $compiler $c $file
    done >"$report" 2>&1
    result "$compiler: share/$folder without a warning"
  done
done
for header in share/engine/host/*.h share/engine/host/implicit/*.h share/fmu/*.h; do
  echo "#include \"$header\"" | gcc -std=c99 -fsyntax-only -I. $folders -x c - || echo "$header"
done >"$report" 2>&1
result 'gcc: their headers need no other before them'
