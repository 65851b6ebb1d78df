"""Worlds and robots for Python. Metres, radians, seconds; x forward, y left, angles counter-clockwise."""

import os
from collections.abc import Callable, Sequence
from types import SimpleNamespace, TracebackType
from typing import Any, Literal, Self

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

class ConfigError(ValueError):
    """A mistake in a file: where it is, what was found, what was expected."""

class Scenario:
    """What a simulation starts from: a world, and robots at their places. Never changes."""

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the floor."""
    @property
    def robots(self) -> list[str]:
        """The name of each robot's model."""
    @property
    def walls(self) -> NDArray[numpy.float64]:
        """One row a wall: x and y of its ends. A copy."""
    @property
    def goals(self) -> NDArray[numpy.float64]:
        """One row a goal of a maze: x and y of the middle of its cell, metres. A copy; no row where its file names none."""
    @property
    def warnings(self) -> list[str]:
        """What was odd in the files and is read all the same."""

def load_scenario(
    path: str | os.PathLike[str], robot: str = "S4", *, strict: bool = True, cell: float | None = None
) -> Scenario:
    """Reads a .wld, .maz, .sim, .robi, .esObj or EyeSim parameter file, or the maze of a contest (docs/formats.md), and all
    that it names. `cell` is the size of the maze's cells, 0.01 to 100 m, whatever its file says. A `path` that does not exist is
    looked for by name, also in the folder worlds beside the script that runs (docs/worlds.md). A world without robots
    gets one `robot`. Raises ConfigError for the first line that is wrong. Where `strict` is False, a wrong line is left
    out and is one of the `warnings` (docs/worlds.md); ConfigError is raised only when nothing of the file can be used."""

def default_scenario() -> Scenario:
    """An empty room, 2 m x 2 m, and one S4 in its middle."""

class Camera:
    """A robot's camera: pictures of the world as it is when they are asked for."""

    def frame(self) -> NDArray[numpy.uint8]:
        """The next picture, height x width x 3 (R, G, B): a read-only view of the frame's own memory, which stays as it
        is. Noise follows from the seed and the number of frames since the last reset()."""
    @property
    def size(self) -> tuple[int, int]:
        """Width and height, pixels."""

