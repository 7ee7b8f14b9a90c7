#!/usr/bin/python3 -B
"""read_tex.py FILE...: reads the equations that gsmbp_tex has written into FILE.tex as a person
would, and compares their values with those of FILE.val (tests/tools/printed.mac).

A symbol is what its letters and subscripts spell: l_{1} is l1 or l_1, I_{xx3} is Ixx3, \\dot{q}_{1}
is q1_d; one that could be two, or none, of the scene's is an error. Sines and cosines are defined
by the line "$s_{1} = \\sin q_{1}$, ...", names in the constraints by their rows. Every entry has
to be there.
"""
import cmath, re, sys

TOKEN = re.compile(r'\s*(\\operatorname\{\w+\}|\\[a-zA-Z]+|\\[,_]|\d+\.\d+|\d+|[a-zA-Z]|'
                   r'[-+^_(){},/])')
FUNCTIONS = {'ln': cmath.log, 'abs': abs, 'signum': lambda x: (x.real > 0) - (x.real < 0),
             'atan2': lambda y, x: cmath.phase(x.real + 1j*y.real), 'asin': cmath.asin,
             'acos': cmath.acos, 'atan': cmath.atan, 'sqrt': cmath.sqrt}
FUNCTIONS.update((f, getattr(cmath, f)) for f in 'sin cos tan sinh cosh tanh exp'.split())

def tokens(text):
    text = re.sub(r'\\[q]?quad|&|\\[,;!]', ' ', text)
    found, k = [], 0
    while text[k:].strip():
        m = TOKEN.match(text, k)
        if not m: raise ValueError('cannot read: ' + text[k:k + 40])
        found.append(m.group(1)); k = m.end()
    return found

class Reader:
    """a sum of products, as they stand in print: a product is a row of factors"""
    def __init__(self, text, symbols):
        self.t, self.k, self.symbols = tokens(text) + [''], 0, symbols
    def here(self): return self.t[self.k]
    def take(self, expected=None):
        token = self.t[self.k]
        if expected and token != expected:
            raise ValueError('expected %s, found %s' % (expected, ' '.join(self.t[self.k:])))
        self.k += 1
        return token
    def whole(self):
        value = self.sum()
        self.take('')  if self.here() == '' else self.take('the end')
        return value
    def sum(self):
        value, sign = 0, 1
        while True:
            if self.here() in '+-' and self.here(): sign = -1 if self.take() == '-' else 1
            value += sign*self.product()
            if self.here() not in ('+', '-'): return value
    def product(self):
        value = self.power()
        while True:
            if self.here() == '/': self.take(); value /= self.power()
            elif self.here() in ('', ')', '}', ',', '+', '-'): return value
            else: value *= self.power()
    def power(self):
        base = self.factor()
        if self.here() != '^': return base
        self.take()
        self.take('{'); exponent = self.sum(); self.take('}')
        return complex(base)**exponent
    def factor(self):
        t = self.take()
        if t == '(': value = self.sum(); self.take(')'); return value
        if t[0].isdigit(): return float(t)
        if t == '\\tfrac': return self.group()/self.group()
        name = t[len('\\operatorname{'):-1] if t.startswith('\\operatorname{') else t[1:]
        if t[0] == '\\' and name in FUNCTIONS: return FUNCTIONS[name](*self.arguments())
        self.k -= 1
        return self.symbols.value(self.symbol())
    def arguments(self):
        if self.here() != '(': return [self.product()]   # \sin 4q_{1}
        self.take('('); values = [self.sum()]
        while self.here() == ',': self.take(); values.append(self.sum())
        self.take(')')
        return values
    def group(self):
        self.take('{'); value = self.sum(); self.take('}')
        return value
    def symbol(self):
        """a letter, with dots over it and with its subscript: text of the symbol, dots"""
        t = self.take()
        dots = {'\\dot': 1, '\\ddot': 2}.get(t, 0)
        if dots: head = self.braced()
        elif t == '\\mathit': head = self.braced()
        elif t == '\\mathrm': head = 'upright ' + self.braced()
        elif t[0] == '\\' or t.isalpha(): head = t.lstrip('\\')
        else: raise ValueError('expected a symbol, found %s' % t)
        if self.here() != '_': return (head, '', dots)
        self.take()
        return (head, self.braced(), dots)
    def braced(self):
        self.take('{'); text, depth = '', 1
        while depth:
            t = self.take()
            if not t: raise ValueError('a brace is not closed')
            depth += (t == '{') - (t == '}')
            if depth and t not in ('{', '}', '\\mathit'): text += t.lstrip('\\')
        return text

class Symbols:
    """values of the names of the scene; of those that the print defines"""
    def __init__(self, values, typed):
        self.values, self.typed = values, typed
        self.printed = {('upright e', '', 0): cmath.e, ('pi', '', 0): cmath.pi}
    def define(self, symbol, value):
        if symbol in self.printed: raise ValueError('defined twice: %s' % spelt(symbol))
        if self.candidates(symbol): raise ValueError('has two meanings: %s' % spelt(symbol))
        self.printed[symbol] = value
    def candidates(self, symbol):
        head, sub, dots = symbol
        parts = [head] + (sub.split(',') if sub else [])
        names = {''}
        for part in parts: names = {n + j + part for n in names for j in (['', '_'] if n else [''])}
        names = sorted(n + '_d'*(dots == 1) + '_dd'*(dots == 2) for n in names)
        return [n for n in names if n in self.values and (n == head or n not in self.typed)]
    def value(self, symbol):
        if symbol in self.printed: return self.printed[symbol]
        names = self.candidates(symbol)
        if len(names) != 1: raise ValueError('%s is %s' % (spelt(symbol), names or 'not known'))
        return self.values[names[0]]

