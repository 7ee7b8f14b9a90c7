# The failures of a job's log, one line each: what was expected and found, as the line `not ok`
# has it or else the line after it, and the command ALONE that runs the job alone; five at most.
function show() {
  if (text != "") print substr(text, 1, 300) "; alone: " alone
  text = ""
}
/^(not )?ok / {
  show()
  if (/^not/ && ++n <= 5) { text = $0; complete = / found |at most/ }
  next
}
text != "" && !complete && NF { sub(/^ +/, ""); text = text ": " $0; complete = 1 }
END {
  show()
  if (n > 5) print "not ok: " n - 5 " more; alone: " alone
}
