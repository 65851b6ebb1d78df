"""What must hold whatever has happened: files are whole or not there, a message comes once, memory does not grow, nobody is
left. Judged by SQLite, by Python's TOML, CSV and zlib, and by /proc: by nothing of ours."""
import contextlib
import csv
import os
import pathlib
import shutil
import sqlite3
import struct
import tempfile
import time
import tomllib
import zlib

GROWTH = 1.10  # of resident memory, from a third of the run on
LEFT_BY_ROBOT_KB = 12  # its place in the world, its sensors, its results
GROWTH_KB = 4096


def wrong_recording(path):
    """Why a recording cannot be read; None: it can, or is not there. In a copy: reading one whose writer was killed puts it in order."""
    if not path.exists():
        return None
    with tempfile.TemporaryDirectory() as folder:
        for part in path.parent.glob(path.name + "*"):
            shutil.copy(part, folder)
        try:
            with contextlib.closing(sqlite3.connect(pathlib.Path(folder) / path.name)) as base:
                found = base.execute("PRAGMA integrity_check").fetchone()[0]
                return None if found == "ok" else f"{path.name}: {found}"
        except sqlite3.Error as error:
            return f"{path.name}: {error}"


def wrong_report(path):
    if not path.exists():
        return None
    try:
        tomllib.loads(path.read_text())
        return None
    except ValueError as error:
        return f"{path.name}: {error}"


def wrong_picture(path):
    data = path.read_bytes()
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        return f"{path.name}: no PNG"
    at, kind = 8, b""
    while at + 12 <= len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        chunk = data[at + 4 : at + 8 + size]
        if at + 12 + size > len(data) or zlib.crc32(chunk) != struct.unpack(">I", data[at + 8 + size : at + 12 + size])[0]:
            return f"{path.name}: a part of it is missing or damaged"
        at += 12 + size
    return None if kind == b"IEND" else f"{path.name}: it has no end"


def wrong_table(path):
    with open(path, newline="") as file:
        text = file.read()
    rows = list(csv.reader(text.splitlines()))
    if text and (not text.endswith("\n") or len({len(row) for row in rows}) != 1):
        return f"{path.name}: a row of it is not whole"
    return None


CHECKS = {".ebrec": wrong_recording, ".report": wrong_report, ".png": wrong_picture, ".csv": wrong_table}


def wrong_files(folder, is_cut=False):
    """What is not whole in a folder of results, a sentence each. `is_cut`: tables may end within a row, as their writer was killed or
    its disk was full. What is in `home` was there before."""
    found = []
    for path in sorted(folder.rglob("*")):
        if path.is_relative_to(folder / "home") or (is_cut and path.suffix == ".csv"):
            continue
        check = CHECKS.get(path.suffix)
        if check is not None and path.is_file() and (wrong := check(path)) is not None:
            found.append(wrong)
    return found


def said_twice(text):
    """A line of ours that came more than once: a message that is repeated tells nothing new. Guards tell each time that they step in,
    which they must on a computer that is too busy."""
    ours = [line for line in text.splitlines() if line.startswith("eyebridge: ") and not line.startswith("eyebridge: guard of")]
    return next((f"said twice: {line}" for line in ours if ours.count(line) > 1), None)


def resident_kb(processes):
    """Of all of them together; those that are gone have none."""
    total = 0
    for one in processes:
        try:
            total += int(pathlib.Path(f"/proc/{one}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") // 1024
        except OSError:
            pass
    return total


def children_of(process):
    """All processes that it has started, and those that they have."""
    found = []
    for task in pathlib.Path("/proc").glob(f"{process}/task/*/children"):
        try:
            for child in map(int, task.read_text().split()):
                found += [child, *children_of(child)]
        except OSError:
            pass
    return found


def grew(samples):
    """`samples`: resident memory, kB, and how many robots had come, in time. None: it did not grow from a third of the run on, but by
    the little that each robot leaves which has gone."""
    if len(samples) < 9:
        return None
    third = len(samples) // 3
    (before, some), (after, all_of_them) = (sorted(part)[third // 2] for part in (samples[third : 2 * third], samples[-third:]))
    if after > before * GROWTH + GROWTH_KB + LEFT_BY_ROBOT_KB * max(all_of_them - some, 0):
        return f"resident memory grew from {before} kB to {after} kB, while {all_of_them - some} robots came"
    return None


def processes_in(folder):
    """Those that work in this folder: of a run that has ended there must be none."""
    found = []
    for process in filter(str.isdigit, os.listdir("/proc")):
        try:
            if pathlib.Path(os.readlink(f"/proc/{process}/cwd")).is_relative_to(folder):
                found.append((int(process), pathlib.Path(f"/proc/{process}/comm").read_text().strip()))
        except OSError:
            pass  # it has ended
    return found


def left_over(folder, patience=10.0):
    """Who still works in `folder` after `patience` seconds; None: nobody."""
    end = time.monotonic() + patience
    while left := processes_in(folder):
        if time.monotonic() > end:
            return f"left over: {left}"
        time.sleep(0.05)
    return None
