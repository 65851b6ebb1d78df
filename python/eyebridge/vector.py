"""Many worlds side by side, as Gymnasium's vectorised environments are used."""

from types import SimpleNamespace

import numpy

from ._core import EpisodeBatch, default_scenario
from .spaces import AutoresetMode, Box, VectorBase

AUTORESET = {"next_step": AutoresetMode.NEXT_STEP, "same_step": AutoresetMode.SAME_STEP, "disabled": AutoresetMode.DISABLED}


class VectorEnv(VectorBase):
    """`num_envs` worlds with one robot each that acts; stepped in C++ on all cores, without Python's lock.

    Signature, units and failures: __init__.pyi; how to train: docs/training.md.
    """

    render_mode = None
    spec = None
    closed = False

    def __init__(
        self, scenario=None, num_envs=1, *, observation="psd speed", action="speed", reward=None, terminated=None,
        start="scenario", period=0.1, time_limit=60.0, step=0.01, autoreset="next_step", threads=0,
    ):  # fmt: skip
        if autoreset not in AUTORESET:
            raise ValueError(f"found {autoreset!r} for 'autoreset', expected next_step, same_step or disabled")
        if num_envs < 1:
            raise ValueError(f"found {num_envs} for 'num_envs', expected 1 or more")
        if scenario is None:
            scenario = default_scenario()
        scenarios = list(scenario) if isinstance(scenario, (list, tuple)) else [scenario]
        self._batch = EpisodeBatch(scenarios, num_envs, observation, action, start, period, time_limit, step, threads)
        self._batch.end_at_collisions(terminated is None)
        self._rows = SimpleNamespace(**self._batch.rows())
        self._reward = reward
        self._terminated = terminated
        self._over = numpy.zeros(num_envs, bool)
        self.num_envs = num_envs
        self.autoreset_mode = AUTORESET[autoreset]
        self.metadata = {"autoreset_mode": self.autoreset_mode, "render_modes": []}
        high = numpy.array(self._batch.action_high)
        # Readings with errors may lie a little outside what the sensors' files say.
        low, top = self._batch.observation_low, self._batch.observation_high
        self.single_observation_space = Box(low, top, dtype=numpy.float64)
        self.single_action_space = Box(-high, high, dtype=numpy.float64)
        rows = (num_envs, 1)
        self.observation_space = Box(numpy.tile(low, rows), numpy.tile(top, rows), dtype=numpy.float64)
        self.action_space = Box(numpy.tile(-high, rows), numpy.tile(high, rows), dtype=numpy.float64)

    def reset(self, *, seed=None, options=None):
        """Begins anew everywhere, world i with `seed` + i; without a seed each world goes on to its next episode. Of
        options, "reset_mask" (N booleans) names the worlds that begin anew."""
        mask = (options or {}).get("reset_mask")
        if mask is not None and seed is not None:
            raise ValueError("found a seed and a reset_mask, expected one of them")
        if seed is not None:
            self._batch.reset_all(seed)
            mask = numpy.ones(self.num_envs, bool)
        else:
            mask = numpy.ones(self.num_envs, bool) if mask is None else numpy.asarray(mask, bool)
            self._batch.reset(mask)
        self._over &= ~mask
        return self._rows.observations.copy(), self._info()

    def step(self, actions):
        """Advances by one period: observations, rewards, terminated, truncated, info; one row a world."""
        actions = numpy.asarray(actions, numpy.float64)
        if actions.shape != (self.num_envs, 2):
            raise ValueError(f"found actions of shape {actions.shape}, expected ({self.num_envs}, 2)")
        begun = self._over if self.autoreset_mode is AutoresetMode.NEXT_STEP else numpy.zeros(self.num_envs, bool)
        self._batch.step(actions, begun)
        rewards, terminated, truncated = self._judge(actions, begun)
        self._over = terminated | truncated
        info = self._info()
        if self.autoreset_mode is AutoresetMode.SAME_STEP and self._over.any():
            info |= {"final_obs": self._rows.observations.copy(), "_final_obs": self._over.copy()}
            info |= {"final_info": self._info(), "_final_info": self._over.copy()}
            self._batch.reset(self._over)
            info |= self._info()
        return self._rows.observations.copy(), rewards, terminated, truncated, info

    def _judge(self, actions, begun):
        """What the callbacks, or C++, think of the step; nothing of worlds that have just begun."""
        rows = self._rows
        rewards = rows.rewards.copy()
        terminated = rows.terminated.astype(bool)
        truncated = rows.truncated.astype(bool)
        if self._reward or self._terminated:
            step = SimpleNamespace(actions=actions, **{name: view.copy() for name, view in vars(rows).items()})
            if self._terminated:
                terminated = self._row("terminated", self._terminated(step), bool) & ~begun
                truncated &= ~terminated
                step.terminated = terminated.astype(numpy.uint8)
            if self._reward:
                rewards = numpy.where(begun, 0.0, self._row("reward", self._reward(step), numpy.float64))
        return rewards, terminated, truncated

    def _row(self, name, values, dtype):
        values = numpy.asarray(values, dtype)
        if values.shape != (self.num_envs,):
            raise ValueError(f"found shape {values.shape} from {name}(), expected ({self.num_envs},)")
        return values

    def _info(self):
        rows = self._rows
        return {
            "pose": rows.poses.copy(),
            "distance": rows.distances.copy(),
            "collisions": rows.collisions.copy(),
            "time": rows.times.copy(),
            "seed": rows.seeds.copy(),
        }

    def close(self, **_):
        """Frees the worlds."""
        self._batch = self._rows = None
        self.closed = True
