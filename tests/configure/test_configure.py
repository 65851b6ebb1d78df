"""The configure step of CMake, without a preset: each option off, each package missing, and what it says of that."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1))
CMAKE = sys.argv.pop(1)

# Option -> what the summary calls that part.
OPTIONS = {
    "EYEBRIDGE_WITH_PYTHON": "Python module eyebridge",
    "EYEBRIDGE_WITH_GUI": "windows",
    "EYEBRIDGE_WITH_MPI": "sweeps over several computers",
    "EYEBRIDGE_WITH_CORTEX": "firmware for a Cortex-M3",
    "EYEBRIDGE_WITH_OPENCV": "fiducials, calibration",
    "EYEBRIDGE_WITH_TESTS": "tests",
    "EYEBRIDGE_WITH_BENCH": "benchmarks",
}
# CMake's name of a package -> the part that goes without it, and what Debian calls it.
OPTIONAL = {
    "pybind11": ("Python module eyebridge", "python3-dev pybind11-dev"),
    "Qt6": ("windows", "qt6-base-dev libxcb1-dev"),
    "MPI": ("sweeps over several computers", "libopenmpi-dev"),
    "GTest": ("tests", "libgtest-dev libgmock-dev"),
}


class Configure(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="eyebridge-test-")
        cls.build = pathlib.Path(cls.folder.name) / "anything"
        cls.first = pathlib.Path(cls.folder.name) / "first"
        cls.first_run = cls.run_cmake()
        if cls.first_run.returncode == 0:
            # Compilers are looked at once: what follows begins with a copy of this.
            shutil.move(cls.build, cls.first)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def run_cmake(cls, *words):
        environment = {name: value for name, value in os.environ.items() if not name.startswith("CMAKE_")}
        return subprocess.run(
            [CMAKE, "-S", SOURCE, "-B", cls.build, "-G", "Ninja", *words], env=environment, capture_output=True, text=True
        )

    def configure(self, *words):
        """A configure step with these options: its summary, from a part's name to its state."""
        self.assertEqual(self.first_run.returncode, 0, self.first_run.stderr)
        shutil.rmtree(self.build, ignore_errors=True)
        shutil.copytree(self.first, self.build, symlinks=True)
        run = self.run_cmake(*words)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("CMake Warning", run.stderr)
        return dict(re.findall(r"^--   (\S.*?)(?: {2,}|: )(\S.*)$", run.stdout, re.MULTILINE))

    def refused(self, *words):
        """What a configure step says that fails."""
        shutil.rmtree(self.build, ignore_errors=True)
        shutil.copytree(self.first, self.build, symlinks=True)
        run = self.run_cmake(*words)
        self.assertNotEqual(run.returncode, 0)
        return run.stderr

    def test_any_folder_and_no_preset_will_do(self):
        for kind in ("Release", "Debug"):
            with self.subTest(kind):
                self.assertEqual(self.configure(f"-DCMAKE_BUILD_TYPE={kind}")["tests"], "yes")

    def test_each_option_can_be_off(self):
        for option, part in OPTIONS.items():
            with self.subTest(option):
                summary = self.configure(f"-D{option}=OFF", "-DCMAKE_BUILD_TYPE=Release")
                self.assertEqual(summary[part], f"no: {option} is OFF")

    def test_all_options_can_be_off(self):
        summary = self.configure(*(f"-D{option}=OFF" for option in OPTIONS))
        for option, part in OPTIONS.items():
            self.assertEqual(summary[part], f"no: {option} is OFF")

    def test_a_missing_package_is_named_where_it_can_be_missed(self):
        for name, (part, packages) in OPTIONAL.items():
            with self.subTest(name):
                summary = self.configure(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON")
                self.assertEqual(summary[part], f"no: missing: apt install {packages}")

    def test_windows_need_no_mouse_of_their_tests(self):
        # A computer without libxcb-xtest0-dev: its pkg-config does not know it.
        program = pathlib.Path(self.folder.name) / "pkg-config"
        program.write_text('#!/bin/sh\ncase "$*" in *xcb-xtest*) exit 1 ;; esac\nexec pkg-config "$@"\n')
        program.chmod(0o755)
        summary = self.configure(f"-DPKG_CONFIG_EXECUTABLE={program}", "-DXTEST_FOUND=")
        self.assertEqual(summary["windows"], "yes")
        self.assertEqual(summary["tests of windows"], "no: missing: apt install libxcb-xtest0-dev")

    def test_all_missing_packages_are_named_at_once(self):
        said = self.refused("-DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON")
        self.assertIn("apt install libfmt-dev libpng-dev\n", said)

    def test_files_go_where_the_prefix_wants_them(self):
        version = f"{sys.version_info.major}.{sys.version_info.minor}"
        machine = sys.implementation._multiarch
        for prefix, library, python in (
            ("/usr", f"lib/{machine}", "lib/python3/dist-packages"),
            ("/usr/local", "lib", f"lib/python{version}/dist-packages"),
            ("/opt/eyebridge", "lib", f"lib/python{version}/site-packages"),
        ):
            with self.subTest(prefix):
                summary = self.configure("--fresh", f"-DCMAKE_INSTALL_PREFIX={prefix}")
                self.assertEqual(summary["libraries"], library)
                self.assertEqual(summary["Python packages"], python)
        self.assertEqual(self.configure("-DEYEBRIDGE_PYTHON_DIR=lib/here")["Python packages"], "lib/here")

    def test_an_absolute_folder_for_libraries_is_refused(self):
        self.assertIn("expected paths relative to", self.refused("-DCMAKE_INSTALL_LIBDIR=/usr/lib64"))

    def test_warnings_are_errors_where_somebody_says_so(self):
        self.configure()
        self.assertNotIn("-Werror", (self.build / "build.ninja").read_text())
        self.configure("-DEYEBRIDGE_WERROR=ON")
        self.assertIn("-Werror", (self.build / "build.ninja").read_text())


if __name__ == "__main__":
    unittest.main()