def spelt(symbol): return '.'*symbol[2] + symbol[0] + (symbol[1] and '_' + symbol[1])

def rows(text):
    """(title, [[labels, expression]]) of every group"""
    for title, body in re.findall(r'^% ([^\n]*)\n\\begin\{align\*\}\n(.*?)\\end\{align\*\}', text,
                                  re.S | re.M):
        entries = []
        for line in re.split(r'\\\\\n', body.rstrip('\n')):
            if '&=' in line:
                left, right = line.split('&=')
                entries.append([[l.strip() for l in left.split(' = ')], right])
            else: entries[-1][1] += ' ' + line
        yield title, entries

def label(text):
    """M_{12} as (M, 1, 2)"""
    m = re.fullmatch(r'\\?(dot\{\\phi\}|[a-zA-Z]+)_\{([\d,]+)\}', text)
    if not m: return None
    name = {'dot{\\phi}': 'phit', 'norm': 'norms'}.get(m.group(1), m.group(1))
    return name + (m.group(2) if name not in 'MH' else
                   m.group(2) if ',' in m.group(2) else ','.join(m.group(2)))

def read(file):
    text = open(file + '.tex').read()
    lines = [l.split() for l in open(file + '.val')]
    number = lambda s: float(s.replace('b', 'e'))
    typed = {n.replace('\\_', '_') for n in re.findall(r'\\mathit\{([^{}]*)\}', text)}
    symbols = Symbols({l[1]: number(l[2]) for l in lines if l[0] == 'symbol'}, typed)
    wanted = {l[1]: number(l[2]) for l in lines if l[0] == 'value'}
    for left, right in re.findall(r'\$([^$]*) = ([^$]*)\$', re.search(r'^(\$.*)?$', text, re.M)[0]):
        symbols.define(Reader(left, None).symbol(), Reader(right, symbols).whole())
    rates, worst = 0, 0.0
    for title, entries in rows(text):
        for labels, right in entries:
            try: value = Reader(right, symbols).whole()
            except ValueError as e: raise ValueError('%s: %s' % (labels[0], e))
            for l in labels:
                if title.startswith('names'):
                    name = Reader(l, None).symbol()
                    symbols.define(name, value)
                    spelt = ''.join(name[:1]) + name[1]
                    key = [k for k in wanted if k.replace('_', '') in spelt][0]
                elif title.startswith('rates of the coordinates'):
                    rates += 1; key = 'rates%d' % rates
                    symbol = Reader(l, None).symbol()
                    if not symbols.candidates(symbol): symbols.define(symbol, value)
                else: key = label(l)
                if key not in wanted: raise ValueError('%s (%s) is no entry' % (l, key))
                expected = wanted.pop(key)
                error = abs(value - expected)/max(1.0, abs(expected))
                worst = max(worst, error)
                if error > 1e-10: raise ValueError('%s: %s, not %s' % (key, value, expected))
    missing = [k for k, v in wanted.items() if not may_be_left_out(k, v, wanted)]
    if missing: raise ValueError('not printed: ' + ', '.join(missing))
    for what in ('Speeds', 'Multipliers'):
        worst = max(worst, check_list(what, text, lines, symbols))
    return worst

def may_be_left_out(key, value, wanted):
    """M is symmetric; rates that are the speeds; phi, phit that are 0"""
    m = re.fullmatch(r'M(\d+),(\d+)', key)
    if m: return int(m.group(1)) > int(m.group(2))
    if key.startswith('rates'): return all(k in wanted for k in wanted if k.startswith('rates'))
    return re.match(r'phit?\d', key) and value == 0

def check_list(what, text, lines, symbols):
    """every speed or multiplier is told; the error of speeds that are equations"""
    n, worst = [int(l[1]) for l in lines if l[0] == what.lower()][0], 0.0
    m = re.search(r'^%s: (.*?)\.$' % what, text, re.S | re.M)
    told = ' '.join(m.group(1).split()).split('; ') if m else []
    if told == [r'$u = \dot q$, the rates of the coordinates']: return worst
    if len(told) != n: raise ValueError('%d %s are told, not %d' % (len(told), what, n))
    own = [re.fullmatch(r'\$([^$]*) = ([^$]*)\$', t) for t in told]
    for left, right in [o.groups() for o in own if o]:
        u, v = (Reader(x, symbols).whole() for x in (left, right))
        worst = max(worst, abs(u - v))
        if abs(u - v) > 1e-10: raise ValueError('%s is %s, its rates say %s' % (left, u, v))
    return worst

for file in sys.argv[1:]:
    name = file.split('/')[-1]
    try: print('ok %s: TeX read back, worst error %.1e' % (name, read(file)))
    except (ValueError, ZeroDivisionError) as e: print('not ok %s: %s' % (name, e))
