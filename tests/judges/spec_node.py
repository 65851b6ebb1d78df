#!/usr/bin/env python3
"""A robot on CAN, written from part 2 of bridges/protocol/SPECIFICATION.md and from nothing else of this project.

usage: spec_node.py --bus PATH [--node N]
Serves a bus on a Unix socket and is a robot on it, in real time. SIGTERM ends it; the last line tells the truth.
"""
import argparse
import math
import os
import select
import signal
import socket
import struct
import time

from spec_drive import RUNNING, Body, Drive

HOST = 15
BOOT, STOPPED, OPERATIONAL, STANDBY = 0, 4, 5, 127
ENABLE, STOP, GO_STANDBY, RESET = 1, 2, 0x80, 0x81
STRAIGHT, TURN = 1, 2
FRAME_LENGTH, BAD_VALUE = 0x8210, 0x8220
# Bits of Flags, the most important first, and their codes.
F_ESTOP, F_TWIN, F_HOST, F_TIMEOUT = 1, 2, 4, 8
CODES = {F_ESTOP: 0xFF01, F_TWIN: 0x8150, F_HOST: 0x8130, F_TIMEOUT: 0xFF02}
ABSENT = 0xFFFF
REMOTE = 1 << 30


def u(bits, first=0, last=None):
    """A signal: bits, signed, first and last value; each lies behind the one before."""
    return bits, False, first, (1 << bits) - 1 if last is None else last


def s(bits, first=None):
    return bits, True, -(1 << (bits - 1)) if first is None else first, (1 << (bits - 1)) - 1


# function: (bytes, signals)
COMMANDS = {
    0x00: (2, [u(8), u(8, 0, 14)]),
    0x01: (2, [u(8, 1, 3), u(8)]),
    0x20: (6, [s(16), s(16), u(8), u(8)]),
    0x21: (8, [u(8, 1, 4), u(8), s(16), s(16), s(16, 0)]),
    0x22: (8, [s(24), s(24), s(16)]),
    0x23: (8, [s(8), s(8), s(8), s(8), u(4), u(4, 0, 1), u(8)]),
    0x24: (4, [u(8, 1, 4), u(8), u(8), u(8)]),
    0x25: (8, [u(8, 0, 1)] + [u(8)] * 7),
    0x26: (4, [u(16), u(16)]),
    0x27: (2, [u(8, 0, 15), u(8, 0, 3)]),
}
HEARTBEAT, VERSION, FAULT, POSE, MOTION, ENC12, ENC34 = 0x70, 0x48, 0x08, 0x18, 0x19, 0x1A, 0x1B
PSDS, DIGITAL, ANALOGS, BOARD = (0x1C, 0x1D, 0x1E), 0x1F, (0x28, 0x29), 0x2A
WORDS = [u(16)] * 4
# function: (seconds, signals)
STATUS = {
    FAULT: (1.0, [u(16), u(8), u(16), u(24)]),
    POSE: (0.02, [s(24), s(24), s(16)]),
    MOTION: (0.02, [s(16), s(16), u(4), u(1), u(1), u(1), u(1), u(8), s(16)]),
    ENC12: (0.02, [s(32), s(32)]),
    ENC34: (0.1, [s(32), s(32)]),
    **dict.fromkeys(PSDS, (0.05, WORDS)),
    DIGITAL: (0.05, WORDS[:3]),
    **dict.fromkeys(ANALOGS, (0.1, WORDS)),
    BOARD: (0.1, [u(16), u(16), u(8), u(24)]),
    VERSION: (5.0, [*[u(8)] * 6, u(16)]),
    HEARTBEAT: (0.1, [u(8)]),
}


