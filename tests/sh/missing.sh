# Without dpkg, and one at a time without Graphviz, Ghostscript, SUNDIALS, ftnchek, Maxima on ECL:
# on a small project whose PATH is a folder of links to the other programs; what can run runs, one
# line says what is missing for what. Without a compiler make stops, without makeinfo there is no
# manual.
. tests/tools/check.sh
PATH=$plain_path
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out.txt
says() { grep -qF -- "$1" "$report"; }
lines() { [ "$(grep -c '^GSMBP: missing: ' "$report")" -eq "$1" ]; }

# every program but dpkg-query, apt-get and those named; gcc finds headers as `headers` says
bin=$work/bin
mkdir "$work/all"
for folder in $(echo "$PATH" | tr : ' '); do
  [ ! -d "$folder" ] || ln -s "$folder"/* "$work/all" 2>/dev/null
done
cp -R -P "$work/all" "$bin"
headers=yes
changed=   # programs in $bin that are not those of $work/all
path_without() {
  for program in $changed; do
    rm -f "$bin/$program"
    cp -P "$work/all/$program" "$bin" 2>/dev/null
  done
  changed="dpkg-query apt-get $*"
  for program in $changed; do rm -f "$bin/$program"; done
  [ $headers = yes ] && return
  gcc=$(readlink -f "$bin/gcc")
  in_its_place gcc \
    "$(printf 'case $* in *"-E "*/header_*) exit 1 ;; esac\nexec %s "$@"' "$gcc")"
}
# in_its_place PROGRAM TEXT: a script as this program
in_its_place() {
  changed="$changed $1"
  rm -f "$bin/$1"
  printf '#!/bin/sh\n%s\n' "$2" >"$bin/$1"
  chmod +x "$bin/$1"
}
here() { PATH=$bin "$@" >"$report" 2>&1; }
make_() { here make --no-print-directory "$@"; }

