#!/usr/bin/env python3
"""Runs the tests of attacks.txt from a build with sanitizers, and prints what was tried and survived.

usage: attacks.py BUILD
A row: what is done, how many tests do it, how many failed. The exit code is 1 if one did, or if a row has no test.
"""
import pathlib
import re
import subprocess
import sys

ROWS = pathlib.Path(__file__).with_name("attacks.txt").read_text().splitlines()[1:]
LIMIT_S = 1800


def run(build, what):
    """Tests that ran, and those that did not pass."""
    program, names = what.split(":", 1)
    done = subprocess.run([build / f"bin/test_{program}", f"--gtest_filter={names}"], text=True, errors="replace", timeout=LIMIT_S,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)  # fmt: skip
    ran = re.findall(r"^\[=+\] (\d+) tests? from .* ran", done.stdout, re.MULTILINE)
    passed = re.findall(r"^\[  PASSED  \] (\d+) test", done.stdout, re.MULTILINE)
    count = int(ran[-1]) if ran else 0
    bad = count - int(passed[-1]) if passed else max(count, 1)
    if bad == 0 and (done.returncode != 0 or count == 0):
        bad = 1  # a sanitizer's word at the end; or there is no such test
    if bad:
        print(f"{what}: {count} tests, exit code {done.returncode}\n{done.stdout[-4000:]}", file=sys.stderr)
    return count, bad


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    print("| what is done to it | tests | failed |\n|---|---:|---:|", flush=True)
    failed = 0
    for row in ROWS:
        title, programs = (part.strip() for part in row.split("|"))
        found = [run(build, what) for what in programs.split()]
        bad = sum(wrong for _, wrong in found)
        failed += bad
        print(f"| {title} | {sum(count for count, _ in found)} | {bad} |", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
