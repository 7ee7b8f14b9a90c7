# index.awk FILE.info: prints what describe of Maxima (? and ??) reads, as Lisp. Run it under
# LC_ALL=C: offsets are bytes, and the file must be ASCII and made by makeinfo --no-split.
# An entry begins at " -- Category: [result =] name"; headings that follow at once (@deffnx) share
# it; it ends before the next one or the end of the node. A long heading continues on lines
# indented by ten blanks.
function close_entry(   i) {
  for (i = 1; i <= n; i++) if (!(name[i] in told)) {
    told[name[i]] = 1
    entries = entries sprintf("(\"%s\" . (\"%s\" %d %d \"%s\"))\n", name[i], file, start,
      at - start, node)
  }
  n = 0
}
function close_node() {
  close_entry()
  if (node != "" && node != "Top" && !is_index)
    nodes = nodes sprintf("(\"%s\" . (\"%s\" %d %d))\n", node, file, body, at - body)
  node = ""
}
function heading(word,   i) {
  sub(/^ -- [^:]*: /, "", word)
  if (word ~ / = gsmbp_/) sub(/^[^(]* = /, "", word)
  sub(/ .*/, "", word)
  if (word == "") return
  for (i = 1; i <= n; i++) if (name[i] == word) return
  name[++n] = word
}
BEGIN { n = split(ARGV[1], part, "/"); file = part[n]; n = 0; at = 0 }
/^\037/ { close_node() }
/^File: .*Node: / {
  node = $0; sub(/.*Node: /, "", node); sub(/,.*/, "", node); body = at; is_index = 0
}
/^\000?\010\[index/ { is_index = 1 }
/^ -- [^:]*: / { if (!in_heading) { close_entry(); start = at } heading($0); in_heading = 1 }
!/^ -- / && !/^          / { in_heading = 0 }
{ at += length($0) + 1 }
END {
  close_node()
  print "(in-package :cl-info)\n(load-info-hashtables (maxima::maxima-load-pathname-directory)"
  printf " '(%s)\n '(%s))\n", entries, nodes
}
