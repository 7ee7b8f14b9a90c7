# All examples derive; the paper's two are run: made from the working tree, a second make does
# nothing. make examples runs them all; numbers of their runs: test_examples*.m, test_audits.m.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out
make_() { make --no-print-directory "$@" >"$report" 2>&1; }
few='slider_crank puma560'
check 'make examples' make_ examples EXAMPLES="$few"
make_ examples EXAMPLES="$few"
check 'a second make examples does nothing' fails grep -q 'share/make\|octave-cli' "$report"
check 'all examples derive' make_ $(ls examples/*/run.m |
  sed 's,examples/,fortran_out/,; s,/run.m$,.f,')

for name in $few; do
  for file in inverse_dynamics.csv open_loop.csv; do
    check "$name wrote $file" test -s "examples/$name/out/$file"
  done
  figures=$(ls examples/$name/out/*.png 2>/dev/null | wc -l)
  check "$name drew $figures figures" test "$figures" -ge 3
done
