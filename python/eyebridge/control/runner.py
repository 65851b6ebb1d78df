"""Runs a control file: its world, its routines, and what is said when one of them fails."""

import inspect
import os
import sys
import time
import traceback
import types

from .. import ConfigError, _control
from .going import KeepGoing
from .interact import Interact
from .robots import Robot, find, plain
from .signals import watched
from .spaces import BeliefSpace, MapSpace
from .turns import Turns

GRACE = 2.0  # seconds of the world from when keep_going is false until routines that go on are ended
SHOWN_EVERY = 50_000_000  # nanoseconds of the world, of which windows show the two spaces
RESOLUTION = 0.05  # metres, of both spaces
PARAMETERS = ("robot", "keep_going", "belief_space", "map_space", "interact")


class ControlError(Exception):
    """What is wrong with a control file, in one line with its place."""


def load(path):
    """The module that the file is. ControlError for what cannot be read, compiled or has no run()."""
    module = types.ModuleType("__control__")
    module.__file__ = path
    try:
        with open(path, "rb") as file:
            code = compile(file.read(), path, "exec")
    except OSError as error:
        raise ControlError(f"{path}: {error.strerror}") from error
    except (SyntaxError, ValueError) as error:
        place = f"{path}:{error.lineno}:{error.offset}" if isinstance(error, SyntaxError) else path
        raise ControlError(f"{place}: {error.args[0]}") from error
    # Not by the file's name, which may be that of a module it imports.
    sys.modules["__control__"] = module
    sys.path.insert(0, os.path.dirname(os.path.abspath(path)))
    exec(code, module.__dict__)
    run = getattr(module, "run", None)
    if not callable(run):
        raise ControlError(f"{path}: found no function run, expected def run({', '.join(PARAMETERS)})")
    count = len(inspect.signature(run).parameters)
    if count != len(PARAMETERS):
        line = run.__code__.co_firstlineno
        raise ControlError(f"{path}:{line}: found run() with {count} parameters, expected {', '.join(PARAMETERS)}")
    return module


