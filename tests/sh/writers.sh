# One function writes files in each language: nothing else opens files for writing or renames them.
# A part of the table of writers and hazards (tests/writers/check; make test-writers has all of it).
. tests/tools/check.sh
work_folder

# only LANGUAGE PATTERN ALLOWED FILE...: lines of the files (comments left out) that hold the
# pattern stand in files that ALLOWED, another pattern, names
only() {
  language=$1 pattern=$2 allowed=$3
  shift 3
  grep -nE "$pattern" "$@" /dev/null | grep -vE '^[^:]*:[0-9]+: *(%|#|;|\*|//|/\*)' |
    grep -vE "^($allowed):" >"$report"
  result "one function writes files: $language"
}
files() { find "$@" ! -path '*/compiled/*' ! -path 'share/package/*' ! -name '*.texi'; }

only Maxima 'openw|opena|writefile|stringout|:direction :output|rename-file|with_stdout' \
  'gsmbp/(kernel/(files|statements|compiled|progress)|show/choose_modes).(mac|lisp)' \
  $(files gsmbp share -name '*.mac' -o -name '*.lisp')
only Octave 'fopen \(.*"[wa]|\<rename \(|copyfile|movefile|dlmwrite|csvwrite|imwrite|\<save \(' \
  'octave/.gs/.files/(write_text|rename_new).m' $(files octave -name '*.m')
only C '\<rename \(|freopen|mkstemp' 'octave/glue/sweep_place.c' \
  $(files octave share -name '*.c' -o -name '*.cc' -o -name '*.h')
only C 'fopen \(.*"[wa]|O_CREAT|H5Fcreate' 'octave/glue/sweep_(files|table|program).c' \
  $(files octave share -name '*.c' -o -name '*.cc' -o -name '*.h')
# install swaps a folder, the Makefile of a sweep makes its program, cache checks its entries
only shell '\<(mv|mktemp) ' 'share/make/(place|install|cache)|share/sweep/Makefile' \
  $(grep -lE '^#!/bin/sh' -r share) share/sweep/Makefile
# notebook writes into a temporary folder, render.py into that of pip
only Python "os\\.(replace|rename)|open\\(.*'[wa]" 'share/make/notebook|share/python/render.py' \
  $(grep -lE '^#!.*python' -r share) $(files share -name '*.py')

tests/writers/check short
