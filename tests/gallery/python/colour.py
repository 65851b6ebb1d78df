# turn to the red can and stop: pixel loops in pure python
from eye import *

CAMWIDTH, CAMHEIGHT = 160, 120

def find_red(img):
    sum_x = n = 0
    for y in range(0, CAMHEIGHT, 2):
        for x in range(0, CAMWIDTH, 2):
            p = 3 * (y * CAMWIDTH + x)
            r = img[p] & 0xff
            g = img[p + 1] & 0xff
            b = img[p + 2] & 0xff
            if r > 120 and g < 80 and b < 80:
                sum_x += x
                n += 1
    return (sum_x // n, n) if n > 5 else (-1, 0)

CAMInit(QQVGA)
LCDImageStart(0, 0, CAMWIDTH, CAMHEIGHT)
for i in range(40):
    img = CAMGet()
    x, n = find_red(img)
    for y in range(CAMHEIGHT):          # paint a line into the picture
        if x >= 0:
            img[3 * (y * CAMWIDTH + x)] = 255
            img[3 * (y * CAMWIDTH + x) + 1] = 255
            img[3 * (y * CAMWIDTH + x) + 2] = 255
    LCDImage(img)
    if n and abs(x - CAMWIDTH // 2) < 6:
        print("in the middle")
        break
    VWTurn(20 if n == 0 else (CAMWIDTH // 2 - x) // 4, 60)
    VWWait()
else:
    print("not found")
LCDSetPrintf(10, 0, "%s", "red in the middle" if n else "nothing")
