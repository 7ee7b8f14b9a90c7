#!/bin/sh
# The maps are true: gsmbp/README.md, share/fortran/README.md, share/engine/core/README.md and
# tests/README.md name every file and routine that is there and none that is not; comments name
# files that exist; one version.
/usr/bin/python3 tests/tools/guide.py .

# in a checkout: nothing that a command writes is under version control
. tests/tools/check.sh
report=$(mktemp)
trap 'rm -f "$report"' EXIT
has git 'what is under version control' || exit 0
git ls-files --cached --ignored --exclude-standard >"$report" 2>/dev/null
git ls-files 2>/dev/null | grep '/' | cut -d/ -f1 | sort -u |
  grep -vxE '\.ci|gsmbp|share|examples|octave|tests' >>"$report"
result 'nothing that a command writes is under version control'
