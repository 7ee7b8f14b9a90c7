# Every twelfth of 300 malformed scenes against its verdict (make test-malformed takes them all);
# warnings reach the caller of derive.
PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 tests/malformed/judge.py hand 12 5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
echo 'scene : gsmbp_scene("warned", link(a, mass = 1, centre = [1, 0, 0]), revolute(J, ground, a, axis = z), spring(S, joint = J, stiffness = -1))$ requests : [mass]$' >"$folder/warned.mac"
share/make/derive "$folder/warned.mac" "$folder" 2>"$folder/errors" && grep -q 'warning: spring S: stiffness is negative' "$folder/errors" &&
  echo 'ok derive tells the warnings of a scene' || echo 'not ok derive tells the warnings of a scene'
octave-cli -qf --no-history --path octave --eval "gsmbp_derive ('$folder/warned.mac', '$folder');" 2>&1 </dev/null | grep -q 'warning: gsmbp_derive: .*spring S: stiffness is negative' &&
  echo 'ok gsmbp_derive tells the warnings of a scene' || echo 'not ok gsmbp_derive tells the warnings of a scene'
