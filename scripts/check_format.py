#!/usr/bin/env python3
"""Is every C++ file formatted as .clang-format says, and of a length that can be read in one sitting?

    scripts/check_format.py            checks; names each file and line that differs
    scripts/check_format.py --fix      formats the files instead
"""

import argparse
import shutil
import subprocess
import sys

from sources import ROOT, project_files

FORMATTED = (".hpp", ".cpp")
COUNTED = (".hpp", ".cpp", ".py", ".sh", ".cmake")
LONG, TOO_LONG = 400, 500


def check_format(fix):
    # Another version of clang-format formats differently, so only the one that the project is written with counts.
    tool = shutil.which("clang-format-14")
    if not tool:
        sys.exit("clang-format-14 is not installed; Debian's package is clang-format-14")
    files = [str(path) for path in project_files(FORMATTED)]
    print(f"clang-format: {len(files)} files")
    mode = ["-i"] if fix else ["--dry-run", "-Werror"]
    done = subprocess.run([tool, *mode, *files], cwd=ROOT)
    if done.returncode != 0:
        print("not formatted; `scripts/check_format.py --fix` does it for you")
    return done.returncode == 0


def check_length():
    good = True
    for path in project_files(COUNTED):
        lines = len((ROOT / path).read_text(encoding="utf-8").splitlines())
        if lines > TOO_LONG:
            print(f"{path}: {lines} lines, more than {TOO_LONG}: split it by concept")
            good = False
        elif lines > LONG:
            print(f"{path}: warning: {lines} lines, more than {LONG}")
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fix", action="store_true", help="format the files")
    results = [check_format(parser.parse_args().fix), check_length()]
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
