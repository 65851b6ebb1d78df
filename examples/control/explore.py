"""Explores a world by its frontiers: drives to the nearest border of the unknown, as long as there is one.

eyebridge run examples/control/explore.py --world worlds/rooms.wld
"""

import eyebridge

MARGIN = 0.02  # metres between the robot and what it drives around


def drive(one, keep_going, belief_space, path):
    """Along the path, mapping on the way; until it is there, or something is in its way."""
    pursuit = eyebridge.PurePursuit(path, lookahead=0.12, speed=0.2)
    while keep_going():
        linear, angular = pursuit.follow(belief_space.robot(one))
        one.set_twist(linear, angular)
        if pursuit.has_arrived:
            return
        belief_space.update(one)
        if any(belief_space.is_occupied(x, y) for x, y in path):
            return


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1")
    one.start()
    belief_space.set_robot(one)
    for _ in range(4):  # what was seen only once is not yet taken for known
        belief_space.update(one)
    while keep_going():
        x, y, theta = belief_space.robot(one)
        # Nearer to walls than it would plan to be, if it must.
        for margin in (MARGIN, 0.0, -0.02):
            try:
                path = eyebridge.explore(belief_space.grid, (x, y), radius=one.radius + margin, smallest=3)
                break
            except ValueError:
                path = None
        if path is None:
            break
        drive(one, keep_going, belief_space, path)
        one.set_twist(0.0)
    found = belief_space.grid.agreement(map_space.grid)
    known = belief_space.grid.coverage(map_space.grid, *one.true_pose[:2])
    interact.print(f"{known:.0%} of what can be reached is known, {found['share']:.1%} of it rightly")
