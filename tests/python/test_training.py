"""Episodes and vectorised environments of the module eyebridge."""

import subprocess
import sys
import textwrap
import threading
import unittest

import eyebridge
import numpy as np
from eyebridge.spaces import AutoresetMode
from support import SOURCE, ProgramTest, main

WORLDS = SOURCE / "worlds"


class Episodes(unittest.TestCase):
    def test_steps_until_a_condition_holds(self):
        with eyebridge.Episode() as episode:
            robot = episode.robots[0]
            robot.set_speed(0.3)
            self.assertFalse(episode.step_until(lambda e: robot.pose[0] > 1.2, 0.3))
            self.assertAlmostEqual(episode.time, 0.3)
            self.assertTrue(episode.step_until(lambda e: e.robots[0].pose[0] > 1.2, 10))
            self.assertLess(robot.pose[0], 1.2 + 0.3 * 0.01 + 1e-9)
            for bad in (-1, float("nan"), 1e10):
                with self.assertRaisesRegex(ValueError, "expected 0 ... 1e9"):
                    episode.step_until(lambda e: True, bad)

    def test_adds_up_the_reward_of_every_step(self):
        episode = eyebridge.Episode(reward=lambda e: 10 if e.time > 0.255 else 1)
        episode.run(0.3)
        self.assertEqual(episode.total_reward, 25 + 5 * 10)
        episode.reset(seed=2)
        self.assertEqual((episode.total_reward, episode.seed), (0, 2))
        episode.step(3)
        self.assertEqual(episode.total_reward, 3)
        with self.assertRaises(ValueError):
            episode.step(-1)
        episode.reward = None
        episode.step(5)
        self.assertEqual(episode.total_reward, 3)

    def test_counts_ways_and_collisions(self):
        episode = eyebridge.Episode()
        robot = episode.robots[0]
        robot.set_speed(0.5)
        self.assertTrue(episode.step_until(lambda e: robot.collisions, 10))
        self.assertAlmostEqual(robot.distance, 0.995 - robot.radius, places=5)
        episode.reset()
        self.assertEqual((robot.distance, robot.collisions), (0, 0))


