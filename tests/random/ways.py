"""The way in which a scene is derived and written, drawn by its seed."""
import random

PASSES = ('zeros share dead hoist angles frames slide group phase spin station short tangents '
          'sines cancel factor pairs once order gauge unit').split()
OPTIONAL = ['gauge', 'unit']
REQUESTS = ['rhs', 'linear', 'jacobian', 'output', 'energy',
            'batch']  # each drawn; the others are always there


class Way:

    def __init__(self, seed):
        r = random.Random(7919*seed + 1)
        self.lisp = r.choices(['GCL', 'ECL'], [.88, .12])[0]
        self.forward = r.choices(['cheapest', 'mass', 'articulated'], [.56, .22, .22])[0]
        self.numbers = r.choices(['literal', 'compiled'], [.75, .25])[0]
        kind = r.choices(['default', 'all', 'none', 'no closed form', 'one off'],
                         [.26, .16, .15, .16, .27])[0]
        on = [p for p in PASSES if p not in OPTIONAL]
        off = r.choice(on)
        self.kind = kind
        self.passes = {
            'default': on, 'all': PASSES, 'none': [], 'no closed form':
            [p for p in on if p != 'short'], 'one off': [p for p in on if p != off]
        }[kind]
        self.off = off if kind == 'one off' else ''
        self.requests = [
            w for w in REQUESTS
            if r.random() < {'jacobian': .18, 'batch': .16, 'rhs': .5}.get(w, .3)
        ]
        self.literal = r.random() < .35

    def names(self):
        off = ['without ' + self.off] if self.off else []
        return [
            'Maxima on ' + self.lisp, 'forward: ' + self.forward, 'numbers: ' + self.numbers,
            'passes: ' + self.kind
        ] + off
