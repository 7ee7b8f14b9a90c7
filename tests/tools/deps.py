#!/usr/bin/env python3
"""deps.py ROOT [OUTDIR] [--brief]: who uses whom in a tree of GSMBP.

Reads ROOT/gsmbp/**/*.mac, *.lisp (functions, variables and structures of Maxima, functions of
Lisp), ROOT/share/fortran (CALLs), ROOT/octave (functions by file name). It works on text only:
nothing is run, nothing is written below ROOT. It prints a report; with OUTDIR it writes gsmbp.dot,
fortran.dot and octave.dot there (files; red: an edge within a circle).

A use is: a name that stands with `(` behind it, or anywhere else where it is no local name of the
same definition (a parameter, a name of block([..]) or lambda([..]), or one behind `for`). Lines
are those of the definition without the comment above it.
"""

import os, re, sys, collections

LONG_LINES, WIDE = 25, 160  # a function over either is listed


# ---------------------------------------------------------------------- text
def strip_mac(t):
    """Maxima text with comments and the inside of strings blanked, same length and lines."""
    out, i, n, depth = list(t), 0, len(t), 0
    while i < n:
        if t.startswith('/*', i):
            depth, j = 1, i + 2
            while j < n and depth:
                if t.startswith('/*', j):
                    depth += 1
                    j += 2
                elif t.startswith('*/', j):
                    depth -= 1
                    j += 2
                else:
                    j += 1
            for k in range(i, j):
                if out[k] != '\n':
                    out[k] = ' '
            i = j
        elif t[i] == '"':
            j = i + 1
            while j < n and t[j] != '"':
                j += 2 if t[j] == '\\' else 1
            for k in range(i + 1, min(j, n)):
                if out[k] != '\n':
                    out[k] = ' '
            i = j + 1
        else:
            i += 2 if t[i] == '\\' else 1
    return ''.join(out)


def strip_lisp(t):
    out, i, n = list(t), 0, len(t)
    while i < n:
        if t[i] == ';':
            while i < n and t[i] != '\n':
                out[i] = ' '
                i += 1
        elif t.startswith('#|', i):
            j = t.find('|#', i)
            j = n if j < 0 else j + 2
            for k in range(i, j):
                if out[k] != '\n':
                    out[k] = ' '
            i = j
        elif t.startswith('#\\', i):
            i += 3
        elif t[i] == '"':
            j = i + 1
            while j < n and t[j] != '"':
                j += 2 if t[j] == '\\' else 1
            for k in range(i + 1, min(j, n)):
                if out[k] != '\n':
                    out[k] = ' '
            i = j + 1
        else:
            i += 1
    return ''.join(out)


def statements(s):
    """(start, end) of the statements of stripped Maxima text (ended by $ or ; outside brackets)."""
    depth, start = 0, 0
    i = 0
    while i < len(s):
        c = s[i]
        if c == '\\':
            i += 2
            continue
        if c in '([{':
            depth += 1
        elif c in ')]}':
            depth -= 1
        elif c in '$;' and depth == 0:
            yield start, i + 1
            start = i + 1
        i += 1


def toplevel_forms(s):
    depth, start = 0, None
    i = 0
    while i < len(s):
        c = s[i]
        if c == '#' and s.startswith('#\\', i):
            i += 3
            continue
        if c == '(':
            if depth == 0:
                start = i
            depth += 1
        elif c == ')':
            depth -= 1
            if depth == 0 and start is not None:
                yield start, i + 1
        i += 1


def bracket_names(s, head):
    """names bound by head([a, b : x, ...]) in s"""
    names = set()
    for m in re.finditer(head, s):
        i, depth, item = m.end(), 1, ''
        parts = []
        while i < len(s) and depth:
            c = s[i]
            if c in '([':
                depth += 1
            elif c in ')]':
                depth -= 1
                if depth == 0:
                    break
            if c == ',' and depth == 1:
                parts.append(item)
                item = ''
            else:
                item += c
            i += 1
        parts.append(item)
        for p in parts:
            w = re.match(r"\s*\[?\s*'?\s*([A-Za-z_%][\w%]*)", p)
            if w:
                names.add(w.group(1))
    return names


