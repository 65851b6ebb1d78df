"""Compares our reader of DBC files with canmatrix: the same messages, the same values of random frames.

judge_test.py ROOT DBC_VALUES [FILE …]; needs the Debian package python3-canmatrix. FILEs are judged as well.
"""

import logging
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

import canmatrix
import canmatrix.formats

logging.disable(logging.CRITICAL)
ROOT = pathlib.Path(sys.argv.pop(1))
DBC_VALUES = sys.argv.pop(1)
MORE = [pathlib.Path(name) for name in sys.argv[1:] if name.lower().endswith(".dbc")]
sys.argv = [name for name in sys.argv if not name.lower().endswith(".dbc")]
FRAMES = 40  # of each message
J1939 = pathlib.Path(canmatrix.__file__).parent / "j1939.dbc"  # as its package has it


def encoding_of(path):
    try:
        path.read_text("utf-8")
    except UnicodeDecodeError:
        return "cp1252"
    return "utf-8"


def number_of(frame):
    return frame.arbitration_id.id | (0x80000000 if frame.arbitration_id.extended else 0)


def fits(signal, size):
    """Whether all its bits are in a frame of `size` bytes: others we never find, and canmatrix stumbles over them."""
    start = signal.get_startbit(bit_numbering=1)
    first = start if signal.is_little_endian else start // 8 * 8 + 7 - start % 8
    return signal.size <= 64 and first + signal.size <= 8 * size


def ours(path, frames):
    text = "".join(f"{number:x} {data.hex()}\n" for number, data in frames)
    done = subprocess.run([DBC_VALUES, path], input=text, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    blocks = done.stdout.split("-\n")
    head = [line.split("\t") for line in blocks[0].splitlines()]
    return head, [[line.split("\t") for line in block.splitlines()] for block in blocks[1 : len(frames) + 1]]


class Judge(unittest.TestCase):
    def judge(self, path, least):
        matrix = canmatrix.formats.loadp_flat(str(path), dbcImportEncoding=encoding_of(path))
        for frame in matrix.frames:
            frame.signals = [signal for signal in frame.signals if fits(signal, frame.size)]
        source = random.Random(1)
        usable = [f for f in matrix.frames if 0 < f.size <= 64 and f.name != "VECTOR__INDEPENDENT_SIG_MSG"]
        frames = [(f, source.randbytes(f.size)) for f in usable for _ in range(FRAMES)]
        head, found = ours(path, [(number_of(f), data) for f, data in frames])
        self.assertLessEqual({f.name for f in usable}, {words[0] for words in head})
        values = 0
        for (frame, data), block in zip(frames, found, strict=True):
            mine = {(name, signal): (raw, value) for name, signal, raw, value in block}
            theirs = {(frame.name, name): value for name, value in self.decode(frame, data)}
            self.assertEqual(mine.keys(), theirs.keys(), f"{path} {frame.name} {data.hex()}")
            for key, (raw, value) in mine.items():
                decoded = theirs[key]
                expected = float(decoded.raw_value) * float(decoded.signal.factor) + float(decoded.signal.offset)
                where = f"{path} {key} {data.hex()}"
                if not decoded.signal.is_float:
                    mask = (1 << decoded.signal.size) - 1
                    self.assertEqual(int(raw), int(decoded.raw_value) & mask, where)
                if math.isfinite(expected) and abs(expected) < 1e300:
                    self.assertTrue(math.isclose(float(value), expected, rel_tol=1e-6, abs_tol=1e-9), where)
                values += 1
        self.assertGreaterEqual(values, least)
        print(f"{path.name}: {len(usable)} messages, {values} values agree", file=sys.stderr)

    def decode(self, frame, data):
        try:
            decoded = frame.decode(data)
        except (canmatrix.DecodingComplexMultiplexed, canmatrix.DecodingFrameLength):
            decoded = {}
        return decoded.items()

    def test_a_file_with_everything(self):
        # canmatrix does not know the names of VAL_TABLE_ in VAL_.
        text = (ROOT / "tests/data/dbc/features.dbc").read_text().replace("VAL_ 101 Small OnOff ;\n", "")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "features.dbc"
            path.write_text(text)
            self.judge(path, 500)

    def test_our_own_files(self):
        self.judge(ROOT / "bridges/protocol/eyebridge.dbc", 3000)
        self.judge(ROOT / "bridges/protocol/eyebridge_fd.dbc", 3000)

    def test_a_file_of_another_project(self):
        self.assertTrue(J1939.exists())
        self.judge(J1939, 1000)

    def test_files_of_the_command_line(self):
        for path in MORE:
            with self.subTest(path.name):
                self.judge(path, 0)


if __name__ == "__main__":
    unittest.main()
