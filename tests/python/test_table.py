"""`eye` against the C headers: nothing is missing, nothing differs."""

import ast
import re
import subprocess
import unittest

import eye
from eye import _library
from support import BUILD, SOURCE, main

HEADERS = SOURCE / "robios" / "include" / "eyebridge_robios"
# Nothing to do in Python.
NOT_FOR_PYTHON = {"XInitThreads"}
# Exported for old programs in C, but declared nowhere.
UNDECLARED = {"KEYInit", "KEYRelease", "LCDInit", "LCDRelease"}


def headers():
    text = "\n".join(path.read_text() for path in sorted(HEADERS.glob("*.h")))
    return re.sub(r"/\*.*?\*/", "", text, flags=re.S)


def declared():
    """Name and number of parameters of each function in the headers."""
    found = {}
    for name, words in re.findall(r"^[\w ]+?[\s*]+([A-Z]\w+)\(((?:[^()]|\([^()]*\))*)\);", headers(), re.M | re.S):
        parameters = re.sub(r"\([^()]*\)", "", words).strip()
        found[name] = 0 if parameters in ("", "void") else parameters.count(",") + 1
    # Names of ours stand for the second form of a call in C.
    return {name: count for name, count in found.items() if name not in NOT_FOR_PYTHON and not name.startswith("EYEBRIDGE")}


def public():
    return {name for name in vars(eye) if not name.startswith("_")}


class Table(unittest.TestCase):
    def test_the_headers_are_understood(self):
        self.assertGreater(len(declared()), 80)
        self.assertEqual(declared()["VWGetPosition"], 3)
        self.assertEqual(declared()["OSAttachTimer"], 2)

    def test_every_function_of_the_headers_is_in_the_table_with_its_parameters(self):
        table = {name: len(parameters) for name, _, parameters in _library.rows()}
        for name, count in declared().items():
            with self.subTest(name):
                self.assertEqual(table.get(name), count)

    def test_every_function_of_the_table_is_a_function_of_eye_with_a_docstring(self):
        for name, _, _ in _library.rows():
            with self.subTest(name):
                self.assertTrue(callable(getattr(eye, name)))
                self.assertGreater(len(getattr(eye, name).__doc__ or ""), 5)

    def test_the_table_is_what_the_library_exports(self):
        symbols = subprocess.run(
            ["nm", "-D", "--defined-only", BUILD / "lib" / "libeyebridge.so"], capture_output=True, text=True, check=True
        ).stdout
        exported = set(re.findall(r" T ([A-Z]\w+)$", symbols, re.M))
        table = {name for name, _, _ in _library.rows()}
        self.assertEqual(table - exported, set())
        left = {name for name in exported - table if not name.startswith("EYEBRIDGE")}
        self.assertEqual(left, UNDECLARED | NOT_FOR_PYTHON)

    def test_constants_are_those_of_the_headers(self):
        constants = dict(re.findall(r"^[ \t]*#define (\w+) ([^\n]+)$", headers(), re.M))
        constants = {
            name: text for name, text in constants.items() if name not in ("True", "False") and not name.startswith("EYEBRIDGE_")
        }
        self.assertGreater(len(constants), 90)
        self.assertEqual(eye.CAM5MP_SIZE, 2592 * 1944 * 3)
        for name, text in constants.items():
            with self.subTest(name):
                value = eval(text, {}, {other: getattr(eye, other, None) for other in constants})
                mine = getattr(eye, name)
                self.assertEqual(mine, ord(value) if isinstance(value, str) and len(value) == 1 else value)

    def test_there_is_no_list_of_names_and_two_names_that_programs_use(self):
        self.assertFalse(hasattr(eye, "__all__"))
        self.assertTrue({"ctypes", "lib", "CAMWIDTH", "PSDGet", "QVGA"} <= public())

    def test_a_star_import_brings_no_module_that_programs_call_by_the_same_name(self):
        self.assertEqual(public() & {"math", "random", "sys", "os", "time", "re", "threading", "signal"}, set())

    def test_the_stub_names_what_there_is(self):
        stub = ast.parse((SOURCE / "python" / "eye" / "__init__.pyi").read_text())
        named = set()
        for node in stub.body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                named.add(node.name)
            elif isinstance(node, ast.AnnAssign):
                named.add(node.target.id)
            elif isinstance(node, ast.Assign):
                named |= {target.id for target in node.targets}
            elif isinstance(node, ast.Import):
                named |= {alias.asname or alias.name for alias in node.names}
        named = {name for name in named if not name.startswith("_")}
        self.assertEqual(named, public())

    def test_the_stub_has_the_parameters_of_the_functions(self):
        stub = ast.parse((SOURCE / "python" / "eye" / "__init__.pyi").read_text())
        for node in stub.body:
            if isinstance(node, ast.FunctionDef):
                code = getattr(eye, node.name).__code__
                mine = code.co_varnames[: code.co_argcount + bool(code.co_flags & 4)]
                names = [argument.arg for argument in node.args.args]
                names += [node.args.vararg.arg] if node.args.vararg else []
                self.assertEqual(names, list(mine), node.name)


if __name__ == "__main__":
    main()
