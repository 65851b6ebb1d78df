#!/usr/bin/env python3
"""programs.py BUILD: how fast, and in how much memory, many programs run in virtual time, in one process and in one each (docs/scale.md)."""
import os
import re
import resource
import subprocess
import sys
import tempfile

FIELD = "floor 40000 40000\n0 0 40000 0\n40000 0 40000 40000\n40000 40000 0 40000\n0 40000 0 0\n"
RUNS = 3


def run(build, world, robots, words, flags=(), program="hundred_hertz"):
    """Times real time of one run, its peak of resident memory in MB, and what the programs said."""
    command = [f"{build}/bin/eyebridge", "run", "--fast", "--robots", str(robots), "--world", world, *flags,
               f"{build}/bench/{program}", *words]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    said, messages = process.stdout.read(), process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    done = re.search(r"([0-9.]+) s on their clock in ([0-9.]+) s", messages)
    if status != 0 or done is None:
        sys.exit(f"programs.py: {' '.join(command)} failed:\n{messages}")
    return float(done[1]) / (used.ru_utime + used.ru_stime), used.ru_maxrss / 1024, said


def heap(build, world, robots):
    """Bytes of heap in use when so many robots have printed something."""
    return int(run(build, world, robots, ["heap", str(robots)])[2])


def main(build):
    with tempfile.TemporaryDirectory() as folder:
        world = os.path.join(folder, "field.wld")
        with open(world, "w", encoding="ascii") as file:
            file.write(FIELD)
        alone = run(build, world, 2, ["1"])[1]
        print(f"{'programs':>9} {'in':>9} {'x real time':>12} {'wanted':>7} {'MB':>6} {'kB/robot':>9}")
        for robots, kind, seconds, goal in ((10, "fibers", 6000, 10000), (100, "fibers", 600, 500), (1000, "fibers", 60, ""),
                                            (10, "processes", 60, ""), (100, "processes", 6, "")):
            flags = ["--isolate"] if kind == "processes" else []
            results = [run(build, world, robots, [str(seconds)], flags) for _ in range(RUNS)]
            speed = max(result[0] for result in results)
            memory = max(result[1] for result in results)
            each = 1024 * (memory - alone) / (robots - 2)
            print(f"{robots:>9} {kind:>9} {speed:>12.0f} {goal:>7} {memory:>6.0f} {each:>9.0f}")
        question = min(float(run(build, world, 2, ["50000"], ["--isolate"], "ask")[2]) for _ in range(RUNS))
        print(f"a question from a process of its own: {question:.1f} µs (wanted: at most 5)")
        each = (heap(build, world, 1000) - heap(build, world, 10)) / 990 / 1024
        print(f"heap that one more robot takes: {each:.1f} kB (wanted: at most 64)")


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    main(sys.argv[1])
