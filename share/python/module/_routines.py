"""Every subroutine of the table as a method; render.py writes their types (_routines.pyi)."""
from ._library import ROUTINES


class Routines:
    """The subroutines of the scene."""


def _made(routine):
    def method(self, *values, **named):
        return routine(self, *values, **named)
    method.__name__ = routine.name
    method.__module__ = __package__   # where pickle looks for it
    method.__qualname__ = 'Model.' + routine.name
    method.__doc__ = routine.documentation()
    return method


for _name, _routine in ROUTINES.items():
    setattr(Routines, _name, _made(_routine))
