"""Mutants of the examples and of tests/scenes: a link, an option, a value, a word is changed by chance."""
import glob, os, random, re
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
def split(s):
    out = []; d = 0; q = False; cur = ''
    for c in s:
        if c == '"': q = not q
        if not q:
            if c in '([{': d += 1
            elif c in ')]}': d -= 1
            elif c == ',' and d == 0: out.append(cur.strip()); cur = ''; continue
        cur += c
    if cur.strip(): out.append(cur.strip())
    return out
def scene_of(path):
    s = re.sub(r'/\*.*?\*/', '', open(path).read(), flags=re.S); k = s.find('scene : gsmbp_scene(')
    if k < 0 or s.count('gsmbp_scene(') != 1 or ':=' in s: return None
    i = s.index('(', k); d = 0; q = False
    for e in range(i, len(s)):
        c = s[e]
        if c == '"': q = not q
        if q: continue
        d += c in '(['; d -= c in ')]'
        if d == 0: break
    return [x for x in split(s[i+1:e])]
def el(t):
    m = re.match(r'(\w+)\((.*)\)$', t, re.S)
    return (m.group(1), split(m.group(2))) if m else None
def opt(t): m = re.match(r'([A-Za-z_]\w*)\s*=\s*(.*)$', t, re.S); return (m.group(1), m.group(2)) if m else None
JOINTS = 'revolute prismatic helical cylindrical universal planar spherical free fixed'.split()
BAD = ['"text"', '[1, 2]', '[1, 2, 3, 4, 5]', 'zzz_unknown', 'foo(1)', '[]', 'inf', '%i', 'a = b', 'lambda([x], x)', 'matrix([1])', "'diff(x, t)", 'und', '[[1]]', '2 + %i', 'false', 'done', 'is(1 < 2)', '{1, 2}', 'x[1]', '"1.5"', 'not a', '1.0e400', "'(f(q))", 'sin']
def mutate(r, E):
    """(text, name of the element, class) or None"""
    E = list(E); k = r.randrange(1, len(E)); t = E[k]; e = el(t); cls = r.choice(['misspell', 'drop_option', 'twice', 'value', 'value', 'value', 'unknown_link', 'self', 'dup_name', 'bad_name', 'word', 'drop_link', 'drop_joint', 'unit', 'drop_par', 'par_twice', 'extra_arg', 'missing_arg', 'zero_axis', 'inertia', 'rotation', 'setting', 'setting_value', 'garbage', 'output', 'parvalue', 'setting_twice'])
    params = next((i for i, x in enumerate(E) if x.startswith('parameters')), None)
    def done(k, w, a, name=None): E[k] = '%s(%s)' % (w, ', '.join(a)); return E, name or a[0], cls
    if cls in ('unit', 'drop_par', 'par_twice', 'parvalue'):
        if params is None: return None
        lst = split(opt(E[params])[1][1:-1]); i = r.randrange(len(lst)); o = opt(lst[i])
        if not o: return None
        if cls == 'unit':
            if '*' not in o[1]: return None
            lst[i] = '%s = %s*%s' % (o[0], o[1].split('*')[0], r.choice(['kg^3', 'mol', 'A^2*s', 'parsec', 'cd', 'N^2', 'V/kg', '"m"', '[m]']))
        elif cls == 'drop_par':
            name = o[0]; lst.pop(i); E[params] = 'parameters = [%s]' % ', '.join(lst)
            return E, name, cls
        elif cls == 'par_twice': lst.append(lst[i])
        else: lst[i] = '%s = %s' % (o[0], r.choice(['"text"', '[1]', 'inf', '%i', 'zzz*qq', 'foo(3)', 'true', 'minf', 'und', '1 = 2', '2*m + 3*kg', 'sqrt(-1)', 'log(0)', '{}', '1.0e400']))
        E[params] = 'parameters = [%s]' % ', '.join(lst); return E, o[0], cls
    if cls == 'setting': E.append(r.choice(['gravty = [0, 0, -1]', 'parameter = [a = 1]', '3 = 4', '"gravity" = [0, 0, 1]', 'gravity : 3', 'speed = []'])); return E, '', cls
    if cls == 'setting_twice':
        s = [x for x in E[1:] if opt(x)]
        if not s: return None
        E.append(r.choice(s)); return E, '', cls
    if cls == 'setting_value':
        n = r.choice(['gravity', 'baumgarte', 'speeds', 'parameters']); E = [x for x in E if not x.startswith(n + ' ') and not x.startswith(n + '=')]
        E.append('%s = %s' % (n, r.choice(BAD))); return E, n, cls
    if cls == 'garbage': E.insert(k, r.choice(['3', '"link"', 'zzz', 'foo(bar)', '[3]', 'link', 'link()', '%i', 'matrix([1])', 'true', 'revolute(A)', '{}', 'a < b', '-link(a, mass = 1)', 'link(a, mass = 1)[2]', 'a + b', "'link"])); return E, '', cls
    if not e: return None
    w, a = e; o = [i for i, x in enumerate(a) if opt(x)]
    if cls == 'misspell' and o: i = r.choice(o); n, v = opt(a[i]); a[i] = r.choice([n[:-1], n + 'x', n[0] + n[2:] if len(n) > 2 else n + 'y', n.upper()]) + ' = ' + v; return done(k, w, a)
    if cls == 'drop_option':
        req = {'link': ['mass'], 'revolute': ['axis'], 'prismatic': ['axis'], 'helical': ['axis', 'pitch'], 'universal': ['axis', 'second_axis'], 'planar': ['axis'], 'cylindrical': ['axis'], 'force': ['vector'], 'torque': ['vector'], 'spring': ['stiffness', 'joint'], 'damper': ['damping', 'joint'], 'rolling': ['radius', 'normal', 'axis'], 'dc_motor': ['joint']}.get(w, [])
        c = [i for i in o if opt(a[i])[0] in req]
        if c: a.pop(r.choice(c)); return done(k, w, a)
    if cls == 'twice' and o: i = r.choice(o); a.append(a[i]); return done(k, w, a)
    if cls == 'value' and o: i = r.choice(o); n, v = opt(a[i]); b = r.choice(BAD)
    if cls == 'value' and o and not (n in ('motion', 'cut') and b == 'false'): a[i] = n + ' = ' + b; return done(k, w, a, a[0])
    if cls == 'unknown_link' and w in JOINTS: i = r.choice([1, 2]); a[i] = r.choice(['nolink', '"ground"', '3', '[ground]', 'A', 'Ground', '%pi']); return done(k, w, a)
    if cls == 'self' and w in JOINTS: a[1] = a[2]; return done(k, w, a)
    if cls == 'dup_name':
        c = [el(x)[1][0] for i, x in enumerate(E) if el(x) and i != k]
        if c: a[0] = r.choice(c); return done(k, w, a)
    if cls == 'bad_name': a[0] = r.choice(['"a b"', '3', '[a]', 'a + b', '%pi', 'ground', '"x\\ny"', 'inf', '"../x"', 'f(x)', 'a[1]', '-a', '"é"', '%i', "''a", '?car', '$', 'true', 'false']) ; return (done(k, w, a, '') if a[0] != '$' else None)
    if cls == 'word': return done(k, r.choice([w[:-1], w + 's', w.upper(), 'foo', w[1:]]), a, '')
    if cls == 'drop_link' and w == 'link': E.pop(k); return E, a[0], cls
    if cls == 'drop_joint' and w in JOINTS and 'cut = true' not in t and ('coordinate' in t or 'axis' in t): E.pop(k); return E, '', cls
    if cls == 'extra_arg': a.insert(len(a) - len(o), r.choice(['extra', '3', '"x"', '[1]'])); return done(k, w, a)
    if cls == 'missing_arg' and w in JOINTS: a.pop(r.choice([1, 2])); return done(k, w, a)
    if cls == 'zero_axis':
        c = [i for i in o if opt(a[i])[0] in ('axis', 'second_axis', 'normal')]
        if c: i = r.choice(c); a[i] = opt(a[i])[0] + ' = ' + r.choice(['[0, 0, 0]', '[1, 0]', 'w', '[1, 0, 0, 0]', '[a, b, c]', '5', '"z"', '[0, 0, %i]', 'Z', '-z', '[0, 0, inf]']); return done(k, w, a)
    if cls == 'inertia' and w == 'link':
        a = [x for x in a if not x.startswith('inertia')]; a.append('inertia = ' + r.choice(['[-1, 1, 1]', '[1, 1]', '[1, 1, 1, 5, 5, 5]', 'matrix([1, 2, 0], [0, 1, 0], [0, 0, 1])', 'matrix([1, 2], [2, 1])', '3', '[1, 1, 1, 0]', '[%i, 1, 1]', '[[1, 0, 0], [0, 1, 0]]', '[1, 1, 1, 0, 0, 0, 0]', '["a", 1, 1]', '[1, 1, inf]'])); return done(k, w, a)
    if cls == 'rotation' and w in JOINTS:
        a = [x for x in a if not x.startswith('rotation')]; a.append('rotation = ' + r.choice(['matrix([1, 0, 0], [0, 1, 0], [0, 0, -1])', 'matrix([2, 0, 0], [0, 1, 0], [0, 0, 1])', '3', '[z]', '[z, 1, 2]', '[w, 1]', '[[z, 1], x]', 'z', '[[0, 0, 0], 1]', '[z, "a"]', 'matrix([1, 0], [0, 1])', '[z, [1]]', '[z, %i]', '[[z, 1], [x, inf]]', '[z, sqrt(-2)]'])); return done(k, w, a)
    if cls == 'output' and w == 'output' and len(a) > 1: a[1] = r.choice(['reaction(nojoint)', 'reaction()', 'specific_force(a)', 'zzz', 'foo(q1)', '"x"', '[]', 'reaction(A, B, C)', '1 = 2', 'inf', 'sin', '%i*t', 'max(t, 1)', 'floor(t)', 'if t > 1 then 2 else 3']); return done(k, w, a)
    return None


def mutants(seed, count):
    """[class, element that an error must name, text of the scene] of `count` mutants"""
    r = random.Random(seed); cases = []
    files = sorted(glob.glob(ROOT + '/examples/*/*.mac') + glob.glob(ROOT + '/tests/scenes/*.mac'))
    sources = [x for x in map(scene_of, files) if x]
    while len(cases) < count:
        m = mutate(r, r.choice(sources))
        named = '' if m and m[2] == 'bad_name' else m and m[1]   # what is no name is shown as Maxima writes it
        if m: cases.append([m[2], named, 'scene : gsmbp_scene(%s)$' % ',\n  '.join(m[0])])
    return cases
