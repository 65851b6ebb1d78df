#!/usr/bin/env python3
"""Writes completions_data.cpp: what the editor offers, from the headers of both generations of RoBIOS and the stub of `eye`.

generate_completions.py ROOT OUT. A declaration that it does not understand ends it with file, line and what was found.
"""

import ast
import json
import pathlib
import re
import sys
import textwrap

WIDTH = 88
PART = re.compile(r"(?P<doc>/\*\*.*?\*/)|(?P<comment>/\*.*?\*/)|(?P<macro>^[ \t]*#(?:[^\n]*\\\n)*[^\n]*)|(?P<code>.)", re.S | re.M)
CONSTANT = re.compile(r"#define ([A-Z][A-Za-z0-9_]*)[ \t]+(?P<value>\S[^\n]*)")
FUNCTION = re.compile(r"^(?P<result>[A-Za-z_][\w ]*[\s*]+|[A-Za-z_]\w*)\(?(?P<name>[A-Za-z_]\w*)\)?\s*(?P<arguments>\(.*\))$", re.S)
VARIABLES = re.compile(r"^extern \w+ (?P<names>\w+(?:, \w+)*)$")
TYPE = re.compile(r"^typedef .*?\(?\*?(?P<name>\w+)\)?(?:\s*\([^()]*\)|(?:\[\w+\])+)?$", re.S)
# Helpers behind macros: programs call them by their other names.
OWN = re.compile(r"^EYEBRIDGE(?!LastError$)")
# Says nothing to who calls the function.
ATTRIBUTE = re.compile(r"\s*__attribute__\(\(.*?\)\)\)?$", re.S)


def one_line(doc: str) -> str:
    """The first sentence of a comment or docstring, in lines that fit."""
    text = re.sub(r"^/\*\*<?|\*/$", "", doc.strip())
    text = " ".join(re.sub(r"^\s*\*", "", line).strip() for line in text.splitlines()).strip()
    sentence = re.split(r"(?<=\.)\s+(?=[A-Z(0-9'\"])", text)[0]
    return "\n".join(textwrap.wrap(sentence, WIDTH))


