#!/bin/sh
# The figures of the sources' structure do not rise above tests/data/structure.txt.
figures=$(mktemp) || exit 1
trap 'rm -f "$figures"' EXIT
/usr/bin/python3 tests/tools/structure.py . >"$figures" || exit 1
grep -v '^#' tests/data/structure.txt | while read -r figure most goal; do
  now=$(awk -v figure="$figure" '$1 == figure { print $2 }' "$figures")
  if [ "${now:-1000000}" -le "$most" ]; then
    echo "ok $figure is $now, at most $most (the goal is $goal)"
  else
    echo "not ok $figure is ${now:-not counted}, at most $most expected:" \
      "python3 tests/tools/structure.py . --where $figure lists them"
  fi
done
