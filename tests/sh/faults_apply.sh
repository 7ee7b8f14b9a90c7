# The seeded faults of tests/faults fit the sources of today, and the tests that they name exist: a
# patch that does not apply finds nothing, and nobody sees it before the faults are run.
. tests/tools/check.sh
work_folder
for patch in tests/faults/*.patch; do
  git apply --check --recount -C1 "$patch" 2>"$work/said" || cat "$work/said" >>"$report"
  named=$(sed -n '1s/^Found by: \([a-zA-Z_0-9./]*\)$/\1/p' "$patch")
  [ -n "$named" ] && ls tests/*/* octave/*.m | grep -qF "$named" ||
    echo "$patch: expected a first line Found by: TEST, found $(head -n 1 "$patch")" >>"$report"
done
result 'the patches of tests/faults apply and name tests'
