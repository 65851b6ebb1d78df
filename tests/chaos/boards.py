"""Programs that end on a board, and boards that fail under a program: do the motors stop, and does it go on?"""
import signal
import subprocess
import time

import ends
import oracle
from judged_board import io7_board

# What the board does, by its own command line: seconds after the first drive, and how long.
NOISE = "bytes lost and flipped"
TROUBLES = {
    "board unplugged": ["--unplug", "1,1.5"],
    "board deaf": ["--dead", "1,1.5"],
    "board restarts": ["--restart", "1"],
    # More bits that flip make a 1 of the last 0 that a board hears now and then: docs/robustness.md.
    NOISE: ["--drop", "0.01", "--flip", "0.001"],
}
TROUBLE_LASTS_S = 2.0
ends.PATIENCE_S = 60.0  # of a computer that has all the other parts to do

FAULTS = [*(f"program ends: {way}" for way in ends.WAYS), *TROUBLES]


def programs_end(place, tally):
    """Every way to end, in random order, on the board that has no watchdog."""
    ways = list(ends.WAYS)
    place.dice.shuffle(ways)
    while place.has_time() or ways:
        way = ways.pop() if ways else place.dice.choice(list(ends.WAYS))
        for _ in range(5):
            _, wrong = ends.one_run(place.programs, way, io7_board)
            # A board that is a busy computer's process may be too late even to be driven: then nothing has been tried.
            if wrong is None or "never told to drive" not in wrong:
                break
        tally.add(f"program ends: {way}", wrong)


def boards_fail(place, tally):
    troubles = list(TROUBLES)
    while place.has_time() or troubles:
        trouble = troubles.pop() if troubles else place.dice.choice(list(TROUBLES))
        tally.add(trouble, one_trouble(place, trouble))


def one_trouble(place, trouble):
    """What was wrong with a program whose board fails and comes back."""
    folder = place.fresh_folder()
    log, out = folder / "log", folder / "out"
    with io7_board(folder, ["--log", log, *TROUBLES[trouble]]) as board, open(out, "w") as outputs:
        start = time.monotonic()
        program = subprocess.Popen(
            [place.programs / "chaos_roamer"], stdin=subprocess.DEVNULL, stdout=outputs, stderr=outputs, cwd=folder,
            start_new_session=True, env={"EYEBRIDGE_HAL": board.hal, "EYEBRIDGE_CAMERA": "none", "PATH": "/usr/bin:/bin"})
        try:
            wrong = watch(program, trouble, log, out, start)
        except TimeoutError:
            wrong = "it did not go on, or its motors did not stop"
        finally:
            program.kill()
            program.wait()
    said = out.read_text()
    # On a line that spoils bytes the trouble comes again and again, and so does its message.
    wrong = wrong or (None if trouble == NOISE else oracle.said_twice(said))
    return wrong and f"{wrong}; it said: {said}"


def watch(program, trouble, log, out, start):
    def commands():
        return log.read_text().count(" CMD ")

    def stands():
        return ends.Log(log, start).stands_from(ended) is not None

    ends.await_that(lambda: ends.Log(log, start).driven_at() is not None)
    if trouble in ("board unplugged", "board deaf"):
        ends.await_that(lambda: "lost " in out.read_text())
        ends.await_that(lambda: "back" in out.read_text())
    else:
        time.sleep(TROUBLE_LASTS_S)
    before = commands()
    ends.await_that(lambda: commands() > before + 20)
    if program.poll() is not None:
        return f"the program ended with {program.returncode}"
    program.terminate()
    if (code := program.wait(ends.PATIENCE_S)) != -signal.SIGTERM:
        return f"its exit code was {code}"
    ended = time.monotonic()
    ends.await_that(stands)
    return None
