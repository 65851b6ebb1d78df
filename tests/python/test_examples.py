"""The examples in Python, by what they do."""

import csv
import os
import re
import sys

from support import SOURCE, ProgramTest, main


class Examples(ProgramTest):
    def run_example(self, name, world, **settings):
        run = self.run_words([sys.executable, SOURCE / "examples" / name],
                             {"fast": True, "world": SOURCE / "worlds" / world} | settings)  # fmt: skip
        self.assertEqual(run.returncode, 0, run.err)
        return run

    def test_wall_follow_keeps_its_distance_to_the_wall(self):
        run = self.run_example("wall_follow.py", "empty-room.wld", out=self.folder / "out")
        self.assertRegex(run.out, r"^stopped at -?\d+ -?\d+, -?\d+ deg\n$")
        with open(self.folder / "out" / "trace.csv") as file:
            rows = list(csv.DictReader(file))
        left = [float(row["range_2"]) for row in rows if float(row["t"]) > 20]
        self.assertGreater(len(left), 400)
        self.assertGreater(sum(0.08 < value < 0.35 for value in left), 0.8 * len(left))

    def test_colour_search_finds_the_red_thing(self):
        run = self.run_example("colour_search.py", "colour-targets.sim")
        self.assertEqual((run.out, run.err), ("found it\n", ""))

    def test_evolve_network_learns_to_drive_without_bumping(self):
        # With sanitizers, at -O0, and on an emulated processor thirty generations take minutes: two show that nothing leaks or overflows.
        generations = 2 if "EYEBRIDGE_TEST_SLOW" in os.environ else 30
        run = self.run_words([sys.executable, SOURCE / "examples" / "training" / "evolve_network.py", str(generations), "4"])
        self.assertEqual((run.returncode, run.err), (0, ""))
        earned = [float(number) for number in re.findall(r"earned ([-\d.]+)", run.out)]
        bumped = [int(number) for number in re.findall(r"bumped (\d+)%", run.out)]
        self.assertEqual(len(earned), generations + 1, run.out)
        if generations == 2:
            return
        self.assertGreater(earned[-1], 5 * earned[0], run.out)
        self.assertLess(bumped[-1], bumped[0] / 2, run.out)


if __name__ == "__main__":
    main()
