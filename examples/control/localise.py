"""Finds out where the robot is: it knows the map, and starts anywhere.

eyebridge run --world worlds/maze-8.maz --errors realistic examples/control/localise.py
"""

import math

import eyebridge


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1")
    lidar = one.sensor("lidar")
    where = eyebridge.MonteCarlo(map_space.grid, max_range=lidar.max_range)
    one.start()
    before = one.pose
    while keep_going() and not (where.share > 0.9 and where.deviation[0] < 0.05):
        near = min(one.read("PSD_FRONT"), one.read("PSD_LEFT"), one.read("PSD_RIGHT"))
        one.set_twist(0.15 if near > 0.15 else 0.0, 0.2 if near > 0.15 else 1.0)
        interact.wait(0.3)
        now = one.pose
        where.predict(before, now)
        where.correct(lidar.read(), lidar.bearings)
        before = now
        map_space.set_robot(one, *where.estimate)
    one.stop()
    x, y, _ = where.estimate
    true_x, true_y, _ = one.true_pose
    interact.print(f"found after {len(where.particles)} particles, {1000 * math.hypot(x - true_x, y - true_y):.0f} mm off")
