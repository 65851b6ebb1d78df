"""Knows where it is by four posts that its lidar sees: an extended Kalman filter, beside odometry alone.

eyebridge run --world examples/control/landmarks.sim --errors harsh examples/control/landmarks.py
"""

import math

import eyebridge

POSTS = (0.5, 0.5), (1.5, 0.5), (0.5, 1.5), (1.5, 1.5)
RADIUS = 0.033  # of a post


def sighting(post, pose, ranges, bearings):
    """Range and bearing of the middle of a post near where it must be, seen from `pose`; None where it is not seen."""
    expected = math.dist(post, pose[:2])
    bearing = math.remainder(math.atan2(post[1] - pose[1], post[0] - pose[0]) - pose[2], math.tau)
    beside = abs((bearings - bearing + math.pi) % math.tau - math.pi)
    hits = (beside < 0.3) & (abs(ranges - expected) < 0.2)
    if expected < 0.2 or hits.sum() < 2:
        return None
    # Mean direction, and the mean of a disc's front is a quarter pi of its radius before its middle.
    sine, cosine = (sum(f(angle) for angle in bearings[hits]) for f in (math.sin, math.cos))
    return ranges[hits].mean() + math.pi / 4 * RADIUS, math.atan2(sine, cosine)


def to_circle(pose):
    """Rate of turn that keeps it on a circle of 0.45 m about the middle of the room."""
    x, y = pose[0] - 1.0, pose[1] - 1.0
    askew = math.remainder(math.atan2(y, x) + math.pi / 2 - pose[2], math.tau)
    return 0.267 + 2 * (math.hypot(x, y) - 0.45) + askew


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1").start()
    lidar = one.sensor("lidar")
    bearings = lidar.bearings
    where = eyebridge.LandmarkEkf(one.true_pose, position_sigma=0.01, heading_sigma=0.01)
    before, seen, errors, by_wheels = one.pose, 0, [], []
    for _ in range(600):
        if not keep_going():
            break
        one.set_twist(0.12, to_circle(where.estimate))
        interact.wait(0.1)
        now = one.pose
        where.predict(before, now)
        before, ranges = now, lidar.read()
        for post in POSTS:
            found = sighting(post, where.estimate, ranges, bearings)
            seen += found is not None and where.update(post, *found, range_sigma=0.03, bearing_sigma=0.03)
        truth = one.true_pose
        errors.append(math.dist(where.estimate[:2], truth[:2]))
        by_wheels.append(math.dist(now[:2], truth[:2]))
        belief_space.set_robot(one, *where.estimate)
    mean = 1000 * sum(errors) / len(errors)
    interact.print(f"{seen} sightings; {mean:.0f} mm off on average, at the end {1000 * errors[-1]:.0f} mm,")
    interact.print(f"by odometry alone {1000 * by_wheels[-1]:.0f} mm")