class Robot:
    """One robot of a simulation."""

    @property
    def index(self) -> int:
        """Its row in poses and twists."""
    @property
    def name(self) -> str:
        """Of its model."""
    @property
    def radius(self) -> float:
        """Of the disc that it is."""
    @property
    def pose(self) -> tuple[float, float, float]:
        """x, y, theta in the world: the truth."""
    @property
    def twist(self) -> tuple[float, float]:
        """Linear and angular speed as driven in the last step."""
    @property
    def odometry(self) -> tuple[float, float, float]:
        """x, y, theta by its wheels; starts at 0, 0, 0."""
    @property
    def distance(self) -> float:
        """The way driven since the start, forwards and back."""
    @property
    def collisions(self) -> int:
        """New contacts since the start."""
    @property
    def driving(self) -> bool:
        """A drive() is under way."""
    @property
    def failed(self) -> bool:
        """The last drive() was given up: stalled for too long."""
    @property
    def stalled(self) -> bool:
        """An obstacle holds a wheel."""
    @property
    def encoders(self) -> tuple[int, int]:
        """Ticks, left and right. Raises IndexError for a submarine, which has none."""
    def set_pose(self, x: float, y: float, theta: float) -> None:
        """Puts the robot somewhere, at rest; nothing is checked, and odometry does not notice."""
    def set_speed(self, linear: float, angular: float = 0.0) -> None:
        """Drives until the next command, within the model's limits."""
    def drive(self, distance: float = 0.0, angle: float = 0.0, speed: float = 0.3) -> None:
        """Drives a straight, a turn on the spot (distance 0; radians a second) or an arc, and stops."""
    def set_wheels(self, left: float, right: float) -> None:
        """Duty of the left and the right motor (of a submarine: thruster), -1 … 1."""
    @property
    def drive_kind(self) -> Literal["differential", "ackermann", "omni", "swedish", "synchro", "submarine"]:
        """What wheels it has: docs/drives.md, which has the numbers of motors and encoders, too."""
    @property
    def motor_count(self) -> int: ...
    @property
    def encoder_count(self) -> int: ...
    @property
    def ticks_per_revolution(self) -> float:
        """Encoder ticks a turn of a wheel."""
    @property
    def body_twist(self) -> tuple[float, float, float]:
        """Speed forward, to the left, and of turning, as driven in the last step."""
    @property
    def steering(self) -> float:
        """Where the front wheels of a car, or all of a synchro drive, point: radians from its front; 0 for others."""
    @property
    def depth(self) -> float | None:
        """How far the upper side of a submarine is below the surface, metres; None for others."""
    def set_twist(self, linear: float, lateral: float = 0.0, angular: float = 0.0) -> None:
        """set_speed() for drives that can go sideways: m/s forward and to the left, radians a second. Too much for a wheel
        is scaled down as a whole. Differential drives and cars leave `lateral` out; synchro ones steer there and do not turn."""
    def set_wheel(self, motor: int, speed: float) -> None:
        """Turns the wheel of motor 1 … `motor_count`, radians a second, until the next command; no faster than it can.
        Raises IndexError for no such motor."""
    def set_motor(self, motor: int, duty: float) -> None:
        """Duty of one motor, -1 … 1; beyond, it is clamped. Raises IndexError."""
    def set_steering(self, angle: float) -> None:
        """Turns the front wheels of a car, radians, left is positive; clamped. Raises ValueError for other drives."""
    def encoder(self, number: int) -> int:
        """Ticks of encoder 1 … `encoder_count`. Raises IndexError."""
    def reset_encoder(self, number: int) -> None:
        """It counts from 0 again; odometry does not notice. Raises IndexError."""
    def stop(self) -> None:
        """Motors off."""
    def set_errors(self, rules: str, scale: float = 1.0) -> None:
        """Changes the errors that it has now by rules as in docs/errors.md ("harsh", "psd:1 dropout=5%"), then scales
        all of them by 0 … 1. Raises ConfigError for bad rules. reset() brings back the scenario's."""
    def psd(self, id: int) -> float:
        """Range of a distance sensor by its number (`psd_ids`), with its error. Raises IndexError for none."""
    def psds(self) -> NDArray[numpy.float64]:
        """Ranges of all distance sensors, in the order of `psd_ids`."""
    @property
    def psd_ids(self) -> list[int]:
        """Numbers of the distance sensors."""
    def lidar(
        self, points: int | None = None, field_of_view: float | None = None, tilt: float | None = None
    ) -> NDArray[numpy.float64]:
        """A scan from the left-most ray clockwise to the right-most; a full circle starts behind. What is not given is
        the model's. Raises ValueError without a lidar and for values outside (1 … 36000 points)."""
    def range_matrix(self, id: int) -> NDArray[numpy.float64]:
        """Ranges of a time-of-flight matrix, metres along its axis, with their errors: eight rows, the top one first,
        of eight zones, the left-most first. Raises IndexError for none."""
    def compass(self) -> float:
        """Heading in the world, with its error."""
    def gyroscope(self) -> float:
        """Rate of turn in the last step, radians a second, with its error; the bias strays with time."""
    def accelerometer(self) -> tuple[float, float]:
        """Acceleration forward and to the left in the last step, m/s², with its errors; gravity is not in it."""
    def psd_probability(
        self, id: int, reading: ArrayLike, distance: ArrayLike, resolution: float = 0.001, cross_talkers: int | None = None
    ) -> Any:
        """P(reading | distance) of a distance sensor with its errors of now: of all readings within half a `resolution`.
        Arrays of any shapes that go together, or numbers, which give a number; `distance` may be inf: nothing there.
        `cross_talkers`: other ultrasound sensors in earshot; None is those of this moment. Raises IndexError for no such
        sensor, ValueError for a resolution that is not above 0."""
    def lidar_probability(self, reading: ArrayLike, distance: ArrayLike, resolution: float = 0.001) -> Any:
        """The same of a ray of the lidar. Raises ValueError without one."""
    def compass_probability(self, reading: ArrayLike, heading: ArrayLike, resolution: float = 0.01) -> Any:
        """P(reading | heading), on the circle."""
    def gyroscope_probability(
        self, reading: ArrayLike, rate: ArrayLike, resolution: float = 0.001, elapsed: float = 0.0
    ) -> Any:
        """P(reading | rate of turn), `elapsed` seconds after the robot came into its world: so long its bias strayed."""
    def accelerometer_probability(self, reading: ArrayLike, acceleration: ArrayLike, resolution: float = 0.01) -> Any:
        """P(reading | acceleration) of one axis."""
    def encoder_probability(self, ticks: ArrayLike, angle: ArrayLike, resolution: float = 1.0) -> Any:
        """P(ticks | angle in radians that the wheel has turned one way since its encoder began to count), by the ticks that
        it misses. Raises ValueError for an angle of more than 1e9 ticks."""
    def camera(self, width: int = 320, height: int = 240, options: str = "") -> Camera:
        """Its camera; options are those of --camera render: "light=0.4&fiducials=on". Raises ValueError without one."""

