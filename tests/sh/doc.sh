# Every public name of the Maxima package is in what `make doc` writes, with a comment. (Those of
# elsewhere.mac only say that they are Octave's.)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
share/make/doc gsmbp/*.mac gsmbp/*/*.mac >"$work/functions.txt"
share/make/maxima "$work/log" "load(\"$PWD/gsmbp/gsmbp.mac\")\$
public(s) := is(ssearch(\"gsmbp_\", s) = 1) and is(ssearch(\"gs__\", s) # 1)\$
listed(f) := public(string(op(f))) and not member(op(f), gs__octave_functions)\$
with_stdout(\"$work/public\",
  for f in functions do if listed(f) then printf(true, \"~a~%\", op(f)))\$"
{
  grep -hoE '^\(defm?[a-z]+ \$gsmbp_[a-z][a-z_]*' gsmbp/*.lisp gsmbp/*/*.lisp | sed 's/.*\$//'
  cat gsmbp/*.mac gsmbp/*/*.mac | grep -oE '^define_variable\(gsmbp_[a-z_]+' | sed 's/.*(//'
} >>"$work/public"
missing=$(sort -u "$work/public" | while read -r name; do
  grep -qE "^$name(\(|\$)" "$work/functions.txt" || echo "$name"
done)
[ "$(wc -l <"$work/public")" -gt 35 ] && [ -z "$missing" ] &&
  echo 'ok every public name is listed' || echo "not ok not listed:" $missing
silent=$(awk '/^gsmbp_/ { name = $0; getline; if ($0 == "") print name }' "$work/functions.txt")
[ -z "$silent" ] && echo 'ok each has a comment' || echo "not ok without a comment:" $silent

# the words that FILE lacks in the comment of a function, a line `NAME WORD` each; FILE has a
# function on a line of its own, its comment on the indented lines behind it
lacking() { # WORDS <FILE
  awk -v words="$1" '
    function tell(   k) {
      for (k in word) if (name != "" && index(text, word[k] ":") == 0) print name, word[k]
    }
    BEGIN { split(words, word) }
    /^[^ ]/ { tell(); name = $0 ~ /^gsmbp_.*\(/ ? $0 : ""; text = "" }
    { text = text " " $0 }
    END { tell() }'
}
# shape, unit, frame, errors and source, of all of them
silent=$(lacking 'Result Units Frame Errors Source' <"$work/functions.txt")
[ -z "$silent" ] && echo 'ok each says result, units, frame, errors and source' ||
  echo "not ok not said:" $silent
printf 'gsmbp_x(a)\n  Result: a. Units: m. Errors: none. Source: own.\n\ngsmbp_y(b)\n  b.\n' \
  >"$work/poor.txt"
[ "$(lacking 'Result Frame' <"$work/poor.txt" | sort | tr '\n' ' ')" = \
  'gsmbp_x(a) Frame gsmbp_y(b) Frame gsmbp_y(b) Result ' ] &&
  echo 'ok what is not said is found' || echo 'not ok what is not said is found'
grep -h -A 2 '^== ' "$work/functions.txt" | awk '/^== / && last ~ /^== / { bad = 1 }
  $0 != "" && $0 != "--" { last = $0 } END { exit bad || last ~ /^== / }' &&
  echo 'ok no heading is empty' || echo 'not ok a heading is empty'
# the help of every function of Octave
silent=$(for file in octave/*.m; do
  for word in Errors Source; do
    sed -n '/^## -\*- texinfo/,/^## @end deftypefn/p' "$file" | grep -q "^## $word: " ||
      echo "$file $word"
  done
done)
[ -z "$silent" ] && echo 'ok each help of Octave says errors and source' ||
  echo "not ok not said:" $silent

# what doctest cannot type
lines=$(grep -nE '^## >>.*\.\.\.$' octave/gsmbp_*.m)
[ -z "$lines" ] && echo 'ok examples of help texts are typed in single lines' ||
  echo "not ok continued:" $lines
