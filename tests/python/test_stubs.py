"""The stubs of both packages against the modules, by mypy's stubtest."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from support import SOURCE, main

# Of classes made by pybind11, which stubs do not know.
FROM_PYBIND11 = (
    "is inconsistent, metaclass differs",
    'is inconsistent, stub does not have *args argument "args"',  # those that a program cannot make: Camera, Robot, Scenario
)


def differences(folder):
    """What stubtest says of the stubs in `folder`, one a line."""
    words = [sys.executable, "-m", "mypy.stubtest", "--concise", "--ignore-missing-stub", "eye", "eyebridge"]
    run = subprocess.run(words, env=os.environ | {"MYPYPATH": folder}, cwd=folder, capture_output=True, text=True)
    if run.returncode not in (0, 1) or run.stderr:
        raise AssertionError(f"stubtest failed; expected mypy (apt install mypy)\n{run.stderr}")
    return [line for line in run.stdout.splitlines() if not line.endswith(FROM_PYBIND11)]


class Stubs(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="eyebridge-test-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        for package in ("eye", "eyebridge"):
            (self.folder / package).mkdir()
            shutil.copy(SOURCE / "python" / package / "__init__.pyi", self.folder / package)

    def test_agree_with_the_modules(self):
        self.assertEqual(differences(self.folder), [])

    def test_are_really_compared(self):
        for package in ("eye", "eyebridge"):
            with open(self.folder / package / "__init__.pyi", "a") as stub:
                stub.write("\ndef is_not_there() -> int: ...\n")
        expected = [f"{package}.is_not_there is not present at runtime" for package in ("eye", "eyebridge")]
        self.assertEqual(differences(self.folder), expected)


if __name__ == "__main__":
    main()
