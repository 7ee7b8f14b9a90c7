# Every function of the package is defined once: Maxima would silently keep the last definition.
export LC_ALL=C   # A-Z: in Turkish they lack some letters
package=$(ls gsmbp/*.mac gsmbp/*/*.mac)
maxima=$(ls gsmbp/*.mac gsmbp/*/*.mac share/*/*.mac)
lisp=$(ls gsmbp/*.lisp gsmbp/*/*.lisp 2>/dev/null)
# none WHAT FAULTS: `ok no WHAT` if there are none
none() { [ -z "$2" ] && echo "ok no $1" || echo "not ok no $1; found: $2"; }

twice=$(grep -hoE '^ *gsmbp_[a-zA-Z_0-9]+\(' $maxima | tr -d ' ' | sort | uniq -d)
calls=''
for f in $twice; do
  n=$(grep -hE "^ *$(printf %s "$f" | sed 's/(/\\(/').*:=" $maxima | wc -l)
  [ "$n" -gt 1 ] && calls="$calls $f"
done
none 'function is defined twice' "$calls"

# Nor is a function defined both in Lisp and in Maxima, or twice in Lisp (but behind #+ and #-).
defined=$(awk '/^#-/ { other = 1 }
  /^\(def(un|macro) / { if (!other) print $2; other = 0 }' $lisp | sort)
twice=$(echo "$defined" | uniq -d)
both=$(for f in $(echo "$defined" | sed -n 's/^\$//p'); do
  grep -lE "^ *$f\(.*:=" $maxima | sed "s/^/$f in /"
done)
none 'function of Lisp is defined again' "$twice$both"

# A function that is kept in a local variable has a name of the package: Maxima would call a user's
# function of the same name instead.
users=$(grep -noE '(^|[^A-Za-z_0-9@])[A-Za-z_0-9]+ : lambda\(' $maxima |
  grep -vE 'gs__[A-Za-z_0-9]+ : lambda')
none "local function has a user's name" "$users"

# No message names a private function: it means nothing to a user.
private=$(grep -nE '(error|wrong|merror|emission|where)[^;]*"gs__[a-z_]+[":]' $package $lisp)
none 'message names a private function' "$private"

# Nor is a variable of the package given a value twice while it is loaded: the second would silently
# win.
twice=$(grep -hoE '^gsmbp_[A-Za-z_0-9]+ *: ' $package | sort | uniq -d)
none 'variable is set twice' "$twice"
# map(string, l) evaluates the expressions once more, with the user's variables, map(sconcat, l) not
none 'expression is evaluated again for its text' "$(grep -n 'map(string\|map(concat' $package)"

# Python and Octave name the request of a subroutine that is missing: one that gsmbp_fortran knows.
unknown=$({
  sed -n '/^_REQUESTS = {/,/}/p' share/python/module/_model.py | grep -oE ": '[a-z_]+'" |
    tr -d ": '"
  grep -oE '^ +\{ "[a-z_]+", "[a-z_]+"' octave/glue/handles.h | sed 's/.*, "//; s/"//'
} | sort -u | while read -r word; do
  [ "$word" = batch ] || grep -qE "^ +'?\[{1,2}$word, \"" gsmbp/emit/requests.mac || echo "$word"
done)
none 'request is named that gsmbp_fortran does not know' "$unknown"
