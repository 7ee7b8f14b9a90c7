# The compiled Lisp files: what is emitted is the same text with them and without; none is used that
# is not newer than every source, and where nothing can be compiled the sources are loaded.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out.txt
compile() { share/make/compile >"$work/out.txt" 2>&1; }
derive() { share/make/derive tests/scenes/case_03a.mac "$work/$1"; }
same() { derive "$1" && cmp "$GSMBP_TEST_DIR/fortran_out/case_03a.f" "$work/$1/case_03a.f"; }
used() {
  share/make/maxima "$work/out.txt" 'load("gsmbp/gsmbp.mac")$
    if gs__is_compiled("gsmbp/") then gs__exit(86)$ gs__exit(1)$' 2>"$work/errors"
}

mkdir "$work/tree"
cp -R --preserve=timestamps gsmbp share "$work/tree"
mkdir "$work/tree/tests"
cp -R tests/scenes "$work/tree/tests"
cd "$work/tree" || exit 1
rm -rf gsmbp/compiled
check 'without compiled files: the same text' same sources
check 'the sources are loaded' fails used

mkdir "$work/bin"   # no C compiler
for name in gcc cc; do
  printf '#!/bin/sh\nexit 1\n' >"$work/bin/$name"
  chmod +x "$work/bin/$name"
done
PATH=$work/bin:$PATH check 'without a compiler share/make/compile does not fail' compile
check 'and says that the sources are loaded' grep -q 'uncompiled' "$work/out.txt"
PATH=$plain_path GSMBP_TIMEOUT=1 compile   # ccache takes less than a second
check 'the reason of a compilation that ends too early is told' grep -q \
  'uncompiled, .*stopped after 1 seconds of processor time' "$work/out.txt"
check 'nothing is left behind' fails sh -c 'ls gsmbp/compiled/*/gsmbp.* >/dev/null 2>&1'

compile
if grep -q 'compilation failed' "$work/out.txt"; then
  echo 'ok this Lisp cannot compile here: only the sources were tested'
  exit 0
fi
check 'compiled files are loaded' used
rm -f gsmbp/compiled/*/start   # no image, which image.sh tests: the compiled file is loaded
check 'with compiled files: the same text' same compiled
file=$(ls gsmbp/compiled/*/gsmbp.*)
compile
check 'what is up to date is not compiled again' \
  test "$(ls -i gsmbp/compiled/*/gsmbp.*)" = "$(ls -i "$file")"
before=$(ls -i "$file")
whole && touch gsmbp/tape/code.lisp && {
  check 'not used once a source is newer' fails used
  compile
  check 'compiled again' test "$(ls -i "$file")" != "$before"
  check 'and used' used
}
parsed=$(ls gsmbp/compiled/*/statements)
printf 'gsmbp_marked : 7$\n' >>gsmbp/elsewhere.mac
check 'a statement that is new in a .mac file is seen' \
  share/make/maxima "$work/out.txt" 'load("gsmbp/gsmbp.mac")$ if gsmbp_marked # 7 then gs__exit(1)$'
compile
check 'statements are read anew' grep -q GSMBP_MARKED "$parsed"
sleep 1.1
sed -i 's/gsmbp_marked : 7/gsmbp_marked : 42/' gsmbp/elsewhere.mac   # as of another version:
touch -d 2001-01-01 gsmbp/elsewhere.mac   # it may be older than what was compiled
check 'a .mac file that is older, of another size, is seen' \
  share/make/maxima "$work/out.txt" \
    'load("gsmbp/gsmbp.mac")$ if gsmbp_marked # 42 then gs__exit(1)$'
compile
check 'and its statements are read anew' grep -q 'GSMBP_MARKED.*42' "$parsed"
printf '(defvar *gs-marked* 42)\n' >>gsmbp/tape/code.lisp
touch -d 2001-01-01 gsmbp/tape/code.lisp
check 'a Lisp file that is older, of another size, is seen' \
  share/make/maxima "$work/out.txt" \
    'load("gsmbp/gsmbp.mac")$ if ?\*gs\-marked\* # 42 then gs__exit(1)$'
sleep 1.1
head -c 20000 "$parsed" >"$work/cut" && cp "$work/cut" "$parsed"
check 'what is cut short is not used' same short
