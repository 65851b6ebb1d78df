"""RoBIOS for Python: the calls of eyebot.h, as robot programs expect them.

    from eye import *

    VWStraight(300, 200)
    VWWait()
    LCDPrintf("front %4d mm\\n", PSDGet(PSD_FRONT))

Names are those of eyebot.h. Functions return what the C function returns; those with out-parameters return their values
instead (`x, y, phi = VWGetPosition()`), or fill in ctypes objects that the program gives. Each call lets other threads of
the program run. `ctypes` and `lib`, the C library itself, are here because programs use them.
"""

import ctypes

from ._library import lib
from ._constants import *
from ._lcd import *
from ._live import Live as _Live
from ._motion import *
from ._os import *
from ._ports import *
from ._readings import RobotError
from ._sim import *
from ._version import __version__
from ._vision import *
from . import _host

# Variables of the library, always of this moment: see _live.py.
CAMWIDTH, CAMHEIGHT = _Live("CAMWIDTH"), _Live("CAMHEIGHT")
CAMPIXELS, CAMSIZE = _Live("CAMPIXELS"), _Live("CAMSIZE")
CAMMODE, CAM_INITIAL, LCD_INITIAL = _Live("CAMMODE"), _Live("CAM_INITIAL"), _Live("LCD_INITIAL")
IP_WIDTH, IP_HEIGHT = _Live("IP_WIDTH"), _Live("IP_HEIGHT")
IP_PIXELS, IP_SIZE = _Live("IP_PIXELS"), _Live("IP_SIZE")
IM_TYPE, IM_LEFT, IM_TOP = _Live("IM_TYPE"), _Live("IM_LEFT"), _Live("IM_TOP")
IM_WIDTH, IM_LENGTH = _Live("IM_WIDTH"), _Live("IM_LENGTH")
LIDAR_RESOLUTION = _Live("LIDAR_RESOLUTION")
