"""What programs hand over, made into what C takes. ctypes calls from_param() for each argument."""

import ctypes as _ctypes
import sys as _sys


def _whole(value):
    if type(value) is int:
        return value
    if isinstance(value, _ctypes._SimpleCData):
        value = value.value
    return int(value)


class Whole:
    """An int: what int() takes (floats are cut, as C does it; numpy's numbers), and ctypes integers."""

    from_param = staticmethod(_whole)


class Text:
    """A string: str as UTF-8, bytes as they are, None as NULL, anything else as str() prints it."""

    @staticmethod
    def from_param(value):
        if value is None or isinstance(value, bytes):
            return value
        if isinstance(value, _ctypes._SimpleCData):
            return value.value
        return str(value).encode("utf-8", "replace")


class Character:
    """A char: the first of a string, or a number."""

    @staticmethod
    def from_param(value):
        if isinstance(value, str):
            value = value.encode("latin-1", "replace")
        if isinstance(value, (bytes, bytearray)):
            value = value[0] if value else 0
        return _ctypes.c_char(_whole(value) & 0xFF)


_said = set()


def warn(message):
    """One line on standard error, the first time only: as the library does it."""
    if message not in _said:
        _said.add(message)
        print("eyebridge: warning: " + message, file=_sys.stderr, flush=True)


_POINTERS = (_ctypes._Pointer, _ctypes.c_void_p, _ctypes.c_char_p, type(_ctypes.byref(_ctypes.c_int())))


def is_pointer(value):
    """True for pointers of ctypes: nobody knows how much memory is behind them."""
    return isinstance(value, _POINTERS)


def _flat(values):
    if isinstance(values, str):
        raise TypeError("a str is text")
    for value in values:
        if hasattr(value, "__iter__"):
            yield from _flat(value)
        else:
            yield _whole(value) & 0xFF


def _byte_view(value):
    """`value` as a memoryview of bytes without gaps, None when it is something else."""
    try:
        view = memoryview(value)
    except TypeError:
        return None
    return view if view.itemsize == 1 and view.c_contiguous else None


def memory(image):
    """An image as something that c_void_p takes, and its bytes: ctypes arrays, bytes, bytearrays, and numpy arrays of
    bytes without a copy; other arrays and lists of numbers, of any shape, copied, each number cut to a byte."""
    if isinstance(image, _ctypes.Array):
        return image, _ctypes.sizeof(image)
    if isinstance(image, bytes):
        return image, len(image)
    view = _byte_view(image)
    if view is None:
        copy = bytes(_flat(image.tolist() if hasattr(image, "tolist") else image))
        return copy, len(copy)
    if view.readonly:
        copy = view.tobytes()
        return copy, len(copy)
    return (_ctypes.c_ubyte * view.nbytes).from_buffer(view), view.nbytes


def image_in(call, image, needed):
    """`image` for a function that reads `needed` bytes; None (and a warning) when it is none or too small."""
    if image is None or is_pointer(image):
        return image
    try:
        data, size = memory(image)
    except (TypeError, ValueError) as error:
        warn(f"{call}: this is no image: {error}")
        return None
    if size < needed:
        warn(f"{call}: the image has {size} bytes, {needed} are needed")
        return None
    return data


def image_out(call, given, needed):
    """Where a function writes `needed` bytes: `given`, or a new array of signed bytes. None as image_in()."""
    if given is None:
        return (_ctypes.c_byte * needed)()
    if not isinstance(given, _ctypes.Array) and not is_pointer(given):
        view = _byte_view(given)
        if view is None or view.readonly:
            warn(f"{call}: the memory for the result cannot be written byte by byte")
            return None
    return image_in(call, given, needed)


def out(value, kind=_ctypes.c_int):
    """Where a function writes a number: a ctypes object or pointer of the program, else a new `kind`."""
    if is_pointer(value):
        return value
    if isinstance(value, (_ctypes._SimpleCData, _ctypes.Array)):
        return _ctypes.byref(value)
    return _ctypes.byref(kind())
