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
