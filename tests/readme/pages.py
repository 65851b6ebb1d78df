"""The commands that a reader finds: in README.md, and in each page of docs/ up to the end of its first section."""

import re
from pathlib import Path

# Code within a sentence is a command when it begins with one of these and says what to do with it;
# `eyebridge run` alone is the name of a command.
PROGRAMS = r"eyebridge-cc|eyebridge-c\+\+|\./run|\./test|\./package|\S*pip|\S*python3|mpirun|cmake|apt|sudo"
INLINE = re.compile(rf"(?<!`)`((?:{PROGRAMS})\s[^`]+|eyebridge\s[^`\s]+\s[^`]+|eyebridge\s(?:doctor|probe|config|--help)|\./run)`")


def pages(root):
    return ["README.md"] + sorted(f"docs/{path.name}" for path in (root / "docs").glob("*.md"))


def first_section(text):
    return "\n## ".join(re.split(r"\n## ", text)[:2])


def without_comment(line):
    """A comment of a shell begins with # behind a blank; no command here has one within quotes."""
    return re.sub(r"(^|\s)#.*", "", line).strip()


def in_block(block):
    """The commands of a ```sh block: one a line; a line that ends in \\ goes on."""
    unfinished = ""
    for line in block.split("\n"):
        unfinished += without_comment(line)
        if unfinished.endswith("\\"):
            unfinished = unfinished[:-1]
        elif unfinished:
            yield unfinished
            unfinished = ""


def commands(root, page):
    """Those of a page, blanks made one, in order, each once."""
    text = (Path(root) / page).read_text()
    if page != "README.md":
        text = first_section(text)
    found = []
    # Sentences and blocks take turns: sentences, language, block, sentences, ...
    parts = re.split(r"(?m)^[ ]*```(\w*)[^\n]*\n", text)
    fenced = False
    for language, part in zip([""] + parts[1::2], parts[0::2]):
        if not fenced:
            found += INLINE.findall(part)
        elif language == "sh":
            found += in_block(part)
        fenced = not fenced
    return list(dict.fromkeys(re.sub(r"\s+", " ", command) for command in found))


def all_commands(root):
    return [(page, command) for page in pages(root) for command in commands(root, page)]
