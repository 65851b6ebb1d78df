"""Drives to a goal through a floor that it does not know: D* Lite takes what is unknown for free, and plans anew when it is not.

Where it is its wheels tell, and each scan, which must fit those before it.

eyebridge run --world worlds/rooms.wld --errors realistic examples/control/replan.py
"""

import math

import eyebridge

GOAL = (0.7, 3.0)
MARGINS = 0.05, 0.02, 0.0  # metres to walls: less where the robot stands nearer


def planners(grid, radius):
    return [eyebridge.DStarLite(grid, GOAL, radius=radius + margin) for margin in MARGINS]


def way_from(place, plans):
    """The path of the first planner in whose margin the robot does not stand, and what that cost."""
    for planner in plans:
        try:
            return planner.plan(place), planner.expanded
        except ValueError:
            continue
    return None, 0


def see(one, lidar, belief_space):
    """Corrects where the robot is believed to be, and believes what it sees from there."""
    matcher = eyebridge.ScanMatcher(belief_space.grid)
    found = matcher.match(belief_space.robot(one), lidar.read(), lidar.bearings, max_range=lidar.max_range)
    if found is not None:
        belief_space.set_robot(one, *found[0])
    belief_space.update(one, lidar)


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1").start()
    start, lidar = one.pose[:2], one.sensor("lidar")
    belief_space.set_robot(one)
    plans = planners(belief_space.grid, one.radius)
    work = fresh = way = 0
    before = one.true_pose
    while keep_going() and math.dist(belief_space.robot(one)[:2], GOAL) > 0.05:
        see(one, lidar, belief_space)
        place = belief_space.robot(one)[:2]
        path, expanded = way_from(place, plans)
        if path is None:
            break
        work += expanded
        fresh += way_from(place, planners(belief_space.grid, one.radius))[1]  # had it to begin again each time
        pursuit = eyebridge.PurePursuit(path, lookahead=0.1, speed=0.2, tolerance=0.03)
        for _ in range(5):
            one.set_twist(*pursuit.follow(belief_space.robot(one)))
            interact.wait(0.04)
        way, before = way + math.dist(one.true_pose[:2], before[:2]), one.true_pose
    one.stop()
    known = eyebridge.plan(map_space.grid, start, GOAL, radius=one.radius + MARGINS[0], method="theta_star")
    shortest = sum(math.dist(a, b) for a, b in zip(known, known[1:]))
    interact.print(f"{1000 * math.dist(one.true_pose[:2], GOAL):.0f} mm from the goal after {way:.2f} m, {way / shortest:.2f} times")
    interact.print(f"the way on a known floor; {work} cells expanded, {fresh} by planning anew each time")
