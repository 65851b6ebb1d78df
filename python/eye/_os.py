"""OS: system, time, timers and errors. Milliseconds on the robot's clock."""

import ctypes as _ctypes

from . import _convert
from ._library import C as _C

_Callback = _ctypes.CFUNCTYPE(None)
# What C may still call must not be collected: a timer that is detached may be running once more.
_callbacks = {}


def OSExecute(command):
    """Runs a shell command to its end and returns what it printed, as str; None on failure."""
    output = _C.OSExecute(command)
    return None if output is None else output.decode("utf-8", "replace")


def _string(call, function, buf):
    """For functions that fill in a string of at most 100 bytes: the str, or the result where `buf` is given."""
    if isinstance(buf, _ctypes.Array) or _convert.is_pointer(buf):
        if isinstance(buf, _ctypes.Array) and _ctypes.sizeof(buf) < 100:
            _convert.warn(f"{call}: the buffer has {_ctypes.sizeof(buf)} bytes, 100 are needed")
            return 1
        return function(buf)
    text = _ctypes.create_string_buffer(256)
    result = function(text)
    if buf is not None:
        return result  # a str cannot be filled in
    return text.value.decode("utf-8", "replace") if result == 0 else None


def OSVersion(buf=None):
    """The version of RoBIOS as str. Given a ctypes buffer of 100 bytes, fills it in and returns 0."""
    return _string("OSVersion", _C.OSVersion, buf)


def OSVersionIO(buf=None):
    """The version of the I/O board as str, None when there is no board. Given a ctypes buffer, as OSVersion()."""
    return _string("OSVersionIO", _C.OSVersionIO, buf)


def OSMachineSpeed():
    """Processor speed in Hz."""
    return _C.OSMachineSpeed()


def OSMachineType():
    """VEHICLE, PLATFORM or WALKER."""
    return _C.OSMachineType()


def OSMachineName(buf=None):
    """The machine's name as str. Given a ctypes buffer of 100 bytes, fills it in and returns 0."""
    return _string("OSMachineName", _C.OSMachineName, buf)


def OSMachineID():
    """Number of this robot."""
    return _C.OSMachineID()


def OSWait(n):
    """Waits n milliseconds; timers go on."""
    return _C.OSWait(n)


def OSAttachTimer(scale, fct):
    """Calls fct() every scale milliseconds until OSDetachTimer(). Returns a handle, 0 on failure. fct may call RoBIOS;
    what it raises is printed, and the timer goes on."""
    if not callable(fct):
        _convert.warn(f"OSAttachTimer: {fct!r} cannot be called")
        return 0
    callback = fct if isinstance(fct, _ctypes._CFuncPtr) else _Callback(fct)
    handle = _C.OSAttachTimer(scale, callback)
    if handle > 0:
        _callbacks[handle] = callback
    return handle


def OSDetachTimer(t):
    """Ends a timer. 1 for an unknown handle. Its function may still be running when this returns."""
    return _C.OSDetachTimer(t)


def OSGetTime(hrs=None, mins=None, secs=None, ticks=None):
    """Time of day: [hours, minutes, seconds, thousandths]. Given ctypes ints, fills them in and returns 0."""
    if hrs is None and mins is None and secs is None and ticks is None:
        four = (_ctypes.c_int * 4)()
        _C.OSGetTime(four, _ctypes.byref(four, 4), _ctypes.byref(four, 8), _ctypes.byref(four, 12))
        return four[:]
    return _C.OSGetTime(*(_convert.out(place) for place in (hrs, mins, secs, ticks)))


def OSSetTime(hrs, mins, secs):
    """Sets the time of day."""
    return _C.OSSetTime(hrs, mins, secs)


def OSGetCount():
    """Milliseconds since the program started."""
    return _C.OSGetCount()


def EYEBRIDGELastError():
    """Why the last RoBIOS call of this program that failed did so; "" when none has failed."""
    return _C.EYEBRIDGELastError().decode("utf-8", "replace")