# ---------------------------------------------------------------------- package
class Def:
    def __init__(self, name, file, line, end, kind, body, raw):
        self.name, self.file, self.line, self.end, self.kind, self.body, self.raw = (
            name,
            file,
            line,
            end,
            kind,
            body,
            raw,
        )
        self.lines = raw.strip('\n').count('\n') + 1
        self.width = max((len(l) for l in raw.split('\n')), default=0)


def read_package(root):
    base = os.path.join(root, 'gsmbp')
    files = sorted(
        os.path.join(d, f)
        for d, _, fs in os.walk(base)
        for f in fs
        if f.endswith(('.mac', '.lisp')) and 'compiled/' not in d + '/'
    )
    defs, top = [], collections.defaultdict(list)
    for p in files:
        f = os.path.relpath(p, base)
        t = open(p, encoding='utf-8', errors='replace').read()
        if p.endswith('.mac'):
            s = strip_mac(t)
            for a, b in statements(s):
                while a < b and s[a].isspace():
                    a += 1
                body, raw = s[a:b], t[a:b]
                line, end = s.count('\n', 0, a) + 1, s.count('\n', 0, b) + 1
                m = re.match(r'([A-Za-z_]\w*)\s*\(', body)
                kind = None
                if m and m.group(1) == 'defstruct':
                    kind, name = 'struct', re.match(r'defstruct\s*\(\s*(\w+)', body).group(1)
                elif m and m.group(1) == 'define_variable':
                    kind, name = 'variable', re.match(r'define_variable\s*\(\s*(\w+)', body).group(
                        1
                    )
                elif m:
                    i, d = m.end(), 1
                    while i < len(body) and d:
                        d += body[i] in '(['
                        d -= body[i] in ')]'
                        i += 1
                    r = re.match(r'\s*(::?=)', body[i:])
                    if r:
                        kind, name = ('macro' if r.group(1) == '::=' else 'function'), m.group(1)
                if kind is None:
                    m = re.match(r'(gs(?:mbp)?_\w*)\s*(\[.*?\])?\s*:(?![:=])', body)
                    if m:
                        kind, name = 'variable', m.group(1)
                    elif re.match(r'gs(?:mbp)?_\w*\s*\[.*?\]\s*:=', body):
                        kind, name = 'function', re.match(r'gs(?:mbp)?_\w*', body).group(0)
                if kind:
                    defs.append(Def(name, f, line, end, kind, body, raw))
                elif body.strip():
                    top[f].append(body)
        else:
            s = strip_lisp(t)
            for a, b in toplevel_forms(s):
                body, raw = s[a:b], t[a:b]
                line, end = s.count('\n', 0, a) + 1, s.count('\n', 0, b) + 1
                m = re.match(
                    r'\((def(?:un|mfun|macro|mspec|var|parameter|constant|struct|mvar|setf)'
                    r'|declaim)'
                    r'\s+\(?\s*([^\s()]+)',
                    body,
                )
                if m and m.group(1) != 'declaim':
                    kind = {
                        'defmacro': 'macro',
                        'defvar': 'variable',
                        'defparameter': 'variable',
                        'defconstant': 'variable',
                        'defmvar': 'variable',
                        'defstruct': 'struct',
                    }.get(m.group(1), 'function')
                    defs.append(Def(m.group(2).lower(), f, line, end, kind, body, raw))
                else:
                    top[f].append(body)
    return files, defs, top


def canon(name):
    """one spelling for Maxima and Lisp: $gs__x is gs__x; gs-x stays."""
    return name[1:] if name.startswith('$') else name


