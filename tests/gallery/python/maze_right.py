# right hand rule in the small maze, 360 mm cells
from eye import *

DIR = [(0, 1), (-1, 0), (0, -1), (1, 0)]     # up, left, down, right
x, y, d = 0, 0, 0
way = [(0, 0)]

def free(sensor):
    return PSDGet(sensor) > 280

LCDMenu("GO", "", "", "END")
KEYWait(KEY1)
for step in range(40):
    if free(PSD_RIGHT):
        turn = -1
    elif free(PSD_FRONT):
        turn = 0
    elif free(PSD_LEFT):
        turn = 1
    else:
        turn = 2
    if turn:
        VWTurn(turn * 90, 120)
        VWWait()
        d = (d + turn) % 4
    VWStraight(360, 400)
    VWWait()
    x, y = x + DIR[d][0], y + DIR[d][1]
    way.append((x, y))
    LCDCircle(320 + 40 * x, 230 - 40 * y, 4, GREEN, 1)
    if (x, y) == (0, 0):
        break
print(len(way) - 1, "steps,", len(set(way)), "cells")
LCDSetPrintf(0, 0, "%s", str(way[:6]))
