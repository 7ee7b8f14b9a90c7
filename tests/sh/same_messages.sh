# Some seventy bad calls (tests/before/calls.json): Octave, Python, FMUs and the program of a sweep
# say the same, but for the words of the language.
. tests/tools/check.sh
work_folder
GSMBP_TEST_DIR=$work GSMBP_BEFORE=$work tests/before/calls >"$report" 2>&1
told $? 'the bad calls are made' "$report"
to_the_end /usr/bin/python3 tests/before/same.py "$work/calls.txt"
sed '/^  python: .*below 1; found -1$/s/below/under/' "$work/calls.txt" >"$work/other.txt"
/usr/bin/python3 tests/before/same.py "$work/other.txt" >"$report"
[ $? = 1 ] && [ "$(grep -c '^not ok call 22 ' "$report")" = 1 ] &&
  [ "$(grep -c '^not ok' "$report")" = 1 ]
told $? 'another word of one host is found' "$report"