class Simulation:
    """A world with robots that move: commands in, readings out, one fixed step at a time.

    Use it with `with`, or close() it: then its memory is free, and every later call raises RuntimeError. Arrays stay."""

    def __init__(self, scenario: Scenario | None = None, *, seed: int = 1, step: float = 0.01) -> None:
        """Without a scenario, the default one. `step` is the length of a step. Raises ValueError."""
    def step(self, steps: int = 1) -> None:
        """Advances by so many steps."""
    def run(self, seconds: float) -> None:
        """Advances by the whole number of steps next to `seconds`."""
    def reset(self, seed: int | None = None) -> None:
        """Everything as at the start; robots and cameras stay usable. Another seed if one is given."""
    def close(self) -> None:
        """Frees the world."""
    def __enter__(self) -> Simulation: ...
    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None: ...
    @property
    def robots(self) -> list[Robot]:
        """All robots, in the order of the scenario."""
    @property
    def poses(self) -> NDArray[numpy.float64]:
        """x, y, theta of each robot: a read-only view, always of this moment; copy() what shall stay."""
    @property
    def twists(self) -> NDArray[numpy.float64]:
        """Linear and angular speed of each robot; a view like poses."""
    def psds(self) -> NDArray[numpy.float64]:
        """A reading of all distance sensors of all robots, metres: a row a robot, as its psds(), and faster than one after the
        other. NaN beyond a robot's sensors."""
    @property
    def objects(self) -> NDArray[numpy.float64]:
        """x, y, theta of each ball, can, box and polygon; of one that was removed as it was then. A copy."""
    def add_object(
        self,
        kind: str,
        x: float,
        y: float,
        theta: float = 0.0,
        *,
        size: tuple[float, float] | None = None,
        corners: Sequence[tuple[float, float]] | None = None,
        mass: float | None = None,
        friction: float | None = None,
        restitution: float | None = None,
        fixed: bool = False,
        lines: str = "",
    ) -> int:
        """Puts a "golf", "soccer", "can", "crate", "box" (then `size`: length and width) or "polygon" (then
        `corners`, x and y about its place, without a dent) there, now; its row in objects.
        `lines`: what more a .sim file can say of it (docs/worlds.md). reset() takes it away. Raises ValueError where there
        is no room, or it cannot be; ConfigError for wrong lines and corners."""
    def remove_object(self, object: int) -> None:
        """Takes an object out of the world, until reset(). Raises IndexError for one that is not there, as all of these do."""
    def set_object_pose(self, object: int, x: float, y: float, theta: float = 0.0) -> None:
        """Puts it somewhere, at rest; without a check."""
    def set_object_velocity(self, object: int, x: float, y: float) -> None:
        """Kicks it: metres a second in the world. Raises ValueError for what neither rolls nor slides by itself."""
    def set_object_fixed(self, object: int, fixed: bool = True) -> None:
        """Whether nothing pushes it away from now on. Raises ValueError for what moves by itself."""
    def change_object(self, object: int, lines: str) -> None:
        """How it behaves from now on: what may follow its line in a .sim file (docs/worlds.md). Raises ValueError for what
        cannot be, ConfigError for wrong lines."""
    def set_speeds(self, speeds: ArrayLike) -> None:
        """set_speed() for all robots: one row each, linear and angular."""
    def cast_rays(
        self, x: float, y: float, angles: ArrayLike, max_range: float = 9.999, ignore: int | None = None
    ) -> NDArray[numpy.float64]:
        """Exact range from (x, y) along each angle to the nearest wall or body, without the robot `ignore`."""
    @property
    def time(self) -> float:
        """Seconds since the start."""
    @property
    def seed(self) -> int:
        """Of all noise."""
    @property
    def step_length(self) -> float:
        """Seconds."""
    @property
    def state_hash(self) -> int:
        """Of everything that moves: equal runs have equal hashes."""


