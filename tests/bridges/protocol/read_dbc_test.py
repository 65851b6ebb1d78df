"""Reads our DBC files with canmatrix and decodes the golden frames with them: other eyes than ours.

read_dbc_test.py ROOT MAKE_PROTOCOL; needs the Debian package python3-canmatrix.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import canmatrix.formats

ROOT = pathlib.Path(sys.argv.pop(1))
MAKE_PROTOCOL = sys.argv.pop(1)
CLASSIC = ROOT / "bridges/protocol/eyebridge.dbc"
FD = ROOT / "bridges/protocol/eyebridge_fd.dbc"

EVENTS = {
    "C_Nmt", "C_VWMove", "C_SetPose", "C_Pid", "C_Digital", "C_DigitalCfg", "S_LidarHdr", "S_LidarChunk", "S_Zones",
}  # fmt: skip
VALUES = {
    ("Heartbeat", "State"): {0: "BOOT", 4: "STOPPED", 5: "OPERATIONAL", 127: "STANDBY"},
    ("C_EStop", "Reason"): {1: "USER", 2: "PROGRAM_END", 3: "HOST_FAULT"},
    ("S_Fault", "Code"): {
        0: "NONE", 0x3120: "LOW_BATTERY", 0x7121: "MOTOR_BLOCKED", 0x8130: "HOST_LOST", 0x8140: "BUS_OFF_RECOVERED",
        0x8150: "DUPLICATE_NODE", 0x8210: "FRAME_LENGTH", 0x8220: "BAD_VALUE", 0xFF01: "ESTOP", 0xFF02: "COMMAND_TIMEOUT"},
    ("S_Speed", "MoveState"): {0: "IDLE", 1: "SPEED", 2: "RUNNING", 3: "DONE", 4: "ABORTED"},
    ("C_VWMove", "Type"): {1: "STRAIGHT", 2: "TURN", 3: "CURVE", 4: "DRIVE"},
    ("C_Motor", "Mode"): {0: "PERCENT", 1: "TICKS"},
    ("C_DigitalCfg", "Mode"): {0: "INPUT", 1: "OUTPUT", 2: "PULL_UP", 3: "PULL_DOWN"},
    ("S_Version", "Hardware"): {0: "UNKNOWN", 1: "EYEBOT_IO"},
    ("S_Version", "Capabilities"): {1: "MOVES", 2: "SCANS", 256: "ZONES"},
    ("S_PsdA", "Psd4"): {9999: "OUT_OF_RANGE", 65535: "ABSENT"},
    ("S_Status", "Battery"): {65535: "ABSENT"},
    ("S_Pose", "X"): {},
}


def load(path):
    return canmatrix.formats.loadp_flat(str(path))


def golden():
    """Yields identifier, data, FD or not, name, and signals with physical values as text."""
    for line in (ROOT / "tests/data/protocol/can.hex").read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        frame, name, *signals = line.split()
        identifier, data = frame.split("#", 1)
        is_fd = data.startswith("#")
        data = bytes.fromhex(data[2:] if is_fd else data)
        yield int(identifier, 16), data, is_fd, name, dict(s.split("=") for s in signals)


def owner(identifier):
    """What the table's names are prefixed with for this identifier."""
    node = identifier & 0xF
    return {0: "", 15: "Host_"}.get(node, f"R{node}_")


class GoldenFrames(unittest.TestCase):
    def check(self, matrix, is_fd):
        frames = {frame.arbitration_id.id: frame for frame in matrix.frames}
        checked = 0
        for identifier, data, golden_is_fd, name, signals in golden():
            if golden_is_fd != is_fd:
                continue
            frame = frames[identifier]
            self.assertEqual((frame.name, frame.size, frame.is_fd), (owner(identifier) + name, len(data), is_fd))
            decoded = frame.decode(data)
            found = {name: float(decoded[name].phys_value) for name in decoded if name in signals}
            expected = {name: float(value) for name, value in signals.items()}
            self.assertEqual(found.keys(), expected.keys())
            for signal, value in expected.items():
                self.assertAlmostEqual(found[signal], value, places=6, msg=f"{frame.name}.{signal}")
            checked += 1
        return checked

    def test_the_classic_file_gives_the_values_of_the_golden_frames(self):
        self.assertGreaterEqual(self.check(load(CLASSIC), False), 26)

    def test_the_fd_file_gives_the_values_of_the_golden_fd_frame(self):
        self.assertGreaterEqual(self.check(load(FD), True), 1)

    def test_values_are_read_with_their_names(self):
        frame = load(CLASSIC).frame_by_name("R1_S_Speed")
        decoded = frame.decode(bytes.fromhex("06FF9411621124FA"))
        self.assertEqual(decoded["MoveState"].named_value, "RUNNING")


