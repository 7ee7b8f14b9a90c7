# A disk that is full: what is written appears whole or not at all, what stood there before is kept,
# and the message says so. The disk is made full by a limit on the size of files whose signal is
# ignored (a write fails then as on a full disk, without a message of the system in between), and by
# a small file system where one may be mounted.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'umount "$work/small" 2>/dev/null; rm -rf "$work"' EXIT
report=$work/out.txt
full() { blocks=$1; shift; (trap '' XFSZ; ulimit -f "$blocks"; "$@") >"$work/out.txt" 2>&1; }
old() { mkdir -p "$1"; for part in f json dot; do echo "old $part" >"$1/case_03a.$part"; done; }
holds() { [ "$(cat "$1")" = "$2" ]; }   # holds FILE TEXT
kept() {
  for part in f json dot; do holds "$1/case_03a.$part" "old $part" || return 1; done
}
alone() { [ "$(ls -A "$1" | grep -c -v '\.log$')" = "${2:-3}" ]; }
says() { grep -q "$1" "$work/out.txt"; }

# one session: the file that does not fit, then one that does
session() {
  old "$work/write"
  cat >"$work/write.mac" <<E1
load("$root/gsmbp/gsmbp.mac")\$
lines : makelist(sconcat("      X(", i, ") = 0"), i, 1, 20000)\$
errcatch(gs__write_files([["$work/write/case_03a.json", ["short"]],
  ["$work/write/case_03a.f", lines]]))\$
gs__write_files([["$work/write/other.f", ["one", "two", "", "part
part"]]])\$
errcatch(gs__write_files([["/proc/no.f", ["one"]]]))\$
E1
  full 64 timeout 100 "$1" --very-quiet -b "$work/write.mac" </dev/null
}
for lisp in maxima maxima-sage; do
  has $lisp 'what it does on a full disk' || continue
  session $lisp
  check "$lisp: a file that is cut short is an error" \
    says 'case_03a.f: expected 20000 lines on the disk, found'
  check "$lisp: so is a folder that cannot be written" \
    says '/proc/no.f: expected a file that can be written'
  check "$lisp: the old files are kept" kept "$work/write"
  check "$lisp: what fits is written as it is" \
    holds "$work/write/other.f" "$(printf 'one\ntwo\n\npart\npart')"
  check "$lisp: nothing else is left behind" alone "$work/write" 4
done

old "$work/derive"
check 'derive: a full disk is an error' \
  fails full 16 share/make/derive tests/scenes/case_03a.mac "$work/derive"
check 'derive: and says so' says 'expected .* lines on the disk'
check 'derive: the old files are kept' kept "$work/derive"
check 'derive: nothing else is left behind' alone "$work/derive"
(ulimit -f 16; share/make/derive tests/scenes/case_03a.mac "$work/derive") >"$work/out.txt" 2>&1
check 'derive: a limit on the size of files is named' says 'limit on the size of files'
check 'derive: the old files are kept, killed too' kept "$work/derive"
check 'derive: nothing else is left behind, killed too' alone "$work/derive"
check 'maxima: a log that is cut short is no success' \
  fails full 4 share/make/maxima "$work/cut.log" \
  'for i thru 1000 do print(i)$ "a statement that fails"$'
check 'maxima: and says so' says 'cut.log is cut short: is the disk full'

mkdir -p "$work/tree" "$work/home"
cp -R --preserve=timestamps gsmbp share Makefile LICENSE octave "$work/tree"
rm -rf "$work/tree/gsmbp/compiled"
cd "$work/tree" || exit 1
mkdir -p share/manual
echo old >share/manual/functions.txt
touch -d '2000-01-01' share/manual/functions.txt
check 'doc: a full disk is an error' fails full 2 make --no-print-directory doc
old_alone() { holds "$1" old && [ ! -e "${2:-$1}.new" ]; }   # old_alone FILE [WHAT WAS WRITTEN]
check 'doc: the old file is kept' old_alone share/manual/functions.txt
full 40 share/make/compile
check 'compile: what is cut short is not used' fails sh -c 'ls gsmbp/compiled/*/gsmbp.*'
check 'compile: and says so' says 'compile: Maxima will load the files uncompiled'
share/make/install put "$work/home" '' '' >"$work/out.txt" &&
  echo old >"$work/home/gsmbp-files/LICENSE"
check 'install: a full disk is an error' fails full 8 \
  share/make/install put "$work/home" '' ''
check 'install: what was installed is kept' \
  old_alone "$work/home/gsmbp-files/LICENSE" "$work/home/gsmbp-files"
printf 'digraph a { %s }\n' "$(seq -s ' ' 1 300)" >"$work/graph.dot"
echo old >"$work/graph.png"
if has dot 'pictures on a full disk'; then
  check 'picture: a full disk is an error' \
    fails full 4 share/make/picture "$work/graph.dot" "$work/graph.png"
fi
check 'picture: the old file is kept' old_alone "$work/graph.png"

cd "$root" || exit 1
mkdir "$work/small"
if mount -t tmpfs -o size=32k tmpfs "$work/small" 2>/dev/null; then
  old "$work/small"
  share/make/derive tests/scenes/case_03a.mac "$work/small" >"$work/out.txt" 2>&1
  check 'a file system that is full: derive is an error' test $? -ne 0
  check 'and says so' says 'No space left on device'
  check 'and keeps the old files' kept "$work/small"
else
  echo 'ok no file system may be mounted here: only the limit was tested'
fi
