"""Designs: values of free variables that make a goal small and meet demands
(host/optimize/optimize.h)."""
import collections
import ctypes
import math
import os
import warnings

import numpy as np

from . import _checks, _run
from ._arguments import nearest
from ._collocate import ONE_AT_A_TIME
from ._design import ALONE, arguments_of, read_cases, read_free, read_rows
from ._design_cases import Cases
from ._design_series import Series, name_table, read_fields
from ._design_structures import (Active, CHOICES, Design, End, EVALUATE, Found, Free, Options, Row,
                                 SOLVERS, Series as Numbers, Times, Values, WORDS)
from ._ends import Ends
from ._library import Error, HERE, LIBRARY, NAME, SIZES, at
from ._tables import REFUSALS, check, is_number

Optimum = collections.namedtuple(
    'Optimum', 'values J model results active solved ended limit violation optimality iterations '
    'evaluations solver starts stopped derivatives conflict info choices report')
Optimum.__doc__ = """What optimize gives: values by name; J: the goal; model: with these values;
results of the cases by name; active: bounds and demands that hold the goal back, dicts of text,
kind, value, bound, multiplier: how much the goal falls for each unit that it is loosened, of an
equation how much it rises for each unit that its bound rises; solved, ended: why it ended; limit:
one was reached; violation, optimality: what is left of the conditions of an optimum, beside their
sizes; iterations (None by NLopt), evaluations; solver; starts: all ends; stopped: "timeout" or "";
derivatives: how they were found; conflict: demands that contradict each other; info: 0 solved, 1 a
limit, 2 a contradiction, 3 it ended elsewhere; choices: how lists were searched; report: a text."""


def optimize(self, free, goal=None, demands=None, cases=None, *, solver='auto', starts=1, seed=1,
             tolerance=1e-10, iterations=500, evaluations=1000, seconds=math.inf, timeout=0.0,
             choices='auto', nodes=1000):
    """The best design: values of free variables that make a goal small and meet demands in load
    cases, as gsmbp_optimize of Octave finds them.

    free: a row for each variable, (name, start, (low, high)) or (name, start, {a, b, ...}), one of
    a set; a name is that of a parameter, of a state (its start in runs) or one of your own.
    goal: rows (word, name) or (word, name, factor), which are added; demands: rows (word, name,
    relation, bound), the relation "<", ">" or "="; the name of a case at the end: of that case
    alone. Words: start, end, mean, integral, square, rms, drawn, peak, max, min, each, settling;
    value of a variable, mass of links ("all", or "arm, fore"). Names: states, inputs, outputs,
    efforts ("effort.q"), multipliers, points ("tip.x"), products of them, "error.q": less its
    target, "end_time", "state_margin2", "frequency1", "damping1", "decay". A row may be a function
    (f,), (f, factor), (f, relation, bound) of the values (a dict), or of these and the results of
    the cases by name; it may give its derivatives by the variables as second result.
    cases: rows ("run", times, x0, {options of simulate}), ("inverse", motion, times, {...}),
    ("rest", x, v, {options of trim}), ("positions", names, values, {"guess": q}); more options:
    name, target (a dict: a number, one for each time, a Piecewise or a function of the time), band
    (0.02, of settling from a value other than 0). An argument may be a function of one argument,
    the values. Derivatives of runs, inverse dynamics and positions are exact in a scene with the
    request sensitivity, else differences of order 4.

    solver: "auto", "slsqp", "mma", "cobyla" (NLopt) or "ipopt"; starts: how many places to start
    from, random within the bounds (seed), or a matrix, a row of values for each further start;
    tolerance; iterations, evaluations, seconds: limits of each start; timeout [s]: of all, looked
    at between evaluations, 0: none; choices: "all" combinations of sets, "branch" (and bound) or
    "auto"; nodes: a limit of the problems of these. Result: an Optimum. Demands that contradict
    each other are an Error with the Optimum in results; that it is no solution is a warning.
    """
    who = NAME + '.optimize'
    search = _Search(who, self, free, goal, demands, cases)
    options = _options(who, search, solver, starts, seed, tolerance, iterations, evaluations,
                       seconds, timeout, choices, nodes)
    found = Found()
    try:
        search.solve(options, found)
        r = _result(who, search, found)
    finally:
        LIBRARY.gs_design_free(found.address())
    if r.info == 2:
        raise Error('%s: %s' % (who, r.ended), 2, r)
    if r.info:
        warnings.warn('%s: no optimum was found: %s' % (who, r.ended), _run.RunWarning,
                      stacklevel=3)
    return r


