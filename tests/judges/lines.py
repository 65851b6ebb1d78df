#!/usr/bin/env python3
"""Drives a robot on the IO7 board of shared/judges over lines of all speeds: where is it, and where does it believe to be?

usage: lines.py FOLDER_OF_PROGRAMS [--runs 1] [--jobs 2] [--course leg|square] [--line NAME]
Prints a table; per line the worst run. Fails where a program fails, or a robot is beyond what docs/boards.md lets expect of the worst line.
"""
import argparse
import concurrent.futures
import math
import pathlib
import subprocess
import sys
import tempfile

from judged_board import io7_board

LINES = {
    "1 ms": ["--latency", "1"],
    "2 ms": ["--latency", "2"],
    "5 ms": ["--latency", "5"],
    "16 ms": ["--latency", "16"],
    "FTDI, 16 ms": ["--latency", "1", "--ftdi", "16"],
    "30 ms": ["--latency", "30"],
    "60 ms": ["--latency", "60"],
    "jitter 2 … 22 ms": ["--latency", "2", "--jitter", "20"],
    "spikes, 5 % of 80 ms": ["--latency", "2", "--spike", "0.05,80"],
    "single bytes, 2 ms apart": ["--latency", "2", "--bytegap", "2"],
    "echo": ["--echo"],
    "prompt and text": ["--verbose", "1", "--fixed-reply", "--reply", "text", "--prompt", ">"],
    "binary": ["--form", "binary"],
    "banner in time": ["--banner", "IO7 board\\r\\n", "--boot", "0.5"],
    "late answers": ["--late", "0.5,100", "--late", "1.5,100", "--late", "2.5,100"],
    "double answers": ["--double", "0.5", "--double", "1.5", "--double", "2.5"],
    "deaf for 0.3 s": ["--dead", "1.0,0.3"],
}
# The path's length in mm, where it ends, and the turns that it takes on the spot.
COURSES = {"leg": (500, (500, 0, 90)), "square": (1200, (0, 0, 0))}
# What no line may exceed, however busy the computer: of the path, degrees, the ideal path's length.
MOST = {"off": 5.0, "turned": 8.0, "path": 1.25}


def one_run(programs, line, course):
    """Percent of the path off, degrees off, odometry off in mm and degrees, share of the ideal path, seconds; or what it said."""
    length, (to_x, to_y, to_phi) = COURSES[course]
    with tempfile.TemporaryDirectory() as folder:
        with io7_board(folder, LINES[line]) as board:
            run = subprocess.run([programs / "judged_course", course], capture_output=True, text=True, timeout=120, cwd=folder,
                                 env={"EYEBRIDGE_HAL": board.hal, "PATH": "/usr/bin:/bin"})
        if run.returncode != 0:
            return None, run.stderr.strip().replace("\n", "; ")
    believed_x, believed_y, believed_phi, seconds = map(float, run.stdout.split())
    return {
        "off": math.hypot(board.x - to_x, board.y - to_y) / length * 100,
        "turned": abs(math.remainder(board.phi - to_phi, 360)),
        "odometry": math.hypot(board.x - believed_x, board.y - believed_y),
        "believed": abs(math.remainder(board.phi - believed_phi, 360)),
        "path": board.path / length,
        "seconds": seconds,
    }, None


def row_of(line, course, results):
    """The row of the worst run, and what is wrong or None."""
    failed = sorted({said for result, said in results if result is None})
    if failed:
        return f"| {line} | {course} | {' / '.join(failed)} | | | | | |", f"{line}, {course}: {failed[0]}"
    worst = {key: max(result[key] for result, _ in results) for key in results[0][0]}
    row = (f"| {line} | {course} | {worst['off']:.1f} | {worst['turned']:.1f} | {worst['odometry']:.1f} | {worst['believed']:.1f} | "
           f"{worst['path']:.2f} | {worst['seconds']:.1f} |")
    beyond = [key for key, most in MOST.items() if worst[key] > most]
    return row, f"{line}, {course}: beyond {MOST}: {beyond}" if beyond else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--course", choices=COURSES, action="append")
    parser.add_argument("--line", choices=LINES, action="append")
    options = parser.parse_args()
    wrong = []
    print("| line | course | off % | off ° | odometry off mm | ° | path | s |\n|---|---|---:|---:|---:|---:|---:|---:|")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        cases = [(line, course) for line in options.line or LINES for course in options.course or COURSES]
        runs = {case: [pool.submit(one_run, options.programs, *case) for _ in range(options.runs)] for case in cases}
        for case in cases:
            row, what = row_of(*case, [run.result() for run in runs[case]])
            print(row, flush=True)
            wrong += [what] if what else []
    print("\n".join(wrong), file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
