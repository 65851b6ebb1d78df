"""The C library through ctypes, as programs and wrappers around `eye` use it."""

from support import ProgramTest, main


class Lib(ProgramTest):
    def test_functions_can_be_called_with_pointers(self):
        self.expect(
            """
            import ctypes
            from eye import lib
            row, col = ctypes.c_int(), ctypes.c_int()
            print(lib.LCDSetPos(2, 3), lib.LCDGetPos(ctypes.pointer(row), ctypes.byref(col)), row.value, col.value)
            print(lib.KEYReadXY(ctypes.pointer(row), ctypes.pointer(col)), lib.OSMachineSpeed(None) > 0)
            print(lib.LCDMenu(b"A", b"B", b"C", b"D"), lib.LCDPrintf(b"%d\\n", 5), lib.PSDGet(1) > 0)
            image = (ctypes.c_byte * 230400)()
            print(lib.LCDImage(image), lib.LCDImage(ctypes.cast(image, ctypes.POINTER(ctypes.c_byte))))
            print(ctypes.c_int.in_dll(lib, "LIDAR_RESOLUTION").value, lib.OSExecute(b"echo hi"))
            """,
            """
            0 0 2 3
            1 True
            0 0 True
            0 0
            360 b'hi\\n'
            """,
        )

    def test_types_that_a_program_sets_do_not_disturb_eye(self):
        self.expect(
            """
            from eye import *
            lib.VWGetPosition.argtypes = [ctypes.c_int]
            lib.LCDSetMode.argtypes = [ctypes.POINTER(ctypes.c_int)]
            lib.PSDGet.restype = ctypes.c_char_p
            lib.OSGetTime.argtypes = [ctypes.POINTER(ctypes.c_int)] * 4
            print(VWGetPosition(), LCDSetMode(0), PSDGet(1) > 0, len(OSGetTime()))
            four = [ctypes.c_int() for _ in range(4)]
            print(lib.OSGetTime(*(ctypes.pointer(one) for one in four)))
            """,
            """
            [0, 0, 0] 0 True 4
            0
            """,
        )

    def test_an_import_of_other_modules_collides_with_nothing(self):
        self.expect(
            """
            from eye import *
            from math import *
            from random import *
            from ctypes import *
            import time
            VWTurn(degrees(pi / 2), 90); VWWait()
            print(VWGetPosition(), sqrt(4), randint(1, 1), type(time).__name__)
            """,
            "[0, 0, 90] 2.0 1 module",
        )


if __name__ == "__main__":
    main()
