#!/usr/bin/env python3
"""Ends robot programs in every way there is: do the robot's wheels stand? On the IO7 board of shared/judges, which has no watchdog,
or with --can on the robot from SPECIFICATION.md alone.

usage: ends.py FOLDER_OF_PROGRAMS [--can] [--runs 1] [--jobs 4] [--limit MS]
Prints a table: per way the time from the end, or from when a deaf board hears again, until the board was told 0; on CAN until it stood. Fails
when a board was not told at all, an exit code or a message is not the expected one; with --limit also when it took longer.
"""
import argparse
import concurrent.futures
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import time

from judged_board import IO7, io7_board, spec_node

PATIENCE_S = 20.0
# The boards write down each command that they hear; where the disk is busy they would be deaf meanwhile (2.6 s once).
IN_MEMORY = pathlib.Path("/dev/shm")
DEAD_AT_S, DEAD_FOR_S = 0.1, 1.5  # from the first command that drives
MOTORS = range(1, 5)
GONE = "the program is gone"
UNSURE = "may still be moving"

# way: (what ends it, whether the board is deaf meanwhile, the exit code, what standard error must say)
PROGRAM = ["_exit", "quick_exit", "abort", "segv", "overflow", "exec", "fork"]
SIGNALS = ["KILL", "QUIT", "TERM", "INT", "HUP"]
CODES = {"abort": -signal.SIGABRT, "segv": -signal.SIGSEGV, "overflow": -signal.SIGSEGV}
WAYS = {
    "return": ("return", False, 0, ""),
    "exit": ("exit", False, 0, ""),
    **{way: (way, False, CODES.get(way, 0), GONE) for way in PROGRAM},
    **{f"SIG{name}": (name, False, -signal.Signals[f"SIG{name}"], "") for name in SIGNALS},
    "SIGSTOP": ("STOP", False, -signal.SIGKILL, "has been silent"),
    "return, deaf board": ("return", True, 1, UNSURE),
    "_exit, deaf board": ("_exit", True, 0, "does not answer"),
    "SIGKILL, deaf board": ("KILL", True, -signal.SIGKILL, "does not answer"),
}


class Log:
    """When the robot's wheels were told to turn or to stand, by its log."""

    def __init__(self, path, start):
        """`start` is when the times of an IO7 board begin, on the monotonic clock; those of spec_node are of that clock."""
        self.changes = []  # (time, whether they turn)
        told = {}
        for line in path.read_text().splitlines():
            words = line.split(maxsplit=3)
            if words[1] in ("ROLLS", "STANDS"):
                self.changes.append((float(words[0]), words[1] == "ROLLS"))
            elif len(words) == 4 and words[1] == "CMD" and words[2] in "mM":
                motor, value = eval(words[3])  # noqa: S307: a list that our own process wrote
                if motor in MOTORS:  # others, of a line that flips bits, the board refuses
                    told[motor] = value
                    self.changes.append((float(words[0]) + start, any(told.values())))

    def driven_at(self):
        """When the first command came that drives; None: never."""
        return next((when for when, turns in self.changes if turns), None)

    def stands_from(self, moment):
        """The first time after `moment` at which no wheel turns; None: one still does."""
        since, turned = moment, False
        for when, turns in self.changes:
            if turned and not turns:
                since = max(when, moment)
            turned = turns
        return None if turned else since


def one_run(programs, way, board_of):
    """Milliseconds until the wheels stood, and what was wrong."""
    what, deaf, code, message = WAYS[way]
    with tempfile.TemporaryDirectory(dir=IN_MEMORY if IN_MEMORY.is_dir() else None) as folder:
        folder = pathlib.Path(folder)
        options = ["--log", folder / "log"]
        if deaf:
            options += ["--dead", f"{DEAD_AT_S},{DEAD_FOR_S}"]
        with board_of(folder, options) as board:
            start = time.monotonic()
            try:
                ended, returned, said = run_program(programs, what, folder, deaf, board.hal)
            except TimeoutError:
                return None, f"{way}: waited in vain; it said: {(folder / 'err').read_text()}\n{(folder / 'log').read_text()[-2000:]}"
        log = Log(folder / "log", start)
        if log.driven_at() is None:
            return None, f"{way}: the board was never told to drive: {said}"
        reference = max(ended, log.driven_at() + DEAD_AT_S + DEAD_FOR_S) if deaf else ended
        stands = log.stands_from(reference)
        if stands is None:
            return None, f"{way}: motors were left running; it said: {said}"
        if returned != code or message not in said:
            return None, f"{way}: expected exit code {code} and '{message}', found {returned} and '{said}'"
        return (stands - reference) * 1000, None


