# wall following on the right side
from eye import *

SAFE = 180
speed = 200
old = SAFE

LCDMenu("", "", "", "END")
while KEYRead() != KEY4:
    f = PSDGet(PSD_FRONT)
    r = PSDGet(PSD_RIGHT)
    LCDSetPrintf(0, 0, "front %4d right %4d   ", f, r)
    if f < SAFE:
        VWTurn(90, 90)
        VWWait()
        old = PSDGet(PSD_RIGHT)
    else:
        diff = max(-60, min(60, SAFE - r))
        VWSetSpeed(speed, int(diff / 4) + 2 * max(-15, min(15, old - r)))
        old = r
    OSWait(20)
VWSetSpeed(0, 0)
print("end")
