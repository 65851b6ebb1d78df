#!/usr/bin/env python3
"""Holds spec_node.py to the dialogues of tests/data/protocol/can_dialogues.txt, as the firmware is, in made-up time.

usage: spec_rules.py
"""
import pathlib
import struct
import sys

from spec_drive import Body
from spec_node import Robot

DIALOGUES = pathlib.Path(__file__).parents[1] / "data/protocol/can_dialogues.txt"
STEP_MS, HEARTBEAT_MS, PATIENCE_MS = 10, 100, 300


class Dialogue:
    def __init__(self):
        self.ms = 0
        self.is_silent = False
        self.heard = []
        self.robot = Robot(1, Body(), self.take, 0.0)

    def take(self, packet):
        identifier, length = struct.unpack_from("=IB", packet)
        self.heard.append(f"{identifier:03X}#{packet[8:8 + length].hex().upper()}")

    def tell(self, frame):
        identifier, data = frame.split("#")
        is_remote = data == "R"
        data = b"" if is_remote else bytes.fromhex(data)
        packet = struct.pack("=IB3x8s", int(identifier, 16) | is_remote << 30, len(data), data)
        self.robot.hear(packet, self.ms / 1000)

    def step(self):
        if self.ms % HEARTBEAT_MS == 0 and not self.is_silent:
            self.tell("70F#05")
        self.ms += STEP_MS
        self.robot.go_on(self.ms / 1000)

    def wait(self, ms):
        for _ in range(0, ms, STEP_MS):
            self.step()
        self.heard.clear()

    def hear(self, pattern):
        """The next frame with the identifier of `pattern`; empty: none came."""
        for _ in range(0, PATIENCE_MS + 1, STEP_MS):
            found = next((frame for frame in self.heard if frame[:3] == pattern[:3]), "")
            if found:
                self.heard.remove(found)
                return found
            self.step()
        return ""


def matches(frame, pattern):
    return len(frame) == len(pattern) and all(p in (".", c) for c, p in zip(frame, pattern, strict=True))


def main():
    wrong = count = 0
    for line in DIALOGUES.read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        what, argument = line.split(maxsplit=1)
        found = ""
        if what == "dialogue":
            dialogue, title = Dialogue(), argument
            count += 1
        elif what == "send":
            dialogue.heard.clear()
            dialogue.tell(argument)
        elif what in ("wait", "silent"):
            dialogue.is_silent = what == "silent"
            dialogue.wait(int(argument))
        else:
            found = dialogue.hear(argument)
            if not matches(found, argument if what == "hear" else ""):
                print(f"{title}: {what} {argument}, found {found}")
                wrong += 1
    print(f"{count} dialogues, {wrong} lines wrong")
    return 0 if wrong == 0 and count >= 25 else 1


if __name__ == "__main__":
    sys.exit(main())
