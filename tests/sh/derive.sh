# What goes wrong in a derivation is one line that names the file and what is the matter:
# share/make/derive, make, gsmbp_derive in Octave.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
body='link(a, mass = 1, inertia = [1, 1, 1]), revolute(J, ground, a, axis = z))$'
# says NAME TEXT: the scene on stdin is refused with that text, in one line
says() {
  cat >"$work/$1.mac"
  if share/make/derive "$work/$1.mac" "$work/out" 2>"$work/errors"; then echo "not ok derive takes $1.mac"; return; fi
  if [ "$(wc -l <"$work/errors")" -eq 1 ] && grep -qF "derive: $work/$1.mac: $2" "$work/errors"; then echo "ok derive: $1"
  else echo "not ok derive: $1"; cat "$work/errors"; fi
}
echo "arm : gsmbp_scene(\"unset\", $body" |
  says unset 'gsmbp_derive: expected a file that leaves its scene in the variable scene (scene : gsmbp_scene("unset", ...)); found: scene has no value'
echo 'scene : 3$' | says number 'gsmbp_derive: expected a file that leaves its scene in the variable scene (scene : gsmbp_scene("number", ...)); found: scene = 3'
echo "scene : gsmbp_scene(\"other\", $body" | says misnamed 'gsmbp_derive: expected a scene named as its file, "misnamed"; found: "other"'
echo 'scene : gsmbp_scene("option", link(a, mass = 1, centr = [1, 0, 0]), revolute(J, ground, a, axis = z))$' | says option 'gsmbp_scene: link a: unknown option centr; nearest: centre'
echo "scene : gsmbp_scene(\"request\", $body requests : [invers]\$" | says request 'gsmbp_fortran: unknown request invers; nearest: inverse'
echo 'scene : gsmbp_scene("syntax", link(a, mass = 1)), revolute(J, ground, a, axis = z))$' | says syntax "incorrect syntax: Too many )'s"
echo 'f(x) := x$ scene : f(1, 2)$' | says maxima 'Too many arguments supplied to f(x); found: [1, 2]'
GSMBP_TIMEOUT=2 says spat32 'stopped after 2 seconds' <tests/bench/systems/spat32.mac
share/make/derive "$work/nowhere.mac" "$work/out" 2>"$work/errors"
[ "$(cat "$work/errors")" = "derive: there is no scene file $work/nowhere.mac" ] && echo 'ok derive: no file' || echo 'not ok derive: no file'
[ -z "$(ls "$work/out" | grep -v 'log$')" ] && echo 'ok nothing is left beside the logs' || echo 'not ok left behind'

octave-cli -qf --no-history --path octave --eval "try, gsmbp_derive ('$work/option.mac'); catch e, disp (e.message); end" >"$work/errors" 2>/dev/null </dev/null
[ "$(wc -l <"$work/errors")" -eq 1 ] && grep -qE "^gsmbp_derive: $work/option.mac: gsmbp_scene: link a: unknown option centr.*cut\$" "$work/errors" &&
  echo 'ok gsmbp_derive: one line' || { echo 'not ok gsmbp_derive'; cat "$work/errors"; }
