"""Planning and localisation, as control files and other Python programs have them."""

import unittest

import eyebridge
import numpy as np
from support import SOURCE, main


class Algorithms(unittest.TestCase):
    def setUp(self):
        self.truth = eyebridge.OccupancyGrid.truth_of(eyebridge.load_scenario(SOURCE / "worlds" / "rooms.wld"))

    def test_every_method_finds_a_way_that_touches_nothing(self):
        lengths = {}
        for method in ("astar", "theta_star", "dstar_lite", "wavefront", "rrt_star"):
            path = eyebridge.plan(self.truth, (0.7, 1.5), (3.3, 2.5), radius=0.1, method=method, shorten=True)
            steps = np.diff(path, axis=0)
            lengths[method] = np.hypot(*steps.T).sum()
            for (x, y), (dx, dy) in zip(path, steps):
                for part in np.linspace(0, 1, 100):
                    self.assertEqual(self.truth.state(x + part * dx, y + part * dy), "free", method)
        self.assertGreater(min(lengths.values()), 2.7)
        self.assertLess(max(lengths.values()), 1.2 * min(lengths.values()))

    def test_no_way_is_none_and_bad_ends_are_errors(self):
        walled = eyebridge.OccupancyGrid(1.0, 1.0, resolution=0.1)
        for row in range(10):
            walled.set_probability(0.55, 0.05 + row / 10, 0.99)
        self.assertIsNone(eyebridge.plan(walled, (0.1, 0.1), (0.9, 0.9)))
        with self.assertRaisesRegex(ValueError, "goal"):
            eyebridge.plan(walled, (0.1, 0.1), (0.55, 0.55))
        with self.assertRaisesRegex(ValueError, "expected astar, theta_star"):
            eyebridge.plan(walled, (0.1, 0.1), (0.2, 0.2), method="magic")

    def test_pursuit_drives_along_its_path(self):
        pursuit = eyebridge.PurePursuit([(0, 0), (1, 0)], speed=0.2)
        self.assertEqual(pursuit.follow((0, 0, 0)), (0.2, 0.0))
        self.assertGreater(pursuit.follow((0.3, -0.1, 0))[1], 0)
        pursuit.follow((1, 0, 0))
        self.assertTrue(pursuit.has_arrived)

    def test_particles_come_to_where_the_robot_is(self):
        scenario = eyebridge.load_scenario(SOURCE / "worlds" / "slalom.wld")
        grid = eyebridge.OccupancyGrid.truth_of(scenario)
        where = eyebridge.MonteCarlo(grid, seed=3)
        with eyebridge.Simulation(scenario) as sim:
            robot = sim.robots[0]
            where.start_at(robot.pose, 0.2, 0.2)
            bearings = np.pi - 2 * np.pi * np.arange(360) / 360
            for _ in range(30):
                before = robot.odometry
                robot.set_speed(0.1, 0.3)
                sim.run(0.2)
                where.predict(before, robot.odometry)
                where.correct(robot.lidar(), bearings)
            x, y, _ = robot.pose
            self.assertLess(np.hypot(where.estimate[0] - x, where.estimate[1] - y), 0.05)
        self.assertLess(where.deviation[0], 0.1)
        self.assertAlmostEqual(where.particles[:, 3].sum(), 1.0)


if __name__ == "__main__":
    main()
