"""calls_python.py FILE OUT: the calls of FILE (calls.json) in the Python modules of its scenes,
which must be importable; a line for each into OUT, its message."""
import importlib
import json
import sys
import warnings


def message(module, given):
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter('always')
        try:
            model = module.Model(**given.get('par', {}))
            model.simulate(given['x0'], given['times'], **given.get('options', {}))
        except Exception as error:
            return '%s: %s' % (type(error).__name__, error.args[0] if error.args else '')
    return 'warning: %s' % said[-1].message if said else 'accepted'


table = json.load(open(sys.argv[1]))
with open(sys.argv[2], 'w') as out:
    for name, given in table['calls']:
        text = message(importlib.import_module(name), {**table['scenes'][name], **given})
        out.write(str(text).replace('\n', ' ') + '\n')
