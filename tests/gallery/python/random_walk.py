from random import *
from eye import *
import time

seed(3)
LCDMenu("", "", "", "END")
f = open("walk.txt", "w")
for i in range(6):
    VWStraight(randint(100, 500), 250)
    while not VWDone():
        if PSDGet(PSD_FRONT) < 150:
            VWSetSpeed(0, 0)
            break
        time.sleep(0.02)
    VWTurn(randint(90, 270), 120)
    VWWait()
    x, y, phi = VWGetPosition()
    f.write("%d %d %d\n" % (x, y, phi))
    LCDPrintf("%d: %d %d %d\n", i, x, y, phi)
f.close()
print(len(open("walk.txt").readlines()), "lines")
