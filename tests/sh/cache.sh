# The run time is compiled once for each user (share/make/cache): what the cache gives is what was
# compiled; changed sources, damaged entries, kills, folders that cannot be written. The script
# alone; then a library of an integrator in Octave, gsmbp_build, an FMU and a Python package.
. tests/tools/check.sh
PATH=$plain_path
root=$PWD
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
report=$work/report
cache=$root/share/make/cache
users=$("$cache" folder)
export GSMBP_CACHE="$work/cache"
objects=$GSMBP_CACHE/objects

# -- the script
echo 'int one = 1;' >"$work/a.c"
key=$("$cache" key gcc -O2 <"$work/a.c")
same() { test "$key" = "$("$@")"; }
check 'the same sources, compiler and options: the same key' same "$cache" key gcc -O2 <"$work/a.c"
check 'other options: another key' fails same "$cache" key gcc -O1 <"$work/a.c"
check 'another compiler: another key' fails same "$cache" key gfortran -O2 <"$work/a.c"
mkdir "$work/bin"   # gcc as on another processor
printf '#!/bin/sh\nexec %s $(echo "$@" | sed s/march=native/march=nocona/)\n' "$(command -v gcc)" \
  >"$work/bin/gcc"
chmod +x "$work/bin/gcc"
check 'the same options on another processor: another key' \
  test "$("$cache" key gcc -march=native </dev/null)" != \
  "$(PATH=$work/bin:$PATH "$cache" key gcc -march=native </dev/null)"
check 'but not where they do not name it' \
  test "$("$cache" key gcc -O2 </dev/null)" = \
  "$(PATH=$work/bin:$PATH "$cache" key gcc -O2 </dev/null)"
echo '/* changed */' >>"$work/a.c"
check 'changed sources: another key' fails same "$cache" key gcc -O2 <"$work/a.c"

mkdir -p "$work/made/sub"
head -c 300000 /dev/urandom >"$work/made/a.o"
echo 'second' >"$work/made/sub/it's b.o"
# given: what the cache gives is what was made
given() {
  rm -rf "$work/out"
  "$cache" take "$key" "$work/out" && diff -r "$work/made" "$work/out"
}
# nothing: it gives nothing, and leaves no part of it
nothing() { rm -rf "$work/out"; fails "$cache" take "$key" "$work/out" && [ ! -e "$work/out" ]; }
keep() { "$cache" add "$key" "$work/made"; }
check 'an empty cache gives nothing' nothing
check 'files are kept' keep
check 'and given back' given
entry=$objects/$key
size=$(wc -c <"$entry")
cp "$entry" "$work/entry"
for at in 0 30 70 600 200000 $((size - 3000)); do   # the sum, names and contents in the archive
  byte=$(dd if="$work/entry" bs=1 skip=$at count=1 2>/dev/null | tr '\000-\377' '\001-\377\000' |
    od -An -to1 | tr -d ' ')
  cp "$work/entry" "$entry"
  printf "\\$byte" | dd of="$entry" bs=1 seek=$at conv=notrunc 2>/dev/null
  check "a flipped byte at $at is noticed" nothing
  check 'the damaged entry is removed' fails test -e "$entry"
done
for length in 0 40 65 66 5000 $((size - 1)); do
  head -c "$length" "$work/entry" >"$entry"
  check "an entry cut off after $length bytes is noticed" nothing
done
check 'it is kept anew' keep
check 'and given' given

# two that add and take at once, one that is killed again and again
: >"$report"
for k in 1 2 3 4 5 6 7 8; do
  "$cache" add "$key" "$work/made" &
  { "$cache" take "$key" "$work/out$k" && diff -r "$work/made" "$work/out$k"; } >>"$report" 2>&1 &
done
wait
result 'eight at once'
check 'the last one stays whole' given
for k in 002 005 008 011 014 017 02 025 03 05; do
  rm -f "$entry"
  "$cache" add "$key" "$work/made" &
  sleep 0.$k
  kill -9 $! 2>/dev/null
  wait $! 2>/dev/null
  [ ! -e "$entry" ] || given || echo "after 0.$k s"