def uses_of(body, is_lisp, known):
    if is_lisp:
        toks = re.findall(r'[^\s()\'`,#"|]+', body.lower())
        return collections.Counter(canon(t) for t in toks if canon(t) in known)
    bound = (
        bracket_names(body, r'\blambda\s*\(\s*\[')
        | bracket_names(body, r'\bblock\s*\(\s*\[')
        | set(re.findall(r'\bfor\s+([A-Za-z_]\w*)', body))
    )
    m = re.match(r'([A-Za-z_]\w*)\s*\(', body)
    if m:
        bound |= bracket_names(
            body[: body.find(':=')] if ':=' in body else '', re.escape(m.group(1)) + r'\s*\('
        )
    c = collections.Counter()
    for m in re.finditer(
        r"\?((?:[A-Za-z0-9_*%]|\\.)+)|(?<![@\w%])([A-Za-z_%][\w%]*)(\s*\()?", body
    ):
        if m.group(1):
            w = canon(m.group(1).replace('\\', '').lower())
            if w in known:
                c[w] += 1
        else:
            w = m.group(2)
            if w in known and (m.group(3) or w not in bound):
                c[w] += 1
    return c


def tarjan(nodes, succ):
    index, low, on, st, out, n = {}, {}, set(), [], [], [0]
    sys.setrecursionlimit(10000)

    def go(v):
        index[v] = low[v] = n[0]
        n[0] += 1
        st.append(v)
        on.add(v)
        for w in succ(v):
            if w not in index:
                go(w)
                low[v] = min(low[v], low[w])
            elif w in on:
                low[v] = min(low[v], index[w])
        if low[v] == index[v]:
            comp = []
            while True:
                w = st.pop()
                on.discard(w)
                comp.append(w)
                if w == v:
                    break
            out.append(comp)

    for v in nodes:
        if v not in index:
            go(v)
    return out


def layers(comps, succ):
    """longest way down to a component that uses none: layer 0 uses nothing"""
    where = {v: i for i, c in enumerate(comps) for v in c}
    memo = {}

    def depth(i):
        if i not in memo:
            memo[i] = 0
            memo[i] = max(
                [1 + depth(where[w]) for v in comps[i] for w in succ(v) if where[w] != i], default=0
            )
        return memo[i]

    return {v: depth(where[v]) for v in where}


def short(f):
    f = re.sub(r'^(?:.*/)?gsmbp_', '', f)
    return f[:-4] if f.endswith('.mac') else f


def dot(path, nodes, edges, comp_of, size=None, colour=None):
    with open(path, 'w') as o:
        o.write('digraph deps {\n  rankdir=TB; node [shape=box, fontsize=10, height=0.2];\n')
        for v in nodes:
            o.write(
                '  "%s" [label="%s%s"%s];\n'
                % (
                    v,
                    v,
                    '\\n%d' % size[v] if size else '',
                    ', style=filled, fillcolor="%s"' % colour[v] if colour and v in colour else '',
                )
            )
        for (a, b), w in sorted(edges.items()):
            o.write(
                '  "%s" -> "%s" [penwidth=%.1f%s];\n'
                % (
                    a,
                    b,
                    min(4, 0.5 + w / 8),
                    ', color=red' if comp_of[a] == comp_of[b] else ', color=gray50',
                )
            )
        o.write('}\n')


def loads_in_order(root):
    p = os.path.join(root, 'gsmbp', 'gsmbp.mac')
    t = open(p).read() if os.path.exists(p) else ''
    return re.findall(r'"([\w/]+)"', t)


def other_text(root):
    """text of everything that may name a function from outside gsmbp/"""
    out = {}
    for top in ('share', 'tests', 'examples', 'octave', '.ci', 'Makefile', 'README.md'):
        p = os.path.join(root, top)
        it = [(os.path.dirname(p), [], [os.path.basename(p)])] if os.path.isfile(p) else os.walk(p)
        for d, _, fs in it:
            for f in fs:
                q = os.path.join(d, f)
                if os.path.getsize(q) < 400000 and not f.endswith(('.png', '.gif', '.csv')):
                    try:
                        out[os.path.relpath(q, root)] = open(q, encoding='utf-8').read()
                    except (UnicodeDecodeError, OSError):
                        pass
    return out


