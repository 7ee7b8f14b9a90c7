# awk -f emitted_text.awk SCENE.f: what the comments of emitted Fortran lack, a line each:
# an argument without a unit, a constant that is read without a line that says what it is, a value
# of PAR without its meaning, a routine without METHOD, one that is called and not named there (with
# a word on it, if it is of the run time), a result that is the negative of a variable of its name,
# a name with the private prefix.
function fault(text) { print routine ": " text }
function close_argument() {
  if (argument != "" && text !~ /\[[^]]+\]/) fault("argument " argument " has no unit")
  argument = text = ""
}
/^ +SUBROUTINE / {
  routine = $2; sub(/\(.*/, "", routine)
  section = method = meaning = told = ""
  delete legend
}
/^C     [A-Z][A-Z ]+$/ {
  close_argument(); section = substr($0, 7)
  if (section == "METHOD") method = 1
}
section == "ARGUMENTS" && /^C     [A-Z]/ && substr($0, 7) != "ARGUMENTS" {
  close_argument(); argument = $2; text = $0; next
}
section == "ARGUMENTS" && /^C      / { text = text " " substr($0, 7) }
section == "METHOD" { told = told " " substr($0, 7) }
section == "CONSTANTS" && /^C     [A-Z][A-Z0-9_]* / { legend[$2] = 1 }
/^      IMPLICIT NONE/ {
  close_argument(); section = ""
  if (!method) fault("no METHOD")
}
!/^C/ && match($0, /CALL [A-Z][A-Z0-9_]*/) {
  name = substr($0, RSTART + 5, RLENGTH - 5)
  if (told !~ " " name (name ~ /^GS[A-Z0-9]+$/ ? " (\\(|gives)" : "[,.; ]"))
    fault("METHOD does not tell of " name)
}
/^C     -- / { meaning = $0 }
/^C        [^ ]/ { meaning = meaning " " substr($0, 10) }
/^ +[A-Z][A-Z0-9_]* = CST\([0-9]+\)$/ && !($1 in legend) { fault("constant " $1 " has no meaning") }
/^ +PAR\([0-9]+\) = / {
  if (meaning !~ /: .*\[[^]]+\]$/) fault($1 " has no meaning above it")
  meaning = ""
}
/^ +[A-Z]+\([0-9,]+\) = -[A-Z]([A-Z0-9_]*[A-Z0-9])?$/ {
  array = $1; sub(/\(.*/, "", array)
  value = substr($3, 2); sub(/[0-9_]*$/, "", value)
  if (value == array && value !~ /^[ZK]$/) fault($0 " is the negative of what has its name")
}
!/^C/ && /GS__/ { fault("private name: " $0) }
