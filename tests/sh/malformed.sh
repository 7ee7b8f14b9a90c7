# Every twelfth of 300 malformed scenes against its verdict (make test-malformed takes them all);
# warnings reach the caller of derive.
. tests/tools/check.sh
PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 tests/malformed/judge.py hand 12 5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/warned.mac" <<'M'
scene : gsmbp_scene("warned", link(a, mass = 1, centre = [1, 0, 0]),
  revolute(J, ground, a, axis = z), spring(S, joint = J, stiffness = -1))$
requests : [mass]$
M
warning='spring S: stiffness is negative'
share/make/derive "$folder/warned.mac" "$folder" 2>"$folder/errors" &&
  grep -q "warning: $warning" "$folder/errors"
told $? 'derive tells the warnings of a scene' "$folder/errors"
octave-cli -qf --no-history --path octave \
  --eval "gsmbp_derive ('$folder/warned.mac', '$folder');" >"$folder/errors" 2>&1 </dev/null
grep -q "warning: gsmbp_derive: .*$warning" "$folder/errors"
told $? 'gsmbp_derive tells the warnings of a scene' "$folder/errors"
