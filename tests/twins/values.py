"""Values of a scene as data: quantities, vectors, rotations in exact fractions, and the words in
expressions."""
import re
from fractions import Fraction

# of each SI unit others, with how many of them make it; degrees and turns are not exact
OTHERS = {
    'm': [('mm', '1000'), ('cm', '100')], 'kg': [('gram', '1000'), ('tonne', '1/1000')],
    's': [('ms', '1000')], 'rad': [('deg', '180/%pi')], 'rad/s': [('rpm', '30/%pi'),
                                                                   ('deg/s', '180/%pi')],
    'm/s': [('mm/s', '1000')], 'm/s^2': [('mm/s^2', '1000')], 'N': [('kN', '1/1000')],
    'N*m': [('N*mm', '1000')], 'N/m': [('N/mm', '1/1000')], 'N*s/m': [('kN*s/m', '1/1000')],
    'N*m/rad': [('N*m/deg', '%pi/180'), ('N*mm/rad', '1000')],
    'N*m*s/rad': [('N*mm*s/rad', '1000')], 'kg*m^2': [('kg*cm^2', '10000'),
                                                       ('gram*m^2', '1000')],
    'kg*m^2/s': [('kg*cm^2/s', '10000')], 'ohm': [('V/A', '1')], 'H': [('mH', '1000')],
    'N*m^2': [('kN*m^2', '1/1000')], 'Pa': [('kPa', '1/1000')],
}


def exact(x):
    """a fraction as Maxima reads it: a decimal where it is one"""
    text = repr(float(x))
    if 'e' not in text and Fraction(text) == x:
        return text
    return '%d' % x if x.denominator == 1 else '(%d/%d)' % (x.numerator, x.denominator)


class Quantity:
    """a number with its SI unit; text: as it is written where it is a parameter or in another
    unit"""

    def __init__(self, value, unit='', text=None):
        self.value, self.unit, self.text = Fraction(str(value)), unit, text

    def written(self):
        return self.text or exact(self.value)

    def in_unit(self, unit, factor):
        """the same in another unit"""
        try:
            number = exact(self.value*Fraction(factor))
        except ValueError:
            number = '(%s)*(%s)' % (exact(self.value), factor)
        return Quantity(self.value, self.unit, '%s*%s' % (number, unit))


def combined(factors, quantities):
    """sum of factors times quantities"""
    value = sum((f*q.value for f, q in zip(factors, quantities)), Fraction(0))
    text = None
    if any(q.text for q in quantities):
        text = summed(factors, [q.written() for q in quantities])
    return Quantity(value, quantities[0].unit, text)


def summed(factors, texts):
    """text of a sum of factors times expressions"""
    parts = ['%s*(%s)' % (exact(f), t) for f, t in zip(factors, texts)
             if f and t not in ('0', '0.0')]
    return '(' + ' + '.join(parts) + ')' if parts else '0'


def vector(numbers, unit=''):
    return [Quantity(x, unit) for x in numbers]


def identity():
    return [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]


def product(A, B):
    return [[sum((A[i][k]*B[k][j] for k in range(3)), Fraction(0)) for j in range(3)]
            for i in range(3)]


def transposed(A):
    return [list(row) for row in zip(*A)]


def turned(R, v):
    """a vector of quantities or of texts in other axes"""
    if all(isinstance(x, str) for x in v):
        return [summed(row, v) for row in R]
    return [combined(row, v) for row in R]


def about(axis, cosine, sine):
    """rotation about x, y or z"""
    R, (i, j) = identity(), {'x': (1, 2), 'y': (2, 0), 'z': (0, 1)}[axis]
    R[i][i] = R[j][j] = Fraction(cosine)
    R[i][j], R[j][i] = -Fraction(sine), Fraction(sine)
    return R


TURNS = [('3/5', '4/5'), ('5/13', '12/13'), ('12/13', '-5/13'), ('4/5', '3/5'), ('0', '1')]


def any_rotation(r, count=2):
    R = identity()
    for axis in r.sample('xyz', count):
        R = product(R, about(axis, *r.choice(TURNS)))
    return R


class Rotation:
    """of the axes of a joint; text: as it is written where that is no matrix"""

    def __init__(self, R, text=None):
        self.R, self.text = R, text

    def written(self):
        rows = ', '.join('[' + ', '.join(exact(x) for x in row) + ']' for row in self.R)
        return self.text or 'matrix(' + rows + ')'

    def behind(self, R):
        """turned by R first"""
        return Rotation(product(R, self.R))


WORD = re.compile(r'(?<![\w.%])[A-Za-z]\w*')


def replaced(text, change):
    """an expression whose words are what change makes of them"""
    return WORD.sub(lambda found: change(found.group()), text)
