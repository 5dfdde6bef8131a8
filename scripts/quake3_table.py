#!/usr/bin/env python3
"""Counts what is in every map of OpenArena, and writes docs/quake3-maps.md.

    scripts/quake3_table.py                    fetches the maps if need be (levels/fetch), reads each, writes the table
    scripts/quake3_table.py --check            reads each and compares its counts with the table; times may differ
    scripts/quake3_table.py --program PROGRAM  another surefoot than build/release/tools/surefoot

Times are what the program tells of itself, the least of a few runs, on a machine that had other things to do too. Exit
codes: 0 done, 1 a map cannot be read or the
table is not what the maps say.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

from sources import ROOT

TABLE = ROOT / "docs" / "quake3-maps.md"
COUNTS = ["triangles", "patches", "brushes", "markers", "spawns", "pads", "teleporters", "items", "without area", "nonsolid",
          "open edges", "T-junctions"]
TIMES = ["read", "tree", "cook"]
ROUNDS = 3

HEAD = """# Maps of Quake III, counted

Every map in Debian's packages of OpenArena, read by `surefoot info` with the defaults: 1/32 m a unit, curves to 1 cm.
`scripts/quake3_table.py` makes this page. The maps themselves are under the GPL and are not here; `levels/fetch
openarena` gets them.

- **patches**: curved surfaces. **brushes**: brushes of which at least one side is invisible and stops a player.
- **markers**: all entities; **spawns**, jump **pads**, **teleporters** and **items** are among them.
- **without area**: triangles, as the compiler of the map left them. They stay, with their ids.
- **nonsolid**: drawn surfaces that stop no player, which are left out.
- **open edges**, **T-junctions**: what cooking finds (docs/cooking.md): sides without a neighbour, and corners in the
  middle of another triangle's open edge. Maps of Quake III are cut by their compiler, so there are many.
- **read**: from the `.pk3` to triangles; **tree**: from there to a mesh that answers; **cook**: from there to the
  `.surefoot` on the disk, with all that cooking looks for, and with hashing the whole `.pk3`, which is most of it for a
  small map in a large one. As `surefoot info --no-cache` and `surefoot cook` tell with `--json`: wall clock within the
  program, the least of {rounds} runs, on two cores that others used too.
"""


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True)


def maps():
    """(package, path of the .pk3, name in it) of every map."""
    listed = subprocess.run([ROOT / "levels" / "fetch", "openarena"], stdout=subprocess.PIPE, text=True, check=True)
    for line in listed.stdout.splitlines():
        path = pathlib.Path(line.split("\t")[0])
        package = next(part for part in path.parts if part.startswith("openarena-"))
        with zipfile.ZipFile(path) as packed:
            for name in sorted(packed.namelist()):
                if re.fullmatch(r"maps/[^/]+\.bsp", name, re.IGNORECASE):
                    yield package, path, name


def counts(info, report):
    kinds = [marker["kind"] for marker in info["markers"]]
    return [info["triangles"], info["patches"], info["brushes"], len(kinds), kinds.count("spawn"),
            kinds.count("jump_pad"), kinds.count("teleporter"), kinds.count("item"), info["degenerate"],
            info["nonsolid_skipped"], report["open_edges"]["count"], report["t_junctions"]["count"]]


def told(program, level, *arguments):
    """What the program says of a level, as JSON."""
    done = run(program, *arguments, "--json")
    if done.returncode != 0:
        sys.exit(f"{level}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def look_at(program, level):
    """What is in a level, what cooking finds, and the least times of reading, building and cooking [s]."""
    with tempfile.TemporaryDirectory() as folder:
        for i in range(ROUNDS):
            info = told(program, level, "info", level, "--no-cache")
            cooked = told(program, level, "cook", level, "-o", f"{folder}/level.surefoot")
            now = [min(info["import_seconds"], cooked["import_seconds"]), info["build_seconds"], cooked["cook_seconds"]]
            least = now if i == 0 else list(map(min, least, now))
    return counts(info, cooked["report"]), least


def row(cells):
    return "| " + " | ".join(f"{cell:,}" if isinstance(cell, int) else cell for cell in cells) + " |"


def milliseconds(seconds):
    return f"{1000 * seconds:.0f} ms"


def measure(program):
    """The lines of the tables, and the totals above them."""
    lines, total, total_times, last = [], [0] * len(COUNTS), [0.0] * len(TIMES), None
    number = 0
    for package, path, name in maps():
        found, spent = look_at(program, f"{path}:{name}")
        if package != last:
            lines += ["", f"## {package}", "", row(["map", *COUNTS, *TIMES]), "|---|" + "--:|" * (len(COUNTS) + len(TIMES))]
            last = package
        lines.append(row([pathlib.PurePosixPath(name).stem, *found, *map(milliseconds, spent)]))
        total = [a + b for a, b in zip(total, found)]
        total_times = [a + b for a, b in zip(total_times, spent)]
        number += 1
        if sys.stderr.isatty():
            print(f"\r{number} {name:40}", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print("\r" + " " * 60 + "\r", end="", file=sys.stderr)
    spent = ", ".join(f"{name} {seconds:.1f} s" for name, seconds in zip(TIMES, total_times))
    summary = (f"\nAll {number} maps: {total[0]:,} triangles, {total[1]:,} patches, {total[2]:,} brushes, {total[3]:,} "
               f"markers,\n{total[8]:,} triangles without area, {total[11]:,} T-junctions. {spent[0].upper() + spent[1:]}.")
    return HEAD.format(rounds=ROUNDS) + "\n".join([summary, *lines]) + "\n"


def without_times(text):
    """The counts of each row."""
    lines = [line for line in text.splitlines() if line.startswith("| ") and not line.startswith("| map")]
    return [line.split("|")[:len(COUNTS) + 2] for line in lines]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare and write nothing")
    parser.add_argument("--program", default=str(ROOT / "build" / "release" / "tools" / "surefoot"))
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.program).exists():
        sys.exit(f"{arguments.program} is not there; build it first: ./run")
    text = measure(arguments.program)
    if not arguments.check:
        TABLE.write_text(text, encoding="utf-8")
        return
    for old, new in zip(without_times(TABLE.read_text(encoding="utf-8")), without_times(text)):
        if old != new:
            sys.exit(f"{TABLE}: not what the maps say any more:\n  {'|'.join(old)}\n  {'|'.join(new)}")


if __name__ == "__main__":
    main()