class OccupancyGrid:
    """How probable it is that something stands in each cell of a floor: a belief, or a map. Log-odds, ln(p / (1 - p))."""

    def __init__(
        self, width: float, height: float, *, resolution: float = 0.05, origin: tuple[float, float] = (0.0, 0.0),
        prior: float = 0.5, growing: bool = False, half_life: float = 0.0,
    ) -> None:
        """Nothing is known of a floor of `width` x `height` whose lower left corner is `origin`. `growing`: evidence beyond
        moves the bounds. `half_life`: seconds in which decay() halves what is known, 0 for never. Raises ValueError."""
    @staticmethod
    def truth_of(scenario: Scenario, *, resolution: float = 0.05, objects: bool = False) -> OccupancyGrid:
        """What stands in a scenario's world: its walls, and with `objects` its boxes, polygons and cans."""
    @staticmethod
    def load(path: str | os.PathLike[str]) -> OccupancyGrid:
        """Reads a ROS map (.yaml, with its .pgm) or .csv. Raises ConfigError; warns of what is odd."""
    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a ROS map (.yaml, and .pgm beside it), .csv or a picture (.png). Raises ConfigError, RuntimeError."""
    @property
    def resolution(self) -> float:
        """Edge length of a cell."""
    @property
    def origin(self) -> tuple[float, float]:
        """x, y of the lower left corner."""
    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
    @property
    def revision(self) -> int:
        """Counts changes."""
    @property
    def log_odds(self) -> NDArray[numpy.float32]:
        """All cells, [row, column] from the lower left one: a read-only view, always of this moment; of a grid that grows
        a copy."""
    @property
    def probabilities(self) -> NDArray[numpy.float64]:
        """The same as probabilities. A copy."""
    @property
    def picture(self) -> NDArray[numpy.uint8]:
        """The greys of ROS's maps: 0 occupied, 205 unknown, 254 free. A copy, [row, column] likewise."""
    def probability(self, x: float, y: float) -> float:
        """Of the cell at (x, y); the prior outside."""
    def state(self, x: float, y: float) -> Literal["free", "occupied", "unknown"]:
        """By ROS's thresholds, 0.196 and 0.65."""
    def set_probability(self, x: float, y: float, probability: float) -> None:
        """Makes a cell that probable. Raises IndexError outside, ValueError unless 0 … 1."""
    def update(self, x: float, y: float, probability: float) -> None:
        """Bayes' rule: `probability` of the cell by one reading alone. Raises ValueError."""
    def clear(self) -> None:
        """Everything back to the prior."""
    def decay(self, seconds: float) -> None:
        """What is known fades by the half-life."""
    def agreement(self, truth: OccupancyGrid, tolerance: int = 1) -> dict[str, Any]:
        """How much of this belief is right: {"observed": cells, "agreeing": cells, "share": 0 … 1}; walls may be found
        `tolerance` cells beside. Raises ValueError for grids whose cells do not lie alike."""
    def coverage(self, truth: OccupancyGrid, x: float, y: float) -> float:
        """Share of the cells that can be reached from (x, y), by `truth`, of which something is known."""

