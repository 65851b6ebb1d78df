"""Reads what C headers declare: function names and the comments before them."""

import pathlib
import re

COMMENT_OR_CODE = re.compile(r"(/\*.*?\*/|//[^\n]*)|([^/]+|/)", re.S)
PROTOTYPE = re.compile(r"\b([A-Z][A-Za-z0-9_]*)\s*\(")


def comment_text(comment: str) -> str:
    """The words of a comment in one line."""
    text = re.sub(r"^/\*+!?|\*+/$|^//+", "", comment.strip())
    return " ".join(re.sub(r"^\s*\*", "", line).strip() for line in text.splitlines()).strip()


def declarations(text: str) -> dict[str, str]:
    """Function -> comment. One without a comment of its own has that of the function before it."""
    text = re.sub(r"^\s*#(?:.*\\\n)*.*$", "", text, flags=re.M)
    found: dict[str, str] = {}
    comment = ""
    for match in COMMENT_OR_CODE.finditer(text):
        if match[1]:
            if match[1].startswith("/**"):
                comment = comment_text(match[1])
            continue
        for statement in match[2].split(";")[:-1]:
            if "typedef" in statement or "extern int " in statement:
                continue
            if name := PROTOTYPE.search(statement):
                found.setdefault(name[1], comment)
    return found


def declared_in(folder: pathlib.Path) -> dict[str, str]:
    found: dict[str, str] = {}
    for header in sorted(folder.glob("*.h")):
        for name, comment in declarations(header.read_text()).items():
            found.setdefault(name, comment)
    return found


DEFINITION = re.compile(r"^(?:extern \"C\" )?(?:__attribute__\(\([^)]*\)\)\) )?(?:int|void) ([A-Z][A-Za-z0-9_]*)\([^;{]*\) \{", re.M)


def defined_in(folder: pathlib.Path) -> set[str]:
    """Functions with a body in the sources: some are exported for old programs, but declared nowhere, as in the original."""
    return {name for source in sorted(folder.glob("*.cpp")) for name in DEFINITION.findall(source.read_text())}


DIFFERENCE = re.compile(
    r"UNCERTAIN|EyeSim|ESP32|manual|older|original|published|header sa|page|sources disagree|real (?:board|robot)|in simulation|"
    r"here\b.*\bthere|unlike|M6|virtual time",
    re.I,
)


def differences(comment: str) -> str:
    """The sentences of a comment that compare with the original, or tell what is particular here."""
    sentences = re.split(r"(?<=[.;:)])\s+(?=[A-Z(0-9])", comment)
    return " ".join(sentence for sentence in sentences if DIFFERENCE.search(sentence))
