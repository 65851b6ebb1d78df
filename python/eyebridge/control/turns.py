"""Routines of a control file that take turns: one runs at a time, in a fixed order, and the world advances when all wait.

A routine is a function in a thread of its own. It has a time, which passes with the calls it makes (spend()) and while it
waits; it runs until its time is beyond the step of the simulation that is next. So the same file, world and seed give the
same run, whatever the computer does meanwhile.
"""

import ctypes
import sys
import threading
import time
import traceback

NANOSECONDS = 1_000_000_000
LOOK = 0.2  # seconds between two looks at a routine that computes


class Stopped(BaseException):
    """Raised in a routine that has been asked politely, and goes on. Not an Exception: files that catch all go on."""


class Routine:
    """One function and its thread."""

    def __init__(self, turns, name, function, start):
        self.name = name
        self.now = start  # nanoseconds
        self.is_over = False
        self.is_astray = False  # it computes without a call: the others no longer wait for it
        self.is_outside = False  # it waits for something that is not the simulation's
        self.inside_since = 0.0  # on the computer's clock: since then it has been computing, or longer
        self.deadline = None  # nanoseconds: its next call from then on raises Stopped
        self.error = None
        self._turns = turns
        self._function = function
        self._may_run = threading.Semaphore(0)
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def begin(self):
        self._thread.start()

    def let_run(self):
        self._may_run.release()

    def wait_for_turn(self):
        self._may_run.acquire()

    def where(self):
        """What the routine is doing: the stack of its thread, the innermost frame last."""
        frame = sys._current_frames().get(self._thread.ident)
        return traceback.extract_stack(frame) if frame is not None else []

    def interrupt(self):
        """Raises Stopped in its thread wherever that is, as soon as it runs Python again."""
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread.ident), ctypes.py_object(Stopped))

    def _run(self):
        self.wait_for_turn()
        self._turns.here.routine = self
        try:
            self._function()
        except Stopped:
            pass
        except BaseException as error:  # SystemExit, too: what ends one routine is told, and ends no other
            self.error = error
        self.is_over = True
        self._turns.came_back(self)


class Turns:
    """Who runs when. The thread that calls run() is the world's; all else is called from routines."""

    def __init__(self, step, step_length, hang_limit):
        """`step()` advances the world by `step_length` nanoseconds; a routine that computes for `hang_limit` seconds
        without a call has gone astray."""
        self.here = threading.local()
        self.now = 0  # of the world, nanoseconds
        self._step = step
        self.step_length = step_length
        self._hang_limit = hang_limit
        self._routines = []
        self._back = threading.Semaphore(0)
        self._lock = threading.Lock()
        self._deadline = None  # of all routines, nanoseconds

    @property
    def routine(self):
        """The one that this thread is; None elsewhere."""
        return getattr(self.here, "routine", None)

    @property
    def time(self):
        """Seconds, of the routine that asks, else of the world."""
        routine = self.routine
        return (self.now if routine is None else max(routine.now, self.now)) / NANOSECONDS

    def add(self, name, function):
        """A routine that begins now, after those that are there."""
        caller = self.routine
        routine = Routine(self, name, function, self.now if caller is None else caller.now)
        routine.deadline = self._deadline
        self._routines.append(routine)
        routine.begin()
        return routine

    def spend(self, seconds):
        """Lets `seconds` pass for the routine that calls."""
        routine = self.routine
        if routine is None:
            return
        if routine.is_astray:
            raise Stopped
        routine.now = max(routine.now, self.now) + round(seconds * NANOSECONDS)
        self._check(routine)
        while routine.now >= self.now + self.step_length:
            self.came_back(routine)
            routine.wait_for_turn()
            if routine.is_astray:
                raise Stopped
            self._check(routine)

    def outside(self, wait, others_go_on):
        """wait(), for what takes a person's time, and its result: meanwhile the others go on, or the world stands still."""
        routine = self.routine
        if routine is None:
            return wait()
        routine.is_outside = True
        if others_go_on:
            self.came_back(routine)
        try:
            return wait()
        finally:
            routine.inside_since = time.monotonic()
            routine.is_outside = False
            if others_go_on:
                routine.wait_for_turn()
                routine.now = max(routine.now, self.now)
                self._check(routine)

    def came_back(self, routine):
        """The world's thread goes on: `routine` waits, or is over."""
        with self._lock:
            if not routine.is_astray:
                self._back.release()

    def ask_to_end(self, grace):
        """Every routine, of now or later, raises Stopped at the first call that is `grace` seconds from now, or later. Who
        waits for a person is not waited for any more."""
        self._deadline = self.now + round(grace * NANOSECONDS)
        for routine in self._routines:
            routine.deadline = self._deadline

    def run(self, before_step, tell_astray, tell_end):
        """Until all routines are over. `before_step()` is called between rounds; `tell_astray(routine)` and
        `tell_end(routine)` once for each."""
        while self._routines:
            for routine in list(self._routines):
                self._give_turn(routine, tell_astray)
            for routine in [each for each in self._routines if each.is_over or each.is_astray or self._is_left(each)]:
                self._routines.remove(routine)
                tell_end(routine)
            if not self._routines:
                return
            before_step()
            self._step()
            self.now += self.step_length

    def _give_turn(self, routine, tell_astray):
        is_due = routine.now < self.now + self.step_length or self._is_late(routine)
        if routine.is_over or routine.is_astray or routine.is_outside or not is_due:
            return
        routine.let_run()
        began = time.monotonic()
        while not self._back.acquire(timeout=min(LOOK, self._hang_limit)):
            if self._is_left(routine):
                return
            computed = time.monotonic() - max(began, routine.inside_since)
            if routine.is_outside or computed < self._hang_limit:
                continue  # or somebody thinks about an answer
            with self._lock:
                if self._back.acquire(blocking=False):
                    return
                routine.is_astray = True
            tell_astray(routine)
            routine.interrupt()
            return

    def _is_left(self, routine):
        """It waits for a person, and the run ends."""
        return routine.is_outside and routine.deadline is not None

    def _is_late(self, routine):
        return routine.deadline is not None and self.now >= routine.deadline

    def _check(self, routine):
        if self._is_late(routine):
            raise Stopped