class RobotMapper:
    """Takes readings of a robot's sensors into grids, each by the inverse model of its own errors."""

    def __init__(self, robot: Robot) -> None: ...
    def insert_range(self, grid: OccupancyGrid, pose: tuple[float, float, float], sensor: int, range: float) -> None:
        """A reading of distance sensor `sensor` (0 is the first of `psd_ids`) of the robot at `pose`. NaN says nothing.
        Raises ValueError for a pose that is not finite or a grid that cannot grow, IndexError for no such sensor."""
    def insert_ranges(self, grid: OccupancyGrid, pose: tuple[float, float, float], ranges: ArrayLike) -> None:
        """Of all, as Robot.psds() gives them."""
    def insert_lidar(
        self, grid: OccupancyGrid, pose: tuple[float, float, float], ranges: ArrayLike, field_of_view: float = ...
    ) -> None:
        """A scan, as Robot.lidar() gives it; a full circle unless said otherwise."""

def plan(
    grid: OccupancyGrid, start: tuple[float, float], goal: tuple[float, float], *, radius: float = 0.0,
    method: Literal["astar", "theta_star", "dstar_lite", "wavefront", "rrt_star", "potential_field"] = "astar",
    unknown_blocks: bool = False, shorten: bool = False, seed: int = 1,
) -> NDArray[numpy.float64] | None:
    """A way for a robot of `radius` through what is not occupied (and not unknown, with `unknown_blocks`): way-points, one row
    each. None where no way is found; potential_field promises to find none, for it gets stuck. `shorten` takes out those that are not needed; `seed` is rrt_star's. Raises
    ValueError for ends that are outside or blocked. Sources of the methods: docs/mapping.md."""

def explore(
    grid: OccupancyGrid, position: tuple[float, float], *, radius: float = 0.0, smallest: int = 1
) -> NDArray[numpy.float64] | None:
    """The way over free cells to the nearest border of the unknown of at least `smallest` cells. None: all that can be
    reached is known. Raises ValueError where the robot stands in no free cell."""

class DStarLite:
    """Ways to one goal over a map that changes as it is explored: a plan anew searches only what the changes touch."""

    def __init__(
        self, grid: OccupancyGrid, goal: tuple[float, float], *, radius: float = 0.0, unknown_blocks: bool = False
    ) -> None:
        """As plan(); `grid` is looked at again in each plan(). Raises ValueError for a radius below 0."""
    def plan(self, start: tuple[float, float]) -> NDArray[numpy.float64] | None:
        """The shortest way from `start` by what the grid says now: way-points, one row each. None where there is none.
        Raises ValueError for ends that are outside or blocked, and for a grid that has grown."""
    @property
    def expanded(self) -> int:
        """Cells that the last plan() expanded: its work."""

class PurePursuit:
    """Follows a path by aiming at a place some way ahead on it."""

    def __init__(
        self, path: ArrayLike, *, lookahead: float = ..., speed: float = ..., max_angular: float = ...,
        deceleration: float = ..., tolerance: float = ...,
    ) -> None:
        """`path`: way-points, a pair each. Raises ValueError for none and for settings that are not positive."""
    def follow(self, pose: tuple[float, float, float]) -> tuple[float, float]:
        """Linear and angular speed to drive from `pose` until the next call; 0 once arrived."""
    @property
    def has_arrived(self) -> bool:
        """The last follow() was at the path's end."""

