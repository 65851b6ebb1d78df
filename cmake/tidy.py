"""Runs clang-tidy-14 on what BUILD compiles, and only on what has changed since it found nothing: tidy.py BUILD STAMPS [--shipped].

--shipped leaves out tests, benchmarks, windows, commands and examples, two thirds of the time, and says so. Prints what it finds; exits with 1 when there is any.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Precompiled headers are g++'s own; the sanitizers only make clang-tidy slower.
DROPPED = re.compile(
    r" -include \S*cmake_pch\.hxx| -Winvalid-pch| -fpch-preprocess| -fsanitize=\S+"
    r"| -fno-sanitize-recover=\S+| -Wno-maybe-uninitialized| -Wno-restrict| -Wno-subobject-linkage"
)
OBJECT = re.compile(r" -o (\S+)")


def commands(build: pathlib.Path) -> list[dict]:
    """The entries of compile_commands.json for our sources, as clang-tidy can read them."""
    entries = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        generated = ROOT / "build" in file.parents and not file.name.startswith("unity_")
        if file.is_relative_to(ROOT) and not generated:
            entries.append({**entry, "command": DROPPED.sub("", entry["command"])})
    return entries


def included(build: pathlib.Path) -> dict[str, list[pathlib.Path]]:
    """What each object was made from, as ninja knows since it was built."""
    found: dict[str, list[pathlib.Path]] = {}
    for line in subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True).stdout.splitlines():
        if line.startswith("    "):
            files.append(build / line.strip())
        elif ": #deps" in line:
            files = found.setdefault(line.split(":")[0], []) if line.endswith("(VALID)") else []
    return found


def state_of(file: pathlib.Path) -> str:
    if not file.exists():
        return "gone"
    if file.is_relative_to(ROOT) and file.suffix != ".gch":
        return hashlib.sha256(file.read_bytes()).hexdigest()
    status = file.stat()
    return f"{status.st_size} {status.st_mtime_ns}"


def is_shipped(entry: dict, build: pathlib.Path) -> bool:
    file = pathlib.Path(entry["file"])
    room = file.relative_to(build if file.is_relative_to(build) else ROOT).parts[0]
    return room not in ("tests", "bench", "gui", "apps", "examples")


def main(build: pathlib.Path, stamps: pathlib.Path, shipped: bool) -> int:
    entries = commands(build)
    if shipped:
        count = len(entries)
        entries = [entry for entry in entries if is_shipped(entry, build)]
        print(f"left to ./test tidy: {count - len(entries)} of {count} compilations, those of tests, benchmarks, windows, commands and examples", flush=True)
    if not entries:
        print(f"{build}: error: compiles nothing of ours")
        return 1
    stamps.mkdir(parents=True, exist_ok=True)
    (stamps / "compile_commands.json").write_text(json.dumps(entries, indent=1))
    tool = subprocess.run(["clang-tidy-14", "--version"], capture_output=True, text=True, check=True).stdout
    rules = tool + (ROOT / ".clang-tidy").read_text()
    files = included(build)
    states: dict[pathlib.Path, str] = {}

    def stamp(entry: dict) -> pathlib.Path | None:
        """Named after all that the result depends on; None where that is not known."""
        made_from = files.get(OBJECT.search(entry["command"])[1])
        if not made_from:
            return None
        for file in made_from:
            if file not in states:
                states[file] = state_of(file)
        text = "\n".join([rules, entry["command"], *(f"{file} {states[file]}" for file in made_from)])
        return stamps / (hashlib.sha256(text.encode()).hexdigest() + ".passed")

    def check(entry: dict, passed: pathlib.Path | None) -> str:
        result = subprocess.run(["clang-tidy-14", "-quiet", "-p", stamps, entry["file"]], capture_output=True, text=True)
        if result.returncode != 0:
            return result.stdout + result.stderr
        if passed:
            passed.touch()
        return ""

    marks = [(entry, stamp(entry)) for entry in entries]
    for old in set(stamps.glob("*.passed")) - {passed for _, passed in marks}:
        old.unlink()
    todo = [(entry, passed) for entry, passed in marks if not (passed and passed.exists())]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        findings = [text for text in pool.map(lambda mark: check(*mark), todo) if text]
    print("".join(findings), end="")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:] == ["--shipped"]))
