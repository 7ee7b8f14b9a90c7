"""A twin beside its scene: the same values of every routine at states that are the same."""
import random
import numpy as np
from routines import called, named, names
from states import tangents

# what a difference may be, where not 1e-9, relative to the largest number beside it
LIMITS = {'JAC along': 1e-6, 'run': 1e-6}
ENERGIES = ['kinetic', 'potential', 'stored', 'power in', 'power lost']


class Beside:
    """one: the code of the scene, two: that of its twin; told: the map between them"""

    def __init__(self, builder, one, two, told):
        self.builder, self.one, self.two, self.told, self.worst = builder, one, two, told, {}
        self.offset = None
        if sorted(map(told.renamed, names(one, 'inputs'))) != sorted(names(two, 'inputs')):
            raise ValueError('inputs: %s, %s' % (names(one, 'inputs'), names(two, 'inputs')))

    def note(self, what, error):
        self.worst[what] = max(self.worst.get(what, 0.), error) if error == error else np.inf

    def at(self, t, x, v):
        """both at one state"""
        self.x, self.t = x, t
        one = {'T': t, 'X': list(x.values()), 'V': list(v.values())}
        new, v = self.told.forth(x), {self.told.renamed(n): a for n, a in v.items()}
        two = {'T': t, 'X': [new[n] for n in names(self.two, 'states')],
               'V': [v[n] for n in names(self.two, 'inputs')]}
        self.closed(two)
        self.rates(*self.both('rhs', one, two))
        for word, compare in (('out', self.outputs), ('ene', self.energies), ('evt', self.events),
                              ('jac', self.jacobians), ('rhp', self.by_parameter)):
            if self.one.has(word) and self.two.has(word):
                compare(*self.both(word, one, two))
        if self.one.has('inv'):
            self.efforts(one, two)

    def both(self, word, one, two):
        return (called(code, word, {**given, 'MODE': modes(code, given['V'])})
                for code, given in ((self.one, one), (self.two, two)))

    def close(self, what, found, wanted, scale):
        found, wanted = np.asarray(found, float), np.asarray(wanted, float)
        size = np.maximum(np.abs(wanted), scale)
        self.note(what, float(np.max(np.abs(found - wanted)/size)) if found.size else 0.)

    def closed(self, two):
        """the mapped state is on the constraints of the twin"""
        if self.two.has('prj'):
            done = called(self.two, 'prj', two)
            self.close('closed', done['X'], two['X'], 1.)

    def rates(self, one, two):
        if one['INFO'] != two['INFO']:
            self.note('RHS INFO', np.inf)
        self.dependent = one['INFO'] == 2
        if one['INFO'] not in (0, 2):
            return
        wanted = self.told.forth(self.x, named(self.one, 'states', one['XD']))
        found = named(self.two, 'states', two['XD'])
        speeds = set(names(self.two, 'speeds'))
        most = max([abs(wanted[n]) for n in speeds] + [1.])
        for n in wanted:
            self.close('RHS', found[n], wanted[n], most if n in speeds else 1.)

    def outputs(self, one, two):
        one, two = (named(c, 'outputs', d['Y']) for c, d in ((self.one, one), (self.two, two)))
        loose = set(self.one.js['indeterminate_outputs'] + self.two.js['indeterminate_outputs'])
        reactions = {o.name: o.options['rest_'][0][9:-1] for o in self.builder.scene.of('output')
                     if o.options['rest_'][0].startswith('reaction')}
        wanted = {}
        for n in {n.split('.')[0] for n in one}:
            parts = {k.partition('.')[2]: a for k, a in one.items() if k.split('.')[0] == n}
            if n not in reactions:
                wanted.update({self.told.renamed(k): a for k, a in one.items()
                               if k.split('.')[0] == n})
            elif not any(k.split('.')[0] in (n, self.told.renamed(n)) for k in loose):
                wanted.update(self.told.output(n, reactions[n], parts))
        scale = max([1.] + [abs(a) for a in wanted.values() if np.isfinite(a)])
        for n, a in wanted.items():
            self.close('OUT', two.get(n, 0.), a, scale)

    def energies(self, one, two):
        one, two = one['E'].copy(), two['E'].copy()
        if self.offset is None:
            self.offset = two[1] - one[1]
        two[1] -= self.offset
        scale = max(1., np.max(np.abs(one)), abs(self.offset))
        for k, word in enumerate(ENERGIES):
            self.close('ENE ' + word, two[k], one[k], scale)

    def events(self, one, two):
        of = lambda code, d: by_name(code.js['events'], d['GV'])
        wanted = {self.told.renamed(n): a for n, a in of(self.one, one).items()}
        found = of(self.two, two)
        for n in wanted:
            self.close('EVT', found[n], wanted[n], max(1., np.max(np.abs(wanted[n]))))

    def jacobians(self, one, two):
        """A, B; where rows of constraints depend on each other or are others, along them only"""
        if one['INFO'] or two['INFO'] or self.told.balls:
            return
        x, mapped = np.array(list(self.x.values())), self.mapped
        if self.dependent or self.told.other_rows:
            tried = tangents(self.one, self.t, x, random.Random(1)) if self.one.has('prj') else []
            for d in tried:
                wanted = mapped(one['A'] @ d)
                self.close('JAC along', two['A'] @ mapped(d), wanted, self.size(one['A']))
            return
        wanted = np.array([mapped(column) for column in one['A'].T])
        found = np.array([two['A'] @ mapped(d) for d in np.eye(len(x))])
        self.close('JAC A', found, wanted, self.size(one['A']))
        for k, n in enumerate(names(self.one, 'inputs')):
            column = names(self.two, 'inputs').index(self.told.renamed(n))
            self.close('JAC B', two['B'][:, column], mapped(one['B'][:, k]), self.size(one['B']))

    def by_parameter(self, one, two):
        """rates by a parameter"""
        if one['INFO'] or two['INFO'] or self.told.balls or self.dependent:
            return
        wanted = self.mapped(one['P'][:, 0])
        self.close('RHP', two['P'][:, 0], wanted, self.size(wanted))

    def mapped(self, change):
        """a change of the state in the order of the twin"""
        new = self.told.forth(self.x, named(self.one, 'states', change))
        return np.array([new[n] for n in names(self.two, 'states')])

    def size(self, A):
        return max(1., np.max(np.abs(A)))

    def efforts(self, one, two):
        """inverse dynamics of the tree at an acceleration"""
        if self.told.balls:
            return
        q, u = names(self.one, 'coordinates'), names(self.one, 'speeds')
        rates = {n: np.cos(k + 1.) for k, n in enumerate(u)}
        new = self.told.forth({**self.x, **rates}, {**self.x, **rates})
        at = lambda code, given, rates: {
            **given, 'Q': given['X'][:code.d['nq']],
            'U': given['X'][code.d['nq']:code.d['nq'] + code.d['nu']],
            'UD': [rates[n] for n in names(code, 'speeds')]}
        a = called(self.one, 'inv', at(self.one, one, rates))['TAU']
        b = called(self.two, 'inv', at(self.two, two, new))['TAU']
        wanted = {self.told.renamed(n): self.told.signs.get(n, 1)*e for n, e in zip(u, a)}
        self.close('INV', b, [wanted[n] for n in names(self.two, 'speeds')],
                   max(1., np.max(np.abs(a), initial=0)))


def modes(code, v):
    """of the events, as the inputs say"""
    return [int(v[e['input'] - 1]) if e['input'] else 0 for e in code.js['events']]


def by_name(rows, values):
    found = {}
    for row, value in zip(rows, values):
        found.setdefault(row['name'], []).append(value)
    return found
