# What the shell tests share:  . tests/tools/check.sh

# told CODE WHAT [FILE]: `ok WHAT` for the exit code 0, else `not ok WHAT` and the end of FILE
told() {
  if [ "$1" -eq 0 ]; then echo "ok $2"; return; fi
  echo "not ok $2"
  [ -z "${3:-}" ] || tail -n 20 "$3"
}

# check WHAT COMMAND...: whether the command succeeds; the end of the file $report if it does not
check() {
  what=$1
  shift
  "$@"
  told $? "$what" "${report:-}"
}

fails() { ! "$@"; }

# result WHAT: `ok WHAT` if the file $report is empty, else `not ok WHAT` and its first lines
result() {
  if [ -s "$report" ]; then echo "not ok $1"; head -n 8 "$report"; else echo "ok $1"; fi
}
