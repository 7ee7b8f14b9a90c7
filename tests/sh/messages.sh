# Every message of the package stands in the manual, and the tool that says so misses one that does
# not.
. tests/tools/check.sh
dir=$(mktemp -d "${GSMBP_TEST_DIR:-/tmp}/messages.XXXXXX")
to_the_end /usr/bin/python3 tests/tools/messages.py
grep -v 'places: expected 3 x k finite numbers' share/manual/errors.texi \
  >"$dir/less.texi"
/usr/bin/python3 tests/tools/messages.py "$dir/less.texi" >"$dir/log"
[ $? = 1 ] && [ "$(grep -c 'places: expected 3 x k finite numbers' "$dir/log")" = 1 ] &&
  [ "$(wc -l <"$dir/log")" = 1 ]
told $? 'a message that the manual lacks is found' "$dir/log"
