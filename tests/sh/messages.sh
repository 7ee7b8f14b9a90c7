# Every message of the package stands in the manual, and the tool that says so misses one that does
# not.
. tests/tools/check.sh
dir=$(mktemp -d "${GSMBP_TEST_DIR:-/tmp}/messages.XXXXXX")
/usr/bin/python3 tests/tools/messages.py
grep -v 'must be ground or a link of the scene' share/manual/errors.texi \
  >"$dir/less.texi"
/usr/bin/python3 tests/tools/messages.py "$dir/less.texi" >"$dir/log"
[ $? = 1 ] && [ "$(grep -c 'must be ground or a link' "$dir/log")" = 1 ] &&
  [ "$(wc -l <"$dir/log")" = 1 ]
told $? 'a message that the manual lacks is found' "$dir/log"
