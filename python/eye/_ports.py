"""SER, AU, DIGITAL, ANALOG, IRTV, RADIO: lines, sounds and messages."""

import ctypes as _ctypes

from . import _convert
from ._library import C as _C
from ._readings import failure as _failure

_MOST_TEXT = 1024  # bytes of a message, as other generations of `eye` have it
_MOST_SAMPLES = 10_000_000  # that ANALOGRecord() takes


def _decoded(data):
    return data.decode("utf-8", "replace")


def SERInit(interface, baud, handshake):
    """Opens interface 0 (the serial port) or 1..20 (USB) at a baud rate, handshake NONE or RTSCTS."""
    return _C.SERInit(interface, baud, handshake)


def SERSendChar(interface, ch):
    """Sends one character: a str, bytes or a number."""
    return _C.SERSendChar(interface, ch)


def SERSend(interface, buf, size=None):
    """Sends a string (its first size bytes, where an older program says how many)."""
    data = _convert.Text.from_param(buf)
    return _C.SERSend(interface, data if size is None or data is None else data[: int(size)])


def SERReceiveChar(interface):
    """Receives one character, as str."""
    return _C.SERReceiveChar(interface).decode("latin-1")


def SERReceive(interface, buf=None, size=_MOST_TEXT):
    """Receives at most size bytes, as str. Given a ctypes buffer, fills it in and returns how many came."""
    if buf is None or isinstance(buf, str):
        memory = _ctypes.create_string_buffer(max(int(size), 0) + 1)
        count = _C.SERReceive(interface, memory, size)
        return _decoded(memory.raw[: max(count, 0)])
    if isinstance(buf, _ctypes.Array):
        size = min(int(size), _ctypes.sizeof(buf))
    return _C.SERReceive(interface, buf, size)


def SERCheck(interface):
    """True when something has come (or the line is ready: see eyebot.h)."""
    return _C.SERCheck(interface)


def SERFlush(interface):
    """Drops what has come and was not received yet."""
    return _C.SERFlush(interface)


def SERClose(interface):
    """Closes the interface."""
    return _C.SERClose(interface)


def AUBeep():
    """Beeps."""
    return _C.AUBeep()


def AUPlay(filename):
    """Plays a sound file in the background."""
    return _C.AUPlay(filename)


def AUDone():
    """1 when nothing is being played any more."""
    return _C.AUDone()


def AUMicrophone():
    """The microphone's present value."""
    return _C.AUMicrophone()


def DIGITALSetup(io, direction):
    """Makes line 1..16 an input ('i', 'I' with pull-up, 'J' with pull-down) or an output ('o')."""
    return _C.DIGITALSetup(io, direction)


def DIGITALRead(io):
    """State of line 1..16."""
    return _C.DIGITALRead(io)


def DIGITALReadAll():
    """All lines, a bit each."""
    return _C.DIGITALReadAll()


def DIGITALWrite(io, state):
    """Sets output 1..16 to 0 or 1."""
    return _C.DIGITALWrite(io, state)


def ANALOGRead(channel):
    """Value of analog channel 0..8; 0 is the supply, 8 the microphone."""
    return _C.ANALOGRead(channel)


def ANALOGVoltage():
    """Supply voltage in 0.01 V; -1 on failure."""
    return _C.ANALOGVoltage()


def ANALOGRecord(channel, iterations):
    """Starts to record a channel in the background, 1000 values a second."""
    return _C.ANALOGRecord(channel, iterations)


def ANALOGTransfer(buffer=None):
    """What was recorded, as bytes. Given a buffer of the program, puts there what has room and returns how much."""
    if _convert.is_pointer(buffer):
        return _C.ANALOGTransfer(buffer)
    memory = (_ctypes.c_ubyte * _MOST_SAMPLES)()
    samples = _ctypes.string_at(memory, max(_C.ANALOGTransfer(memory), 0))
    if buffer is None:
        return samples
    view = memoryview(buffer).cast("B")
    count = min(len(view), len(samples))
    view[:count] = samples[:count]
    return count


def IRTVGet():
    """Waits for a key of the remote control and returns its code."""
    return _C.IRTVGet()


def IRTVRead():
    """Code of a key of the remote control, 0 when there was none."""
    return _C.IRTVRead()


def IRTVFlush():
    """Drops the codes that have come."""
    return _C.IRTVFlush()


def IRTVGetStatus():
    """1 when the receiver is on."""
    return _C.IRTVGetStatus()


def RADIOInit():
    """Starts the radio. 0, or 1 on failure."""
    return _C.RADIOInit()


def RADIOGetID():
    """This robot's number."""
    return _C.RADIOGetID()


def RADIOSend(id, buf):
    """Sends a string to a robot."""
    return _C.RADIOSend(id, buf)


def RADIOReceive():
    """Waits for a message: [number of the sender, text]. RobotError without a radio, and before RADIOInit()."""
    sender = _ctypes.c_int()
    memory = _ctypes.create_string_buffer(_MOST_TEXT + 1)
    if _C.RADIOReceive(_ctypes.byref(sender), memory, _MOST_TEXT + 1) < 0:
        raise _failure("RADIOReceive")
    return [sender.value, _decoded(memory.value)]


def RADIOCheck():
    """1 when a message waits, 0 when none does, -1 on failure."""
    return _C.RADIOCheck()


def RADIOStatus():
    """[number of robots with this one, their numbers: a ctypes array of 256 ints]."""
    ids = (_ctypes.c_int * 256)()
    return [_C.RADIOStatus(ids), ids]


def RADIORelease():
    """Stops the radio."""
    return _C.RADIORelease()
