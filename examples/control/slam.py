"""Draws a map of a floor it does not know and its place on it (SLAM); beside it, scans matched with the true map, and odometry.

eyebridge run --world worlds/rooms.wld --errors harsh --time-limit 60s examples/control/slam.py
"""

import math

import eyebridge


def moved(pose, before, after):
    """`pose`, after a motion that odometry saw from `before` to `after`."""
    turn = pose[2] - before[2]
    dx, dy = after[0] - before[0], after[1] - before[1]
    return (
        pose[0] + dx * math.cos(turn) - dy * math.sin(turn),
        pose[1] + dx * math.sin(turn) + dy * math.cos(turn),
        pose[2] + after[2] - before[2],
    )


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1").start()
    lidar = one.sensor("lidar")
    bearings, reach = lidar.bearings, lidar.max_range
    ahead, left = abs(bearings) < 0.6, bearings > 0
    slam = eyebridge.GridSlam(belief_space.grid, one.true_pose, max_range=reach, sigma=0.02)
    matcher = eyebridge.ScanMatcher(map_space.grid)
    matched = before = one.pose
    turn = 0.0
    while keep_going():
        interact.wait(0.2)
        ranges, now = lidar.read(), one.pose
        slam.add(now, ranges, bearings)
        matched, before = moved(matched, before, now), now
        found = matcher.match(matched, ranges, bearings, max_range=reach)
        if found is not None:
            matched, _ = found
        gap = ranges[ahead].min() - one.radius
        if turn == 0.0 and gap < 0.1:
            turn = 0.8 if ranges[left].mean() > ranges[~left].mean() else -0.8
        elif gap > 0.2:
            turn = 0.0
        one.set_twist(0.0 if turn else 0.15, turn)
        belief_space.grid = slam.map
        belief_space.set_robot(one, *slam.pose)
    truth = one.true_pose
    for name, pose in (("slam", slam.pose), ("matched with the map", matched), ("odometry", one.pose)):
        interact.print(f"{name}: {1000 * math.dist(pose[:2], truth[:2]):.0f} mm off")
    found = slam.map.agreement(map_space.grid)
    interact.print(f"{found['observed']} cells are on the map, {found['share']:.1%} of them rightly")
