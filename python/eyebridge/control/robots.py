"""robot("Robot 1"): what a control file commands, and what it reads."""

import difflib
import math
from collections import Counter

# What calls cost, seconds of the robot's time: what keeps a loop that only polls from standing still in virtual time.
READ_COST = 0.001
COMMAND_COST = 0.0001
SCAN_COST = 0.005

ONLY_ONE = ("lidar", "compass", "gyroscope", "accelerometer")  # kinds of which a robot has one: no number in their names
ROWS = ("lidar", "accelerometer")  # kinds that read more than one number
# How exactly a reading is known, unless said otherwise: metres, radians, radians a second, metres a second squared, ticks.
RESOLUTIONS = {"psd": 0.001, "lidar": 0.001, "compass": 0.01, "gyroscope": 0.001, "accelerometer": 0.01, "encoder": 1.0}



def plain(name):
    """As names are compared: "PSD_FRONT", "psd front" and "Psd-Front" are one."""
    return " ".join(str(name).lower().replace("_", " ").replace("-", " ").split())


def find(kind, name, known):
    """known[name], whatever its case; LookupError that lists what there is."""
    wanted = plain(name)
    if wanted in known:
        return known[wanted]
    near = difflib.get_close_matches(wanted, known, 1)
    hint = f"; most like it: {near[0]}" if near else ""
    raise LookupError(f"found no {kind} {str(name)!r}, expected one of: {', '.join(known) or '(there is none)'}{hint}")


class Reading(float):
    """A number that a sensor said: metres, radians, radians a second, ticks, or 1 and 0 for yes and no."""

    def __new__(cls, value, sensor, time):
        reading = super().__new__(cls, value)
        reading.sensor = sensor
        reading.time = time  # seconds since the start, of the routine that read it
        return reading


class Sensor:
    """A device of a robot by its name."""

    def __init__(self, robot, kind, index, id, name, pose, reach):
        self.robot = robot
        self.kind = kind  # "psd", "ir", "bumper", "lidar", "compass", "gyroscope", "accelerometer", "encoder"
        self.index = index  # among those of its kind, from 0
        self.id = id
        self.name = name
        self.pose = pose  # in the robot: x, y (metres), theta (radians)
        self.max_range = reach  # metres; 0: it measures no distance

    def read(self):
        """Now: a Reading. As numpy arrays: of the lidar its ranges, left-most first, clockwise; of the accelerometer what
        it feels forward and to the left."""
        self.robot._turns.spend(SCAN_COST if self.kind == "lidar" else READ_COST)
        value = self.robot._world.read(self.robot.index, self.kind, self.id)
        return value if self.kind in ROWS else Reading(value, self, self.robot._turns.time)

    def probability(self, reading, truth, resolution=None, elapsed=None):
        """P(reading | truth) with the errors that it has now: of all readings within half a `resolution`, which is
        0.001 for ranges (m) and the gyroscope (rad/s), 0.01 for the compass (rad) and the accelerometer (m/s²; of one
        axis), 1 for encoders (ticks; the truth is the angle in radians that the wheel has turned, one way). Numbers or
        numpy arrays of shapes that go together. `elapsed`: so many seconds the gyroscope's bias has strayed; all since the
        start, if not given. Cross-talk of ultrasound is not in it. Draws nothing: it changes no run. Raises ValueError."""
        if resolution is None:
            resolution = RESOLUTIONS.get(self.kind, 1.0)
        if elapsed is None:
            elapsed = self.robot._turns.time
        world = self.robot._world
        return world.probability(self.robot.index, self.kind, self.id, reading, truth, resolution, elapsed)

    @property
    def bearings(self):
        """Of the lidar's rays in the robot, radians, as read() orders them."""
        return self.robot._world.lidar_bearings(self.robot.index)

    def __repr__(self):
        return f"<{self.robot.name}: {self.name}>"


