"""Several robots in a simulated world: short runs that are broken in every way, one run that lives all the time while its robots
come, go, are killed and stopped, and one with windows whose display dies."""
import contextlib
import os
import pathlib
import re
import resource
import signal
import subprocess
import time

import ends
import frames
import oracle

ROBOTS = 3
ROOM = pathlib.Path(__file__).resolve().parents[2] / "worlds/two-robots.sim"
PATIENCE_S = 60.0  # for commands and ends
RESULTS = ["--out", "out", "--report", "run.report"]

RUNS = ["nothing", "robot killed", "robot stopped for a while", "robot stopped, then killed", "run gets SIGTERM", "run gets SIGINT",
        "run killed", "disk full", "picture damaged", "picture is a pipe"]  # fmt: skip
LIFE = ["robot added", "robot removed", "robot of a long run killed", "all stopped for a while"]
WATCHED = ["windows, robot added and removed", "display dies"]
FAULTS = [f"run: {what}" for what in RUNS] + LIFE + WATCHED + ["memory of a long run"]


def start(place, folder, words, limit=None, **environment):
    """`eyebridge run` of roamers in `folder`; what it says goes to the file `said`. No file gets larger than `limit` bytes: as on a
    full disk, so without the signal that there is else (Python ignores it)."""

    def before():
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    (folder / "home").mkdir(exist_ok=True)
    own = {"PATH": "/usr/bin:/bin", "HOME": str(folder / "home"), "XDG_RUNTIME_DIR": str(folder / "home"), **environment}
    with open(folder / "said", "ab") as said:
        return subprocess.Popen([place.programs / "eyebridge", "run", *words, place.programs / "chaos_roamer"], stdin=subprocess.DEVNULL,
                                stdout=said, stderr=said, cwd=folder, env=own, start_new_session=True, preexec_fn=before,
                                restore_signals=limit is None)  # fmt: skip


def said(folder):
    """Without what robots do to each other, which is no message about a fault."""
    text = (folder / "said").read_text(errors="replace")
    return "\n".join(line for line in text.splitlines() if " hit " not in line)


def await_that(holds):
    try:
        ends.await_that(holds)
        return True
    except TimeoutError:
        return False


def robots_of(process):
    """The processes of its robots' programs."""
    return [one for one in [process, *oracle.children_of(process)] if ends.name_of(one) == "chaos_roamer"]


def send(process, number):
    with contextlib.suppress(ProcessLookupError):
        os.kill(process, number)


def runs(place, tally):
    """Short runs, each broken in one way."""
    left = list(RUNS)
    place.dice.shuffle(left)
    while place.has_time() or left:
        what = left.pop() if left else place.dice.choice(RUNS)
        folder = place.fresh_folder()
        tally.add(f"run: {what}", one_run(place, folder, what))


def one_run(place, folder, what):
    frames.write_folder(folder / "home", 12)
    # One alone is the program itself, and can be recorded.
    count = ROBOTS if what.startswith("robot") else place.dice.choice([1, ROBOTS])
    words = ["--record", "run.ebrec"] if count == 1 else ["--robots", str(count), "--isolate"]
    limit = place.dice.choice([4_000, 60_000]) if count == 1 else 4_000
    run = start(place, folder, [*words, "--no-gui", "--time-limit", "4", "--camera", "frames:home?fps=4&end=hold", *RESULTS],
                limit if what == "disk full" else None)  # fmt: skip
    try:
        if not await_that(lambda: len(robots_of(run.pid)) == count or run.poll() is not None):
            return f"no robots came; {said(folder)}"
        time.sleep(place.dice.uniform(0.1, 2.0))
        break_it(place, folder, run, what)
        try:
            code = run.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            return f"it did not end; {said(folder)}"
    finally:
        run.kill()
        run.wait()
    wrong = oracle.left_over(folder) or oracle.said_twice(said(folder)) or wrong_end(folder, what, code, count)
    wrong = wrong or "; ".join(oracle.wrong_files(folder, is_cut=what == "disk full" or what.endswith("killed")))
    return wrong and f"{wrong}; exit code {code}, said: {said(folder)}"


