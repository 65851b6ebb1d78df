"""Python programs as some of several robots: a process each, one world, one time."""

import os
import pathlib
import re
import select
import signal
import stat
import sys
import unittest.mock

from support import BUILD, SOURCE, ProgramTest, main

EYEBRIDGE = BUILD / "bin" / "eyebridge"
ROOMS = SOURCE / "worlds" / "rooms.wld"
PROGRAMS = BUILD / "tests" / "robios" / "programs"
ROOM = "floor 3000 3000\n0 0 3000 0\n3000 0 3000 3000\n3000 3000 0 3000\n0 3000 0 0\n"
PLACES = ("S4 500 500 0", "S4 1500 500 90", "S4 2500 2500 180", "S4 500 2500 0", "S4 1500 1500 45")
CLOCKS = ({"fast": True}, {"fast": False, "factor": 20})

# Drives by what it sees, in virtual and in real time.
DRIVES = """
    from eye import *
    import sys, time
    counted = 0
    me = OSMachineID()
    for i in range(20):
        counted += me
        VWSetSpeed(100 if PSDGet(PSD_FRONT) > 300 else 0, 20 * me)
        time.sleep(0.1)
    x, y, phi = VWGetPosition()
    print(me, counted, OSGetCount() // 100, *sys.argv[1:], flush=True)
    """

# Three threads that read sensors, each at times of its own; no call before theirs.
SENSES = """
    from eye import *
    import threading
    seen = []
    def sense(name, pause):
        for i in range(15):
            x, y, phi = VWGetPosition()
            psd = PSDGet(1 + ord(name) % 3)
            seen.append(f"{name}{OSGetCount()}:{x},{phi},{psd}")
            if name == "a":
                VWSetSpeed(100 + psd % 100, psd % 40 - 20)
            if pause:
                OSWait(pause)
    threads = [threading.Thread(target=sense, args=own) for own in (("a", 3), ("b", 5), ("c", 0))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print(OSMachineID(), *seen, flush=True)
    """


def state_of(run):
    return re.search("trace [0-9a-f]{16}", run.err).group()


