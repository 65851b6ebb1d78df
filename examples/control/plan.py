"""Compares the planners on one map, then drives the shortest way by pure pursuit, and back by the dynamic window.

Particles tell it where it is: its wheels alone lead it into walls.

eyebridge run --world worlds/rooms.wld --errors realistic examples/control/plan.py
"""

import math

import eyebridge

GOAL = (0.7, 3.0)  # in the north-west room of worlds/rooms.wld
MARGIN = 0.05  # metres between the robot and walls
METHODS = "astar", "dstar_lite", "wavefront", "theta_star", "rrt_star", "potential_field"


def length(path):
    return sum(math.dist(a, b) for a, b in zip(path, path[1:]))


class Whereabouts:
    """Where the robot is: by its wheels, and by what its lidar sees of the map."""

    def __init__(self, one, grid):
        self.one, self.lidar, self.steps, self.before = one, one.sensor("lidar"), 0, one.pose
        self.filter = eyebridge.MonteCarlo(grid, max_range=self.lidar.max_range, particles=3000)
        self.filter.start_at(one.pose, 0.02, 0.02)

    def __call__(self):
        now = self.one.pose
        self.filter.predict(self.before, now)
        self.before = now
        self.steps += 1
        if self.steps % 5 == 0:
            self.filter.correct(self.lidar.read(), self.lidar.bearings)
        return self.filter.estimate


def pursue(one, keep_going, path, where):
    pursuit = eyebridge.PurePursuit(path, lookahead=0.15, speed=0.2)
    while keep_going() and not pursuit.has_arrived:
        one.set_twist(*pursuit.follow(where()))
        yield


def weave(one, keep_going, path, where, grid):
    """Aims at places some way ahead on the path: by itself the method gets stuck behind walls."""
    window = eyebridge.DynamicWindow(grid, radius=one.radius + 0.01, speed=0.2, max_angular=1.5, period=0.05, tolerance=0.03)
    ahead, now = 0, (0.0, 0.0)
    while keep_going() and math.dist((pose := where())[:2], path[-1]) > 0.05:
        while ahead < len(path) - 1 and math.dist(pose[:2], path[ahead]) < 0.3:
            ahead += 1
        *now, _ = window.choose(pose, now, path[ahead])
        one.set_twist(*now)
        yield


def drive(name, one, steps, path, interact):
    way, near, before = 0.0, math.inf, one.true_pose
    for _ in steps:
        interact.wait(0.04)
        way, before = way + math.dist(one.true_pose[:2], before[:2]), one.true_pose
        near = min(near, one.read("lidar").min() - one.radius)
    off = math.dist(before[:2], path[-1])
    interact.print(f"{name}: {way / length(path):.0%} of its path, {1000 * off:.0f} mm off, walls {1000 * near:.0f} mm away")


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1").start()
    ends = {"start": one.pose[:2], "goal": GOAL, "radius": one.radius + MARGIN}
    paths = {method: eyebridge.plan(map_space.grid, method=method, **ends) for method in METHODS}
    best = min(length(path) for path in paths.values() if path is not None)
    for method, path in paths.items():
        found = "got stuck" if path is None else f"{length(path):.2f} m, {length(path) / best:.1%} of the shortest"
        interact.print(f"{method}: {found}")
    where = Whereabouts(one, map_space.grid)
    path = paths["theta_star"]
    drive("pure pursuit", one, pursue(one, keep_going, path, where), path, interact)
    back = paths["astar"][::-1]
    drive("dynamic window", one, weave(one, keep_going, back, where, map_space.grid), back, interact)
