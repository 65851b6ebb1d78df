"""pip install . in a clean venv, without network: what users do."""

import os
import subprocess
import sys
import tempfile
import unittest
import zipfile

from support import SOURCE, main


class Install(unittest.TestCase):
    def run_words(self, *words, cwd):
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH" and not name.startswith("EYEBRIDGE_")}
        environment |= {"EYEBRIDGE_FAST": "true", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "http_proxy": "http://127.0.0.1:9",
                        "https_proxy": "http://127.0.0.1:9"}  # fmt: skip
        run = subprocess.run([str(word) for word in words], cwd=cwd, env=environment, capture_output=True, text=True, timeout=1500)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def test_pip_installs_both_packages_and_the_library(self):
        with tempfile.TemporaryDirectory(prefix="eyebridge-test-") as folder:
            self.run_words(sys.executable, "-m", "venv", "venv", cwd=folder)
            python = os.path.join(folder, "venv", "bin", "python")
            self.run_words(python, "-m", "pip", "wheel", "--no-deps", "-w", folder, SOURCE, cwd=folder)
            wheel = [name for name in os.listdir(folder) if name.endswith(".whl")]
            self.assertEqual(len(wheel), 1)
            names = zipfile.ZipFile(os.path.join(folder, wheel[0])).namelist()
            for name in ("eye/__init__.py", "eye/__init__.pyi", "eye/py.typed", "eyebridge/__init__.py", "eyebridge/libeyebridge.so.0",
                         "eyebridge/eyebridge-robots"):
                self.assertIn(name, names)
            self.run_words(python, "-m", "pip", "install", SOURCE, cwd=folder)
            out = self.run_words(python, SOURCE / "examples" / "wall_follow.py", cwd=folder)
            self.assertRegex(out, "^stopped at ")
            out = self.run_words(python, "-c", "import eye, eyebridge; print(eye.__file__, eyebridge.default_scenario().size)", cwd=folder)
            self.assertIn("site-packages", out)
            with open(os.path.join(folder, "prog.py"), "w") as program:
                program.write("import eye\nprint(eye.OSMachineID())\n")
            out = self.run_words("env", "EYEBRIDGE_ROBOTS=2", python, "prog.py", cwd=folder)
            self.assertEqual(sorted(out.split()), ["1", "2"])
            self.run_words(python, "-m", "pip", "uninstall", "-y", "eyebridge", cwd=folder)


if __name__ == "__main__":
    main()