def _solver(name):
    """A solver in C, which setup.py makes where it finds it; None: it is not there."""
    path = os.path.join(HERE, '_%s.so' % name)
    if not os.path.exists(path):
        return None
    try:
        return ctypes.cast(getattr(ctypes.CDLL(path), 'gs_' + name), ctypes.c_void_p)
    except OSError as problem:
        raise ImportError('%s: %s: %s' % (NAME, getattr(REFUSALS, 'no_' + name), problem)) from None


def _options(who, search, solver, starts, seed, tolerance, iterations, evaluations, seconds,
             timeout, choices, nodes):
    _run._word(who, 'solver', solver, SOLVERS)
    _run._word(who, 'choices', choices, CHOICES)
    check(who, 'tolerance', tolerance, 'tolerance')
    check(who, 'timeout', timeout, 'nonnegative')
    for name, value, least in (('iterations', iterations, 0), ('evaluations', evaluations, 0),
                               ('seed', seed, 0), ('nodes', nodes, 1)):
        if not (is_number(value) and least <= value <= 2e9 and value == int(value)):
            raise ValueError('%s: %s: expected a whole number from %d on; found %r' % (
                who, name, least, value))
    if not (isinstance(seconds, (int, float)) and seconds > 0):
        raise ValueError('%s: seconds: expected a number above 0; found %r' % (who, seconds))
    places = _places(who, search.free, starts, seed)
    options = Options(
        solver=SOLVERS.index(solver), choices=CHOICES.index(choices), nodes=int(nodes),
        iterations=int(iterations), nstarts=places.shape[1], tolerance=tolerance,
        evaluations=evaluations, seconds=seconds, timeout=timeout, ipopt=_solver('ipopt'),
        nlopt=_solver('nlopt'))
    options.put('starts', places if places.size else [0])
    return options


def _places(who, free, starts, seed):
    """Further starts, a column each: given, or random within the bounds."""
    low, high = (np.array([getattr(one, k) for one in free]) for k in ('low', 'high'))
    if np.ndim(starts) == 0:
        if not (is_number(starts) and starts >= 1 and starts == int(starts)):
            raise ValueError('%s: starts: expected a whole number, at least 1; found %r' % (
                who, starts))
        for one in free:
            if starts > 1 and not math.isfinite(one.high - one.low):
                raise ValueError('%s: starts: expected finite bounds of %s, between which to start'
                                 % (who, one.name))
        chance = np.random.default_rng(int(seed)).random((int(starts) - 1, len(free)))
        return (low + (high - low) * chance).T if starts > 1 else np.zeros((len(free), 0))
    places = np.atleast_2d(np.asarray(starts, float))
    if places.ndim != 2 or places.shape[1] != len(free):
        raise ValueError('%s: starts: expected a row for each further start, %d numbers (%s); '
                         'found the shape %s' % (who, len(free),
                                                 ', '.join(one.name for one in free), places.shape))
    for k, i in zip(*np.nonzero(~((places >= low) & (places <= high)))):
        raise ValueError('%s: starts: row %d: expected %s from %g to %g; found %g' % (
            who, k + 1, free[i].name, low[i], high[i], places[k, i]))
    return places.T


# --------------------------------------------------------------------------------- the search

