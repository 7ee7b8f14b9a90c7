# Every function of the package is defined once: Maxima would silently keep the last definition.
twice=$(grep -hoE '^ *gsmbp_[a-zA-Z_0-9]+\(' gsmbp/*.mac gsmbp/*/*.mac share/*/*.mac | tr -d ' ' | sort | uniq -d)
calls=''
for f in $twice; do
  n=$(grep -hE "^ *$(printf %s "$f" | sed 's/(/\\(/').*:=" gsmbp/*.mac gsmbp/*/*.mac share/*/*.mac | wc -l)
  [ "$n" -gt 1 ] && calls="$calls $f"
done
[ -z "$calls" ] && echo "ok no function is defined twice" || echo "not ok defined twice:$calls"

# Nor is a function defined both in Lisp and in Maxima, or twice in Lisp.
lisp=$(grep -hoE '^\(def(un|macro) \$?[A-Za-z_0-9-]+' gsmbp/*.lisp gsmbp/*/*.lisp | sed 's/^(def[a-z]* //' | sort)
twice=$(echo "$lisp" | uniq -d)
both=$(for f in $(echo "$lisp" | sed -n 's/^\$//p'); do grep -lE "^ *$f\(.*:=" gsmbp/*.mac gsmbp/*/*.mac share/*/*.mac | sed "s/^/$f in /"; done)
[ -z "$twice$both" ] && echo "ok no function of Lisp is defined again" || echo "not ok defined again: $twice $both"

# A function that is kept in a local variable has a name of the package: Maxima would call a user's
# function of the same name instead.
local=$(grep -noE '(^|[^A-Za-z_0-9@])[A-Za-z_0-9]+ : lambda\(' gsmbp/*.mac gsmbp/*/*.mac share/*/*.mac | grep -vE 'gsmbp__[A-Za-z_0-9]+ : lambda')
[ -z "$local" ] && echo "ok no local function has a user's name" || echo "not ok local functions: $local"

# No message names a private function: it means nothing to a user.
private=$(grep -nE '(error|wrong|merror|emission|where)[^;]*"gsmbp__[a-z_]+[":]' gsmbp/*.mac gsmbp/*/*.mac gsmbp/*.lisp gsmbp/*/*.lisp)
[ -z "$private" ] && echo "ok no message names a private function" || echo "not ok messages with a private name: $private"

# Nor is a variable of the package given a value twice while it is loaded: the second would silently
# win.
twice=$(grep -hoE '^gsmbp_[A-Za-z_0-9]+ *: ' gsmbp/*.mac gsmbp/*/*.mac | sort | uniq -d)
[ -z "$twice" ] && echo "ok no variable is set twice" || echo "not ok set twice: $twice"
