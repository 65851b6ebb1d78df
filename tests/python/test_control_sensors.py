"""Sensors of control files: their names, what they read, how likely that is."""

from support import SOURCE, main
from test_control import ControlTest


class Sensors(ControlTest):
    def test_sensors_have_the_names_of_the_robots_file_and_numbers(self):
        self.says(["True True", "psd PSD_FRONT 1", "0.935", "360 360", "0.995"], """
            front = robot("robot 1").sensor("psd front")
            interact.print(front is robot(1).sensor("PSD_FRONT"), front is robot("1").sensor("psd 1"))
            interact.print(front.kind, front.name, front.id)
            interact.print(f"{front.read():.3f}")
            scan = robot(1).sensor("lidar")
            ranges, bearings = scan.read(), scan.bearings
            interact.print(len(ranges), len(bearings))
            interact.print(f"{ranges[abs(bearings).argmin()]:.3f}")
        """)

    def test_gyroscope_accelerometer_compass_and_encoders_are_sensors(self):
        self.says(["0.50 0.00 0.10", "0.50 gyroscope", "1.00", "True", "encoder left"], """
            one = robot(1).start()
            one.set_twist(0.2, 0.5)
            interact.wait(1)
            forward, left = one.read("accelerometer")
            interact.print(f"{one.read('gyroscope'):.2f} {abs(forward):.2f} {left:.2f}")
            rate = one.sensor("Gyroscope").read()
            interact.print(f"{rate:.2f} {rate.sensor.name}")
            interact.print(f"{one.read('compass') / one.true_pose[2]:.2f}")
            ticks = one.read("encoder left")
            interact.print(0 < ticks == one.read("encoder 1") < one.read("encoder right"))
            interact.print(one.sensor("encoder 1").name)
        """)

    def test_how_likely_a_reading_is(self):
        errors = "psd sigma=20; lidar sigma=10; compass 5; gyroscope 1 drift=2; accelerometer 0.1; encoder miss=10; bump 20"
        expected = ["0.6827", "0.6827", "0.6827", "0.6827", "0.6827", "0.2000 0.8000", "1.0000 0.0900", "(2, 3)"]
        self.says(expected, """
            import math
            one = robot(1)
            p = lambda name, reading, truth, **more: one.sensor(name).probability(reading, truth, **more)
            print = interact.print
            print(f"{p('psd 1', 0.5, 0.5, resolution=0.04):.4f}")
            print(f"{p('lidar', 1.0, 1.0, resolution=0.02):.4f}")
            print(f"{p('compass', 1.0, 1.0, resolution=math.radians(10)):.4f}")
            sigma = math.radians(math.hypot(1, 2 * 3))  # strayed for 9 s
            print(f"{p('gyroscope', 0.1, 0.1, resolution=2 * sigma, elapsed=9):.4f}")
            print(f"{p('accelerometer', 0.5, 0.5, resolution=0.2):.4f}")
            print(f"{p('bumper 1', 0, 1):.4f} {p('bumper 1', True, True):.4f}")
            tick = math.tau / 2000
            print(f"{p('encoder left', range(3), 2 * tick).sum():.4f} {p('encoder left', 1, 2 * tick) / 2:.4f}")
            print(p("psd 1", [[0.5], [0.6]], [0.5, 0.6, 0.7]).shape)
        """, "--errors", errors, "--world", SOURCE / "worlds" / "robots" / "Explorer.robi")
        self.fails("control.py:2: run: ValueError: found 0 for 'resolution', expected more than 0",
                   "robot(1).sensor('compass').probability(0, 0, resolution=0)")  # fmt: skip

    def test_errors_that_change_are_known_to_probabilities_and_maps(self):
        self.says(["0.6827 0.3829", "True", "True"], """
            one = robot(1)
            sensor = one.sensor("psd 1")
            p = lambda: sensor.probability(0.5, 0.5, resolution=0.04)
            def how_sure():
                belief_space.clear()
                belief_space.add(one, sensor, 0.5, (0.5, 0.5, 0))
                return belief_space.log_odds.max()  # of the cell that it met something in
            before, sure = p(), how_sure()
            one.set_errors("psd sigma=40")
            interact.print(f"{before:.4f} {p():.4f}")
            interact.print(how_sure() < 0.9 * sure)
            one.set_errors("psd sigma=40", scale=0.5)
            interact.print(abs(how_sure() - sure) < 1e-6)
        """, "--errors", "psd sigma=20", "--world", SOURCE / "worlds" / "robots" / "Explorer.robi")
        self.fails("control.py:2: run: ValueError: errors:1:11: 'wide' found: expected psd's sigma, a number in mm",
                   "robot(1).set_errors('psd sigma=wide')")  # fmt: skip


if __name__ == "__main__":
    main()
