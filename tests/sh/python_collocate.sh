# Optimal motions of modules of Python beside those of Octave (tests/python: collocate.m,
# collocate.py): a block, an arm, a cart, a gear, a crank; closed forms; refusals; Ctrl-C, timeout.
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
if ! echo '#include "share/engine/host/ipopt/header_ipopt.h"' | gcc -I. -E - >/dev/null 2>&1; then
  echo 'ok left out without Ipopt: optimal motions of modules'
  exit 0
fi
python_packages ', requests' optimal_block optimal_arm optimal_cart optimal_gear optimal_crank \
  case_d1a
python_modules 'gsmbp_package(scene, python) of six scenes'
octave-cli -qf --no-history --path "$root/octave" --path "$root/tests/octave" \
  --path "$root/tests/python" --eval "collocate (\"$work/octave.json\")" >"$report" 2>&1
told $? 'collocate.m ends' "$report"
PYTHONPATH="$work" timeout 200 $python tests/python/collocate.py "$work/octave.json"
told $? 'collocate.py ends'
mv "$work/optimal_block/_ipopt.so" "$work/none.so"
PYTHONPATH="$work" $python -c 'import optimal_block as b
b.Model().collocate([0, 0], [1, 0], time=1)' 2>&1 | grep -q 'Ipopt is not installed'
told $? 'a module without Ipopt says so'
