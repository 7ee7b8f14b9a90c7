# A sample of the examples, the paper's two among them: made from the working tree, a second make
# does nothing; the others are derived. make examples runs them all. Numbers of the paper's two:
# test_examples.m.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
few='slider_crank puma560 four_bar slider_crank_induction'
make --no-print-directory examples EXAMPLES="$few" >"$work/out" 2>&1 && echo 'ok make examples' || { echo 'not ok make examples'; tail -n 20 "$work/out"; }
make --no-print-directory examples EXAMPLES="$few" >"$work/out" 2>&1
if [ -s "$work/out" ] && grep -q 'share/make\|octave-cli' "$work/out"; then echo 'not ok a second make examples does nothing'; cat "$work/out"; else echo 'ok a second make examples does nothing'; fi
all=$(ls -d examples/*/ | sed 's,examples/,fortran_out/,; s,/$,.f,')
make --no-print-directory $all >"$work/out" 2>&1 && echo 'ok all examples derive' || { echo 'not ok all examples derive'; tail -n 20 "$work/out"; }

for name in puma560 slider_crank; do
  for file in inverse_dynamics.csv open_loop.csv; do
    [ -s examples/$name/out/$file ] && echo "ok $name wrote $file" || echo "not ok $name wrote $file"
  done
  figures=$(ls examples/$name/out/*.png 2>/dev/null | wc -l)
  [ "$figures" -ge 3 ] && echo "ok $name drew $figures figures" || echo "not ok $name drew $figures figures"
done
