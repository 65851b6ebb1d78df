#!/usr/bin/env python3
"""Changes one place of the code at a time and asks the tests of its room: who is not killed shows what no test checks.

usage: run.py [ROOM] [--count N] [--seed N]
ROOM is a folder: core/world, core, bridges, hal, camera (all four). In a clone of the last commit, in build/mutants.
The exit code is 1 if the tests kill less than 97 % of the mutants. Those in equal.txt do not count.
"""

import argparse
import os
import pathlib
import random
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TREE = ROOT / "build/mutants/tree"
BUILD = TREE / "build/release"
EQUAL = pathlib.Path(__file__).with_name("equal.txt")
WANTED = 97.0  # per cent
# Compiled in a third of the time; and a read past an array's end is the end of the test.
QUICK = ["-DCMAKE_CXX_FLAGS_RELEASE=-O0 -D_GLIBCXX_ASSERTIONS", "-DEYEBRIDGE_WERROR=OFF", "-DEYEBRIDGE_WITH_BENCH=OFF"]

# What is written, and what it becomes. Each matches within one line of code.
OPERATORS = [
    (r"(?<=[\w)\]] )<=(?= )", "<"), (r"(?<=[\w)\]] )<(?= [\w(-])", "<="), (r"(?<=[\w)\]] )>=(?= )", ">"),
    (r"(?<=[\w)\]] )>(?= [\w(-])", ">="), (r" == ", " != "), (r" != ", " == "), (r" && ", " || "), (r" \|\| ", " && "),
    (r"(?<=[\w)\]]) \+ (?=[\w(])", " - "), (r"(?<=[\w)\]]) - (?=[\w(])", " + "), (r"(?<=[\w)\]]) \* (?=[\w(])", " / "),
    (r"(?<=[\w)\]]) / (?=[\w(])", " * "), (r"\+= ", "-= "), (r"-= ", "+= "), (r"\bstd::min\b", "std::max"),
    (r"\bstd::max\b", "std::min"), (r"\btrue\b", "false"), (r"\bfalse\b", "true"), (r"(?<![\w.])0(?![\w.])", "1"),
    (r"(?<![\w.])1(?![\w.])", "2"), (r"\+\+(?=\w)", "--"), (r"\bcontinue;", ";"), (r"\bbreak;", ";"), (r"!(?=[\w(])", ""),
]  # fmt: skip
A_STATEMENT = re.compile(r"^\s+[\w.>\[\]()-]+(\(.*\)| [-+*/|&^]?= .*);\s*(//.*)?$")
NO_CODE = re.compile(r"^\s*(//|\*|#|using |namespace|template|constexpr|static_assert|assert|\[\[noreturn)|ConfigError|fail\(|fmt::|\"")


def shell(*words, limit=3600):
    """The exit code and all output; 124 where it took longer than `limit` seconds."""
    try:
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                              timeout=limit, stdin=subprocess.DEVNULL, check=False)  # fmt: skip
        return done.returncode, done.stdout
    except subprocess.TimeoutExpired:
        return 124, ""


def must(*words):
    code, out = shell(*words)
    if code != 0:
        sys.exit(f"mutants: {' '.join(map(str, words))}\n{out}")


def sites(rooms):
    """All places that can be changed: file, number of the line from 0, the line, and what it becomes."""
    for room in rooms:
        for path in sorted((TREE / room).rglob("*.[ch]pp")):
            for number, line in enumerate(path.read_text().split("\n")):
                if NO_CODE.search(line):
                    continue
                code = line.split("//")[0]
                for pattern, other in OPERATORS:
                    for match in re.finditer(pattern, code):
                        yield path, number, line, line[: match.start()] + other + line[match.end() :]
                if A_STATEMENT.match(line) and "return" not in line:
                    yield path, number, line, "  ;"


def tests_of(path):
    """The names of the unit tests of the room that `path` is in, as a pattern for ctest."""
    parts = path.relative_to(TREE).parts
    return f"^{parts[0]}_{parts[1]}@" if parts[0] == "core" else f"^{parts[0]}(_.*)?@"


def targets_of(pattern):
    _, listed = shell("ctest", "--test-dir", str(BUILD), "-N", "-R", pattern, "-LE", "lab|slow")
    return ["test_" + name for name in re.findall(r"Test +#\d+: ([\w]+)@", listed)]


def outcome(path, number, mutated):
    """killed, survived, or no program."""
    pattern = tests_of(path)
    targets = targets_of(pattern)
    if not targets:
        return "no tests"
    text = path.read_text()
    lines = text.split("\n")
    lines[number] = mutated
    path.write_text("\n".join(lines))
    try:
        code, _ = shell("cmake", "--build", str(BUILD), "--target", *targets)
        if code != 0:
            return "no program"
        # A test has ten minutes, but the endless loop of a mutant is one that it killed.
        code, _ = shell("timeout", "-k", "5", "200", "ctest", "--test-dir", str(BUILD), "-j2", "-R", pattern, "-LE", "lab|slow",
                        "--stop-on-failure")  # fmt: skip
        return "survived" if code == 0 else "killed"
    finally:
        path.write_text(text)


def prepare(rooms):
    if TREE.exists():
        must("git", "-C", str(TREE), "fetch", "-q", "origin")
        must("git", "-C", str(TREE), "checkout", "-q", "-f", "--detach", "origin/HEAD")
    else:
        must("git", "clone", "-q", str(ROOT), str(TREE))
    if not (BUILD / "build.ninja").exists():
        must("cmake", "-S", str(TREE), "--preset", "release", *QUICK)
    for pattern in sorted({tests_of(TREE / room / "x" / "x") for room in rooms}):
        targets = targets_of(pattern)
        if targets:
            must("cmake", "--build", str(BUILD), "--target", *targets)


def main():
    os.environ["GTEST_FAIL_FAST"] = "1"
    options = argparse.ArgumentParser(description="See the top of this file.")
    options.add_argument("room", nargs="?", default="")
    options.add_argument("--count", type=int, default=200)
    options.add_argument("--seed", type=int, default=1)
    options = options.parse_args()
    rooms = [options.room] if options.room else ["core", "bridges", "hal", "camera"]
    for room in rooms:
        if not (ROOT / room).is_dir() or room.split("/")[0] not in ("core", "bridges", "hal", "camera"):
            sys.exit(f"mutants: found {room!r}, expected a folder of core, bridges, hal or camera")
    equal = {line.split("|")[0].strip() for line in EQUAL.read_text().split("\n") if "|" in line}
    prepare(rooms)
    all_sites = list(sites(rooms))
    random.Random(options.seed).shuffle(all_sites)
    counts = {"killed": 0, "survived": 0, "equal": 0}
    try:
        for path, number, line, mutated in all_sites:
            if sum(counts.values()) >= options.count:
                break
            name = f"{path.relative_to(TREE)}: {line.strip()} -> {mutated.strip()}"
            found = "equal" if name in equal else outcome(path, number, mutated)
            if found not in counts:
                continue
            counts[found] += 1
            if found == "survived":
                print(f"{path.relative_to(TREE)}:{number + 1}\n  - {line.strip()}\n  + {mutated.strip()}", flush=True)
    except KeyboardInterrupt:
        print("ended before its time", flush=True)  # and so far:
    judged = counts["killed"] + counts["survived"]
    share = 100.0 * counts["killed"] / judged if judged else 0.0
    print(f"{counts['killed']} of {judged} mutants killed ({share:.1f} %), {counts['equal']} called equal; wanted {WANTED:.0f} %")
    return 0 if share >= WANTED else 1


if __name__ == "__main__":
    sys.exit(main())
