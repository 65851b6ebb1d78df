#!/usr/bin/python3
"""Runs robots in worlds and prints the hash of each run; compares such lists.

same_bits.py run BUILD [--thin]      one line a run: name, tab, hash. BUILD is a build folder; the processor is this interpreter's
same_bits.py table NAME=FILE...      those lists side by side, Markdown; exits with 1 when they differ, and says where
"""

import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SEEDS = range(1, 6)
PATIENCE = 600  # seconds a run, on an emulated processor

# name, what runs and where, settings as `eyebridge run` takes them, -- and the program's own arguments. One seed of each with * is enough for ./test all.
RUNS = [
    ("square *", "examples/square", "--world empty-room.wld --errors realistic"),
    ("square, every error", "examples/square", "--world noisy-room.sim --errors harsh"),
    ("wall follower", "examples/wall_follower", "--world corridor.wld --errors realistic --time-limit 40s"),
    ("wall follower among things that move *", "examples/wall_follower", "--world moving-things.sim --errors harsh --time-limit 40s"),
    ("wall follower in a busy hall", "examples/wall_follower", "--world busy-hall.sim --errors realistic --time-limit 40s"),
    ("evolved follower", "examples/evolved_follower", "--world u-trap.wld --errors realistic --time-limit 40s -- 0.33 11.8 6.5 0.5 0.49 3.5"),
    ("maze explorer, 5 x 5 *", "examples/maze_explorer", "--world maze-5.maz --errors realistic"),
    ("maze explorer, 8 x 8", "examples/maze_explorer", "--world maze-8.maz --errors realistic"),
    ("maze explorer, 16 x 16", "examples/maze_explorer", "--world micromouse-16.maz --robot Mouse --errors realistic --time-limit 60s"),
    ("classic patrol *", "examples/classic_patrol", "--world rooms.wld --errors realistic"),
    ("mecanum wheels *", "tests/robios/programs/mecanum", "--world empty-room.wld --robot Omni --errors realistic"),
    ("a car", "tests/robios/programs/car", "--world empty-room.wld --robot Car --errors harsh"),
    ("a submarine *", "tests/robios/programs/submarine", "--world empty-room.wld --robot USAL --errors realistic"),
    ("gyroscope and accelerometer", "tests/robios/programs/inertial", "--world rooms.wld --errors harsh"),
    ("threads of a program *", "tests/robios/programs/families", "--world rooms.wld --errors realistic --camera pattern:"),
    ("two robots, radio", "tests/robios/programs/pingpong", "--world rooms.wld --robots 2 --errors realistic --time-limit 20s"),
    ("a fleet of 20 *", "examples/wall_follower", "--world obstacles.sim --robots 20 --errors realistic --time-limit 20s"),
    ("soccer, 5 against 5", "examples/soccer", "--world soccer-5v5.sim --robots all --errors realistic --time-limit 30s"),
    ("Python: wall follower *", SOURCE / "examples/wall_follow.py", "--world corridor.wld --errors realistic --time-limit 20s"),
    ("Python: explorer with maps", SOURCE / "examples/control/explore.py", "--world rooms.wld --time-limit 60s"),
    ("Python: 32 simulations at once *", SOURCE / "tests/machines/batch.py", ""),
]


def settings(arguments, seed, report):
    """Those of `eyebridge run` as variables, with which a program is run directly."""
    out = {"EYEBRIDGE_FAST": "true", "EYEBRIDGE_PANEL": "none", "EYEBRIDGE_GUI": "off", "EYEBRIDGE_SEED": str(seed), "EYEBRIDGE_REPORT": str(report)}
    for name, value in re.findall(r"--(\S+) (\S+)", arguments):
        value = str(SOURCE / "worlds" / value) if name == "world" else value
        out["EYEBRIDGE_" + name.upper().replace("-", "_")] = value
    return out


def run_hash(build, what, arguments, seed):
    """What came of one run: state and trace hash of its report, or what it printed after "hash"."""
    program = what if isinstance(what, pathlib.Path) else build / what
    environment = {name: value for name, value in os.environ.items() if not name.startswith("EYEBRIDGE_")}
    environment |= {"PYTHONPATH": str(build / "python"), "PYTHONDONTWRITEBYTECODE": "1"}
    arguments, _, own = arguments.partition(" -- ")
    words = [sys.executable, program] if isinstance(what, pathlib.Path) else [program]
    with tempfile.TemporaryDirectory(prefix="eyebridge-same-bits-") as folder:
        report = pathlib.Path(folder) / "report"
        words += own.split()
        if not arguments:
            words.append(seed)
        else:
            environment |= settings(arguments, seed, report)
        if "control" in program.parts:
            words = [build / "bin/eyebridge", "run", program]
        done = subprocess.run([str(word) for word in words], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=PATIENCE, check=False)  # fmt: skip
        text = report.read_text() if report.exists() else done.stdout
    found = re.findall(r'(?:state_hash = "|trace_hash = "|hash )([0-9a-f]{16})', text)
    found += re.findall(r", trace ([0-9a-f]{16})", done.stderr)
    if not found:
        command = " ".join(f"{name}={value}" for name, value in environment.items() if name.startswith("EYEBRIDGE_"))
        sys.exit(f"same_bits: found no hash after exit code {done.returncode}: {command} {' '.join(map(str, words))}\n"
                 + done.stdout[-2000:] + done.stderr[-2000:])  # fmt: skip
    return "/".join(found)


def run(build, thin):
    for name, what, arguments in RUNS:
        if thin and not name.endswith(" *"):
            continue
        for seed in SEEDS if not thin else (1, 2):
            print(f"{name.removesuffix(' *')}, seed {seed}", run_hash(build.resolve(), what, arguments, seed), sep="\t", flush=True)


def read(path):
    return dict(line.rstrip("\n").split("\t") for line in open(path))


def short(hashes):
    """One word for several runs: 8 digits of a hash of theirs."""
    return hashlib.sha256(" ".join(hashes).encode()).hexdigest()[:8]


def table(columns):
    """Rows are programs; a cell has the number of runs that are the same as in the first column, and one word for all of them."""
    lists = {name: read(path) for name, path in (column.split("=", 1) for column in columns)}
    first = next(iter(lists.values()))
    rows = {}
    for key in first:
        rows.setdefault(key.rsplit(", seed ", 1)[0], []).append(key)
    print("| runs | number |", " | ".join(lists), "|")
    print("|---|---|" + "---|" * len(lists))
    wrong, compared = [], 0
    for row, keys in rows.items():
        cells = []
        for name, values in lists.items():
            have = [key for key in keys if key in values]
            differ = [key for key in have if values[key] != first[key]]
            wrong += [f"{name}: {key}: {values[key]}, expected {first[key]}" for key in differ]
            compared += len(have) if values is not first else 0
            cells.append("-" if not have else f"{len(differ)} differ" if differ else short([values[key] for key in have]))
        print(f"| {row} | {len(keys)} |", " | ".join(cells), "|")
    print(f"\n{len(first)} runs, {compared} compared with the first column, {len(wrong)} differ.")
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong or not compared else 0


def main():
    words = sys.argv[1:]
    if words[:1] == ["run"] and len(words) in (2, 3):
        return run(pathlib.Path(words[1]), words[2:] == ["--thin"])
    if words[:1] == ["table"] and len(words) > 2:
        return table(words[1:])
    sys.exit(__doc__)


if __name__ == "__main__":
    sys.exit(main())
