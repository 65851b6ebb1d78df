"""However a program ends, the motors stop, results are written, and what was printed is there."""

import os
import pty
import select
import signal
import sys

from support import ProgramTest, main

REAL_TIME = {"fast": False}
# Says "ready" when the main thread is in a function of that name.
ANNOUNCE = """
import os, sys, threading
def announce(name):
    main = threading.main_thread().ident
    def watch():
        while sys._current_frames()[main].f_code.co_name != name:
            pass
        os.write(1, b"ready\\n")  # and nothing of what was printed
    threading.Thread(target=watch, daemon=True).start()
"""


class End(ProgramTest):
    def expect_results(self):
        for name in ("map.png", "lcd.png", "trace.csv"):
            self.assertGreater((self.folder / "out" / name).stat().st_size, 100, name)

    def interrupt(self, text, how=signal.SIGINT):
        """Runs a program in real time until it prints "ready", then sends a signal."""
        self.write("prog.py", text)
        process = self.start([sys.executable, "prog.py"], REAL_TIME | {"out": self.folder / "out", "keys": "KEY1@9999s"})
        while (line := process.stdout.readline()) != "ready\n":
            self.assertNotEqual(line, "", "the program ended before it was ready")
        process.send_signal(how)
        return self.finish(process)

    def test_ctrl_c_ends_a_program_that_waits_in_a_call(self):
        for call, name in (("VWStraight(100000, 100); VWWait()", "VWWait"), ("OSWait(100000)", "OSWait"),
                           ("time.sleep(1000)", "sleep"), ("KEYWait(ANYKEY)", "KEYWait"),
                           ("OSAttachTimer(1, lambda: None); OSWait(100000)", "OSWait")):  # fmt: skip
            run = self.interrupt(
                ANNOUNCE + f"import time\nfrom eye import *\nOSWait(100)\nannounce('{name}')\nprint('before')\n{call}\n",
            )
            self.assertEqual(run.returncode, -signal.SIGINT, call + run.err)
            self.assertEqual(run.out, "before\n", call)
            self.assertNotIn("Traceback", run.err, call)
            self.expect_results()

    def test_ctrl_c_is_a_keyboard_interrupt_while_python_runs(self):
        run = self.interrupt(
            """
            from eye import *
            VWSetSpeed(100, 0)
            OSWait(100)
            try:
                print("ready", flush=True)  # the signal may come before this line is left
                while True:
                    pass
            except KeyboardInterrupt:
                print("stopping", VWSetSpeed(0, 0))
            """
        )
        self.assertEqual((run.returncode, run.out), (0, "stopping 0\n"), run.err)
        self.expect_results()

    def test_a_keyboard_interrupt_that_nobody_catches(self):
        run = self.interrupt(
            """
            from eye import *
            VWSetSpeed(100, 0)
            OSWait(100)
            print("ready", flush=True)
            while True:
                pass
            """
        )
        self.assertEqual(run.returncode, -signal.SIGINT)
        self.assertIn("KeyboardInterrupt", run.err)
        self.expect_results()

    def test_ctrl_c_ends_what_python_itself_waits_for(self):
        self.write("prog.py", """
            from eye import *
            OSWait(100)
            try:
                print("ready", flush=True)
                while True:
                    input()
            except KeyboardInterrupt:
                print("stopping")
            """)
        person, terminal = pty.openpty()
        environment = self.environment(REAL_TIME)
        pid = os.fork()
        if pid == 0:
            os.setsid()
            for descriptor in (0, 1, 2):
                os.dup2(terminal, descriptor)
            os.chdir(self.folder)
            os.execve(sys.executable, [sys.executable, "prog.py"], environment)
        os.close(terminal)
        self.addCleanup(os.close, person)
        out = b""
        while b"ready" not in out:
            out += os.read(person, 1000)
        # As a person does: one that comes before Python reads is noticed only when something else comes.
        while not select.select([person], [], [], 0)[0]:
            os.kill(pid, signal.SIGINT)
            select.select([person], [], [], 1)
        while True:
            try:
                out += os.read(person, 1000)
            except OSError:
                break
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), 0, out)
        self.assertIn(b"stopping", out)

    def test_a_programs_own_handler_is_left_to_it(self):
        run = self.interrupt(
            """
            from eye import *
            import signal
            seen = []
            signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
            OSWait(100)
            print("ready", flush=True)
            while not seen:
                pass
            print("seen", seen)
            """
        )
        self.assertEqual((run.returncode, run.out), (0, "seen [2]\n"), run.err)

    def test_a_handler_that_comes_after_the_first_call_is_left_to_the_program(self):
        run = self.interrupt(
            """
            from eye import *
            import signal
            seen = []
            OSWait(100)
            signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
            print("ready", flush=True)
            while not seen:
                OSWait(1)
            print("seen", seen)
            """
        )
        self.assertEqual((run.returncode, run.out), (0, "seen [2]\n"), run.err)

    def test_sigterm_keeps_what_was_printed(self):
        run = self.interrupt(
            ANNOUNCE + "from eye import *\nOSWait(100)\nannounce('PSDGet')\nprint('before')\nwhile True:\n    PSDGet(1)\n",
            signal.SIGTERM,
        )
        self.assertEqual((run.returncode, run.out), (-signal.SIGTERM, "before\n"), run.err)
        self.expect_results()

    def test_a_time_limit_keeps_what_was_printed(self):
        run = self.run_program(
            """
            from eye import *
            print("printed", end=" here")
            while True:
                OSWait(10)
            """,
            {"time_limit": "1s", "out": self.folder / "out"},
        )
        self.assertEqual((run.returncode, run.out), (0, "printed here"), run.err)
        self.expect_results()

    def test_an_empty_loop_ends_at_the_time_limit_in_virtual_time(self):
        run = self.run_program(
            """
            from eye import *
            OSWait(100)
            print("before", flush=True)
            while True:
                pass
            """,
            {"time_limit": "2s"},
        )
        self.assertEqual(run.returncode, 0, run.err)
        self.assertEqual(run.out, "before\n")
        self.assertIn("longer than the time limit of 2 s; it ends", run.err)

    def test_a_loop_that_waits_for_what_another_thread_sets_ends(self):
        run = self.run_program(
            """
            import threading
            from eye import *
            flag = False
            def setter():
                global flag
                OSWait(500)
                flag = True
            OSWait(1)
            threading.Thread(target=setter, daemon=True).start()
            while not flag:
                pass
            print("set", OSGetCount() >= 500, flush=True)
            """,
        )
        self.assertEqual(run.returncode, 0, run.err)
        self.assertEqual(run.out, "set True\n")

    def test_a_key_that_cannot_come_ends_the_program(self):
        run = self.run_program("from eye import *\nprint('printed')\nKEYWait(KEY1)\n")
        self.assertEqual((run.returncode, run.out), (1, "printed\n"))
        self.assertIn("--keys", run.err)

    def test_exit_codes_are_the_programs(self):
        for end, code in (("", 0), ("exit()", 0), ("exit(3)", 3), ("raise ValueError('oh')", 1)):
            run = self.run_program(f"from eye import *\nVWSetSpeed(100, 0)\nOSWait(50)\n{end}\n", {"out": self.folder / "out"})
            self.assertEqual(run.returncode, code, run.err)
            self.expect_results()

    def test_a_program_may_end_while_timers_and_threads_run(self):
        for settings in ({"fast": True}, {"fast": False}):
            for _ in range(3):
                run = self.run_program(
                    """
                    from eye import *
                    import threading
                    def poll():
                        while True:
                            PSDGet(1)
                    for period in (1, 1, 2):
                        OSAttachTimer(period, lambda: LCDPrintf("tick"))
                    threading.Thread(target=poll, daemon=True).start()
                    OSWait(50)
                    print("done")
                    """,
                    settings,
                )
                self.assertEqual((run.returncode, run.out, run.err), (0, "done\n", ""))

    def test_a_bad_setting_ends_the_program_at_its_first_call(self):
        run = self.run_program("from eye import *\nprint('before', flush=True)\nPSDGet(1)\n", {"hal": "simm"})
        self.assertEqual((run.returncode, run.out), (2, "before\n"))
        self.assertIn("EYEBRIDGE_HAL", run.err)


if __name__ == "__main__":
    main()