def run_program(programs, what, folder, deaf, hal):
    """Runs the program and ends it: when it ended, its exit code, its standard error once its guard has ended, too."""
    with open(folder / "err", "w+") as errors:
        program = subprocess.Popen(
            [programs / "judged_ways", what], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors, text=True,
            cwd=folder, start_new_session=True, env={"EYEBRIDGE_HAL": hal, "PATH": "/usr/bin:/bin"})
        guard = None
        try:
            program.stdout.readline()
            await_that(lambda: guard_of(folder / "err"))  # it has its name a moment after it was started
            guard = guard_of(folder / "err")
            if deaf:
                await_that(lambda: " DEAD " in (folder / "log").read_text())
            ended = time.monotonic()
            if what.isupper():
                program.send_signal(signal.Signals[f"SIG{what}"])
                if what == "STOP":
                    await_that(lambda: "has been silent" in (folder / "err").read_text())
                    program.kill()
            else:
                program.stdin.write("\n")
                program.stdin.flush()
            returned = program.wait(PATIENCE_S)
            if not what.isupper():
                ended = time.monotonic()
            await_that(lambda: not any(os.path.exists(f"/proc/{process}/stat") for process in guard))  # exists() of a Path fails where it ends meanwhile
        finally:
            for process in holders_of(folder / "err"):  # the child of "fork"
                subprocess.run(["kill", "-9", str(process)], check=False, stderr=subprocess.DEVNULL)
            program.kill()
            program.wait()
            program.stdin.close()
            program.stdout.close()
        errors.seek(0)
        return ended, returned, errors.read().strip()


def holders_of(path):
    """The processes that have `path` as standard error."""
    found = []
    for process in filter(str.isdigit, os.listdir("/proc")):
        try:
            if os.readlink(f"/proc/{process}/fd/2") == str(path):
                found.append(int(process))
        except OSError:
            pass  # it has ended
    return found


def guard_of(errors):
    """The process ids of the guards that write into `errors`."""
    return [process for process in holders_of(errors) if name_of(process) == "eb:guard"]


def name_of(process):
    try:
        return pathlib.Path(f"/proc/{process}/comm").read_text().strip()
    except OSError:
        return ""  # it has ended


def await_that(holds):
    end = time.monotonic() + PATIENCE_S
    while not holds():
        if time.monotonic() > end:
            raise TimeoutError
        time.sleep(0.005)


def main():
    # What a shell starts in the background ignores these, and so would the programs.
    for number in (signal.SIGINT, signal.SIGQUIT):
        signal.signal(number, signal.SIG_DFL)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=4)
    parser.add_argument("--limit", type=float, metavar="MS")
    parser.add_argument("--way", action="append", choices=WAYS, help="only this one; may be given again")
    parser.add_argument("--can", action="store_true")
    options = parser.parse_args()
    if not IO7.exists():
        sys.exit(f"{IO7}: not found; expected the judges beside the project")
    board_of = spec_node if options.can else io7_board
    # A robot on CAN that hears nothing stops by itself, before its guard would.
    ways = options.way or [way for way, (what, deaf, *_) in WAYS.items() if not (options.can and (deaf or what == "STOP"))]
    failed = False
    print("| end | runs | median ms | longest ms |\n|---|---:|---:|---:|")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        runs = {way: [pool.submit(one_run, options.programs, way, board_of) for _ in range(options.runs)] for way in ways}
        for way in ways:
            results = [run.result() for run in runs[way]]
            times = [taken for taken, wrong in results if wrong is None]
            for wrong in {wrong for _, wrong in results if wrong is not None}:
                failed = True
                print(wrong, file=sys.stderr)
            if times:
                print(f"| {way} | {len(times)} | {statistics.median(times):.0f} | {max(times):.0f} |", flush=True)
            # A silent program is given half a second.
            limit = None if options.limit is None else options.limit + (500 if way == "SIGSTOP" else 0)
            if limit is not None and times and max(times) > limit:
                failed = True
                print(f"{way}: {max(times):.0f} ms, expected at most {limit:g}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
