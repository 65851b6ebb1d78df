"""The control interface in one screen: two wheels, a belief that grows, and a polite stop.

eyebridge run examples/control/first.py --world worlds/maze-8.maz --time-limit 20s
"""


def run(robot, keep_going, belief_space, map_space, interact):
    robot("Robot 1").start()
    belief_space.set_robot("Robot 1")
    robot("Robot 1").set_wheel("left", 8)
    robot("Robot 1").set_wheel("right", 8)
    while keep_going():
        belief_space.set_robot("Robot 1")
        readings = belief_space.update("Robot 1")
        if readings["PSD_FRONT"] < 0.15:
            robot("Robot 1").set_wheel("left", 4)
            robot("Robot 1").set_wheel("right", -4)
        else:
            robot("Robot 1").set_wheel("left", 8)
            robot("Robot 1").set_wheel("right", 8)
    interact.print(f"saw {belief_space.grid.agreement(map_space.grid)['observed']} cells")
