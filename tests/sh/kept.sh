# Derived scenes in the user's cache folder (tests/tools/kept_scenes.py): the same bytes come back,
# anything that takes part in a derivation makes another key, damage is noticed, two at once.
. tests/tools/check.sh
work_folder
export GSMBP_CACHE=$work/cache GSMBP_TEST_MAXIMA=5.46
# a copy, in which sources are edited
mkdir "$work/tree"
cp -a --parents gsmbp share tests/scenes tests/tools/kept_scenes.py tests/tools/derive_lot \
  examples/puma560/*.mac octave/gsmbp_csv.m "$work/tree/"
scene=tests/scenes/flexible_data.mac
kept() { (cd "$work/tree" && tests/tools/kept_scenes.py "$@"); }
fetch() { rm -rf "$work/$1"; mkdir "$work/$1"; kept fetch "$work/$1" "$work/keys" ${2:-$scene}; }
# is it there again?
same() { fetch again && diff -r "$work/derived" "$work/again" >"$report" 2>&1; }
entry() { ls -d "$work"/cache/derived/* 2>/dev/null; }

fetch derived
(cd "$work/tree" && tests/tools/derive_lot "$work/derived" "$work/log" $scene)
check 'a scene is derived' test -s "$work/derived/flexible_data.f"
kept keep "$work/derived" "$work/keys" $scene
check 'the same bytes come back' same

# another FILE: with one more line in it the key is another one
other() {
  cp -p "$work/tree/$1" "$work/before"
  echo >>"$work/tree/$1"
  fetch again
  mv "$work/before" "$work/tree/$1"
  [ ! -e "$work/again/flexible_data.f" ]
}
for file in $scene share/flexible/cantilever.txt gsmbp/kernel/exact.lisp share/laws.mac \
  share/passive/duffing_spring.mac share/make/maxima tests/tools/derive_lot; do
  check "an edit of $file makes another key" other "$file"
done
check 'an edit of octave/ does not' fails other octave/gsmbp_csv.m
GSMBP_TEST_MAXIMA=5.47
check 'another Maxima makes another key' fails same
GSMBP_TEST_MAXIMA=5.46
fetch again
echo >>"$work/tree/gsmbp/gsmbp.mac"
rm "$(entry)"
kept keep "$work/derived" "$work/keys" $scene
check 'what sources gave that were edited meanwhile is not kept' fails entry
cp gsmbp/gsmbp.mac "$work/tree/gsmbp/gsmbp.mac"

# damage: one byte, an end that is missing
kept keep "$work/derived" "$work/keys" $scene & kept keep "$work/derived" "$work/keys" $scene
wait
check 'kept by two at once' same
printf '\377' | dd of="$(entry)" bs=1 seek=1000 conv=notrunc 2>/dev/null
check 'a byte that was changed is noticed' fails same
check 'the entry is removed' fails entry
kept keep "$work/derived" "$work/keys" $scene
truncate -s -1 "$(entry)"
check 'an end that is missing is noticed' fails same
GSMBP_CACHE=none
kept keep "$work/derived" "$work/keys" $scene
check 'with GSMBP_CACHE=none nothing is kept' fails same

# the files that Maxima reads in a derivation are those of the key
has strace 'the files that a derivation reads' || exit 0
GSMBP_CACHE=$work/cache
fetch again tests/scenes/choose_less.mac
(cd "$work/tree" && strace -f --seccomp-bpf -qq -e trace=open,openat -o "$work/calls" \
  tests/tools/derive_lot "$work/again" "$work/log" tests/scenes/choose_less.mac)
sed -n "s|.*\"$work/tree/\([^\"]*\)\", O_RDONLY.*) = [0-9].*|\1|p" "$work/calls" |
  (cd "$work/tree" && xargs -d '\n' realpath --relative-to=. | sort -u |
    while read -r file; do [ -d "$file" ] || echo "$file"; done) |
  grep -v -e '^gsmbp/compiled/' -e '^share/manual/gsmbp' >"$work/read"   # the manual: for ? alone
kept files tests/scenes/choose_less.mac | sort | comm -13 - "$work/read" >"$report"
grep -q puma560.mac "$work/read" || echo 'expected the example among them, found none' >>"$report"
result "all $(wc -l <"$work/read") files that a derivation reads make the key"