class _Search:
    """The problem as the engine takes it (gs_design), and the values that it asks for."""

    def __init__(self, who, model, free, goal, demands, cases):
        self.who, self.model = who, model
        self.free = read_free(who, model, free)
        cases = read_cases(who, model, cases)
        self.goal = read_rows(who, 'goal', goal, cases, True)
        self.demands = read_rows(who, 'demands', demands, cases, False)
        self.rows = self.goal + self.demands
        self.table = name_table(model)
        fields = read_fields(who, cases, self.rows, self.table)
        self.cases = Cases(who, model, self.free, cases, fields)
        self.ends, self.problem, self.kept = Ends(), None, []
        for row in self.rows:
            if row.word in ALONE:
                self.alone(row, [one.start for one in self.free])

    def solve(self, options, found):
        design = self.design()
        with ONE_AT_A_TIME, self.ends:
            bad = LIBRARY.gs_optimize(design.address(), options.address(), found.address())
        if self.ends.failure is not None:
            raise self.ends.failure
        if bad:
            raise MemoryError(self.who)
        if found.verdict == Found.FAILED:
            raise self.problem
        if found.verdict == Found.STOPPED:
            raise Error('%s: %s' % (self.who, found.ended.decode()))
        if found.verdict:
            text = found.ended.decode()
            kind = ImportError if text in (REFUSALS.no_ipopt, REFUSALS.no_nlopt) else ValueError
            raise kind('%s: %s' % (self.who, text))

    def design(self):
        cases = self.cases.cases
        d = Design(name=NAME.encode(), nfree=len(self.free), ngoal=len(self.goal),
                   ndemands=len(self.demands), ncases=len(cases), why=self.cases.why().encode())
        d.keep('free', (Free * len(self.free))(*map(self.as_free, self.free)))
        d.keep('rows', (Row * (len(self.rows) + 1))(*map(self.as_row, self.rows)))
        d.put('bands', [case.band for case in cases] or [0])
        d.keep('evaluate', EVALUATE(self.evaluate))
        return d

    def as_free(self, one):
        values = np.array(one.choices or [0], float)
        self.kept.append(values)
        return Free(one.name.encode(), one.start, one.low, one.high, one.kind == 'own',
                    len(one.choices), values.ctypes.data)

    def as_row(self, row):
        numbers = np.array(row.cases or [0], np.intc)
        self.kept.append(numbers)
        word = WORDS.index(row.word) if row.word else len(WORDS)
        return Row(word, ord(row.relation) if row.relation else 0, len(row.cases), row.factor,
                   row.bound, numbers.ctypes.data, row.text.encode())

    # what the engine asks for

    def evaluate(self, _, p, rows, free, found):
        """What the rows read at the values p, into found; what it is called with no exception may
        leave."""
        v = found.contents
        answer = [Values.INTERRUPTED]

        def values():
            try:
                self.put(v, np.array(p[:len(self.free)]), rows[:len(self.rows)],
                         np.array(free[:len(self.free)], bool))
                answer[0] = Values.FOUND
            except (ArithmeticError, ValueError) as problem:
                self.problem = problem
                v.trouble = str(problem).encode()[:799]
                answer[0] = Values.FAILED
        if self.ends.call(values):
            return Values.INTERRUPTED
        return answer[0]

    def put(self, v, p, wanted, by):
        cases = self.cases.cases
        self.here = []   # arrays that the engine reads until the next call
        results, series = {}, {}
        rough = np.zeros(len(p), bool)
        read = {k for row, want in zip(self.rows, wanted) if want for k in row.cases}
        if any(row.function and want for row, want in zip(self.rows, wanted)):
            read = set(range(len(cases)))
        for k in sorted(read):
            R, D, differs = self.cases.run(cases[k], p, by)
            rough |= differs
            results[cases[k].name] = R
            series[k] = Series(self.who, cases[k], R, D, self.table, len(p))
            v.times[k] = Times(len(R.t), *(self.address(x) for x in (
                R.t, R.w, D.get('t'), D.get('w'))))
        for k in range(len(p)):
            v.rough[k] = int(rough[k])
        place = 0
        for row, want in zip(self.rows, wanted):
            place = self.put_row(v, place, row, want, series, results, p, by)

    def put_row(self, v, place, row, want, series, results, p, by):
        alone = row.function or row.word in ALONE
        for k in [None] if alone else row.cases:
            if want:
                y, Y = (self.single(v, row, results, p, by) if alone else series[k](row.name))
                v.series[place] = Numbers(len(y), self.address(y), self.address(Y))
            place += 1
        return place

    def address(self, a):
        """An array as the engine reads it, by columns."""
        if a is None:
            return None
        self.here.append(np.asfortranarray(a, float))
        return self.here[-1].ctypes.data

    def single(self, v, row, results, p, by):
        """A row that needs no load case by itself: its numbers, (k,), and derivatives, (k, n)."""
        if row.function is None:
            return self.alone(row, p)
        y, Y = self.called(row, results, p)
        if Y is None:
            v.functions = 1
            Y = np.zeros((len(y), len(p)))
            for k in np.flatnonzero(by):
                Y[:, k] = self.cases.slope(k, p, lambda q: {'y': self.called_at(row, q)})['y']
        if row in self.goal and len(y) != 1:
            raise ValueError('%s: goal %s: expected one number; found %d' % (
                self.who, row.text, len(y)))
        return y, Y

    def called_at(self, row, p):
        results = {}
        if arguments_of(row.function) > 1:
            results = {case.name: self.cases.run(case, p)[0] for case in self.cases.cases}
        return self.called(row, results, p)[0]

    def called(self, row, results, p):
        """What the function gives, and its derivatives or None."""
        given = (self.cases.values(p), results)[:arguments_of(row.function)]
        found, slopes = row.function(*given), None
        if isinstance(found, tuple) and len(found) == 2:
            found, slopes = found
        y = np.atleast_1d(np.asarray(found))
        if y.dtype.kind not in 'fiub' or y.ndim != 1 or not y.size or not np.isfinite(y).all():
            raise ValueError('%s: %s: expected finite numbers; found %r' % (
                self.who, row.text, found))
        if slopes is not None:
            slopes = np.atleast_2d(np.asarray(slopes, float))
            if slopes.shape != (len(y), len(p)):
                raise ValueError('%s: %s: expected derivatives of the shape (%d, %d) (by %s); '
                                 'found %s' % (self.who, row.text, len(y), len(p), ', '.join(
                                     one.name for one in self.free), slopes.shape))
        return y.astype(float), slopes

    def alone(self, row, p):
        """The value of a variable or parameter, or the mass of links."""
        names, Y = [one.name for one in self.free], np.zeros((1, len(p)))
        if row.word == 'value':
            if row.name in names:
                Y[0, names.index(row.name)] = 1
                return np.array([p[names.index(row.name)]]), Y
            if row.name in self.model.parameters:
                return np.array([self.model.parameters[row.name]]), Y
            raise ValueError('%s: value: expected a free variable or a parameter; found %r%s' % (
                self.who, row.name, nearest(row.name, names + list(self.model.parameters))))
        mass, slopes = _mass(self.who, self.cases.model_at(p), row.name)
        for k, one in enumerate(self.free):
            if one.kind == 'parameter':
                Y[0, k] = slopes.get(one.name, 0)
        return np.array([mass]), Y