class Run:
    """One run of a control file."""

    def __init__(self, world, path):
        self.path = path
        self.world = world
        self.is_failed = False
        self._hang_limit = world.number("hang_limit")
        self._is_fast = world.setting("fast") == "true"
        self._limit = world.number("time_limit") if world.is_set("time_limit") else None
        self._asked = False
        self._interrupted = False
        self._shown = {}  # space -> what its window shows
        self.turns = Turns(world.step, round(world.step_length * 1e9), self._hang_limit)
        self.keep_going = KeepGoing(self.turns)
        self.interact = Interact(self.turns, not self._is_fast)
        robots = [Robot(world, self.turns, index, self._begin) for index in range(world.robot_count)]
        for robot in robots:
            world.set_odometry(robot.index, *world.truth(robot.index))
        self._robots = {plain(robot.name): robot for robot in robots} | {str(n + 1): r for n, r in enumerate(robots)}
        self._start = world.truth(0)[:2] if robots else None
        self._robot_of = {}  # routine -> the robot that it is of
        self._own_routines = {}  # robot -> the routine of its own function, the last one begun
        mappers = {}

        def mapper(index):
            changes = world.error_changes(index)
            if index not in mappers or mappers[index][0] != changes:
                mappers[index] = changes, world.mapper(index)
            return mappers[index][1]

        self.belief_space = BeliefSpace(world.belief(RESOLUTION), self.turns, self.robot, mapper)
        self.map_space = MapSpace(world.truth_grid(RESOLUTION), self.turns, self.robot, world)

    def robot(self, name):
        """The robot of that name ("Robot 1") or number; LookupError."""
        if isinstance(name, Robot):
            return name
        return find("robot", name, self._robots)

    def run(self, module):
        """Until all routines are over. 0, or 1 where one failed."""
        self._module = module
        self.turns.add("run", lambda: module.run(*self._arguments()))
        self.turns.run(self._before_step, self._tell_astray, self._tell_end)
        return int(self.is_failed)

    def interrupted(self, count):
        """Ctrl-C, or SIGTERM, for the first, second … time. Any thread."""
        if count > 1:
            print("eyebridge: stopped", file=sys.stderr)
            self.world.give_up()
            leave(130)
        self._interrupted = True
        self.world.resume()  # time may stand still

    def note_belief(self):
        """What the belief came to, for the run's report: how much of the world it knows, and how much of that is right."""
        if not self.belief_space.is_used or self._start is None or not self.world.is_set("report"):
            return
        truth = self.world.truth_grid(RESOLUTION)  # of map_space.grid a file may have made another
        try:
            found = self.belief_space.grid.agreement(truth)
            share = self.belief_space.grid.coverage(truth, *self._start)
        except (AttributeError, TypeError, ValueError) as error:  # the file's own grid, of another kind
            print(f"eyebridge: the belief cannot be compared with the world: {error}", file=sys.stderr)
            return
        self.world.note("coverage", share)
        self.world.note("observed", found["observed"])
        if found["observed"] > 0:
            self.world.note("agreement", found["share"])

    def _arguments(self):
        return self.robot, self.keep_going, self.belief_space, self.map_space, self.interact

    def _begin(self, robot, routine):
        function = routine or getattr(self._module, plain(robot.name).replace(" ", "_"), None)
        own = routine is None
        if function is None or (own and self._own_routine_goes_on(robot)):
            return
        if not callable(function):
            raise TypeError(f"{robot.name}: found {function!r}, expected a function({', '.join(PARAMETERS)})")
        begun = self.turns.add(robot.name, lambda: function(*self._arguments()))
        self._robot_of[begun] = robot
        if own:
            self._own_routines[robot] = begun

    def _own_routine_goes_on(self, robot):
        """Whether the file's function of this robot runs: start() within it, or again, begins no second one."""
        begun = self._own_routines.get(robot)
        return begun is not None and not begun.is_over and not begun.is_astray

    def _before_step(self):
        if self.world.has_windows and self.turns.now % SHOWN_EVERY < self.turns.step_length:
            self._show(self.world.show_belief, self.belief_space)
            self._show(self.world.show_map, self.map_space)
        if self._limit is not None and self.turns.now >= self._limit * 1e9:
            self._ask(f"the time limit of {self._limit:g} s")
        if self._interrupted:
            self._ask("Ctrl-C; again to stop at once")
        if self.world.is_closed:
            self._ask("its windows are closed")

    def _show(self, show, space):
        """A space in its window, when it has changed."""
        poses = space.poses
        try:
            now = space.grid.revision, poses
            if self._shown.get(space) != now:
                self._shown[space] = now
                show(space.grid, [(robot.index + 1, *pose) for robot, pose in poses.items()])
        except (AttributeError, TypeError):
            pass  # the file's own grid, of another kind: its window keeps the last one that could be shown

    def _ask(self, why):
        if self._asked:
            return
        self._asked = True
        print(f"eyebridge: {why}: the run ends", file=sys.stderr)
        self.keep_going.stop()
        self.turns.ask_to_end(GRACE)

    def _place(self, frames):
        """file:line of the innermost of `frames` that is the control file's."""
        own = [frame for frame in frames if frame.filename == self.path]
        return f"{self.path}:{own[-1].lineno}" if own else self.path

    def _halt(self, routine):
        """The robot of a routine that failed stands; all of them, where it was run()."""
        robot = self._robot_of.get(routine)
        for each in [robot] if robot is not None else dict.fromkeys(self._robots.values()):
            self.world.set_twist(each.index, 0.0, 0.0)

    def _tell_astray(self, routine):
        self.is_failed = True
        self._halt(routine)
        print(
            f"eyebridge: {self._place(routine.where())}: {routine.name} has computed for {self._hang_limit:g} s without a "
            "call; expected one that its time passes with (keep_going(), a sensor, interact.wait()): it is ended, the world "
            "goes on",
            file=sys.stderr,
        )

    def _tell_end(self, routine):
        if routine.error is None or routine.is_astray:
            return
        if isinstance(routine.error, SystemExit) and routine.error.code in (None, 0):
            return
        self.is_failed = True
        self._halt(routine)
        trace = traceback.extract_tb(routine.error.__traceback__)
        text = "".join(traceback.format_exception_only(routine.error)).strip()
        print(f"eyebridge: {self._place(trace)}: {routine.name}: {text}", file=sys.stderr)


def main(arguments):
    """`arguments`: the control file, and what it finds in sys.argv. The exit code."""
    path = os.path.normpath(arguments[0])
    sys.argv[:] = [path, *arguments[1:]]
    try:
        world = _control.World(path)
    except ConfigError as error:
        print(f"eyebridge: {error}", file=sys.stderr)
        return 1
    run = Run(world, path)
    follow_time(run.turns)
    try:
        module = load(path)
    except ControlError as error:
        print(f"eyebridge: {error}", file=sys.stderr)
        return 1
    except Exception as error:  # its first lines failed
        trace = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename == path]
        line = f":{trace[-1].lineno}" if trace else ""
        print(f"eyebridge: {path}{line}: {type(error).__name__}: {error}", file=sys.stderr)
        return 1
    try:
        world.open_windows()
    except ConfigError as error:
        print(f"eyebridge: {error}", file=sys.stderr)
        return 1
    def work():
        code = run.run(module)
        run.note_belief()
        world.end()
        return code

    code = watched(work, run.interrupted)
    # Windows stay until a person closes them, or presses Ctrl-C.
    watched(lambda: world.finish("ended" if code == 0 else f"ended with {code}"), lambda _count: leave(code))
    return code


def leave(code):
    """Ends the process now, whatever its threads do."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


def follow_time(turns):
    """time.sleep() and time.time() of routines are the world's; other threads keep their own."""
    sleep, now, began = time.sleep, time.time, time.time()

    def sleep_here(seconds):
        if turns.routine is None:
            return sleep(seconds)
        if seconds < 0:
            raise ValueError("sleep length must be non-negative")
        turns.spend(seconds)

    time.sleep = sleep_here
    time.time = lambda: now() if turns.routine is None else began + turns.time
