# The manual: every public function is in its index; every entry of the index opens in describe with
# its text (on ECL too in make test-whole); example works for every function; every word of the
# scene language has its picture, or is said to have none. Its sessions: sessions_*.sh.
. tests/tools/check.sh
report=$(mktemp)
trap 'rm -f "$report"' EXIT
make --no-print-directory manual >"$report" 2>&1
told $? 'info and index are made' "$report"
# what a system has no package for is said each time
make --no-print-directory manual 2>&1 | grep -v '^GSMBP: missing: ' >"$report"
result 'what is made is not made again'
if whole; then
  rm share/manual/units.texi
  share/make/manual info >"$report" 2>&1
  result 'share/make/manual info makes what it needs'
fi
share/make/manual >"$report" 2>&1 && echo 'not refused' >>"$report"
sed -i '/^manual: expected sources, info, html or pdf; found nothing$/d' "$report"
result 'share/make/manual without a word says which there are'
(cd share/manual && makeinfo --no-split -o /dev/null gsmbp.texi) >"$report" 2>&1
result 'makeinfo has no warning'
index=share/manual/gsmbp-index.lisp
# readers of info, Octave's doc among them, find nodes and the index by the table at the end
/usr/bin/python3 - octave/doc.info >"$report" <<'END'
import re
import sys
text = open(sys.argv[1], 'rb').read()
rows = re.findall(rb'(?m)^Node: ([^\x7f\n]*)\x7f(\d+)$', text)
for name, place in rows:
    head = text[int(place):].split(b'\n', 2)[:2]
    if head[0] != b'\x1f' or b'Node: %s,' % name not in head[1] + b',':
        print('%s is not at %s' % (name.decode(), place.decode()))
if len(rows) < 100 or text.count(b'\x1f\nFile: ') != len(rows):
    print('%d nodes in the table' % len(rows))
END
result 'the table of nodes tells where they are'

{ grep -oE '^gsmbp_[A-Za-z0-9_]+' share/manual/functions.txt; ls octave/gsmbp_*.m |
  sed 's|.*/||; s|\.m$||'; } | sort -u | while read -r name; do
  grep -q "(\"$name\" \." $index || echo "$name"
done >"$report"
result 'every public function is in the index'
{ grep -oE '^gsmbp_[A-Za-z0-9_]+' share/manual/functions.txt | sort -u | while read -r name; do
  grep -q "^@c of $name\$" share/manual/examples.texi || echo "$name"
done; } | grep -vx -e gsmbp_actuator_entry -e gsmbp_demo >"$report"
result 'every function of Maxima has an example'
grep -L '^## >> ' octave/gsmbp_*.m >"$report"
result 'every function of Octave has an example'

# words of options, requests and units, from where they are read
/usr/bin/python3 - >"$report" <<'END'
import glob
import re
for path in sorted(glob.glob('octave/gsmbp_*.m')):
    text = open(path).read()
    help_text = ''.join(re.findall(r'(?m)^##.*$', text))
    if path.endswith('gsmbp_simulate.m'):
        text = open('octave/+gs/+run/option_table.m').read()
    for table in re.findall(r'table = (?:\[)?\{(.*?)\};', text, re.S):
        for word in re.findall(r'(?m)^\s*"(\w+)", ', '  ' + table):
            if '"%s"' % word not in help_text:
                print('%s: option %s' % (path, word))
code = open('share/manual/code.texi').read()
rows = open('gsmbp/emit/requests.mac').read().split('gs__request_rows :')[1].split('$')[0]
for word, suffix in re.findall(r'\[(\w+), "(\w+)", gs__d', rows):
    if word not in code:
        print('code.texi: request %s, %s' % (word, suffix))
# the first column of the table has every subroutine once
made = {'PAR', 'PRE', 'STD'} | set(re.findall(r'\[\w+, "(\w+)", gs__d', rows))
for path in glob.glob('gsmbp/*/*.mac'):
    made |= set(re.findall(r'suffix = "(\w+)"', open(path).read()))
table = code.split('@headitem Subroutine @tab Does')[1].split('@end multitable')[0]
listed = [name for row in re.findall(r'(?m)^@item (.*?) @tab', table)
          for name in re.findall(r'_([A-Z0-9]+(?:_[VW])?)\b', row)]
for name in sorted(made | set(listed)):
    known = name in made or re.match(r'C[TD]\d', name)
    if listed.count(name) != 1 or not known:
        print('code.texi: subroutine _%s: %d times in the table' % (name, listed.count(name)))
END
result 'every option of Octave, every request and, once, every subroutine is in the manual'

/usr/bin/python3 tests/tools/pictures.py
(cd share/manual && makeinfo --html --no-split -o "$report.html" gsmbp.texi) >"$report" 2>&1 &&
  share/make/with_pictures "$report.html" share/manual >"$report.page" 2>>"$report" &&
  [ "$(grep -o 'src="data:image/svg+xml;base64,' "$report.page" | wc -l)" -eq \
    "$(ls share/manual/pictures | wc -l)" ] && ! grep -q 'src="[^d]' "$report.page"
told $? 'the page of HTML has all pictures in it' "$report"
rm -f "$report.html" "$report.page"

names=$(sed -n 's/^.*("\([^"]*\)" \. ("gsmbp.info" [0-9]* [0-9]* .*/"\1"/p' $index | paste -s -d ,)
nodes=$(sed -n 's/^.*("\([^"]*\)" \. ("gsmbp.info" [0-9]* [0-9]*))*$/"\1"/p' $index | paste -s -d ,)
for maxima in maxima ${GSMBP_WHOLE:+maxima-sage}; do
  has $maxima 'topics of the manual in describe' || continue
  rm -f "$report"
  MAXIMA=$maxima share/make/maxima "$report.log" "load(\"$PWD/gsmbp/gsmbp.mac\")\$
    load(\"$PWD/tests/tools/topics.lisp\")\$ names : [$names]\$
    lost : sublist(names, lambda([n], topic_opens(n) # true))\$ nodes : [$nodes]\$
    empty : sublist(nodes, lambda([n], node_opens(n) # true))\$
    with_stdout(\"$report\", print(\"looked up\", length(names), lost),
      print(\"sections\", length(nodes), empty))\$" >/dev/null 2>&1
  grep -q '^looked up [1-9][0-9][0-9]* \[\]' "$report" &&
    grep -q '^sections [1-9][0-9][0-9]* \[\]' "$report"
  told $? "$maxima: every entry of the index opens in describe, with text" "$report"
done

# in a folder of its own: examples write files
work=$(mktemp -d)
top=$PWD
examples=$(sed -n 's/^&& \(gsmbp_[a-z_]*\)$/\1/p' share/manual/gsmbp.demo)
if ! (cd "$work" && "$top/share/make/maxima" "$report.log" "load(\"$top/gsmbp/gsmbp.mac\")\$
  $(for name in $examples; do
    echo "if errcatch(example($name)) = [] then print(\"not an example:\", $name)\$"
  done)") >/dev/null 2>&1; then
  echo 'Maxima failed' >"$report"
else grep -n '^not an example:\|an error' "$report.log" >"$report"
fi
result 'example() of every function runs'
rm -rf "$report.log" "$work"
