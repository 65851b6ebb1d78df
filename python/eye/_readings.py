"""Calls that return readings: what they raise when there is none."""

import ctypes as _ctypes

from . import _host
from ._library import C as _C

_Two = _ctypes.c_int * 2


class RobotError(RuntimeError):
    """A call that returns readings has none; the text says why."""


def failure(call):
    """The RobotError for `call`, which has just failed."""
    reason = _C.EYEBRIDGELastError()
    _host.await_end()
    text = reason.decode("utf-8", "replace") if reason else "failed"
    return RobotError(text if text.startswith(call) else f"{call}: {text}")


def pair(call, function):
    """[first, second] of what function(int*, int*) fills in. RobotError when it fails."""
    two = _Two()
    if function(two, _ctypes.byref(two, 4)) != 0:
        raise failure(call)
    return two[:]
