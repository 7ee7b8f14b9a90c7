# What the tests of loops that are to be vectorized share:  . tests/tools/loops.sh

# Whether a loop is vectorized is asked for fixed processors (AVX2, AVX-512), whatever this machine
# is: compiled, not run. Numbers are those of code for this machine, or for GSMBP_MARCH.
native=-march=${GSMBP_MARCH:-native}
case $(gfortran -dumpmachine) in
  x86_64*) processors='-march=x86-64-v3 -march=x86-64-v4' ;;
  *) processors=; echo 'ok left out without gfortran for x86-64: which loops are vectorized' ;;
esac

# routines NAME FILE WORDS: the text of these subroutines of a scene
routines() {
  awk -v name="$(echo "$1" | tr a-z A-Z)_" -v words="$3" '
    BEGIN { n = split(words, word) }
    /^      SUBROUTINE/ {
      for (inside = i = 0; ++i <= n;) if (index($0, " " name word[i] "(")) inside = 1
    }
    inside' "$2"
}

# vectorizer FILE... OPTION...: what it says, in a file `report`
vectorizer() { gfortran "$@" -fopenmp-simd -fopt-info-vec -o report.o -c >report 2>&1; }

# vectorized ROUTINE FILE: the loop with the whole of the routine, by that report
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
