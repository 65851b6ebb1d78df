#!/usr/bin/env python3
"""worlds.py COUNT: how many thousand steps of 0.1 s a CPU second the worlds of a VectorEnv make, on one core. For programs.py."""
import pathlib
import resource
import sys

import numpy as np

import eyebridge

CORRIDOR = pathlib.Path(__file__).parents[2] / "worlds/corridor.wld"
STEPS = 200000  # of all worlds together, at least three of each


def processor():
    """CPU seconds of this process."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def main(worlds):
    env = eyebridge.VectorEnv(eyebridge.load_scenario(str(CORRIDOR)), num_envs=worlds, observation="psd", action="speed",
                              start="anywhere", threads=1)
    env.reset(seed=1)
    actions = np.column_stack([np.full(worlds, 0.2), np.random.default_rng(1).uniform(-1, 1, worlds)]).astype(np.float32)
    env.step(actions)
    rounds = max(3, STEPS // worlds)
    start = processor()
    for _ in range(rounds):
        env.step(actions)
    print(f"k_steps_s={rounds * worlds / (processor() - start) / 1e3:.1f}")


if __name__ == "__main__":
    main(int(sys.argv[1]))
