"""Values of parameters: what the scene requires of them, and where it starts with them.

The routines CHK and INI of the scene compute both.
"""
import ctypes

import numpy as np

from ._library import LIBRARY, NAME, SIZES, TABLE, at
from ._tables import REFUSALS

RULES = TABLE.get('rules') or []
MASSES = TABLE.get('masses') or []
MADE = np.array(TABLE.get('starts') or [], int) - 1   # states that are made of parameters
EMITTED = [row['name'] for row in TABLE['subroutines']]


def need_routines():
    """Refuse other values of parameters where CHK or INI was not emitted."""
    for part, suffix in (('rules', 'CHK'), ('starts', 'INI')):
        if TABLE.get(part) and not has(suffix):
            raise AttributeError('%s: %s' % (NAME, REFUSALS.unchecked % suffix))


def has(suffix):
    return '%s_%s' % (NAME.upper(), suffix) in EMITTED


def checked(values):
    """[the values of the rules, the sentence of the first one that is broken or None]."""
    results, first = np.zeros(max(1, len(RULES))), ctypes.c_int(0)
    if not RULES or not has('CHK'):
        return results, None
    info = LIBRARY.gs_loop_chk(at(values), at(results), ctypes.byref(first))
    if first.value == 0:
        return results, None
    rule = RULES[first.value - 1]
    text = rule['broken'] if info == 1 else REFUSALS.not_real % rule['place']
    return results, '%s; found: %s' % (text, ', '.join(
        '%s = %g' % (row['name'], value) for name in rule['parameters']
        for row, value in zip(TABLE['parameters'], values) if row['name'] == name))


def negative(results, given):
    """[place, value] of each rule of a given parameter that calls for a warning."""
    return [(rule['place'], value) for rule, value in zip(RULES, results)
            if rule['rule'] == 'rather_nonnegative' and value < 0
            and set(rule['parameters']) & set(given)]


def start(values):
    """The states where the scene states that it starts."""
    x = np.array(TABLE['initial'], float)
    if len(MADE) and has('INI'):
        made, masses = np.zeros(SIZES['nx']), np.zeros(len(MASSES) + 1)
        slopes = np.zeros(1 + sum(len(row['parameters']) for row in MASSES))
        LIBRARY.gs_loop_ini(at(values), at(made), at(masses), at(slopes))
        good = MADE[np.isfinite(made[MADE])]
        x[good] = made[good]
    return x
