#!/usr/bin/env python3
"""Trains a small neural network by evolution to drive about without bumping into anything.

Nine ranges and its own speed in, ten hidden neurons, speed and turn out: 132 weights. Every network of the population drives
in four worlds of its own, from places that chance picks; it earns the way that it drives straight (as in Floreano and Mondada
1994, "Automatic creation of an autonomous agent": else it would circle for ever) and pays for bumping. The mean of the best
fifth, weighted by rank, is the parent of the next generation (an evolution strategy, (mu/mu, lambda)-ES as in Hansen et al.
2015, "Evolution Strategies", with a step size that shrinks).

Usage: evolve_network.py [GENERATIONS [SEED]]; 30 and 1 by default. PYTHONPATH=build/release/python or an installed package.
"""

import pathlib
import sys

import eyebridge
import numpy as np

WORLD = pathlib.Path(__file__).resolve().parents[2] / "worlds" / "rooms.wld"
RAYS, HIDDEN, OUT = 9, 10, 2
INPUTS = RAYS + 2
WEIGHTS = HIDDEN * (INPUTS + 1) + OUT * (HIDDEN + 1)
POPULATION, PARENTS, TRIALS = 60, 12, 4
SECONDS = 30.0
FASTEST, SHARPEST = 0.4, 2.0  # m/s, rad/s
PRICE = 5.0  # of bumping into something, metres of way


def drive(weights, observations):
    """Actions of many networks at once: weights (N, WEIGHTS), observations (N, INPUTS)."""
    seen = np.concatenate([np.exp(-4 * observations[:, :RAYS]), observations[:, RAYS:]], axis=1)  # near is 1, far is 0
    cut = HIDDEN * (INPUTS + 1)
    first = weights[:, :cut].reshape(-1, HIDDEN, INPUTS + 1)
    second = weights[:, cut:].reshape(-1, OUT, HIDDEN + 1)
    hidden = np.tanh(np.einsum("nhi,ni->nh", first[:, :, :-1], seen) + first[:, :, -1])
    out = np.tanh(np.einsum("noh,nh->no", second[:, :, :-1], hidden) + second[:, :, -1])
    return np.stack([(out[:, 0] + 1) / 2 * FASTEST, out[:, 1] * SHARPEST], axis=1)


def reward(step):
    """Way, the less the sharper the turn."""
    return step.distances * (1 - np.sqrt(np.abs(step.actions[:, 1]) / SHARPEST))


def judge(env, weights, seed):
    """What each network earns in one episode, and whether it ended at a wall."""
    observations, _ = env.reset(seed=seed)
    total = np.zeros(env.num_envs)
    bumped = np.zeros(env.num_envs, bool)
    over = np.zeros(env.num_envs, bool)
    while not over.all():
        observations, rewards, terminated, truncated, _ = env.step(drive(weights, observations))
        total += np.where(over, 0, rewards)
        bumped |= terminated & ~over
        over |= terminated | truncated
    return total, bumped


def evolve(generations, seed):
    random = np.random.default_rng(seed)
    env = eyebridge.VectorEnv(
        eyebridge.load_scenario(WORLD), POPULATION * TRIALS, observation=f"lidar:{RAYS} speed", start="anywhere",
        time_limit=SECONDS, autoreset="disabled", reward=reward,
    )  # fmt: skip
    mean, sigma = np.zeros(WEIGHTS), 0.6
    ranks = np.log(PARENTS + 0.5) - np.log(np.arange(1, PARENTS + 1))
    for generation in range(1, generations + 1):
        weights = mean + sigma * random.normal(size=(POPULATION, WEIGHTS))
        earned, bumped = judge(env, np.repeat(weights, TRIALS, axis=0), int(random.integers(1 << 62)))
        score = (earned - PRICE * bumped).reshape(POPULATION, TRIALS).mean(axis=1)
        best = np.argsort(-score, kind="stable")[:PARENTS]
        mean = ranks @ weights[best] / ranks.sum()
        sigma *= 0.94
        print(f"generation {generation}: best {score.max():.2f}, earned {earned.mean():.2f}, bumped {bumped.mean():.0%}", flush=True)
    earned, bumped = judge(env, np.tile(mean, (env.num_envs, 1)), seed)
    print(f"trained: earned {earned.mean():.2f} in {SECONDS:g} s from {env.num_envs} places, bumped {bumped.mean():.0%}")
    return mean


if __name__ == "__main__":
    numbers = [int(word) for word in sys.argv[1:]]
    evolve(*numbers, *(30, 1)[len(numbers) :])
