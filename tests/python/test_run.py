"""How Python programs are started."""

import sys

from support import BUILD, ProgramTest, main

EYEBRIDGE = BUILD / "bin" / "eyebridge"
DRIVE = "from eye import *\nVWStraight(100, 100)\nVWWait()\nprint(VWGetPosition())\n"
DROVE = "[100, 0, 0]\n"


class Run(ProgramTest):
    def environment(self, settings):
        """As users have it: no PYTHONPATH."""
        out = super().environment(settings)
        del out["PYTHONPATH"]
        return out

    def eyebridge(self, *words):
        run = self.run_words([EYEBRIDGE, "run", "--fast", *words], {"log": "warning"})
        self.assertEqual(run.err, "")
        return run

    def test_eyebridge_run_finds_eye(self):
        self.write("prog.py", DRIVE)
        self.assertEqual(self.eyebridge("prog.py").out, DROVE)

    def test_a_script_with_a_shebang(self):
        path = self.write("prog", "#!/usr/bin/env python3\n" + DRIVE)
        path.chmod(0o755)
        self.assertEqual(self.eyebridge("./prog").out, DROVE)

    def test_another_eye_beside_the_program_does_not_matter(self):
        self.write("eye.py", "raise ImportError('the wrong one')\n")
        self.write("prog.py", DRIVE)
        self.assertEqual(self.eyebridge("prog.py").out, DROVE)

    def test_the_programs_own_modules_and_arguments(self):
        (self.folder / "sub").mkdir()
        self.write("sub/helper.py", "def name():\n    return 'helper'\n")
        self.write("sub/prog.py", "import sys\nimport helper\nprint(helper.name(), sys.argv, __name__, __file__)\n")
        run = self.eyebridge("sub/prog.py", "a", "-b")
        self.assertEqual(run.out, "helper ['sub/prog.py', 'a', '-b'] __main__ sub/prog.py\n")

    def test_globals_and_threads_outlive_the_last_line(self):
        self.write("prog.py", """
            from eye import *
            import threading
            word = "still here"
            def late():
                OSWait(100)
                print(word, __name__)
            threading.Thread(target=late).start()
            """)
        self.assertEqual(self.eyebridge("prog.py").out, "still here __main__\n")

    def test_the_programs_time_is_the_robots_even_before_eye(self):
        self.write("prog.py", """
            import time
            from time import sleep
            start = time.time()
            from eye import *
            OSWait(1000)
            sleep(1)
            print(round(time.time() - start))
            """)
        self.assertEqual(self.eyebridge("prog.py").out, "2\n")

    def test_an_exception_is_shown_from_the_programs_line_on(self):
        self.write("prog.py", "from eye import *\ndef f():\n    return 1 / 0\nf()\n")
        run = self.run_words([EYEBRIDGE, "run", "--fast", "prog.py"], {"log": "warning"})
        self.assertEqual(run.returncode, 1)
        self.assertIn("ZeroDivisionError", run.err)
        self.assertNotIn("__main__.py", run.err)
        self.assertEqual(run.err.count("File "), 2)

    def test_a_syntax_error_is_shown_as_python_does(self):
        self.write("prog.py", "from eye import *\nif\n")
        run = self.run_words([EYEBRIDGE, "run", "--fast", "prog.py"], {"log": "warning"})
        self.assertEqual(run.returncode, 1)
        self.assertIn("SyntaxError", run.err)
        self.assertNotIn("__main__.py", run.err)

    def test_settings_beside_the_program_hold(self):
        (self.folder / "sub").mkdir()
        self.write("sub/eyebridge.toml", 'fast = true\nlcd = "300x200"\n')
        self.write("sub/prog.py", "from eye import *\nprint(LCDGetSize())\n")
        for words in ([EYEBRIDGE, "run", "sub/prog.py"], ["env", f"PYTHONPATH={BUILD}/python", sys.executable, "sub/prog.py"]):
            run = self.run_words(words, {"log": "warning"})
            self.assertEqual((run.returncode, run.out), (0, "[300, 200]\n"), run.err)

    def test_python3_runs_a_program_with_the_packages_in_its_path(self):
        self.write("prog.py", DRIVE)
        run = self.run_words(["env", f"PYTHONPATH={BUILD}/python", sys.executable, "prog.py"])
        self.assertEqual(run.out, DROVE, run.err)

    def test_a_program_that_is_not_there(self):
        run = self.run_words(["env", f"PYTHONPATH={BUILD}/python", sys.executable, "-m", "eye", "gone.py"])
        self.assertEqual(run.returncode, 1)
        self.assertIn("No such file", run.err)


if __name__ == "__main__":
    main()
