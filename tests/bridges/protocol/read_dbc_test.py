"""Reads our DBC files with canmatrix and decodes the golden frames with them: other eyes than ours.

read_dbc_test.py ROOT MAKE_DBC; needs the Debian package python3-canmatrix.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import canmatrix.formats

ROOT = pathlib.Path(sys.argv.pop(1))
MAKE_DBC = sys.argv.pop(1)
CLASSIC = ROOT / "bridges/protocol/eyebridge.dbc"
FD = ROOT / "bridges/protocol/eyebridge_fd.dbc"


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


class GoldenFrames(unittest.TestCase):
    def check(self, matrix, frame, data, signals):
        decoded = frame.decode(data)
        found = {name: float(decoded[name].phys_value) for name in decoded if name in signals}
        expected = {name: float(value) for name, value in signals.items()}
        self.assertEqual(found.keys(), expected.keys())
        for name, value in expected.items():
            self.assertAlmostEqual(found[name], value, places=6, msg=f"{frame.name}.{name}")

    def test_the_classic_file_gives_the_values_of_the_golden_frames(self):
        matrix = load(CLASSIC)
        frames = {frame.arbitration_id.id & 0x7F0: frame for frame in matrix.frames}
        checked = 0
        for identifier, data, is_fd, name, signals in golden():
            if is_fd:
                continue
            frame = frames[identifier & 0x7F0]
            self.assertEqual((frame.name, frame.size), (name, len(data)))
            self.check(matrix, frame, data, signals)
            checked += 1
        self.assertGreaterEqual(checked, 26)

    def test_the_fd_file_gives_the_values_of_the_golden_fd_frame(self):
        matrix = load(FD)
        checked = 0
        for _, data, is_fd, name, signals in golden():
            if not is_fd:
                continue
            frame = matrix.frame_by_name(name)
            self.assertTrue(frame.is_fd)
            self.assertEqual(frame.size, 64)
            self.check(matrix, frame, data, signals)
            checked += 1
        self.assertGreaterEqual(checked, 1)


class Files(unittest.TestCase):
    def test_cycle_times_and_senders_are_read(self):
        frame = load(CLASSIC).frame_by_name("S_Pose")
        self.assertEqual(frame.effective_cycle_time, 20)
        self.assertEqual(frame.transmitters, ["Robot"])
        self.assertFalse(frame.is_fd)
        self.assertEqual(load(CLASSIC).frame_by_name("C_VWSpeed").transmitters, ["Host"])

    def test_no_identifier_is_there_twice(self):
        for path in (CLASSIC, FD):
            identifiers = [frame.arbitration_id.id for frame in load(path).frames]
            self.assertEqual(len(identifiers), len(set(identifiers)))
            self.assertEqual(len(identifiers), 26)

    def test_a_file_for_many_robots_has_each_robots_identifiers(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "fourteen.dbc"
            subprocess.run([MAKE_DBC, "--robots", "14", path], check=True)
            matrix = load(path)
        # 25 kinds for each robot; C_Nmt and C_EStop to all, and the host's heartbeat.
        self.assertEqual(len(matrix.frames), 14 * 25 + 3)
        self.assertEqual(matrix.frame_by_name("R14_S_Pose").arbitration_id.id, 0x18E)
        self.assertEqual(matrix.frame_by_name("Host_Heartbeat").arbitration_id.id, 0x70F)

    def test_the_tool_refuses_what_it_cannot_do(self):
        for arguments in ([], ["--robots", "15", "x"], ["--robots", "x", "y"], ["--what"], ["a", "b"]):
            result = subprocess.run([MAKE_DBC, *arguments], capture_output=True, text=True)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn("usage", result.stderr)
        result = subprocess.run([MAKE_DBC, "/no/such/folder/x.dbc"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("/no/such/folder/x.dbc", result.stderr)


if __name__ == "__main__":
    unittest.main()
