# The output of Maxima's run_testsuite on one file as lines `ok`, `not ok`; variable name: the
# file's.
match($0, /[0-9]+\/[0-9]+ tests passed/) {
  split(substr($0, RSTART, RLENGTH), n, "[/ ]")
  passed = n[1] + 0
  all = n[2] + 0
  seen = 1
}
/^No unexpected errors found/ { clean = 1 }
/^The following .* failed:/ {
  bad = $0
  sub(/.*failed: /, "", bad)
  gsub(/[()]/, "", bad)
  split(bad, number, " ")
}
END {
  if (!seen) { print "not ok " name ": no summary of Maxima's test run"; exit }
  for (i in number) { wrong[number[i]] = 1; failed++ }
  for (i = 1; i <= all; i++) print (i in wrong ? "not ok " : "ok ") name " problem " i
  if (failed + 0 != all - passed || (passed == all && !clean))
    print "not ok " name ": the summary does not add up, or the line " \
      "`No unexpected errors found` is missing"
}
