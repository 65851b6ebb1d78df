"""Turns g++'s compile_commands.json into one that clang-tidy-14 can read: tidy_commands.py IN OUT."""

import json
import pathlib
import re
import sys

# Precompiled headers are g++'s own; the sanitizers only make clang-tidy slower.
DROPPED = re.compile(
    r" -include \S*cmake_pch\.hxx| -Winvalid-pch| -fpch-preprocess| -fsanitize=\S+"
    r"| -fno-sanitize-recover=\S+| -Wno-maybe-uninitialized"
    r"| -Wno-restrict| -Wno-subobject-linkage"
)
# The launcher comes before the compiler.
LAUNCHER = re.compile(r"^\S*ccache ")


def main(source: str, target: str) -> None:
    root = pathlib.Path(__file__).resolve().parent.parent
    entries = []
    for entry in json.loads(pathlib.Path(source).read_text()):
        file = pathlib.Path(entry["file"])
        unity = file.name.startswith("unity_")
        if file.name.startswith("cmake_pch") or not file.is_relative_to(root):
            continue
        if (root / "build") in file.parents and not unity:
            continue
        command = LAUNCHER.sub("", entry["command"])
        entries.append({**entry, "command": DROPPED.sub("", command)})
    pathlib.Path(target).write_text(json.dumps(entries, indent=1))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
