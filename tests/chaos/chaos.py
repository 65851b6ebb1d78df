#!/usr/bin/env python3
"""Robots, boards, cameras and windows under random kills, stops, full disks and lost lines: do the motors stop, are files whole,
does each message come once, does memory stay?

usage: chaos.py FOLDER_OF_PROGRAMS [--minutes 3] [--seed N]
Prints a table: what was done, how often, how often something was wrong; and what was wrong on standard error. The exit code is 1
if anything was, or if a kind of fault was never tried.
"""
import argparse
import collections
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
import traceback

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "judges"))

import boards  # noqa: E402
import fleets  # noqa: E402
import oracle  # noqa: E402


class Tally:
    """What was tried, and what went wrong. Any thread."""

    def __init__(self):
        self.lock = threading.Lock()
        self.tried = collections.Counter()
        self.wrong = collections.Counter()

    def add(self, fault, wrong):
        with self.lock:
            self.tried[fault] += 1
            if wrong:
                self.wrong[fault] += 1
                print(f"{fault}: {wrong}", file=sys.stderr, flush=True)


class Place:
    """Where a part of the test runs: programs, a folder of its own, its own dice, and until when."""

    def __init__(self, programs, folder, seed, until):
        self.programs, self.folder, self.dice, self.until = programs, folder, random.Random(seed), until
        folder.mkdir(parents=True)

    def has_time(self, seconds=0.0):
        return time.monotonic() + seconds < self.until

    def fresh_folder(self):
        return pathlib.Path(tempfile.mkdtemp(dir=self.folder))


def guarded(part, place, tally):
    try:
        part(place, tally)
    except Exception:  # noqa: BLE001: a part that breaks is a finding, and the others go on
        tally.add(part.__name__, traceback.format_exc())


def main():
    signal.signal(signal.SIGINT, signal.default_int_handler)  # what a shell starts in the background ignores these
    signal.signal(signal.SIGQUIT, signal.SIG_DFL)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--minutes", type=float, default=3.0)
    parser.add_argument("--seed", type=int, default=time.time_ns() % 1_000_000)
    options = parser.parse_args()
    print(f"seed {options.seed}", flush=True)
    tally = Tally()
    until = time.monotonic() + 60.0 * options.minutes
    parts = [boards.programs_end, boards.boards_fail, fleets.runs, fleets.lives, fleets.watched]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        threads = [
            threading.Thread(target=guarded, args=(part, Place(options.programs, folder / part.__name__, options.seed + i, until), tally))
            for i, part in enumerate(parts)
        ]
        for thread in threads:
            thread.start()
        try:
            for thread in threads:
                thread.join()
        except KeyboardInterrupt:
            # A program that stays would find the boards of the next run: pseudo-terminals get numbers again.
            subprocess.Popen = None  # the threads go on, and must start nothing more
            known = set()
            while new := {*oracle.children_of(os.getpid())} - known:  # children of one that is killed would be nobody's
                known |= new
                for one in new:
                    fleets.send(one, signal.SIGSTOP)
            for one in known:
                fleets.send(one, signal.SIGKILL)
            os._exit(130)
        tally.add("all has ended", oracle.left_over(folder))
    print("| fault | tried | wrong |\n|---|---:|---:|")
    for fault in sorted(tally.tried):
        print(f"| {fault} | {tally.tried[fault]} | {tally.wrong[fault]} |")
    never = sorted({*boards.FAULTS, *fleets.FAULTS} - set(tally.tried))
    if never:
        print(f"never tried: {', '.join(never)}; expected all in {options.minutes:g} minutes", file=sys.stderr)
    return 1 if never or tally.wrong.total() else 0


if __name__ == "__main__":
    sys.exit(main())
