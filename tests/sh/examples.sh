# The paper's two examples: made from the working tree, a second make does nothing; of the others a
# third a day is derived (all in make test-whole). make examples runs them all. Numbers of the
# paper's two: test_examples.m.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out
make_() { make --no-print-directory "$@" >"$report" 2>&1; }
few='slider_crank puma560'
check 'make examples' make_ examples EXAMPLES="$few"
make_ examples EXAMPLES="$few"
check 'a second make examples does nothing' fails grep -q 'share/make\|octave-cli' "$report"
check 'the examples derive' make_ $(ls examples/*/run.m |
  awk -v day="$(($(date +%s) / 86400))" -v all="${GSMBP_WHOLE:-}" 'all || NR % 3 == day % 3' |
  sed 's,examples/,fortran_out/,; s,/run.m$,.f,')

for name in puma560 slider_crank; do
  for file in inverse_dynamics.csv open_loop.csv; do
    check "$name wrote $file" test -s "examples/$name/out/$file"
  done
  figures=$(ls examples/$name/out/*.png 2>/dev/null | wc -l)
  check "$name drew $figures figures" test "$figures" -ge 3
done
