#!/usr/bin/env python3
"""The motions of tests/parity on boards that nobody here wrote: rows of the table in docs/parity.md.

usage: parity.py FOLDER_OF_PROGRAMS [--jobs 4] [--short]
Compares where the robot truly is at the end with the same binary in the simulation. Fails beyond 2 % of the path (2 mm for turns) or
2 degrees, when the program believes to be elsewhere, when it says that something was missed, and when one of the two refused a frame of
the other. --short leaves out the square.
"""
import argparse
import concurrent.futures
import csv
import math
import pathlib
import re
import subprocess
import sys
import tempfile

from judged_board import io7_board, spec_node

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORLD = ROOT / "worlds/empty-room.wld"
# Of tests/parity/moves.c and the examples; those that go by ranges need a world, which these boards lack.
MOVES = {"forwards": 0, "backwards": 1, "turn left": 2, "turn right": 3, "curve": 4, "backwards, curved": 5, "drive to": 6,
         "replaced": 7, "set speed": 9}
# These end by the clock: a slow line begins them later, and the robot on CAN stops without a ramp.
BY_CLOCK = {"replaced", "set speed"}
BOARDS = {
    "judge, IO7": (io7_board, ()),
    "judge, IO7, 16 ms": (io7_board, ("--latency", "16")),
    "judge, CAN": (spec_node, ()),
}
LIMIT, LEAST_MM, LIMIT_DEGREES = 0.02, 2.0, 2.0
BELIEVED_MM, BELIEVED_DEGREES = 10.0, 2.0
BELIEVES = re.compile(r"believes (\S+) (\S+) (\S+)")


def command_of(programs, task):
    if task == "square":
        return [programs.parent / "examples/square"]
    return [programs / "parity_moves", str(MOVES[task])]


def run(command, folder, environment):
    return subprocess.run(command, capture_output=True, text=True, cwd=folder, timeout=120,
                          env={"PATH": "/usr/bin:/bin", **environment})


def simulated(programs, task):
    """Where the simulated robot ends, seen from where it started: x, y in mm, degrees; and its path in mm."""
    with tempfile.TemporaryDirectory() as folder:
        ended = run(command_of(programs, task), folder,
                    {"EYEBRIDGE_WORLD": str(WORLD), "EYEBRIDGE_ROBOT": "S4", "EYEBRIDGE_FAST": "1", "EYEBRIDGE_OUT": folder})
        if ended.returncode != 0:
            raise RuntimeError(f"{task} in the simulation: {ended.stderr}")
        with open(f"{folder}/trace.csv") as trace:
            rows = [list(map(float, row[1:4])) for row in list(csv.reader(trace))[1:]]
    path = sum(math.dist(a[:2], b[:2]) for a, b in zip(rows, rows[1:]))
    x0, y0, phi0 = rows[0]
    dx, dy, phi = rows[-1][0] - x0, rows[-1][1] - y0, rows[-1][2] - phi0
    cos, sin = math.cos(phi0), math.sin(phi0)
    return (dx * cos + dy * sin) * 1000, (dy * cos - dx * sin) * 1000, math.degrees(phi), path * 1000


def wrong_with(board, ended, off, path, turned):
    """What is wrong with a run, `off` mm and `turned` degrees from the simulated one."""
    if ended.returncode != 0 or "eyebridge:" in ended.stderr or "missed" in ended.stdout:
        yield f"exit code {ended.returncode}: {ended.stdout} {ended.stderr}"
    if off > max(LIMIT * path, LEAST_MM) or turned > LIMIT_DEGREES:
        yield f"{off:.1f} mm and {turned:.1f} degrees off"
    if board.refused > 0:
        yield f"the board refused {board.refused} frames"
    if found := BELIEVES.search(ended.stdout):
        x, y, phi = map(float, found.groups())
        if math.dist((x, y), (board.x, board.y)) > BELIEVED_MM or abs(math.remainder(phi - board.phi, 360)) > BELIEVED_DEGREES:
            yield f"it believes to be at {x} {y} {phi} and is at {board.x} {board.y} {board.phi}"


def compare(programs, name, task, expected):
    """A row of the table, and what is wrong with it or None."""
    make, options = BOARDS[name]
    x, y, phi, path = expected
    with tempfile.TemporaryDirectory() as folder:
        with make(folder, options) as board:
            ended = run(command_of(programs, task), folder, {"EYEBRIDGE_HAL": board.hal})
    off = math.dist((board.x, board.y), (x, y))
    turned = abs(math.remainder(board.phi - phi, 360))
    row = f"| {name} | {task} | {path:.0f} | {off:.1f} | {100 * off / path if path > 10 else 0:.2f} | {turned:.2f} |"
    return row, next((f"{name}, {task}: {what}" for what in wrong_with(board, ended, off, path, turned)), None)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--jobs", type=int, default=4)
    parser.add_argument("--short", action="store_true")
    options = parser.parse_args()
    tasks = list(MOVES) if options.short else ["square", *MOVES]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        expected = dict(zip(tasks, pool.map(lambda task: simulated(options.programs, task), tasks)))
        cases = [(name, task) for name in BOARDS for task in tasks if name == "judge, IO7" or task not in BY_CLOCK]
        found = list(pool.map(lambda case: compare(options.programs, *case, expected[case[1]]), cases))
    print("\n".join(row for row, _ in found))
    wrong = [what for _, what in found if what]
    print("\n".join(wrong), file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