done >"$report" 2>&1
result 'killed while it adds: nothing or all'
sleep 0.5   # their children end
touch -d '2 days ago' "$objects"/.new-* 2>/dev/null
for k in 1 2 3 4 5; do
  truncate -s 30M "$objects/$k"
  touch -d "$k hours ago" "$objects/$k"
done
touch -d '61 days ago' "$objects/old"
keep && given
check 'what killed ones left is removed' test -z "$(ls -A "$objects" | grep new)"
check 'what was not used for 60 days is removed' fails test -e "$objects/old"
check 'the 100 MB used last stay' test -e "$entry" -a -e "$objects/3" -a ! -e "$objects/4" -a \
  ! -e "$objects/5"

# nowhere to keep anything: no cache, no message
none() {
  subject=$1
  shift
  for task in folder "take $key $work/none" "add $key $work/made"; do
    "$@" "$cache" $task && echo "$task"
  done >"$report" 2>&1
  result "$subject: no cache"
}
none 'GSMBP_CACHE=none' env GSMBP_CACHE=none
none 'no HOME' env -u HOME -u GSMBP_CACHE -u XDG_CACHE_HOME
none 'HOME is empty' env -u GSMBP_CACHE -u XDG_CACHE_HOME HOME=
none 'a file in the place of the folder' env GSMBP_CACHE="$work/a.c"
mkdir "$work/closed"
chmod a-w "$work/closed"
none 'a folder that cannot be written' without_root_powers env GSMBP_CACHE="$work/closed"
if [ "$(id -u)" -eq 0 ]; then
  mkdir -p "$work/others/objects"
  chown 65534 "$work/others/objects"
  none 'the folder of another user' env GSMBP_CACHE="$work/others"
fi
said() { test "$("$@" "$cache" folder)" = "$folder/objects"; }
folder=$work/home/.cache/gsmbp
check 'by default below HOME' said env -u GSMBP_CACHE -u XDG_CACHE_HOME HOME="$work/home"
check 'XDG_CACHE_HOME is absolute' said env -u GSMBP_CACHE XDG_CACHE_HOME=x HOME="$work/home"
folder=$work/xdg/gsmbp
check 'or below XDG_CACHE_HOME' said env -u GSMBP_CACHE XDG_CACHE_HOME="$work/xdg"

# -- Octave: a module in two folders
has script 'the cache in Octave' || exit 0
cp octave/hand/motor_pendulum.* "$work"
mkdir "$work/octave"
[ -z "$users" ] || cp -Rp "$users" "$work/octave"   # what other tests have compiled
export GSMBP_CACHE="$work/octave"
objects=$GSMBP_CACHE/objects
# on_terminal SCRIPT FOLDER ...: what it writes on one
on_terminal() { script -qec "sh $*" /dev/null </dev/null | tr -d '\r' | sed 's/.*\[K//'; }
# octave_run FOLDER: the end of a run with its build folder, to the last bit
cat >"$work/octave_run" <<END
cd '$work'; FOLDER=\$1 exec octave-cli -qf --no-history --path "$root/octave" --eval '
  m = gsmbp_build ("motor_pendulum", "build", getenv ("FOLDER"), "directory", ".");
  r = gsmbp_simulate (m, m.initial, 0:0.1:1, "input", 12, "method", "gauss", "step", 1e-3);
  printf ("%.17g %.17g %.17g", r.x(end,:));' </dev/null
END
on_terminal "$work/octave_run" one >"$report" 2>&1
first=$(tail -n 1 "$report")
check 'a run' test "$(echo "$first" | wc -w)" = 3
on_terminal "$work/octave_run" two >"$report" 2>&1
check 'a new folder: the same numbers' test "$(tail -n 1 "$report")" = "$first"
check 'a new folder: nothing is compiled' fails grep -q 'compiling the run time' "$report"
for file in libgsmbp.a gsmbp_module.o; do
  cmp "$work/one/double/common/$file" "$work/two/double/common/$file"
