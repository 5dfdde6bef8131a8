#!/usr/bin/env python3
"""Draws the pictures of docs/game-in-a-day.md: runs its steps 7 and 9 and halves what they leave.

    docs/pictures/game_in_a_day.py build/release
"""

import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PICTURES = {"game.ppm": "hero", "game-800.ppm": "ferry", "game-1060.ppm": "enemy", "game-1750.ppm": "lift"}


def halved(ppm):
    """The size and rows of a picture of which each pixel is the mean of four."""
    head, pixels = ppm.split(b"\n", 1)
    width, height = map(int, head.split()[1:3])
    rows = []
    for y in range(0, height - 1, 2):
        upper, lower = (pixels[3 * width * k:3 * width * (k + 1)] for k in (y, y + 1))
        rows.append(bytes((upper[i] + upper[i + 3] + lower[i] + lower[i + 3] + 2) // 4
                          for x in range(0, width - 1, 2) for i in range(3 * x, 3 * x + 3)))
    return width // 2, rows


def png(width, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    programs = pathlib.Path(sys.argv[1]).resolve() / "examples"
    with tempfile.TemporaryDirectory() as folder:
        for step in (7, 9):
            subprocess.run([programs / f"example_game_in_a_day_{step}", ROOT / "examples/game_in_a_day/level.glb", "--script"],
                           cwd=folder, check=True)
        for source, name in PICTURES.items():
            data = png(*halved((pathlib.Path(folder) / source).read_bytes()))
            (ROOT / f"docs/pictures/day-{name}.png").write_bytes(data)


if __name__ == "__main__":
    main()
