# The emitter on artificial routines (tests/tools/emit_cases.mac): compiles without a warning,
# values against Maxima in 50 digits, in double and in quad precision, operation counts against an
# independent counter of the text, same bytes whatever the session holds.
root=$PWD
. tests/tools/check.sh
root=$PWD
flags='-std=f95 -Wall -Wextra -pedantic -fimplicit-none -Wno-unused-dummy-argument -Werror'
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out

mkdir "$work/a" "$work/b" "$work/quad"
load="load(\"gsmbp/gsmbp.mac\")\$ load(\"tests/tools/emit_cases.mac\")\$"
share/make/maxima "$work/log" "$load records : emit_records()\$
  emit_write(\"$work/a\", records)\$ emit_write_driver(\"$work/a\", records)\$
  emit_time(\"$work/time\")\$" || { echo 'not ok the emitter runs'; exit; }
share/make/maxima "$work/log" "$load records : emit_records()\$
  [m, q, w, x, y, c, d, e, k, n, r, s, t, x1, x2, x3] : makelist(i, i, 1, 16)\$
  [sin, max, data, total, text, lines, code, args_] : makelist(i, i, 17, 24)\$
  [fpprintprec, numer, listarith, stringdisp] : [4, true, false, true]\$
  [display2d, exptdispflag, inflag, obase] : [false, false, true, 16]\$
  emit_write(\"$work/b\", records)\$ obase : 10\$" ||
  echo 'not ok the emitter runs in a session that binds everything'
for part in f json; do
  cmp "$work/a/emit.$part" "$work/b/emit.$part" >"$report" 2>&1
  result "emit.$part: same bytes in another session"
done

cd "$work/a" || exit
gfortran $flags -c emit.f >"$report" 2>&1; result 'compiles without a warning'
if has ftnchek 'what it says of artificial routines'; then
  ftnchek -library -noextern -usage=no-arg-unused emit.f 2>&1 |
    grep -A4 -E '^(Warning|Error)|[1-9][0-9]* (warning|syntax)' >"$report"
  result 'clean under ftnchek'
fi
awk 'length > 72 || /[^ -~]/ { print FNR ": " $0 }
  /^     \$/  { if (++n > 19) print FNR ": too many lines" }
  !/^     \$/ { n = 0 }' emit.f >"$report"
result 'columns and continuation lines'

# counts of the header, of the JSON and of the text
json_counts() {
  { tr -d '\n' <"$1"; echo; } | sed 's/"name": "\([A-Z_0-9]*\)", *"purpose/\n@\1 "purpose/g' |
    sed -n 's/^@\([A-Z_0-9]*\) .*"mul": \([0-9]*\), "add": \([0-9]*\), "div": \([0-9]*\), '\
'"sqrt": \([0-9]*\), "trig": \([0-9]*\).*/\1 \2 \3 \4 \5 \6/p'
}
awk -f "$root/tests/tools/opcount.awk" emit.f >text
json_counts emit.json >json
awk '/^ +SUBROUTINE/ { name = $2; sub(/\(.*/, "", name) }
  / mul, .* trig/ { gsub(/[A-Za-z,]/, ""); print name, $1, $2, $3, $4, $5 }' emit.f >header
diff text header >"$report" 2>&1
result "operations of the header are those of the text ($(wc -l <text) routines)"
diff text json >"$report" 2>&1
result 'operations of the JSON are those of the text'
# with the parts LIN1, LIN2, ... of a long routine, which the JSON does not name, added to LIN
with_parts() {
  awk 'NR == FNR { named[$1]; next }
    { name = $1; if (!(name in named)) sub(/[0-9]+$/, "", name)
      if (!(name in seen)) { seen[name]; order[++n] = name }
      for (i = 2; i <= 6; i++) sum[name, i] += $i }
    END { for (k = 1; k <= n; k++) { printf "%s", order[k]
        for (i = 2; i <= 6; i++) printf " %d", sum[order[k], i]
        print "" } }' "$1" -
}
for file in "${GSMBP_TEST_DIR:-/nowhere}"/fortran_out/*.f; do
  [ -f "$file" ] || continue
  json_counts "${file%.f}.json" >json
  awk -f "$root/tests/tools/opcount.awk" "$file" | with_parts json >scene
  diff scene json >"$report" 2>&1
  result "operations of $(basename "$file") ($(wc -l <json) routines)"
done
[ "$(wc -l <text)" -eq 8 ] && echo 'ok eight routines' || echo 'not ok eight routines'

# Values.  In double precision the random expressions (powers of powers) lose up to six digits; quad
# shows that no digit is lost in the text.
for file in emit driver; do
  gfortran -c $file.f && gfortran -freal-8-real-16 -c $file.f -o "$work/quad/$file.o" ||
    echo "not ok $file.f compiles"
done
gfortran emit.o driver.o -o double && ./double | sed 's/$/ 1E-9 double/' >values
gfortran "$work"/quad/*.o -o quad && ./quad | sed 's/$/ 1E-27 quad/' >>values
awk '{ print ($2 + 0 <= $3 + 0 ? "ok " : "not ok ") $1 " in " $4 " precision: error " $2 \
  " (at most " $3 ")" }' values
[ "$(wc -l <values)" -eq 14 ] && echo 'ok all routines ran' || echo 'not ok all routines ran'

awk '{ print ($2 > 3000 ? "ok " : "not ok ") "3000 assignments: " $2 " lines" }' "$work/time"

# files appear whole or not at all: an error while a line is written leaves what was there, and no
# new file
cd "$root" || exit
mkdir "$work/files"; echo old >"$work/files/kept.f"
share/make/maxima "$work/log" "load(\"gsmbp/gsmbp.mac\")\$ dir : \"$work/files/\"\$
  pairs(paths, lines) := map(lambda([p, l], [sconcat(dir, p), l]), paths, lines)\$
  fails(paths, lines) := is(errcatch(gs__write_files(pairs(paths, lines))) = [])\$
  whole : fails([\"kept.f\", \"new.json\"], [[\"new\"], 5])\$
  nowhere : fails([\"kept.f\", \"no/such/new.f\"], [[\"new\"], [\"new\"]])\$
  gs__write_files(pairs([\"pair.f\", \"pair\"], [[\"a~a\", \"b\"], [\"c\"]]))\$
  printf(true, \"~%answers ~a ~a~%\", whole, nowhere)\$" &&
  grep -q '^answers true true' "$work/log"
told $? 'a bad line or place is an error' "$work/log"
check 'the error names the folder' grep -q "there is no folder .*/no/such/" "$work/log"
cd "$work/files" || exit
ls >"$report"
[ "$(tr '\n' ' ' <"$report")" = 'kept.f pair pair.f ' ] && [ "$(cat kept.f)" = old ]
told $? 'nothing is left or changed' "$report"
printf 'a~a\nb\n' | cmp - pair.f >"$report" 2>&1; result 'a file holds its lines'