done >"$report" 2>&1
result 'and the same bytes'

# -- Octave: how it keeps a part of the run time, by one that compiles in no time (each time in a
# second at least, to be interrupted)
awk 'BEGIN { print "const double part[] = {"; for (k = 0; k < 4000; k++) print k ".125,"
             print "};" }' >"$work/part.c"
# octave_part FOLDER [SOURCE]: the sum of what is built there
cat >"$work/octave_part" <<END
cd '$work'; FOLDER=\$1 SOURCE=\${2:-$work/part.c} exec octave-cli -qf --no-history \
  --path "$root/octave" --eval '
  [folder, source, cc] = deal (getenv ("FOLDER"), getenv ("SOURCE"), "gcc -O1 -c");
  made = @(place) {"part.o", system(sprintf ("sleep 1; %s -o %s/part.o %s", cc, place, source))}{1};
  gs.files.build_once ("gsmbp_build", fullfile (folder, "part.o"), cc, {source}, made, cc);
  printf ("%s", hash ("md5", fileread (fullfile (folder, "part.o"))));' </dev/null
END
run() { on_terminal "$work/octave_part" "$@"; }
# again FOLDER ...: the same after what was built there was removed
again() {
  rm -f "$work/$1"/part.o*
  run "$@"
}
# gives WHAT TOLD COMMAND ...: the same sum, after the line `... once for this TOLD`
gives() {
  subject=$1 told=$2
  shift 2
  "$@" >"$report" 2>&1
  check "$subject: the same file" test "$(tail -n 1 "$report")" = "$first"
  check "$subject: compiled for: ${told:-nobody}" test "$told" = \
    "$(sed -n 's/^gsmbp_[a-z]*: compiling the run time, once for this //p' "$report")"
}
run three >"$report" 2>&1
first=$(tail -n 1 "$report")
check 'a part of the run time' test "$(printf %s "$first" | wc -c)" = 32
gives 'a new folder' '' run four
entry=$(ls -t "$objects"/* | head -n 1)
cp "$entry" "$work/entry"
printf '\377' | dd of="$entry" bs=1 seek=9000 conv=notrunc 2>/dev/null
gives 'a flipped byte' user again three
gives 'and then' '' again four
head -c 9000 "$work/entry" >"$entry"
gives 'a truncated file' user again three
mkdir "$work/sources"
{ cat "$work/part.c" && echo '/* changed */'; } >"$work/sources/part.c"
gives 'a changed source' user again three "$work/sources/part.c"
gives 'the same change' '' again four "$work/sources/part.c"
rm "$entry"
again three >"$work/said" 2>&1 &
gives 'two at once' user again four
wait
check 'the other one: the same file' test "$(tail -n 1 "$work/said")" = "$first"
rm "$entry"
rm -f "$work"/three/part.o*
setsid sh "$work/octave_part" three >"$work/said" 2>&1 &
child=$!
until [ -e "$work"/three/.new-* ] || ! kill -0 $child; do sleep 0.01; done
sleep 0.3
kill -9 -$child
check 'killed while it compiles: nothing is kept' fails test -e "$entry"
gives 'after it' user again three
cat >"$work/again" <<END
rm -f "$work/\$1"/part.o*
script -qec "sh '$work/octave_part' '\$1'" /dev/null </dev/null | tr -d '\r' | sed 's/.*\[K//'
END
chmod a-w "$objects"
gives 'a folder that cannot be written' 'folder (no cache folder)' without_root_powers \
  sh "$work/again" three
chmod u+w "$objects"
gives 'no HOME' 'folder (no cache folder)' env -u HOME -u GSMBP_CACHE \
  -u XDG_CACHE_HOME sh "$work/again" three
