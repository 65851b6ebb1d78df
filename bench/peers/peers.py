#!/usr/bin/env python3
"""peers.py BUILD DATA [quick]: EyeBridge beside other simulators at the same work, on one machine in the same rounds (docs/scale.md).

quick: one short round of a hundred robots, without targets; fails where the work is not the same."""
import csv
import math
import os
import pathlib
import statistics
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "scale"))
from rounds import ROUNDS, Targets, figures, in_rounds, measured, run, spread  # noqa: E402

SAME = 0.03  # figures of the same work differ by no more
# Robots, and the seconds that all simulate of them.
SIZES = {10: 1000, 100: 100, 1000: 10}
# Ours, and how many times as fast as the best peer they should be: by sense and step in ms.
OURS = {
    "program in C": {("psd", 100): 5, ("psd", 10): {10: 15, 100: 15, 1000: 10}},
    "one by one": {("psd", 100): 8, ("psd", 10): 8},
    "all at once": {("psd", 100): 10, ("psd", 10): 10},
    "around the rim": {("psd", 100): 10},
    "": {("lidar", 100): 10, ("lidar", 10): 10, ("none", 100): 10, ("none", 10): 10},
}
FLAGS = {"one by one": ["--one-by-one"], "around the rim": ["--rim", "0.09"]}


def build_enki(folder):
    """The program that is Enki at this work."""
    program = folder / "enki"
    run(["g++", "-O2", "-DNDEBUG", "-std=c++20", "-w", f"-I{HERE.parent}", f"-I{HERE.parents[1]}/core/base/include",
         f"{HERE}/enki.cpp", "-lenki", "-o", str(program)])
    return program


def peers(folder):
    """Programs that speak as enki.cpp does, by name."""
    found = {"Enki": build_enki(folder)}
    others = os.environ.get("EYEBRIDGE_PEERS")
    if others:
        found |= {path.name.removeprefix("peer_"): path for path in sorted(pathlib.Path(others).glob("peer_*")) if os.access(path, os.X_OK)}
    if len(found) == 1:
        print("Enki alone. To add Stage, ARGoS or another one: write a program for it that takes the words and prints the line of\n"
              "bench/peers/README.md, name it peer_NAME, and give its folder in EYEBRIDGE_PEERS.\n")
    return found


def write_world(folder, data, robots):
    """The place of walls.csv and robots.csv as a world of EyeSim's, with programs' robots in it."""
    with open(data / "walls.csv", encoding="ascii") as file:
        walls = [list(map(float, row)) for row in csv.reader(file) if not row[0].startswith("#")]
    with open(data / "robots.csv", encoding="ascii") as file:
        starts = [list(map(float, row)) for row in csv.reader(file) if not row[0].startswith("#")]
    lines = ["floor 41000 41000"]
    for x, y, length, thickness, angle in walls:
        forward = (length / 2 * math.cos(angle), length / 2 * math.sin(angle))
        lines.append(" ".join(f"{1000 * c:.0f}" for c in (20.5 + x - forward[0], 20.5 + y - forward[1], 20.5 + x + forward[0],
                                                          20.5 + y + forward[1], thickness, 0.2)))
    (folder / "arena.wld").write_text("\n".join(lines) + "\n")
    bearings = [angle if angle <= 180 else angle - 360 for angle in range(0, 360, 45)]
    (folder / "Rover.robi").write_text(
        "name Rover\ndiameter 200\nspeed 600\nturn 300\naccel 1000000 1000000\n"
        + "".join(f"psd PSD{i} {i} 0 0 30 {bearing}\n" for i, bearing in enumerate(bearings, 1))
        + "psd_range 0 4000\nwheel 54 3600 1100 90\ndrive DIFFERENTIAL_DRIVE\n")
    (folder / "arena.sim").write_text(
        "world arena.wld\nrobot Rover.robi\n"
        + "".join(f"Rover {1000 * x + 20500:.0f} {1000 * y + 20500:.0f} {math.degrees(a):.1f}\n" for x, y, a in starts[:robots]))
    return folder / "arena.sim"


