"""The wheels of spec_node.py, and how it drives them; written from SPECIFICATION.md alone, as that."""
import math

IDLE, SPEED, RUNNING, DONE, ABORTED = range(5)


class Body:
    """Two wheels on a floor. Knows the truth; the robot only sees the encoders."""

    TICKS_PER_M, BASE, TOP = 6484.0, 0.09, 0.6

    def __init__(self):
        self.x = self.y = self.phi = self.path = 0.0
        self.rolled = [0.0, 0.0]  # metres

    def roll(self, left, right):
        way, turn = (left + right) / 2, (right - left) / self.BASE
        self.x += way * math.cos(self.phi + turn / 2)
        self.y += way * math.sin(self.phi + turn / 2)
        self.phi += turn
        self.path += abs(way)
        self.rolled[0] += left
        self.rolled[1] += right

    def ticks(self):
        return [math.floor(way * self.TICKS_PER_M) for way in self.rolled]


class Drive:
    """Speeds and moves."""

    LINEAR, ANGULAR = 1.0, 10.0  # accelerations, m/s² and rad/s²

    def __init__(self):
        self.state = IDLE
        self.v = self.w = 0.0
        self.target = (0.0, 0.0)
        self.raw = None  # wheel speeds of C_Motor, m/s
        self.left = 0.0

    def off(self):
        self.state = {RUNNING: ABORTED, SPEED: IDLE, DONE: IDLE}.get(self.state, self.state)
        self.v = self.w = 0.0
        self.target = (0.0, 0.0)
        self.raw = None

    def speed(self, v, w):
        self.raw, self.state, self.target = None, SPEED, (v, w)

    def move(self, distance, angle, speed):
        """`speed` is m/s along `distance`, or rad/s when there is none."""
        self.raw, self.target = None, (0.0, 0.0)
        self.total = abs(distance) or abs(angle)
        if speed == 0 or self.total == 0:
            self.state = DONE
            return
        self.v = self.w = 0.0
        self.state, self.left, self.pace = RUNNING, self.total, 0.0
        self.step, self.top = (self.LINEAR, min(speed, Body.TOP)) if distance else (self.ANGULAR, min(speed, 5.0))
        self.shares = (distance / self.total, angle / self.total)
        self.is_turn = distance == 0

    def motors(self, wheels):
        if self.raw is None:
            self.off()
            self.raw = [0.0, 0.0]
        for index, speed in wheels.items():
            self.raw[index] = speed

    def run(self, seconds):
        """How far each wheel rolls."""
        if self.raw is not None:
            self.v, self.w = sum(self.raw) / 2, (self.raw[1] - self.raw[0]) / Body.BASE
        elif self.state == RUNNING:
            self.pace = min(self.pace + self.step * seconds, self.top, math.sqrt(2 * self.step * self.left) + 1e-3)
            way = min(self.pace * seconds, self.left)
            self.left -= way
            self.v, self.w = (share * way / seconds for share in self.shares)
        else:
            self.v += max(-self.LINEAR * seconds, min(self.LINEAR * seconds, self.target[0] - self.v))
            self.w += max(-self.ANGULAR * seconds, min(self.ANGULAR * seconds, self.target[1] - self.w))
        wheels = [(self.v + sign * self.w * Body.BASE / 2) * seconds for sign in (-1, 1)]
        if self.state == RUNNING and self.left <= 0:
            self.state, self.v, self.w = DONE, 0.0, 0.0
        return wheels
