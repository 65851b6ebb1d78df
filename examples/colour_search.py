#!/usr/bin/env python3
"""Turns until it sees something red with the camera, drives up to it and stops in front of it.

What is red is counted by column; the middle of the reddest columns is steered to.
"""

from eye import *

STOP_MM = 150
ENOUGH = 8  # red pixels in a column


def red_columns(image):
    """How many pixels of each column are red."""
    count = [0] * QQVGA_X
    for i in range(0, QQVGA_SIZE, 3):
        r, g, b = image[i] & 0xFF, image[i + 1] & 0xFF, image[i + 2] & 0xFF
        if r > 100 and r > 2 * g and r > 2 * b:
            count[i // 3 % QQVGA_X] += 1
    return count


CAMInit(QQVGA)
LCDMenu("", "", "", "END")
while KEYRead() != KEY4 and OSGetCount() < 60000:
    image = CAMGet()
    LCDImage(image)
    columns = [x for x, count in enumerate(red_columns(image)) if count >= ENOUGH]
    if not columns:
        VWTurn(30, 90)  # look elsewhere
        VWWait()
        continue
    offset = QQVGA_X // 2 - sum(columns) // len(columns)
    if abs(offset) < 20 and PSDGet(PSD_FRONT) < STOP_MM:
        VWSetSpeed(0, 0)
        print("found it")
        break
    VWSetSpeed(150, offset / 2)
else:
    VWSetSpeed(0, 0)
    print("gave up")
