import numpy as np
from eye import *

CAMInit(QVGA)
img = np.asarray(CAMGet(), dtype=np.uint8).reshape(QVGA_Y, QVGA_X, 3)
print(img.shape, img.dtype)
row = img[200].astype(int).mean(axis=0)
print("row 200 has colour", bool(abs(row).max() > 0))
binary = (img[:, :, 0].astype(int) > 128).astype(np.uint8)
small = np.ascontiguousarray(binary[::2, ::2])
LCDImageStart(0, 0, 160, 120)
LCDImageBinary((ctypes.c_byte * small.size)(*small.flatten().tolist()))
hist = np.histogram(img[:, :, 1], bins=8, range=(0, 256))[0]
for i, n in enumerate(hist):
    LCDLine(200 + 12 * i, 120, 200 + 12 * i, 120 - n // 700, GREEN)   # n is a numpy integer
    LCDArea(200 + 12 * i, 125, np.int64(208 + 12 * i), 130, WHITE, 1)
LCDSetPrintf(12, 0, "%d of %d pixels", int(hist.sum()), QVGA_PIXELS)
