"""What is made of the table of a scene (table.json) when its module is built.

loops(table): C source, a function for each subroutine that calls it for many states;
stubs(table): the methods of Model with their types, for type checkers and editors.
"""
import keyword


def write(path, lines):
    with open(path, 'w', encoding='utf-8') as out:
        out.write('\n'.join(lines) + '\n')


def routines(table):
    """[(name, row)] of the subroutines that Python calls: no batches of the Fortran's form."""
    cut = len(table['name']) + 1
    every = [(row['name'][cut:].lower(), row) for row in table['subroutines']]
    return [(name, row) for name, row in every
            if not name.endswith(('_v', '_w')) and name not in ('par', 'pre', 'chk', 'ini')]


def arguments(row):
    """[(name, whole, intent, sizes, meaning)] as they stand in the Fortran."""
    found = []
    for name, shape, sizes, meaning in zip(row['arguments'], row['shapes'], row['sizes'],
                                           row['meanings']):
        whole, _, rest = shape.rpartition(' ')
        found.append((name.lower(), whole == 'integer', rest.partition('(')[0], sizes, meaning))
    return found


def is_leading(argument, row):
    """Is it the leading dimension of matrices, which the loops know?"""
    name, whole, intent = argument[:3]
    return whole and intent == 'in' and any('(%s,' % name.upper() in s for s in row['shapes'])


def own(row):
    """The arguments that Python hands over: no constants, leading dimensions, INFO."""
    return [a for a in arguments(row)
            if a[0] not in ('cst', 'info') and not is_leading(a, row)]


def count(sizes):
    n = 1
    for s in sizes:
        n *= s
    return n


# ------------------------------------------------------------------------------------ loops in C

def loops(table):
    name = table['name'].lower()
    lines = ['#include <string.h>', '#include "%s.h"' % table['name'], '#include "host/start.h"',
             '#include "loop.h"', '',
             'const gs_scene *gs_loop_scene (void) { return &%s_scene; }' % name,
             'extern const gs_description %s_about;' % name,
             'const gs_description *gs_loop_about (void) { return &%s_about; }' % name,
             'void gs_loop_par (double *p) { %s_par ((%s_parameters *)p); }' % (name, name),
             'int gs_loop_pre (const double *p, double *c)',
             '{ return %s_pre ((const %s_parameters *)p, c); }' % (name, name)]
    emitted = [row['name'].lower() for row in table['subroutines']]
    if name + '_chk' in emitted:
        lines += ['int gs_loop_chk (const double *p, double *r, int *k)',
                  '{ return %s_chk ((const %s_parameters *)p, r, k); }' % (name, name)]
    if name + '_ini' in emitted:
        lines += ['void gs_loop_ini (const double *p, double *x, double *w, double *d)',
                  '{ %s_ini ((const %s_parameters *)p, x, w, d); }' % (name, name)]
    for short, row in routines(table):
        lines += [''] + loop(name, short, row)
    return lines


def loop(scene, short, row):
    """One subroutine at k states; argument i of state j begins at a[i] + j*s[i], e[i] apart."""
    room, gets, texts = [], [], {}
    for i, (name, whole, intent, sizes, _) in enumerate(own(row)):
        kind = 'int' if whole else 'double'
        if intent == 'in' and len(sizes) == 1:
            room.append('  %s r%d[GS_TILE * %d];' % (kind, i, max(1, sizes[0])))
            gets += ['      ptrdiff_t s%d = s[%d];' % (i, i),
                     '      const char *a%d = gs_tile_%s (a[%d] + l * s%d, e[%d], &s%d, '
                     '%d, m, r%d);' % (i, kind, i, i, i, i, sizes[0], i)]
            texts[name] = '(const %s *)(a%d + j * s%d)' % (kind, i, i)
        else:
            texts[name] = '%s(%s *)(a[%d] + (l + j) * s[%d])' % (
                '*' if intent == 'in' and sizes == [] else '', kind, i, i)
    call = '%s_%s (%s)' % (scene, short, ', '.join(spoken(row, texts)))
    checked = 'INFO' in row['arguments']
    return (['ptrdiff_t',
             '%s_%s_k (ptrdiff_t k, char *const *a, const ptrdiff_t *e, const ptrdiff_t *s,'
             % (scene, short),
             '    const double *cst, int *info)', '{', '  ptrdiff_t bad = 0;'] + room
            + ['  (void)a, (void)e, (void)s, (void)cst, (void)info;',
               '  for (ptrdiff_t l = 0; l < k; l += GS_TILE)', '    {',
               '      const int m = k - l < GS_TILE ? (int)(k - l) : GS_TILE;'] + gets
            + ['      for (int j = 0; j < m; j++)', '        {']
            + (['          info[l + j] = %s;' % call,
                '          if (info[l + j] != 0 && bad == 0)', '            bad = l + j + 1;']
               if checked else ['          %s;' % call])
            + ['        }', '    }', '  return bad;', '}'])


def spoken(row, texts):
    """The arguments of a call as text, those by value first looked up in texts."""
    rows = {}
    for (name, _, _, sizes, _), shape in zip(arguments(row), row['shapes']):
        if ',*)' in shape:
            rows[shape[shape.index('(') + 1:shape.index(',')].lower()] = max(1, sizes[0])
    spoken_ = []
    for name, *_ in arguments(row):
        if name == 'cst':
            spoken_.append('cst')
        elif name != 'info':
            spoken_.append(texts.get(name, str(rows.get(name))))
    return spoken_


# ------------------------------------------------------------------------------------ stubs

def stubs(table):
    lines = ['from typing import Any, NamedTuple', '', 'import numpy as np',
             'from numpy.typing import ArrayLike, NDArray', '',
             'Real = NDArray[np.float64]', '']
    methods = []
    for short, row in routines(table):
        results = [a for a in own(row) if a[2] in ('out', 'inout')]
        kind = 'Real'
        if len(results) > 1:
            kind = short.upper() + '_results'
            lines += ['class %s(NamedTuple):' % kind]
            lines += ['    %s: %s' % (python_name(a[0]), type_of(a)) for a in results] + ['']
        elif results:
            kind = type_of(results[0])
        methods += method(short, row, kind)
    return lines + ['class Routines:'] + (methods or ['    ...'])


def method(short, row, kind):
    given = [a for a in own(row) if a[2] in ('in', 'inout')]
    named = ''.join(', %s: ArrayLike%s' % (python_name(a[0]), ' = ...' if a[0] == 'v' else '')
                    for a in optional_last(given))
    text = '    """%s' % row['purpose'].replace('\\', '\\\\')
    return ['    def %s(self%s) -> %s:' % (short, named, kind), '    ' + text]\
        + ['', *('        %s: %s' % (python_name(a[0]), says(a)) for a in own(row)), '        """']


def optional_last(given):
    """Inputs v may be left out (then they are zero), so they stand behind the others."""
    return [a for a in given if a[0] != 'v'] + [a for a in given if a[0] == 'v']


def python_name(name):
    return name + '_' if keyword.iskeyword(name) else name


def type_of(argument):
    return 'NDArray[np.int32]' if argument[1] else 'Real'


def shape_text(sizes):
    if not sizes:
        return 'number'
    return '(%s)' % ', '.join(map(str, sizes))


def says(argument):
    name, whole, intent, sizes, meaning = argument
    return '%s%s, %s' % ('whole ' if whole else '', shape_text(sizes),
                         meaning.replace('\\', '\\\\'))
