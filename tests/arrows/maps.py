"""Files that READMEs name in their tables, and links of all pages: both must be there."""

import pathlib
import re

NAME = re.compile(r"`([\w*+-][\w/*+-]*(?:\.[\w*]+|/))`")
LINK = re.compile(r"\]\(([^)#\s:]+)(?:#[^)]*)?\)")


def check_maps(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    offences = []
    known = {path for file in files for path in (file, *file.parents)}
    for page in (file for file in files if file.suffix == ".md"):
        has_map = page.name == "README.md" and len(page.parts) > 1
        below = [path for path in known if path.is_relative_to(page.parent)] if has_map else []
        for number, line in enumerate((root / page).read_text(errors="replace").splitlines(), 1):
            for link in LINK.findall(line):
                if not (root / page.parent / link).exists():
                    offences.append(f"{page}:{number}: links to {link}; expected a file or folder that is there")
            if not has_map or not line.startswith("|"):
                continue
            for name in NAME.findall(line.split("|")[1]):
                if "NAME" not in name and not any(path.match(name.rstrip("/")) for path in below):
                    offences.append(f"{page}:{number}: names {name}; expected a file or folder below {page.parent}")
    return offences
