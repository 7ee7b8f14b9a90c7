"""What tests of modules print: `ok WHAT` or `not ok WHAT`."""
import numpy as np


def holds(what, true):
    print('%sok %s' % ('' if true else 'not ', what))


def close(what, found, wanted, tolerance):
    off = np.abs(np.asarray(found) - np.asarray(wanted)).max()
    holds('%s: off by %.1e, at most %.1e' % (what, off, tolerance), off <= tolerance)


def refuses(what, kind, words, function, *values, **named):
    try:
        function(*values, **named)
        found = 'nothing'
    except Exception as error:
        found = '%s: %s' % (type(error).__name__, error)
        if isinstance(error, kind) and all(w in str(error) for w in words):
            return holds('%s is refused' % what, True)
    return holds('%s is refused by %s, found %s' % (what, kind, found), False)
