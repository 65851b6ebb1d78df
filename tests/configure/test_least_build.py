"""The least that can be built, without a preset and with sources compiled together as CMake does it: it installs and drives."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1))
CMAKE = sys.argv.pop(1)
OFF = ("PYTHON", "GUI", "MPI", "CORTEX", "OPENCV", "TESTS", "BENCH")


class LeastBuild(unittest.TestCase):
    def run_words(self, *words, expected=0):
        environment = {name: value for name, value in os.environ.items() if not name.startswith(("CMAKE_", "EYEBRIDGE_"))}
        run = subprocess.run([str(word) for word in words], env=environment, cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, expected, run.stdout[-4000:] + run.stderr[-4000:])
        return run.stdout + run.stderr

    def test_it_installs_and_drives(self):
        with tempfile.TemporaryDirectory(prefix="eyebridge-test-") as folder:
            self.folder = pathlib.Path(folder)
            self.run_words(CMAKE, "-S", SOURCE, "-B", "anything", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0",
                           "-DCMAKE_UNITY_BUILD=ON", *(f"-DEYEBRIDGE_WITH_{part}=OFF" for part in OFF))  # fmt: skip
            self.run_words("nice", CMAKE, "--build", "anything", "--target", "installable")
            self.run_words(CMAKE, "--install", "anything", "--prefix", "first")
            os.rename(self.folder / "first", self.folder / "moved")
            worlds = self.folder / "moved/share/eyebridge/worlds"
            self.run_words("moved/bin/eyebridge-cc", SOURCE / "tests/apps/consumer/prog.c", "-o", "prog")
            said = self.run_words("moved/bin/eyebridge", "run", "--fast", "--world", worlds / "rooms.wld", "prog")
            self.assertIn("at 300 0 90\n", said)
            (self.folder / "prog.py").write_text("")
            said = self.run_words("moved/bin/eyebridge", "run", "prog.py", expected=2)
            self.assertIn("build with EYEBRIDGE_WITH_PYTHON=ON", said)


if __name__ == "__main__":
    unittest.main()
