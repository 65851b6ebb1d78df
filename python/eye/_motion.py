"""PSD, LIDAR, ENCODER, SERVO, MOTOR, VW: what senses and what moves. Millimetres, degrees (counter-clockwise
positive), milliseconds; 0 is success unless a function says otherwise. eyebot.h says all."""

import ctypes as _ctypes

from . import _convert
from ._library import C as _C
from ._library import variable as _variable
from ._readings import failure as _failure
from ._readings import pair as _pair

_lidar_points = _variable("LIDAR_RESOLUTION")
# The most that LIDARSet() takes: a timer or another thread may call it while a scan is made.
_Scan = _ctypes.c_int * 36000
_Three = _ctypes.c_int * 3
_byref = _ctypes.byref


def EYEBRIDGEGyroscopeGet():
    """Rate of turn, hundredths of a degree per second, counter-clockwise. Raises RobotError where there is no gyroscope."""
    rate = _ctypes.c_int()
    if _C.EYEBRIDGEGyroscopeGet(_ctypes.byref(rate)) != 0:
        raise _failure("EYEBRIDGEGyroscopeGet")
    return rate.value


def EYEBRIDGEAccelerometerGet():
    """Acceleration [forward, left], mm/s². Raises RobotError where there is no accelerometer."""
    return _pair("EYEBRIDGEAccelerometerGet", _C.EYEBRIDGEAccelerometerGet)


def EYEBRIDGERangeMatrixGet(matrix):
    """The 64 ranges of a time-of-flight matrix, mm along its axis: eight rows of eight zones, the top row first, each
    from the left; 9999 is nothing within reach. Raises RobotError where there is no such matrix, or it is lost."""
    ranges = (_ctypes.c_int * 64)()
    if _C.EYEBRIDGERangeMatrixGet(matrix, ranges) != 0:
        raise _failure("EYEBRIDGERangeMatrixGet")
    return ranges[:]


def PSDGet(psd):
    """Distance in mm of sensor PSD_FRONT …; -1 for a sensor that the robot does not have or has lost."""
    return _C.PSDGet(psd)


def PSDGetRaw(psd):
    """Raw value of a distance sensor."""
    return _C.PSDGetRaw(psd)


def LIDARGet():
    """A scan, mm, as a list: of 360 values 0 is behind, 90 left, 180 front, 270 right; 9999 is nothing hit. -1
    everywhere when there is no lidar or it is lost."""
    scan = _Scan()
    if _C.LIDARGet(scan) != 0:
        return [-1] * _lidar_points.value
    return scan[: _lidar_points.value]


def LIDARSet(angRange, tilt, numPoints):
    """Range 1..360 degrees centred on the front, tilt (positive down), number of points. 1 for values outside."""
    return _C.LIDARSet(angRange, tilt, numPoints)


def SERVOSet(servo, angle):
    """Sets servo 1..14 to a position 0..255."""
    return _C.SERVOSet(servo, angle)


def SERVOSetRaw(servo, angle):
    """As SERVOSet(), past the robot's table."""
    return _C.SERVOSetRaw(servo, angle)


def SERVORange(servo, low, high):
    """Pulse lengths of positions 0 and 255, 1/100 ms."""
    return _C.SERVORange(servo, low, high)


def MOTORDrive(motor, speed):
    """Drives motor 1..4 with -100..100 percent."""
    return _C.MOTORDrive(motor, speed)


def MOTORDriveRaw(motor, speed):
    """As MOTORDrive(), past the robot's table."""
    return _C.MOTORDriveRaw(motor, speed)


def MOTORPID(motor, p, i, d):
    """Parameters of a motor's speed controller, 0..255 each."""
    return _C.MOTORPID(motor, p, i, d)


def MOTORPIDOff(motor):
    """Switches the speed controller of a motor off."""
    return _C.MOTORPIDOff(motor)


def MOTORSpeed(motor, speed):
    """Drives a motor at a controlled speed in encoder ticks per 1/100 s, -128..127."""
    return _C.MOTORSpeed(motor, speed)


def ENCODERRead(quad):
    """Ticks of encoder 1..4 since the last reset."""
    return _C.ENCODERRead(quad)


def ENCODERReset(quad):
    """Sets an encoder to 0."""
    return _C.ENCODERReset(quad)


def VWSetSpeed(speed, angspeed):
    """Drives with mm/s and deg/s until the next command."""
    return _C.VWSetSpeed(speed, angspeed)


def VWGetSpeed(linSpeed=None, angSpeed=None):
    """Measured speeds: [mm/s, deg/s]. Given two ctypes ints, fills them in and returns 0. RobotError when the robot
    cannot say."""
    if linSpeed is None and angSpeed is None:
        return _pair("VWGetSpeed", _C.VWGetSpeed)
    return _C.VWGetSpeed(_convert.out(linSpeed), _convert.out(angSpeed))


def VWSetPosition(x, y, phi):
    """Declares the present pose to be x, y in mm, phi in degrees; the robot does not move."""
    return _C.VWSetPosition(x, y, phi)


def VWGetPosition(x=None, y=None, phi=None):
    """Pose by odometry: [x, y, phi] in mm and degrees. Given ctypes ints, fills them in and returns 0. RobotError
    when the robot cannot say."""
    if x is None and y is None and phi is None:
        pose = _Three()
        if _C.VWGetPosition(pose, _byref(pose, 4), _byref(pose, 8)) != 0:
            raise _failure("VWGetPosition")
        return pose[:]
    return _C.VWGetPosition(_convert.out(x), _convert.out(y), _convert.out(phi))


def VWStraight(dist, speed):
    """Drives dist mm straight on; backwards when dist is negative."""
    return _C.VWStraight(dist, speed)


def VWTurn(ang, speed):
    """Turns on the spot by ang degrees, left when positive."""
    return _C.VWTurn(ang, speed)


def VWCurve(dist, angle, speed):
    """Drives an arc of dist mm while turning by angle degrees."""
    return _C.VWCurve(dist, angle, speed)


def VWDrive(dx, dy, speed):
    """Drives an arc to the point dx ahead and dy to the left. 1 unless dx >= |dy|."""
    return _C.VWDrive(dx, dy, speed)


def VWRemain():
    """Distance still to go, mm."""
    return _C.VWRemain()


def VWDone():
    """1 when the command is finished or there is none, 0 while driving, -1 on failure."""
    return _C.VWDone()


def VWWait():
    """Waits until the command is finished. 1 when the robot is stuck."""
    return _C.VWWait()


def VWStalled():
    """Motors that are stuck: 0 none, 1 left, 2 right, 3 both."""
    return _C.VWStalled()


def VWControl(Vv, Tv, Vw, Tw):
    """Parameters of the v and w controllers."""
    return _C.VWControl(Vv, Tv, Vw, Tw)


def VWControlOff():
    """Switches the v-omega controller off."""
    return _C.VWControlOff()


VWDriveRemain = VWRemain
VWDriveDone = VWDone
VWDriveWait = VWWait