def pack(signals, values):
    bits = at = 0
    for (width, _, first, last), value in zip(signals, values, strict=True):
        assert first <= value <= last, (signals, values)
        bits |= (value & ((1 << width) - 1)) << at
        at += width
    return bits.to_bytes((at + 7) // 8, "little")


def unpack(signals, data):
    """The values; None when one is refused."""
    bits = int.from_bytes(data, "little")
    values = []
    for width, signed, first, last in signals:
        value = bits & ((1 << width) - 1)
        bits >>= width
        if signed and value >> (width - 1):
            value -= 1 << width
        if not first <= value <= last:
            return None
        values.append(value)
    return values


class Robot:
    def __init__(self, node, body, send, now):
        self.node, self.body, self.send_bytes = node, body, send
        self.refused = 0
        self.restart(now)

    def restart(self, now):
        self.started = self.last = now
        self.state = BOOT
        self.drive = Drive()
        self.zero_ticks = self.last_ticks = self.body.ticks()
        self.pose = [0.0, 0.0, 0.0]  # mm, mm, rad
        self.ports = {"out": 0, "outputs": 0}
        self.last_seq, self.seq_counts = 0, False
        self.flags = self.told_flags = 0
        self.events, self.event_told = [], False
        self.host = self.estop = self.twin = self.faulted = -math.inf
        self.commanded = None  # since when a speed or duty must be repeated
        self.timed_out = False
        self.due = {function: now + period for function, (period, _) in STATUS.items() if function != FAULT}
        self.send(HEARTBEAT)
        self.enter(STANDBY)
        self.send(VERSION)

    # ---- what it says ----

    def send(self, function):
        data = pack(STATUS[function][1], self.values(function))
        self.send_bytes(struct.pack("=IB3x8s", function << 4 | self.node, len(data), data))

    def values(self, function):
        if function == HEARTBEAT:
            return [self.state]
        if function == VERSION:
            return [1, *b"spec", 128, 1]
        if function == POSE:
            x, y, phi = self.pose
            return [round(x), round(y), (round(math.degrees(phi) * 100) + 18000) % 36000 - 18000]
        if function == MOTION:
            drive = self.drive
            left = drive.left * 1000 if drive.state == RUNNING and not drive.is_turn else 0
            return [round(drive.v * 1000), round(math.degrees(drive.w) * 100), drive.state, 0, 0, int(self.state == OPERATIONAL),
                    int(self.timed_out), self.last_seq, round(left)]
        if function == ENC12:
            return [now - zero for now, zero in zip(self.body.ticks(), self.zero_ticks, strict=True)]
        if function == ENC34:
            return [0, 0]
        if function == DIGITAL:
            out = self.ports["out"] & self.ports["outputs"]
            return [out, out, self.ports["outputs"]]
        if function == BOARD:
            return [ABSENT, ABSENT, 0, int((self.last - self.started) * 10) & 0xFFFFFF]
        if function == FAULT:
            return self.fault_values()
        return [ABSENT] * 4  # it has neither PSDs nor a converter

    def fault_values(self):
        if self.events:
            code, aux = self.events.pop(0)
            self.event_told = True
        else:
            code, aux = next((code for bit, code in CODES.items() if self.flags & bit), 0), 0
            self.event_told, self.told_flags = False, self.flags
        return [code, 0 if code == 0 else 1 | 16, self.flags, aux]

    # ---- what it is told ----

    def enter(self, state):
        if state != self.state:
            self.state = state
            self.send(HEARTBEAT)

    def leave(self, state):
        self.drive.off()
        self.commanded, self.timed_out = None, False
        self.enter(state)

    def hear(self, packet, now):
        if len(packet) != 16:
            return
        identifier, length = struct.unpack_from("=IB", packet)
        function, node, data = (identifier & 0x7FF) >> 4, identifier & 0xF, packet[8:8 + length]
        if identifier & REMOTE:
            if identifier & ~REMOTE == VERSION << 4 | self.node:
                self.send(VERSION)
            return
        if identifier > 0x7FF:
            return
        if function == HEARTBEAT and node == HOST:
            if data[:1] and data[0] in (BOOT, STOPPED, OPERATIONAL, STANDBY):
                self.host = now
        elif function in STATUS and node == self.node:
            self.twin = now
            self.flags |= F_TWIN
            if self.state == OPERATIONAL:
                self.leave(STANDBY)
        elif function in COMMANDS and node in {0: (0,), 1: (0, self.node)}.get(function, (self.node,)):
            self.hear_command(function, identifier, data, now)

    def hear_command(self, function, identifier, data, now):
        length, signals = COMMANDS[function]
        if len(data) < length:
            self.refuse(FRAME_LENGTH, identifier | len(data) << 16)
            return
        v = unpack(signals, data)
        bad_command = v is not None and function == 0 and v[0] not in (ENABLE, STOP, GO_STANDBY, RESET)
        bad_duty = v is not None and function == 0x23 and v[5] == 0 and any(abs(duty) > 100 for duty in v[:4])
        if v is None or bad_command or bad_duty:
            self.refuse(BAD_VALUE, identifier)
        else:
            self.obey(function, v, now)

    def refuse(self, code, aux):
        self.refused += 1
        self.events.append((code, aux))

    def obey(self, function, v, now):
        if function == 0x00 and v[1] in (0, self.node):
            self.switch(v[0], now)
        elif function == 0x01:
            self.estop = now
            self.flags |= F_ESTOP
            self.leave(STOPPED)
        elif function == 0x22:
            self.pose = [float(v[0]), float(v[1]), math.radians(v[2] * 0.01)]
            self.send(POSE)
        elif function == 0x27:
            bit = 1 << v[0]
            self.ports["outputs"] = self.ports["outputs"] | bit if v[1] == 1 else self.ports["outputs"] & ~bit
            self.send(DIGITAL)
        elif self.state == OPERATIONAL:
            self.act(function, v, now)

    def switch(self, command, now):
        if command == ENABLE:
            if now - self.estop < 0.5 or now - self.twin < 1.0:
                return
            self.flags &= ~(F_ESTOP | F_TWIN | F_HOST | F_TIMEOUT)
            if self.state != OPERATIONAL:
                self.host, self.seq_counts = now, False
                self.leave(OPERATIONAL)
        elif command == RESET:
            self.restart(now)
        else:
            self.leave(STOPPED if command == STOP else STANDBY)

    def act(self, function, v, now):
        if function == 0x26:
            self.ports["out"] = self.ports["out"] & ~v[0] | v[1] & v[0]
            self.send(DIGITAL)
            return
        if function not in (0x20, 0x21, 0x23) or (function == 0x21 and self.seq_counts and v[1] == self.last_seq):
            return
        self.timed_out = False
        self.flags &= ~F_TIMEOUT
        self.commanded = None if function == 0x21 else now
        if function == 0x20:
            self.drive.speed(v[0] / 1000, math.radians(v[1] * 0.01))
        elif function == 0x23:
            scale = Body.TOP / 100 if v[5] == 0 else 100 / Body.TICKS_PER_M
            self.drive.motors({i: v[i] * scale for i in range(2) if v[4] >> i & 1})
        else:
            distance = 0 if v[0] == TURN else v[2] / 1000
            angle = 0 if v[0] == STRAIGHT else math.radians(v[3] * 0.1)
            self.drive.move(distance, angle, v[4] / 1000 if distance else math.radians(v[4]))
            self.last_seq, self.seq_counts = v[1], True
            self.send(MOTION)

    # ---- time ----

    def go_on(self, now):
        if now > self.last:
            self.body.roll(*self.drive.run(now - self.last))
        self.last = now
        ticks = self.body.ticks()
        left, right = ((new - old) / Body.TICKS_PER_M for new, old in zip(ticks, self.last_ticks, strict=True))
        self.last_ticks = ticks
        turn = (right - left) / Body.BASE
        heading = self.pose[2] + turn / 2
        self.pose[0] += (left + right) * 500 * math.cos(heading)
        self.pose[1] += (left + right) * 500 * math.sin(heading)
        self.pose[2] += turn
        self.supervise(now)
        for function, due in self.due.items():
            if now >= due:
                self.due[function] = max(due + STATUS[function][0], now)
                self.send(function)
        changed = self.events or self.event_told or self.flags != self.told_flags
        if now - self.faulted >= (0.02 if changed else 1.0) and (changed or self.flags):
            self.faulted = now
            self.send(FAULT)

    def supervise(self, now):
        if self.state != OPERATIONAL:
            return
        if now - self.host >= 0.3:
            self.flags |= F_HOST
            self.leave(STANDBY)
        elif self.commanded is not None and now - self.commanded >= 0.25 and not self.timed_out:
            self.timed_out = True
            self.flags |= F_TIMEOUT
            if self.drive.raw is not None:
                self.drive.off()
            else:
                self.drive.speed(0.0, 0.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bus", required=True, metavar="PATH")
    parser.add_argument("--node", type=int, default=1, choices=range(1, 15))
    parser.add_argument("--log", type=argparse.FileType("w"), help="tells when the wheels begin to turn and when they stand")
    options = parser.parse_args()
    ended = []
    signal.signal(signal.SIGTERM, lambda *_: ended.append(True))
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    listener.bind(options.bus)
    listener.listen()
    others = []

    def pass_on(packet, to):
        for other in to:
            try:
                other.send(packet, socket.MSG_DONTWAIT)
            except OSError:
                pass  # gone, or too slow: as on a bus

    body = Body()
    robot = Robot(options.node, body, lambda packet: pass_on(packet, others), time.monotonic())
    print(f"bus at {options.bus}", flush=True)
    rolls = False
    while not ended:
        for ready in select.select([listener, *others], [], [], 0.005)[0]:
            if ready is listener:
                others.append(listener.accept()[0])
                continue
            try:
                packet = ready.recv(72)
            except ConnectionResetError:
                continue  # it had not read all that was sent to it; what it has sent is still there
            except OSError:
                packet = b""
            if not packet:
                others.remove(ready)
                continue
            pass_on(packet, [other for other in others if other is not ready])
            robot.hear(packet, time.monotonic())
        robot.go_on(time.monotonic())
        if options.log and rolls != (robot.drive.v != 0 or robot.drive.w != 0):
            rolls = not rolls
            print(f"{time.monotonic():.4f} {'ROLLS' if rolls else 'STANDS'}", file=options.log, flush=True)
    os.unlink(options.bus)
    print(f"end: truth x={body.x * 1000:.1f} y={body.y * 1000:.1f} mm phi={math.degrees(body.phi):.2f} deg "
          f"path={body.path * 1000:.1f} mm refused={robot.refused}")


if __name__ == "__main__":
    main()
