#!/bin/sh
# values.sh [PARTS]: every option of every element and device with values of every wrong type
# (tests/tools/wrong_values.mac), in PARTS sessions of Maxima (7), one after the other: lines `ok`
# and `not ok`.
set -u
cd "$(dirname "$0")/../.." || exit 1
parts=${1:-7}
dir=$(mktemp -d "${TMPDIR:-/tmp}/values.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
k=1
while [ "$k" -le "$parts" ]; do
  timeout 1800 share/make/maxima "$dir/log" "load(\"gsmbp/gsmbp.mac\")\$ \
    load(\"tests/tools/wrong_values.mac\")\$ r : wrong_values($parts, $k)\$ \
    with_stdout(\"$dir/answers\", printf(true, \"~a ~d values~%\",
      if second(r) = [] then \"ok\" else \"not ok\", first(r)),
      for x in second(r) do printf(true, \"   ~a: ~a = ~a: ~a~%\", first(x), second(x),
        string(third(x)), fourth(x)))\$" > "$dir/said" 2>&1
  if [ -s "$dir/answers" ]; then cat "$dir/answers"; else echo "not ok part $k"; cat "$dir/said"; fi
  rm -f "$dir/answers"
  k=$((k + 1))
done
