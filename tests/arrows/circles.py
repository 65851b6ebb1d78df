"""Folders that include each other in a circle: neither can be read, tested or given away without the other."""

import pathlib
import re

CODE = {".c", ".h", ".cpp", ".hpp", ".ipp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
PRODUCT = {"core", "hal", "bridges", "camera", "firmware-stubs", "robios", "gui", "python", "apps"}


def folder_of(file: pathlib.PurePosixPath) -> str:
    """The second-level folder; public headers are those of the first one."""
    parts = file.parts[:2] if len(file.parts) > 2 else file.parts[:1]
    return "/".join(parts)


def arrows_in(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> dict[str, dict[str, str]]:
    """From folder to folder, with one include as an example."""
    product = [file for file in files if file.suffix in CODE and file.parts[0] in PRODUCT]
    by_name: dict[str, list[pathlib.PurePosixPath]] = {}
    for file in product:
        by_name.setdefault(file.name, []).append(file)
    arrows: dict[str, dict[str, str]] = {}
    for file in product:
        for include in INCLUDE.findall((root / file).read_text(errors="replace")):
            words = tuple(word for word in include.split("/") if word not in ("..", "."))
            ends_so = [other for other in by_name.get(words[-1], []) if other.parts[-len(words):] == words]
            beside = [other for other in ends_so if other.parent == file.parent]
            near = [other for other in ends_so if other.parts[0] == file.parts[0]]
            for target in (beside or near or ends_so)[:1]:
                if folder_of(target) != folder_of(file):
                    arrows.setdefault(folder_of(file), {}).setdefault(folder_of(target), f"{file}: {include}")
    return arrows


def circles_in(arrows: dict[str, dict[str, str]]) -> list[set[str]]:
    """The sets of folders each of which reaches each other one."""
    def reached_from(start: str) -> set[str]:
        found, open_ = set(), [start]
        while open_:
            for target in arrows.get(open_.pop(), {}):
                if target not in found:
                    found.add(target)
                    open_.append(target)
        return found

    reached = {folder: reached_from(folder) for folder in arrows}
    circles = []
    for folder in sorted(arrows):
        circle = {other for other in reached[folder] if folder in reached.get(other, set())}
        if circle and circle not in circles:
            circles.append(circle)
    return circles


def check_circles(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    arrows = arrows_in(root, files)
    offences = []
    for circle in circles_in(arrows):
        examples = [arrows[home][target] for home in sorted(circle) for target in sorted(circle) if target in arrows.get(home, {})]
        offences.append(f"{', '.join(sorted(circle))}: include each other in a circle ({'; '.join(examples)})")
    return offences
