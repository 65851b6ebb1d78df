#!/usr/bin/env python3
"""Drives a straight and a turn on spec_node.py, the robot that was written from SPECIFICATION.md alone: is it where it should be?

usage: spec_course.py FOLDER_OF_PROGRAMS
Fails when the robot is more than 2 % or 2 degrees off, or when one of the two refused a frame of the other.
"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROBOT = pathlib.Path(__file__).with_name("spec_node.py")
PATIENCE_S = 60
LENGTH_MM, GOAL = 500, (500, 0, 90)
TRUTH = re.compile(r"end: truth x=(\S+) y=(\S+) mm phi=(\S+) deg path=(\S+) mm refused=(\d+)")


def drive(programs):
    """What the robot said at its end, and how the program ended."""
    with tempfile.TemporaryDirectory() as folder:
        robot = subprocess.Popen([sys.executable, "-B", ROBOT, "--bus", "./eyebot.bus"], stdout=subprocess.PIPE, text=True,
                                 cwd=folder)
        try:
            robot.stdout.readline()
            program = subprocess.run([programs / "judged_course", "leg"], capture_output=True, text=True, cwd=folder,
                                     timeout=PATIENCE_S,
                                     env={"EYEBRIDGE_HAL": "can:./eyebot.bus?node=1", "PATH": "/usr/bin:/bin"})
        finally:
            robot.terminate()
            said = robot.communicate(timeout=PATIENCE_S)[0]
    return said, program


def judge(said, program):
    """What is wrong."""
    if program.returncode != 0:
        yield f"the program ended with {program.returncode}"
    if "ignored a frame" in program.stderr:
        yield "the program refused frames of the robot"
    found = TRUTH.search(said)
    if found is None:
        yield f"the robot did not tell the truth, but: {said}"
        return
    x, y, phi, path, refused = map(float, found.groups())
    off = math.hypot(x - GOAL[0], y - GOAL[1]) / LENGTH_MM
    turned = math.remainder(phi - GOAL[2], 360)
    if off > 0.02 or abs(turned) > 2 or abs(path / LENGTH_MM - 1) > 0.02:
        yield f"the robot is {off:.1%} and {turned:.1f} degrees off"
    believed = list(map(float, program.stdout.split()[:3]))
    if len(believed) != 3 or math.hypot(x - believed[0], y - believed[1]) > 10 or abs(phi - believed[2]) > 2:
        yield f"the program believes to be at {believed}"
    if refused > 0:
        yield f"the robot refused {refused:.0f} frames of the program"


def main():
    said, program = drive(pathlib.Path(sys.argv[1]).resolve())
    wrong = list(judge(said, program))
    print(said, program.stdout, program.stderr, *(f"wrong: {line}\n" for line in wrong), sep="")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
