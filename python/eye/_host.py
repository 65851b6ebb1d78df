"""What the library has to know of the interpreter, and the program's time: see eyebridge_host.h."""

import atexit as _atexit
import ctypes as _ctypes
import functools as _functools
import os as _os
import signal as _signal
import sys as _sys
import threading as _threading
import time as _time

from ._library import library as _library

_FOLDER = _os.path.dirname(_os.path.abspath(__file__))
_Interrupted = _ctypes.CFUNCTYPE(_ctypes.c_int)
_Ending = _ctypes.CFUNCTYPE(None)

_begin = _library.EYEBRIDGEHostBegin
_begin.argtypes, _begin.restype = [_ctypes.c_char_p, _Interrupted, _Ending], None
_start = _library.EYEBRIDGEHostStart
_start.argtypes, _start.restype = [_ctypes.c_int, _ctypes.POINTER(_ctypes.c_char_p), _ctypes.c_char_p], None
_end = _library.EYEBRIDGEHostEnd
_end.argtypes, _end.restype = [], None
_wait = _library.EYEBRIDGEHostWait
_wait.argtypes, _wait.restype = [_ctypes.c_longlong], _ctypes.c_int
_now = _library.EYEBRIDGEHostNow
_now.argtypes, _now.restype = [], _ctypes.c_longlong
_expected = _library.EYEBRIDGEHostThreadExpected
_expected.argtypes, _expected.restype = [], _ctypes.c_void_p
_starts = _library.EYEBRIDGEHostThreadStarts
_starts.argtypes, _starts.restype = [_ctypes.c_void_p], None
_failed = _library.EYEBRIDGEHostThreadFailed
_failed.argtypes, _failed.restype = [_ctypes.c_void_p], None
_started = _library.EYEBRIDGEHostThreadStarted
_started.argtypes, _started.restype = [_ctypes.c_void_p], None

_real_sleep, _real_time, _real_time_ns = _time.sleep, _time.time, _time.time_ns


@_Interrupted
def _interrupted():
    """Ctrl-C: 1 when Python shall have it (KeyboardInterrupt, or the program's own handler), 0 when the main thread
    waits within a call of ours, where Python would notice only afterwards: then the library ends the program."""
    if _signal.getsignal(_signal.SIGINT) is not _signal.default_int_handler:
        return 1
    frame = _sys._current_frames().get(_threading.main_thread().ident)
    waits = frame is not None and frame.f_code.co_filename.startswith(_FOLDER + _os.sep)
    return 0 if waits and frame.f_code.co_name not in ("run_program", "<module>") else 1


def await_end():
    """For threads that still run while another one ends the process: they shall not take what they see for failures."""
    while _is_ending:
        _real_sleep(1)


_is_ending = False


@_Ending
def _ending():
    """The process ends without Python's own end (a time limit, a signal): what was printed must not get lost."""
    global _is_ending
    _is_ending = True
    _flush()


def _flush():
    for stream in (_sys.stdout, _sys.stderr):
        try:
            stream.flush()
        except (AttributeError, OSError, ValueError):
            pass


def sleep(seconds, /):
    """Waits for `seconds`: on the robot's clock, where that is another than the wall clock (virtual time, a factor);
    else as Python does it."""
    nanoseconds = int(seconds * 1e9) if seconds >= 0 else -1
    if nanoseconds < 0 or not _wait(nanoseconds):
        _real_sleep(seconds)


def time_ns():
    """Nanoseconds: of the robot's clock, which starts at 0, where that is another than the wall clock; else since 1970,
    as Python has it."""
    now = _now()
    return now if now >= 0 else _real_time_ns()


def time():
    """time_ns() in seconds."""
    now = _now()
    return now / 1e9 if now >= 0 else _real_time()


_OURS = {_real_sleep: sleep, _real_time: time, _real_time_ns: time_ns}


def _take_over_time():
    """time.sleep(), time.time() and time.time_ns() for everybody; modules that took one by name get ours, too: they
    are of the program, or do not mind. threading, which counts by time.monotonic(), is left alone."""
    _time.sleep, _time.time, _time.time_ns = sleep, time, time_ns
    for module in list(_sys.modules.values()):
        names = getattr(module, "__dict__", None)
        if not isinstance(names, dict) or module is _time or names.get("__name__") == __name__:
            continue
        for name in ("sleep", "time", "time_ns"):
            value = names.get(name)
            if type(value) is type(_real_sleep) and value in _OURS:
                names[name] = _OURS[value]


def _take_over_threads():
    """Threads take turns on the robot's clock, where that is virtual: each has its first one when it begins to run."""
    start = _threading.Thread.start

    @_functools.wraps(start)
    def start_in_turn(self):
        expected = _expected()
        if expected is None:
            return start(self)
        run, own = self.run, self.__dict__.get("run")

        def give_back():
            if own is None:
                del self.run
            else:
                self.run = own

        def run_in_turn():
            give_back()
            _starts(expected)
            run()

        self.run = run_in_turn
        try:
            start(self)
        except BaseException:
            give_back()
            _failed(expected)
            raise
        finally:
            _started(expected)

    _threading.Thread.start = start_in_turn


def _command():
    """The file of the robot program and its arguments; nothing when there is no file (python3 -c, a console)."""
    file = getattr(_sys.modules.get("__main__"), "__file__", None) or ""
    by_module = not file and _sys.argv[:1] == ["-m"] and "eye" in _sys.orig_argv  # python3 -m eye prog.py
    if by_module or file.endswith("/eye/__main__.py"):
        return _sys.argv[1:]
    return [file, *_sys.argv[1:]] if file else []


def _begin_host():
    command = [_os.fsencode(word) for word in _command()]
    _begin(_os.path.abspath(command[0]) if command else b"", _interrupted, _ending)
    _flush()  # this process may become another
    _start(len(command), (_ctypes.c_char_p * len(command))(*command), _os.fsencode(_sys.executable or ""))


def _at_exit():
    _flush()
    _end()


_begin_host()
_atexit.register(_at_exit)
_take_over_time()
_take_over_threads()