def tidy(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


class Header:
    """What one C header declares, as (kind, name, prototype, doc)."""

    def __init__(self, path: pathlib.Path):
        self.path = path
        self.found: list[tuple[str, str, str, str]] = []
        self.doc = ""
        self.statement = ""
        self.depth = 0
        text = path.read_text()
        for match in PART.finditer(text):
            self.part(match, text)

    def part(self, match: re.Match[str], text: str) -> None:
        if match["doc"]:
            if self.depth == 0:
                self.doc = one_line(match["doc"])
        elif match["macro"]:
            self.macro(match["macro"])
        elif match["code"]:
            self.code(match["code"], text.count("\n", 0, match.start()) + 1)

    def macro(self, line: str) -> None:
        doc, self.doc = self.doc, ""
        line = re.sub(r"\s*/\*.*", "", line)
        constant = CONSTANT.match(line)
        if constant and not OWN.match(constant[1]) and not constant["value"].startswith("EYEBRIDGE"):
            self.found.append(("Constant", constant[1], f"{constant[1]} = {tidy(constant['value'])}", doc))

    def code(self, character: str, line: int) -> None:
        if character == "}":
            self.depth -= 1
            if self.depth == 0 and not re.match(r"\s*(typedef|struct)\b", self.statement):
                self.statement = ""  # the body of an inline function
                return
        if self.depth == 0 and character == ";":
            self.declaration(tidy(self.statement), line)
            self.statement = ""
            return
        if self.depth == 0 and character not in "{}":
            self.statement += character
        if character == "{":
            self.depth += 1

    def declaration(self, text: str, line: int) -> None:
        doc, self.doc = self.doc, ""
        text = ATTRIBUTE.sub("", text)
        if not text:
            return
        if text.startswith("struct ") and "(" not in text:
            self.found.append(("Type", text.split()[1], text, doc))
        elif variables := VARIABLES.match(text):
            for name in variables["names"].split(", "):
                self.found.append(("Variable", name, f"int {name}", doc))
        elif text.startswith("typedef ") and (type_ := TYPE.match(text)):
            self.found.append(("Type", type_["name"], text, doc))
        elif function := FUNCTION.match(text):
            name = function["name"]
            arguments = "()" if function["arguments"] == "(void)" else function["arguments"]
            prototype = f"{tidy(function['result'])} {name}{arguments}"
            if not OWN.match(name):
                self.found.append(("Function", name, prototype, doc))
        else:
            sys.exit(f"{self.path}:{line}:1: found '{text}', expected a function, a type or a variable")


def of_headers(paths: list[pathlib.Path]) -> list[tuple[str, str, str, str]]:
    return [entry for path in paths for entry in Header(path).found]


def python_prototype(function: ast.FunctionDef) -> str:
    arguments = function.args
    first_default = len(arguments.args) - len(arguments.defaults)
    words = [a.arg + ("=..." if i >= first_default else "") for i, a in enumerate(arguments.args)]
    if arguments.vararg:
        words.append("*" + arguments.vararg.arg)
    result = ast.unparse(function.returns) if function.returns else "None"
    return f"{function.name}({', '.join(words)}) -> {result.replace('_SimValue', 'int').replace('_Image', 'bytes')}"


def of_python(folder: pathlib.Path) -> list[tuple[str, str, str, str]]:
    """What the stub says, with the docstrings of the modules."""
    docs: dict[str, str] = {}
    for path in sorted(folder.glob("*.py")):
        for node in ast.parse(path.read_text()).body:
            if isinstance(node, ast.FunctionDef):
                docs[node.name] = one_line(ast.get_docstring(node) or "")
    found: list[tuple[str, str, str, str]] = []
    functions: dict[str, str] = {}
    for node in ast.parse((folder / "__init__.pyi").read_text()).body:
        if isinstance(node, ast.FunctionDef):
            functions[node.name] = python_prototype(node)
            found.append(("Function", node.name, functions[node.name], docs.get(node.name, "")))
        elif isinstance(node, ast.ClassDef):
            found.append(("Type", node.name, f"class {node.name}", ""))
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            found.append(("Constant", node.target.id, node.target.id, ""))
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and isinstance(node.value, ast.Name):
            name, other = node.targets[0].id, node.value.id
            prototype = functions[other].replace(other, name, 1)
            found.append(("Function", name, prototype, f"The same as {other}()."))
    return [entry for entry in found if not entry[1].startswith("_")]


def table(name: str, entries: list[tuple[str, str, str, str]]) -> str:
    unique: dict[str, tuple[str, str, str, str]] = {}
    for entry in entries:
        unique.setdefault(entry[1], entry)
    rows = [
        f"    {{Completion::Kind::{kind}, {json.dumps(word)}, {json.dumps(prototype)}, {json.dumps(doc, ensure_ascii=False)}}},"
        for kind, word, prototype, doc in sorted(unique.values(), key=lambda entry: entry[1])
    ]
    return f"constexpr Completion {name}[] = {{\n" + "\n".join(rows) + "\n};\n"


def main() -> None:
    root, out = map(pathlib.Path, sys.argv[1:])
    include = root / "robios" / "include"
    extension = include / "eyebridge.h"
    classic = [path for path in sorted((include / "classic" / "eyebridge_classic").glob("*.h")) if path.name != "m6_overloads.h"]
    out.write_text(
        "// Made by generate_completions.py.\n"
        '#include "code/completions.hpp"\n\n'
        "namespace eyebridge::gui {\nnamespace {\n\n"
        + table("kRobios7Completions", of_headers([*sorted((include / "eyebridge_robios").glob("*.h")), extension]))
        + table("kClassicCompletions", of_headers([*classic, extension]))
        + table("kPythonCompletions", of_python(root / "python" / "eye"))
        + "\n}  // namespace\n\n"
        "std::span<const Completion> completions(Api api) {\n"
        "  switch (api) {\n"
        "    case Api::Robios7: return kRobios7Completions;\n"
        "    case Api::Classic: return kClassicCompletions;\n"
        "    case Api::Python: return kPythonCompletions;\n"
        "  }\n  return {};\n}\n\n"
        "}  // namespace eyebridge::gui\n"
    )


if __name__ == "__main__":
    main()
