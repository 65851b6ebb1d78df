"""Explores a world by its frontiers: drives to the nearest border of the unknown, as long as there is one.

eyebridge run --world worlds/rooms.wld examples/control/explore.py
"""

import math
import time

import eyebridge

MARGIN = 0.03  # metres between the robot and what it drives around


def drive(one, keep_going, belief_space, path):
    """Along the path, mapping on the way; until it is there, something is in its way, or it is stuck."""
    pursuit = eyebridge.PurePursuit(path, lookahead=0.1, speed=0.2)
    last, since = one.pose, time.time()
    while keep_going():
        linear, angular = pursuit.follow(belief_space.robot(one))
        one.set_twist(linear, angular)
        if pursuit.has_arrived:
            return
        belief_space.update(one)
        if any(belief_space.is_occupied(x, y) for x, y in path):
            return
        pose = one.pose
        if math.dist(pose, last) > 0.02:  # metres and radians alike: it moves
            last, since = pose, time.time()
        elif time.time() - since > 1.0:
            back_off(one)
            return


def back_off(one):
    """Half a second back, where it came from."""
    one.set_twist(-0.1)
    time.sleep(0.5)
    one.set_twist(0.0)


def way_on(grid, place, radius):
    """To the nearest border of the unknown; nearer to walls than it would like to be, if it must. None: all is known."""
    for margin in (MARGIN, 0.01):
        path = eyebridge.explore(grid, place, radius=radius + margin, smallest=3)
        if path is not None:
            return path
    return None


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1")
    one.start()
    belief_space.set_robot(one)
    for _ in range(4):  # what was seen only once is not yet taken for known
        belief_space.update(one)
    while keep_going():
        x, y, theta = belief_space.robot(one)
        try:
            path = way_on(belief_space.grid, (x, y), one.radius)
        except ValueError:  # so near to a wall does it stand
            back_off(one)
            continue
        if path is None:
            break
        drive(one, keep_going, belief_space, path)
        one.set_twist(0.0)
    found = belief_space.grid.agreement(map_space.grid)
    known = belief_space.grid.coverage(map_space.grid, *one.true_pose[:2])
    interact.print(f"{known:.0%} of what can be reached is known, {found['share']:.1%} of it rightly")
