"""Numbers that the library changes while the program runs, and those that SIMGetRobot() gives."""

import ctypes as _ctypes
import operator as _operator

from ._library import variable as _variable


class Live:
    """A C variable as a number that is always what it is now.

    `from eye import *` copies names, so a plain int would stay what it was then: 0 for CAMWIDTH. This one goes where
    an int goes (range, indices, arithmetic, `%d`, numpy shapes, `ctypes.c_byte * CAMSIZE`), but is no instance of int:
    int(CAMWIDTH) is the value of this moment.
    """

    __slots__ = ("_place",)

    def __init__(self, name):
        self._place = _variable(name)

    def __index__(self):
        return self._place.value

    __int__ = __trunc__ = __index__

    def __float__(self):
        return float(self._place.value)

    def __bool__(self):
        return self._place.value != 0

    def __hash__(self):
        return hash(self._place.value)

    def __repr__(self):
        return repr(self._place.value)

    def __format__(self, spec):
        return format(self._place.value, spec)

    @property
    def value(self):
        """The value of this moment, an int."""
        return self._place.value


def _plain(value):
    return value._place.value if isinstance(value, Live) else value


def _both(function):
    return lambda self, other: function(self._place.value, _plain(other))


def _turned(function):
    return lambda self, other: function(_plain(other), self._place.value)


for _name in "add sub mul truediv floordiv mod pow lshift rshift and or xor".split():
    _function = getattr(_operator, _name + "_" if _name in ("and", "or") else _name)
    setattr(Live, f"__{_name}__", _both(_function))
    setattr(Live, f"__r{_name}__", _turned(_function))
for _name in "eq ne lt le gt ge".split():
    setattr(Live, f"__{_name}__", _both(getattr(_operator, _name)))
for _name in "neg pos abs invert".split():
    setattr(Live, f"__{_name}__", lambda self, _function=getattr(_operator, _name): _function(self._place.value))
Live.__divmod__ = _both(divmod)
Live.__rdivmod__ = _turned(divmod)
Live.__round__ = lambda self, digits=None: round(self._place.value, digits)


class SimValue(int):
    """An int that also has what a ctypes int has: one generation of `eye` gave those, and programs say `.value`."""

    __slots__ = ()

    @property
    def value(self):
        """The number itself, a plain int."""
        return int(self)

    def __bytes__(self):
        return bytes(_ctypes.c_int(self))
