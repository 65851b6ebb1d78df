"""Everything that may be an image, cameras, and what is done with their pictures."""

from support import SOURCE, ProgramTest, main

WORLD = {"world": SOURCE / "worlds" / "colour-targets.sim"}


class Images(ProgramTest):
    def test_a_frame_is_an_array_that_can_be_changed(self):
        self.expect(
            """
            from eye import *
            import numpy as np
            print(CAMInit(QVGA))
            img = CAMGet()
            print(isinstance(img, ctypes.Array), img._type_ is ctypes.c_byte, len(img) == CAMSIZE)
            img[0] = 255
            print(img[0], img[0] & 0xff, max(value & 0xff for value in img))
            a = np.frombuffer(img, np.uint8).reshape(QVGA_Y, QVGA_X, 3)
            print(a.shape, a[0, 0, 0], len(set(bytes(img))) > 10)
            a = np.asarray(img).astype(int) & 0xff
            print(a.min() >= 0, a.max(), np.array(img, dtype=np.uint8).max())
            print(len(CAMGetGray()) == CAMPIXELS, LCDImage(img), LCDImageGray(CAMGetGray()), CAMRelease())
            """,
            """
            0
            True True True
            -1 255 255
            (240, 320, 3) 255 True
            True 255 255
            True 0 0 0
            """,
            WORLD,
        )

    def test_whatever_holds_bytes_can_be_shown(self):
        self.expect(
            """
            from eye import *
            import numpy as np
            LCDImageStart(0, 0, 2, 1)
            def show(image):
                LCDClear()
                return LCDImage(image), hex(LCDGetPixel(0, 0)), hex(LCDGetPixel(1, 0))
            values = [255, 0, 1, 2, 128, 3]
            signed = [value - 256 if value > 127 else value for value in values]
            array = np.array(values, np.uint8)
            for image in [bytes(values), bytearray(values), values, tuple(values), signed, array, array.reshape(1, 2, 3),
                          np.array(values), np.array(values, float), (ctypes.c_ubyte * 6)(*values),
                          (ctypes.c_byte * 6)(*signed), ctypes.create_string_buffer(bytes(values), 6),
                          ctypes.cast((ctypes.c_ubyte * 6)(*values), ctypes.POINTER(ctypes.c_ubyte)),
                          ctypes.pointer((ctypes.c_ubyte * 6)(*values)), np.array([values, values], np.uint8)[:, :],
                          np.array(values[::-1], np.uint8)[::-1], [[values[:3], values[3:]]], memoryview(bytes(values))]:
                if show(image) != (0, "0xff0001", "0x28003"):
                    print(type(image), show(image))
            print("all")
            """,
            "all",
        )

    def test_what_is_too_small_or_no_image_is_refused(self):
        run = self.run_program(
            """
            from eye import *
            LCDImageStart(0, 0, 100, 100)
            print([LCDImage(image) for image in (None, b"small", [1, 2], 5, "text", object())])
            print([LCDImageGray((ctypes.c_byte * n)()) for n in (9999, 10000, 20000)], LCDImageBinary([1] * 10000))
            print(len(IPSobel([1, 2])), IPCol2Gray(None, (ctypes.c_byte * 5)()) is not None)
            """
        )
        self.assertEqual(run.returncode, 0, run.err)
        self.assertEqual(run.out, "[1, 1, 1, 1, 1, 1]\n[1, 0, 0] 0\n76800 True\n", run.err)
        self.assertIn("eyebridge: warning: LCDImageGray: the image has 9999 bytes, 10000 are needed\n", run.err)
        self.assertIn("LCDImage: this is no image", run.err)

    def test_a_binary_map_of_a_program(self):
        self.expect(
            """
            from eye import *
            import numpy as np
            map = np.zeros((128, 128), dtype=np.uint8)
            map[5, 7] = 1
            print(LCDImageStart(10, 0, 128, 128), LCDImageBinary(map.ctypes.data_as(ctypes.POINTER(ctypes.c_ubyte))))
            print(hex(LCDGetPixel(17, 5)), hex(LCDGetPixel(10, 0)))
            """,
            """
            0 0
            0x0 0xffffff
            """,
        )

    def test_image_processing_returns_images(self):
        self.expect(
            """
            from eye import *
            import numpy as np
            CAMInit(QQVGA)
            img = CAMGet()
            gray = IPCol2Gray(img)
            edge = IPSobel(gray)
            print(len(gray), len(edge), len(IPLaplace(gray)), max(v & 0xff for v in edge) > 50)
            h, s, i = IPCol2HSI(img)
            print(np.array(h).reshape(QQVGA_Y, QQVGA_X).shape, len(IPOverlayGray(gray, edge, RED)), len(IPOverlay(img, img)))
            print(bytes(IPCol2Gray(IPGray2Col(gray))) == bytes(gray), bytes(IPRGB2Col(gray, gray, gray)) == bytes(IPGray2Col(gray)))
            out = (ctypes.c_byte * CAMPIXELS)()
            print(IPSobel(gray, out) is out, bytes(out) == bytes(edge))
            print(IPWriteFile("a.ppm", img), IPWriteFileGray("b.pgm", gray))
            result, colour = IPReadFile("a.ppm")
            print(result, bytes(colour) == bytes(img), IPReadFile("b.pgm")[0], len(IPReadFile("b.pgm")[1]), IPReadFile("c.ppm")[0])
            """,
            """
            19200 19200 19200 True
            (120, 160) 57600 57600
            True True
            True True
            0 0
            3 True 2 19200 -1
            """,
            WORLD,
            err=None,
        )

    def test_single_pixels(self):
        self.expect(
            """
            from eye import *
            print(hex(IPPRGB2Col(1, 2, 255)), IPPCol2RGB(0x0102FF), IPPRGB2Hue(255, 0, 0), IPPRGB2HSI(255, 0, 0), IPPCol2HSI(RED))
            print(hex(IPPRGB2Col(-1, 0, 0)), IPPRGB2Hue(0, -1, 0))
            h, s, i = ctypes.c_int(), ctypes.c_int(), ctypes.c_int()
            IPPCol2HSI(RED, ctypes.pointer(h), ctypes.pointer(s), ctypes.pointer(i))
            print(h.value, s.value, i.value)
            """,
            """
            0x102ff [1, 2, 255] 43 [43, 255, 85] [43, 255, 85]
            0xff0000 128
            43 255 85
            """,
        )

    def test_a_frame_before_the_camera_is_on_is_an_error(self):
        run = self.run_program("from eye import *\nCAMGet()\n")
        self.assertEqual(run.returncode, 1)
        self.assertIn("RobotError: CAMGet: ", run.err)
        self.assertIn("CAMInit", run.err)


if __name__ == "__main__":
    main()