mkdir -p "$work/project/gsmbp" "$work/project/share"
cp Makefile "$work/project" && cp -R share/make "$work/project/share"
cp --parents share/engine/host/*/header_* "$work/project"
cd "$work/project" || exit 1
cat >gsmbp/gsmbp.mac <<'E1'
gsmbp_fortran(name, requests, options) := block([folder : rhs(first(options))],
  with_stdout(sconcat(folder, "/", name, ".json"), print("{}")),
  with_stdout(sconcat(folder, "/", name, ".f"), print("      END")))$
gsmbp_graph_picture(name, file) := with_stdout(file, print("digraph { a -> b }"))$
gs__check_scene_of_file(scene, name) := true$
E1
for name in easy stiff; do
  mkdir -p examples/$name && echo "scene : \"$name\"\$" >examples/$name/$name.mac
done
echo 'disp ("runs")' >examples/easy/run.m
echo 'method = "cvode", disp ("runs")' >examples/stiff/run.m

# without PROGRAM PACKAGE LOST: make examples is as it is with it, but for what is LOST
without() {
  path_without "$1"
  rm -rf examples/*/out
  make_ examples
  told $? "without $1: make examples" "$report"
  check "without $1: one line" lines 1
  check "without $1: what is missing for what" says "GSMBP: missing: $2, for $3"
  check "without $1: both are made" test -e examples/easy/out/finished -a \
    -e examples/stiff/out/finished
}
path_without
if make_ packages && lines 0; then
  without dot 'dot (Debian: graphviz)' 'the drawing of the system graph'
  check 'without dot: no drawing' fails test -e examples/easy/out/graph.png
  check 'without dot: which' \
    says 'picture: examples/easy/out/graph.png is left out: there is no dot (Debian: graphviz)'
  without gs 'gs (Debian: ghostscript)' 'the pictures in the PDF of the manual'
  check 'with dot: a drawing' test -s examples/easy/out/graph.png
  without ftnchek ftnchek 'one of the tests of the emitted Fortran'
  without maxima-sage maxima-sage 'Maxima on ECL'
  headers=no
  path_without
  rm -rf examples/*/out
  check 'without SUNDIALS: make examples' make_ examples
  check 'without SUNDIALS, Ipopt and NLopt: three lines' lines 3
  check 'without SUNDIALS: what is missing for what' \
    says 'GSMBP: missing: libsundials-dev, for method "cvode" of gsmbp_simulate'
  check 'without Ipopt: what is missing for what' \
    says 'GSMBP: missing: coinor-libipopt-dev, for gsmbp_collocate'
  check 'without NLopt: what is missing for what' \
    says 'GSMBP: missing: libnlopt-dev, for gsmbp_optimize'
  check 'without SUNDIALS: an example with it is left out' fails test -e examples/stiff/out/finished
  check 'without SUNDIALS: and named' \
    says 'examples/stiff is left out: it needs libsundials-dev'
  check 'without SUNDIALS: the other is made' test -e examples/easy/out/finished
  headers=yes
else
  sed 's/^GSMBP: missing: /ok left out, for this machine is without: /' "$report"
fi

# an apt that has no maxima-sage, as Ubuntu's, of a root: what it has is installed, ftnchek here
path_without
all=$(share/make/packages list)
in_its_place id 'echo 0'
there=$(echo " $all " | sed 's/ maxima-sage maxima-sage-share / /; s/ ftnchek / /')
in_its_place dpkg-query "for p in $there; do
  printf 'installed %s ' \$p; done; [ ! -e '$work/installed' ] || printf 'installed ftnchek '"
in_its_place apt-cache 'case $2 in maxima-sage*) echo "  Candidate: (none)" ;;
*) echo "  Candidate: 1" ;; esac'
in_its_place apt-get "echo \"\$*\" >>'$work/asked'; case \$* in *maxima-sage*) exit 100 ;; esac
case \$1 in install) touch '$work/installed' ;; esac"
check 'apt without maxima-sage: make goes on' make_ packages
check 'apt without maxima-sage: the rest is installed, and maxima-sage not asked for' \
  test "$(grep -c 'install.* ftnchek$' "$work/asked") $(grep -c maxima-sage "$work/asked")" = '1 0'
check 'apt without maxima-sage: named' says 'GSMBP: missing: maxima-sage, for Maxima on ECL'
rm "$work/asked" "$work/installed"
in_its_place apt-get "echo \"\$*\" >>'$work/asked'; [ \$1 = update ]"
check 'apt that fails: make goes on without what not everything needs' make_ packages
check 'apt that fails: ftnchek, too, is named' says 'GSMBP: missing: ftnchek, for one of the tests'

path_without gfortran dot
check 'without a compiler make stops' fails make_ examples
check 'without a compiler: it is named, and nothing else' \
  grep -q 'this is no Debian where it could install them: gfortran$' "$report"
path_without gfortran dot ftnchek
here share/make/packages missing run
check 'what an installed package needs: the compiler alone' \
  test "$(cat "$report")" = 'GSMBP: missing: gfortran, for everything that runs'

path_without maxima-sage
cd "$root" || exit 1
here sh tests/sh/ecl.sh
check 'the tests say what they leave out' \
  test "$(cat "$report")" = 'ok left out without maxima-sage: the same text on two Lisps'
path_without makeinfo
check 'without makeinfo: make install' make_ install MAXIMA_USERDIR="$work/.maxima"
check 'without makeinfo: there is no manual, in one line' \
  test "$(grep -c 'install: without the manual' "$report")" -eq 1
check 'without makeinfo: the package is installed' test -s "$work/.maxima/gsmbp.mac"
# with that folder of the user in its environment make has made another image of Maxima: the other
# tests go on with theirs
PATH=$plain_path share/make/compile >"$report" 2>&1 </dev/null
told $? 'the image of Maxima is made again' "$report"
