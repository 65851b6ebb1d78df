"""CAM and IP: camera and image processing. Images are ctypes arrays of signed bytes, as programs expect: mask with
& 0xff, or numpy.frombuffer(image, numpy.uint8). Wherever one is read, whatever LCDImage() takes will do."""

import ctypes as _ctypes

from . import _convert
from ._library import C as _C
from ._library import variable as _variable
from ._readings import failure as _failure

_colour_bytes = _variable("CAMSIZE")
_grey_bytes = _variable("CAMPIXELS")
_ip_pixels = _variable("IP_PIXELS")
_types = {}


def _array(size):
    kind = _types.get(size)
    if kind is None:
        kind = _types[size] = _ctypes.c_byte * size
    return kind()


def CAMInit(resolution):
    """Starts the camera in a mode (QQVGA, QVGA, VGA …) and sets CAMWIDTH and friends. 0; 1 without a camera or for a
    mode that it cannot do."""
    return _C.CAMInit(resolution)


def CAMRelease():
    """Stops the camera. 0."""
    return _C.CAMRelease()


def CAMGet():
    """Waits for the next colour frame: CAMSIZE bytes R, G, B in a new array. RobotError when there is none: no
    CAMInit(), no camera, a camera that is lost."""
    image = _array(_colour_bytes.value)
    if _C.CAMGet(image) != 0:
        raise _failure("CAMGet")
    return image


def CAMGetGray():
    """Waits for the next frame in grey: CAMPIXELS bytes in a new array. Fails as CAMGet()."""
    image = _array(_grey_bytes.value)
    if _C.CAMGetGray(image) != 0:
        raise _failure("CAMGetGray")
    return image


def IPSetSize(resolution):
    """Mode of the images that IP functions work on; CAMInit() sets it, too. 1 for an unknown mode."""
    return _C.IPSetSize(resolution)


def IPReadFile(filename):
    """Reads a PNM file into an image of the IP size: [result, image]. result is 3 for colour (three bytes a pixel),
    2 for grey, 1 for black and white (one byte a pixel), -1 on failure."""
    image = _array(3 * _ip_pixels.value)
    result = _C.IPReadFile(filename, image)
    if result in (1, 2):
        image = (_ctypes.c_byte * _ip_pixels.value).from_buffer(image)
    return [result, image]


def IPWriteFile(filename, img):
    """Writes a colour image of the IP size as PPM. 0, or 1 on failure."""
    return _C.IPWriteFile(filename, _colour("IPWriteFile", img))


def IPWriteFileGray(filename, gray):
    """Writes a grey image of the IP size as PGM. 0, or 1 on failure."""
    return _C.IPWriteFileGray(filename, _grey("IPWriteFileGray", gray))


def _colour(call, image):
    return _convert.image_in(call, image, 3 * _ip_pixels.value)


def _grey(call, image):
    return _convert.image_in(call, image, _ip_pixels.value)


def _result(call, given, bytes_per_pixel):
    """Where the result goes, and what is returned: the program's own object if it gave one."""
    place = _convert.image_out(call, given, bytes_per_pixel * _ip_pixels.value)
    return place, place if given is None else given


def IPLaplace(grayIn, grayOut=None):
    """Edges of a grey image, in a new image (or in grayOut)."""
    place, image = _result("IPLaplace", grayOut, 1)
    _C.IPLaplace(_grey("IPLaplace", grayIn), place)
    return image


def IPSobel(grayIn, grayOut=None):
    """Edges of a grey image, in a new image (or in grayOut)."""
    place, image = _result("IPSobel", grayOut, 1)
    _C.IPSobel(_grey("IPSobel", grayIn), place)
    return image


def IPCol2Gray(imgIn, grayOut=None):
    """Grey = mean of R, G and B, in a new image (or in grayOut)."""
    place, image = _result("IPCol2Gray", grayOut, 1)
    _C.IPCol2Gray(_colour("IPCol2Gray", imgIn), place)
    return image


def IPGray2Col(imgIn, colOut=None):
    """A grey image as a colour image, in a new image (or in colOut)."""
    place, image = _result("IPGray2Col", colOut, 3)
    _C.IPGray2Col(_grey("IPGray2Col", imgIn), place)
    return image


def IPRGB2Col(r, g, b, imgOut=None):
    """Three planes as one colour image, in a new image (or in imgOut)."""
    place, image = _result("IPRGB2Col", imgOut, 3)
    _C.IPRGB2Col(_grey("IPRGB2Col", r), _grey("IPRGB2Col", g), _grey("IPRGB2Col", b), place)
    return image


def IPCol2HSI(img, h=None, s=None, i=None):
    """Hue, saturation and intensity of a colour image: [h, s, i], new images (or those given)."""
    planes = [_result("IPCol2HSI", given, 1) for given in (h, s, i)]
    _C.IPCol2HSI(_colour("IPCol2HSI", img), *(place for place, _ in planes))
    return [image for _, image in planes]


def IPOverlay(c1, c2, cOut=None):
    """c1 where c2 is black, else c2, in a new colour image (or in cOut)."""
    place, image = _result("IPOverlay", cOut, 3)
    _C.IPOverlay(_colour("IPOverlay", c1), _colour("IPOverlay", c2), place)
    return image


def IPOverlayGray(g1, g2, col, cOut=None):
    """g1 as grey where g2 is 0, else the colour col, in a new colour image (or in cOut)."""
    place, image = _result("IPOverlayGray", cOut, 3)
    _C.IPOverlayGray(_grey("IPOverlayGray", g1), _grey("IPOverlayGray", g2), col, place)
    return image


def IPPRGB2Col(r, g, b):
    """0xRRGGBB of three bytes."""
    return _C.IPPRGB2Col(r, g, b)


def _three(function, colour, given):
    if all(place is None for place in given):
        three = (_ctypes.c_ubyte * 3)()
        function(*colour, three, _ctypes.byref(three, 1), _ctypes.byref(three, 2))
        return three[:]
    return function(*colour, *(_convert.out(place, _ctypes.c_ubyte) for place in given))


def IPPCol2RGB(col, r=None, g=None, b=None):
    """[r, g, b] of 0xRRGGBB. Given three ctypes bytes or pointers, fills them in."""
    return _three(_C.IPPCol2RGB, (col,), (r, g, b))


def IPPCol2HSI(c, h=None, s=None, i=None):
    """[hue, saturation, intensity] of 0xRRGGBB, 0..255. Given three ctypes bytes or pointers, fills them in."""
    return _three(_C.IPPCol2HSI, (c,), (h, s, i))


def IPPRGB2Hue(r, g, b):
    """Hue 1..255 of a colour, 0 for grey."""
    return _C.IPPRGB2Hue(r, g, b)


def IPPRGB2HSI(r, g, b, h=None, s=None, i=None):
    """[hue, saturation, intensity] of a colour, 0..255. Given three ctypes bytes or pointers, fills them in."""
    return _three(_C.IPPRGB2HSI, (r, g, b), (h, s, i))
