"""The module eyebridge: worlds, robots and pictures as numpy arrays."""

import math
import pathlib
import subprocess
import sys
import tempfile
import threading
import unittest

import eyebridge
import numpy as np
from support import PATIENCE, SOURCE, main

WORLDS = SOURCE / "worlds"


class Scenarios(unittest.TestCase):
    def test_a_maze_with_a_robot_of_a_name(self):
        scenario = eyebridge.load_scenario(WORLDS / "maze-8.maz", robot="Mouse")
        self.assertEqual(scenario.robots, ["Mouse"])
        self.assertEqual(scenario.walls.shape[1], 4)
        self.assertGreater(len(scenario.walls), 50)
        self.assertTrue(0 <= scenario.walls.min() and scenario.walls[:, ::2].max() <= scenario.size[0] + 1e-9)

    def test_a_world_is_found_by_its_name(self):
        self.assertEqual(eyebridge.load_scenario("rooms.wld").size, (4, 4))
        self.assertEqual(len(eyebridge.load_scenario("rooms.wld").goals), 0)
        cases = SOURCE.parent / "shared" / "cases"
        contest = eyebridge.load_scenario(cases / "mazes" / "posts.txt", robot="Mouse", cell=0.2)
        self.assertEqual(contest.size, (0.8, 0.8))
        np.testing.assert_allclose(contest.goals, [[0.5, 0.5]])
        with self.assertRaisesRegex(eyebridge.ConfigError, "no maze: only a maze has cells"):
            eyebridge.load_scenario("rooms.wld", cell=0.2)
        with self.assertRaisesRegex(ValueError, "cell"):
            eyebridge.load_scenario(cases / "mazes" / "posts.txt", cell=0.0)
        for name in sorted((cases / "maps").glob("*.yaml")):
            self.assertIn(24, eyebridge.OccupancyGrid.load(name).shape)
            self.assertGreater(len(eyebridge.load_scenario(name).walls), 3)
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program.py"
            program.write_text("import eyebridge\nprint(eyebridge.load_scenario('rooms.wld').size)\n")
            (program.parent / "worlds").mkdir()
            own = program.parent / "worlds" / "rooms.wld"
            own.write_text((WORLDS / "empty-room.wld").read_text())
            run = subprocess.run([sys.executable, program], capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(run.stdout, "(2.0, 2.0)\n", run.stderr)

    def test_a_mistake_names_its_place(self):
        with self.assertRaisesRegex(eyebridge.ConfigError, "gone.maz"):
            eyebridge.load_scenario("gone.maz")
        with self.assertRaisesRegex(eyebridge.ConfigError, "expected 'rooms.wld' .only the case differs"):
            eyebridge.load_scenario("Rooms.wld")
        with self.assertRaisesRegex(ValueError, "R2D2"):
            eyebridge.load_scenario(WORLDS / "maze-8.maz", robot="R2D2")

    def test_the_default_is_an_empty_room(self):
        scenario = eyebridge.default_scenario()
        self.assertEqual((scenario.size, scenario.robots, scenario.warnings), ((2.0, 2.0), ["S4"], []))
        self.assertIn("4 walls, 1 robots", repr(scenario))


class Simulations(unittest.TestCase):
    def test_a_robot_drives_where_it_is_told(self):
        with eyebridge.Simulation() as sim:
            robot = sim.robots[0]
            self.assertEqual((robot.name, robot.index, robot.pose), ("S4", 0, (1.0, 1.0, 0.0)))
            robot.drive(distance=0.5, speed=0.4)
            self.assertTrue(robot.driving)
            sim.run(5)
            self.assertFalse(robot.driving or robot.failed or robot.stalled)
            np.testing.assert_allclose(robot.pose, (1.5, 1, 0), atol=1e-6)
            np.testing.assert_allclose(robot.odometry, (0.5, 0, 0), atol=1e-6)
            robot.drive(angle=math.pi / 2, speed=1)
            sim.run(3)
            np.testing.assert_allclose(robot.compass(), math.pi / 2, atol=1e-6)
            self.assertEqual(round(sim.time, 9), 8.0)
            robot.set_wheels(0.1, 0.1)
            sim.step(10)
            self.assertGreater(robot.encoders[0], 0)
            robot.stop()
            sim.step(2)
            self.assertEqual(robot.twist, (0.0, 0.0))

    def test_errors_are_set_while_it_runs(self):
        with eyebridge.Simulation() as sim:
            robot = sim.robots[0]
            exact = robot.psd(1)
            robot.set_errors("psd bias=100; psd:2 sigma=5", scale=0.5)
            self.assertAlmostEqual(robot.psd(1), exact + 0.05)
            robot.set_errors("perfect")
            self.assertEqual(robot.psd(1), exact)
            for rules, scale in (("awful", 1), ("robot:1 harsh", 1), ("harsh", 1.5), ("harsh", math.nan)):
                with self.assertRaises(ValueError):
                    robot.set_errors(rules, scale)

    def test_poses_are_a_view_that_follows_and_cannot_be_written(self):
        sim = eyebridge.Simulation(seed=3)
        poses, twists = sim.poses, sim.twists
        self.assertEqual((poses.shape, twists.shape), ((1, 3), (1, 2)))
        self.assertTrue(np.shares_memory(poses, sim.poses))
        sim.robots[0].set_speed(0.2, 0.1)
        sim.step(100)
        self.assertEqual(tuple(poses[0]), sim.robots[0].pose)
        self.assertGreater(poses[0, 0], 1.1)
        np.testing.assert_allclose(twists[0], (0.2, 0.1), atol=1e-9)
        sim.robots[0].set_pose(0.5, 0.6, 0.7)
        np.testing.assert_allclose(poses[0], (0.5, 0.6, 0.7))
        with self.assertRaises(ValueError):
            poses[0, 0] = 5
        sim.close()
        np.testing.assert_allclose(poses[0], (0.5, 0.6, 0.7))

    def test_equal_runs_have_equal_hashes(self):
        def run(seed, sim=None):
            sim = sim or eyebridge.Simulation(eyebridge.load_scenario(WORLDS / "maze-8.maz"), seed=seed)
            for i in range(50):
                sim.robots[0].set_speed(0.3, 0.5 * (-1) ** i)
                sim.step(10)
            return sim

        first, again = run(1), run(1)
        self.assertEqual(first.state_hash, again.state_hash)
        again.robots[0].set_speed(-0.1)
        again.step(100)
        self.assertNotEqual(again.state_hash, first.state_hash)
        again.reset()
        self.assertEqual((again.time, again.seed), (0.0, 1))
        self.assertEqual(again.state_hash, eyebridge.Simulation(eyebridge.load_scenario(WORLDS / "maze-8.maz")).state_hash)
        self.assertEqual(run(1, again).state_hash, first.state_hash)
        again.reset(seed=2)
        self.assertEqual(again.seed, 2)

    def test_a_simulation_that_is_closed_says_so(self):
        with eyebridge.Simulation() as sim:
            robot = sim.robots[0]
        for use in (sim.step, lambda: sim.time, lambda: robot.pose, sim.reset, robot.psds):
            with self.assertRaisesRegex(RuntimeError, "closed"):
                use()
        sim.close()

    def test_bad_numbers_are_refused(self):
        sim = eyebridge.Simulation()
        robot = sim.robots[0]
        nan = float("nan")
        for use in (lambda: sim.step(-1), lambda: sim.run(nan), lambda: sim.run(-1), lambda: robot.set_speed(nan),
                    lambda: robot.set_pose(0, 0, math.inf), lambda: robot.drive(nan), lambda: sim.set_speeds([[1, nan]]),
                    lambda: sim.set_speeds([1, 2]), lambda: sim.cast_rays(0, 0, [nan]),
                    lambda: sim.cast_rays(0, 0, [0], max_range=-1), lambda: robot.set_wheels(nan, 0)):  # fmt: skip
            with self.assertRaisesRegex(ValueError, "found .*, expected "):
                use()
        with self.assertRaises(ValueError):
            eyebridge.Simulation(step=0)
        with self.assertRaises(IndexError):
            sim.cast_rays(0, 0, [0], ignore=7)

    def test_each_robot_has_its_row(self):
        sim = eyebridge.Simulation(eyebridge.load_scenario(WORLDS / "two-robots.sim"))
        self.assertEqual([(robot.index, robot.name) for robot in sim.robots], [(0, "S4"), (1, "LabBot")])
        np.testing.assert_allclose(sim.poses, [(2, 0.4, math.pi / 2), (0.7, 1, 0)])
        self.assertEqual(sim.objects.shape, (0, 3))
        sim.set_speeds([(0.2, 0), (0, 0.5)])
        sim.step(100)
        np.testing.assert_allclose(sim.twists, [(0.2, 0), (0, 0.5)], atol=1e-9)
        np.testing.assert_allclose(sim.poses, [(2, 0.6, math.pi / 2), (0.7, 1, 0.5)], atol=0.03)
        for robot in sim.robots:
            self.assertEqual((robot.pose, robot.twist), (tuple(sim.poses[robot.index]), tuple(sim.twists[robot.index])))

    def test_objects_lie_where_the_file_has_them(self):
        sim = eyebridge.Simulation(eyebridge.load_scenario(WORLDS / "colour-targets.sim"))
        np.testing.assert_allclose(sim.objects, [(1.5, 1.3, 0), (1.2, 0.7, 0)])

    def test_threads_share_a_simulation(self):
        sim = eyebridge.Simulation()
        threads = [threading.Thread(target=lambda: [sim.step() for _ in range(500)]) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(round(sim.time, 6), 20.0)

    def test_other_threads_run_while_a_call_waits_for_the_simulation(self):
        for call in ("sim.objects", "sim.psds()", "sim.set_speeds([[0, 0]])", "sim.cast_rays(1, 1, [0.0])", "sim.robots[0].psd(1)",
                     "sim.robots[0].pose", "sim.__exit__(None, None, None)"):  # fmt: skip
            with self.subTest(call):
                words = [sys.executable, "-c", WAITS_FOR_EVER.replace("CALL", call)]
                # A call that keeps Python's lock stops that process for ever.
                self.assertEqual(subprocess.run(words, timeout=PATIENCE).returncode, 0)


# One thread has the simulation for ever, one makes a call that waits for it, and the third ends the process when it
# runs meanwhile. Threads change only where one lets go of Python's lock.
WAITS_FOR_EVER = """
import os, sys, threading, time, eyebridge
sys.setswitchinterval(1e6)
waiting = False

def look():
    while True:
        time.sleep(0.001)
        if waiting:
            os._exit(0)

def have(sim):
    try:
        sim.step(10**15)
    except RuntimeError:
        pass  # closed by the call that came before it

threading.Thread(target=look, daemon=True).start()
while True:
    sim = eyebridge.Simulation()
    threading.Thread(target=have, args=[sim], daemon=True).start()
    waiting = True
    CALL
    waiting = False
"""


class Cameras(unittest.TestCase):
    def test_pictures_of_this_moment_without_a_copy(self):
        sim = eyebridge.Simulation(eyebridge.load_scenario(WORLDS / "colour-targets.sim"))
        robot = sim.robots[0]
        camera = robot.camera(160, 120)
        self.assertEqual(camera.size, (160, 120))
        frame = camera.frame()
        self.assertEqual((frame.shape, frame.dtype), ((120, 160, 3), np.uint8))
        self.assertFalse(frame.flags.owndata or frame.flags.writeable)
        kept = frame.copy()
        np.testing.assert_array_equal(camera.frame(), frame)
        x, y, theta = robot.pose
        robot.set_pose(x, y, theta + 1.5)
        self.assertTrue((camera.frame() != kept).any())
        np.testing.assert_array_equal(frame, kept)
        del camera
        np.testing.assert_array_equal(frame, kept)

    def test_a_picture_outlives_everything(self):
        with eyebridge.Simulation() as sim:
            frame = sim.robots[0].camera(64, 48).frame()
        self.assertGreater(len(np.unique(frame)), 2)

    def test_options_of_the_renderer(self):
        robot = eyebridge.Simulation(eyebridge.load_scenario(WORLDS / "maze-5.maz")).robots[0]
        plain = robot.camera().frame()
        self.assertLess(robot.camera(options="light=0.4").frame().mean(), plain.mean())
        self.assertTrue((robot.camera(options="fiducials=on").frame() != plain).any())

    def test_bad_cameras(self):
        robot = eyebridge.Simulation().robots[0]
        with self.assertRaises(ValueError):
            robot.camera(0, 10)
        with self.assertRaises(eyebridge.ConfigError):
            robot.camera(options="light=dark")

    def test_a_closed_world_has_no_pictures(self):
        sim = eyebridge.Simulation()
        camera = sim.robots[0].camera(64, 48)
        sim.close()
        with self.assertRaises(RuntimeError):
            camera.frame()


class Grids(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_bayes_rule_by_hand(self):
        grid = eyebridge.OccupancyGrid(1.0, 1.0, resolution=0.1)
        for reading in (0.7, 0.7, 0.4):
            grid.update(0.55, 0.25, reading)
        odds = (0.7 / 0.3) ** 2 * 0.4 / 0.6
        self.assertAlmostEqual(grid.probability(0.55, 0.25), odds / (1 + odds), places=6)
        self.assertEqual(grid.state(0.55, 0.25), "occupied")
        self.assertAlmostEqual(grid.log_odds[2, 5], math.log(odds), places=5)
        self.assertEqual(grid.probability(0.05, 0.05), 0.5)

    def test_the_view_follows_and_cannot_be_written(self):
        grid = eyebridge.OccupancyGrid(1.0, 0.5)
        cells = grid.log_odds
        grid.set_probability(0.01, 0.01, 0.9)
        self.assertGreater(cells[0, 0], 2.0)
        self.assertFalse(cells.flags.writeable or cells.flags.owndata)
        self.assertEqual((cells.shape, cells.dtype), (grid.shape, np.float32))
        del grid
        self.assertGreater(cells[0, 0], 2.0)

    def test_a_view_of_a_grid_that_grows_stays_what_it_was(self):
        grid = eyebridge.OccupancyGrid(1.0, 1.0, growing=True)
        cells = grid.log_odds
        grid.update(30.0, 30.0, 0.9)
        self.assertGreater(grid.shape[0], 500)
        self.assertEqual((cells.shape, float(abs(cells).sum())), ((20, 20), 0.0))

    def test_a_scan_makes_a_belief_that_agrees_with_the_truth(self):
        scenario = eyebridge.default_scenario()
        truth = eyebridge.OccupancyGrid.truth_of(scenario)
        belief = eyebridge.OccupancyGrid(2.2, 2.2, origin=truth.origin)
        with eyebridge.Simulation(scenario) as sim:
            robot = sim.robots[0]
            mapper = eyebridge.RobotMapper(robot)
            for _ in range(4):  # what was seen only once is not yet taken for free
                mapper.insert_lidar(belief, robot.pose, robot.lidar())
                mapper.insert_ranges(belief, robot.pose, robot.psds())
        found = belief.agreement(truth)
        self.assertGreater(found["observed"], 1000)
        self.assertGreater(found["share"], 0.97)
        self.assertGreater(belief.coverage(truth, 1.0, 1.0), 0.8)

    def test_maps_are_read_as_they_were_written(self):
        truth = eyebridge.OccupancyGrid.truth_of(eyebridge.load_scenario(WORLDS / "maze-5.maz"))
        for name in ("map.yaml", "map.csv"):
            truth.save(self.folder / name)
            read = eyebridge.OccupancyGrid.load(self.folder / name)
            self.assertEqual((read.shape, read.resolution), (truth.shape, truth.resolution))
            np.testing.assert_array_equal(read.picture, truth.picture)
        truth.save(self.folder / "map.png")
        self.assertEqual((self.folder / "map.png").read_bytes()[:4], b"\x89PNG")

    def test_bad_maps_and_arguments(self):
        (self.folder / "bad.yaml").write_text("image: a.pgm\nresolution: -1\norigin: [0, 0, 0]\n")
        with self.assertRaisesRegex(eyebridge.ConfigError, r"bad\.yaml:2:13: "):
            eyebridge.OccupancyGrid.load(self.folder / "bad.yaml")
        with self.assertRaisesRegex(ValueError, "expected .yaml or .csv"):
            eyebridge.OccupancyGrid.load(self.folder / "map.bmp")
        for arguments in ((0.0, 1.0), (1.0, math.nan), (1e5, 1e5)):
            with self.assertRaises(ValueError):
                eyebridge.OccupancyGrid(*arguments)
        grid = eyebridge.OccupancyGrid(1.0, 1.0)
        with self.assertRaises(IndexError):
            grid.set_probability(3.0, 0.0, 0.5)
        with self.assertRaises(ValueError):
            grid.update(0.5, 0.5, 1.5)


if __name__ == "__main__":
    main()
