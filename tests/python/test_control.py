"""Control files: `def run(robot, keep_going, belief_space, map_space, interact)`."""

import signal
import subprocess
import textwrap

from support import BUILD, SOURCE, ProgramTest, main

EYEBRIDGE = BUILD / "bin" / "eyebridge"
HEAD = "def run(robot, keep_going, belief_space, map_space, interact):\n"


class ControlTest(ProgramTest):
    def environment(self, settings):
        """As users have it: no PYTHONPATH."""
        out = super().environment(settings)
        del out["PYTHONPATH"]
        return out

    def control(self, body, *options, before="", **settings):
        """Runs a control file in virtual time whose run() has the lines `body`."""
        text = textwrap.dedent(before) + HEAD + textwrap.indent(textwrap.dedent(body).strip("\n"), "    ") + "\n"
        self.write("control.py", text)
        words = [EYEBRIDGE, "run", "--fast", "--no-gui", *options, "control.py"]
        return self.run_words(words, {"log": "error"} | settings)

    def says(self, lines, body, *options, before="", **settings):
        run = self.control(body, *options, before=before, **settings)
        self.assertEqual((run.out.splitlines(), run.err, run.returncode), (lines, "", 0))

    def fails(self, message, body, *options, before="", **settings):
        run = self.control(body, *options, before=before, **settings)
        self.assertEqual((run.err, run.returncode), (f"eyebridge: {message}\n", 1), run.out)
        return run


class Robots(ControlTest):
    def test_wheels_drive_it_as_far_as_they_turn(self):
        self.says(["0.27 0.00 0.00 10.0"], """
            robot("Robot 1").start()
            x, y, theta = robot("Robot 1").true_pose
            robot("Robot 1").set_wheel("left", 8)
            robot("Robot 1").set_wheel("right", 8)
            while robot("Robot 1").wheel("left") < 10:
                pass
            at = robot("Robot 1").true_pose
            interact.print(f"{at[0] - x:.2f} {at[1] - y:.2f} {at[2] - theta:.2f}", end=" ")
            interact.print(f"{robot('Robot 1').wheel('right'):.1f}")
        """)

    def test_it_stands_until_it_is_started_and_then_does_what_it_was_told(self):
        self.says(["0.000", "0.345"], """
            one = robot("Robot 1")
            x = one.true_pose[0]
            one.set_twist(0.3)
            interact.wait(1)
            interact.print(f"{one.true_pose[0] - x:.3f}")
            one.start()
            interact.wait(1.15)
            one.stop()
            interact.wait(1)
            interact.print(f"{one.true_pose[0] - x:.3f}")
        """)

    def test_its_own_function_runs_beside_run(self):
        self.says(["run 0.5", "one 1.0", "run 1.5", "one 2.0", "run 2.5", "one 3.0"], """
            robot(1).start()
            interact.wait(0.5)
            for _ in range(3):
                interact.print(f"run {time.time() - began:.1f}")
                time.sleep(1)
        """, before="""
            import time
            began = time.time()
            def robot_1(robot, keep_going, belief_space, map_space, interact):
                for _ in range(3):
                    interact.wait(1)
                    interact.print(f"one {time.time() - began:.1f}")
        """)

    def test_a_function_that_is_given_runs_beside_run(self):
        self.says(["beside", "run"], """
            def beside(robot, keep_going, belief_space, map_space, interact):
                interact.print("beside")
            robot(1).start(beside)
            interact.wait(0.1)
            interact.print("run")
        """)

    def test_its_own_function_begins_once_however_often_it_is_started(self):
        self.says(["1", "1"], """
            robot(1).start()
            interact.wait(0.2)
            robot(1).start()
            interact.wait(0.2)
            interact.print(len(begun))
        """, before="""
            begun = []
            def robot_1(robot, keep_going, belief_space, map_space, interact):
                begun.append(1)
                robot("Robot 1").start()
                interact.wait(0.1)
                interact.print(len(begun))
                interact.wait(1)
        """)

    def test_wheels_are_those_of_the_robots_drive(self):
        for model, motors in (("Car", ["drive"]), ("Omni", ["front left", "front right", "rear left", "rear right"])):
            self.says([str(motors)], "interact.print(robot(1).motors)", "--robot", model)
        self.fails("control.py:2: run: LookupError: found no wheel of Robot 1 'right', expected one of: drive, 1",
                   'robot(1).set_wheel("right", 1)', "--robot", "Car")  # fmt: skip

    def test_all_robots_of_a_scenario_are_there(self):
        self.says(["Robot 1 Robot 2", "True"], """
            one, two = robot("Robot 1"), robot("Robot 2")
            interact.print(one.name, two.name)
            interact.print(one.true_pose != two.true_pose)
        """, "--world", SOURCE / "worlds" / "two-robots.sim")

    def test_the_same_file_and_seed_give_the_same_run(self):
        body = """
            def beside(robot, keep_going, belief_space, map_space, interact):
                robot(2).start()
                while keep_going():
                    robot(2).set_twist(0.2, robot(2).read("psd 1"))
            robot(1).start()
            robot(2).start(beside)
            while keep_going():
                near = robot(1).read("psd 1") < 0.2
                robot(1).set_twist(0.0 if near else 0.3, 1.0 if near else 0.1)
        """
        for name in ("first", "second"):
            run = self.control(body, "--world", SOURCE / "worlds" / "two-robots.sim", "--errors", "realistic",
                               "--time-limit", "20s", "--report", name)  # fmt: skip
            self.assertEqual(run.returncode, 0, run.err)
        first, second = ((self.folder / name).read_text() for name in ("first", "second"))
        self.assertIn("hash", first)
        self.assertEqual(first, second)


