# A bench whose table stays empty ends with an error: every target of the Makefile looks at its
# report, and what a script pipes on does not hide that its program failed.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
filled() { tests/bench/filled "$work/report.md" 2>"$work/said"; }
said() { grep -q "$1" "$work/said"; }
report() { printf '%s\n' "$@" >"$work/report.md"; }

check 'a report that is missing is an error' fails filled
report '# title' '' '| a | b |' '|---|---|' '| 1 | 2 |' '' 'text'
check 'a table with rows passes' filled
report '# title' '' '| a | b |' '|---|---|' '' 'text'
check 'one without rows is an error' fails filled
check '... that tells the line' said 'report.md: a table without rows, line 5'
report '| a | b |' '|---|---|' '| 1 | 2 |' '' '| a |' '|---|'
check 'one without rows at the end is an error' fails filled
report 'text'
check 'a report without a table is an error' fails filled

# bench-c writes no report
for target in $(sed -n 's/^make \(bench[a-z0-9-]*\).*/\1/p' Makefile | sort -u); do
  [ "$target" = bench-c ] && continue
  make --no-print-directory -n "$target" PEERS=1 >"$work/commands" 2>&1
  check "$target: its report is new and looked at" sh -c \
    'grep -q "rm -f tests/bench/[a-z0-9]*.md" "$1" && grep -q "bench/filled" "$1"' \
    sh "$work/commands"
done

mkdir "$work/bin"   # programs that fail
for name in octave-cli gfortran; do
  printf '#!/bin/sh\nexit 1\n' >"$work/bin/$name"
  chmod +x "$work/bin/$name"
done
for bench in collocation flexible reach; do
  check "bench-$bench ends with an error where a program fails" \
    fails env PATH="$work/bin:$PATH" tests/bench/$bench/run "$work/out"
done
