"""What is wrong with the arguments of a call, in words."""
import difflib
import functools
import inspect

from ._library import NAME


def guessed(name, words):
    """The words that were likely meant."""
    found = ([w for w in words if w.lower() == name.lower()]
             or difflib.get_close_matches(name, words, 3))
    return '; did you mean %s?' % ' or '.join(found) if found else ''


def nearest(name, words):
    """The words that were likely meant, and all that there are."""
    known = '; known: ' + ', '.join(words) if words else '; there are none'
    return guessed(str(name), words) + known


def explained(function):
    """A method of Model: the TypeError of a wrong call names the argument and what is expected."""
    signature = inspect.signature(function)

    @functools.wraps(function)
    def call(*values, **named):
        try:
            signature.bind(*values, **named)
        except TypeError:
            raise TypeError(_wrong(function, signature, values, named)) from None
        return function(*values, **named)
    return call


def _wrong(function, signature, values, named):
    """Why the call with these arguments, the model first, does not fit."""
    name = 'Model' if function.__name__ == '__init__' else function.__name__
    who = '%s.%s' % (NAME, name)
    known = list(signature.parameters.values())[1:]
    placed = [p.name for p in known if p.kind == p.POSITIONAL_OR_KEYWORD]
    typed = '%s%s' % (name, str(signature.replace(parameters=known)))
    if len(values) > 1 + len(placed):
        return '%s: expected at most %d arguments without a name%s; found %d; type %s' % (
            who, len(placed), ' (%s)' % ', '.join(placed) if placed else '', len(values) - 1,
            typed if placed else '%s(NAME=value), NAME a parameter' % name)
    words = [p.name for p in known]
    for word in named:
        if word not in words:
            return '%s: argument %s is unknown%s; expected %s' % (
                who, word, guessed(word, words), typed)
    for word in placed[:len(values) - 1]:
        if word in named:
            return '%s: argument %s is given twice; expected %s' % (who, word, typed)
    missing = [p.name for p in known if p.default is p.empty and p.name not in named]
    missing = [w for w in missing if w not in placed[:len(values) - 1]]
    return '%s: argument %s is missing; expected %s' % (who, missing[0], typed)