def break_it(place, folder, run, what):
    robots = robots_of(run.pid)
    victim = place.dice.choice(robots) if robots else run.pid
    if what == "robot killed":
        send(victim, signal.SIGKILL)
    elif what.startswith("robot stopped"):
        send(victim, signal.SIGSTOP)
        time.sleep(place.dice.uniform(0.1, 1.0))
        send(victim, signal.SIGKILL if what.endswith("killed") else signal.SIGCONT)
    elif what in ("run gets SIGTERM", "run gets SIGINT", "run killed"):
        send(run.pid, {"run gets SIGTERM": signal.SIGTERM, "run gets SIGINT": signal.SIGINT, "run killed": signal.SIGKILL}[what])
    elif what.startswith("picture"):
        picture = sorted((folder / "home").glob("*.png"))[place.dice.randrange(12)]
        picture.unlink()
        if what.endswith("pipe"):
            os.mkfifo(picture)
        else:
            picture.write_bytes(b"\x89PNG\r\n\x1a\n" + place.dice.randbytes(200))


def wrong_end(folder, what, code, count):
    """What is not as it should be in the exit code, the results that were asked for and what was said."""
    text = said(folder)
    expected = {"robot killed": (128 + 9,), "robot stopped, then killed": (128 + 9,), "run gets SIGTERM": (-15, 143), "run gets SIGINT": (-2, 130),
                "run killed": (-9,), "disk full": (1, 2)}.get(what, (0,))  # fmt: skip
    if code not in expected:
        return f"found exit code {code}, expected {expected}"
    if what == "disk full" and not any(words in text for words in ("too large", "cannot write", "is not whole")):
        return "it does not say why"
    if what in ("run killed", "disk full"):
        return None
    lcds = ["out/lcd.txt"] if count == 1 else [f"out/robot-{i}/lcd.txt" for i in range(1, count + 1)]
    lacking = [name for name in ["run.report", *["run.ebrec"][: count == 1], *lcds] if not (folder / name).exists()]
    # Who is killed shows nothing any more.
    allowed = 1 if what.endswith("killed") else 0
    return f"results are missing: {lacking}" if len(lacking) > allowed or "run.report" in lacking else None