class Robot:
    """One robot of the world. Until start() it keeps what it is told, and stands.

    Metres, radians, seconds; x forward, y left, angles counter-clockwise.
    """

    def __init__(self, world, turns, index, begin):
        self.index = index  # from 0
        self.name = f"Robot {index + 1}"
        self.model = world.model_name(index)
        self.radius = world.radius(index)
        self.wheel_base = world.wheel_base(index)
        self.wheel_diameter = world.wheel_diameter(index)
        self.is_started = False
        self._world = world
        self._turns = turns
        self._begin = begin  # starts the routine of this robot
        self._wheels = {}  # what it was told before start()
        self._twist = None
        self._motors = {name: number for name, number in world.motors(index)}
        self._motors |= {str(number): number for number in self._motors.values()}
        self._encoders = {name: number for name, number in world.encoders(index)}
        self._encoders |= {str(number): number for number in self._encoders.values()}
        self._sensors = {}
        counts = Counter()
        for kind, id, name, pose, reach in world.sensors(index):
            sensor = Sensor(self, kind, counts[kind], id, name, pose, reach)
            counts[kind] += 1
            for each in plain(name), kind if kind in ONLY_ONE else f"{kind} {id}":
                if each:
                    self._sensors.setdefault(each, sensor)

    def start(self, routine=None):
        """Lets it move, and runs `routine(robot, keep_going, belief_space, map_space, interact)` beside everything else:
        the function that is given, or the control file's own of the robot's name, robot_1(...), where it has one."""
        self._turns.spend(COMMAND_COST)
        if not self.is_started:
            self.is_started = True
            for wheel, speed in self._wheels.items():
                self._world.set_wheel(self.index, wheel, speed)
            if self._twist is not None:
                self._world.set_twist(self.index, *self._twist)
            self._wheels, self._twist = {}, None
        self._begin(self, routine)
        return self

    def stop(self):
        """It stands, until the next start()."""
        self._turns.spend(COMMAND_COST)
        self._world.set_twist(self.index, 0.0, 0.0)
        self._wheels, self._twist = {}, None
        self.is_started = False

    def set_wheel(self, wheel, speed):
        """Turns a wheel (`motors`: "left", "right", or its number) at `speed`, radians a second, from now on; no faster
        than it can."""
        number = find(f"wheel of {self.name}", wheel, self._motors)
        speed = finite("speed", speed)
        self._turns.spend(COMMAND_COST)
        if self.is_started:
            self._world.set_wheel(self.index, number, speed)
        else:
            self._wheels[number], self._twist = speed, None

    def set_twist(self, linear, angular=0.0):
        """Drives at `linear` metres and `angular` radians a second from now on; no faster than it can."""
        twist = finite("linear", linear), finite("angular", angular)
        self._turns.spend(COMMAND_COST)
        if self.is_started:
            self._world.set_twist(self.index, *twist)
        else:
            self._wheels, self._twist = {}, twist

    def set_errors(self, rules, scale=1.0):
        """Changes the errors that its sensors and motors have now by rules as `--errors` takes them ("harsh", "psd:1
        sigma=20"), then scales all of them by 0 … 1; beliefs and probabilities follow. Raises ValueError for bad rules."""
        self._turns.spend(COMMAND_COST)
        self._world.set_errors(self.index, str(rules), float(scale))

    def wheel(self, wheel):
        """The angle that a wheel has turned by its encoder, radians."""
        number = find(f"wheel of {self.name} with an encoder", wheel, self._encoders)
        self._turns.spend(READ_COST)
        return self._world.wheel_angle(self.index, number)

    def sensor(self, name):
        """The device of that name: "PSD_FRONT", "psd 1", "lidar", "compass", "gyroscope", "accelerometer", "bumper 1",
        "ir 1", "encoder left"; or that device itself."""
        if isinstance(name, Sensor) and name.robot is self:
            return name
        return find(f"sensor of {self.name}", name, self._sensors)

    def read(self, name):
        """sensor(name).read()"""
        return self.sensor(name).read()

    @property
    def motors(self):
        """The names of its motors, which are those of its kind of drive: docs/drives.md."""
        return [name for name in self._motors if not name.isdigit()]

    @property
    def sensors(self):
        """All that it has."""
        return list(dict.fromkeys(self._sensors.values()))

    @property
    def pose(self):
        """Where it is by its wheels: x, y, theta in the world, begun with where it stood at first."""
        self._turns.spend(READ_COST)
        return self._pose()

    @property
    def true_pose(self):
        """Where it really is: what no real robot knows."""
        self._turns.spend(READ_COST)
        return self._world.truth(self.index)

    def _pose(self):
        return self._world.odometry(self.index)

    def __repr__(self):
        return f"<{self.name}, {self.model}>"


def finite(name, value):
    """The number, or TypeError, ValueError with what was expected."""
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"found {value!r} for '{name}', expected a finite number")
    return number
