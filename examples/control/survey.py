"""Maps a world until nothing new turns up, then ends by itself: something to assess.

eyebridge assess --worlds worlds/maze-5.maz,worlds/rooms.wld --errors realistic examples/control/survey.py
"""

PATIENCE = 8.0  # seconds without news that end it
NEWS = 12  # cells


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1").start()
    bearings = one.sensor("lidar").bearings
    ahead, left = abs(bearings) < 0.7, bearings > 0
    known, quiet, turn = 0, 0.0, 0.0
    while keep_going() and quiet < PATIENCE:
        interact.wait(0.1)
        belief_space.set_robot(one)  # where its wheels say
        ranges = belief_space.update(one, "lidar")["lidar"]
        gap = ranges[ahead].min() - one.radius
        if turn == 0.0 and gap < 0.05:
            turn = 1.0 if ranges[left].mean() > ranges[~left].mean() else -1.0
        elif turn != 0.0 and gap > 0.10:
            turn = 0.0
        one.set_twist(0.0 if turn else 0.15, turn)
        now = int((belief_space.log_odds != 0).sum())
        quiet += 0.1
        if now > known + NEWS:
            known, quiet = now, 0.0
