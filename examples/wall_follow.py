#!/usr/bin/env python3
"""Drives to the first wall ahead and follows it on its left at 150 mm, until KEY4 is pressed or a minute is over.

Proportional-derivative steering on the left PSD; a wall ahead is turned away from on the spot.
"""

from eye import *

KEEP_MM = 150
SPEED_MM_S = 150
FRONT_STOP_MM = 120
PERIOD_MS = 50


def limit(value, most):
    return max(-most, min(most, value))


LCDMenu("", "", "", "END")
last = KEEP_MM
found = False
step = 0
while KEYRead() != KEY4 and OSGetCount() < 60000:
    left = PSDGet(PSD_LEFT)
    front = PSDGet(PSD_FRONT)
    if front < FRONT_STOP_MM:
        VWTurn(-90, 90)  # to the right, along the wall
        VWWait()
        left = PSDGet(PSD_LEFT)
        found = True
    elif not found:
        VWSetSpeed(SPEED_MM_S, 0)
    else:
        error = limit(left - KEEP_MM, 100)
        rate = limit(left, 300) - limit(last, 300)
        VWSetSpeed(SPEED_MM_S, limit(error / 4 + 2 * rate, 60))
    last = left
    step += 1
    if step % 10 == 0:
        LCDSetPrintf(0, 0, "left %4d  front %4d ", left, front)
    OSWait(PERIOD_MS)

VWSetSpeed(0, 0)
LCDSetPrintf(1, 0, "stopped")
x, y, phi = VWGetPosition()
print(f"stopped at {x} {y}, {phi} deg")