class Spaces(ControlTest):
    def test_the_map_is_the_world(self):
        self.says(["True False True"], """
            known = map_space.is_occupied(0.0, 1.0), map_space.is_occupied(1.0, 1.0), map_space.is_free(1.0, 1.0)
            interact.print(*known)
        """)

    def test_the_belief_grows_by_readings_and_agrees_with_the_map(self):
        self.says(["False", "True", "True True"], """
            interact.print(belief_space.is_known(1.5, 1.0))
            robot(1).start().set_twist(0.0, 1.0)
            while keep_going() and interact.wait(0.1) is None and robot(1).wheel("left") > -12:
                belief_space.update("Robot 1")
            interact.print(belief_space.is_free(1.5, 1.0))
            found = belief_space.grid.agreement(map_space.grid)
            interact.print(found["share"] > 0.97, found["observed"] > 500)
        """)

    def test_numpy_sees_the_cells_without_a_copy(self):
        self.says(["True", "False", "0.9"], """
            cells = belief_space.log_odds
            before = cells.max()
            belief_space.set(1.0, 1.0, 0.9)
            interact.print(bool(cells.max() > before))
            interact.print(cells.flags.writeable)
            interact.print(f"{belief_space.probability(1.0, 1.0):.1f}")
        """)

    def test_readings_are_added_by_names_and_only_of_what_measures_distances(self):
        self.says(["True"], """
            for _ in range(4):
                belief_space.add(1, "psd 1", 0.5, (1.0, 1.0, 0.0))
            interact.print(belief_space.is_free(1.3, 1.0))
        """)
        self.fails("control.py:2: run: ValueError: <Robot 1: compass> measures no distance: expected a PSD, ultrasound, "
                   "infrared or lidar", 'belief_space.add(1, "compass", 0.5, (1.0, 1.0, 0.0))')  # fmt: skip

    def test_a_robot_that_was_put_moves_with_its_wheels(self):
        self.says(["3.0 4.3 1.6"], """
            belief_space.set_robot(1, 3.0, 4.0, 1.5708)
            robot(1).start().set_twist(0.3)
            interact.wait(1)
            interact.print("{:.1f} {:.1f} {:.1f}".format(*belief_space.robot(1)))
        """)

    def test_a_robot_is_where_it_was_put_or_by_its_wheels(self):
        self.says(["1.00 1.00", "0.25 0.75 0.50", "Robot 1 is not in this space; expected set_robot('Robot 1') before"], """
            belief_space.set_robot("Robot 1")
            interact.print("{:.2f} {:.2f}".format(*belief_space.robot("Robot 1")))
            belief_space.set_robot("Robot 1", 0.25, 0.75, 0.5)
            interact.print("{:.2f} {:.2f} {:.2f}".format(*belief_space.robot(1)))
            try:
                map_space.robot("Robot 1")
            except LookupError as error:
                interact.print(error)
        """)


