#!/bin/sh
# The figures of the sources' structure do not rise above tests/data/structure.txt. Two of them are
# counted in Maxima: how many functions run for one request.
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
/usr/bin/python3 tests/tools/structure.py . >"$folder/all" || exit 1
share/make/maxima "$folder/log" \
  "gs__run_folder : \"$folder\"\$ load(\"tests/tools/functions_run.mac\")\$" >&2 || exit 1
cat "$folder/figures" >>"$folder/all"
grep -v '^#' tests/data/structure.txt | while read -r figure most goal; do
  now=$(awk -v figure="$figure" '$1 == figure { print $2 }' "$folder/all")
  if [ "${now:-1000000}" -le "$most" ]; then
    echo "ok $figure is $now, at most $most (the goal is $goal)"
  else
    case $figure in
      read | pulled) where="these functions run" ;;
      *) where="python3 tests/tools/structure.py . --where $figure lists them" ;;
    esac
    echo "not ok $figure is ${now:-not counted}, at most $most expected: $where"
    sed -n "s/^$figure /   /p" "$folder/functions.txt" | tr '\n' ' '
  fi
done
