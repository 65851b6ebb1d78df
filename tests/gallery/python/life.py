# game of life with an image made by hand
from eye import *
import random

N = 64
random.seed(5)
world = [[1 if random.random() < 0.3 else 0 for x in range(N)] for y in range(N)]

def step(w):
    new = []
    for y in range(N):
        row = []
        for x in range(N):
            n = sum(w[(y + j) % N][(x + i) % N] for j in (-1, 0, 1) for i in (-1, 0, 1)) - w[y][x]
            row.append(1 if n == 3 or (n == 2 and w[y][x]) else 0)
        new.append(row)
    return new

img = (ctypes.c_ubyte * (N * N))()
LCDImageStart(20, 20, N, N)
for gen in range(25):
    for y in range(N):
        for x in range(N):
            img[y * N + x] = world[y][x]
    LCDImageBinary(img)
    LCDSetPrintf(8, 0, "generation %d" % gen)
    world = step(world)
print("alive", sum(map(sum, world)))
