# Operations of the assignments in fixed-form Fortran 77, one line a subroutine: NAME mul add div
# sqrt trig. X**3 is two mul, unary minus, ABS, SIGN, MAX, MIN, rounding are free, subscripts and
# whole numbers do not count; trig is every other intrinsic call, and a power with a broken
# exponent; CALL GSSC is a sine and a cosine, what it leaves in IDLE apart; of GSSCV it is
# what is read of SN and CN.
BEGIN {
  set(trig, "SIN COS TAN ASIN ACOS ATAN ATAN2 SINH COSH TANH LOG EXP")
  set(free, "SQRT ABS SIGN MAX MIN ANINT GSFLR")
}
/^[Cc*!]/ || /^ *$/ { next }
substr($0, 6, 1) !~ /[ 0]/ && length($0) > 5 { statement = statement substr($0, 7); next }
{ count(statement); statement = substr($0, 7) }
END { count(statement); report() }

function set(words, text,   list, i) {
  split(text, list, " ")
  for (i in list) words[list[i]] = 1
}

function report() {
  if (name != "") print name, mul + 0, add + 0, div + 0, root + 0, calls + 0
  mul = add = div = root = calls = 0
}

# the token at the head of text, taken off it
function token() {
  sub(/^ +/, "", text)
  number = "[0-9]+\\.?[0-9]*([DE][-+]?[0-9]+)?"
  if (!match(text, "^(" number "|[A-Z][A-Z0-9_]*|\\*\\*|\\.[A-Z]+\\.|.)")) return ""
  tok = substr(text, 1, RLENGTH); text = substr(text, RLENGTH + 1)
  return tok
}

# text loses everything up to the parenthesis that closes the one at its head
function skip(   depth) {
  do { tok = token(); depth += (tok == "(") - (tok == ")") } while (depth > 0 && tok != "")
}

# a whole power is so many factors less one
function power() {
  if (match(text, /^ *[0-9]+/) && substr(text, RLENGTH + 1, 1) != ".")
    mul += substr(text, 1, RLENGTH) - 1
  else calls++
}

# an intrinsic function, or the subscripts of an array, which do not count
function application(word) {
  if (word == "SQRT") root++
  else if (word in trig) calls++
  else if (!(word in free)) { skip(); return ")" }
  return word
}

# the names that text declares
function integers(   t) {
  while ((t = token()) != "") {
    if (t ~ /^[A-Z]/) whole[t] = 1
    if (text ~ /^ *\(/) skip()
  }
}

function count(s,   t, before) {
  text = toupper(s)
  if (match(text, /^ *(SUBROUTINE|[A-Z ]*FUNCTION) +[A-Z0-9_]+/)) {
    report()
    name = substr(text, 1, RLENGTH)
    sub(/.* /, "", name)
    split("", whole)
    return
  }
  if (sub(/^ *INTEGER /, "", text)) { integers(); return }
  if (text ~ /^ *[A-Z][A-Z0-9_]* *= *[SC]N\([0-9]+\) *$/) calls++
  if (sub(/^ *CALL +GSSC *\(/, "", text)) calls += 2 - (text ~ /, *IDLE *[,)]/)
  else {
    if (text !~ /^ *[A-Z][A-Z0-9_]* *(\(.*\))? *=/) return
    if (token() in whole) return
    if (text ~ /^ *\(/) skip()
    if (token() != "=") return
  }
  for (before = "="; (t = token()) != ""; before = t) {
    if (t == "*") mul++
    else if (t == "/") div++
    else if (t ~ /^[-+]$/) { if (before !~ /^[=(,]$/) add++ }
    else if (t == "**") power()
    else if (t ~ /^[A-Z]/ && text ~ /^ *\(/) t = application(t)
  }
}