class Interaction(ControlTest):
    def answer(self, typed, body, *options):
        self.write("control.py", HEAD + textwrap.indent(textwrap.dedent(body), "    "))
        words = [str(word) for word in (EYEBRIDGE, "run", "--no-gui", *options, "control.py")]
        return subprocess.run(words, cwd=self.folder, env=self.environment({}), input=typed, text=True,
                              capture_output=True, timeout=120)  # fmt: skip

    def test_a_prompt_gives_what_is_typed(self):
        run = self.answer("Ada\nno\n", 'interact.print(interact("name? "), interact.confirm("sure?"))', "--fast")
        self.assertEqual((run.stdout, run.stderr), ("name? sure? (yes/no) Ada False\n", ""))

    def test_without_anybody_there_it_is_the_default_or_an_error(self):
        run = self.answer("", 'interact.print(interact.prompt("speed? ", "0.3"))', "--fast")
        self.assertEqual((run.stdout, run.returncode), ("speed? 0.3\n", 0))
        run = self.answer("", 'interact("speed? ")', "--fast")
        self.assertIn("control.py:2: run: EOFError: interact: nobody answers 'speed? '", run.stderr)
        self.assertEqual(run.returncode, 1)

    def test_the_world_goes_on_while_somebody_thinks(self):
        body = """
            robot(1).start().set_twist(0.2)
            beside = []
            def watch(robot, keep_going, belief_space, map_space, interact):
                x = robot(1).true_pose[0]
                while robot(1).true_pose[0] < x + 0.05:
                    interact.wait(0.05)
                interact.print("it drove")
            robot(1).start(watch)
            interact("? ")
        """
        self.write("control.py", HEAD + textwrap.indent(textwrap.dedent(body), "    "))
        words = [str(word) for word in (EYEBRIDGE, "run", "--no-gui", "--factor", "10", "control.py")]
        with subprocess.Popen(words, cwd=self.folder, env=self.environment({}), stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, text=True) as process:  # fmt: skip
            self.assertEqual(process.stdout.readline(), "? it drove\n")
            process.communicate("\n", timeout=120)
        self.assertEqual(process.returncode, 0)