class Environments(unittest.TestCase):
    def test_says_what_its_numbers_are(self):
        env = eyebridge.VectorEnv(num_envs=3, observation="psd compass lidar:8")
        self.assertEqual(env.single_observation_space.shape, (17,))
        self.assertEqual(env.observation_space.shape, (3, 17))
        self.assertEqual((env.single_action_space.shape, env.action_space.shape), ((2,), (3, 2)))
        np.testing.assert_allclose(env.single_action_space.high, (0.6, 5.236), atol=1e-3)
        np.testing.assert_array_equal(env.action_space.low, -env.action_space.high)
        self.assertEqual(env.metadata["autoreset_mode"], AutoresetMode.NEXT_STEP)
        observations, info = env.reset(seed=5)
        self.assertTrue(env.observation_space.contains(observations))
        self.assertEqual(list(info["seed"]), [5, 6, 7])
        self.assertFalse(env.observation_space.contains(observations[0]))
        self.assertFalse(env.observation_space.contains(observations - 20))

    def test_samples_are_actions(self):
        env = eyebridge.VectorEnv(num_envs=4)
        env.action_space.seed(3)
        first = env.action_space.sample()
        self.assertTrue(env.action_space.contains(first))
        env.action_space.seed(3)
        np.testing.assert_array_equal(env.action_space.sample(), first)
        self.assertTrue(env.observation_space.contains(env.observation_space.sample()), "open ends")

    def test_each_world_does_as_it_is_told(self):
        env = eyebridge.VectorEnv(num_envs=2, observation="pose")
        env.reset(seed=1)
        for _ in range(5):
            observations, rewards, terminated, truncated, info = env.step([[0, 0], [0.3, 0]])
        np.testing.assert_array_equal(observations, info["pose"])
        self.assertEqual(observations[0, 0], 1)
        self.assertGreater(observations[1, 0], 1.05)
        self.assertEqual((rewards.shape, rewards.dtype), ((2,), np.float64))
        self.assertEqual((terminated.dtype, truncated.dtype), (bool, bool))
        self.assertAlmostEqual(rewards[1], 0.03)
        kept = observations.copy()
        env.step([[0.3, 0], [0.3, 0]])
        np.testing.assert_array_equal(observations, kept, "what was given stays as it is")

    def drive_into_the_wall(self, env):
        env.reset(seed=1)
        actions = np.array([[0.6, 0.0], [0.0, 1.0]])
        for _ in range(100):
            out = env.step(actions)
            if out[2][0]:
                return actions, out
        self.fail("never came to a wall")

    def test_begins_again_with_the_next_step(self):
        env = eyebridge.VectorEnv(num_envs=2, observation="pose")
        actions, (observations, _, terminated, truncated, info) = self.drive_into_the_wall(env)
        self.assertEqual((list(terminated), list(truncated)), ([True, False], [False, False]))
        self.assertEqual(list(info["collisions"]), [1, 0])
        self.assertGreater(observations[0, 0], 1.8, "the last observation of the episode")
        observations, rewards, terminated, _, info = env.step(actions)
        self.assertEqual((observations[0, 0], rewards[0], terminated[0], info["time"][0]), (1, 0, False, 0))
        self.assertNotEqual(info["seed"][0], 1)
        self.assertEqual(info["seed"][1], 2)
        self.assertGreater(env.step(actions)[1][0], 0)

    def test_begins_again_in_the_same_step(self):
        env = eyebridge.VectorEnv(num_envs=2, observation="pose", autoreset="same_step")
        _, (observations, rewards, _, _, info) = self.drive_into_the_wall(env)
        self.assertEqual((observations[0, 0], info["time"][0]), (1, 0))
        self.assertGreater(info["final_obs"][0, 0], 1.8)
        self.assertGreater(info["final_info"]["time"][0], 0)
        self.assertEqual(list(info["_final_obs"]), [True, False])

    def test_begins_again_when_it_is_told(self):
        env = eyebridge.VectorEnv(num_envs=2, observation="pose", autoreset="disabled")
        actions, _ = self.drive_into_the_wall(env)
        self.assertGreater(env.step(actions)[0][0, 0], 1.8)
        observations, info = env.reset(options={"reset_mask": [True, False]})
        self.assertEqual((observations[0, 0], info["time"][0]), (1, 0))
        self.assertGreater(info["time"][1], 0)
        with self.assertRaisesRegex(ValueError, "one of them"):
            env.reset(seed=1, options={"reset_mask": [True, False]})

    def test_the_time_limit_truncates(self):
        env = eyebridge.VectorEnv(num_envs=1, time_limit=0.2)
        env.reset(seed=1)
        self.assertFalse(env.step([[0, 0]])[3][0])
        _, _, terminated, truncated, _ = env.step([[0, 0]])
        self.assertEqual((terminated[0], truncated[0]), (False, True))

    def test_callbacks_give_rewards_and_ends(self):
        def reward(step):
            return step.poses[:, 2] + step.actions[:, 1]

        env = eyebridge.VectorEnv(num_envs=2, reward=reward, terminated=lambda step: step.poses[:, 0] > 1.1)
        env.reset(seed=1)
        actions = [[0.6, 0], [0, 0.5]]
        while True:
            _, rewards, terminated, _, info = env.step(actions)
            if terminated.any():
                break
        self.assertEqual(list(terminated), [True, False])
        np.testing.assert_allclose(rewards, info["pose"][:, 2] + [0, 0.5])
        self.assertEqual(env.step(actions)[1][0], 0, "no reward for the step that begins")
        for name in ("reward", "terminated"):
            bad = eyebridge.VectorEnv(num_envs=2, **{name: lambda step: [1, 2, 3]})
            with self.assertRaisesRegex(ValueError, rf"found shape \(3,\) from {name}\(\), expected \(2,\)"):
                bad.step(actions)

    def test_same_seeds_and_actions_give_the_same_bits_on_any_number_of_threads(self):
        scenario = eyebridge.load_scenario(WORLDS / "noisy-room.sim")

        def run(threads):
            env = eyebridge.VectorEnv(scenario, 6, threads=threads, start="anywhere", observation="psd lidar:12 speed")
            rows = [env.reset(seed=7)[0]]
            actions = np.linspace((0.1, -1), (0.5, 1), 6)
            for _ in range(80):
                rows.append(env.step(actions)[0])
            return np.array(rows)

        one = run(1)
        np.testing.assert_array_equal(run(3), one)
        self.assertFalse((one[0, 0] == one[0, 1]).all(), "another place, another view")

    def test_worlds_take_turns_in_having_the_scenarios(self):
        room = eyebridge.default_scenario()
        corridor = eyebridge.load_scenario(WORLDS / "corridor.wld")
        env = eyebridge.VectorEnv([room, corridor], num_envs=3, observation="pose")
        observations, _ = env.reset(seed=1)
        np.testing.assert_array_equal(observations[0], observations[2])
        np.testing.assert_allclose(observations[1], (0.3, 0.3, 0))

    def test_other_threads_run_while_it_steps(self):
        env = eyebridge.VectorEnv(num_envs=200, time_limit=1e9)
        env.reset(seed=1)
        ran, over = [], threading.Event()

        def count():
            while not over.is_set():
                ran.append(1)
                over.wait(0.001)

        other = threading.Thread(target=count)
        other.start()
        while len(ran) < 3:
            env.step(np.zeros((200, 2)))
        over.set()
        other.join()

    def test_refuses_what_cannot_be(self):
        cases = {
            "found 'never' for 'autoreset'": {"autoreset": "never"},
            "expected 1 or more": {"num_envs": 0},
            "found legs for 'action'": {"action": "legs"},
            "found nowhere for 'start'": {"start": "nowhere"},
            "found 'smell' for an observation": {"observation": "smell"},
            "period": {"period": 0},
        }
        for message, settings in cases.items():
            with self.assertRaisesRegex(ValueError, message):
                eyebridge.VectorEnv(**settings)
        env = eyebridge.VectorEnv(num_envs=2)
        with self.assertRaisesRegex(ValueError, r"found actions of shape \(2,\), expected \(2, 2\)"):
            env.step([0, 0])
        with self.assertRaisesRegex(ValueError, "not finite"):
            env.step([[0, 0], [0, float("nan")]])
        env.close()
        self.assertTrue(env.closed)


