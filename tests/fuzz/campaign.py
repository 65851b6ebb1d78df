#!/usr/bin/env python3
"""Feeds each fuzzer a number of inputs, and prints what it found. They begin with its corpus and the inputs that earlier runs kept.

usage: campaign.py BUILD OUT [NAME...] [--inputs 100000] [--jobs N] [--seconds S] [--coverage BUILD]
BUILD is a build folder of the preset fuzz; OUT keeps a corpus, a log and findings for each. With --seconds a fuzzer that is
slower ends then. With --coverage, a build for coverage.py, the table says how much of the code that is reached was run. The exit
code is 1 if one found anything.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

from coverage import regions_run

CORPUS = pathlib.Path(__file__).with_name("corpus")


def number(pattern, text):
    found = re.findall(pattern, text)
    return int(found[-1]) if found else 0


def feed(fuzzer, out, inputs, seconds, coverage):
    """The row of its table, and whether it found nothing."""
    name = fuzzer.name.removeprefix("fuzz_")
    corpus = out / "corpus" / name
    corpus.mkdir(parents=True, exist_ok=True)
    for seed in (CORPUS / name).iterdir():
        shutil.copy(seed, corpus)
    before = len(list(corpus.iterdir()))
    limit = [f"-max_total_time={seconds}"] if seconds else []
    done = subprocess.run(
        [fuzzer, f"-runs={inputs}", *limit, "-timeout=10", "-rss_limit_mb=2048", "-verbosity=1", "-print_final_stats=1",
         f"-artifact_prefix={out}/{name}-", corpus],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace", check=False)  # fmt: skip
    (out / f"{name}.log").write_text(done.stderr)
    executed = number(r"stat::number_of_executed_units: +(\d+)", done.stderr)
    grown = len(list(corpus.iterdir()))
    end = "nothing" if done.returncode == 0 else f"see {out}/{name}.log"
    reached = ""
    if coverage:
        run, there = regions_run(coverage / "bin" / fuzzer.name, corpus, out / name)
        reached = f" {100 * run / max(there, 1):.0f} % of {there} |"
    return f"| {name} | {executed} | {before} → {grown} |{reached} {end} |", done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--inputs", type=int, default=100_000)
    parser.add_argument("--seconds", type=int, default=0)
    parser.add_argument("--coverage", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_intermixed_args()
    fuzzers = sorted(path for path in (options.build / "bin").glob("fuzz_*") if os.access(path, os.X_OK))
    if options.names:
        fuzzers = [path for name in options.names for path in fuzzers if path.name == f"fuzz_{name}"]
    if not fuzzers:
        sys.exit(f"campaign: {options.build}/bin: no fuzzers; expected a build of the preset fuzz")
    options.out.mkdir(parents=True, exist_ok=True)
    reached = " code |" if options.coverage else ""
    print(f"| parser | inputs | corpus |{reached} found |\n|---|---:|---:|{'---:|' if reached else ''}---|", flush=True)
    fine = True
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row, is_fine in pool.map(lambda path: feed(path, options.out, options.inputs, options.seconds, options.coverage), fuzzers):
            print(row, flush=True)
            fine = fine and is_fine
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
