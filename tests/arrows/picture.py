#!/usr/bin/env python3
"""The picture of rooms in docs/architecture.md, drawn from who includes whom; each of its arrows is explained beside it.

picture.py ROOT          prints what is wrong with the picture or its sentences, and exits with 1 when anything is
picture.py ROOT --write  draws it again; sentences are yours
"""

import pathlib
import re
import sys

from check_arrows import ALLOWED, CODE, INCLUDE, files_in, room_of, target_of

PAGE = "docs/architecture.md"
# They may include everything: that says nothing about the rooms.
OUTSIDE = {"tests", "bench"}
BEGIN, END = "<!-- picture.py draws from here -->\n", "<!-- to here -->\n"
SENTENCE = re.compile(r"^\| (\S+) → (\S+) \| (.*\S.*) \|$", re.MULTILINE)


def includes(root: pathlib.Path) -> dict[str, set[str]]:
    """Room -> the rooms that it includes."""
    files = [file for file in files_in(root) if file.suffix in CODE]
    headers: dict[str, list] = {}
    for file in files:
        headers.setdefault(file.name, []).append(file)
    arrows: dict[str, set[str]] = {room: set() for room in ALLOWED if room not in OUTSIDE}
    for file in files:
        home = room_of(file)
        if home not in arrows:
            continue
        for line in (root / file).read_text(errors="replace").splitlines():
            match = INCLUDE.match(line)
            target = target_of(match[1] or match[2], file, headers) if match else None
            if target not in (None, home):
                arrows[home].add(target)
    return arrows


def can_reach(arrows: dict[str, set[str]], start: str, end: str) -> bool:
    """By way of at least one other room."""
    seen: set[str] = set()
    ahead = [room for room in arrows[start] if room != end]
    while ahead:
        room = ahead.pop()
        if room == end:
            return True
        if room not in seen:
            seen.add(room)
            ahead += arrows.get(room, ())
    return False


def shown(arrows: dict[str, set[str]]) -> list[tuple[str, str]]:
    """Without arrows that follow from others: with robios → hal and hal → core/base, robios → core/base is left out."""
    return sorted((home, target) for home in arrows for target in arrows[home] if not can_reach(arrows, home, target))


def drawn(arrows: list[tuple[str, str]]) -> str:
    lines = "\n".join(f"  {home.replace('/', '_')}[{home}] --> {target.replace('/', '_')}[{target}]" for home, target in arrows)
    return f"{BEGIN}```mermaid\nflowchart TD\n{lines}\n```\n{END}"


def wrong_with(page: str, arrows: list[tuple[str, str]]) -> list[str]:
    offences = []
    if drawn(arrows) not in page:
        offences.append(f"{PAGE}: the picture is not that of the includes; tests/arrows/picture.py . --write draws it")
    explained = {(home, target) for home, target, _ in SENTENCE.findall(page)}
    offences += [f"{PAGE}: no sentence says why {home} includes {target}" for home, target in arrows if (home, target) not in explained]
    offences += [f"{PAGE}: {home} → {target} is explained, and not there" for home, target in sorted(explained - set(arrows))]
    return offences


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    page = root / PAGE
    text = page.read_text()
    arrows = shown(includes(root))
    if "--write" in sys.argv:
        before, _, rest = text.partition(BEGIN)
        page.write_text(before + drawn(arrows) + rest.partition(END)[2])
        return 0
    offences = wrong_with(text, arrows)
    print("\n".join(offences), end="\n" if offences else "")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
