#!/usr/bin/env python3
"""Checks the tree against the design: who includes whom and forgets to, no circles, READMEs that are true, no long files.

check_arrows.py ROOT prints one line for each offence and exits with 1 when there is any.
"""

import pathlib
import re
import sys

from circles import check_circles
from forgotten import check_forgotten, check_unused
from maps import check_maps

SOURCES = {".c", ".h", ".cpp", ".hpp", ".ipp", ".py", ".sh", ".cmake"}
CODE = {".c", ".h", ".cpp", ".hpp", ".ipp"}
LONGEST_SOURCE = 400
LONGEST_README = 29
SKIPPED = {"build", "out", ".git", "__pycache__", ".cache"}

GRIDS = ["core/mapping", "core/planning", "core/localisation"]
CORE = ["core/base", "core/world", "core/robot", "core/files", "core/episode", *GRIDS]
BACKENDS = ["hal/sim", "hal/shared", "hal/remote_robot", "hal/board", "hal/replay", "hal/hand", "hal/host"]
FIRMWARE = ["firmware-stubs/board", "firmware-stubs/rover", "firmware-stubs/ports", "firmware-stubs/pins",
            "firmware-stubs/mps2"]
EVERYTHING = [*CORE, "hal", *BACKENDS, "camera", "robios", "bridges", *FIRMWARE, "apps", "gui", "tests"]

# Room -> what it may include besides itself. The longest room that holds a file is the file's.
ALLOWED = {
    "core/base": [],
    "core/world": ["core/base"],
    "core/robot": ["core/base", "core/world"],
    "core/files": ["core/base", "core/world", "core/robot", "core/mapping"],
    "core/episode": ["core/base", "core/world", "core/robot", "core/files"],
    "core/mapping": ["core/base", "core/world", "core/robot"],
    "core/planning": ["core/base", "core/mapping"],
    "core/localisation": ["core/base", "core/world", "core/robot", "core/mapping"],
    "camera": CORE,
    "bridges": ["core/base"],
    "hal": [*CORE, "camera:view.hpp"],
    "hal/registry": [*CORE, "hal", "camera:view.hpp", *BACKENDS],
    "hal/sim": [*CORE, "hal", "camera"],
    "hal/shared": [*CORE, "hal", "hal/sim", "hal/host"],
    "hal/remote_robot": [*CORE, "hal", "hal/sim", "camera:view.hpp"],
    "hal/replay": [*CORE, "hal", "camera"],
    "hal/hand": [*CORE, "hal", "camera"],
    "hal/host": [*CORE, "hal", "bridges"],
    "hal/board": [*CORE, "hal", "bridges"],
    "robios": [*CORE, "hal", "camera"],
    "firmware-stubs/board": ["bridges:opcodes.h"],
    "firmware-stubs/rover": ["firmware-stubs/board"],
    "firmware-stubs/ports": ["core/base", "firmware-stubs/board", "firmware-stubs/rover"],
    "firmware-stubs/pins": [*CORE, "firmware-stubs/board", "firmware-stubs/rover"],
    "firmware-stubs/mps2": [*CORE, "firmware-stubs/board", "firmware-stubs/ports", "firmware-stubs/pins"],
    "gui": [*CORE, "hal", "camera", "robios"],
    "python": [*CORE, "hal", "camera", "robios"],
    "apps": [*CORE, "hal", "hal/replay", "camera", "robios", "bridges", *FIRMWARE],
    "examples": ["robios:eyebot.h", "robios:eyebot++.h"],
    "examples/training": [*CORE, "robios:eyebot.h"],
    "tests": EVERYTHING,
    "bench": EVERYTHING,
}

# eyebridge/<this>/… -> the room whose public header it is.
PUBLIC = {room.split("/")[-1]: room for room in ALLOWED if room.startswith("core/")} | {
    name: name for name in ("hal", "camera", "bridges", "robios", "gui")
} | {name: f"firmware-stubs/{name}" for name in ("ports", "pins", "mps2")}

# Rooms that may look at another one's private headers.
CURIOUS = {"tests", "bench"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<(eye[^>]+)>)')

# Rooms whose results are the same bits on every computer (docs/same-bits.md), and what they may not call for that: the last bits
# of these are the C library's, which has several versions of them for one processor.
SAME_BITS = {"core", "hal", "camera", "robios"}
LIBM = re.compile(
    r"\bstd::(sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|exp2?|expm1|log2?|log10|log1p|pow|hypot|cbrt|erfc?|[lt]gamma)[fl]?\("
)


