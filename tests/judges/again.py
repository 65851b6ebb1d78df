#!/usr/bin/env python3
"""Kills a program while the CAN robot of shared/judges is silent, and starts another one at once: does that one drive the robot?

usage: again.py FOLDER_OF_PROGRAMS
The guard of the first program stops the robot until the second one has it. Fails when it stays, or the second program does not end well.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

from bus import ROBOT, TRUTH

SILENT_AT_S, SILENT_FOR_S = 0.2, 1.5  # from the first command that drives
DISTANCE_MM, SPEED = 300, 150
PATIENCE_S = 20


def await_text(path, text):
    end = time.monotonic() + PATIENCE_S
    while text not in path.read_text():
        if time.monotonic() > end:
            sys.exit(f"{path.name}: found no '{text}' within {PATIENCE_S} s:\n{path.read_text()}")
        time.sleep(0.01)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
    programs = parser.parse_args().programs
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        robot = subprocess.Popen([sys.executable, ROBOT, "--bus", folder / "bus", "--log", folder / "log", "--dur", "100000",
                                  f"--at={SILENT_AT_S},silent,{SILENT_FOR_S}"], stdout=subprocess.PIPE, text=True)
        try:
            robot.stdout.readline()
            drive = {"args": [programs / "judged_poses", "1", str(DISTANCE_MM), str(SPEED)], "cwd": folder, "text": True,
                     "env": {"EYEBRIDGE_HAL": f"can:{folder}/bus?node=1", "PATH": "/usr/bin:/bin"}}
            with open(folder / "err", "w") as errors:
                first = subprocess.Popen(**drive, stdout=subprocess.DEVNULL, stderr=errors)
                await_text(folder / "log", "silent")
                first.kill()
                first.wait()
            second = subprocess.run(**drive, capture_output=True, timeout=60)
            await_text(folder / "err", "another program has the robot now")
        finally:
            robot.terminate()
            truth = TRUTH.search(robot.communicate(timeout=20)[0])
        x = float(truth.group(1))
        print(f"the second program: exit code {second.returncode}, the robot at {x:.0f} mm")
        if second.returncode or not second.stdout.endswith("end\n") or x < DISTANCE_MM:
            sys.exit(f"expected exit code 0, 'end' and at least {DISTANCE_MM} mm:\n{second.stdout[-300:]}{second.stderr}")


if __name__ == "__main__":
    main()
