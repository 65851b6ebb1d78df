"""LCD and KEY: the panel."""

import ctypes as _ctypes

from . import _convert
from ._format import c_format as _c_format
from ._library import C as _C
from ._library import variable as _variable
from ._readings import pair as _pair

_image_width = _variable("IM_WIDTH")
_image_height = _variable("IM_LENGTH")


def LCDPrintf(format, *args):
    """Prints at the cursor as printf() does in C: surplus arguments are ignored, int and float stand in for each
    other, and for %s any value does. A conversion without an argument is printed as it stands. 0."""
    return _C.LCDPrintf(b"%s", _c_format(format, args).encode("utf-8", "replace"))


def LCDSetPrintf(row, column, format, *args):
    """Moves the cursor to a character cell (row first, from 0 at the top left), then prints as LCDPrintf()."""
    return _C.LCDSetPrintf(row, column, b"%s", _c_format(format, args).encode("utf-8", "replace"))


def LCDClear():
    """Blanks the screen to black, cursor to 0, 0, white text on black. The menu stays."""
    return _C.LCDClear()


def LCDSetPos(row, column):
    """Moves the text cursor to a character cell."""
    return _C.LCDSetPos(row, column)


def LCDGetPos(row=None, column=None):
    """The text cursor, cells: [row, column]. Given two ctypes ints, fills them in and returns 0."""
    if row is None and column is None:
        return _pair("LCDGetPos", _C.LCDGetPos)
    return _C.LCDGetPos(_convert.out(row), _convert.out(column))


def LCDSetColor(fg, bg=0):
    """Colours (0xRRGGBB) of the text printed from now on."""
    return _C.LCDSetColor(fg, bg)


def LCDSetFont(font, variation):
    """HELVETICA, TIMES or COURIER in NORMAL, BOLD or ITALICS; 1 for any other value."""
    return _C.LCDSetFont(font, variation)


def LCDSetFontSize(fontsize):
    """8, 10, 12, 14, 18 or 24 pixels; 1 for any other size."""
    return _C.LCDSetFontSize(fontsize)


LCDFontSize = LCDSetFontSize  # as one generation of `eye` called it


def LCDSetMode(mode):
    """Switches by the LCD_… flags; a flag not given stays as it is."""
    return _C.LCDSetMode(mode)


def LCDMenu(st1, st2, st3, st4):
    """Labels the four soft keys, left to right, and shows them."""
    return _C.LCDMenu(st1, st2, st3, st4)


def LCDMenuI(pos, string, fg, bg):
    """One label in its own colours; pos 1..4 (see eyebot.h for 0..3)."""
    return _C.LCDMenuI(pos, string, fg, bg)


def LCDGetSize(x=None, y=None):
    """Size of the screen, pixels: [width, height]. Given two ctypes ints, fills them in and returns 0."""
    if x is None and y is None:
        return _pair("LCDGetSize", _C.LCDGetSize)
    return _C.LCDGetSize(_convert.out(x), _convert.out(y))


def LCDPixel(x, y, col):
    """Draws a pixel; origin top left, y down."""
    return _C.LCDPixel(x, y, col)


def LCDGetPixel(x, y):
    """The colour shown at a pixel; 0 outside the screen."""
    return _C.LCDGetPixel(x, y)


def LCDLine(x1, y1, x2, y2, col):
    """Draws a straight line; both ends are drawn."""
    return _C.LCDLine(x1, y1, x2, y2, col)


def LCDArea(x1, y1, x2, y2, col, fill=1):
    """Draws a rectangle between two corners, filled when fill is not 0."""
    return _C.LCDArea(x1, y1, x2, y2, col, fill)


def LCDCircle(x1, y1, size, col, fill=1):
    """Draws a circle of radius size around (x1, y1), filled when fill is not 0."""
    return _C.LCDCircle(x1, y1, size, col, fill)


def LCDPixelInvert(x, y):
    """Inverts a pixel."""
    return _C.LCDPixelInvert(x, y)


def LCDLineInvert(x1, y1, x2, y2):
    """Inverts the pixels of a line."""
    return _C.LCDLineInvert(x1, y1, x2, y2)


def LCDAreaInvert(x1, y1, x2, y2):
    """Inverts the pixels of a rectangle."""
    return _C.LCDAreaInvert(x1, y1, x2, y2)


def LCDImageSize(t):
    """Mode (QQVGA …) of the images that follow, placed at 0, 0."""
    return _C.LCDImageSize(t)


def LCDImageStart(x, y, xs, ys):
    """Place and size in pixels of the images that follow. Must be the image's real size."""
    return _C.LCDImageStart(x, y, xs, ys)


def _show(call, function, image, bytes_per_pixel):
    needed = _image_width.value * _image_height.value * bytes_per_pixel
    return function(_convert.image_in(call, image, needed))


def LCDImage(img):
    """Shows a colour image, three bytes a pixel: an array of CAMGet(), any ctypes array of bytes, bytes, bytearray, a
    numpy array, a list. 1 for what is none or has too few bytes for LCDImageStart()'s size."""
    return _show("LCDImage", _C.LCDImage, img, 3)


def LCDImageGray(img_gray):
    """Shows a grey image, one byte a pixel, 0 black … 255 white; otherwise as LCDImage()."""
    return _show("LCDImageGray", _C.LCDImageGray, img_gray, 1)


def LCDImageBinary(binary):
    """Shows one byte a pixel, 0 white and all else black; otherwise as LCDImage()."""
    return _show("LCDImageBinary", _C.LCDImageBinary, binary, 1)


def LCDRefresh():
    """Shows what was drawn since LCD_NOAUTOREFRESH; otherwise nothing to do."""
    return _C.LCDRefresh()


def KEYGet():
    """Waits for a key and returns KEY1, KEY2, KEY3 or KEY4."""
    return _C.KEYGet()


def KEYRead():
    """The oldest press that no call has reported yet, or NOKEY. Never waits."""
    return _C.KEYRead()


def KEYWait(key):
    """Waits for one of the keys in the mask (ANYKEY: any) and returns it."""
    return _C.KEYWait(key)


def KEYGetXY(x=None, y=None):
    """Waits for a touch: [x, y] in LCD pixels. Given two ctypes ints, fills them in and returns 0."""
    if x is None and y is None:
        return _pair("KEYGetXY", _C.KEYGetXY)
    return _C.KEYGetXY(_convert.out(x), _convert.out(y))


def KEYReadXY(x=None, y=None):
    """The touch since the last call: [x, y], or None when there was none. Given two ctypes ints, fills them in and
    returns 0, or returns 1 when there was none."""
    if x is None and y is None:
        touch = (_ctypes.c_int * 2)()
        return touch[:] if _C.KEYReadXY(touch, _ctypes.byref(touch, 4)) == 0 else None
    return _C.KEYReadXY(_convert.out(x), _convert.out(y))