def room_of(path: pathlib.PurePosixPath) -> str | None:
    """The room that `path`, relative to the root, lies in."""
    rooms = [room for room in ALLOWED if path.is_relative_to(room)]
    return max(rooms, key=len, default=None)


def files_in(root: pathlib.Path) -> list[pathlib.PurePosixPath]:
    """All files of the tree, without what is built or hidden, relative to `root`."""
    found = []
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        hidden = any(part in SKIPPED or part.startswith(".") for part in relative.parts)
        if path.is_file() and not hidden:
            found.append(pathlib.PurePosixPath(relative))
    return found


def target_of(include: str, source: pathlib.PurePosixPath, headers: dict[str, list]) -> str | None:
    """The room that `include`, written in `source`, reaches; None when it is nobody's of ours."""
    words = include.split("/")
    if words[0] == "eyebridge" and len(words) > 2:
        return PUBLIC.get(words[1], words[1])
    # Private headers: the nearest file whose path ends so is the one the compiler finds.
    normal = [word for word in words if word not in ("..", ".")]
    candidates = [file for file in headers.get(normal[-1], []) if file.parts[-len(normal) :] == tuple(normal)]
    if not candidates:
        return None
    home = room_of(source)
    rooms = {room_of(file) for file in candidates}
    if ".." not in words and home in rooms:
        return home
    own_top = {room for room in rooms if room and source.parts[0] == room.split("/")[0]}
    return sorted(own_top or {room or "(no room)" for room in rooms})[0]


def may_include(home: str, target: str, include: str) -> bool:
    if target == home:
        return True
    for rule in ALLOWED[home]:
        room, _, header = rule.partition(":")
        if room == target and (not header or include.endswith(header)):
            return True
    return False


def check_includes(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    headers: dict[str, list] = {}
    for file in files:
        if file.suffix in {".h", ".hpp", ".ipp"}:
            headers.setdefault(file.name, []).append(file)
    offences = []
    for file in files:
        if file.suffix not in CODE:
            continue
        home = room_of(file)
        if home is None:
            offences.append(f"{file}: this folder is no room of the architecture")
            continue
        for number, line in enumerate((root / file).read_text(errors="replace").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            include = match[1] or match[2]
            target = target_of(include, file, headers)
            if target is not None and not may_include(home, target, include):
                offences.append(f"{file}:{number}: {home} may not include {target} ({include})")
            elif target not in (None, home) and "src" in include.split("/") and home not in CURIOUS:
                offences.append(f"{file}:{number}: {home} may only include public headers of {target} ({include})")
    return offences


def check_sizes(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    offences = []
    for file in files:
        if file.name == "README.md" and len(file.parts) > 1:
            limit = LONGEST_README
        elif file.suffix in SOURCES or file.name == "CMakeLists.txt":
            limit = LONGEST_SOURCE
        else:
            continue
        lines = len((root / file).read_text(errors="replace").splitlines())
        if lines > limit:
            offences.append(f"{file}: {lines} lines; expected at most {limit}")
    return offences


def check_libm(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    offences = []
    for file in files:
        if file.parts[0] not in SAME_BITS or file.suffix not in CODE:
            continue
        for number, line in enumerate((root / file).read_text(errors="replace").splitlines(), 1):
            match = LIBM.search(line.partition("//")[0])
            if match:
                offences.append(f"{file}:{number}: {match[0]}) differs between computers; expected base/math.hpp, or std::sqrt")
    return offences


def check_readmes(files: list[pathlib.PurePosixPath]) -> list[str]:
    folders = {file.parts[0] for file in files if len(file.parts) > 1}
    folders |= {str(pathlib.PurePosixPath(*file.parts[:2])) for file in files if file.parts[0] == "core" and len(file.parts) > 2}
    have = {str(file.parent) for file in files if file.name == "README.md"}
    return [f"{folder}: has no README.md" for folder in sorted(folders - have)]


def offences_in(root: pathlib.Path) -> list[str]:
    """One line for each rule that the tree under `root` breaks."""
    files = files_in(root)
    checks = (check_includes, check_circles, check_forgotten, check_unused, check_sizes, check_libm, check_maps)
    return [offence for check in checks for offence in check(root, files)] + check_readmes(files)


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    if not files_in(root):
        print(f"{root}: found no files; expected the source tree")
        return 1
    offences = offences_in(root)
    for offence in offences:
        print(offence)
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
