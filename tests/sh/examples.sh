# The examples but the three that take a minute each: made from the working tree, a second make does nothing. Numbers of the paper's two: test_examples.m.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
few=$(ls -d examples/*/ | sed 's,examples/,,; s,/,,' | grep -v 'hydraulic_crane\|pneumatic_position\|robot_joint' | tr '\n' ' ')
make --no-print-directory examples EXAMPLES="$few" >"$work/out" 2>&1 && echo 'ok make examples' || { echo 'not ok make examples'; tail -n 20 "$work/out"; }
make --no-print-directory examples EXAMPLES="$few" >"$work/out" 2>&1
if [ -s "$work/out" ] && grep -q 'share/make\|octave-cli' "$work/out"; then echo 'not ok a second make examples does nothing'; cat "$work/out"; else echo 'ok a second make examples does nothing'; fi

for name in puma560 slider_crank; do
  for file in inverse_dynamics.csv open_loop.csv; do
    [ -s examples/$name/out/$file ] && echo "ok $name wrote $file" || echo "not ok $name wrote $file"
  done
  figures=$(ls examples/$name/out/*.png 2>/dev/null | wc -l)
  [ "$figures" -ge 3 ] && echo "ok $name drew $figures figures" || echo "not ok $name drew $figures figures"
done
