"""Finds libeyebridge, and binds the functions of the table: `lib` for programs, `C` for this module.

They are two sets of function objects, so that a program that sets `lib.PSDGet.argtypes` changes nothing of `eye`.
"""

import ctypes as _ctypes
import os as _os
import sys as _sys
import types as _types

from . import _convert
from ._signatures import SIGNATURES as _SIGNATURES

_NAME = "libeyebridge.so.0"


def _folders():
    """Where the library may be: in a wheel; of the release build; in the prefix that this package is installed in."""
    above = _os.path.dirname(_os.path.dirname(_os.path.abspath(__file__)))
    yield _os.path.join(above, "eyebridge", "lib")
    yield _os.path.join(_os.path.dirname(above), "build", "release", "lib")
    libraries = ["lib", _os.path.join("lib", getattr(_sys.implementation, "_multiarch", ""))]
    while above != _os.path.dirname(above):
        above = _os.path.dirname(above)
        yield from (_os.path.join(above, name) for name in libraries)


def _find():
    for folder in _folders():
        path = _os.path.join(folder, _NAME)
        if _os.path.exists(path):
            return path
    return _NAME  # wherever the system's loader looks


def _open(path):
    try:
        return _ctypes.CDLL(path)
    except OSError as error:
        searched = ", ".join(_folders())
        raise ImportError(f"cannot load {_NAME} ({error}); searched in {searched}") from error


_RESULTS = {
    "void": None,
    "int": _ctypes.c_int,
    "byte": _ctypes.c_ubyte,
    "char": _ctypes.c_char,
    "bool": _ctypes.c_bool,
    "text": _ctypes.c_char_p,
}
# What a program may hand to `lib`: whatever ctypes makes of it.
_PLAIN = {
    "int": _ctypes.c_int,
    "byte": _ctypes.c_ubyte,
    "char": _ctypes.c_char,
    "text": _ctypes.c_char_p,
    "int*": _ctypes.c_void_p,
    "byte*": _ctypes.c_void_p,
    "char*": _ctypes.c_void_p,
    "callback": _ctypes.c_void_p,
}
# What `eye` takes: more than that.
_TOLERANT = _PLAIN | {
    "int": _convert.Whole,
    "byte": _convert.Whole,
    "char": _convert.Character,
    "text": _convert.Text,
}


def rows():
    """Name, result and parameters of each function of the table, as words."""
    for line in _SIGNATURES.split("\n"):
        if line:
            result, _, rest = line.partition(" ")
            name, _, words = rest.rstrip(")").partition("(")
            yield name, result, [word.strip() for word in words.split(",") if word.strip()]


def _missing(name, path):
    def call(*_arguments):
        raise NotImplementedError(f"{name}: {path} has no such function")

    return call


def _bind(library, path, types):
    bound = {}
    for name, result, parameters in rows():
        function = getattr(library, name, None)
        if function is None:
            bound[name] = _missing(name, path)
            continue
        function.restype = _RESULTS[result]
        function.argtypes = [types[word] for word in parameters if word != "..."]
        bound[name] = function
    return _types.SimpleNamespace(**bound)


_path = _find()
#: The C library, for programs that call it themselves; they may set argtypes and restypes.
lib = _open(_path)
#: The same functions with tolerant parameters, for this module alone.
library = _open(_path)
_bind(lib, _path, _PLAIN)
C = _bind(library, _path, _TOLERANT)


def variable(name):
    """The C variable `name`, a ctypes int at its place in the library."""
    return _ctypes.c_int.in_dll(library, name)
