#!/usr/bin/env python3
"""growth.py BUILD DATA [quick]: what one more robot, wall, box, program or hour costs, from few to very many (docs/scale.md).

quick: one round of the smallest ones, without targets."""
import pathlib
import resource
import sys
import tempfile

from rounds import ROUNDS, Targets, figures, in_rounds, measured, run, spread

FIELD = "floor 200000 200000\n0 0 200000 0\n200000 0 200000 200000\n200000 200000 0 200000\n0 200000 0 0\n"
MOST = 1.5  # times the least cost of a unit


def scale_cost(build, data, robots, seconds, *flags):
    """Microseconds of a robot's decision: eight ranges, and the steps until the next one."""
    command = [f"{build}/bin/bench_scale", "--robots", str(robots), "--seconds", str(seconds), "--data", data, *map(str, flags)]
    return lambda: 1e6 * figures(run(command))["cpu_s"] / (robots * seconds * 10)


def program_cost(build, world, robots, seconds):
    """Nanoseconds of a round of one program: a question, a wait, a step of its robot."""
    def once(simulated):
        return measured([f"{build}/bin/eyebridge", "run", "--fast", "--robots", str(robots), "--world", world,
                         f"{build}/bench/hundred_hertz", str(simulated)])[0]
    return lambda: 1e9 * (once(seconds) - once(0)) / (robots * seconds * 100)


def hour_cost(build, world, folder, hours, flags):
    """Milliseconds of CPU a simulated hour of one program."""
    def once():
        words = [flag.replace("FOLDER", str(folder)) for flag in flags]
        for left in folder.glob("run*"):
            run(["rm", "-r", str(left)])
        return 1e3 * measured([f"{build}/bin/eyebridge", "run", "--fast", "--world", world, *words, f"{build}/bench/hundred_hertz",
                               str(3600 * hours)])[0] / hours
    return once


def rows(build, data, folder):
    """{what grows: (unit, {how many: task})}."""
    world = str(folder / "field.wld")
    pathlib.Path(world).write_text(FIELD, encoding="ascii")
    sim = lambda *words: scale_cost(build, data, *words)  # noqa: E731
    return {
        "robots, ten to a place": ("µs a decision", {n: sim(n, max(6, 100000 // n), "--in-one", 10) for n in (10, 100, 1000, 10000)}),
        "robots, 1,000 to a place": ("µs a decision", {n: sim(n, max(6, 100000 // n)) for n in (1000, 10000, 100000)}),
        "robots, steps of 10 ms": ("µs a decision", {n: sim(n, max(6, 100000 // n), "--step", 0.01) for n in (1000, 10000, 100000)}),
        "walls, ten robots": ("µs a decision", {100 * (1 + n): sim(10, 2000, "--empty", n) for n in (0, 9, 99, 999, 4999)}),
        "boxes, a hundred to a place": ("µs a decision", {100 * (1 + n): sim(10, 1000, "--boxes", 100, "--empty", n) for n in (0, 9, 99)}),
        "programs": ("ns a round", {n: program_cost(build, world, n, max(3, 30000 // n)) for n in (1, 10, 100, 1000, 9000)}),
        "hours": ("ms an hour", {n: hour_cost(build, world, folder, n, []) for n in (1, 10)}),
        "hours with --out": ("ms an hour", {n: hour_cost(build, world, folder, n, ["--out", "FOLDER/run"]) for n in (1, 10)}),
        "hours with --record": ("ms an hour", {n: hour_cost(build, world, folder, n, ["--record", "FOLDER/run.ebrec"]) for n in (1, 10)}),
    }


def main(build, data, quick):
    targets = Targets()
    print(f"{'what grows':28} {'how many':>9} {'least':>9} {'median':>9} {'most':>9}  {'unit':14} {'by the least':>12}")
    with tempfile.TemporaryDirectory() as name:
        medians = {}
        for what, (unit, tasks) in rows(build, data, pathlib.Path(name)).items():
            if quick:
                tasks = {count: tasks[count] for count in list(tasks)[:1]}
            found = {count: spread(values) for count, values in in_rounds(tasks, 1 if quick else ROUNDS).items()}
            least = min(middle for _, middle, _ in found.values())
            for count, (low, middle, high) in found.items():
                missed = targets.judge(middle / least, most=MOST)
                print(f"{what:28} {count:9} {low:9.3f} {middle:9.3f} {high:9.3f}  {unit:14} {middle / least:12.2f}{missed}", flush=True)
            medians[what] = found
        if quick:
            return
        hour = medians["hours"][10][1]
        for what in ("hours with --out", "hours with --record"):
            times = medians[what][10][1] / hour
            print(f"{what}, by those without: {times:.1f} (wanted: 3){targets.judge(times, most=3)}")
    targets.end()


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["quick"]):
        sys.exit(__doc__)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    main(*sys.argv[1:3], quick=len(sys.argv) == 4)
