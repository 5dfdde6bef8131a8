#!/usr/bin/env python3
"""Does a step of docs/game-in-a-day.md print what the page says?

    check_output.py PAGE STEP PROGRAM [arguments...]

What it says is the fence under the comment `<!-- step STEP prints -->`.
"""

import pathlib
import re
import subprocess
import sys


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    page, step, *command = sys.argv[1:]
    said = re.search(rf"<!-- step {step} prints -->\n```\n(.*?)```", pathlib.Path(page).read_text(encoding="utf-8"), re.DOTALL)
    if not said:
        sys.exit(f"{page} does not say what step {step} prints")
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if done.stdout != said[1]:
        sys.exit(f"{page} says\n{said[1]}\nand the program\n{done.stdout}")
    print(done.stdout, end="")
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
