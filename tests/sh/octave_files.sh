# What Octave writes on a disk that is full (a limit of file sizes; where mounting is allowed also a
# file system of 64 kB): an error that names the file, the old file as it was, nothing half-written
# beside it. Tables, figures, moving pictures, what gsmbp_build compiles.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
small=
trap '[ -n "$small" ] && umount "$work/small"; rm -rf "$work"' EXIT
octave_run() {
  timeout 200 octave-cli -qf --no-history --path "$root/octave" --path "$root/octave/hand" \
    --eval "addpath (\"$work\"); $1" </dev/null
}

cat >"$work/gsmbp_write_all.m" <<'END'
## write everything into FOLDER, N numbers; the errors are printed
function gsmbp_write_all (folder, n)
  t = linspace (0, 1, n)';
  says ("table", @() gsmbp_csv (fullfile (folder, "a.csv"), {"t", "y"}, [t, t]));
  y = struct ("y", sin (50 * t), "names", {{"y"}}, "label", "y");
  says ("figure", @() gsmbp_plot (fullfile (folder, "b.png"), t, y));
  ## few numbers, which fit: the picture does not
  k = 1:10;
  y.y = y.y(k);
  says ("figure alone", @() gsmbp_plot (fullfile (folder, "b.png"), t(k), y));
  m = gsmbp_hand ("hand_crank");
  r = gsmbp_simulate (m, gsmbp_assemble (m, m.initial), linspace (0, 1, 40));
  says ("picture", @() gsmbp_animate (m, r, fullfile (folder, "c.gif"), "width", 200 + n / 10));
  says ("module", @() gsmbp_build ("motor_pendulum", "directory", fullfile (folder, "scene")));
end
function says (what, f)
  said = "no error";
  try
    f ();
  catch err
    said = strsplit (err.message, "\n"){1};
  end
  printf ("%s: %s\n", what, said);
end
END

# sums FOLDER: of all its files but those of the scene
sums() { (cd "$1" && find . -type f ! -path './scene/*' | sort | xargs md5sum); }

# outcome HOW FOLDER: of a second writing, after a first one of little into the same folder
outcome() {
  for item in table figure 'figure alone' picture module; do
    grep -q "^$item: gsmbp_[a-z]*: .*\(full\|cannot\|failed\)" "$work/second"
    told $? "$1: $item: an error" "$work/second"
  done
  sums "$2" >"$work/after"
  diff "$work/before" "$work/after" >"$work/changed"
  told $? "$1: the old files are as they were, and nothing else is there" "$work/changed"
  find "$2" -name '*.new*' -o -name '.new*' >"$work/left"
  [ ! -s "$work/left" ]; told $? "$1: no part is left" "$work/left"
}
mkdir "$work/limit" "$work/small"
cp -r octave/hand "$work/scene"
octave_run "gsmbp_hand (\"hand_crank\");" >/dev/null   # compiled before the limit
export TMPDIR="$work"

cp -r "$work/scene" "$work/limit/scene"
octave_run "for f = {'a.csv', 'b.png', 'b.csv', 'c.gif', 'c.csv'}, \
  gsmbp_csv (['$work/limit/' f{1}], {'t'}, 1); end"
sums "$work/limit" >"$work/before"
(ulimit -f 10; trap '' XFSZ; octave_run "gsmbp_write_all (\"$work/limit\", 20000);") \
  >"$work/second" 2>&1
outcome 'limit of file sizes' "$work/limit"

if mount -t tmpfs -o size=64k tmpfs "$work/small" 2>/dev/null; then
  small=yes
  cp -r "$work/scene/motor_pendulum.f" "$work/scene/motor_pendulum.json" "$work"
  mkdir "$work/small/scene"
  cp "$work/motor_pendulum.f" "$work/motor_pendulum.json" "$work/small/scene"
  for file in a.csv b.png b.csv c.gif c.csv; do echo old >"$work/small/$file"; done
  head -c 1000000 /dev/zero >"$work/small/filler" 2>/dev/null   # no room at all
  sums "$work/small" >"$work/before"
  octave_run "gsmbp_write_all (\"$work/small\", 300);" >"$work/second" 2>&1
  outcome 'full file system' "$work/small"
fi
