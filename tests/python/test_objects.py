"""Objects that come, change and go while a run goes on: in `import eyebridge` and in control files."""

import math
import unittest

import eyebridge
import numpy as np
from support import main
from test_control import ControlTest


class InASimulation(unittest.TestCase):
    def test_objects_come_change_and_go_while_it_runs(self):
        sim = eyebridge.Simulation()
        robot = sim.robots[0]
        x, y, theta = robot.pose
        ahead = lambda d: (x + d * math.cos(theta), y + d * math.sin(theta))  # noqa: E731
        free = robot.psd(1)
        can = sim.add_object("can", *ahead(0.4))
        box = sim.add_object("box", 0.3, 0.3, 0.5, size=(0.2, 0.1), friction=0.4, fixed=True)
        self.assertEqual((can, box), (0, 1))
        self.assertLess(robot.psd(1), free - 0.2)
        np.testing.assert_allclose(sim.objects, [(*ahead(0.4), 0), (0.3, 0.3, 0.5)])
        sim.set_object_pose(can, 0.3, 1.7)
        self.assertEqual(robot.psd(1), free)
        with self.assertRaisesRegex(ValueError, "a ball, or one with a friction, that is not fixed"):
            sim.set_object_velocity(box, 0.1, 0.0)
        sim.set_object_fixed(box, False)
        sim.set_object_velocity(box, 0.2, 0.0)
        sim.step()
        self.assertGreater(sim.objects[box][0], 0.3)
        sim.remove_object(can)
        with self.assertRaisesRegex(IndexError, "object 0 has been removed"):
            sim.set_object_pose(can, 1.0, 1.0)
        with self.assertRaisesRegex(IndexError, "no object 2, the world has 2"):
            sim.remove_object(2)
        wedge = sim.add_object("polygon", *ahead(0.5), theta, corners=[(0.1, 0), (-0.2, 0.1), (-0.2, -0.1)])
        self.assertLess(robot.psd(1), free - 0.2)
        sim.change_object(wedge, "path 100 back 1000 300\nmass 2")
        there, began = sim.objects[wedge], sim.time
        sim.step()
        self.assertAlmostEqual(math.dist(there[:2], sim.objects[wedge][:2]), 0.1 * (sim.time - began), places=6)
        sim.change_object(wedge, "still")
        there = sim.objects[wedge]
        sim.step()
        np.testing.assert_array_equal(sim.objects[wedge], there)
        with self.assertRaisesRegex(eyebridge.ConfigError, "corner 3 of the polygon: expected three corners or more"):
            sim.add_object("polygon", 1, 1, corners=[(0.1, 0), (-0.2, 0.1)])
        with self.assertRaisesRegex(ValueError, "corners"):
            sim.add_object("can", 1, 1, corners=[(0.1, 0), (-0.2, 0.1), (-0.2, -0.1)])
        with self.assertRaisesRegex(ValueError, "path leads into a wall"):
            sim.change_object(wedge, "path 100 back 9000 300")
        with self.assertRaisesRegex(eyebridge.ConfigError, "change_object:2:1: 'can' found"):
            sim.change_object(wedge, "fixed\ncan 1 2 3")
        before = sim.state_hash
        for wrong in [("chair", 1, 0.3), ("box", 1, 0.3), ("can", 0.0, 0.3), ("can", math.nan, 1)]:
            with self.assertRaises(ValueError):
                sim.add_object(*wrong)
        with self.assertRaisesRegex(eyebridge.ConfigError, "add_object:2:"):
            sim.add_object("can", 1, 0.3, lines="path 200")
        self.assertEqual(sim.state_hash, before)
        sim.reset()
        self.assertEqual(sim.objects.shape, (0, 3))


class InAControlFile(ControlTest):
    def test_they_are_put_there_seen_moved_and_taken_away(self):
        self.says(["True", "<object 1> 1.50 0.30 0.00", "True", "[<object 1>]", "False []"], """
            x, y, theta = robot(1).true_pose
            free = robot(1).read("psd 1")
            can = map_space.add_object("can", x + 0.4 * math.cos(theta), y + 0.4 * math.sin(theta))
            interact.print(robot(1).read("psd 1") < free - 0.2)
            can.move(1.5, 0.3)
            interact.print(can, "{:.2f} {:.2f} {:.2f}".format(*can.pose))
            interact.print(robot(1).read("psd 1") == free)
            interact.print(map_space.objects)
            can.remove()
            interact.print(can.is_there, map_space.objects)
        """, before="import math\n")  # fmt: skip

    def test_a_ball_is_kicked_and_a_path_is_gone(self):
        self.says(["True", "True"], """
            ball = map_space.add_object("soccer", 0.5, 0.3)
            post = map_space.add_object("can", 0.5, 1.7, lines="path 100 back 1500 1700")
            ball.set_velocity(0.5, 0.0)
            interact.wait(1)
            interact.print(0.7 < ball.pose[0] < 0.95)
            interact.print(abs(post.pose[0] - 0.6) < 0.01)
        """)

    def test_a_thing_takes_another_way_and_stands_again(self):
        self.says(["True", "True"], """
            wedge = map_space.add_object("polygon", 0.5, 0.3, corners=[(0.1, 0), (-0.1, 0.1), (-0.1, -0.1)])
            wedge.change("path 100 back 1500 300")
            interact.wait(1)
            x = wedge.pose[0]
            interact.print(abs(x - 0.6) < 0.01)
            wedge.change("still")
            interact.wait(1)
            interact.print(abs(wedge.pose[0] - x) < 0.01)
        """)

    def test_mistakes_are_told(self):
        self.fails("control.py:2: run: ValueError: can at (0.000, 1.000) m would stand in a wall",
                   'map_space.add_object("can", 0.0, 1.0)')  # fmt: skip
        self.fails("control.py:3: run: ValueError: object 1 does not roll or slide: expected a ball, or one with a "
                   "friction, that is not fixed", """
            can = map_space.add_object("can", 0.5, 0.3)
            can.set_velocity(0.1, 0.0)
        """)  # fmt: skip
        self.fails("control.py:4: run: IndexError: object 1 has been removed", """
            can = map_space.add_object("can", 0.5, 0.3)
            can.remove()
            can.move(1.0, 1.0)
        """)  # fmt: skip

    def test_the_same_calls_give_the_same_run(self):
        body = """
            ball = map_space.add_object("golf", 0.5, 0.3)
            ball.set_velocity(0.3, 0.2)
            robot(1).start().set_twist(0.2, 0.5)
            interact.wait(3)
            interact.print(repr(ball.pose), repr(robot(1).true_pose))
        """
        self.assertEqual(self.control(body).out, self.control(body).out)


if __name__ == "__main__":
    main()
