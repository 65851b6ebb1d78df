"""How benches that are whole processes are measured: in rounds, each in another order, by CPU time."""
import os
import random
import statistics
import subprocess
import sys
import tempfile

ROUNDS = 5
SLACK = 1.1  # a target is missed where the median is worse by more than a tenth


def run(command, environment=None):
    """What a process printed. Ends this program where it fails."""
    return measured(command, environment)[2]


def figures(said):
    """The numbers of a line "name=value name=value"."""
    return {name: float(value) for name, value in (word.split("=") for word in said.split()) if name != "hash"}


def measured(command, environment=None):
    """CPU seconds of a process with all that it starts and waits for, the most memory that it or one of these had (MB), and what it printed."""
    with tempfile.TemporaryFile("w+") as said, tempfile.TemporaryFile("w+") as messages:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=said, stderr=messages, env=environment)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        messages.seek(0)
        if process.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))} ended with {process.returncode}:\n{messages.read()}")
        return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, said.read()


def in_rounds(tasks, rounds=ROUNDS, seed=1):
    """What each of `tasks`, {name: function}, gives in each round."""
    results = {name: [] for name in tasks}
    order = random.Random(seed)
    for number in range(rounds):
        names = list(tasks)
        order.shuffle(names)
        for name in names:
            if sys.stderr.isatty():
                print(f"\r\033[Kround {number + 1} of {rounds}: {name}", end="", file=sys.stderr, flush=True)
            results[name].append(tasks[name]())
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr)
    return results


class Targets:
    """Counts what was missed; the exit code of a bench."""

    def __init__(self):
        self.asked = self.missed = 0

    def judge(self, value, least=None, most=None):
        """"" where the target is met or missed by less than a tenth."""
        self.asked += 1
        good = value * SLACK >= least if least is not None else value <= most * SLACK
        self.missed += not good
        return "" if good else "  MISSED"

    def end(self):
        print(f"\n{self.asked - self.missed} of {self.asked} targets are met")
        sys.exit(1 if self.missed else 0)


def spread(values):
    """Least, median, greatest."""
    return min(values), statistics.median(values), max(values)