class Files(unittest.TestCase):
    def test_each_robot_and_the_host_have_their_identifiers(self):
        for path in (CLASSIC, FD):
            matrix = load(path)
            identifiers = [frame.arbitration_id.id for frame in matrix.frames]
            self.assertEqual(len(identifiers), len(set(identifiers)))
            # 25 kinds for each robot; C_Nmt and C_EStop to all, and the host's heartbeat.
            self.assertEqual(len(identifiers), 14 * 26 + 3)
            self.assertEqual([ecu.name for ecu in matrix.ecus], ["Host", *(f"Robot{n}" for n in range(1, 15))])
            self.assertIn("digit E", matrix.ecu_by_name("Robot14").comment)
            self.assertEqual(matrix.frame_by_name("R14_S_Pose").arbitration_id.id, 0x18E)
            self.assertEqual(matrix.frame_by_name("Host_Heartbeat").arbitration_id.id, 0x70F)

    def test_cycle_times_senders_and_receivers_are_read(self):
        matrix = load(CLASSIC)
        frame = matrix.frame_by_name("R3_S_Pose")
        self.assertEqual(frame.effective_cycle_time, 20)
        self.assertEqual((frame.transmitters, frame.receivers), (["Robot3"], ["Host"]))
        self.assertFalse(frame.is_fd)
        self.assertEqual(matrix.frame_by_name("R3_C_VWSpeed").transmitters, ["Host"])
        self.assertEqual(len(matrix.frame_by_name("C_EStop").receivers), 14)
        for frame in matrix.frames:
            name = re.sub(r"^(R\d+|Host)_", "", frame.name)
            self.assertEqual(frame.effective_cycle_time == 0, name in EVENTS, frame.name)

    def test_value_tables_are_read_for_every_robot(self):
        matrix = load(CLASSIC)
        for node in range(1, 15):
            for (frame, signal), values in VALUES.items():
                found = matrix.frame_by_name(f"R{node}_{frame}").signal_by_name(signal).values
                self.assertEqual(found, values, f"{node} {frame} {signal}")
        found = matrix.frame_by_name("C_Nmt").signal_by_name("Command").values
        self.assertEqual(found, {1: "ENABLE", 2: "STOP", 128: "STANDBY", 129: "RESET"})

    def test_messages_and_signals_have_comments(self):
        matrix = load(FD)
        for frame in matrix.frames:
            self.assertTrue(frame.comment, frame.name)
        for frame in ("R7_S_Fault", "R7_S_Version", "R7_S_Speed"):
            commented = [signal for signal in matrix.frame_by_name(frame).signals if signal.comment]
            self.assertGreaterEqual(len(commented), 4, frame)
        capabilities = matrix.frame_by_name("R7_S_Version").signal_by_name("Capabilities")
        self.assertIn("Sum of bits. MOVES: Executes C_VWMove", capabilities.comment)

    def test_a_file_for_tools_that_mask_the_node_has_one_robot(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "one.dbc"
            subprocess.run([MAKE_PROTOCOL, "--robots", "0", path], check=True)
            matrix = load(path)
        self.assertEqual(len(matrix.frames), 27)
        self.assertEqual(matrix.frame_by_name("S_Pose").arbitration_id.id, 0x181)


class Tool(unittest.TestCase):
    def test_it_mends_what_was_edited_by_hand(self):
        names = ["opcodes.h", "SPECIFICATION.md", "eyebridge.dbc", "eyebridge_fd.dbc"]
        room = ROOT / "bridges/protocol"
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for name in names:
                text = (room / name).read_text()
                self.assertIn("STANDBY", text)
                (folder / name).write_text(text.replace("STANDBY", "SLEEP", 1))
            # The first STANDBY of the text is prose, which the tool leaves alone.
            (folder / "SPECIFICATION.md").write_text((room / "SPECIFICATION.md").read_text().replace("`EYECAN_NMT_", "`E_"))
            subprocess.run([MAKE_PROTOCOL, "--update", folder], check=True)
            for name in names:
                self.assertEqual((folder / name).read_text(), (room / name).read_text(), name)

    def test_it_refuses_what_it_cannot_do(self):
        for arguments in ([], ["--robots", "15", "x"], ["--robots", "x", "y"], ["--what"], ["a", "b"], ["--update"]):
            result = subprocess.run([MAKE_PROTOCOL, *arguments], capture_output=True, text=True)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn("usage", result.stderr)
        for arguments in (["/no/such/folder/x.dbc"], ["--update", "/no/such/folder"]):
            result = subprocess.run([MAKE_PROTOCOL, *arguments], capture_output=True, text=True)
            self.assertEqual(result.returncode, 1)
            self.assertIn("/no/such/folder/", result.stderr)


if __name__ == "__main__":
    unittest.main()
