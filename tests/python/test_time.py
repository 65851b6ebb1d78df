"""Sleep, time, timers and threads: they follow the robot's clock."""

from support import ProgramTest, main


class Time(ProgramTest):
    def test_sleep_and_time_follow_virtual_time(self):
        self.expect(
            """
            from time import sleep
            import time
            from eye import *
            start, count = time.time(), OSGetCount()
            VWSetSpeed(100, 0)
            time.sleep(1.5)
            sleep(1)
            VWSetSpeed(0, 0)
            x, y, phi = VWGetPosition()
            print(round(time.time() - start, 1), round((OSGetCount() - count) / 1000, 1), 230 < x < 260)
            while time.time() - start < 10:
                pass
            print(OSGetCount() - count >= 10000 - 1, abs(time.time_ns() / 1e9 - time.time()) < 0.01)
            """,
            """
            2.5 2.5 True
            True True
            """,
        )

    def test_threads_take_turns_on_the_robots_clock(self):
        self.expect(
            """
            import queue, threading, time
            from eye import *
            ends = []
            def loop(wait):
                for _ in range(50):
                    wait()
                ends.append(OSGetCount() // 10 * 10)
            waits = [lambda: OSWait(10), lambda: time.sleep(0.02), lambda: OSWait(10)]
            threads = [threading.Thread(target=loop, args=(wait,)) for wait in waits]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            print(ends, "run" in vars(threads[0]))
            made = queue.Queue()
            def produce():
                for _ in range(3):
                    time.sleep(0.1)
                    made.put(OSGetCount())
                made.put(None)
            producer = threading.Timer(0, produce)
            producer.start()
            while (at := made.get()) is not None:
                assert OSGetCount() == at
            print("empty")
            """,
            """
            [500, 500, 1000] False
            empty
            """,
        )

    def test_time_before_the_first_call_is_the_robots_too(self):
        self.expect(
            """
            import eye, time
            start = time.time()
            time.sleep(2)
            print(start < 1, round(time.time() - start), round(eye.OSGetCount() / 1000))
            """,
            "True 2 2",
        )

    def test_wall_time_stays_pythons(self):
        self.expect(
            """
            import time
            import datetime
            from eye import *
            OSGetCount()
            time.sleep(0.01)
            print(abs(time.time() - datetime.datetime.now().timestamp()) < 5)
            for seconds in (-1, "long"):
                try:
                    time.sleep(seconds)
                except (TypeError, ValueError) as error:
                    print(type(error).__name__)
            """,
            """
            True
            ValueError
            TypeError
            """,
            {"fast": False},
        )

    def test_waiting_threads_do_not_wait_for_virtual_time(self):
        self.expect(
            """
            from eye import *
            import queue, threading
            OSWait(1)
            mail = queue.Queue()
            threading.Thread(target=lambda: mail.put(PSDGet(1))).start()
            print(mail.get(timeout=30) > 0)
            try:
                mail.get(timeout=0.01)
            except queue.Empty:
                print("empty")
            """,
            """
            True
            empty
            """,
        )

    def test_timers_call_functions_until_they_are_detached(self):
        program = """
            from eye import *
            import gc
            count = [0, 0]
            def tick():
                count[0] += 1
            def other():
                count[1] += 1
                LCDPrintf("tick\\n")
            a, b = OSAttachTimer(10, tick), OSAttachTimer(100, other)
            gc.collect()
            while count[1] < 3:
                OSWait(10)
            print(OSDetachTimer(a), OSDetachTimer(a), a != b, count[0] > 3)
            print([OSAttachTimer(5, tick) > 0 for _ in range(40)] == [True] * 40, OSAttachTimer(0, tick), OSAttachTimer(5, 5))
            print(OSDetachTimer(OSAttachTimer(1000, type(None))))
            """
        for settings in ({"fast": True}, {"fast": False, "factor": 10}):
            self.expect(program, "0 1 True True\nTrue 0 0\n0", settings, err=None)

    def test_an_exact_number_of_ticks_in_virtual_time(self):
        self.expect(
            """
            from eye import *
            count = 0
            def tick():
                global count
                count += 1
            OSAttachTimer(10, tick)
            OSWait(1000)
            print(count)
            while count < 200:
                PSDGet(1)
            print(count)
            """,
            """
            100
            200
            """,
        )

    def test_what_a_timers_function_raises_is_printed_and_the_timer_goes_on(self):
        run = self.run_program(
            """
            from eye import *
            count = 0
            def tick():
                global count
                count += 1
                raise ValueError("in the timer")
            OSAttachTimer(10, tick)
            OSWait(105)
            print(count)
            """
        )
        self.assertEqual((run.returncode, run.out), (0, "10\n"), run.err)
        self.assertEqual(run.err.count("ValueError: in the timer"), 10)

    def test_threads_of_a_program(self):
        for settings in ({"fast": True}, {"fast": False, "factor": 20}):
            self.expect(
                """
                from eye import *
                import threading
                def watch():
                    for i in range(200):
                        PSDGet(PSD_FRONT)
                        KEYRead()
                        LCDPrintf("%d\\n", i)
                def drive():
                    VWStraight(200, 200)
                    VWWait()
                    print("drove")
                threads = [threading.Thread(target=run) for run in (watch, drive, watch)]
                for thread in threads:
                    thread.start()
                for thread in threads:
                    thread.join()
                print(VWGetPosition())
                """,
                """
                drove
                [200, 0, 0]
                """,
                settings,
            )

    def test_the_same_run_gives_the_same_trace(self):
        program = """
            from eye import *
            import random, time
            random.seed(time.time())
            for i in range(20):
                VWStraight(random.randint(-50, 100), 200); VWWait()
                VWTurn(random.randint(-90, 90), 90); time.sleep(0.5)
            """
        traces = []
        for name in ("a", "b"):
            run = self.run_program(program, {"out": self.folder / name})
            self.assertEqual(run.returncode, 0, run.err)
            traces.append((self.folder / name / "trace.csv").read_bytes())
        self.assertGreater(len(traces[0]), 1000)
        self.assertEqual(*traces)


if __name__ == "__main__":
    main()
