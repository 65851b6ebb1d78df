#!/usr/bin/env python3
"""What a call costs in Python beyond what it costs in C. Goal: at most 1.5 us.

    PYTHONPATH=build/release/python python3 bench/python_calls.py build/release/bin/python_calls
"""

import os
import subprocess
import sys
import time

CALLS = 50000
REPEATS = 7
os.environ |= {"EYEBRIDGE_FAST": "true", "EYEBRIDGE_KEYS": "KEY1@1e9s"}

from eye import *  # noqa: E402


def nanoseconds(function, *arguments):
    """Of one call: the fastest of several rounds, less the loop itself."""

    def rounds(body):
        best = float("inf")
        for _ in range(REPEATS):
            start = time.process_time_ns()
            body()
            best = min(best, (time.process_time_ns() - start) / CALLS)
        return best

    def calls():
        for _ in range(CALLS):
            function(*arguments)

    def nothing():
        for _ in range(CALLS):
            pass

    return rounds(calls) - rounds(nothing)


def main():
    c = dict(line.split() for line in subprocess.run([sys.argv[1]], capture_output=True, text=True, check=True).stdout.splitlines())
    python = {
        "IPPRGB2Col": nanoseconds(IPPRGB2Col, 1, 2, 3),
        "PSDGet": nanoseconds(PSDGet, PSD_FRONT),
        "KEYRead": nanoseconds(KEYRead),
        "VWGetPosition": nanoseconds(VWGetPosition),
        "VWSetSpeed": nanoseconds(VWSetSpeed, 0, 0),
        "LCDPixel": nanoseconds(LCDPixel, 1, 2, RED),
        "LCDSetPrintf": nanoseconds(LCDSetPrintf, 0, 0, "PSD %5d", 123),
    }
    print(f"{'call':16} {'C, us':>8} {'Python, us':>11} {'more, us':>9}")
    for name, ns in python.items():
        base = float(c[name])
        print(f"{name:16} {base / 1e3:8.2f} {ns / 1e3:11.2f} {(ns - base) / 1e3:9.2f}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
