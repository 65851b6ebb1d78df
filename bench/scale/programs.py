#!/usr/bin/env python3
"""programs.py BUILD: how fast, and in how much memory, many programs, worlds and runs go (docs/scale.md)."""
import os
import pathlib
import resource
import statistics
import sys
import tempfile
import time

from rounds import Targets, figures, in_rounds, measured, run

FIELD = "floor 40000 40000\n0 0 40000 0\n40000 0 40000 40000\n40000 40000 0 40000\n0 40000 0 0\n"
WORLDS = pathlib.Path(__file__).with_name("worlds.py")
# Programs, where they run, seconds of theirs, and how many times real time is wanted.
PROGRAMS = ((10, "fibers", 6000, 10000), (100, "fibers", 600, 500), (1000, "fibers", 60, 100), (10, "processes", 60, None),
            (100, "processes", 6, None))
# Worlds of a VectorEnv, and how many thousand steps a CPU second are wanted.
ENVIRONMENTS = {1: 300, 16: 800, 64: 800, 1024: 800, 16384: 800}
RUNS = 200  # of a sweep


def program(build, name, world, robots, words, flags=()):
    return [f"{build}/bin/eyebridge", "run", "--fast", "--robots", str(robots), "--world", world, *flags, f"{build}/bench/{name}", *words]


def speed(build, world, robots, where, seconds):
    """Times real time by CPU time without the start, and memory in MB."""
    def once():
        def hundred_hertz(simulated):
            return measured(program(build, "hundred_hertz", world, robots, [str(simulated)], ["--isolate"] if where == "processes" else []))
        spent, memory, _ = hundred_hertz(seconds)
        return seconds / (spent - hundred_hertz(0)[0]), memory
    return once


def heap(build, world, robots):
    """Bytes of heap in use when so many robots have printed something."""
    return int(run(program(build, "hundred_hertz", world, robots, ["heap", str(robots)])))


def sweep_times(build, world, folder):
    """Real time of a sweep of one-second runs, by that of xargs with the same."""
    words = ["--world", world, "--time-limit", "1s"]
    square = f"{build}/examples/square"

    def seconds(command):
        start = time.monotonic()
        run(command)
        return time.monotonic() - start

    (folder / "seeds").write_text("\n".join(map(str, range(1, RUNS + 1))))
    for left in folder.glob("sweep.db*"):
        left.unlink()
    sweep = seconds([f"{build}/bin/eyebridge", "sweep", *words, "--seed", f"1..{RUNS}", "--jobs", "2", "--results",
                     str(folder / "sweep.db"), square])
    return sweep / seconds(["xargs", "-P2", "-I{}", "-a", str(folder / "seeds"), f"{build}/bin/eyebridge", "run", "--fast", *words,
                            "--seed", "{}", square])


def print_programs(build, world, targets):
    results = in_rounds({case[:2]: speed(build, world, *case[:3]) for case in PROGRAMS})
    print(f"{'programs':>9} {'in':>9} {'x real time':>12} {'wanted':>7} {'MB':>6}")
    for robots, where, _, wanted in PROGRAMS:
        times = statistics.median(result[0] for result in results[robots, where])
        memory = max(result[1] for result in results[robots, where])
        missed = targets.judge(times, least=wanted) if wanted else ""
        print(f"{robots:>9} {where:>9} {times:>12.0f} {wanted or '':>7} {memory:>6.0f}{missed}", flush=True)


def print_worlds(build, targets):
    environment = dict(os.environ, PYTHONPATH=f"{build}/python")
    tasks = {worlds: lambda worlds=worlds: figures(run(["/usr/bin/python3", "-B", str(WORLDS), str(worlds)], environment))["k_steps_s"]
             for worlds in ENVIRONMENTS}
    print(f"\n{'worlds':>9} {'k steps/s':>9} {'wanted':>7}")
    for worlds, rates in in_rounds(tasks).items():
        rate = statistics.median(rates)
        print(f"{worlds:>9} {rate:>9.0f} {ENVIRONMENTS[worlds]:>7}{targets.judge(rate, least=ENVIRONMENTS[worlds])}", flush=True)


def main(build):
    targets = Targets()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        world = str(folder / "field.wld")
        pathlib.Path(world).write_text(FIELD, encoding="ascii")
        print_programs(build, world, targets)
        print_worlds(build, targets)
        one = in_rounds({
            "µs of a question from a process of its own": lambda: float(run(program(build, "ask", world, 2, ["50000"], ["--isolate"]))),
            "kB of heap that one more robot takes": lambda: (heap(build, world, 1000) - heap(build, world, 10)) / 990 / 1024,
            f"a sweep of {RUNS} runs of a second, by xargs -P2": lambda: sweep_times(build, world, folder)})
        for (what, values), wanted in zip(one.items(), (5, 64, 1.1)):
            value = statistics.median(values)
            print(f"\n{what}: {value:.2f} (wanted: at most {wanted}){targets.judge(value, most=wanted)}")
    targets.end()


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    main(os.path.abspath(sys.argv[1]))
