"""Pictures for a camera, by zlib alone."""
import struct
import zlib

WIDTH, HEIGHT = 64, 48


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(shade):
    """A grey picture."""
    rows = (b"\0" + bytes([shade]) * WIDTH) * HEIGHT
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def write_folder(folder, count):
    """`count` pictures, each a little brighter than the one before."""
    folder.mkdir(exist_ok=True)
    for i in range(count):
        (folder / f"frame{i:03}.png").write_bytes(png(20 * i % 256))