class Several(ProgramTest):
    def robots(self, count, text, settings=None):
        """Runs the program `text` for so many robots."""
        self.write("prog.py", text)
        settings = {"fast": True, "world": ROOMS} | (settings or {})
        return self.run_words([EYEBRIDGE, "run", "--robots", count, "prog.py"], settings)

    def scenario(self, *programs):
        """A world whose robots run these, each a line's end."""
        self.write("room.wld", ROOM)
        lines = [f"{place} {program}" for place, program in zip(PLACES, programs)]
        path = self.write("all.sim", "world room.wld\n" + "\n".join(lines) + "\n")
        trusted = self.run_words([EYEBRIDGE, "trust", path])  # some are outside of this folder
        self.assertEqual(trusted.returncode, 0, trusted.err)
        return path

    def run_scenario(self, *programs, settings=None):
        path = self.scenario(*programs)
        return self.run_words([EYEBRIDGE, "run", "--world", path], {"fast": True} | (settings or {}))

    def test_runs_with_threads_that_read_sensors_repeat(self):
        results = set()
        all_processors = os.sched_getaffinity(0)
        self.addCleanup(os.sched_setaffinity, 0, all_processors)
        for processors in (all_processors, {min(all_processors)}):
            os.sched_setaffinity(0, processors)  # those that are started inherit it
            for _ in range(1 if "EYEBRIDGE_TEST_SLOW" in os.environ else 6):
                run = self.robots(2, SENSES)
                self.assertEqual(run.returncode, 0, run.err)
                results.add((*sorted(run.out.splitlines()), state_of(run)))
        self.assertEqual(len(results), 1)

    def test_each_has_globals_a_number_and_time_of_its_own(self):
        for clock in CLOCKS:
            run = self.robots(3, DRIVES, clock)
            self.assertEqual(run.returncode, 0, run.err)
            rows = sorted(line.split() for line in run.out.splitlines())
            self.assertEqual([row[:2] for row in rows], [["1", "20"], ["2", "40"], ["3", "60"]], run.err)
            self.assertTrue(all(int(row[2]) >= 20 for row in rows), rows)
            self.assertIn("eyebridge: 3 robots, ", run.err)

    def test_virtual_runs_are_one_run(self):
        states = {state_of(self.robots(4, DRIVES)) for _ in range(3)}
        self.assertEqual(len(states), 1, states)
        self.assertNotEqual(states, {state_of(self.robots(3, DRIVES))})

    def test_its_state_is_that_of_the_same_program_in_c(self):
        """Each call takes the same time and does the same."""
        self.write("prog.py", """
            from eye import *
            me = OSMachineID()
            for i in range(5 + me):
                VWSetSpeed(20 * me, 0)
                OSWait(100)
            OSGetCount()
            VWGetPosition()
            LCDSetPrintf(0, 0, "robot %d", me)
            CAMInit(QQVGA if me == 1 else QVGA)
            """)
        settings = {"fast": True, "world": ROOMS}
        python = self.run_words([EYEBRIDGE, "run", "--robots", 3, "prog.py"], settings)
        self.assertEqual(python.returncode, 0, python.err)
        native = self.run_words([EYEBRIDGE, "run", "--robots", 3, PROGRAMS / "several"], settings)
        self.assertEqual(state_of(python), state_of(native))
        clock = re.compile(r"robots, ([0-9.]+) s on their clock")
        self.assertEqual(clock.search(python.err).group(1), clock.search(native.err).group(1))

    def test_a_c_robot_and_a_python_robot_talk_by_radio(self):
        self.write("ping.py", """
            from eye import *
            RADIOInit()
            me = RADIOGetID()
            while RADIOStatus()[0] < 2:
                OSWait(10)
            for i in range(1, 11):
                if me == 1:
                    RADIOSend(2, "ping %d" % i)
                sender, text = RADIOReceive()
                print("py", sender, text)
                if me == 2:
                    RADIOSend(1, "pong %d" % i)
            OSWait(200)
            """)
        c = PROGRAMS / "pingpong"
        for programs, wanted in (((c, "ping.py"), ("2: pong 10", "py 1 ping 10")), (("ping.py", c), ("1: ping 10", "py 2 pong 10"))):
            states = set()
            for _ in range(2):
                run = self.run_scenario(*programs)
                self.assertEqual(run.returncode, 0, run.err)
                for line in wanted:
                    self.assertIn(line, run.out + run.err)
                states.add(state_of(run))
            self.assertEqual(len(states), 1)
        run = self.run_scenario(c, "ping.py", settings={"fast": False, "factor": 10})
        self.assertEqual((run.returncode, run.out.count("py 1 ping")), (0, 10), run.out + run.err)

    def test_ends_of_any_kind_are_that_robots_own(self):
        self.write("ends.py", """
            from eye import *
            import os, sys
            me = OSMachineID()
            OSWait(100)
            if me == 1: sys.exit(3)
            if me == 2: raise ValueError("no more")
            if me == 3: os.abort()
            if me == 4: os._exit(0)
            OSWait(1000)
            print("robot", me, "is left at", OSGetCount() // 100 * 100)
            """)
        for clock in CLOCKS:
            run = self.run_scenario(*["ends.py"] * 5, settings=clock)
            self.assertEqual(run.returncode, 3, run.err)
            # A slow computer is later in real time, how much nobody can say.
            late = r"1[1-9]00" if clock["fast"] else r"(1[1-9]|[2-9]\d|\d{3,})00"
            self.assertRegex(run.out, rf"^robot 5 is left at {late}\n$")
            self.assertIn("ValueError: no more", run.err)
            self.assertIn("robot 3: error: the program was ended by a signal: Aborted; the others go on", run.err)
            for quiet in ("robot 1: error", "robot 4: error", "robot 5: error"):
                self.assertNotIn(quiet, run.err)

    def test_exit_codes_by_the_robots_numbers(self):
        self.write("good.py", "from eye import *\nOSWait(10)\n")
        self.write("abort.py", "from eye import *\nimport os\nOSWait(10)\nos.abort()\n")
        run = self.run_scenario("good.py", "abort.py", "good.py")
        self.assertEqual(run.returncode, 128 + signal.SIGABRT, run.err)

    def test_one_that_hangs_is_told_of_and_ended(self):
        self.write("hang.py", """
            from eye import *
            OSWait(100)
            while OSMachineID() == 2:
                while True:
                    pass
            OSWait(10000)
            print(OSMachineID(), "at", OSGetCount() // 100 * 100)
            """)
        # An emulated processor may compute for a second until Python has begun, or ended.
        run = self.run_scenario(*["hang.py"] * 3, settings={"hang_limit": "4s"})
        self.assertEqual(run.returncode, 124, run.err)
        self.assertEqual(sorted(run.out.splitlines()), ["1 at 10100", "3 at 10100"])
        self.assertIn("robot 2: warning: the program has computed for 2 s without a call", run.err)
        self.assertIn("robot 2: error: the program has made no call for too long", run.err)

    def test_each_sees_with_its_own_camera(self):
        self.write("sees.py", """
            from eye import *
            CAMInit(QQVGA)
            image = bytes(CAMGet())
            OSWait(500)
            print(OSMachineID(), sum(image) // 1000, sum(bytes(CAMGet())) // 1000)
            """)
        run = self.run_scenario("sees.py", "sees.py")
        self.assertEqual(run.returncode, 0, run.err)
        self.assertEqual(run.out, self.run_scenario("sees.py", "sees.py").out)
        first, second = sorted(line.split() for line in run.out.splitlines())
        self.assertEqual((first[0], second[0]), ("1", "2"))
        self.assertNotEqual(first[1:], second[1:])  # they look elsewhere
        self.assertGreater(int(first[1]), 0)

    def test_results_go_to_a_folder_each(self):
        run = self.robots(2, "from eye import *\nLCDPrintf('hello %d', OSMachineID())\nVWStraight(200, 100)\nVWWait()\n",
                          {"out": "out"})  # fmt: skip
        self.assertEqual(run.returncode, 0, run.err)
        self.assertNotIn("x); results in", run.err)
        for number in (1, 2):
            folder = self.folder / "out" / f"robot-{number}"
            self.assertTrue((folder / "lcd.txt").read_text().startswith(f"hello {number}"))
            self.assertGreater((folder / "map.png").stat().st_size, 100)
            rows = (folder / "trace.csv").read_text().splitlines()
            self.assertGreater(len(rows), 30)
            start, end = (tuple(float(word) for word in row.split(",")[1:3]) for row in (rows[1], rows[-1]))
            self.assertAlmostEqual(((end[0] - start[0]) ** 2 + (end[1] - start[1]) ** 2) ** 0.5, 0.2, delta=0.01)

    def test_settings_are_the_fleets(self):
        (self.folder / "one").mkdir()
        self.write("one/eyebridge.toml", 'lcd = "300x200"\nfast = false\n')
        self.write("one/prog.py", "from eye import *\nprint(LCDGetSize(), KEYRead() == KEY2, flush=True)\n")
        self.write("two.py", "from eye import *\nprint(LCDGetSize(), KEYRead() == KEY2, flush=True)\n")
        run = self.run_scenario("two.py", "one/prog.py", settings={"lcd": "400x300", "keys": "KEY2@0s"})
        self.assertEqual(run.out, "[400, 300] True\n" * 2, run.err)

    def test_the_world_is_one(self):
        self.write("sim.py", """
            from eye import *
            me = OSMachineID()
            OSWait(100 * me)
            if me == 1:
                SIMSetRobot(2, 2000, 2000, 0, 90)
            OSWait(300)
            x, y, z, phi = SIMGetRobot(2)
            print(me, x, y, phi, flush=True)
            """)
        run = self.run_scenario("sim.py", "sim.py")
        self.assertEqual(run.out, "1 2000 2000 90\n2 2000 2000 90\n", run.err)

    def test_submarines_are_at_the_heights_that_others_see(self):
        self.write("room.wld", ROOM + "water 3000\n")
        self.write("dives.py", """
            from eye import *
            me = OSMachineID()
            if me == 1:
                SIMSetRobot(2, 2000, 2000, 1000, 90)
            OSWait(100)
            print(me, *(SIMGetRobot(i)[2] for i in (1, 2)), PSDGet(6), flush=True)
            """)
        path = self.write("dive.sim", "world room.wld\nUSAL 500 500 0 dives.py\nUSAL 2000 1000 0 dives.py\n")
        run = self.run_words([EYEBRIDGE, "run", "--world", path], {"fast": True})
        self.assertEqual(sorted(run.out.splitlines()), ["1 2740 1000 2740", "2 2740 1000 1000"], run.err)

    def test_one_is_added_while_others_run(self):
        self.write("waits.py", """
            from eye import *
            RADIOInit()
            print("ready", flush=True)
            while RADIOCheck() <= 0:
                OSWait(100)
            print(*RADIOReceive(), flush=True)
            """)
        self.write("says.py", "from eye import *\nimport sys\nRADIOInit()\nRADIOSend(1, sys.argv[1])\n")
        own = {"XDG_RUNTIME_DIR": str(self.folder)}
        for clock in CLOCKS:
            path = self.scenario("waits.py")
            with unittest.mock.patch.dict(os.environ, own):
                process = self.start([EYEBRIDGE, "run", "--robots", "all", "--world", path], clock)
                self.assertEqual(process.stdout.readline(), "ready\n")
                added = self.run_words([EYEBRIDGE, "add", "S4", 1500, 1500, 90, "says.py", "hello"])
            self.assertEqual((added.out, added.err), ("2\n", ""))
            run = self.finish(process)
            self.assertEqual((run.returncode, run.out), (0, "2 hello\n"), run.err)

    def test_ctrl_c_leaves_no_process_behind(self):
        for program in ("while True:\n    OSWait(1000)\n", "while True:\n    pass\n"):
            for clock in ({"fast": True, "hang_limit": "1000s"}, {"fast": False}):
                self.write("prog.py", f"from eye import *\nimport os\nOSWait(1)\nLCDPrintf('hi')\nprint(os.getpid(), flush=True)\n{program}")
                process = self.start([EYEBRIDGE, "run", "--robots", 2, "prog.py"], clock | {"world": ROOMS, "out": "out"})
                # In virtual time all wait for the first one that hangs.
                hangs = "pass" in program and clock["fast"]
                children = [int(process.stdout.readline()) for _ in range(1 if hangs else 2)]
                process.send_signal(signal.SIGINT)
                run = self.finish(process)
                self.assertEqual(run.returncode, -signal.SIGINT, run.err)
                for child in children:
                    self.assertFalse(pathlib.Path(f"/proc/{child}").exists(), program)
                self.assertTrue((self.folder / "out/robot-1/lcd.txt").read_text().startswith("hi"))

    def test_a_fleet_that_is_killed_takes_its_programs_along(self):
        process_ends = """
            from eye import *
            import os
            OSWait(1)
            print(os.getpid(), flush=True)
            while True:
                pass
            """
        self.write("prog.py", process_ends)
        process = self.start([EYEBRIDGE, "run", "--robots", 2, "prog.py"], {"fast": False, "world": ROOMS})
        watched = [os.pidfd_open(int(process.stdout.readline())) for _ in range(2)]
        process.kill()
        process.communicate()
        process.watchdog.cancel()
        for descriptor in watched:
            self.assertTrue(select.select([descriptor], [], [], 60)[0], "it goes on")
            os.close(descriptor)

    def test_nonsense_on_the_line_ends_that_robot(self):
        self.write("good.py", "from eye import *\nOSWait(300)\nprint('good')\n")
        self.write("bad.py", """
            from eye import *
            import ctypes, signal
            OSWait(100)
            for line in open("/proc/self/maps"):
                if "eyebridge-line" in line:
                    begin, end = (int(word, 16) for word in line.split()[0].split("-"))
                    ctypes.memset(begin, 0xA5, end - begin)
            signal.pause()
            print("not reached")
            """)
        run = self.run_scenario("bad.py", "good.py")
        self.assertEqual((run.returncode, run.out), (1, "good\n"), run.err)
        self.assertRegex(run.err, r"robot 1: error: found \d+ bytes in a line that has room for 16384")

    def test_nobody_moves_before_all_have_made_a_call(self):
        self.write("late.py", """
            from eye import *
            import sys, time
            time.sleep(float(sys.argv[1]))
            at = OSGetCount()
            VWSetSpeed(200, 0)
            OSWait(500)
            print(OSMachineID(), "at", at, "drove", VWGetPosition()[0] // 10 * 10, flush=True)
            """)
        for programs in (("late.py 0.7", "late.py 0", PROGRAMS / "gathers"), ("late.py 0.1", "late.py 0", f"{PROGRAMS}/gathers 700")):
            run = self.run_scenario(*programs)
            self.assertEqual(run.returncode, 0, run.err)
            self.assertEqual(sorted(run.out.splitlines()), [f"{number} at 700 drove 80" for number in (1, 2, 3)], run.err)

    def test_a_program_that_never_calls(self):
        self.write("quiet.py", "print('quiet', flush=True)\n")
        self.write("prog.py", DRIVES)
        for clock in CLOCKS:
            run = self.run_scenario("quiet.py", "prog.py word", settings=clock)
            self.assertEqual(run.returncode, 0, run.err)
            self.assertEqual(sorted(line.split()[0] for line in run.out.splitlines()), ["2", "quiet"])
            self.assertIn("word", run.out)

    def test_a_script_with_a_shebang_and_one_that_cannot_be_started(self):
        path = self.write("script", "#!/usr/bin/env python3\nfrom eye import *\nOSWait(10)\nprint(OSMachineID())\n")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        path = self.write("wrong", "#!/nowhere/python3\n")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        run = self.run_scenario("script", "wrong")
        self.assertEqual((run.returncode, run.out), (126, "1\n"), run.err)
        self.assertIn("robot 2: error:", run.err)
        self.assertIn("wrong cannot be started: No such file or directory", run.err)

    def test_python3_with_several_robots_is_the_same(self):
        self.write("prog.py", DRIVES)
        run = self.run_words([sys.executable, "prog.py", "a", "-b"], {"fast": True, "robots": 3, "world": ROOMS})
        self.assertEqual(run.returncode, 0, run.err)
        rows = sorted(line.split() for line in run.out.splitlines())
        self.assertEqual([row[0] for row in rows], ["1", "2", "3"])
        self.assertEqual(rows[0][3:], ["a", "-b"])
        self.assertEqual(state_of(run), state_of(self.robots(3, DRIVES)))

    def test_a_time_limit_ends_all(self):
        run = self.robots(2, "from eye import *\nwhile True:\n    OSWait(100)\n", {"time_limit": "5s"})
        self.assertEqual(run.returncode, 0, run.err)
        self.assertIn("2 robots, 5.0", run.err)


if __name__ == "__main__":
    main()
