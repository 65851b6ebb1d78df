"""Finds libeyebridge, and binds the functions of the table: `lib` for programs, `C` for this module.

They are two sets of function objects, so that a program that sets `lib.PSDGet.argtypes` changes nothing of `eye`.
"""

import ctypes as _ctypes
import os as _os
import types as _types

from . import _convert
from ._signatures import SIGNATURES as _SIGNATURES

_NAME = "libeyebridge.so.0"
_HERE = _os.path.dirname(_os.path.abspath(__file__))
# In a wheel; in a build tree; in an installation; in the source tree, of the release build.
_PLACES = ("../eyebridge", "../../lib", "../../..", "../../build/release/lib")


def _find():
    for place in _PLACES:
        path = _os.path.normpath(_os.path.join(_HERE, place, _NAME))
        if _os.path.exists(path):
            return path
    return _NAME  # wherever the system's loader looks


def _open(path):
    try:
        return _ctypes.CDLL(path)
    except OSError as error:
        searched = ", ".join(_os.path.normpath(_os.path.join(_HERE, place)) for place in _PLACES)
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
