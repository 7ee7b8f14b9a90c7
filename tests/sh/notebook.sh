# The tutorial as notebooks (share/make/notebook): every input of the Texinfo source is in them;
# what wxMaxima opens runs in Maxima, and a matrix that is returned reaches the display of a front
# end as it is; in Jupyter every cell is whole and every scene that a cell derives was written by a
# cell before (make check-notebook runs them); the page fetches nothing, shows the figures and has
# every equation that is printed as MathML.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
share/make/notebook share/manual/tutorial.texi "$work" >"$work/log" 2>&1
told $? 'the notebooks are made' "$work/log"

/usr/bin/python3 - "$work" <<'END'
import html, json, re, sys
from html.parser import HTMLParser
work = sys.argv[1]
def check(what, good, found=''):
    print('%s %s%s' % ('ok' if good else 'not ok', what, '' if good else ': %s' % found))
def plain(text):
    return text.replace('@@', '@').replace('@{', '{').replace('@}', '}')
source = open('share/manual/tutorial.texi').read()
first = {p: [plain(x) for e in re.findall(r'@example\n(.*?)@end example', source, re.S)
             for x in re.findall(mark + r'(.*)', e)]
         for p, mark in (('maxima', r'\(%i\d+\) '), ('octave', r'>> '))}
page = open(work + '/gsmbp-notebook.html').read()
typed = [html.unescape(x) for x in re.findall(r'<pre class="in [^>]*>(.*?)</pre>', page, re.S)]
check('the page has every input, in its order, %d' % len(typed),
      [x.split('\n')[0] for x in typed] ==
      [plain(x) for x in re.findall(r'^(?:\(%i\d+\) |>> )(.*)', source, re.M)], typed)
wxm = open(work + '/gsmbp-tutorial.wxm').read()
cells = re.findall(r'input   start \] \*/\n(.*?)\n/\* \[wxMaxima: input   end', wxm, re.S)
lines = '\n'.join(cells).split('\n')
check('wxMaxima has every input of Maxima, %d' % len(first['maxima']),
      len(first['maxima']) > 15 and all(x in lines for x in first['maxima']))
book = json.load(open(work + '/gsmbp-tutorial.ipynb'))
code = [''.join(c['source']) for c in book['cells'] if c['cell_type'] == 'code']
files = {}
for k, x in enumerate(code):
    name = re.match(r'%%file (\w+\.mac)\n', x)
    if name:
        files[name.group(1)] = k
derived = [(k, re.match(r'gsmbp_derive \("(\w+\.mac)", "fortran_out"\);$', x))
           for k, x in enumerate(code)]
derived = [(k, m.group(1)) for k, m in derived if m]
check('Jupyter: each scene is written and then derived, %d' % len(files),
      len(files) > 4 and sorted(files) == sorted(n for k, n in derived)
      and all(files[n] < k for k, n in derived), derived)
check('Jupyter: the functions of GSMBP are found first', 'addpath' in code[0], code[0])
own = code[0], 'clear'
code = [x for x in code if not re.match('%%file|gsmbp_derive', x) and x not in own]
sys.path.insert(0, 'share/make')
sys.dont_write_bytecode = True
from typed_lines import goes_on
check('Jupyter: every cell is whole', not any(goes_on('octave', x) for x in code),
      [x for x in code if goes_on('octave', x)])
check('an open loop and an open call go on, closed ones do not',
      [goes_on('octave', x) for x in ('for k = 1:3', 'for k = 1:3, f (k); end', 'f (1, ...',
                                      'a = [1', 'x = "(";', "y = x';")] ==
      [True, False, True, True, False, False])
check('Jupyter: nbformat 4, every cell with its fields, every input of Octave, %d' % len(code),
      book['nbformat'] == 4 and [c.split('\n')[0] for c in code] == first['octave']
      and all({'metadata', 'source'} <= set(c) and
              (c['cell_type'] == 'markdown' or {'outputs', 'execution_count'} <= set(c))
              for c in book['cells']))
printed = [html.unescape(x) for x in re.findall(r'<pre class="out [^>]*>(.*?)</pre>', page, re.S)]
check('outputs are those of the manual',
      len(printed) > 30 and all(x in plain(source) for x in printed))
class Reader(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.wrong, self.math, self.pictures, self.fetched = [], [], 0, 0, []
    def handle_starttag(self, tag, attributes):
        self.math += tag == 'math'
        self.open += [tag] if tag not in ('meta', 'img') else []
        self.wrong += [tag] if tag == 'script' else []
    def handle_startendtag(self, tag, attributes):
        for name, value in attributes:
            if name in ('src', 'href') and not value.startswith('data:'):
                self.fetched.append(value)
        self.pictures += tag == 'img'
    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append('/' + tag)
r = Reader()
r.feed(page)
check('the page: tags are closed, no script', not r.wrong and not r.open, r.wrong + r.open)
check('nothing is fetched', not r.fetched, r.fetched)
check('all figures are in it', r.pictures == len(re.findall('@image', source)) > 3, r.pictures)
shown = re.findall(r'gsmbp_equations\(', '\n'.join(typed))
check('equations as MathML behind each that is printed', len(shown) > 1 and r.math > 20, r.math)
END
root=$PWD
{
  # a display of a front end's own, as wxMaxima sets one: it writes what it is given
  echo ':lisp (defun displa (form) (format t "shown: ~s~%" form))'
  sed -n '/input   start/,/input   end/p' "$work/gsmbp-tutorial.wxm" | grep -v '^/\* \[wxMaxima' |
    sed "s|load(\"gsmbp\")|load(\"$root/gsmbp/gsmbp.mac\")|"
  echo 'printf(true, "end of the notebook ~a~%", display2d)$'
} >"$work/typed.mac"
(cd "$work" && timeout -k 5 300 maxima --very-quiet <typed.mac >typed.log 2>&1)
grep -q 'end of the notebook true' "$work/typed.log" &&
  ! grep -q 'an error. To debug' "$work/typed.log"
told $? 'Maxima types what wxMaxima opens, without an error' "$work/typed.log"
tr -s '\n ' '  ' <"$work/typed.log" | grep -q 'shown: ((MLABEL[^)]*) $%O[0-9]* (($MATRIX'
told $? 'returned equations reach the display of the front end as expressions' "$work/typed.log"
