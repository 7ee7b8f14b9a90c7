# What the shell tests share:  . tests/tools/check.sh

# told CODE WHAT [FILE]: `ok WHAT` for the exit code 0, else `not ok WHAT`, the code and the end of
# FILE, whose last line is the reason
told() {
  if [ "$1" -eq 0 ]; then echo "ok $2"; return; fi
  echo "not ok $2: expected exit code 0, found $1${3:+: $(tail -n 1 "$3" | cut -c 1-200)}"
  [ -z "${3:-}" ] || tail -n 20 "$3"
}

# check WHAT COMMAND...: whether the command succeeds; the end of the file $report if it does not
check() {
  what=$1
  shift
  "$@"
  told $? "$what" "${report:-}"
}

# whole: whether all is asked for (make test-whole), not a part of what takes long
whole() { [ -n "${GSMBP_WHOLE:-}" ]; }

fails() { ! "$@"; }

# plain_path: PATH without ccache (tests/tools/job), for a compiler of the test's own in front of
# it: ccache takes the first in PATH for the true one, and the two would call each other for ever
plain_path=${PATH#/usr/lib/ccache:}

# to_the_end COMMAND...: one that prints its own results; `not ok` if it ends with an error, which
# could be before them
to_the_end() { "$@" || echo "not ok $2 comes to its end: expected exit code 0, found $?"; }

# result WHAT: `ok WHAT` if the file $report is empty, else `not ok WHAT` and its first lines
result() {
  if [ ! -s "$report" ]; then echo "ok $1"; return; fi
  found="$(wc -l <"$report"): $(head -n 1 "$report" | cut -c 1-200)"
  echo "not ok $1: expected no lines, found $found"
  head -n 8 "$report"
}

# gfortran for comparisons bit for bit: statements apart, as in modules (gs.model.fortran_flags)
fortran_apart='gfortran -O2 -ffp-contract=off -fno-tree-slp-vectorize -frecursive'

# base_fortran FOLDER: into a new folder what share/fortran had at the commit of
# tests/data/before/base and has no more, but for its lanes; lacking=yes where there is no such
# commit
base_fortran() {
  base=$(cat tests/data/before/base) into=$1 lacking=
  mkdir -p "$into" && git cat-file -e "$base" 2>/dev/null || { lacking=yes; return; }
  git archive "$base" share/fortran | tar -x -C "$into" --strip-components=2
  rm -rf "$into/README.md" "$into/solve/lapack"
  (cd share/fortran && find . -name '*.f') | (cd "$into" && xargs rm -f)
  rm -f "$into"/integrate/gslan.f "$into"/integrate/gslev.f "$into"/integrate/gsllp.f
}
# unlinked WHAT: a driver that does not link: it needs what only that commit has
unlinked() {
  if [ -z "$lacking" ]; then told 1 "$1 compiles" "$report"; return; fi
  echo "ok left out without the commit of tests/data/before/base: $1"
}

# fortran_objects FOLDER [BASE]: those of share/fortran, and of the folder BASE of base_fortran, by
# $fortran_apart in a new folder, from the cache folder if they are kept there (share/make/cache)
fortran_objects() {
  into=$1 base=${2:-none}
  set -- "$PWD"/share/fortran/*/*.f "$PWD"/share/fortran/solve/plain/*.f \
    $(find "$base" -name '*.f' 2>/dev/null)
  key=$(cat "$@" | share/make/cache key $fortran_apart -fPIC)
  share/make/cache take "$key" "$into" && return
  mkdir "$into" && (cd "$into" && $fortran_apart -fPIC -c "$@") || return
  share/make/cache add "$key" "$into" || :   # there may be no cache folder
}

# engine_program KIND FILE WORD...: the program FILE of the sources WORD with all of share/engine,
# not optimized, every warning an error: sane (under the sanitizers of addresses and undefined
# behaviour), threads (under that of threads), quad (in quad precision). The library of a kind is
# made once for all tests of a run.
engine_program() {
  kind=$1 file=$2 library=$GSMBP_TEST_DIR/engine_$1.a
  shift 2
  case $kind in
    sane) flags='-fsanitize=address,undefined -fno-sanitize-recover=all' ;;
    threads) flags=-fsanitize=thread ;;
    quad) flags=-DGSMBP_QUAD ;;
  esac
  flags="-std=c99 -O0 -g -Wall -Wextra -Werror -I$PWD/share/engine/core -I$PWD/share/engine $flags"
  (flock 9 && { [ -s "$library" ] || engine_library; }) 9>"$library.lock" >"$report" 2>&1 &&
    gcc $flags -o "$file" "$@" "$library" -pthread $([ "$kind" != quad ] || echo -lquadmath) -lm \
      >"$report" 2>&1
}
engine_library() {
  host=$PWD/share/engine/host
  set -- "$PWD"/share/engine/core/*/*.c "$PWD"/share/engine/core/*/*/*.c "$host"/*.c \
    "$host"/run/*.c "$host"/derivatives/*.c "$host"/ensemble/*.c
  [ "$kind" = quad ] || set -- "$@" "$host"/implicit/*.c "$host"/lanes/*.c
  objects=$(mktemp -d) && trap 'rm -rf "$objects"' EXIT && cd "$objects" || return
  for source; do   # one by one, for ccache
    gcc $flags -c "$source" || return
  done
  ar rcs new.a ./*.o && mv new.a "$library"
}

# headers_in_cplusplus HEADER...: those of share/engine compile as C++
headers_in_cplusplus() {
  for header; do
    g++ -x c++ -Wall -Wextra -Wno-pragmas -Ishare/engine/core -Ishare/engine -fsyntax-only \
      -include "$header" - </dev/null
  done >"$report" 2>&1
  result 'the headers compile as C++'
}

# python_packages WITH SCENE...: adds to $statements what writes packages of Python of these scenes
# of tests/scenes into $work/folders; WITH: ', requests' for their requests (all by default)
python_packages() {
  with=$1
  shift
  : "${statements:=load(\"$PWD/gsmbp/gsmbp.mac\")\$}"
  for scene; do
    statements="$statements kill(scene)\$ requests : all\$ load(\"$PWD/tests/scenes/$scene.mac\")\$
      gsmbp_package(scene, python$with, directory = \"$work/folders/$scene\")\$"
  done
}
# python_modules WHAT: these packages are written, and built as modules in $work
python_modules() {
  share/make/maxima "$work/log" "$statements" >"$report" 2>&1
  told $? "$1" "$report"
  build_modules
}
# build_modules: the folders in $work/folders as modules in $work; quickly, where GSMBP_TIMES does
# not ask for times
build_modules() {
  for folder in "$work"/folders/*; do
    name=${folder##*/}
    [ -n "${GSMBP_TIMES:-}" ] || sed -i 's/-O2/-O0/' "$folder/setup.py"
    (cd "$folder" && /usr/bin/python3 setup.py -q build_py -d built &&
      mv "built/$name" "$work/$name") >"$report" 2>&1 || told 1 "$name builds" "$report"
  done
}
# stubs_are_python: those of the modules in $work
stubs_are_python() {
  for stub in "$work"/*/__init__.pyi; do
    /usr/bin/python3 -m py_compile "$stub" || echo "$stub"
  done >"$report" 2>&1
  result 'their stubs are Python'
}

# work_folder: a folder $work for the test, gone at its end, and in it the file $report
work_folder() {
  work=$(mktemp -d) || exit 1
  trap 'rm -rf "$work"' EXIT
  report=$work/report
}

# has_all WHAT PROGRAM...: whether all are there; without them a line says that WHAT is left out
has_all() {
  what=$1
  shift
  for program; do has "$program" "$what" || return 1; done
}

# has PROGRAM WHAT: whether it is there; without it a line says that WHAT is left out
has() {
  command -v "$1" >/dev/null && return
  echo "ok left out without $1: $2"
  return 1
}

# without_root_powers COMMAND...: root may write everywhere; this root may not
without_root_powers() {
  if [ "$(id -u)" -ne 0 ]; then "$@"; return; fi
  setpriv --bounding-set -dac_override,-dac_read_search -- "$@"
}