class Long:
    """A run that lives as long as the test; `memory` is a sample of each moment that somebody looked, with how many robots had come."""

    def __init__(self, place, words, **environment):
        self.place, self.folder = place, place.fresh_folder()
        self.process = start(place, self.folder, words, **environment)
        self.own = {"PATH": "/usr/bin:/bin", "HOME": str(self.folder / "home"), "XDG_RUNTIME_DIR": str(self.folder / "home")}
        self.lasting = [self.process.pid]  # whose memory is looked at: robots that come and go make it more and less
        self.memory = []
        self.came = 0

    def command(self, *words):
        done = subprocess.run([self.place.programs / "eyebridge", *map(str, words)], cwd=self.folder, env=self.own, text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=PATIENCE_S, check=False)  # fmt: skip
        return done.returncode, done.stdout + done.stderr

    def add(self):
        """The number of the robot that came, or what was wrong."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            at = [self.place.dice.randrange(300, 1700) for _ in range(2)]
            code, text = self.command("add", "S4", *at, self.place.dice.randrange(360), self.place.programs / "chaos_roamer")
            if code == 0 and re.fullmatch(r"\d+\n", text):
                self.came += 1
                return int(text)
            if "found no run" in text:
                time.sleep(0.05)  # it has only just begun
            elif "expected a free place" not in text:
                break
        return f"add: {code}, {text}"

    def look(self):
        self.memory.append((oracle.resident_kb(self.lasting), self.came))

    def end(self):
        self.process.terminate()
        try:
            code = self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return "it did not end"
        text = said(self.folder)
        wrong = None if code in (-15, 143) else f"exit code {code}, expected 143"
        wrong = wrong or oracle.left_over(self.folder) or "; ".join(oracle.wrong_files(self.folder))
        return wrong and f"{wrong}; it said: {text}"


def lives(place, tally):
    """One run, all the time. As many robots as at first, whatever is done to them."""
    run = Long(place, ["--robots", "2", "--isolate", "--no-gui", "--camera", "none", "--world", str(ROOM)])
    try:
        if not await_that(lambda: len(robots_of(run.process.pid)) == 2):
            raise RuntimeError(f"no robots came; {said(run.folder)}")
        run.lasting += oracle.children_of(run.process.pid)
        extra = []  # numbers of robots that came later, which still live
        left = list(LIFE)
        while place.has_time() or left:
            what = left.pop(0) if left else place.dice.choice(LIFE)
            wrong = None
            if what == "robot added" or not extra:
                what = "robot added"
                came = run.add()
                wrong = came if isinstance(came, str) else None
                extra += [] if wrong else [came]
            if len(extra) > 2 or what == "robot removed":
                what = "robot removed"
                code, text = run.command("remove", extra.pop(0))
                wrong = None if code == 0 else f"remove: {code}, {text}"
            elif what == "robot of a long run killed":
                # The one that came last, once it is its program: the first two are what the run lives for.
                if not await_that(lambda: len(robots_of(run.process.pid)) == 2 + len(extra)):
                    raise RuntimeError(f"{2 + len(extra)} robots expected, found {robots_of(run.process.pid)}; {said(run.folder)}")
                left_alive = robots_of(run.process.pid)
                send(left_alive[-1], signal.SIGKILL)
                if not await_that(lambda: left_alive[-1] not in robots_of(run.process.pid)):
                    wrong = "it is still there"
                code, text = run.command("remove", extra.pop())  # it would stand there for ever
                wrong = wrong or (None if code == 0 else f"remove: {code}, {text}")
            elif what == "all stopped for a while":
                everyone = [run.process.pid, *oracle.children_of(run.process.pid)]
                for number in (signal.SIGSTOP, signal.SIGCONT):
                    for one in everyone:
                        send(one, number)
                    time.sleep(place.dice.uniform(0.05, 0.5))
            if run.process.poll() is not None:
                raise RuntimeError(f"{what}: the run ended with {run.process.returncode}; {said(run.folder)}")
            run.look()
            tally.add(what, wrong)
            time.sleep(0.3)
    finally:
        tally.add("end of a long run", run.end())
    tally.add("memory of a long run", oracle.grew(run.memory))


def watched(place, tally):
    """Runs with windows, on a display of their own, which dies at the end."""
    once = True
    while place.has_time(10.0) or once:
        if not once:
            time.sleep(2.0)  # windows are much work, and boards have to be punctual meanwhile
        once = False
        with display(place.fresh_folder()) as (name, server):
            run = Long(place, ["--robots", "2", "--gui", "--world", str(ROOM), *RESULTS], DISPLAY=name)
            try:
                if not await_that(lambda: "eb:gui" in threads_of(run.process.pid) or run.process.poll() is not None):
                    raise RuntimeError("no windows")
                for _ in range(3):
                    came = run.add()
                    time.sleep(place.dice.uniform(0.2, 1.0))
                    code, text = run.command("remove", came)
                    tally.add("windows, robot added and removed", None if code == 0 else f"add: {came}; remove: {code}, {text}")
                    run.look()
            finally:
                server.kill()
                tally.add("display dies", end_without_display(run))


def end_without_display(run):
    try:
        code = run.process.wait(PATIENCE_S)
    except subprocess.TimeoutExpired:
        run.process.kill()
        return f"the run did not end; {said(run.folder)}"
    text = said(run.folder)
    wrong = None if code in (-15, 143) else f"exit code {code}, expected 143"
    wrong = wrong or (None if "the display went away" in text else "it does not say why it ended")
    wrong = wrong or oracle.left_over(run.folder) or oracle.said_twice(text) or "; ".join(oracle.wrong_files(run.folder))
    return wrong and f"{wrong}; it said: {text}"


@contextlib.contextmanager
def display(folder):
    """The name of a display of its own, and its server's process."""
    server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              text=True, cwd=folder)  # fmt: skip
    try:
        yield f":{server.stdout.readline().strip()}", server
    finally:
        server.kill()
        server.wait()
        server.stdout.close()


def threads_of(process):
    with contextlib.suppress(OSError):
        return [ends.name_of(f"{process}/task/{one}") for one in os.listdir(f"/proc/{process}/task")]
    return []
