"""Programs that call each family, written as people write them."""

from support import ProgramTest, main


class Calls(ProgramTest):
    def test_a_first_program(self):
        self.expect(
            """
            from eye import *
            LCDMenu("GO", "", "", "END")
            while KEYRead() != KEY4:
                if PSDGet(PSD_FRONT) > 300:
                    VWStraight(100, 200)
                    VWWait()
                else:
                    VWTurn(90, 90)
                    VWWait()
                [x, y, phi] = VWGetPosition()
                LCDSetPrintf(2, 0, "%4d %4d %4d", x, y, phi)
            VWSetSpeed(0, 0)
            print(type(x).__name__, LCDGetPos())
            """,
            "int [2, 14]",
            {"keys": "KEY4@9s"},
        )

    def test_driving_takes_floats_numpy_and_ctypes_numbers(self):
        self.expect(
            """
            from eye import *
            import numpy as np
            print(VWStraight(300.7, np.int64(200)), VWWait(), VWGetPosition())
            print(VWTurn(ctypes.c_int(90), 90.5), VWWait(), VWGetPosition())
            print(VWSetPosition(np.float32(1.9), True, -1), VWGetPosition())
            print(VWDrive(100, 200, 100), VWDone(), VWRemain(), VWStalled())
            VWSetSpeed(speed=100, angspeed=0)
            OSWait(2000)
            print(VWGetSpeed(), VWDriveDone())
            """,
            """
            0 0 [300, 0, 0]
            0 0 [300, 0, 90]
            0 [1, 1, -1]
            1 1 0 0
            [100, 0] 1
            """,
            err="eyebridge: warning: VWDrive: the point 100, 200 must lie ahead: dx >= |dy|\n",
        )

    def test_out_parameters_of_c_are_filled_in(self):
        self.expect(
            """
            from eye import *
            import ctypes
            x, y, phi = ctypes.c_int(), ctypes.c_int(), ctypes.c_int()
            VWStraight(100, 100); VWWait()
            print(VWGetPosition(x, y, ctypes.pointer(phi)), x.value, y.value)
            print(LCDGetSize(x, y), x.value, y.value, LCDGetSize())
            LCDSetPos(3, 5)
            print(LCDGetPos(ctypes.byref(x), y), x.value, y.value, LCDGetPos())
            h, m, s, t = (ctypes.c_int() for _ in range(4))
            print(OSGetTime(h, m, s, t), s.value > 0, len(OSGetTime()), OSGetTime(1, 2, 3, 4))
            print(KEYReadXY(x, y), KEYReadXY())
            """,
            """
            0 100 0
            0 560 400 [560, 400]
            0 3 5 [3, 5]
            0 True 4 0
            1 None
            """,
        )

    def test_text_of_any_kind(self):
        self.expect(
            """
            from eye import *
            print(LCDPrintf("%d %s\\n", 5, "five"), LCDPrintf(5), LCDPrintf("text", ""), LCDPrintf("äöü €\\n"))
            print(LCDSetPrintf(1, 2.5, "%s", None), LCDPrintf("%d"), LCDPrintf("100%"), LCDPrintf(b"bytes"))
            print(LCDMenu("A", b"B", 3, None), LCDMenuI(1, "X", RED, BLACK))
            print(LCDSetFont(TIMES, BOLD), LCDSetFontSize(18), LCDFontSize(7), LCDSetMode(LCD_SHOWMENU), LCDRefresh())
            """,
            """
            0 0 0 0
            0 0 0 0
            0 0
            0 0 1 0 0
            """,
            err=None,
        )

    def test_drawing(self):
        self.expect(
            """
            from eye import *
            LCDClear()
            LCDArea(10, 10, 20, 20, RED)
            LCDLine(0, 0, 5, 0, GREEN)
            LCDPixel(30, 30, BLUE)
            LCDCircle(50, 50, 5, WHITE, 1)
            print([hex(LCDGetPixel(x, y)) for x, y in [(15, 15), (5, 0), (30, 30), (50, 53), (100, 100)]])
            """,
            "['0xff0000', '0xff00', '0xff', '0xffffff', '0x0']",
        )

    def test_sensors(self):
        self.expect(
            """
            from eye import *
            print(PSDGet(PSD_FRONT) == PSDGetRaw(1), PSDGet(42), EYEBRIDGELastError())
            scan = LIDARGet()
            print(type(scan).__name__, len(scan), scan[180], LIDAR_RESOLUTION)
            print(LIDARSet(180, 0, 8), len(LIDARGet()), LIDARSet(0, 0, 0), len(SIMLaserScan()))
            MOTORDrive(1, 50); MOTORDrive(2, 50); OSWait(100)
            print(ENCODERRead(1) > 0, ENCODERReset(1), ENCODERRead(1) < 100, MOTORSpeed(1, 5), MOTORPID(1, 4, 1, 1))
            MOTORDrive(1, 0); MOTORDrive(2, 0); OSWait(100)
            print(EYEBRIDGEGyroscopeGet(), EYEBRIDGEAccelerometerGet())
            print(SERVOSet(1, 128), SERVOSetRaw(1, 0), SERVORange(1, 10, 20), MOTORPIDOff(1))
            """,
            """
            True -1 PSDGet: this robot has no PSD 42
            list 360 995 360
            0 8 1 360
            True 0 True 0 0
            0 [0, 0]
            0 0 0 0
            """,
            err=None,
        )

    def test_a_range_matrix(self):
        world = self.write("world.sim", "robot tof.robi\nSeer 1000 1000 0\n")
        self.write("tof.robi", "name Seer\ndiameter 100\ntof 1 TOF_FRONT 140 0 100 0\n")
        self.expect(
            """
            from eye import *
            zones = EYEBRIDGERangeMatrixGet(1)
            print(type(zones).__name__, len(zones), zones[0], zones[63])
            try:
                EYEBRIDGERangeMatrixGet(2)
            except RobotError as error:
                print(error)
            """,
            """
            list 64 855 241
            EYEBRIDGERangeMatrixGet: this robot has no tof 2
            """,
            {"world": world},
            err=None,
        )

    def test_a_robot_without_lidar_says_so_and_goes_on(self):
        world = self.write("world.sim", """
            robot bare.robi
            Bare 1000 1000 0
            """)
        self.write("bare.robi", """
            drive DIFFERENTIAL_DRIVE
            name "Bare"
            axis 0 0
            wheel 54 3600 540 45
            """)
        run = self.run_program(
            """
            from eye import *
            print(LIDARGet() == [-1] * 360, SIMLaserScan()[0], PSDGet(1), CAMInit(QVGA))
            try:
                CAMGet()
            except RobotError as error:
                print(error)
            """,
            {"world": world},
        )
        self.assertEqual(run.returncode, 0, run.err)
        first, second = run.out.splitlines()
        self.assertEqual(first, "True -1 -1 1")
        self.assertRegex(second, "^CAMGet: .*CAMInit")

    def test_what_sim_gives_is_a_number_with_a_value(self):
        self.expect(
            """
            from eye import *
            x, y, z, phi = pose = SIMGetRobot(1)
            print(pose, x.value, type(x.value), x + 1, int.from_bytes(y, "little"), isinstance(x, int))
            SIMSetRobot(1, *pose)
            print(SIMGetRobot(1) == pose, SIMGetRobot(0) == pose, SIMSetRobot(1, x.value + 100, y, z, -90))
            print(SIMGetRobot(1), SIMGetRobotCount(), SIMGetObjectCount(), OSMachineID())
            """,
            """
            [1000, 1000, 0, 0] 1000 <class 'int'> 1001 1000 True
            True True 0
            [1100, 1000, 0, -90] 1 0 1
            """,
        )

    def test_system(self):
        self.expect(
            """
            from eye import *
            buf = ctypes.create_string_buffer(100)
            print(OSVersion(), OSVersion(buf), buf.value, OSVersion("buffer"), OSMachineName(), OSVersionIO())
            print(OSExecute("echo hello").strip(), OSMachineType() == VEHICLE, OSMachineSpeed() > 0, OSVersion(ctypes.create_string_buffer(4)))
            before = OSGetCount(); OSWait(1500); print(OSGetCount() - before)
            """,
            """
            1.0 0 b'1.0' 0 EyeBot None
            hello True True 1
            1500
            """,
            err=None,
        )

    def test_functions_that_the_library_lacks_say_so(self):
        self.expect(
            """
            import eye
            from eye import _library
            try:
                _library._missing("RADIOSend", "libeyebridge.so")(1, "hello")
            except NotImplementedError as error:
                print(error)
            """,
            "RADIOSend: libeyebridge.so has no such function",
        )

    def test_names_of_variables_follow_the_library(self):
        self.expect(
            """
            from eye import *
            import numpy as np
            print(CAMWIDTH, CAMWIDTH == 0, bool(CAMSIZE))
            CAMInit(QQVGA)
            print(CAMWIDTH, CAMHEIGHT * CAMWIDTH == CAMPIXELS, "%d %s" % (CAMWIDTH, CAMHEIGHT), f"{CAMSIZE:7d}")
            print(len(range(CAMWIDTH)), np.zeros((CAMHEIGHT, CAMWIDTH)).shape, ctypes.sizeof(ctypes.c_byte * CAMSIZE))
            print([0] * IP_WIDTH == [0] * 160, CAMWIDTH // 2, 1000 - CAMWIDTH, CAMWIDTH < 200, -CAMWIDTH, CAMWIDTH / 2)
            print(LCDLine(0, 0, CAMWIDTH, CAMHEIGHT, RED), LCDPrintf("%d", CAMWIDTH), divmod(CAMWIDTH, 100), CAMWIDTH == IM_WIDTH)
            """,
            """
            0 True False
            160 True 160 120   57600
            160 (120, 160) 57600
            True 80 840 True -160 80.0
            0 0 (1, 60) True
            """,
        )


if __name__ == "__main__":
    main()
