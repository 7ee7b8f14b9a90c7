# The output of Maxima's run_testsuite on one file as lines `ok`, `not ok`; variable name: the
# file's. A problem that failed prints its parts after headlines: Input, Result (what was found),
# and what was expected.
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
/^\*+ Problem [0-9]+/ { problem = $3; part = ""; next }
/^Input:/ { part = "input"; next }
/^Result:/ { part = "found"; next }
/^This differed from the expected result:/ { part = "expected"; next }
/^[0-9]+\/[0-9]+ tests passed/ { part = "" }
part != "" && NF && length(text[problem, part]) < 80 {
  gsub(/^ +| +$/, "")
  text[problem, part] = substr(text[problem, part] " " $0, 1, 80)
}
END {
  if (!seen) { print "not ok " name ": no summary of Maxima's test run"; exit }
  for (i in number) { wrong[number[i]] = 1; failed++ }
  for (i = 1; i <= all; i++)
    if (!(i in wrong)) print "ok " name " problem " i
    else print "not ok " name " problem " i ":" text[i, "input"] ": expected" text[i, "expected"] \
      ", found" text[i, "found"]
  if (failed + 0 != all - passed || (passed == all && !clean))
    print "not ok " name ": the summary does not add up, or the line " \
      "`No unexpected errors found` is missing"
}
