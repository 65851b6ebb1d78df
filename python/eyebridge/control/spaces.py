"""belief_space and map_space: what robots believe of the floor, and what is really there; both answer alike."""

import math

from .objects import WorldObject
from .robots import COMMAND_COST, READ_COST, finite


def measures_distance(sensor):
    return sensor.kind in ("psd", "lidar")


class Space:
    """A grid of the floor with a probability in each cell that something stands there. x, y in metres, in the world."""

    def __init__(self, grid, turns, robots):
        self.grid = grid  # eyebridge.OccupancyGrid
        self._turns = turns
        self._robots = robots
        self._anchors = {}  # robot -> its pose here when it was put, and by its wheels then
        self.is_used = False  # something was put into its cells

    def set_robot(self, name, x=None, y=None, theta=None):
        """Puts a robot into this space: at a pose, or where it is by its wheels. From there it moves as its wheels do."""
        robot = self._robots(name)
        self._turns.spend(COMMAND_COST)
        if x is None and y is None and theta is None:
            self._anchors[robot] = robot._pose(), robot._pose()
        elif x is None or y is None:
            raise TypeError(f"set_robot({robot.name!r}): expected x, y and theta, or none of them")
        else:
            self._anchors[robot] = (finite("x", x), finite("y", y), finite("theta", theta or 0.0)), robot._pose()

    def robot(self, name):
        """x, y, theta of a robot in this space now; LookupError where it was never put."""
        robot = self._robots(name)
        self._turns.spend(READ_COST)
        if robot not in self._anchors:
            raise LookupError(f"{robot.name} is not in this space; expected set_robot({robot.name!r}) before")
        return self._pose_of(robot)

    @property
    def poses(self):
        """Of all robots in this space now: robot -> x, y, theta."""
        return {robot: self._pose_of(robot) for robot in self._anchors}

    def _pose_of(self, robot):
        """Where it was put, and what its wheels did since; where they say, if it never was."""
        now = robot._pose()
        if robot not in self._anchors:
            return now
        (x, y, theta), then = self._anchors[robot]
        turn = theta - then[2]
        dx, dy = now[0] - then[0], now[1] - then[1]
        return (
            x + dx * math.cos(turn) - dy * math.sin(turn),
            y + dx * math.sin(turn) + dy * math.cos(turn),
            math.remainder(theta + now[2] - then[2], math.tau),
        )

    def probability(self, x, y):
        """Of something at (x, y), 0 … 1; 0.5 where nothing is known."""
        self._turns.spend(READ_COST)
        return self.grid.probability(x, y)

    def is_occupied(self, x, y):
        self._turns.spend(READ_COST)
        return self.grid.state(x, y) == "occupied"

    def is_free(self, x, y):
        self._turns.spend(READ_COST)
        return self.grid.state(x, y) == "free"

    def is_known(self, x, y):
        self._turns.spend(READ_COST)
        return self.grid.state(x, y) != "unknown"

    def set(self, x, y, probability):
        """Makes the cell at (x, y) as probable as that."""
        self._turns.spend(COMMAND_COST)
        self.grid.set_probability(x, y, probability)
        self.is_used = True

    def clear(self):
        """Forgets everything."""
        self._turns.spend(COMMAND_COST)
        self.grid.clear()

    @property
    def log_odds(self):
        """A read-only numpy view of all cells, without a copy: [row, column] from the lower left one."""
        return self.grid.log_odds

    @property
    def resolution(self):
        """Edge length of a cell, metres."""
        return self.grid.resolution

    def save(self, path):
        """Writes it: .yaml (and .pgm, a ROS map), .png or .csv."""
        self.grid.save(path)


class MapSpace(Space):
    """What is there: the world's walls, or a map that was loaded; and the objects of the world, which are in no cell."""

    def __init__(self, grid, turns, robots, world):
        super().__init__(grid, turns, robots)
        self._world = world

    def add_object(self, kind, x, y, theta=0.0, **traits):
        """Puts a thing into the world: "golf", "soccer", "can", "crate", "box" (then `size`, its length and width) or
        "polygon" (then `corners`, x and y of each about its place), its middle at x, y. `mass`, `friction`,
        `restitution`, `fixed`, and `lines`, what more a .sim file can say of it (docs/worlds.md). The WorldObject; ValueError where there is no room, or it cannot be."""
        self._turns.spend(COMMAND_COST)
        return WorldObject(self._world, self._turns, self._world.add_object(kind, x, y, theta, **traits))

    @property
    def objects(self):
        """All objects that are there, those of the .sim file first."""
        self._turns.spend(READ_COST)
        numbers = range(1, self._world.object_count + 1)
        return [WorldObject(self._world, self._turns, n) for n in numbers if self._world.is_object_there(n)]

    def load(self, path):
        """Takes the map in a .yaml (ROS) or .csv file for the truth. Raises eyebridge.ConfigError."""
        self.grid = type(self.grid).load(path)


class BeliefSpace(Space):
    """What is believed: every cell unknown, until readings come in. Each sensor counts by its own error model."""

    def __init__(self, grid, turns, robots, mappers):
        super().__init__(grid, turns, robots)
        self._mappers = mappers  # index of a robot -> eyebridge.RobotMapper

    def update(self, name, *sensors):
        """Reads sensors of a robot (all that measure distances, if none are named) and takes what they say from where the
        robot is in this space; a robot that was never put here is where its wheels say. The readings, by sensor."""
        robot = self._robots(name)
        readings = {}
        for sensor in [robot.sensor(each) for each in sensors] or filter(measures_distance, robot.sensors):
            self._need_range(sensor)
            readings[sensor.name or f"{sensor.kind} {sensor.id}"] = reading = sensor.read()
            self.add(robot, sensor, reading, self._pose_of(robot))
        return readings

    def add(self, robot, sensor, reading, pose):
        """Takes one reading of a robot's sensor, by their names, made at `pose`: x, y, theta."""
        robot = self._robots(robot)
        sensor = robot.sensor(sensor) if isinstance(sensor, str) else sensor
        self._need_range(sensor)
        mapper = self._mappers(robot.index)
        self.is_used = True
        if sensor.kind == "lidar":
            mapper.insert_lidar(self.grid, pose, reading, robot._world.field_of_view(robot.index))
        else:
            mapper.insert_range(self.grid, pose, sensor.index, reading)

    @staticmethod
    def _need_range(sensor):
        if not measures_distance(sensor):
            raise ValueError(f"{sensor!r} measures no distance: expected a PSD, ultrasound, infrared or lidar")
