"""A scene as data: elements with options, parameters; its text."""
import copy
from values import Quantity, Rotation, replaced

GROUND = 'ground'
# coordinates of each joint that its reversal only gives another sign, and their units
PLAIN = {'revolute': 'r', 'prismatic': 'm', 'helical': 'r', 'cylindrical': 'mr', 'universal': 'rr'}


class Element:
    """word(name, ends ..., option = value ...): ends are links, for a joint parent and child. A
    value is a quantity, a rotation, a list of these, or the text of an expression"""

    def __init__(self, word, name, ends=(), /, **options):
        self.word, self.name, self.ends, self.options = word, name, list(ends), options

    def written(self):
        words = [self.name] + self.ends + self.options.get('rest_', [])
        words += ['%s = %s' % (k, written(v)) for k, v in self.options.items() if k != 'rest_']
        return '%s(%s)' % (self.word, ', '.join(words))

    def is_joint(self):
        return self.word in JOINTS

    def coordinates(self):
        own = self.options.get('coordinates', self.options.get('coordinate', []))
        return [own] if isinstance(own, str) else own


JOINTS = list(PLAIN) + ['spherical', 'free', 'planar', 'fixed', 'elastic_joint']


def written(value):
    if isinstance(value, list):
        return '[' + ', '.join(written(x) for x in value) + ']'
    return value if isinstance(value, str) else value.written()


def mapped(value, change):
    """a value whose texts are what change makes of them"""
    if isinstance(value, list):
        return [mapped(x, change) for x in value]
    if isinstance(value, str):
        return replaced(value, change)
    if value.text is None:
        return value
    text = replaced(value.text, change)
    if isinstance(value, Quantity):
        return Quantity(value.value, value.unit, text)
    return Rotation(value.R, text)


class Scene:
    """elements; parameters: {name: quantity}; speeds: own ones {name: text}; features: what was
    put into it"""

    def __init__(self, name):
        self.name, self.elements, self.parameters, self.speeds = name, [], {}, {}
        self.gravity, self.features, self.inputs = None, [], {}
        self.closed = False  # whether constraints hold it
        self.by, self.smooth = '', True  # a parameter; whether derivatives are compared

    def copy(self, name):
        other = copy.deepcopy(self)
        other.name = name
        return other

    def of(self, *words):
        return [e for e in self.elements if e.word in words]

    def joints(self):
        return [e for e in self.elements if e.is_joint()]

    def named(self, name):
        return next(e for e in self.elements if e.name == name)

    def expressions(self, change):
        """replaces the words of all expressions, but not of names and ends"""
        for e in self.elements:
            for k, v in e.options.items():
                if k not in ('coordinate', 'coordinates', 'joint'):
                    e.options[k] = mapped(v, change)
        self.speeds = {k: mapped(v, change) for k, v in self.speeds.items()}

    def text(self):
        parts = ['gravity = ' + written(self.gravity)] + [e.written() for e in self.elements]
        parts += ['input(%s, unit = %s)' % x for x in self.inputs.items()]
        if self.speeds:
            own = ['%s = %s' % x for x in self.speeds.items()]
            parts.append('speeds = [' + ', '.join(own) + ']')
        if self.parameters:
            own = ['%s = %s' % (k, v.in_unit(v.unit, 1).text if v.text is None and v.unit else
                                v.written()) for k, v in self.parameters.items()]
            parts.append('parameters = [' + ', '.join(own) + ']')
        return 'scene : gsmbp_scene("%s",\n  %s)$\n' % (self.name, ',\n  '.join(parts))
