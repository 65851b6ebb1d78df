#!/usr/bin/env python3
"""./test programs FOLDER: runs every robot program in a folder headless, and prints what came of each.

A program is a .c, .cpp, .cc or .py file that names RoBIOS; a folder with a Makefile, or with several sources of which one
has main(), is one program. One that lies beside exactly one world (.sim, .wld, .maz) runs in that, else in the default room.
Exit code 1 when a program crashed by a signal or hung past its limit of wall-clock time; else 0: what the table says is for
a person to read.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

LIMIT = 120  # seconds of the robot's time
WALL = 60  # seconds until a program hangs
STUCK = 10.0  # seconds that a robot told to move may stand
C_ENDINGS = {".c", ".cpp", ".cc", ".cxx"}
KEYS = ",".join(f"KEY{1 + i % 4}@{2 + 3 * i}s" for i in range(20))
LACKS = re.compile(r"this robot has no ([a-zA-Z]+(?: -?\w+)?)")


def text_of(path):
    return path.read_text(encoding="utf-8", errors="replace")


def is_program(path):
    text = text_of(path)
    if path.suffix == ".py":
        return re.search(r"^\s*(from\s+eye\s+import|import\s+eye\b)", text, re.MULTILINE) is not None
    return re.search(r"\bmain\s*\(", text) is not None


def programs_in(folder):
    """(name, sources): the sources of a folder belong together unless each of them has a main()."""
    for place, _, names in sorted(os.walk(folder)):
        paths = [pathlib.Path(place) / name for name in sorted(names)]
        sources = [path for path in paths if path.suffix.lower() in C_ENDINGS]
        mains = [path for path in sources if is_program(path)]
        others = [path for path in sources if path not in mains]
        for main in mains:
            yield main, [main] + (others if len(mains) == 1 else [])
        for path in paths:
            if path.suffix == ".py" and is_program(path):
                yield path, [path]


def is_classic(sources):
    """Calls that only RoBIOS before RoBIOS-7 has."""
    return any(re.search(r"\b(OSInit|VWInit|PSDInit|MOTORInit|SERVOInit|LCDPutString|KEYGetBuf)\s*\(", text_of(path))
               for path in sources)


def compile_program(sources, output, wrappers):
    if sources[0].suffix == ".py":
        return sources[0], ""
    plus = any(path.suffix.lower() != ".c" for path in sources)
    command = [str(wrappers / ("eyebridge-c++" if plus else "eyebridge-cc"))]
    command += ["--classic"] if is_classic(sources) else []
    command += ["-w", "-o", str(output), *map(str, sources), "-lm", "-lpthread"]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
    return (output if done.returncode == 0 else None), done.stderr


def world_of(source):
    worlds = [path for path in source.parent.iterdir() if path.suffix.lower() in (".sim", ".wld", ".maz")]
    return worlds[0] if len(worlds) == 1 else None


def read_report(path):
    if not path.exists():
        return {}
    pairs = (line.split("=", 1) for line in text_of(path).splitlines() if "=" in line)
    return {key.strip(): value.strip().strip('"') for key, value in pairs}


def run_program(program, source, scratch, wrappers):
    report = scratch / "report.txt"
    command = [str(wrappers / "eyebridge"), "run", "--fast", "--gui=off", "--panel", "none", "--player", "none",
               "--time-limit", f"{LIMIT}s", "--hang-limit", "20s", "--keys", KEYS, "--report", str(report)]
    world = world_of(source)
    command += ["--world", str(world)] if world else []
    begin = time.monotonic()
    try:
        done = subprocess.run([*command, str(program)], cwd=source.parent, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, errors="replace", timeout=WALL, check=False)
        code, err = done.returncode, done.stderr
    except subprocess.TimeoutExpired as late:
        code, err = "hangs", (late.stderr or b"").decode(errors="replace")
    return code, err, read_report(report), time.monotonic() - begin


def end_of(code, report):
    if code == "hangs":
        return f"hangs ({WALL} s)"
    if code < 0 or code >= 128:
        return f"crashes ({-code if code < 0 else code - 128})"
    if code == 124:
        return "no call"
    if code == 0 and float(report.get("time", 0)) >= LIMIT:
        return "at the limit"
    return "ends" if code == 0 else f"exit {code}"


def row_of(source, sources, scratch, wrappers):
    program, errors = compile_program(sources, scratch / "program.x", wrappers)
    if program is None:
        first = next((line for line in errors.splitlines() if "error" in line), errors.strip().splitlines()[-1])
        return ["no", "", first[:60], "", "", ""], False
    code, err, report, wall = run_program(program, source, scratch, wrappers)
    lacks = sorted(set(LACKS.findall(err)))
    stuck = float(report.get("stuck", 0))
    end = end_of(code, report)
    row = ["yes", f"{float(report.get('distance', 0)):.2f}", ", ".join(lacks), f"{stuck:.0f}" if stuck >= STUCK else "",
           end, f"{float(report.get('time', 0)):.1f} / {wall:.1f}"]
    return row, end.startswith(("hangs", "crashes"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of eyebridge and eyebridge-cc")
    options = parser.parse_args()
    if not options.folder.is_dir():
        sys.exit(f"{options.folder}: no folder; expected one with robot programs")
    rows = []
    bad = 0
    for source, sources in programs_in(options.folder.resolve()):
        with tempfile.TemporaryDirectory() as scratch:
            row, is_bad = row_of(source, sources, pathlib.Path(scratch), options.bin.resolve())
        bad += is_bad
        rows.append([str(source.relative_to(options.folder.resolve())), *row])
        print(".", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    if not rows:
        sys.exit(f"{options.folder}: no robot program in it; expected .c, .cpp or .py files with main() or 'from eye import'")
    head = ["program", "compiles", "moves, m", "lacks", f"stuck, s (from {STUCK:.0f})", "end", "s: robot / wall"]
    widths = [max(len(row[i]) for row in [head, *rows]) for i in range(len(head))]
    for row in [head, *rows]:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())
    print(f"{len(rows)} programs, {sum(row[1] == 'yes' for row in rows)} compile, {bad} crash or hang, "
          f"{sum(bool(row[4]) for row in rows)} stuck, {sum(bool(row[3]) and row[1] == 'yes' for row in rows)} lack a device")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
