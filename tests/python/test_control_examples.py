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

    def test_plan_compares_the_planners_and_drives_their_ways(self):
        out = self.example("plan.py", "rooms.wld", "--errors", "realistic", "--time-limit", "120s")
        share = {name: float(number) for name, number in re.findall(r"^(\w+): [\d.]+ m, ([\d.]+)% of the shortest$", out, re.M)}
        self.assertEqual(set(share), {"astar", "dstar_lite", "wavefront", "theta_star", "rrt_star"})
        self.assertIn("potential_field: got stuck\n", out)  # it draws straight at a wall
        self.assertEqual(share["astar"], share["dstar_lite"])
        self.assertEqual(share["astar"], share["wavefront"])
        self.assertLessEqual(share["theta_star"], share["astar"])
        self.assertLess(max(share.values()), 109)  # eight directions: 8.2 % at worst
        drives = re.findall(r"^(.*): (\d+)% of its path, (\d+) mm off, walls (\d+) mm away$", out, re.M)
        self.assertEqual([name for name, *_ in drives], ["pure pursuit", "dynamic window"])
        for name, way, off, gap in drives:
            self.assertLess(int(way), 115, name)
            self.assertLess(int(off), 60, name)
            self.assertGreater(int(gap), 20, name)

    def test_replan_comes_through_unknown_floor_with_little_work(self):
        out = self.example("replan.py", "rooms.wld", "--errors", "realistic", "--time-limit", "120s")
        off, times, work, fresh = re.search(
            r"(\d+) mm from the goal after .* m, ([\d.]+) times\n.*; (\d+) cells expanded, (\d+) by", out).groups()  # fmt: skip
        self.assertLess(int(off), 60)
        self.assertLess(float(times), 1.3)
        self.assertLess(int(work), int(fresh) / 4)

    def test_landmarks_are_better_than_odometry(self):
        out = self.example("landmarks.py", SOURCE / "examples" / "control" / "landmarks.sim", "--errors", "harsh",
                           "--time-limit", "120s")  # fmt: skip
        seen, mean, end, by_wheels = map(int, re.findall(r"(\d+) (?:sightings|mm)", out))
        self.assertGreater(seen, 500)
        self.assertLess(max(mean, end), 40)
        self.assertGreater(by_wheels, 4 * mean)

    def test_slam_and_scan_matching_know_their_place(self):
        out = self.example("slam.py", "rooms.wld", "--errors", "harsh", "--time-limit", "60s")
        slam, matched, by_wheels = map(int, re.findall(r": (\d+) mm off", out))
        cells, share = re.search(r"(\d+) cells are on the map, ([\d.]+)% of them rightly", out).groups()
        self.assertLess(max(slam, matched), 100)
        self.assertGreater(by_wheels, 3 * slam)
        self.assertGreater(int(cells), 3000)
        self.assertGreater(float(share), 93)


if __name__ == "__main__":
    main()
