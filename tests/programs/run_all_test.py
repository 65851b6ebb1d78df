"""./test programs on a folder of four programs: what its table says of each."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

BIN = sys.argv.pop()

PROGRAMS = {
    "drives.c": '#include "eyebot.h"\nint main() { VWStraight(500, 200); VWWait(); return 0; }\n',
    "lacks/asks.c": '#include "eyebot.h"\nint main() { return SERVOSet(12, 100) > 0; }\n',
    "stuck.py": "from eye import *\nVWSetSpeed(300, 0)\nOSWait(20000)\n",
    "two/main.c": '#include "eyebot.h"\nint half(int);\nint main() { return half(0); }\n',
    "two/half.c": "int half(int x) { return x / 2; }\n",
    "wrong.c": '#include "eyebot.h"\nint main() { return nothing; }\n',
    "crash.c": '#include "eyebot.h"\n#include <stdlib.h>\nint main() { OSWait(10); abort(); }\n',
    "notes.txt": "no program\n",
}


class RunAll(unittest.TestCase):
    def run_on(self, folder):
        script = pathlib.Path(__file__).with_name("run_all.py")
        return subprocess.run([sys.executable, "-B", str(script), "--bin", BIN, str(folder)], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False)

    def test_the_table_says_what_came_of_each(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in PROGRAMS.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(exist_ok=True)
                path.write_text(text, encoding="utf-8")
            run = self.run_on(folder)
        self.assertEqual(run.returncode, 1, run.stderr)
        rows = {line.split()[0]: line for line in run.stdout.splitlines()}
        self.assertRegex(rows["drives.c"], r"yes +0\.50 +ends")
        self.assertRegex(rows["lacks/asks.c"], r"yes +0\.00 +servo 12 +exit 1|yes +0\.00 +servo 12 +ends")
        self.assertRegex(rows["stuck.py"], r"yes +0\.\d\d +1[5-9] +ends")
        self.assertRegex(rows["two/main.c"], r"yes +0\.00 +ends")
        self.assertNotIn("two/half.c", rows)
        self.assertRegex(rows["wrong.c"], r"no .*nothing")
        self.assertIn("crashes (6)", rows["crash.c"])
        self.assertIn("6 programs, 5 compile, 1 crash or hang, 1 stuck, 1 lack a device", run.stdout)

    def test_a_folder_without_programs_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            run = self.run_on(folder)
        self.assertIn("no robot program in it", run.stderr)
        self.assertEqual(run.returncode, 1)


if __name__ == "__main__":
    unittest.main()
