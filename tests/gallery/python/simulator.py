from eye import *

[x, y, z, phi] = SIMGetRobot(1)
print("start", x.value, y.value, phi.value)
SIMSetRobot(0, 500, 600, 0, 45)
x, y, z, phi = SIMGetRobot(0)
print("moved", x, y, phi, x + 1)
SIMSetRobot(0, x.value, y.value, z.value, phi.value)
print("same", [int(v) for v in SIMGetRobot(0)] == [int(x), int(y), int(z), int(phi)])
for i in range(1, 4):
    pos = SIMGetObject(i)
    print("object", i, pos[0], pos[1])
SIMSetObject(1, 800, 900, 0, 0)
pos = SIMGetObject(1)
print("object 1 now", pos[0], pos[1])
VWSetSpeed(150, 0)
while PSDGet(PSD_FRONT) > 50 and OSGetCount() < 20000:
    OSWait(20)
VWSetSpeed(0, 0)
LCDPrintf("front %d\n", PSDGet(PSD_FRONT))
print("robots", SIMGetRobotCount(), "objects", SIMGetObjectCount())
