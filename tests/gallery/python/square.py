from eye import *

def corner(n):
    x, y, phi = VWGetPosition()
    print("corner %d: %d %d %d" % (n, x, y, phi))
    LCDPrintf("corner %d: %d %d %d\n", n, x, y, phi)

VWSetPosition(0, 0, 0)
for i in range(4):
    VWStraight(400, 200)
    VWWait()
    VWTurn(90, 60)
    VWWait()
    corner(i)
VWCurve(300, 90, 150)
VWWait()
pos = VWGetPosition()
print("curve", pos[0], pos[1], pos[2], len(pos))
