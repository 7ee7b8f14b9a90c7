# What the tests of routines for runs in lanes share:  . tests/tools/lanes.sh

# vectorized ROUTINE FILE: the loop with the whole of the routine, by the compiler's report, a file
# of that name
vectorized() {
  awk -v name="_$1(" 'FILENAME != "report" {
      if (/^      SUBROUTINE/) inside = index($0, name)
      if (inside && /-- all of one state/) whole = 1
      if (whole && /DO [0-9]+ IS = 1, 8/) { first = FNR; label = $2 + 0 }
      if (whole && first && $1 == label && /CONTINUE/) { last = FNR; whole = 0 }
      next
    }
    /optimized: loop vectorized/ { split($0, p, ":"); if (p[2] >= first && p[2] <= last) ok = 1 }
    END { exit !ok }' "$2" report
}

# size NAME WHAT: a number of the description of a scene
size() { sed -n "s/.*\"$2\": \([0-9]*\).*/\1/p" "$1.json" | head -n 1; }