class WithGymnasium(ProgramTest):
    def test_it_is_an_environment_of_gymnasium_where_that_is_installed(self):
        """Gymnasium itself is no package of Debian 12: what we use of it, by the same names."""
        self.write("gymnasium/__init__.py", "")
        self.write("gymnasium/spaces.py", """
            class Box:
                def __init__(self, low, high, dtype):
                    self.low, self.high, self.shape, self.dtype = low, high, low.shape, dtype
            """)  # fmt: skip
        self.write("gymnasium/vector.py", """
            import enum
            AutoresetMode = enum.Enum("AutoresetMode", "NEXT_STEP SAME_STEP DISABLED")
            class VectorEnv:
                pass
            """)  # fmt: skip
        program = """
            import eyebridge, gymnasium.spaces, gymnasium.vector
            env = eyebridge.VectorEnv(num_envs=2)
            assert isinstance(env, gymnasium.vector.VectorEnv)
            assert isinstance(env.single_action_space, gymnasium.spaces.Box)
            assert env.metadata["autoreset_mode"] is gymnasium.vector.AutoresetMode.NEXT_STEP
            print(env.reset(seed=1)[0].shape)
            """
        run = subprocess.run([sys.executable, "-c", textwrap.dedent(program)], cwd=self.folder, capture_output=True,
                             text=True, env=self.environment({}), check=False)  # fmt: skip
        self.assertEqual((run.returncode, run.stdout), (0, "(2, 10)\n"), run.stderr)

    def write(self, name, text):
        (self.folder / name).parent.mkdir(exist_ok=True)
        return super().write(name, text)


if __name__ == "__main__":
    main()
