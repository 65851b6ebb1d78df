"""SIM: the simulated world. mm from its lower-left corner, degrees; id 0 is the program's own robot."""

import ctypes as _ctypes

from ._library import C as _C
from ._live import SimValue as _SimValue

_Four = _ctypes.c_int * 4
_byref = _ctypes.byref


def SIMGetRobot(robot_id):
    """Pose of a robot: [x, y, z, phi], ints that also have `.value`. Zeros for an unknown id, on a real robot too."""
    pose = _Four()
    _C.SIMGetRobot(robot_id, pose, _byref(pose, 4), _byref(pose, 8), _byref(pose, 12))
    return [_SimValue(value) for value in pose]


def SIMSetRobot(robot_id, x, y, z=0, phi=0):
    """Puts a robot to a pose. 1 for an unknown id and on a real robot."""
    return _C.SIMSetRobot(robot_id, x, y, z, phi)


def SIMGetObject(obj_id):
    """Pose of an object: [x, y, phi] (without z, as programs expect), else as SIMGetRobot()."""
    pose = _Four()
    _C.SIMGetObject(obj_id, pose, _byref(pose, 4), _byref(pose, 8), _byref(pose, 12))
    return [_SimValue(value) for value in (pose[0], pose[1], pose[3])]


def SIMSetObject(obj_id, x, y, z=0, phi=0):
    """Puts an object to a pose. 1 for an unknown id and on a real robot."""
    return _C.SIMSetObject(obj_id, x, y, z, phi)


def SIMGetRobotCount():
    """Number of robots in the world."""
    return _C.SIMGetRobotCount()


def SIMGetObjectCount():
    """Number of objects in the world."""
    return _C.SIMGetObjectCount()


def SIMLaserScan():
    """360 distances in mm, as a list: 0 is the front, i the ray i degrees counter-clockwise. -1 everywhere when there
    is no lidar."""
    scan = (_ctypes.c_int * 360)()
    return scan[:] if _C.SIMLaserScan(scan) == 0 else [-1] * 360