class Ends(ControlTest):
    def test_the_time_limit_is_polite(self):
        run = self.control("""
            while keep_going():
                interact.wait(0.5)
            interact.print("goodbye")
        """, "--time-limit", "2s")
        self.assertEqual((run.out, run.returncode), ("goodbye\n", 0))
        self.assertEqual(run.err, "eyebridge: the time limit of 2 s: the run ends\n")

    def test_who_does_not_ask_is_ended_all_the_same(self):
        run = self.control("while True:\n    interact.wait(100)", "--time-limit", "2s")
        self.assertEqual((run.err, run.returncode), ("eyebridge: the time limit of 2 s: the run ends\n", 0))

    def test_ctrl_c_is_polite(self):
        text = HEAD + "    interact.print('up')\n    while keep_going():\n        pass\n    interact.print('goodbye')\n"
        self.write("control.py", text)
        process = self.start([EYEBRIDGE, "run", "--no-gui", "control.py"], {"log": "error"})
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        run = self.finish(process)
        self.assertEqual((run.out, run.returncode), ("goodbye\n", 0), run.err)

    def test_sigterm_is_polite_too_and_a_second_signal_ends_at_once(self):
        text = HEAD + "    interact.print('up')\n    while keep_going():\n        pass\n    interact.print('goodbye')\n"
        self.write("control.py", text + "    interact.prompt('? ', 'nobody')\n")
        process = self.start([EYEBRIDGE, "run", "--no-gui", "control.py"], {"log": "error"})
        process.stdout.readline()
        process.send_signal(signal.SIGTERM)
        run = self.finish(process)
        self.assertEqual((run.out, run.returncode), ("goodbye\n? ", 0), run.err)
        self.write("control.py", HEAD + "    while True:\n        interact.print('on')\n        interact.wait(1)\n")
        process = self.start([EYEBRIDGE, "run", "--no-gui", "--factor", "0.01", "control.py"], {"log": "error"})
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(self.finish(process).returncode, 130)

    def test_a_routine_that_begins_late_is_ended_too(self):
        run = self.control("""
            while keep_going():
                interact.wait(0.5)
            robot(1).start(late)
        """, "--time-limit", "2s", before="""
            def late(robot, keep_going, belief_space, map_space, interact):
                while True:
                    interact.wait(0.1)
        """)
        self.assertEqual(run.returncode, 0, run.err)

    def test_who_waits_for_an_answer_does_not_hold_the_end(self):
        self.write("control.py", HEAD + "    robot(1).start(ask)\n    interact.wait(3)\n"
                   "def ask(robot, keep_going, belief_space, map_space, interact):\n    interact('? ')\n")  # fmt: skip
        words = [str(word) for word in (EYEBRIDGE, "run", "--no-gui", "--factor", "10", "--time-limit", "1s", "control.py")]
        with subprocess.Popen(words, cwd=self.folder, env=self.environment({}), stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:  # fmt: skip
            self.assertEqual(process.wait(timeout=120), 0)


class Mistakes(ControlTest):
    def test_an_exception_names_its_line_and_others_go_on(self):
        run = self.fails("control.py:4: Robot 1: ZeroDivisionError: division by zero", """
            robot(1).start(bad)
            robot(1).set_twist(0.3)
            interact.wait(3)
            x = robot(1).true_pose[0]
            interact.wait(1)
            interact.print(robot(1).true_pose[0] == x)
        """, before="""
            def bad(robot, keep_going, belief_space, map_space, interact):
                interact.wait(0.5)
                1 / 0
        """)
        self.assertEqual(run.out, "True\n")  # its robot stands

    def test_one_that_never_returns_is_ended_and_the_world_goes_on(self):
        run = self.control("""
            robot(1).start(stuck)
            interact.wait(1)
            interact.print("still here")
        """, "--hang-limit", "3s", before="""
            def stuck(robot, keep_going, belief_space, map_space, interact):
                while True:
                    pass
        """)
        self.assertEqual((run.out, run.returncode), ("still here\n", 1))
        self.assertRegex(run.err, r"^eyebridge: control\.py:[34]: Robot 1 has computed for 3 s without a call; expected ")

    def test_robots_and_sensors_that_are_not_there(self):
        self.fails("control.py:2: run: LookupError: found no robot 'Robot 7', expected one of: robot 1, 1; most like it: robot 1", 'robot("Robot 7")')
        run = self.control('robot(1).read("PSD_FRNT")')
        self.assertIn("LookupError: found no sensor of Robot 1 'PSD_FRNT', expected one of: ", run.err)
        run = self.control('robot(1).set_wheel("middle", 1)')
        self.assertIn("LookupError: found no wheel of Robot 1 'middle', expected one of: left, right", run.err)
        self.fails("control.py:2: run: ValueError: found nan for 'speed', expected a finite number",
                   'robot(1).set_wheel("left", float("nan"))')  # fmt: skip

    def test_a_file_that_cannot_be_read_as_python(self):
        self.fails("control.py:2:10: '(' was never closed", "robot(1", before="")
        self.fails("control.py:2: NameError: name 'nothing' is not defined", "pass", before="\nnothing\n")

    def test_a_run_with_other_parameters_is_a_program(self):
        self.write("control.py", "def run(robot):\n    pass\nprint('as a program')\n")
        run = self.run_words([EYEBRIDGE, "run", "--fast", "control.py"])
        self.assertEqual(run.out, "as a program\n")

    def test_a_world_that_is_not_there(self):
        run = self.control("pass", "--world", "nowhere.wld")
        self.assertIn("nowhere.wld", run.err)
        self.assertEqual(run.returncode, 2)


if __name__ == "__main__":
    main()
