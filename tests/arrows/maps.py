"""What the pages point at: the files in the tables of READMEs, and links. Who follows a map that is wrong is lost."""

import pathlib
import re

NAME = re.compile(r"`([\w*+-][\w/*+-]*(?:\.[\w*]+|/))`")
PLACEHOLDER = re.compile(r"\bNAME|NAME\b")
LINK = re.compile(r"\]\(([^)#\s:]+)(?:#[^)]*)?\)")


def check_maps(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    offences = []
    known = {part for file in files for part in (file, *file.parents)}
    for file in files:
        if file.suffix != ".md":
            continue
        below = None
        for number, line in enumerate((root / file).read_text(errors="replace").splitlines(), 1):
            for link in LINK.findall(line):
                if pathlib.Path(root / file.parent / link).resolve().exists():
                    continue
                offences.append(f"{file}:{number}: links to {link}, which is not there")
            if file.name != "README.md" or len(file.parts) == 1 or not line.startswith("|"):
                continue
            below = below or [path for path in known if path.is_relative_to(file.parent)]
            for name in NAME.findall(line.split("|")[1]):
                if PLACEHOLDER.search(name) or any(path.match(name.rstrip("/")) for path in below):
                    continue
                offences.append(f"{file}:{number}: names {name}, which is not below {file.parent}")
    return offences