class MonteCarlo:
    """Where a robot is on a known map, by its odometry and scans: particles. Same seed, same calls: same bits."""

    def __init__(
        self, grid: OccupancyGrid, *, sigma: float = 0.05, max_range: float = 9.999, particles: int = 20000, seed: int = 1
    ) -> None:
        """On a map; beams end within about `sigma` of something occupied, and look as far as `max_range`. At most so many particles, which is also how many
        a start anywhere spreads. Raises ValueError, also where nothing is free. Starts anywhere."""
    def start_anywhere(self) -> None:
        """Forgets everything."""
    def start_at(self, pose: tuple[float, float, float], position_sigma: float = 0.1, heading_sigma: float = 0.1) -> None:
        """Forgets everything: it is there, give or take."""
    def predict(self, before: tuple[float, float, float], after: tuple[float, float, float]) -> None:
        """The robot moved, by its odometry, from `before` to `after`."""
    def correct(self, ranges: ArrayLike, bearings: ArrayLike) -> None:
        """It sees a scan: ranges along bearings in the robot; the full range, and more, is no hit. 60 hits are used."""
    @property
    def estimate(self) -> tuple[float, float, float]:
        """Mean of the heaviest cluster of particles."""
    @property
    def deviation(self) -> tuple[float, float]:
        """Its standard deviations: of the place, metres, and of the heading, radians."""
    @property
    def share(self) -> float:
        """That cluster's share of the belief, 0 … 1."""
    @property
    def particles(self) -> NDArray[numpy.float64]:
        """x, y, theta, weight, one row each. A copy."""

class LandmarkEkf:
    """Where a robot is, by its odometry and by landmarks that it can tell apart: an extended Kalman filter. Same calls: same
    bits."""

    def __init__(
        self, pose: tuple[float, float, float], *, position_sigma: float = 0.1, heading_sigma: float = 0.1
    ) -> None:
        """It starts at `pose`, give or take. Raises ValueError for deviations below 0."""
    def predict(self, before: tuple[float, float, float], after: tuple[float, float, float]) -> None:
        """The robot moved, by its odometry, from `before` to `after`."""
    def update(
        self, landmark: tuple[float, float], range: float, bearing: float, *, range_sigma: float = 0.02, bearing_sigma: float = 0.02
    ) -> bool:
        """It sees the landmark that stands at `landmark`, from its centre, `bearing` from its front. Whether that was
        believed: 99 % of right sightings are. Raises ValueError for a range or deviations that are not above 0."""
    @property
    def estimate(self) -> tuple[float, float, float]:
        """The pose."""
    @property
    def covariance(self) -> NDArray[numpy.float64]:
        """Of x, y and theta, 3 x 3. A copy."""
    def nees(self, truth: tuple[float, float, float]) -> float | None:
        """Normalised estimation error squared: of an honest filter chi-square with 3 degrees, 3 on average. None where the
        covariance is not positive definite."""

class ScanMatcher:
    """Fits scans into a map: where was the robot, near a guess? Never changes."""

    def __init__(
        self, grid: OccupancyGrid, *, window: float = 0.25, turn_window: float = ..., sigma: float = 0.05, least_score: float = 0.4
    ) -> None:
        """`window`: how far off a guess may be along x and y; `turn_window`: its heading (20°). What fits within `sigma`
        counts; a score below `least_score` (0 … 1) is no match. Raises ValueError."""
    def match(
        self, guess: tuple[float, float, float], ranges: ArrayLike, bearings: ArrayLike, *, max_range: float = 9.999
    ) -> tuple[tuple[float, float, float], float] | None:
        """The pose near `guess` that a scan is from, and its score, 0 … 1. None: it fits nowhere there. Ranges of
        `max_range` are no hits. Raises ValueError."""

class GridSlam:
    """Draws a map of an unknown floor while finding out where the robot is on it; closes no loops. Same calls: same bits."""

    def __init__(
        self, grid: OccupancyGrid, start: tuple[float, float, float], *, max_range: float = 9.999, sigma: float = 0.01
    ) -> None:
        """A map with the bounds, cells and settings of `grid`, not its values; the robot is at `start` by definition. Its
        scanner looks as far as `max_range` and errs by `sigma`. Raises ValueError."""
    def add(self, odometry: tuple[float, float, float], ranges: ArrayLike, bearings: ArrayLike) -> Literal["added", "skipped", "unmatched"]:
        """The robot sees a scan where its odometry is at `odometry`. "skipped": it has hardly moved; "unmatched": the scan
        fits nowhere, the pose goes by odometry. Raises ValueError, and RuntimeError for a map that would grow too large."""
    @property
    def pose(self) -> tuple[float, float, float]:
        """Where the robot is on the map."""
    @property
    def map(self) -> OccupancyGrid:
        """A copy."""
    @property
    def unmatched(self) -> int:
        """How many scans fitted nowhere."""

