"""The control interface in one screen: two wheels, a belief that grows, and a polite stop.

eyebridge run --world worlds/maze-8.maz --time-limit 20s examples/control/first.py
"""


def run(robot, keep_going, belief_space, map_space, interact):
    one = robot("Robot 1")
    one.start()
    belief_space.set_robot("Robot 1")
    while keep_going():
        seen = belief_space.update("Robot 1")
        if seen["PSD_FRONT"] > 0.2:
            # Ahead, in the middle between the walls at its sides.
            turn = 10 * (min(seen["PSD_RIGHT"], 0.3) - min(seen["PSD_LEFT"], 0.3))
            one.set_wheel("left", 8 + turn)
            one.set_wheel("right", 8 - turn)
            continue
        # A wall: to the side with more room, until there is room ahead.
        turn = 4 if seen["PSD_LEFT"] < seen["PSD_RIGHT"] else -4
        one.set_wheel("left", turn)
        one.set_wheel("right", -turn)
        while keep_going() and one.read("PSD_FRONT") < 0.3:
            pass
    found = belief_space.grid.agreement(map_space.grid)
    interact.print(f"{found['observed']} cells are known, {found['share']:.1%} of them rightly")