def _mass(who, model, name):
    """The mass of links, and its derivatives by the parameters that it is made of."""
    rows = _checks.MASSES
    if not rows or (any(row['parameters'] for row in rows) and not _checks.has('INI')):
        raise ValueError('%s: mass: %s was derived without the masses of its links: derive it '
                         'again' % (who, NAME))
    known = [row['link'] for row in rows]
    chosen = known if name == 'all' else [part.strip() for part in name.split(',')]
    for link in chosen:
        if link not in known:
            raise ValueError('%s: mass: unknown link %r%s' % (
                who, link, nearest(link, known + ['all'])))
        if chosen.count(link) > 1:
            raise ValueError('%s: mass: expected every link once; found %s' % (who, name))
    made, masses = np.zeros(max(1, SIZES['nx'])), np.array([row['value'] for row in rows] + [0.0])
    by = np.zeros(1 + sum(len(row['parameters']) for row in rows))
    if len(by) > 1:
        LIBRARY.gs_loop_ini(at(model._values), at(made), at(masses), at(by))
    total, slopes, first = 0.0, {}, 0
    for row, value in zip(rows, masses):
        for k, parameter in enumerate(row['parameters']):
            if row['link'] in chosen:
                slopes[parameter] = slopes.get(parameter, 0) + by[first + k]
        first += len(row['parameters'])
        total += value if row['link'] in chosen else 0
    return total, slopes


# ---------------------------------------------------------------------------------- the result

def _results(cases, p, info):
    """Of the load cases at the values; where demands contradict each other, those that can be
    there."""
    found = {}
    for case in cases.cases:
        try:
            found[case.name] = cases.run(case, p)[0]
        except (ArithmeticError, ValueError) as problem:
            if info != 2:   # no goal or demand has read it, or it would have failed before
                raise type(problem)('%s; at the values found: %s' % (problem, ', '.join(
                    '%s = %.6g' % pair for pair in cases.values(p).items()))) from problem
    return found


def _result(who, search, r):
    n, cases = len(search.free), search.cases
    p = np.array(r.rows('values', n, ctypes.c_double))
    active = [{'text': one.text.decode(), 'kind': 'demand' if one.demand else 'bound',
               'value': one.value, 'bound': one.bound, 'multiplier': one.multiplier}
              for one in r.rows('active', r.nactive, Active)]
    starts = [{'values': cases.values(list((ctypes.c_double * n).from_address(one.values))),
               'J': one.J, 'solved': bool(one.solved), 'violation': one.violation,
               'ended': one.ended.decode()} for one in r.rows('ends', r.nends, End)]
    idle = [one.name for one, k in zip(search.free, r.rows('idle', n, ctypes.c_int)) if k]
    if idle:
        warnings.warn('%s: nothing depends on %s, at the start and at the end' % (
            who, ', '.join(idle)), _run.RunWarning, stacklevel=4)
    many = r.nconflict if r.info == 2 else 0
    return Optimum(
        cases.values(p), r.J, cases.model_at(p), _results(cases, p, r.info), active,
        bool(r.solved),
        r.ended.decode(), bool(r.limit), r.violation, r.optimality,
        None if r.iterations < 0 else r.iterations, r.evaluations, SOLVERS[r.solver], starts,
        'timeout' if r.stopped else '', r.derivatives.decode(),
        [search.demands[k].text for k in r.rows('conflict', many, ctypes.c_int)], r.info,
        {'how': 'branch' if r.branched else 'all', 'combinations': int(r.combinations),
         'solved': r.problems, 'limit': bool(r.choices_limit), 'open': r.open,
         'stopped': 'timeout' if r.choices_stopped else ''}, r.report.decode())
