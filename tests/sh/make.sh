# The Makefile on a small project of its own: a stand-in package and one example. What changed is
# redone, what broke is never trusted.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/gsmbp" "$work/octave" "$work/examples/demo" "$work/share"
cp "$root/Makefile" "$work"
cp -R "$root/share/make" "$work/share"
cd "$work" || exit 1
cat >gsmbp/gsmbp.mac <<'E1'
gsmbp_fortran(name, requests, options) := block([folder : rhs(first(options))],
  with_stdout(sconcat(folder, "/", name, ".json"), print("{}")),
  with_stdout(sconcat(folder, "/", name, ".f"), print("      END")))$
gsmbp_graph_picture(name, file) := with_stdout(file, print("digraph { a -> b }"))$
E1
echo 'scene : "demo"$' >examples/demo/demo.mac
cat >examples/demo/run.m <<'M'
fid = fopen ("examples/demo/out/table.csv", "a"); fdisp (fid, 1); fclose (fid);
M

report=out.txt
make_() { make --no-print-directory "$@" >out.txt 2>&1; }
derives() { grep -q 'share/make/derive' out.txt; }
runs() { grep -q 'octave-cli' out.txt; }
later() { sleep 1.1; touch "$@"; }   # file times may have a grain of a second

check 'help is the default target' sh -c 'make | grep "make examples" >out.txt'
check 'examples are derived and run' make_ examples
check 'the run left its table' test -s examples/demo/out/table.csv
check 'Fortran and JSON are there' test -s fortran_out/demo.f -a -s fortran_out/demo.json
make_ examples
check 'a second run derives nothing' fails derives
check 'a second run runs nothing' fails runs
later examples/demo/run.m; make_ examples
check 'a new driver is run again' runs
check 'a new driver derives nothing' fails derives
later gsmbp/gsmbp.mac; make_ examples
check 'a new package derives again' derives
check 'and runs again' runs

sleep 1.1; echo 'error ("no figure");' >examples/demo/run.m
check 'a driver that fails stops make' fails make_ examples
check 'and leaves no stamp' fails test -e examples/demo/out/finished
sleep 1.1; echo 'scene : error("link", 7, "has no mass")$' >examples/demo/demo.mac
check 'a scene that fails stops make' fails make_ fortran_out/demo.f
check 'its error is shown' grep -q 'link 7 has no mass' out.txt
echo 'scene : "demo" oops$' >examples/demo/demo.mac
check 'a syntax error stops make' fails make_ fortran_out/demo.f
echo 'scene : "omed"$' >examples/demo/demo.mac
rm -rf fortran_out
check 'a scene of another name stops make' fails make_ fortran_out/demo.f
mkdir -p tests/bench/systems && echo 'scene : "pend_r1em06"$' >tests/bench/systems/pend_r1e-06.mac
check 'a name that Fortran cannot have is that of the files' make_ fortran_out/pend_r1e-06.f
check 'all of them, and no others' test "$(cd fortran_out && echo pend*)" = \
  'pend_r1e-06.dot pend_r1e-06.f pend_r1e-06.json pend_r1e-06.log'
rm -rf tests
echo 'do 1$' >examples/demo/demo.mac
make --no-print-directory fortran_out/demo.f >out.txt 2>&1 & child=$!
sleep 2; kill -TERM $child; wait $child
check 'an interrupted derivation leaves no Fortran' fails test -e fortran_out/demo.f
sleep 0.5
check 'and no Maxima behind' fails grep -qs "$work" /proc/[0-9]*/cmdline
make_ clean
check 'clean removes what make wrote' fails test -e fortran_out -o -e examples/demo/out

mkdir bin
cat >bin/dpkg-query <<'E2'
#!/bin/sh
for package; do
  case $package in
    -*) ;;
    ghostscript|maxima-share) [ ! -e apt.txt ] || printf 'installed %s ' "$package" ;;
    *) printf 'installed %s ' "$package" ;;
  esac
done
E2
printf '#!/bin/sh\necho 1000\n' >bin/id
chmod +x bin/*
PATH=$work/bin:$PATH
check 'without root a missing package stops make' fails make_ examples
check 'the message names the packages and no others' \
  grep -q 'no-install-recommends maxima-share ghostscript$' out.txt
names_numpy() { share/make/packages list "$@" | grep -q numpy; }
check 'the tests need numpy' names_numpy test
check 'nothing else does' fails names_numpy
printf '#!/bin/sh\necho 0\n' >bin/id
printf '#!/bin/sh\necho "apt-get $*" >>%s/apt.txt\n' "$work" >bin/apt-get
chmod +x bin/*
check 'with root they are installed' make_ packages
check 'after an update' test "$(head -n 1 apt.txt)" = 'apt-get update'
check 'by name' grep -q 'install -y --no-install-recommends maxima-share ghostscript$' apt.txt

# what a command writes here (.gitignore), make clean removes, but for libraries and Python's own
made=$(sed -n 's,^/\(.*[^/]\)$,\1,p' "$root/.gitignore" | tr -d '*')
for file in $made; do mkdir -p "$(dirname "$file")" && touch "$file"; done
mkdir -p fmu_out share/package && touch fmu_out/a.fmu share/package/a.tar.gz octave-workspace
make_ clean
for file in $made fmu_out share/package octave-workspace; do
  [ ! -e "$file" ] || echo "$file"
done >"$work/left"
[ ! -s "$work/left" ]; told $? 'make clean leaves nothing that a command wrote' "$work/left"
