#!/usr/bin/env python3
"""The tables of docs/course.md, from the JSON of `surefoot course`.

    surefoot course --json > ours.json; surefoot course --json --mover bullet > bullet.json; ...
    scripts/course_table.py Surefoot=ours.json Bullet=bullet.json ...          prints the table
    scripts/course_table.py --write Surefoot=ours.json Bullet=bullet.json ...  puts it into docs/course.md

A name may be given several files, NAME=a.json,b.json: the settings of a mover; the better one of each scene is shown.

    surefoot course --shape all --json | scripts/course_table.py --shapes -          prints the table of shapes
    surefoot course --shape all --json | scripts/course_table.py --shapes --write -  puts it into docs/course.md
    surefoot course --shape all --json | scripts/course_table.py --shapes --check -  fails if another one is there
    scripts/course_table.py --names FILE  fails unless both tables have the scenes of this `surefoot course --list`
"""

import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "course.md"
BEGIN, END = "<!-- the table: scripts/course_table.py -->\n", "<!-- the table ends -->\n"
SHAPES_BEGIN, SHAPES_END = "<!-- the table: scripts/course_table.py --shapes -->\n", "<!-- the table of shapes ends -->\n"


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


def by_shape(text):
    """One row a scene, one column a shape; the last one tells which broken mover the scene fails."""
    fields = [json.loads(line) for line in text.splitlines()]
    shapes = [field["shape"] for field in fields]
    lines = [f"| scene | {' | '.join(shapes)} | fails |", "|---" * (len(shapes) + 2) + "|"]
    notes = []
    for row in zip(*(field["scenes"] for field in fields)):
        cells = []
        for shape, scene in zip(shapes, row):
            cells.append(cell(scene) if scene["applies"] else "does not apply")
            if not scene["applies"]:
                notes.append(f"`{scene['scene']}` does not apply to a {shape}: {scene['why_not']}.")
        faults = {}
        for shape, scene in zip(shapes, row):
            if scene["applies"]:
                faults.setdefault(scene["fails"], []).append(shape)
        first = next(iter(faults))
        fails = [f"`{first}`"] + [f"`{fault}` ({', '.join(of)})" for fault, of in faults.items() if fault != first]
        lines.append(f"| `{row[0]['scene']}` | {' | '.join(cells)} | {', '.join(fails)} |")
    counts = [f"**{field['passed']} of {field['apply']}**" for field in fields]
    lines.append(f"| **cleared, of those that apply** | {' | '.join(counts)} | |")
    return "\n".join(lines) + "\n" + "".join(f"\n{note}\n" for note in notes)


def between(page, begin, end):
    return page.partition(begin)[2].partition(end)[0].strip("\n") + "\n"


def put(text, begin, end):
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(begin)
    PAGE.write_text(before + begin + "\n" + text + "\n" + end + rest.partition(end)[2], encoding="utf-8")


def shapes_table(arguments):
    names = [name for name in arguments if not name.startswith("--")]
    if len(names) != 1:
        sys.exit(__doc__)
    text = by_shape(sys.stdin.read() if names[0] == "-" else pathlib.Path(names[0]).read_text(encoding="utf-8"))
    if "--write" in arguments:
        put(text, SHAPES_BEGIN, SHAPES_END)
    elif "--check" in arguments:
        if between(PAGE.read_text(encoding="utf-8"), SHAPES_BEGIN, SHAPES_END) != text:
            sys.exit("docs/course.md has another table of shapes than this:\n" + text)
    else:
        print(text, end="")


def check_names(path):
    """Needs no walk: a scene that came, went or has another name makes both tables stale."""
    listed = re.findall(r"^([a-z-]+): .* runs$", pathlib.Path(path).read_text(encoding="utf-8"), re.MULTILINE)
    page = PAGE.read_text(encoding="utf-8")
    for begin, end in ((BEGIN, END), (SHAPES_BEGIN, SHAPES_END)):
        told = re.findall(r"^\| `([a-z-]+)` \|", between(page, begin, end), re.MULTILINE)
        if not listed or told != listed:
            sys.exit(f"docs/course.md, {begin.strip()}: other scenes than those of {path}: {set(told) ^ set(listed)}")


def main():
    arguments = sys.argv[1:]
    if "--shapes" in arguments:
        return shapes_table(arguments)
    if arguments[:1] == ["--names"] and len(arguments) == 2:
        return check_names(arguments[1])
    write = "--write" in arguments
    pairs = [argument.split("=", 1) for argument in arguments if argument != "--write"]
    if not pairs or any(len(pair) != 2 for pair in pairs):
        sys.exit(__doc__)
    text = table({name: [read(path) for path in paths.split(",")] for name, paths in pairs})
    if not write:
        print(text, end="")
        return
    put(text, BEGIN, END)


if __name__ == "__main__":
    main()
