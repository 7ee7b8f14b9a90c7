"""What a session is asked for one scene: the scene, and its twins."""
import os
import random
import shutil
from features import FEATURES
from maps import Map
from skeletons import SKELETONS, Builder
from twins import TWINS, heavier
from ways import OPTIONAL, PASSES

SHORT = os.environ.get('GSMBP_TWINS') == 'short'  # one twin each, fewer derivatives
MODULES = 10 if SHORT else 5  # one scene in so many is a module of Python as well
WORDS = ['rhs', 'inverse', 'energy', 'events', 'jacobian', 'output', 'projection', 'constraints']


def deck(seed, word, names, count):
    """`count` names of a scene: every name comes as often as any other one"""
    names = list(names)
    turn = seed*count
    return [dealt(word, names, k) for k in range(turn, turn + count)]


def dealt(word, names, k):
    cards = list(names)
    random.Random('%s %d' % (word, k//len(cards))).shuffle(cards)
    return cards[k % len(cards)]


def built(seed):
    """a builder with its scene"""
    b = Builder(seed, 'twin%d' % seed)
    kind = dealt('skeleton', SKELETONS, seed)
    SKELETONS[kind](b)
    b.scene.features.append(kind)
    for f in sorted(deck(seed, 'feature', FEATURES, 4), key=list(FEATURES).index):
        if f not in b.scene.features and FEATURES[f](b) is not False:
            b.scene.features.append(f)
    b.scene.by = b.r.choice(list(b.scene.parameters) or [''])
    return b


class Way:
    """as the session wants it"""

    def __init__(self, forward='cheapest', numbers='literal', passes=None):
        self.forward, self.numbers = forward, numbers
        self.passes = passes or [p for p in PASSES if p not in OPTIONAL]


class Call:
    """one derivation; told: the map from the scene, None for the scene itself"""

    points = '[]'

    def __init__(self, scene, way, told=None, kinds=(), module=False):
        self.scene, self.way, self.told, self.kinds, self.module = scene, way, told, kinds, module
        self.requests = [w for w in WORDS if needed(w, scene)]
        self.derived = ''  # the parameter by which rates are differentiated
        if needed('jacobian', scene) and scene.parameters and way.numbers == 'literal':
            self.derived = scene.by if told is None else told.renamed(scene.by)
            self.requests.append('sensitivity(%s)' % self.derived)

    def path(self, folder):
        return os.path.join(folder, self.scene.name)

    def write(self, folder):
        for end in ('error', 'json', 'cheapest', 'module'):
            if os.path.exists(self.path(folder) + '.' + end):
                os.remove(self.path(folder) + '.' + end)
        shutil.rmtree(self.path(folder) + '_module', ignore_errors=True)
        with open(self.path(folder) + '.mac', 'w') as f:
            f.write(self.scene.text())
        if self.module:
            open(self.path(folder) + '.module', 'w').close()


def needed(word, scene):
    held = any(e.options.get('variant') == 'event' for e in scene.elements)
    return {'output': bool(scene.of('output')), 'events': held or bool(scene.of('event')),
            'jacobian': not held and scene.smooth, 'projection': scene.closed or has_balls(scene),
            'constraints': scene.closed}.get(word, True)


def has_balls(scene):
    return any(J.word in ('spherical', 'free') and 'orientation' not in J.options
               for J in scene.joints() if J.coordinates())


def twin(b, seed, number, kinds, module):
    """a twin that the changes `kinds` make, one behind the other"""
    r, told = random.Random('twin %d %d' % (seed, number)), Map()
    scene = b.scene.copy('%st%d' % (b.scene.name, number))
    for kind in [k for k in TWINS if k in kinds]:
        TWINS[kind](scene, r, told)
    if 'heavier' in kinds:  # which has to be found
        heavier(scene, r, told)
    way = Way()
    if 'forward' in kinds:
        numbers = 'literal' if told.run else r.choice(['literal', 'compiled'])
        way = Way(r.choice(['mass', 'articulated']), numbers,
                  r.choice([None, PASSES]))
    return Call(scene, way, told, kinds, module)


def calls_of(seed, kinds=None):
    """the builder, the calls: the scene, a twin of one change, one of several"""
    b = built(seed)
    module = seed % MODULES == 0
    b.scene.smooth = not SHORT or seed % 3 == 0
    calls = [Call(b.scene, Way(), module=module)]
    rest = random.Random('kinds %d' % seed)
    lists = kinds or [deck(seed, 'twin', TWINS, 1), sorted(rest.sample(list(TWINS), 3))]
    if SHORT and not kinds:
        lists = [sorted({*lists[0], *lists[1]})]
    for k, own in enumerate(lists):
        calls.append(twin(b, seed, k + 1, own, module and k == len(lists) - 1))
    return b, calls
