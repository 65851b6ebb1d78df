"""Sensors of robots of the module eyebridge."""

import math
import pathlib
import tempfile
import unittest

import eyebridge
import numpy as np
from support import SOURCE, main

WORLDS = SOURCE / "worlds"


class Sensors(unittest.TestCase):
    def test_gyroscope_and_accelerometer_feel_the_motion(self):
        with eyebridge.Simulation() as sim:
            robot = sim.robots[0]
            robot.set_speed(0.2, 0.5)
            sim.step()
            self.assertGreater(robot.accelerometer()[0], 0.5)
            sim.run(1)
            np.testing.assert_allclose(robot.gyroscope(), 0.5, atol=1e-9)
            np.testing.assert_allclose(robot.accelerometer(), (0, 0.1), atol=1e-9)
            robot.set_errors("gyroscope sigma=1 bias=5")
            rates = np.array([robot.gyroscope() for _ in range(2000)])
            np.testing.assert_allclose((rates.mean(), rates.std()), (0.5 + math.radians(5), math.radians(1)), rtol=0.1)

    def test_a_range_matrix_sees_the_wall_and_the_floor(self):
        with tempfile.TemporaryDirectory() as folder:
            world = pathlib.Path(folder) / "one.sim"
            (pathlib.Path(folder) / "tof.robi").write_text("name Seer\ndiameter 100\ntof 3 TOF_FRONT 50 0 100 0\n")
            world.write_text("robot tof.robi\nSeer 1000 1000 0\n")
            with eyebridge.Simulation(eyebridge.load_scenario(world)) as sim:
                ranges = sim.robots[0].range_matrix(3)
                self.assertEqual(ranges.shape, (8, 8))
                down = np.radians(45 / 8) * np.arange(-3, 5)  # lower edges of the rows
                floor = np.where(down > 0, 0.1 / np.tan(np.maximum(down, 1e-9)), np.inf)
                np.testing.assert_allclose(ranges, np.minimum(0.945, floor)[:, None].repeat(8, axis=1), atol=1e-9)
                with self.assertRaises(IndexError):
                    sim.robots[0].range_matrix(1)

    def test_how_likely_a_reading_is(self):
        with eyebridge.Simulation() as sim:
            robot = sim.robots[0]
            robot.set_errors("psd sigma=20 dropout=10; lidar sigma=10; compass 5; accelerometer 0.1; gyroscope 1 drift=2")
            readings = np.arange(-0.1, 11, 0.001)
            for distances in (0.5, 1.7, math.inf):
                likely = robot.psd_probability(1, readings, distances)
                self.assertEqual(likely.shape, readings.shape)
                self.assertAlmostEqual(likely.sum(), 1)
            np.testing.assert_allclose(robot.psd_probability(1, 9.999, [0.5, 1.7, math.inf]), (0.1, 0.1, 1))
            self.assertEqual(robot.psd_probability(1, [[0.5], [0.6]], [0.5, 0.6, 0.7]).shape, (2, 3))
            half = robot.psd_probability(1, 0.5, 0.5, resolution=0.04)
            self.assertAlmostEqual(half, 0.9 * 0.682689, places=5)  # one sigma to either side
            self.assertIsInstance(half, float)
            self.assertAlmostEqual(robot.lidar_probability(1.0, 1.0, resolution=0.02), 0.682689, places=5)
            seam = robot.compass_probability([-math.pi, math.pi], math.pi)
            self.assertAlmostEqual(seam[0], seam[1])
            self.assertAlmostEqual(robot.compass_probability(0.3, 1.0, resolution=2 * math.pi), 1)
            sigma = math.radians(math.hypot(1, 2 * 3))  # strayed for 9 s
            self.assertAlmostEqual(
                robot.gyroscope_probability(0.1, 0.1, resolution=2 * sigma, elapsed=9), 0.682689, places=5
            )
            self.assertAlmostEqual(robot.accelerometer_probability(0.5, 0.5, resolution=0.2), 0.682689, places=5)
            robot.set_errors("encoder miss=25")
            counted = robot.encoder_probability(np.arange(-1, 4), 2 * math.tau / 1100)  # two ticks
            np.testing.assert_allclose(counted, (0, 1 / 16, 6 / 16, 9 / 16, 0), atol=1e-12)
            with self.assertRaises(ValueError):
                robot.encoder_probability(1, 1e300)
            self.assertEqual(robot.encoder_probability(math.nan, 1.0), 0.0)
            for wrong in (0, -1, math.nan):
                with self.assertRaises(ValueError):
                    robot.psd_probability(1, 0.5, 0.5, resolution=wrong)
            with self.assertRaises(ValueError):
                robot.psd_probability(1, 0.5, 0.5, cross_talkers=-1)
            with self.assertRaises(IndexError):
                robot.psd_probability(77, 0.5, 0.5)

    def test_sonars_and_infrared_are_read_as_distance_sensors(self):
        with eyebridge.Simulation(eyebridge.load_scenario(WORLDS / "robots" / "Explorer.robi")) as sim:
            robot = sim.robots[0]
            robot.set_pose(1.0, 1.0, math.radians(10))
            self.assertEqual(len(robot.lidar()), 181)
            ahead = robot.psd(1)
            self.assertLess(ahead, robot.lidar(points=1)[0] - 0.14, "the nearest in the cone, not straight ahead")
            self.assertEqual(robot.psd_probability(1, ahead, ahead), 1.0)

    def test_sensors_read_what_geometry_says(self):
        sim = eyebridge.Simulation()
        robot = sim.robots[0]
        self.assertEqual(robot.psd_ids, [1, 2, 3, 4, 5, 6, 7, 8])
        self.assertEqual(list(robot.psds()), [robot.psd(id) for id in robot.psd_ids])
        with self.assertRaises(IndexError):
            robot.psd(42)
        scan = robot.lidar(360)
        self.assertEqual(scan.shape, (360,))
        rays = sim.cast_rays(1, 1, [0, math.pi / 2, math.pi], ignore=0)
        np.testing.assert_allclose(rays, [0.995, 0.995, 0.995], atol=1e-9)
        self.assertLess(sim.cast_rays(0.5, 1, [0.0])[0], 0.5)
        self.assertEqual(robot.lidar(8, field_of_view=math.pi).shape, (8,))
        for bad in ({"points": 0}, {"field_of_view": 0.0}, {"tilt": 2.0}, {"points": 36001}):
            with self.assertRaisesRegex(ValueError, "found .* for .*, expected "):
                robot.lidar(**bad)

    def test_all_distance_sensors_are_read_at_once(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "fleet.sim")
            explorer = WORLDS / "robots" / "Explorer.robi"
            robots = "S4 2000 400 90\nExplorer 700 1000 0\nLabBot 1000 400 0\n"
            path.write_text(f"world {WORLDS / 'rooms.wld'}\nrobot {explorer}\n{robots}")
            together, apart = (eyebridge.Simulation(eyebridge.load_scenario(path)) for _ in range(2))
        for robot in together.robots + apart.robots:
            robot.set_errors("psd sigma=20")
        for _ in range(3):
            table = together.psds()
            self.assertEqual(table.shape, (3, 9))
            for robot, row in zip(apart.robots, table):
                alone = [robot.psd(id) for id in robot.psd_ids]
                self.assertEqual(list(row[: len(alone)]), alone)
                self.assertTrue(np.isnan(row[len(alone):]).all())
            for sim in (together, apart):
                sim.set_speeds([(0.2, 0.1)] * 3)
                sim.step(5)


if __name__ == "__main__":
    main()
