"""Control files: routines in Python that drive the robots of a world, as the Trinity College simulator runs them.

    def run(robot, keep_going, belief_space, map_space, interact):
        robot("Robot 1").start()
        robot("Robot 1").set_wheel("left", 8)
        robot("Robot 1").set_wheel("right", 8)
        while keep_going():
            belief_space.update("Robot 1")
            if robot("Robot 1").read("psd 1") < 0.2:
                robot("Robot 1").stop()
                return

`eyebridge run --world WORLD FILE` runs one. Each argument: robots.py, going.py, spaces.py, interact.py; docs/control.md.
"""
