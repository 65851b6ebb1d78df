#!/usr/bin/env python3
"""Drives a robot on the IO7 board of shared/judges over lines of all speeds: where is it, and where does it believe to be?

usage: lines.py FOLDER_OF_PROGRAMS [--runs 1] [--course leg|square] [--line NAME]
Prints a table; per line the worst run. A course that is refused is a row, too.
"""
import argparse
import concurrent.futures
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOARD = ROOT.parent / "shared/judges/io7_board.py"
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
TRUTH = re.compile(r"end: truth x=(\S+) y=(\S+) mm phi=(\S+) deg path=(\S+) mm")


def one_run(programs, line, course):
    """Millimetres off, degrees off, odometry off in mm, share of the ideal path, seconds; or what it said."""
    length, (to_x, to_y, to_phi) = COURSES[course]
    with tempfile.TemporaryDirectory() as folder:
        board = subprocess.Popen([sys.executable, BOARD, f"{folder}/tty", "--tpm", "6484", "--base", "0.09", *LINES[line]],
                                 stdout=subprocess.PIPE, text=True)
        try:
            board.stdout.readline()
            run = subprocess.run([programs / "judged_course", course], capture_output=True, text=True, timeout=120, cwd=folder,
                                 env={"EYEBRIDGE_HAL": f"serial:{folder}/tty", "PATH": "/usr/bin:/bin"})
        finally:
            board.terminate()
            out = board.communicate(timeout=20)[0]
        if run.returncode != 0:
            return None, run.stderr.strip().replace("\n", "; ")
    x, y, phi, path = map(float, TRUTH.search(out).groups())
    believed_x, believed_y, believed_phi, seconds = map(float, run.stdout.split())
    return {
        "off": math.hypot(x - to_x, y - to_y) / length * 100,
        "turned": abs(math.remainder(phi - to_phi, 360)),
        "odometry": math.hypot(x - believed_x, y - believed_y),
        "believed": abs(math.remainder(phi - believed_phi, 360)),
        "path": path / length,
        "seconds": seconds,
    }, run.stderr.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--course", choices=COURSES, action="append")
    parser.add_argument("--line", choices=LINES, action="append")
    options = parser.parse_args()
    print("| line | course | off % | off ° | odometry off mm | ° | path | s |\n|---|---|---:|---:|---:|---:|---:|---:|")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for line in options.line or LINES:
            for course in options.course or COURSES:
                results = list(pool.map(lambda _, at=(line, course): one_run(options.programs, *at), range(options.runs)))
                for said in {said for result, said in results if result is None}:
                    print(f"| {line} | {course} | {said} | | | | | |", flush=True)
                found = [result for result, _ in results if result is not None]
                if not found:
                    continue
                worst = {key: max(result[key] for result in found) for key in found[0]}
                print(f"| {line} | {course} | {worst['off']:.1f} | {worst['turned']:.1f} | {worst['odometry']:.1f} | "
                      f"{worst['believed']:.1f} | {worst['path']:.2f} | {worst['seconds']:.1f} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
