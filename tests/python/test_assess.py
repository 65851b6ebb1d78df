"""`eyebridge assess` with control files; with other programs: tests/apps/assess_test.cpp."""

import csv
import textwrap

from support import BUILD, SOURCE, ProgramTest, main

HEAD = "def run(robot, keep_going, belief_space, map_space, interact):\n"
ROOM = SOURCE / "worlds" / "empty-room.wld"


class Assess(ProgramTest):
    def assess(self, body, *options):
        """Runs an assessment of a control file whose run() has the lines `body`; the rows of runs.csv."""
        self.write("control.py", HEAD + textwrap.indent(textwrap.dedent(body).strip("\n"), "    ") + "\n")
        run = self.run_words([BUILD / "bin" / "eyebridge", "assess", "--worlds", ROOM, *options, "control.py"], {"log": "error"})
        self.assertEqual(run.returncode, 0, run.err)
        with (self.folder / "assessment" / "runs.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def test_a_belief_is_compared_with_the_world(self):
        # Of 38 x 38 free cells of 5 cm two are known; one of them is wrong, and no wall is near.
        (run,) = self.assess("""
            belief_space.set(0.53, 0.53, 0.1)
            belief_space.set(1.53, 1.53, 0.9)
        """, "--seeds", "1")
        self.assertEqual((run["verdict"], run["agreement"], run["observed"]), ("success", "0.5", "2"))
        self.assertAlmostEqual(float(run["coverage"]), 2 / 38**2, delta=1e-6)

    def test_readings_count_and_a_run_without_a_belief_has_no_number(self):
        scans = "for _ in range(5):\n    belief_space.update(1, 'lidar')"
        (run,) = self.assess(scans, "--seeds", "1")
        self.assertGreater(float(run["coverage"]), 0.9)
        self.assertGreater(float(run["agreement"]), 0.97)
        self.assess("interact.wait(1)", "--seeds", "1", "--out", "assessment/second")
        with (self.folder / "assessment" / "second" / "runs.csv").open(newline="") as file:
            (run,) = csv.DictReader(file)
        self.assertEqual((run["verdict"], run["coverage"], run["agreement"]), ("success", "", ""))

    def test_a_belief_of_another_kind_is_not_compared_and_the_run_goes_well(self):
        (run,) = self.assess("belief_space.set(1, 1, 0.1)\nbelief_space.grid = None", "--seeds", "1")
        self.assertEqual((run["verdict"], run["coverage"]), ("success", ""))

    def test_the_way_and_the_goal_are_those_of_the_world(self):
        # From (1, 1), and it stops at once.
        (run,) = self.assess("""
            robot(1).start().set_twist(0.2)
            while robot(1).true_pose[0] < 1.4:
                pass
            robot(1).stop()
        """, "--seeds", "1", "--goal", "1400,1000,10")
        self.assertEqual(run["verdict"], "success", run["reason"])
        self.assertAlmostEqual(float(run["path_m"]), 0.4, delta=0.01)
        self.assertAlmostEqual(float(run["path_m"]), float(run["end_x_m"]) - 1, delta=1e-4)

    def test_an_exception_is_a_failure_with_its_line_and_stops_no_other_run(self):
        runs = self.assess("""
            interact.wait(1)
            belief_space.set(0.5, 0.5, 0.1)
            1 / (robot(1).read("psd 1") < 0)
        """, "--seeds", "3", "--errors", "realistic")
        self.assertEqual([run["verdict"] for run in runs], ["failed"] * 3)
        self.assertIn("control.py:4: run: ZeroDivisionError", runs[2]["reason"])
        self.assertNotEqual(runs[0]["coverage"], "")  # what it found until then

    def test_one_that_does_not_end_fails_by_its_time_limit(self):
        (run,) = self.assess("while keep_going():\n    pass", "--seeds", "1", "--time-limit", "2s")
        self.assertEqual((run["verdict"], run["reason"]), ("time limit", "no end before the time limit"))


if __name__ == "__main__":
    main()
