"""From an sdist to a wheel to a clean venv, without network: what users do. `pip install .` itself is a line of README (tests/readme)."""

import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

from support import SOURCE, main

COMMANDS = ("eyebridge", "eyebridge-cc", "eyebridge-c++", "gccsim", "g++sim", "gccarm", "g++arm")
C_PROGRAM = '#include <stdio.h>\n#include "eyebot.h"\nint main() { VWStraight(100, 200); VWWait(); printf("arrived\\n"); return 0; }\n'


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="eyebridge-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.version = re.search(r"^project\(EyeBridge VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text(), re.M)[1]
        backend = f"import eyebridge_wheel; print(eyebridge_wheel.build_sdist({scratch.name!r}))"
        name = cls.run_words(sys.executable, "-c", backend, PYTHONPATH=SOURCE / "python" / "build_backend").strip()
        cls.sdist = cls.folder / name
        cls.commit = cls.git("rev-parse", "HEAD").strip()
        # Warnings are errors, as in the build that this test belongs to.
        cls.run_words(
            sys.executable, "-m", "pip", "wheel", "--no-index", "--no-deps", "-w", scratch.name, cls.sdist,
            CMAKE_ARGS="-DEYEBRIDGE_WERROR=ON", TMPDIR=scratch.name,
        )  # fmt: skip
        [cls.wheel] = cls.folder.glob("*.whl")
        cls.run_words(sys.executable, "-m", "venv", "venv")
        cls.bin = cls.folder / "venv" / "bin"
        cls.run_words(cls.bin / "pip", "install", "--no-index", cls.wheel)

    @classmethod
    def run_words(cls, *words, **variables):
        """What the command prints, in the folder; it has to end well. No setting or package of ours is there but what is installed."""
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH" and not name.startswith("EYEBRIDGE_")}
        environment |= {"EYEBRIDGE_FAST": "true", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
        environment |= {name: str(value) for name, value in variables.items()}
        run = subprocess.run([str(word) for word in words], cwd=cls.folder, env=environment, capture_output=True, text=True, timeout=1500)
        if run.returncode != 0:
            raise AssertionError(f"{words}: exit code {run.returncode}\n{run.stdout}{run.stderr}")
        return run.stdout

    @classmethod
    def git(cls, *words):
        return cls.run_words("git", "-c", "safe.directory=*", "-C", SOURCE, *words)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def test_the_sdist_has_what_git_knows(self):
        top = f"eyebridge-{self.version}"
        self.assertEqual(self.sdist.name, f"{top}.tar.gz")
        with tarfile.open(self.sdist) as archive:
            names = set(archive.getnames())
            commit = archive.extractfile(f"{top}/cmake/commit.txt").read().decode()
            self.assertTrue(archive.getmember(f"{top}/run").mode & 0o100)
        known = {f"{top}/{name}" for name in self.git("ls-files", "-z").split("\0") if (SOURCE / name).is_file()}
        self.assertEqual(names, known | {f"{top}/PKG-INFO"})
        self.assertRegex(commit, f"^{self.commit}(-modified)?\n$")

    def test_an_sdist_cannot_be_made_where_git_knows_nothing(self):
        with tarfile.open(self.sdist) as archive:
            archive.extractall(self.folder / "unpacked")
        root = self.folder / "unpacked" / f"eyebridge-{self.version}"
        script = "import eyebridge_wheel as e\ntry: e.build_sdist('.')\nexcept RuntimeError as error: print(error)"
        out = self.run_words(sys.executable, "-c", script, PYTHONPATH=root / "python" / "build_backend")
        self.assertIn("an sdist has the files that git knows, but git says of ", out)

    def test_the_wheel_is_complete(self):
        with zipfile.ZipFile(self.wheel) as wheel:
            names = set(wheel.namelist())
            metadata = wheel.read(f"eyebridge-{self.version}.dist-info/METADATA").decode()
        for name in ("eye/__init__.py", "eye/__init__.pyi", "eye/py.typed", "eyebridge/__init__.py", "eyebridge/__init__.pyi",
                     "eyebridge/py.typed", "eyebridge/control/__main__.py", "eyebridge/lib/libeyebridge.so.0",
                     "eyebridge/lib/eyebridge/eyebridge-robots", "eyebridge/bin/eyebridge", "eyebridge/include/eyebridge/eyebot.h",
                     "eyebridge/share/eyebridge/worlds/maze-8.maz", f"eyebridge-{self.version}.dist-info/LICENSE"):  # fmt: skip
            self.assertIn(name, names)
        self.assertIn(f"\nVersion: {self.version}\n", metadata)

    def test_every_version_is_that_of_the_project(self):
        script = "import eye, eyebridge, importlib.metadata as m; print(eye.__version__, eyebridge.__version__, m.version('eyebridge'))"
        self.assertEqual(self.run_words(self.bin / "python", "-c", script).split(), [self.version] * 3)

    def test_the_command_tells_the_commit(self):
        out = self.run_words(self.bin / "python", "-m", "eyebridge", "--version")
        self.assertRegex(out, rf"^eyebridge {re.escape(self.version)} \(commit {self.commit[:12]}(-modified)?\)\n$")
        self.assertEqual(self.run_words(self.bin / "eyebridge", "--version"), out)

    def test_every_command_is_installed(self):
        for name in COMMANDS:
            with self.subTest(name):
                self.assertRegex(self.run_words(self.bin / name, "--version"), "^(eyebridge|gcc|g\\+\\+) ")

    def test_both_packages_work(self):
        out = self.run_words(self.bin / "python", SOURCE / "examples" / "wall_follow.py")
        self.assertRegex(out, "^stopped at ")
        script = "import eye, eyebridge; print(eye.__file__, eyebridge.load_scenario('maze-8.maz').size)"
        self.assertIn("site-packages", self.run_words(self.bin / "python", "-c", script))

    def test_the_command_runs_programs_in_its_own_environment(self):
        self.assertIn("maze-8.maz", self.run_words(self.bin / "eyebridge", "world", "list"))
        program = self.write("prefix.py", "import eye, sys\nprint(sys.prefix, eye.__file__)\n")
        out = self.run_words(self.bin / "eyebridge", "run", "--world", "maze-8.maz", program)
        prefix, file = out.split()
        self.assertTrue(os.path.samefile(prefix, self.folder / "venv"), out)
        self.assertTrue(pathlib.Path(file).is_relative_to(prefix), out)

    def test_several_robots_run_a_program(self):
        program = self.write("several.py", "import eye\nprint(eye.OSMachineID())\n")
        self.assertEqual(sorted(self.run_words(self.bin / "python", program, EYEBRIDGE_ROBOTS=2).split()), ["1", "2"])

    def test_programs_in_c_and_c_plus_plus_are_compiled_and_run(self):
        for compiler, name in (("eyebridge-cc", "one.c"), ("eyebridge-c++", "two.cpp")):
            with self.subTest(compiler):
                self.run_words(self.bin / compiler, self.write(name, C_PROGRAM), "-o", "prog")
                self.assertEqual(self.run_words(self.bin / "eyebridge", "run", "prog"), "arrived\n")
                self.assertEqual(self.run_words(self.folder / "prog"), "arrived\n")

    def test_pip_removes_all_of_it(self):
        self.run_words(sys.executable, "-m", "venv", "other")
        other = self.folder / "other"
        before = set(other.rglob("*"))
        self.run_words(other / "bin" / "pip", "install", "--no-index", self.wheel)
        self.run_words(other / "bin" / "pip", "uninstall", "-y", "eyebridge")
        left = {path for path in set(other.rglob("*")) - before if "__pycache__" not in path.parts}
        self.assertEqual(left, set())


if __name__ == "__main__":
    main()
