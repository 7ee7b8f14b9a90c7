# The image of Maxima with GSMBP loaded (share/make/image): its sessions are like those that have
# loaded the sources, and emit the same text; it is not used once a source, Maxima or the image has
# changed; it appears whole or not at all, and is not installed.
. tests/tools/check.sh
case $(ls gsmbp/compiled) in
  *GCL*) ;;
  *) echo 'ok Maxima is not on GCL: there is no image'; exit 0 ;;
esac
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out.txt
mkdir -p "$work/tree/tests" "$work/user"
cp -R --preserve=timestamps gsmbp share LICENSE octave "$work/tree"
cp -R tests/scenes "$work/tree/tests"
cd "$work/tree" || exit 1
echo 'A pendulum' >share/manual/gsmbp.info   # in the place of the manual
cat >share/manual/gsmbp-index.lisp <<'END'
(in-package :cl-info)
(load-info-hashtables (maxima::maxima-load-pathname-directory) nil
                      '(("A pendulum" . ("gsmbp.info" 0 10))))
END
make_image() { share/make/image make gsmbp/compiled/*GCL* >"$report" 2>&1; }
# used [BEFORE]: whether a session that begins with BEFORE and load comes from the image
used() {
  share/make/maxima "$report" "${1:-}load(\"gsmbp/gsmbp.mac\")\$ if gsmbp_version # \"\" then 1\$
:lisp (format t \"~&lisp ~a~%\" (si::argv 0))" 2>"$work/errors" &&
    grep -q '^lisp /.*/image$' "$report"
}
derive() { share/make/derive tests/scenes/case_03a.mac "$work/$1" >"$report" 2>&1; }
same() { derive "$1" && cmp "$GSMBP_TEST_DIR/fortran_out/case_03a.f" "$work/$1/case_03a.f"; }
# what differs between any two sessions: numbers of new symbols, times, addresses, the two commands
# and what they read; a folder of messages that Maxima notes each time it starts
apart='COMMON-LISP:\*GENSYM-COUNTER\*|INTL:\*LOCALE-DIRECTORIES\*|SYSTEM::?\*COMMAND-ARGS\*'
apart="$apart|SYSTEM::?\*(LINK-ARRAY|STREAM-ALIST)\*|(LIB:)?.lib[cm].(:.*)?"
apart=$apart'|MAXIMA::(\$%|\$_|\$%[IO][12]|ACCUMULATED-TIME)'
# state WHICH: the state of a session as $work/state.WHICH
state() {
  GSMBP_STATE=$work/state share/make/maxima "$report" \
    "load(\"$PWD/gsmbp/gsmbp.mac\")\$ load(\"$root/tests/tools/state.lisp\")\$" &&
    sed -E 's/(ENTRIES|gsmbp-)[0-9]+(-[A-Za-z0-9]+)?/\1/g' "$work/state" |
    grep -vE "^($apart):" >"$work/state.$1"
}

check 'the image of another folder is not used' fails used
rm -f gsmbp/compiled/*/image gsmbp/compiled/*/start
check 'without an image the sources are loaded' fails used
check 'the same text as in the tests' same sources
state sources
told $? 'the state of a session with the sources' "$report"
(ulimit -f 50000; make_image)
check 'on a disk that is full there is none' fails sh -c 'ls gsmbp/compiled/*/image 2>/dev/null'
check 'an image is made' make_image
check 'and used' used
check 'the same text from the image' same image
state image
told $? 'the state of a session from the image' "$report"
diff "$work/state.sources" "$work/state.image" 2>&1 | cut -c 1-500 >"$report"
result 'the two states are equal'
functions=$(grep -c '^MAXIMA::\$GSMBP_' "$work/state.image")
check 'the states have the functions of GSMBP' test "$functions" -gt 50
before=$(ls -i gsmbp/compiled/*/image)
make_image
check 'what is up to date is not made again' test "$(ls -i gsmbp/compiled/*/image)" = "$before"

check 'not used where a statement comes before load' fails used 'x : 1$ '
check 'load in a session from the image loads' share/make/maxima "$report" \
  'load("gsmbp/gsmbp.mac")$ kill(gs__sources)$ load("gsmbp/gsmbp.mac")$
  if not listp(gs__sources) then gs__exit(1)$'
check 'an error is one' fails share/make/maxima "$report" \
  'load("gsmbp/gsmbp.mac")$ error("no")$' 2>"$work/errors"
GSMBP_TIMEOUT=1 share/make/maxima "$work/log" 'load("gsmbp/gsmbp.mac")$ do 1$' 2>"$report"
check 'the limit of processor time holds' grep -q 'stopped after 1 seconds of processor' "$report"
printf '#!/bin/sh\nexec maxima "$@"\n' >"$work/maxima" && chmod +x "$work/maxima"
export MAXIMA="$work/maxima"
check 'not used for another Maxima' fails used
unset MAXIMA
export MAXIMA_TEMPDIR="$work"
check 'not used with other variables of Maxima' fails used
unset MAXIMA_TEMPDIR

touch gsmbp/elsewhere.mac
share/make/image make gsmbp/compiled/*GCL* &
sleep 0.3
kill -9 $!
check 'not used after an update that was killed' fails used
make_image & make_image
wait
check 'two updates at once: the same text' same two
make_image
check 'and an image' used
check 'and nothing else' test -z "$(find gsmbp/compiled -name '.new-*')"

image=$(ls gsmbp/compiled/*/image)
cp --preserve=timestamps "$image" "$work/whole"
head -c 30000000 "$work/whole" >"$image"
check 'not used when it is cut short' fails used
check 'and the text is the same' same short
touch -r "$work/whole" "$image"
check 'nor with its old time' fails used
make_image
check 'made again, used again' used
touch "$(ls gsmbp/compiled/*/image)"
check 'not used with another time' fails used
make_image
printf 'gsmbp_marked : 7$\n' >>gsmbp/elsewhere.mac
check 'not used once a source has changed' fails used
check 'and the source is loaded' share/make/maxima "$report" \
  'load("gsmbp/gsmbp.mac")$ if gsmbp_marked # 7 then gs__exit(1)$'
share/make/install put "$work/user" '' '' >"$report" 2>&1
check 'what is compiled is installed' test "$(find "$work/user" -name gsmbp.o | wc -l)" -eq \
  "$(find gsmbp -name gsmbp.o | wc -l)"
check 'but no image' test -z "$(find "$work/user" -name image -type f -size +9k)"
