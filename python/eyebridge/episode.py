"""A scenario that is run again and again: reset, step until, a reward by callback."""

from ._core import Simulation


class Episode(Simulation):
    """A simulation with a reward: `reward(episode)` is asked after every step, and summed up.

        episode = eyebridge.Episode(scenario, reward=lambda e: e.robots[0].twist[0] * e.step_length)
        for seed in range(100):
            episode.reset(seed)
            while not episode.step_until(lambda e: e.robots[0].collisions, 0.1) and episode.time < 60:
                steer(episode.robots[0])
            print(seed, episode.total_reward)

    For many at a time, and without Python in between, there is VectorEnv.
    """

    def __init__(self, scenario=None, *, seed=1, step=0.01, reward=None):
        super().__init__(scenario, seed=seed, step=step)
        self.reward = reward
        self.total_reward = 0.0

    def reset(self, seed=None):
        super().reset(seed)
        self.total_reward = 0.0

    def step(self, steps=1):
        if self.reward is None:
            super().step(steps)
            return
        if steps < 0:
            raise ValueError(f"found {steps} for 'steps', expected 0 or more")
        for _ in range(steps):
            super().step()
            self.total_reward += self.reward(self)

    def run(self, seconds):
        if not 0 <= seconds < 1e9:
            raise ValueError(f"found {seconds} for 'seconds', expected 0 ... 1e9")
        self.step(round(seconds / self.step_length))

    def step_until(self, done, seconds):
        """Steps until `done(episode)` holds, asked after each step, and says whether it does; or for `seconds`."""
        if not 0 <= seconds < 1e9:
            raise ValueError(f"found {seconds} for 'seconds', expected 0 ... 1e9")
        for _ in range(max(round(seconds / self.step_length), 1)):
            self.step()
            if done(self):
                return True
        return False
