#!/usr/bin/env python3
"""Does the whole game draw into a window? It is run on a display of its own, Xvfb, whose memory is looked at.

    check_window.py PROGRAM LEVEL       ends with 77 where there is no Xvfb
"""

import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time

SKIPPED = 77


def share_of(colour, screen):
    """How much of the screen has a colour, blue, green and red, as some of its pixels say. The file is that of xwd."""
    head = struct.unpack(">25I", screen[:100])
    places = range(head[0] + 12 * head[19], len(screen), 4 * 101)
    return sum(screen[i:i + 3] == colour for i in places) / len(places)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if not shutil.which("Xvfb"):
        print("Xvfb is not installed")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        reader, writer = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1280x720x24", "-fbdir", folder,
                                   "-nolisten", "tcp"], pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        display = os.fdopen(reader).readline().strip()
        game = subprocess.Popen(sys.argv[1:], cwd=folder, env={**os.environ, "DISPLAY": f":{display}"})
        sky = black = 0
        try:
            for _ in range(150):
                time.sleep(0.2)
                screen = (pathlib.Path(folder) / "Xvfb_screen0").read_bytes()
                sky, black = (share_of(bytes(colour), screen) for colour in ((235, 199, 158), (0, 0, 0)))
                if game.poll() is not None or (0.2 < sky < 0.8 and black < 0.05):
                    break
            is_running = game.poll() is None
        finally:
            game.kill()
            game.wait()
            server.terminate()
            server.wait()
    print(f"{100 * sky:.0f}% of the window is sky, {100 * black:.0f}% is black")
    sys.exit(0 if is_running and 0.2 < sky < 0.8 and black < 0.05 else 1)


if __name__ == "__main__":
    main()
