# The Fortran: what is emitted for the scenes of the tests, and the run time of share/fortran. Needs
# the scenes derived (tests/run does that).
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out
: >"$report"

# what is not of the fixed form; variable emitted: yes or no
cat >"$work/fixed_form.awk" <<'A'
function fault(text) { print FNR ": " text }
/^[Cc*]/           { next }
length($0) > 72    { fault("beyond column 72: " $0) }
/\t/               { fault("a tab: " $0) }
/^     [^ 0]/      { if (++lines == 20) fault("more than 19 continuation lines") }
!/^     [^ 0]/     { lines = 0 }
{
  text = " " toupper(substr($0, 7)) " "
  if (text ~ /[^A-Z0-9_.][0-9]+\.[0-9]*(E|[^0-9D.A-Z])/) fault("a constant without D: " $0)
  forbidden = "^ *(COMMON|SAVE|WRITE|READ|PRINT|STOP|OPEN|DATA|ENTRY|GO ?TO)[ (*]"
  if (emitted == "yes" && text ~ forbidden) fault("not in emitted code: " $0)
  line = toupper($0)
  gsub(/[^A-Z0-9_]+/, " ", line)
  n = split(line, word, " ")
  for (i = 1; i <= n; i++)
    if (word[i] ~ /^[A-Z]/ && length(word[i]) > 31) fault("more than 31 characters: " word[i])
}
A
# warnings FILE: what the compiler writes, now or when tests/run compiled these texts
warnings() {
  kept=$GSMBP_TEST_DIR/warnings/${1##*/}
  { read -r sum && [ "$sum" = "$(md5sum <"$1")" ] && cat; } 2>/dev/null <"$kept" && return
  # -Og: two thirds of the time, with a false warning of gspas.f
  gfortran $(cat tests/tools/compiler/warnings) -frecursive -O1 -S "$1" -o /dev/null 2>&1
}
standard=all,no-long-name,no-name-underscore,no-implicit-none
usage=no-arg-unused,no-ext-unused,no-arg-array-alias
ftnchek=no
has ftnchek 'what it says of the emitted Fortran and the run time' && ftnchek=yes

for file in "$GSMBP_TEST_DIR"/fortran_out/*.f \
  $(find share/fortran share/controllers -name "*.f"); do
  [ -f "$file" ] || { echo "not ok no Fortran at $file"; continue; }
  name=${file##*/}
  emitted=no
  case $file in "$GSMBP_TEST_DIR"/*) emitted=yes ;; esac

  warnings "$file" >"$report"
  result "$name compiles without a warning"

  awk -v emitted=$emitted -f "$work/fixed_form.awk" "$file" >"$report"
  result "$name keeps to the fixed form"

  if [ $emitted = yes ]; then
    awk -f tests/tools/emitted_text.awk "$file" >"$report"
    result "$name says what its arguments and constants are, and its methods"
  fi

  # workspace handed on by its first element, routines called from other files, and IAND
  # (MIL-STD-1753, Fortran 95) are the run time's custom
  custom= more=
  [ $emitted = no ] && custom='-array=none' more=',no-intrinsic'
  [ "$ftnchek" = yes ] || continue
  ftnchek -nopretty -noextern $custom -f77=$standard$more -usage=$usage "$file" 2>&1 |
    grep -E -A4 '^(Warning|Error)|Nonstandard|[1-9][0-9]* (warning|syntax error)' >"$report"
  result "$name is clean under ftnchek"
done

for name in case_01a case_02a_motor; do
  share/make/derive tests/scenes/$name.mac "$work/again" >/dev/null 2>&1 ||
    echo "derive failed" >"$report"
  for part in f json; do
    cmp "$GSMBP_TEST_DIR/fortran_out/$name.$part" "$work/again/$name.$part" >>"$report" 2>&1
  done
  result "$name: same scene, same bytes"
done
