"""How much of what a fuzzer reaches its inputs have run, by clang's source-based coverage."""
import json
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODE_REGION = 0  # the kind that is code, of llvm-cov's JSON


def regions_run(fuzzer, corpus, scratch):
    """Regions of our code that the inputs in `corpus` run, and all of the functions that they reach. `fuzzer` is one of a build with
    -fprofile-instr-generate -fcoverage-mapping."""
    raw, merged = scratch.with_suffix(".profraw"), scratch.with_suffix(".profdata")
    subprocess.run([fuzzer, "-runs=0", "-verbosity=0", corpus], env={**os.environ, "LLVM_PROFILE_FILE": str(raw)}, check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # fmt: skip
    subprocess.run(["llvm-profdata", "merge", "-sparse", raw, "-o", merged], check=True)
    found = subprocess.run(["llvm-cov", "export", "-skip-expansions", f"-instr-profile={merged}", fuzzer], check=True,
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)  # fmt: skip
    run = there = 0
    seen = set()
    for function in json.loads(found.stdout)["data"][0]["functions"]:
        path = pathlib.Path(function["filenames"][0])
        ours = path.is_relative_to(ROOT) and not path.is_relative_to(ROOT / "tests")
        if function["count"] == 0 or not ours:
            continue
        for begin, column, end, end_column, count, _, _, kind in function["regions"]:
            place = (path, begin, column, end, end_column)
            # A template's instances share their lines.
            if kind != CODE_REGION or place in seen:
                continue
            seen.add(place)
            there += 1
            run += count > 0
    return run, there
