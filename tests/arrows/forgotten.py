"""Finds what compilers and clang-tidy do not see when headers are precompiled and sources are compiled together.

Forgotten includes of precompiled headers: a name below wants its header, included by the source itself or by a header of
ours that it includes. And using-declarations that their own source makes no use of.
"""

import pathlib
import re

ALGORITHMS = (
    "all_of any_of clamp copy copy_if copy_n count count_if equal fill fill_n find find_if find_if_not for_each generate is_sorted"
    " lexicographical_compare lower_bound max max_element min min_element minmax mismatch none_of ranges::\\w+ remove_if replace"
    " reverse rotate search shuffle sort stable_sort transform unique upper_bound"
)
MATHS = "abs atan2 ceil copysign cos exp floor fmod hypot isfinite isnan lround pow remainder round sin sqrt trunc"

# As in eyebridge_headers(libraries …) of cmake/EyebridgeTargets.cmake.
NAMES = {
    "algorithm": rf"std::(?:{'|'.join(ALGORITHMS.split())})\(",
    "array": r"std::(?:array\b|to_array\()",
    "cmath": rf"std::(?:{'|'.join(MATHS.split())})\(",
    "filesystem": r"std::filesystem\b",
    "memory": r"std::(?:unique_ptr|shared_ptr|weak_ptr|make_unique|make_shared)\b",
    "optional": r"std::(?:optional|nullopt)\b",
    "span": r"std::span\b",
    "string": r"std::(?:string\b|to_string\()",
    "vector": r"std::vector\b",
    "tl/expected.hpp": r"tl::(?:expected|unexpected)\b",
    "gtest/gtest.h": r"^(?:TEST|TEST_F|TEST_P|INSTANTIATE_TEST_SUITE_P)\(",
}
WANTED = {header: re.compile(names, re.M) for header, names in NAMES.items()}
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.M)
USING = re.compile(r"^ *using (?:\w*::)+(\w+);", re.M)
COMMENT = re.compile(r"//.*")
ALSO = {"gmock/gmock.h": "gtest/gtest.h"}


class Sources:
    """The C++ of a tree, and what each file of it includes in the end."""

    def __init__(self, root: pathlib.Path, files: list[pathlib.PurePosixPath]):
        self.root = root
        self.files = [file for file in files if file.suffix in {".c", ".h", ".cpp", ".hpp", ".ipp"}]
        self.by_name: dict[str, list] = {}
        for file in self.files:
            self.by_name.setdefault(file.name, []).append(file)
        self.reached: dict[pathlib.PurePosixPath, set[str]] = {}

    def text(self, file: pathlib.PurePosixPath) -> str:
        return (self.root / file).read_text(errors="replace")

    def foreign_headers(self, file: pathlib.PurePosixPath) -> set[str]:
        """Headers that are not ours, included by `file` or by one of ours that it includes."""
        if file in self.reached:
            return self.reached[file]
        self.reached[file] = found = set()
        for include in INCLUDE.findall(self.text(file)):
            words = [word for word in include.split("/") if word not in ("..", ".")]
            ours = [other for other in self.by_name.get(words[-1], []) if other.parts[-len(words) :] == tuple(words)]
            if not ours:
                found |= {include, ALSO.get(include, include)}
            for other in ours:
                found |= self.foreign_headers(other)
        return found


def check_forgotten(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    sources = Sources(root, files)
    offences = []
    for file in sources.files:
        if file.suffix not in {".cpp", ".hpp"}:
            continue
        code = COMMENT.sub("", sources.text(file))
        for header in WANTED.keys() - sources.foreign_headers(file):
            if match := WANTED[header].search(code):
                number = code.count("\n", 0, match.start()) + 1
                offences.append(f"{file}:{number}: {match[0].rstrip('(')} needs #include <{header}>")
    return sorted(offences)


def check_unused(root: pathlib.Path, files: list[pathlib.PurePosixPath]) -> list[str]:
    offences = []
    for file in files:
        if file.suffix != ".cpp":
            continue
        code = COMMENT.sub("", (root / file).read_text(errors="replace"))
        for match in USING.finditer(code):
            if len(re.findall(rf"\b{match[1]}\b", code)) == 1:
                number = code.count("\n", 0, match.start()) + 1
                offences.append(f"{file}:{number}: {match[1]} is not used")
    return offences
