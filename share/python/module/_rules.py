"""Values of parameters: expressions of the table, and what they must be."""
import ast
import math
import operator

import numpy as np

_BINARY = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
           ast.Div: operator.truediv, ast.Pow: operator.pow}
_FUNCTIONS = {f: getattr(math, f) for f in
              ('sqrt', 'sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'atan2', 'sinh', 'cosh', 'tanh',
               'exp', 'log')}
_FUNCTIONS.update(abs=abs, max=max, min=min, sign=lambda x: math.copysign(1.0, x) if x else 0.0)
_NAMES = {'pi': math.pi, 'e': math.e}


def value(text, **names):
    """The value of an expression in p1, p2, ..., NaN where it has none."""
    names.update((k, v) for k, v in _NAMES.items() if k not in names)
    try:
        return float(_value(ast.parse(text.replace('^', '**'), mode='eval').body, names))
    except (ZeroDivisionError, OverflowError, TypeError, ValueError):
        return math.nan


def _value(node, names):
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        return node.value
    if isinstance(node, ast.Name) and node.id in names:
        return names[node.id]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
        x = _value(node.operand, names)
        return -x if isinstance(node.op, ast.USub) else x
    if isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
        return _BINARY[type(node.op)](_value(node.left, names), _value(node.right, names))
    if isinstance(node, ast.Call) and getattr(node.func, 'id', None) in _FUNCTIONS:
        return _FUNCTIONS[node.func.id](*[_value(a, names) for a in node.args])
    raise SyntaxError('the table holds an expression that is not understood: ' + ast.dump(node))


def numbered(letter, values):
    return {'%s%d' % (letter, k + 1): float(v) for k, v in enumerate(values)}


def row_value(row, parameters, states=()):
    """The value of row['value'] in its parameters and in states x1, x2, ..."""
    own = [parameters[name] for name in row.get('parameters') or []]
    return value(row['value'], **numbered('p', own), **numbered('x', states))


def _semidefinite(v):
    inertia = v.reshape(3, 3)
    return np.linalg.eigvalsh((inertia + inertia.T) / 2)[0] >= -1e-13 * np.abs(v).max()


def _rotation(v):
    r = v.reshape(3, 3)
    return np.abs(r.T @ r - np.eye(3)).max() < 1e-12 and np.linalg.det(r) > 0


# rule: (what holds, what is said where it does not)
_RULES = {
    'nonnegative': (lambda v: (v >= 0).all(), 'must not be negative'),
    'positive': (lambda v: (v > 0).all(), 'must be above 0'),
    'nonzero': (lambda v: (v != 0).all(), 'must not be 0'),
    'fraction': (lambda v: ((v > 0) & (v <= 1)).all(), 'must be above 0 and at most 1'),
    'axis': (lambda v: (np.abs(v) >= 1e-12).any(), 'must not be the zero vector'),
    'across': (lambda v: abs(v[:3] @ v[3:6]) < 1e-12, 'must be across axis'),
    'inertia': (_semidefinite, 'must have no negative eigenvalue'),
    'rotation': (_rotation, "must be a rotation (R'R = 1, determinant 1)"),
    'finite': (lambda v: True, ''),
    'rather_nonnegative': (lambda v: True, ''),
}


def broken(rules, parameters):
    """The sentences of the rules that these parameters break."""
    found = []
    for rule in rules:
        own = [parameters[name] for name in rule['parameters']]
        v = np.array([value(text, **numbered('p', own)) for text in rule['values']])
        holds, sentence = _RULES[rule['rule']]
        if not np.isfinite(v).all():
            sentence = 'must be real and finite'
        elif holds(v):
            continue
        if 'expected' in rule:
            text = '%s: expected %s' % (rule['place'], rule['expected'])
        else:
            text = '%s %s' % (rule['place'], sentence)
        found.append('%s; found: %s' % (text, ', '.join(
            '%s = %g' % pair for pair in zip(rule['parameters'], own))))
    return found
