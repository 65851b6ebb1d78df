#!/usr/bin/env python3
"""Drives the CAN robot of shared/judges while others send under its identifiers, while it is silent, and when it restarts.

usage: bus.py FOLDER_OF_PROGRAMS [--drives 1] [--jobs 2] [--case NAME]
Prints a table: per case the poses that a program was given, how many were wrong, how many drives were called done before
they were, and what the program was told. Fails when one was wrong, or what must be told was not.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROBOT = ROOT.parent / "shared/judges/can_node.py"
DISTANCE, SPEED = 300, 150  # mm, mm/s
SLACK = 3  # mm: whole millimetres, both ways
TRUTH = re.compile(r"end truth x=(\S+) y=(\S+) phi=(\S+) path=(\S+)")


def foreign(kind, period, told):
    return [f"--noise={kind},{period}"], told


# case: (arguments of the robot, what the program must be told; "" for nothing; None where it depends on chance)
CASES = {
    "alone": ([], ""),
    **{f"a CANopen TPDO1 each {period} ms": foreign("tpdo1", period, "181") for period in (1, 5, 20, 50, 200)},
    "a CANopen TPDO1 each 1000 ms": foreign("tpdo1", 1000, None),
    **{f"random bytes as S_Speed each {period} ms": foreign("canopen17", period, "191") for period in (1, 5, 20, 50, 200)},
    "short frames": foreign("short", 50, "ignored a frame"),
    "other formats": (["--noise=ext,20", "--noise=extlow,20", "--noise=rtr,20", "--noise=fd,20"], ""),
    "SDO, SYNC, another's heartbeat": (["--noise=sdo,20", "--noise=sync,20", "--noise=hbother,50"], ""),
    "silent for 1 s": (["--at=0.5,silent,1.0"], "lost"),
    "restarts": (["--at=0.5,reboot"], "restarted"),
}


class Run:
    """What a program on the robot said, and what the robot heard."""

    def __init__(self, programs, case, drives):
        arguments, _ = CASES[case]
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            robot = subprocess.Popen([sys.executable, ROBOT, "--bus", folder / "bus", "--log", folder / "log", "--dur", "100000", *arguments],
                                     stdout=subprocess.PIPE, text=True)
            try:
                robot.stdout.readline()
                program = subprocess.run([programs / "judged_poses", str(drives), str(DISTANCE), str(SPEED)], capture_output=True, text=True,
                                         timeout=120 + 10 * drives, cwd=folder,
                                         env={"EYEBRIDGE_HAL": f"can:{folder}/bus?node=1", "PATH": "/usr/bin:/bin"})
            finally:
                robot.terminate()
                out = robot.communicate(timeout=20)[0]
            self.log = (folder / "log").read_text()
        self.said = program.stderr.strip()
        self.ended = program.stdout.endswith("end\n")
        self.rows = [tuple(map(int, line.split())) for line in program.stdout.splitlines() if line != "end"]
        self.truth = tuple(map(float, TRUTH.search(out).groups()))

    def wrong(self):
        """Poses that are not on the way, or go back."""
        count, last = 0, 0
        for x, y, phi, _ in self.rows:
            if abs(y) > SLACK or abs(phi) > 1 or not last - SLACK <= x <= self.truth[0] + SLACK:
                count += 1
            else:
                last = x
        return count

    def too_early(self):
        """Drives that were called done before they were."""
        done = [x for x, _, _, done in self.rows if done == 1]
        return sum(x < DISTANCE * (i + 1) - SLACK for i, x in enumerate(done))

    def set_poses(self):
        return self.log.count("CMD 0x221")


def judge(programs, case, drives):
    run = Run(programs, case, drives)
    told = CASES[case][1]
    row = (f"| {case} | {len(run.rows)} | {run.wrong()} | {run.too_early()} | {'yes' if run.ended else 'no'} | "
           f"{run.said.splitlines()[-1] if run.said else ''} |")
    problems = []
    if run.wrong() or run.too_early():
        problems.append(f"{run.wrong()} wrong poses, {run.too_early()} drives called done too early")
    if told is not None and (told not in run.said if told else "else" in run.said or "ignored" in run.said):
        problems.append(f"expected to be told '{told}'")
    if "silent" in case and run.set_poses():
        problems.append("the pose of a robot that had only been silent was set")
    if case == "restarts" and not run.set_poses():
        problems.append("the robot was not told where it was")
    if not told and told is not None and not run.ended:
        problems.append("the program did not end well")
    return row, [f"{case}: {problem}\n{run.said}" for problem in problems]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--drives", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--case", choices=CASES, action="append")
    options = parser.parse_args()
    print("| on the bus | poses | wrong | done too early | ended well | what it was told |\n|---|---:|---:|---:|---|---|")
    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row, problems in pool.map(lambda case: judge(options.programs, case, options.drives), options.case or CASES):
            print(row, flush=True)
            for problem in problems:
                print(problem, file=sys.stderr)
            wrong += len(problems)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
