"""The way in which a scene is derived and written: cards of shuffled decks, so that each way has
its share."""
import random

PASSES = ('zeros share dead hoist angles frames slide group phase spin station short tangents '
          'sines cancel factor pairs once order gauge unit').split()
OPTIONAL = ['gauge', 'unit']
DECK = 50
# cards of each deck; each deck is shuffled anew for every fifty seeds
LISP = {'GCL': 43, 'ECL': 7}
FORWARD = {'cheapest': 22, 'mass': 13, 'articulated': 15}
NUMBERS = {'literal': 37, 'compiled': 13}
KINDS = {'default': 13, 'all': 8, 'none': 8, 'no closed form': 8, 'one off': 13}
# asked for beside what is always there
REQUESTS = {'rhs': 25, 'linear': 10, 'jacobian': 10, 'output': 13, 'energy': 13, 'batch': 8}
LITERAL = 24


def card(deck, seed, word):
    """the seed's own of the cards {name: number}"""
    cards = [name for name, n in deck.items() for _ in range(n)]
    random.Random('%s %d' % (word, seed//DECK)).shuffle(cards)
    return cards[seed % DECK]


def every_way():
    decks = {'Maxima on ': LISP, 'forward: ': FORWARD, 'numbers: ': NUMBERS, 'passes: ': KINDS}
    return [title + name for title, deck in decks.items() for name in deck]


def drawn(n, seed, word):
    return card({True: n, False: DECK - n}, seed, word)


class Way:

    def __init__(self, seed):
        self.lisp, self.forward = card(LISP, seed, 'lisp'), card(FORWARD, seed, 'forward')
        self.numbers, self.kind = card(NUMBERS, seed, 'numbers'), card(KINDS, seed, 'passes')
        on = [p for p in PASSES if p not in OPTIONAL]
        off = random.Random(7919*seed + 1).choice(on)
        self.passes = {
            'default': on, 'all': PASSES, 'none': [], 'no closed form':
            [p for p in on if p != 'short'], 'one off': [p for p in on if p != off]
        }[self.kind]
        self.off = off if self.kind == 'one off' else ''
        self.requests = [w for w, n in REQUESTS.items() if drawn(n, seed, w)]
        # without these the code is many times as long: scenes of few links say as much
        self.long = any(p not in self.passes for p in ('share', 'dead', 'zeros'))
        self.literal = (self.numbers == 'literal' and not self.long
                        and drawn(LITERAL, seed, 'equations'))

    def names(self):
        off = ['without ' + self.off] if self.off else []
        return [
            'Maxima on ' + self.lisp, 'forward: ' + self.forward, 'numbers: ' + self.numbers,
            'passes: ' + self.kind
        ] + off
