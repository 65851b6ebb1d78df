"""Robots of all kinds of drives, wheel by wheel: what docs/drives.md says, in Python."""

import math
import unittest

import eyebridge
import numpy as np
from support import SOURCE, main


def one(name):
    """A simulation of one robot of a file in worlds/robots in an empty room, and the robot."""
    sim = eyebridge.Simulation(eyebridge.load_scenario(SOURCE / "worlds" / "robots" / f"{name}.robi"))
    return sim, sim.robots[0]


class Chassis(unittest.TestCase):
    def test_what_wheels_there_are(self):
        expected = {"S4": ("differential", 2, 2), "Car": ("ackermann", 1, 2), "Omni": ("omni", 4, 4),
                    "Trio": ("swedish", 3, 3), "Synchro": ("synchro", 2, 2), "USAL": ("submarine", 4, 0)}  # fmt: skip
        for name, kind in expected.items():
            robot = one(name)[1]
            self.assertEqual((robot.drive_kind, robot.motor_count, robot.encoder_count), kind)

    def test_those_with_wheels_for_it_go_sideways(self):
        for name, sideways in (("Omni", 0.05), ("Trio", 0.05), ("S4", 0.0)):
            sim, robot = one(name)
            x, y, theta = robot.pose
            robot.set_twist(0.1, lateral=0.05)
            sim.run(1)
            np.testing.assert_allclose(robot.body_twist, (0.1, sideways, 0), atol=1e-6, err_msg=name)
            now = robot.pose
            left = -(now[0] - x) * math.sin(theta) + (now[1] - y) * math.cos(theta)
            np.testing.assert_allclose(left, sideways, atol=0.005, err_msg=name)

    def test_a_synchro_drive_steers_and_its_body_does_not_turn(self):
        sim, robot = one("Synchro")
        theta = robot.pose[2]
        robot.set_twist(0.0, lateral=0.1)
        sim.run(3)
        self.assertAlmostEqual(robot.steering, math.pi / 2, places=2)
        self.assertAlmostEqual(robot.pose[2], theta)

    def test_a_submarine_dives_and_rises(self):
        sim, robot = one("USAL")
        self.assertEqual(robot.depth, 0)
        for thruster in (2, 4):
            robot.set_motor(thruster, -1.0)
        sim.run(3)
        # 135 mm/s in the end, and a drag of 0.8 s.
        self.assertAlmostEqual(robot.depth, 0.135 * (3 - 0.8 * (1 - math.exp(-3 / 0.8))), places=6)
        self.assertEqual(robot.twist, (0, 0), "not in the plane")
        for thruster in (2, 4):
            robot.set_motor(thruster, 1.0)
        sim.run(10)
        self.assertEqual(robot.depth, 0)
        self.assertIsNone(one("S4")[1].depth)
        for call in (lambda: robot.encoder(1), lambda: robot.set_wheel(1, 1.0)):
            with self.assertRaises(IndexError):
                call()

    def test_a_wheel_turns_as_fast_as_it_is_told_and_its_encoder_counts_it(self):
        sim, robot = one("S4")
        robot.set_wheel(1, 2.0)
        robot.set_wheel(2, -2.0)
        sim.run(2)
        for number, turned in ((1, 4.0), (2, -4.0)):
            self.assertAlmostEqual(robot.encoder(number), turned / math.tau * robot.ticks_per_revolution, delta=2)
        robot.reset_encoder(1)
        self.assertEqual(robot.encoder(1), 0)
        self.assertLess(robot.encoder(2), 0)
        robot.set_motor(1, 1.0)
        robot.set_motor(2, 0.0)
        sim.run(0.5)
        self.assertGreater(robot.encoder(1), 0)

    def test_a_car_steers_its_front_wheels(self):
        sim, robot = one("Car")
        robot.set_steering(0.2)
        robot.set_wheel(1, 2.0)
        sim.run(1)
        self.assertAlmostEqual(robot.steering, 0.2)
        self.assertGreater(robot.twist[1], 0)
        robot.set_steering(9.0)
        sim.run(1)
        self.assertLess(robot.steering, math.radians(80.1), "clamped to what it can")

    def test_what_is_not_there_is_one_clear_error(self):
        _, robot = one("S4")
        for call in (lambda: robot.set_wheel(3, 1.0), lambda: robot.set_motor(0, 1.0)):
            with self.assertRaisesRegex(IndexError, "has no motor [03], expected 1 to 2"):
                call()
        with self.assertRaisesRegex(IndexError, "has no encoder 3, expected 1 to 2"):
            robot.encoder(3)
        with self.assertRaisesRegex(ValueError, "no front wheels to steer"):
            robot.set_steering(0.1)
        for call in (robot.set_steering, robot.set_twist, lambda value: robot.set_wheel(1, value)):
            with self.assertRaisesRegex(ValueError, "found nan for '.*', expected a finite number"):
                call(math.nan)


if __name__ == "__main__":
    main()
