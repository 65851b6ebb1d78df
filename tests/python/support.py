"""Runs robot programs in Python, each in a process and a folder of its own, as users do."""

import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import threading
import unittest

BUILD = pathlib.Path(os.environ["EYEBRIDGE_TEST_BUILD"])
SOURCE = pathlib.Path(os.environ["EYEBRIDGE_TEST_SOURCE"])
PATIENCE = 120  # seconds


class ProgramTest(unittest.TestCase):
    """A folder for a program, and ways to run it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="eyebridge-test-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(textwrap.dedent(text))
        return path

    def environment(self, settings):
        """This one's, with the settings as variables: fast=True is EYEBRIDGE_FAST=true."""
        out = dict(os.environ, PYTHONPATH=str(BUILD / "python"), PYTHONDONTWRITEBYTECODE="1")
        out["XDG_DATA_HOME"] = str(self.folder / "data")  # what is trusted is this test's own
        out.pop("PYTHONUNBUFFERED", None)  # output is buffered, as it is for users
        for name, value in settings.items():
            out["EYEBRIDGE_" + name.upper()] = str(value).lower() if isinstance(value, bool) else str(value)
        return out

    def start(self, words, settings=None):
        """A process that runs `words` in the folder, its output captured; killed when it takes too long."""
        process = subprocess.Popen(
            [str(word) for word in words], cwd=self.folder, env=self.environment(settings or {"fast": True}),
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        process.watchdog = threading.Timer(PATIENCE, process.kill)
        process.watchdog.daemon = True
        process.watchdog.start()
        return process

    def finish(self, process):
        process.out, process.err = process.communicate()
        process.watchdog.cancel()
        return process

    def run_words(self, words, settings=None):
        return self.finish(self.start(words, settings))

    def run_program(self, text, settings=None):
        """Runs a program, in virtual time unless `settings` say otherwise."""
        path = self.write("prog.py", text)
        return self.run_words([sys.executable, path], {"fast": True} | (settings or {}))

    def expect(self, text, lines, settings=None, err=""):
        """The program ends well, prints `lines`, and says `err` on standard error (None: anything)."""
        run = self.run_program(text, settings)
        self.assertEqual(run.returncode, 0, run.err)
        self.assertEqual(run.out.splitlines(), textwrap.dedent(lines).strip().splitlines(), run.err)
        if err is not None:
            self.assertEqual(run.err, err)


def main():
    unittest.main(verbosity=0)
