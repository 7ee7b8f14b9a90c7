# functions.awk EXAMPLES.texi FUNCTIONS.txt: the functions of Maxima as Texinfo, from what
# share/make/doc printed, by name; behind each its example: in EXAMPLES `@c of NAME` stands ahead
# of it. Lines of a comment that are indented further than its paragraphs keep their breaks.

# ------------------------------------------------------------------------------------- examples
FILENAME == ARGV[1] {
  if (/^@c of /) name = $3
  else if (/^@example$/) inside = 1
  if (name != "" && inside) example[name] = example[name] $0 "\n"
  if (/^@end example$/) { inside = 0; name = "" }
  next
}

# ------------------------------------------------------------------------------------ functions
/^== / { next }
/^gsmbp_/ {
  finish()
  current = arguments = $0
  sub(/\(.*/, "", current)
  sub(/^[A-Za-z0-9_]*/, "", arguments)
  gsub(/\[(gs__[a-z]*|more|options|file)\]/, "...", arguments)
  gsub(/gs__/, "", arguments)
  next
}
current != "" { add($0) }
END {
  finish()
  for (i = 1; i <= count; i++) print text[sorted[i]]
}

function plain(s) { gsub(/[@{}]/, "@&", s); return s }

# one line of a comment; lines: how many of it there are so far; kept: line breaks are kept
function add(line,   indent) {
  match(line, /^ */)
  indent = RLENGTH
  line = substr(line, indent + 1)
  sub(/ +$/, "", line)
  if (++lines == 1) { base = indent; sub(/^gsmbp_[a-z_]*(\([^)]*\))?: */, "", line) }
  keep(line != "" && indent > base + 3 && line !~ /^(Result|Units|Frame|Errors|Source): /)
  body = body (kept ? sprintf("%" (indent - base - 4) "s", "") : "") plain(line) "\n"
}
function keep(yes) {
  if (yes && !kept) body = body "@smallformat\n"
  if (!yes && kept) body = body "@end smallformat\n"
  kept = yes
}

# the text of the function that ends here, put in its place by name
function finish(   i, n, word) {
  if (current == "") return
  keep(0)
  n = split("Result Units Frame Errors Source", word)
  for (i = 1; i <= n; i++)
    gsub("(^|[ \n])" word[i] ": ", "\n\n@strong{" word[i] ":} ", body)
  text[current] = definition() "\n" body "\n" example[current] ending() "\n"
  for (i = ++count; i > 1 && current < sorted[i - 1]; i--) sorted[i] = sorted[i - 1]
  sorted[i] = current
  current = body = ""
  lines = 0
}
function definition() {
  return arguments == "" ? "@defvr {Option variable} " current \
    : "@deffn {Function} " current " " plain(arguments)
}
function ending() { return arguments == "" ? "@end defvr" : "@end deffn" }