def program_run(build, world, robots, step, seconds):
    """Many copies of wander.c, less what starting them costs."""
    def once(simulated):
        return measured([f"{build}/bin/eyebridge", "run", "--fast", "--step", str(step), "--robots", "all", "--world", world,
                         f"{build}/bench/wander", str(simulated)])
    spent, _, said = once(seconds)
    start, _, _ = once(0)
    lines = [figures(line) for line in said.splitlines()]
    total = {name: sum(line[name] for line in lines) for name in lines[0]}
    return {"cpu_s": spent - start, "distance_m": total["distance_m"] / robots, "range_m": total["range_m"] / total["rays"],
            "hits": total["hits"] / total["rays"]}


def tasks_of(build, data, others, folder, sense, step_ms, robots):
    seconds, step = SIZES[robots], step_ms / 1000
    tasks = {name: lambda program=program: figures(run([program, sense, str(robots), str(step), str(seconds), data]))
             for name, program in others.items()}
    for name, wanted in OURS.items():
        if (sense, step_ms) not in wanted:
            continue
        if name == "program in C":
            world = write_world(folder, data, robots)
            tasks[name] = lambda: program_run(build, world, robots, step, seconds)
            continue
        # The peers' robots slide without friction.
        command = [f"{build}/bin/bench_scale", "--sense", sense, "--robots", str(robots), "--step", str(step), "--seconds", str(seconds),
                   "--friction", "0", "--data", data, *FLAGS.get(name, [])]
        tasks[name or sense] = lambda command=command: figures(run(command))
    return tasks


def differ(ours, theirs, rim):
    """What makes the work another one; "" where it is the same. Sensors around the rim see other ranges."""
    names = ["distance_m"] if rim else ["distance_m", "range_m", "hits"]
    apart = [name for name in names if abs(ours[name] - theirs[name]) > SAME * max(abs(theirs[name]), 1e-9)]
    return ", ".join(f"{name} {ours[name]:.3f} by {theirs[name]:.3f}" for name in apart)


def main(build, data, quick):
    data = pathlib.Path(data)
    targets = Targets()
    another = 0
    if quick:
        SIZES.clear()
        SIZES[100] = 60
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        others = peers(folder)
        print(f"{'sense':6} {'step':>5} {'robots':>6}  {'who':15} {'µs a decision: least, median, most':>34} {'times':>7} {'wanted':>6}")
        for sense, step_ms in (("psd", 100), ("psd", 10), ("lidar", 100), ("lidar", 10), ("none", 100), ("none", 10)):
            for robots, seconds in SIZES.items():
                results = in_rounds(tasks_of(build, data, others, folder, sense, step_ms, robots), 1 if quick else ROUNDS)
                decisions = robots * seconds * 10
                cost = {who: [1e6 * result["cpu_s"] / decisions for result in rounds] for who, rounds in results.items()}
                best = min(others, key=lambda who: statistics.median(cost[who]))
                for who, rounds in results.items():
                    low, middle, high = spread(cost[who])
                    line = f"{sense:6} {step_ms:5} {robots:6}  {who:15} {low:14.3f} {middle:9.3f} {high:9.3f}"
                    if who in others:
                        print(line)
                        continue
                    apart = differ(rounds[0], results[best][0], who == "around the rim")
                    if apart:
                        another += sense != "lidar"  # Enki's is a camera of pixels, not of rays
                        print(f"{line}   not the same work as {best}'s: {apart}")
                        continue
                    wanted = OURS[who if who in OURS else ""][sense, step_ms]
                    wanted = wanted[robots] if isinstance(wanted, dict) else wanted
                    times = statistics.median(theirs / ours for theirs, ours in zip(cost[best], cost[who]))
                    print(f"{line} {times:7.1f} {wanted:6}{targets.judge(times, least=wanted)}", flush=True)
    if quick:
        sys.exit(1 if another else 0)
    targets.end()


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["quick"]):
        sys.exit(__doc__)
    main(*sys.argv[1:3], quick=len(sys.argv) == 4)
