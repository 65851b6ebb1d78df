# DistBug-like: goal in VW coordinates, class with a method per state
from eye import *
from math import atan2, degrees, hypot

class Bug:
    def __init__(self, gx, gy):
        self.gx, self.gy = gx, gy
        self.min_dist = 1e9
        self.state = self.drive
        VWSetPosition(0, 0, 0)

    def pose(self):
        x, y, phi = VWGetPosition()
        a = degrees(atan2(self.gy - y, self.gx - x)) - phi
        return hypot(self.gx - x, self.gy - y), (a + 180) % 360 - 180

    def drive(self):
        dist, a = self.pose()
        if dist < 60:
            return None
        if PSDGet(PSD_FRONT) < 130:
            self.min_dist = dist
            print("hit, still", round(dist, -2))
            VWTurn(-90, 90)
            VWWait()
            self.old = PSDGet(PSD_LEFT)
            return self.follow
        VWSetSpeed(200, int(a))
        return self.drive

    def follow(self):
        dist, a = self.pose()
        left, front = PSDGet(PSD_LEFT), PSDGet(PSD_FRONT)
        scan = LIDARGet()
        ahead = min(scan[int(180 - a + k) % 360] for k in range(-40, 41))    # the robot is wide
        self.min_dist = min(self.min_dist, dist)
        if dist - ahead < self.min_dist - 300:
            print("leave, still", round(dist, -2))
            VWTurn(int(a), 90)
            VWWait()
            return self.drive
        if front < 130:
            VWTurn(-90, 90)
            VWWait()
            self.old = PSDGet(PSD_LEFT)
        elif left > 400:
            VWSetSpeed(120, 45)
            self.old = 160
        else:
            VWSetSpeed(150, max(-45, min(45, (left - 160) // 4 + 2 * (left - self.old))))
            self.old = left
        return self.follow

bug = Bug(2200, 0)
n = 0
while bug.state and n < 3000:
    bug.state = bug.state()
    OSWait(30)
    n += 1
VWSetSpeed(0, 0)
print("arrived" if n < 3000 else "lost", VWGetPosition()[:2] is not None)
LCDPrintf("%s\n", "GOAL")
