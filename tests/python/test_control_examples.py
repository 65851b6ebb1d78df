"""The examples of control files, by what they measure of themselves."""

import re

from support import SOURCE, main
from test_control import EYEBRIDGE, ControlTest


class Examples(ControlTest):
    def example(self, name, world, *options):
        words = [EYEBRIDGE, "run", "--fast", "--no-gui", "--world", SOURCE / "worlds" / world, *options,
                 SOURCE / "examples" / "control" / name]  # fmt: skip
        run = self.run_words(words, {"log": "error"})
        self.assertEqual(run.returncode, 0, run.err)
        return run.out

    def test_first_maps_what_it_passes(self):
        out = self.example("first.py", "maze-8.maz", "--time-limit", "60s")
        cells, share = re.fullmatch(r"(\d+) cells are known, (.*)% of them rightly\n", out).groups()
        self.assertGreater(int(cells), 1000)
        self.assertGreater(float(share), 97)

    def test_explore_comes_to_know_all_rooms(self):
        out = self.example("explore.py", "rooms.wld", "--time-limit", "400s")
        known, share = re.fullmatch(r"(.*)% of what can be reached is known, (.*)% of it rightly\n", out).groups()
        self.assertGreater(float(known), 95)
        self.assertGreater(float(share), 97)

    def test_localise_finds_out_where_it_is(self):
        out = self.example("localise.py", "maze-8.maz", "--errors", "realistic", "--time-limit", "120s")
        self.assertLess(float(re.search(r", (\d+) mm off", out).group(1)), 60)


if __name__ == "__main__":
    main()
