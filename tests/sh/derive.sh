# What goes wrong in a derivation is one line that names the file and what is the matter:
# share/make/derive, make, gsmbp_derive in Octave.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/errors
body='link(a, mass = 1, inertia = [1, 1, 1]), revolute(J, ground, a, axis = z))$'
one_line() { [ "$(wc -l <"$report")" -eq 1 ]; }
# says NAME TEXT: the scene on stdin is refused with that text, in one line
says() {
  cat >"$work/$1.mac"
  if share/make/derive "$work/$1.mac" "$work/out" 2>"$report"; then
    echo "not ok derive takes $1.mac"
    return
  fi
  one_line && grep -qF "derive: $work/$1.mac: $2" "$report"
  told $? "derive: $1" "$report"
}
# no_scene NAME FOUND: a file that leaves no scene
no_scene() {
  says "$1" "gsmbp_derive: expected a file that leaves its scene in the variable scene \
(scene : gsmbp_scene(\"$1\", ...)); found: $2"
}
echo "arm : gsmbp_scene(\"unset\", $body" | no_scene unset 'scene has no value'
echo 'scene : 3$' | no_scene number 'scene = 3'
echo "scene : gsmbp_scene(\"other\", $body" |
  says misnamed 'gsmbp_derive: expected a scene named as its file, "misnamed"; found: "other"'
echo "scene : gsmbp_scene(\"option\", link(b, mass = 1, centr = [1, 0, 0]), $body" |
  says option 'gsmbp_scene: link b: unknown option centr; nearest: centre'
echo "scene : gsmbp_scene(\"request\", $body requests : [invers]\$" |
  says request 'gsmbp_fortran: unknown request invers; nearest: inverse'
echo "scene : gsmbp_scene(\"syntax\", link(b, mass = 1)), $body" |
  says syntax "incorrect syntax: Too many )'s"
echo 'f(x) := x$ scene : f(1, 2)$' |
  says maxima 'Too many arguments supplied to f(x); found: [1, 2]'
echo 'scene : ?car(3)$' | says lisp ''
GSMBP_TIMEOUT=2 says spat32 'stopped after 2 seconds of processor time' \
  <tests/bench/systems/spat32.mac
GSMBP_TIMEOUT=1 share/make/page "$work/spat32.mac" "$work/page.html" 2>"$report"
one_line && grep -q "spat32.mac: stopped after 1 seconds of processor time" "$report"
told $? 'page: the limit of processor time' "$report"
share/make/derive "$work/nowhere.mac" "$work/out" 2>"$report"
check 'derive: no file' \
  test "$(cat "$report")" = "derive: there is no scene file $work/nowhere.mac"
check 'nothing is left beside the logs' fails sh -c "ls '$work/out' | grep -v 'log\$'"

octave-cli -qf --no-history --path octave \
  --eval "try, gsmbp_derive ('$work/option.mac'); catch e, disp (e.message); end" \
  >"$report" 2>/dev/null </dev/null
refusal="^gsmbp_derive: $work/option.mac: gsmbp_scene: link b: unknown option centr.*cut, shape\$"
one_line && grep -qE "$refusal" "$report"
told $? 'gsmbp_derive: one line' "$report"

# folders with characters that a shell or Lisp would read as patterns
echo "scene : gsmbp_scene(\"arm\", $body" >"$work/arm.mac"
odd="$work/it's c++ (1) \$x^"
check 'a folder whose name has +, (, $, ^, a quote' share/make/derive "$work/arm.mac" "$odd"
check 'a module is built there' env ODD="$odd" octave-cli -qf --no-history --path octave \
  --eval "m = gsmbp_build ('arm', 'directory', getenv ('ODD')); assert (m.mas (0, 0), 1)"
echo 'gsmbp_fortran(scene, [mass], [directory = "a[1]"])$' >>"$work/arm.mac"
share/make/derive "$work/arm.mac" "$work/out" 2>"$report"
one_line && grep -qF 'a[1]: [ in the name of a file or folder is a pattern to Lisp' "$report"
told $? 'a folder that Lisp cannot name' "$report"

# a folder for temporary files or for the log that cannot be: one sentence
sentence() { one_line && grep -qF -- "$1" "$report"; }
fails env TMPDIR="$work/nowhere" share/make/derive "$work/arm.mac" "$work/out" 2>"$report" &&
  sentence "derive: expected a folder for temporary files; found TMPDIR=$work/nowhere"
told $? 'derive: TMPDIR that is not there' "$report"
fails share/make/derive "$work/arm.mac" /proc/nowhere 2>"$report" &&
  sentence 'derive: /proc/nowhere/arm.f: there is no folder /proc/nowhere'
told $? 'derive: a folder that cannot be made' "$report"
fails share/make/maxima /proc/nowhere/log 'x$' 2>"$report" &&
  sentence 'maxima: /proc/nowhere/log cannot be written'
told $? 'maxima: a log that cannot be written' "$report"
