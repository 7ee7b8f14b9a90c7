"""The named quantities of a load case, a number for each of its times, with derivatives."""
import re

import numpy as np

from ._arguments import nearest
from ._library import NAME, ROUTINES, SIZES, TABLE

NQ, NU, NLAM = (SIZES[k] for k in ('nq', 'nu', 'nlam'))
MARGIN = re.compile(r'state_margin(\d+)$')
EXTRA = re.compile(r'decay$|(frequency|damping)\d+$|end_time$')
OF_KIND = {'run': ('end_time',), 'rest': ('frequency1', 'damping1', 'decay')}


def name_table(model):
    """{name: (field of a result, row)}, as gsmbp_names of Octave has them."""
    rows = [(name, field, k) for field, names in (
        ('x', model.states), ('v', model.inputs), ('y', model.outputs))
        for k, name in enumerate(names)]
    if 'pnt' in ROUTINES:
        rows += [('%s.%s' % (row['name'], axis), 'points', 3 * k + i)
                 for k, row in enumerate(TABLE.get('points') or []) if row['link'] != 'ground'
                 for i, axis in enumerate('xyz')]
    moved = [int(k) - 1 for k in np.atleast_1d(TABLE.get('actuated') or [])] if NLAM else range(NU)
    names = model.coordinates if NLAM or NQ == NU else model.speeds
    rows += [('effort.' + names[k], 'tau', i) for i, k in enumerate(moved)]
    rows += [(name, 'lam', k) for k, name in enumerate(model.multipliers)]
    rows += [('margin%d' % (k + 1), 'margins', k)
             for k in range(len(TABLE.get('margins') or []))]
    return _distinct(rows)


def _distinct(rows):
    """A name that is there already has its kind after it."""
    kinds = {'x': 'state', 'v': 'input', 'y': 'output', 'points': 'point', 'tau': 'effort',
             'lam': 'multiplier', 'margins': 'margin'}
    found = {}
    for name, field, k in rows:
        if name in found:
            name = base = '%s (%s)' % (name, kinds[field])
            n = 1
            while name in found:
                n += 1
                name = '%s %d' % (base, n)
        found[name] = field, k
    return found


def parts_of(name):
    """The factors of a product, less "error."."""
    return [part.strip() for part in name.split('*')]


def plain(name):
    return name[6:] if name.startswith('error.') else name


def read_fields(who, cases, rows, table):
    """{case: fields of its result that goals and demands read}; unknown names are refused."""
    fields = {case.name: set() for case in cases}
    for row in rows:
        for k in row.cases:
            for name in map(plain, parts_of(row.name)):
                if name in table:
                    fields[cases[k].name].add(table[name][0])
                elif EXTRA.match(name):
                    fields[cases[k].name].add('extra')
                elif MARGIN.match(name):
                    fields[cases[k].name].add('state_margins')
                else:
                    known = [*table, *(n for c in cases for n in OF_KIND.get(c.kind, ()))]
                    raise ValueError('%s: case %s: unknown quantity %r%s' % (
                        who, cases[k].name, name, nearest(name, known)))
    return fields


class Series:
    """The quantities of one case: its result R with the derivatives D by n variables."""

    def __init__(self, who, case, R, D, table, n):
        self.who, self.case, self.R, self.D, self.table, self.n = who, case, R, D, table, n

    def __call__(self, name):
        """y (nt,), Y (nt, n) of a name or a product."""
        parts = parts_of(name)
        y, Y = self.one(parts[0])
        for part in parts[1:]:
            b, B = self.one(part)
            y, Y = y * b, Y * b[:, None] + y[:, None] * B
        if not np.isfinite(y).all():
            raise ValueError('%s: case %s: %s is not known (NaN)' % (
                self.who, self.case.name, name))
        return y, Y

    def one(self, name):
        if name.startswith('error.'):
            y, Y = self.one(name[6:])
            return y - self.target(name[6:], self.R.t), Y - self.moved_target(name[6:])
        if name in self.R.extra:
            Y = self.D.get('extra', {}).get(name, np.zeros(self.n))
            nt = len(self.R.t)
            return np.full(nt, self.R.extra[name]), np.tile(Y, (nt, 1))
        field, k = self.place(name)
        y = getattr(self.R, field)[k]
        Y = self.D[field][k] if field in self.D else np.zeros((len(y), self.n))
        return np.array(y, float), np.array(Y, float)

    def place(self, name):
        """The field and the row of a name."""
        match = MARGIN.match(name)
        if match:
            rows = getattr(self.R, 'state_margins', np.zeros((0, 0)))
            if not 1 <= int(match.group(1)) <= len(rows):
                raise ValueError('%s: case %s: %s: expected the number of a margin, 1 to %d' % (
                    self.who, self.case.name, name, len(TABLE.get('state_margins') or [])))
            return 'state_margins', int(match.group(1)) - 1
        if re.match(r'(frequency|damping)\d+$', name):
            raise ValueError('%s: case %s: %s: found %d oscillations about the equilibrium' % (
                self.who, self.case.name, name,
                sum(key.startswith('freq') for key in self.R.extra)))
        field, k = self.table.get(name, ('', 0))
        rows = getattr(self.R, field, None) if field else None
        if rows is None or len(rows) <= k:
            raise ValueError('%s: case %s (%s): there is no %s in its result' % (
                self.who, self.case.name, self.case.kind, name))
        return field, k

    def target(self, name, t):
        """What a quantity should be at the times."""
        if name not in self.case.target:
            raise ValueError('%s: case %s: error.%s needs what %s should be: option target, '
                             '{"%s": ...}' % (self.who, self.case.name, name, name, name))
        v = self.case.target[name]
        v = np.asarray(v(t) if callable(v) else v, float).ravel()
        if v.size not in (1, len(t)) or not np.isfinite(v).all():
            raise ValueError('%s: case %s: target of %s: expected 1 or %d finite numbers; found %r'
                             % (self.who, self.case.name, name, len(t), v))
        return v

    def moved_target(self, name):
        """How the target changes where an event moves the last time."""
        given, t = self.case.target[name], self.R.t
        if not callable(given) or not np.any(self.D.get('t', 0)):
            return np.zeros((len(t), self.n))
        h = 1e-3 * (t[-1] - t[0])
        at = [self.target(name, t + s * h) for s in (-2, -1, 1, 2)]
        slope = (8 * (at[2] - at[1]) - at[3] + at[0]) / (12 * h)
        return slope[:, None] * self.D['t']