class DynamicWindow:
    """Chooses speeds among those that the motors reach within a period and from which the robot can still stop."""

    def __init__(
        self, grid: OccupancyGrid, *, radius: float = ..., speed: float = ..., max_angular: float = ..., acceleration: float = ...,
        angular_acceleration: float = ..., period: float = ..., tolerance: float = ...,
    ) -> None:
        """Around what is occupied in `grid`, which may change between two choices. Raises ValueError for settings that are
        not positive."""
    def choose(
        self, pose: tuple[float, float, float], now: tuple[float, float], goal: tuple[float, float]
    ) -> tuple[float, float, bool]:
        """Linear and angular speed for the next `period`, from `pose` while driving `now`; and whether it brakes: at the
        goal, or since nothing else is safe. Like all local methods it may get stuck: give it a goal some way ahead on a
        path. Raises ValueError for what is not finite."""

class Episode(Simulation):
    """A simulation with a reward that is asked after every step and summed up."""

    reward: Callable[[Self], float] | None
    total_reward: float
    """Sum since the last reset()."""
    def __init__(
        self, scenario: Scenario | None = None, *, seed: int = 1, step: float = 0.01, reward: Callable[[Self], float] | None = None
    ) -> None: ...
    def step_until(self, done: Callable[[Self], object], seconds: float) -> bool:
        """Steps until `done(episode)` holds, asked after each step, and says whether it does; or for the whole number of
        steps next to `seconds`, at least one."""

class VectorEnv:
    """`num_envs` worlds with one robot each that acts (others stand), as Gymnasium's vectorised environments are used;
    it is one where Gymnasium is installed. One thread at a time. Same seeds and actions: same bits."""

    num_envs: int
    observation_space: Any
    """A gymnasium.spaces.Box, or ours with low, high, shape, dtype, sample(), contains(); (num_envs, ...)."""
    action_space: Any
    single_observation_space: Any
    single_action_space: Any
    metadata: dict[str, Any]
    def __init__(
        self,
        scenario: Scenario | Sequence[Scenario] | None = None,
        num_envs: int = 1,
        *,
        observation: str = "psd speed",
        action: Literal["speed", "wheels"] = "speed",
        reward: Callable[[SimpleNamespace], ArrayLike] | None = None,
        terminated: Callable[[SimpleNamespace], ArrayLike] | None = None,
        start: Literal["scenario", "anywhere"] = "scenario",
        period: float = 0.1,
        time_limit: float = 60.0,
        step: float = 0.01,
        autoreset: Literal["next_step", "same_step", "disabled"] = "next_step",
        threads: int = 0,
    ) -> None:
        """World i has scenario i modulo their number. `observation`: words of psd, lidar, lidar:N, bumper, compass,
        gyroscope, accelerometer, speed, odometry, pose. `action`: linear and angular speed, or the duty of both motors.
        `period`: between two actions; `time_limit` truncates. `reward` and `terminated` get what the step came to, one row
        a world (observations, actions, poses, distances, collisions, times, rewards, seeds), and give N values; without
        them the way driven is the reward, and a collision the end. `start`: where the scenario says, or at a free place by
        the seed. `threads`: 0 is one a core. Raises ValueError."""
    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[numpy.float64], dict[str, Any]]:
        """World i begins with `seed` + i; without a seed each world goes on to its next episode. `options`:
        {"reset_mask": N booleans} for some worlds alone."""
    def step(
        self, actions: ArrayLike
    ) -> tuple[NDArray[numpy.float64], NDArray[numpy.float64], NDArray[numpy.bool_], NDArray[numpy.bool_], dict[str, Any]]:
        """One period: observations, rewards, terminated, truncated, info (pose, distance, collisions, time, seed).

        A world whose episode is over begins the next one in the next step, which takes no action and gives reward 0
        ("next_step"); at once, with the last observation in info["final_obs"] ("same_step"); or when reset() says
        ("disabled"). Raises ValueError for actions of another shape than (num_envs, 2), or not finite."""
    def close(self) -> None:
        """Frees the worlds."""
