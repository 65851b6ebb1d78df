from eye import *
from math import *

LCDMenu("", "", "", "END")
def draw(scan):
    LCDClear()
    for i in range(360):
        a = radians(180 - i)
        x = 270 - int(min(scan[i], 2000) / 12 * sin(a))
        y = 180 - int(min(scan[i], 2000) / 12 * cos(a))
        LCDPixel(x, y, WHITE)
    LCDCircle(270, 180, 8, RED, 1)

for n in range(3):
    scan = LIDARGet()
    draw(scan)
    print("front", scan[180], "left", scan[90], "right", scan[270], "back", scan[0])
    free = max(range(45, 315), key=lambda i: scan[i])
    VWTurn(180 - free, 60)
    VWWait()
    VWStraight(min(scan[free] - 300, 600), 200)
    VWWait()
LIDARSet(180, 0, 8)
print(len(LIDARGet()))
