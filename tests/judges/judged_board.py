"""Boards that nobody of us wrote, or that were written from our specification alone, each with a robot of 6484 ticks a metre
and a wheel base of 90 mm, at the origin."""
import contextlib
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
IO7 = HERE.parents[2] / "shared/judges/io7_board.py"
SPEC_NODE = HERE / "spec_node.py"
TRUTH = re.compile(r"end: truth x=(\S+) y=(\S+) mm phi=(\S+) deg path=(\S+) mm(?: refused=(\d+))?")
PATIENCE_S = 20


class Board:
    """A board that runs. `hal` is what EYEBRIDGE_HAL must be; once it has ended `x`, `y` in mm, `phi` in degrees and `path` in
    mm tell where its robot truly is, and `refused` how many frames of the program it did not accept."""

    def __init__(self, process, hal):
        self.process = process
        self.hal = hal
        self.process.stdout.readline()

    def end(self):
        self.process.terminate()
        said = self.process.communicate(timeout=PATIENCE_S)[0]
        found = TRUTH.search(said)
        if found is None:
            raise RuntimeError(f"the board did not tell the truth, but: {said}")
        self.x, self.y, self.phi, self.path = map(float, found.groups()[:4])
        self.refused = int(found[5] or 0)


@contextlib.contextmanager
def running(command, hal, folder):
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=folder)
    try:
        board = Board(process, hal)
        yield board
        board.end()
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()


def io7_board(folder, options=()):
    """The IO7 board of shared/judges on a pty in `folder`, with its own command line `options`."""
    command = [sys.executable, IO7, f"{folder}/tty", "--tpm", "6484", "--base", "0.09", *options]
    return running(command, f"serial:{folder}/tty", folder)


def spec_node(folder, options=()):
    """The robot on CAN from SPECIFICATION.md alone, on a bus over a socket in `folder`, with its own command line `options`."""
    return running([sys.executable, "-B", SPEC_NODE, "--bus", "./eyebot.bus", *options], "can:./eyebot.bus?node=1", folder)
