#!/usr/bin/env python3
"""Writes docs/compatibility.md: every function of the references, where it works, how it differs, what tests it.

make_compatibility.py           writes the page
make_compatibility.py --check   exits with 1 when the page is stale, or a function is missing or has no test
"""

import pathlib
import re
import sys
import tomllib

from headers import declared_in, defined_in, differences
from robots import HEAD, robot_rows

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
PAGE = ROOT / "docs" / "compatibility.md"
# Where each generation is declared, and what calls it: programs, then whatever else runs it from outside.
HEADERS = {"RoBIOS-7": ["robios/include/eyebridge_robios"], "classic": ["robios/include/classic", "robios/include/classic/eyebridge_classic"]}
SOURCES = {"RoBIOS-7": "robios/v7", "classic": "robios/classic"}
UNDECLARED = "Exported, but not declared, as in the published library."
CALLERS = {
    "RoBIOS-7": ["tests/gallery/c", "tests/robios/programs", "tests/apps/consumer", "tests/robios/v7", "examples"],
    "classic": ["tests/gallery/classic", "tests/robios/classic", "examples"],
}
PYTHON = ["tests/gallery/python", "tests/python", "examples"]
SHOWN_TESTS = 3


def read_functions(text: str) -> dict[str, dict[str, list[str]]]:
    """Generation -> family -> functions."""
    found: dict[str, dict[str, list[str]]] = {}
    for line in text.splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith("["):
            families = found.setdefault(line.strip("[]"), {})
        else:
            family, _, names = line.partition(": ")
            families.setdefault(family, []).extend(names.split())
    return found


def calls(folders: list[str], suffixes: set[str], classic: bool = False) -> dict[str, list[str]]:
    """Function -> the programs, without suffix, that call it. Examples for classic RoBIOS are called classic_…"""
    found: dict[str, list[str]] = {}
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix not in suffixes or (folder == "examples" and path.name.startswith("classic_") != classic):
                continue
            relative = path.relative_to(ROOT / folder)
            name = f"{folder.removeprefix('tests/').removeprefix('robios/')}/{relative.with_suffix('')}"
            code = re.sub(r"/\*.*?\*/|//[^\n]*", "", path.read_text(errors="replace"), flags=re.S)
            for function in sorted(set(re.findall(r"\b[A-Z]{2,}[A-Za-z0-9_]*(?=\s*\()", code))):
                found.setdefault(function, []).append(name)
    return found


def status_of(function: str, table: dict[str, list[str]]) -> list[str]:
    fitting = [prefix for prefix in table if function.startswith(prefix)]
    return table[max(fitting, key=len)] if fitting else ["?", "?", "?", "?"]


def cell(text: str) -> str:
    return text.replace("|", "\\|")


class Page:
    """The page, and what is wrong with the tree it describes."""

    def __init__(self) -> None:
        self.functions = read_functions((HERE / "functions.txt").read_text())
        self.status = tomllib.loads((HERE / "status.toml").read_text())
        self.offences: list[str] = []
        self.python = calls(PYTHON, {".py"})
        modules = sorted((ROOT / "python/eye").glob("*.py"))
        self.in_python = {name for module in modules for name in re.findall(r"^def ([A-Z]\w+)\(", module.read_text(), re.M)}
        self.lines = [
            "# Compatibility",
            "",
            "Every function of RoBIOS-7 and of classic RoBIOS (`robios/include`), where it works, in what it differs from the original or",
            "is settled where the originals disagree, and what tests it: programs of [tests/gallery](../tests/gallery/README.md), whose",
            "results a person has looked at, and others. Made by `tests/compatibility/make_compatibility.py`; a test says when it is stale.",
            "",
            "*host*: no device is behind it, it is the same with every backend. Recorded: `--record` keeps it and `--hal replay:` answers.",
            "In Python: a program that calls it through the module `eye`, or *yes*.",
        ]
        for generation, families in self.functions.items():
            self.add_generation(generation, families)
        self.add_robots()

    def add_robots(self) -> None:
        self.lines += ["", "## Robots", "", *(HERE / "robots.md").read_text().splitlines(), ""]
        self.lines += ["| " + " | ".join(HEAD) + " |", "|---" * len(HEAD) + "|"]
        self.lines += ["| " + " | ".join(cell(text) for text in row) + " |" for row in robot_rows(ROOT)]

    def add_generation(self, generation: str, families: dict[str, list[str]]) -> None:
        declared: dict[str, str] = {}
        for folder in HEADERS[generation]:
            declared |= declared_in(ROOT / folder)
        declared |= {name: UNDECLARED for name in defined_in(ROOT / SOURCES[generation]) if name not in declared}
        called = calls(CALLERS[generation], {".c", ".cpp", ".h"}, generation == "classic")
        wanted = [name for names in families.values() for name in names]
        there = sum(1 for name in wanted if name in declared)
        tested = sum(1 for name in wanted if name in declared and name in called)
        self.lines += ["", f"## {generation}", "", f"{len(wanted)} functions, {there} of them here, {tested} with a test."]
        for family, names in families.items():
            python = generation == "RoBIOS-7"
            head = ["function", "simulated", "IO7 board", "CAN", "recorded", "differences", "tests"]
            if python:
                head.append("in Python")
            self.lines += ["", f"### {family}", "", "| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
            for name in names:
                self.add_row(generation, name, declared, called, python)

    def add_row(self, generation: str, name: str, declared: dict[str, str], called: dict[str, list[str]], python: bool) -> None:
        key = f"{generation} {name}"
        tests = called.get(name, [])
        if name not in declared:
            row = [f"`{name}`", "missing", "", "", "", "", ""]
            self.offences.append(f"{key}: declared in no header")
        else:
            status = status_of(name, self.status[generation])
            if "?" in status:
                self.offences.append(f"status.toml: says nothing about {key}")
            if not tests:
                self.offences.append(f"{key}: no program calls it; expected one in {' or '.join(CALLERS[generation])}")
            more = f" and {len(tests) - SHOWN_TESTS} more" if len(tests) > SHOWN_TESTS else ""
            row = [f"`{name}`", *status, differences(declared[name]), ", ".join(tests[:SHOWN_TESTS]) + more or "none"]
        if python:
            programs = self.python.get(name, ["yes"])
            row.append(", ".join(programs[:1]) if name in self.in_python else "")
        self.lines.append("| " + " | ".join(cell(text) for text in row) + " |")

    def text(self) -> str:
        return "\n".join(self.lines) + "\n"


def main() -> int:
    page = Page()
    if "--check" not in sys.argv:
        PAGE.write_text(page.text())
    elif not PAGE.exists() or PAGE.read_text() != page.text():
        page.offences.append(f"{PAGE.relative_to(ROOT)} is stale: run python3 -B tests/compatibility/make_compatibility.py")
    for offence in page.offences:
        print(offence)
    return 1 if page.offences else 0


if __name__ == "__main__":
    sys.exit(main())