def report_package(root, outdir, brief):
    files, defs, top = read_package(root)
    base = os.path.join(root, 'gsmbp')
    names = collections.defaultdict(list)
    for d in defs:
        names[canon(d.name)].append(d)
    known = set(names)
    order = {os.path.relpath(p, base) for p in files}
    use = {}  # (def) -> Counter
    for d in defs:
        own = canon(d.name)
        c = uses_of(d.body, d.file.endswith('.lisp'), known)
        c.pop(own, None)
        use[d] = c
    edges, fedges, users = (
        collections.Counter(),
        collections.defaultdict(set),
        collections.defaultdict(collections.Counter),
    )

    def add(f, c, who):
        for w, n in c.items():
            tgt = names[w]
            g = f if any(x.file == f for x in tgt) else tgt[0].file
            users[w][f] += n
            if g != f:
                edges[(f, g)] += n
                fedges[(f, g)].add((who, w))

    for d in defs:
        add(d.file, use[d], canon(d.name))
    for f, bodies in top.items():
        for b in bodies:
            add(f, uses_of(b, f.endswith('.lisp'), known), '(loading)')
    nodes = sorted(order)
    succ = lambda v: [b for (a, b) in edges if a == v]
    comps = tarjan(nodes, succ)
    comp_of = {v: i for i, c in enumerate(comps) for v in c}
    lay = layers(comps, succ)
    size = {
        f: open(os.path.join(base, f), encoding='utf-8', errors='replace').read().count('\n')
        for f in nodes
    }
    nfun = collections.Counter(d.file for d in defs if d.kind in ('function', 'macro'))
    print(
        '== gsmbp: %d files, %d lines, %d functions and macros, %d variables, %d structures, '
        '%d file edges'
        % (
            len(nodes),
            sum(size.values()),
            sum(nfun.values()),
            sum(d.kind == 'variable' for d in defs),
            sum(d.kind == 'struct' for d in defs),
            len(edges),
        )
    )
    big = [c for c in comps if len(c) > 1]
    print(
        '\n-- cycles between files (strongly connected components): %d; files in the largest: %d'
        % (len(big), max(map(len, big), default=0))
    )
    for c in sorted(big, key=len, reverse=True):
        print('   [%d] %s' % (len(c), ' '.join(sorted(map(short, c)))))
    print('\n-- layers (0 uses no other file; files of one cycle share a layer)')
    for k in sorted(set(lay.values())):
        print('   %2d: %s' % (k, ' '.join(short(f) for f in nodes if lay[f] == k)))
    # function-level cycles across files
    fsucc = lambda n: [w for d in names[n] for w in use[d]]
    fc = [
        c
        for c in tarjan(sorted(known), fsucc)
        if len(c) > 1 and len({names[x][0].file for x in c}) > 1
    ]
    print('\n-- recursion that crosses files (cycles of functions): %d' % len(fc))
    for c in sorted(fc, key=len, reverse=True):
        print(
            '   [%d] %s'
            % (len(c), ' '.join('%s:%s' % (short(names[x][0].file), x) for x in sorted(c)[:14]))
        )
    lo = loads_in_order(root)
    pos = {
        f: i
        for i, n in enumerate(lo)
        for f in nodes
        if short(f) == n or f == n + '.mac' or f.endswith('/' + n + '.mac')
    }
    back = [(a, b, w) for (a, b), w in edges.items() if a in pos and b in pos and pos[b] > pos[a]]
    print(
        '\n-- edges against the order in which gsmbp.mac loads: %d of %d between loaded files'
        % (len(back), sum(a in pos and b in pos for a, b in edges))
    )
    for a, b, w in sorted(back, key=lambda e: (pos[e[0]], pos[e[1]])):
        print(
            '   %-14s -> %-14s %3d  %s'
            % (short(a), short(b), w, ' '.join(sorted({x for _, x in fedges[(a, b)]})[:6]))
        )
    print('\n-- files: lines, functions, used by (files), uses (files)')
    fin = {f: len({a for a, b in edges if b == f}) for f in nodes}
    fout = {f: len({b for a, b in edges if a == f}) for f in nodes}
    for f in sorted(nodes, key=lambda f: -fin[f]):
        print(
            '   %-20s %4d lines %3d functions  in %2d  out %2d  layer %d'
            % (short(f), size[f], nfun[f], fin[f], fout[f], lay[f])
        )
    outside = other_text(root)
    code_out = {
        p: t
        for p, t in outside.items()
        if not p.startswith(('README', 'examples/')) or p.endswith('.mac') or p.endswith('.m')
    }
    toks = {
        p: set(re.findall(r'gs(?:mbp)?_\w+|gs-[\w-]+', t.replace('\\', '')))
        for p, t in code_out.items()
    }
    dead, tests_only, one_other, own_other = [], [], [], []
    for n, ds in sorted(names.items()):
        d = ds[0]
        if d.kind == 'struct':
            continue
        inside = {f for f in users[n]}
        public = re.match(r'gsmbp_[a-z]', n)
        ext = [p for p, s in toks.items() if n in s]
        if not inside and not public:
            # named in strings or by construction (concat, verbify)?
            (tests_only if ext else dead).append((d, ext))
        elif inside and d.file not in inside and len(inside) == 1:
            one_other.append((d, list(inside)[0]))
    print('\n-- no use found in gsmbp/ (private): %d' % len(dead))
    for d, _ in dead:
        print('   %-34s %s:%d' % (canon(d.name), d.file, d.line))
    print('\n-- used only outside gsmbp/ (private): %d' % len(tests_only))
    for d, e in tests_only:
        print('   %-34s %s:%d  by %s' % (canon(d.name), d.file, d.line, ' '.join(e[:3])))
    print(
        '\n-- used by one other file only, not by its own: %d (candidates to move)' % len(one_other)
    )
    by = collections.defaultdict(list)
    for d, g in one_other:
        by[(d.file, g)].append(canon(d.name))
    for (f, g), l in sorted(by.items(), key=lambda x: -len(x[1])):
        print('   %-18s -> %-18s %2d: %s' % (short(f), short(g), len(l), ' '.join(l)))
    # a function that uses more of one other file than of its own and is used by that file only
    pub = sorted(
        n
        for n, ds in names.items()
        if re.match(r'gsmbp_[a-z]', n) and ds[0].kind in ('function', 'macro')
    )
    print('\n-- public functions: %d: %s' % (len(pub), ' '.join(pub)))
    var = sorted((n, names[n][0].file) for n in names if names[n][0].kind == 'variable')
    print(
        '\n-- global variables: %d: %s'
        % (len(var), ' '.join('%s(%s)' % (n, short(f)) for n, f in var))
    )
    twice = [(n, [x.file for x in ds]) for n, ds in names.items() if len(ds) > 1]
    print('\n-- defined more than once: %s' % twice)
    long_ = sorted(
        (d for d in defs if d.kind in ('function', 'macro') and d.lines > LONG_LINES),
        key=lambda d: -d.lines,
    )
    wide = sorted(
        (d for d in defs if d.kind in ('function', 'macro') and d.width > WIDE),
        key=lambda d: -d.width,
    )
    nf = sum(d.kind in ('function', 'macro') for d in defs)
    print(
        '\n-- functions over %d lines: %d of %d; with a line over %d characters: %d'
        % (LONG_LINES, len(long_), nf, WIDE, len(wide))
    )
    print(
        '   long: '
        + ', '.join('%s(%s) %d' % (canon(d.name), short(d.file), d.lines) for d in long_)
    )
    if not brief:
        print(
            '   wide: '
            + ', '.join('%s(%s) %d' % (canon(d.name), short(d.file), d.width) for d in wide)
        )
    L = sorted(d.lines for d in defs if d.kind in ('function', 'macro'))
    print(
        '   lines of a function: median %d, 90 %% at most %d'
        % (L[len(L) // 2], L[int(0.9 * len(L))])
    )
    alll = [
        l
        for f in nodes
        for l in open(os.path.join(base, f), encoding='utf-8', errors='replace').read().split('\n')
    ]
    print(
        '   lines of the package: %d, over 100 characters %d, over 120 %d, over 160 %d, '
        'over 200 %d, longest %d'
        % (
            len(alll),
            *(sum(len(l) > k for l in alll) for k in (100, 120, 160, 200)),
            max(map(len, alll)),
        )
    )
    idx = re.findall(
        r'\w+_?\[\d+\](?:\[\d+\])*', ' '.join(d.body for d in defs if d.file.endswith('.mac'))
    )
    ord_ = re.findall(
        r'\b(?:first|second|third|fourth|fifth|sixth|seventh|eighth|ninth|tenth)\s*\(',
        ' '.join(d.body for d in defs if d.file.endswith('.mac')),
    )
    pc = re.findall(
        r'\bnew\s*\(\s*(gs__\w+)', ' '.join(d.body for d in defs if d.file.endswith('.mac'))
    )
    print(
        '   numeric indices %d, first..tenth( %d, @field %d, positional new(...) %d'
        % (
            len(idx),
            len(ord_),
            sum(d.body.count('@') for d in defs if d.file.endswith('.mac')),
            len(pc),
        )
    )
    guards = [d for d in defs if re.match(r'gsmbp_[a-z]', canon(d.name)) and d.kind == 'function']
    print('\n-- structures: where made, in how many files their constructor stands')
    st = collections.defaultdict(set)
    for d in defs:
        for m in re.finditer(r'\b(?:new|gs__record)\s*\(\s*(gs__\w+)', d.body):
            st[m.group(1)].add(d.file)
    for n in sorted(st):
        print(
            '   %-22s defined %-12s made in %s'
            % (
                n,
                short(names[n][0].file) if n in names else '?',
                ' '.join(sorted(map(short, st[n]))),
            )
        )
    if outdir:
        colour = {}
        dot(
            os.path.join(outdir, 'gsmbp.dot'),
            [short(f) for f in nodes],
            collections.Counter({(short(a), short(b)): w for (a, b), w in edges.items()}),
            {short(f): comp_of[f] for f in nodes},
            {short(f): size[f] for f in nodes},
        )
    return defs, names, use, edges


# ---------------------------------------------------------------------- fortran
def report_fortran(root, outdir):
    base = os.path.join(root, 'share', 'fortran')
    units, calls, size = {}, {}, {}
    for d, _, fs in os.walk(base):
        for f in sorted(fs):
            if not f.endswith(('.f', '.F', '.for', '.inc')):
                continue
            p = os.path.relpath(os.path.join(d, f), base)
            t = open(os.path.join(d, f), errors='replace').read()
            size[p] = t.count('\n')
            code = '\n'.join(l for l in t.split('\n') if l[:1] not in 'Cc*!')
            for m in re.finditer(
                r'^\s+(?:DOUBLE PRECISION |INTEGER |LOGICAL )?(SUBROUTINE|FUNCTION)\s+(\w+)',
                code,
                re.M | re.I,
            ):
                units.setdefault(m.group(2).upper(), []).append(p)
            calls[p] = code.upper()
    edges = collections.Counter()
    known = set(units)
    ext = collections.defaultdict(set)
    for p, code in calls.items():
        own = {u for u, q in units.items() if p in q}
        for w in set(re.findall(r'\b[A-Z]\w*\b', re.sub(r"'[^'\n]*'", '', code))):
            if w in known and w not in own:
                for q in units[w]:
                    bodies = {os.path.basename(os.path.dirname(f)) for f in (p, q)}
                    if bodies >= {'lapack', 'plain'}:
                        continue  # a build takes one of them
                    edges[(p, q)] += 1
        for w in re.findall(r'\bCALL\s+(\w+)', code):
            if w not in known:
                ext[w].add(p)
    nodes = sorted(size)
    succ = lambda v: [b for a, b in edges if a == v]
    comps = tarjan(nodes, succ)
    comp_of = {v: i for i, c in enumerate(comps) for v in c}
    lay = layers(comps, succ)
    print(
        '\n== share/fortran: %d files, %d lines, %d program units'
        % (len(nodes), sum(size.values()), len(units))
    )
    print('-- cycles: %s' % [c for c in comps if len(c) > 1])
    for k in sorted(set(lay.values())):
        print('   %2d: %s' % (k, ' '.join(f for f in nodes if lay[f] == k)))
    print(
        '-- called here but defined elsewhere (LAPACK, emitted, dummy arguments): %s'
        % ' '.join('%s(%d)' % (w, len(s)) for w, s in sorted(ext.items()))
    )
    pkg = ''
    for top in ('gsmbp', 'octave', 'tests', 'share/make'):
        for d, _, fs in os.walk(os.path.join(root, top)):
            for f in fs:
                if (
                    f.endswith(('.mac', '.lisp', '.m', '.f', '.c', '.cc', '.h', '.sh'))
                    or '.' not in f
                ):
                    pkg += open(os.path.join(d, f), errors='replace').read().upper()
    print('-- fan-in of program units (files here), [E] named in gsmbp/ or octave/ or tests/')
    for u in sorted(units):
        print(
            '   %-8s %-18s used by %2d %s'
            % (
                u,
                units[u][0],
                len({a for a, b in edges if b in units[u]}),
                '[E]' if re.search(r'\b%s\b' % u, pkg) else '',
            )
        )
    if outdir:
        dot(os.path.join(outdir, 'fortran.dot'), nodes, edges, comp_of, size)


# ---------------------------------------------------------------------- octave
def report_octave(root, outdir):
    base = os.path.join(root, 'octave')
    files = {}
    for d, _, fs in os.walk(base):
        for f in fs:
            if f.endswith('.m'):
                files[os.path.splitext(f)[0]] = os.path.join(d, f)
    edges, size = collections.Counter(), {}
    for n, p in files.items():
        t = open(p).read()
        size[n] = t.count('\n')
        code = '\n'.join(
            re.sub(r'[#%].*', '', l) if not re.search(r'["\'].*[#%]', l) else l
            for l in t.split('\n')
        )
        code = '\n'.join(l for l in t.split('\n') if not l.lstrip().startswith(('#', '%')))
        for w in set(re.findall(r'\b[A-Za-z_]\w*\b', code)):
            if w in files and w != n:
                edges[(n, w)] += len(re.findall(r'\b%s\b' % w, code))
    nodes = sorted(files)
    succ = lambda v: [b for a, b in edges if a == v]
    comps = tarjan(nodes, succ)
    comp_of = {v: i for i, c in enumerate(comps) for v in c}
    lay = layers(comps, succ)
    print('\n== octave: %d functions, %d lines' % (len(nodes), sum(size.values())))
    print('-- cycles: %s' % [c for c in comps if len(c) > 1])
    for k in sorted(set(lay.values())):
        print('   %2d: %s' % (k, ' '.join(f for f in nodes if lay[f] == k)))
    print('-- lines, used by, uses')
    for n in sorted(nodes, key=lambda n: -size[n]):
        print(
            '   %-26s %-8s %4d  in %2d out %2d'
            % (
                n,
                'private' if '/private/' in files[n] else 'public',
                size[n],
                sum(b == n for a, b in edges),
                sum(a == n for a, b in edges),
            )
        )
    if outdir:
        dot(os.path.join(outdir, 'octave.dot'), nodes, edges, comp_of, size)


if __name__ == '__main__':
    a = [x for x in sys.argv[1:] if not x.startswith('--')]
    if not a:
        sys.exit(__doc__)
    root, outdir = a[0], (a[1] if len(a) > 1 else None)
    if outdir:
        os.makedirs(outdir, exist_ok=True)
    report_package(root, outdir, '--brief' in sys.argv)
    if os.path.isdir(os.path.join(root, 'share', 'fortran')):
        report_fortran(root, outdir)
    if os.path.isdir(os.path.join(root, 'octave')):
        report_octave(root, outdir)
