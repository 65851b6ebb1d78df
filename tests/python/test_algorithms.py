"""Planning and localisation, as control files and other Python programs have them."""

import math
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

    def test_a_potential_field_draws_and_gets_stuck_before_a_wall(self):
        room = eyebridge.OccupancyGrid.truth_of(eyebridge.default_scenario())
        path = eyebridge.plan(room, (0.5, 0.5), (1.4, 1.4), radius=0.1, method="potential_field")
        np.testing.assert_allclose(path[-1], (1.4, 1.4))
        self.assertIsNone(eyebridge.plan(self.truth, (0.7, 1.0), (0.7, 3.0), radius=0.1, method="potential_field"))

    def test_dstar_lite_plans_anew_what_has_changed(self):
        room = eyebridge.OccupancyGrid(3.0, 2.0)
        planner = eyebridge.DStarLite(room, (2.5, 1.0))
        self.assertAlmostEqual(planner.plan((0.5, 1.0))[:, 1].max(), 1.025)
        room.set_probability(1.5, 1.0, 0.99)
        length = lambda path: np.hypot(*np.diff(path, axis=0).T).sum()
        anew = eyebridge.plan(room, (0.5, 1.0), (2.5, 1.0))
        self.assertAlmostEqual(length(planner.plan((0.5, 1.0))), length(anew))
        self.assertGreater(length(anew), 2.02)
        for row in range(40):
            room.set_probability(1.5, 0.025 + row * 0.05, 0.99)
        self.assertIsNone(planner.plan((0.5, 1.0)))
        room.set_probability(1.5, 0.025, 0.01)
        self.assertLess(planner.plan((0.5, 1.0))[:, 1].min(), 0.05)
        self.assertGreater(planner.expanded, 0)
        with self.assertRaisesRegex(ValueError, "start"):
            planner.plan((1.5, 1.0))
        with self.assertRaisesRegex(ValueError, "'radius', expected 0 m or more"):
            eyebridge.DStarLite(room, (2.5, 1.0), radius=-1)

    def test_landmarks_tell_where_the_robot_is(self):
        where = eyebridge.LandmarkEkf((0, 0, 0), position_sigma=0.2, heading_sigma=0.1)
        before = where.covariance[1, 1]
        for landmark in ((2.0, 0.0), (0.0, 2.0)):
            # It is at (0.1, 0, 0) in truth.
            range, bearing = math.dist(landmark, (0.1, 0)), math.atan2(landmark[1], landmark[0] - 0.1)
            self.assertTrue(where.update(landmark, range, bearing))
        self.assertLess(math.dist(where.estimate, (0.1, 0, 0)), 0.01)
        self.assertLess(where.covariance[1, 1], before)
        self.assertLess(where.nees((0.1, 0, 0)), 9)
        self.assertFalse(where.update((2.0, 0.0), 0.5, 2.0), "that is another one")
        where.predict((0, 0, 0), (0.5, 0, 0))
        self.assertAlmostEqual(where.estimate[0], 0.6, places=1)
        with self.assertRaisesRegex(ValueError, "'range', expected a length of more than 0 m"):
            where.update((2.0, 0.0), 0.0, 0.0)
        with self.assertRaisesRegex(ValueError, "position_sigma"):
            eyebridge.LandmarkEkf((0, 0, 0), position_sigma=-1)

    def scan(self, sim, pose):
        """Exact ranges and bearings from a pose."""
        bearings = np.pi - 2 * np.pi * np.arange(180) / 180
        return sim.cast_rays(pose[0], pose[1], bearings + pose[2], ignore=0), bearings

    def test_a_scan_is_fitted_into_the_map(self):
        with eyebridge.Simulation(eyebridge.load_scenario(SOURCE / "worlds" / "rooms.wld")) as sim:
            pose = (2.0, 2.3, 0.7)
            scan = self.scan(sim, pose)
            matcher = eyebridge.ScanMatcher(self.truth)
            found, score = matcher.match((1.9, 2.4, 0.6), *scan)
            self.assertLess(math.dist(found[:2], pose[:2]), 0.04)  # walls lie between cells
            self.assertLess(abs(found[2] - pose[2]), 0.03)
            self.assertGreater(score, 0.7)
            self.assertIsNone(matcher.match((0.7, 1.0, 0.6), *scan))
            with self.assertRaisesRegex(ValueError, "as many bearings as ranges"):
                matcher.match(pose, scan[0][:5], scan[1])
            with self.assertRaises(ValueError):
                matcher.match(pose, *scan, max_range=math.inf)
            with self.assertRaises(ValueError):
                eyebridge.ScanMatcher(self.truth, window=1e9)
            self.assertIsNone(matcher.match(pose, [1e12], [0.0], max_range=1e13))

    def test_slam_draws_a_map_and_knows_its_place_on_it(self):
        with eyebridge.Simulation(eyebridge.load_scenario(SOURCE / "worlds" / "rooms.wld")) as sim:
            slam = eyebridge.GridSlam(eyebridge.OccupancyGrid(4.0, 4.0), (2.0, 0.5, 1.5), sigma=0.005)
            outcomes = []
            for i in range(30):
                pose = (2.0, 0.5 + 0.1 * i, 1.5)
                odometry = (2.0 + 0.01 * i, 0.5 + 0.1 * i, 1.5)  # it slips to the side
                outcomes.append(slam.add(odometry, *self.scan(sim, pose)))
            self.assertEqual(set(outcomes), {"added"})
            self.assertLess(math.dist(slam.pose[:2], pose[:2]), 0.06)
            self.assertEqual(slam.add(odometry, *self.scan(sim, pose)), "skipped")
            found = slam.map.agreement(self.truth)
            self.assertGreater(found["observed"], 1500)
            self.assertGreater(found["share"], 0.95)
            self.assertEqual(slam.unmatched, 0)

    def test_the_dynamic_window_drives_to_its_goal_and_brakes_before_walls(self):
        room = eyebridge.OccupancyGrid(3.0, 2.0)
        window = eyebridge.DynamicWindow(room, radius=0.1, speed=0.3)
        pose, now = (0.5, 1.0, 0.0), (0.0, 0.0)

        def drive(goal):
            nonlocal pose, now
            for _ in range(150):
                linear, angular, braking = window.choose(pose, now, goal)
                now, (x, y, theta) = (linear, angular), pose
                middle = theta + 0.05 * angular
                pose = x + 0.1 * linear * math.cos(middle), y + 0.1 * linear * math.sin(middle), theta + 0.1 * angular
                if braking and linear == 0:
                    break

        drive((2.0, 1.3))
        self.assertLess(math.dist(pose[:2], (2.0, 1.3)), 0.1)
        pose, now = (0.5, 1.0, 0.0), (0.0, 0.0)
        for row in range(40):  # now there is a wall across
            room.set_probability(1.5, 0.025 + row * 0.05, 0.99)
        drive((2.5, 1.0))
        self.assertLess(pose[0], 1.5 - 0.1)


if __name__ == "__main__":
    main()
