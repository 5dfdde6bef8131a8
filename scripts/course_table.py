#!/usr/bin/env python3
"""The table of docs/course.md, from the JSON of `surefoot course`.

    surefoot course --json > ours.json; surefoot course --json --mover bullet > bullet.json; ...
    scripts/course_table.py Surefoot=ours.json Bullet=bullet.json ...          prints the table
    scripts/course_table.py --write Surefoot=ours.json Bullet=bullet.json ...  puts it into docs/course.md

A name may be given several files, NAME=a.json,b.json: the settings of a mover; the better one of each scene is shown.
"""

import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BEGIN, END = "<!-- the table: scripts/course_table.py -->\n", "<!-- the table ends -->\n"


def read(path):
    return {scene["scene"]: scene for scene in json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["scenes"]}


def figure(bar):
    value = "without end" if bar["measured"] is None else f"{bar['measured']:.2g}"
    return f"{bar['what']} {value}{' ' + bar['unit'] if bar['unit'] else ''}"


def badness(scene):
    """How many bars are missed; a mover that gave up is the worst."""
    return 100 if scene["failure"] else sum(not bar["passes"] for bar in scene["bars"])


def cell(scene):
    if scene["passes"]:
        return "passes"
    if scene["failure"]:
        return "gave up"
    missed = [bar for bar in scene["bars"] if not bar["passes"]]
    # The bar that is missed by the most, as a multiple of what is allowed.
    worst = max(missed, key=lambda bar: 1e300 if bar["measured"] is None else bar["measured"] / max(bar["most"], 1e-3))
    more = f", and {len(missed) - 1} more" if len(missed) > 1 else ""
    return figure(worst) + more


def table(movers):
    names = list(movers)
    lines = [f"| scene | {' | '.join(names)} |", "|---" * (len(names) + 1) + "|"]
    passed = dict.fromkeys(names, 0)
    scenes = next(iter(movers.values()))[0]
    for scene in scenes:
        row = []
        for name in names:
            best = min((settings[scene] for settings in movers[name]), key=badness)
            passed[name] += best["passes"]
            row.append(cell(best))
        lines.append(f"| `{scene}` | {' | '.join(row)} |")
    lines.append(f"| **cleared, of {len(scenes)}** | {' | '.join(f'**{passed[name]}**' for name in names)} |")
    return "\n".join(lines) + "\n"


def main():
    arguments = sys.argv[1:]
    write = "--write" in arguments
    pairs = [argument.split("=", 1) for argument in arguments if argument != "--write"]
    if not pairs or any(len(pair) != 2 for pair in pairs):
        sys.exit(__doc__)
    text = table({name: [read(path) for path in paths.split(",")] for name, paths in pairs})
    if not write:
        print(text, end="")
        return
    page = ROOT / "docs" / "course.md"
    before, _, rest = page.read_text(encoding="utf-8").partition(BEGIN)
    page.write_text(before + BEGIN + "\n" + text + "\n" + END + rest.partition(END)[2], encoding="utf-8")


if __name__ == "__main__":
    main()
