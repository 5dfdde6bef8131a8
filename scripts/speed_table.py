#!/usr/bin/env python3
"""Makes the tables of docs/speed.md from what `surefoot bench --json` printed.

    surefoot bench --json >speed.json
    scripts/speed_table.py speed.json                        prints them
    scripts/speed_table.py speed.json --write docs/speed.md  puts them between the marks in that page
"""

import argparse
import json
import pathlib
import re
import sys

SCENES = ("terrain", "city", "soup", "dungeon")

# Multiples of E, single thread, measured once by others' builds on another machine; None where nobody measured.
FIELD = {
    "short sphere sweep": {"PhysX": (6.9, 2.9, 1.5), "Jolt": (9.2, 3.7, 1.4), "Box3D": (9.7, 3.3, 1.3),
                           "Bullet": (31, 11, 2.2)},
    "long sphere sweep": {"PhysX": (5.4, 5.6, 3.8), "Jolt": (8.5, 7.5, 3.9), "Box3D": (13.8, 8.8, 4.7),
                          "Bullet": (146, 108, 20)},
    "short capsule sweep": {"PhysX, Jolt, Box3D": ("8.9-10", "4-5.5", "1.5-1.9")},
    "short ellipsoid sweep": {"as a scaled mesh": ("9-10.5", "4-4.5", "1.5-1.7")},
    "long ray": {"PhysX, Jolt, Box3D": ("2.0", "3.3", "4")},
}

# Our bars: multiples of E by scene, or (factor, the question it is a multiple of).
BARS = {
    "short sphere sweep": (1.6, 1.0, 0.5, 1.5),
    "long sphere sweep": (1.8, 1.8, 1.0, 3.3),
    "long ray": (1.0, 1.1, 1.4, None),
    "short sphere sweeps, 8 at once": (1.3, 0.85, 0.4),
    "short ellipsoid sweep": (1.1, "short sphere sweep"),
    "short capsule sweep": (1.5, "short sphere sweep"),
    "short box sweep": (3, "short sphere sweep"),
    "short cylinder sweep": (3, "short sphere sweep"),
    "short cone sweep": (3, "short sphere sweep"),
    "sphere gather": (1.2, "short sphere sweep"),
}
MARKS = re.compile(r"(<!-- made by scripts/speed_table.py -->\n).*?(<!-- end -->\n)", re.DOTALL)


def table(heading, rows):
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"


def number(value, digits=3):
    if value is None:
        return ""
    return value if isinstance(value, str) else f"{value:.{digits}g}"


def multiples(scene, solver):
    return {row["question"]: row["multiple_of_e"] for row in scene["rows"]
            if row["solver"] == solver and row["order"] == "random" and "multiple_of_e" in row}


def bar_of(question, place, ours):
    bar = BARS.get(question)
    if bar is None:
        return None
    if isinstance(bar[1], str):
        return bar[0] * ours[bar[1]] if bar[1] in ours else None
    return bar[place] if place < len(bar) else None


def against_the_field(scenes):
    """For every question with a bar: ours, the bar, Bullet of the same run, and the field."""
    rows = []
    for question in BARS:
        for place, name in enumerate(SCENES):
            scene = scenes.get(name)
            ours = multiples(scene, "Surefoot") if scene else {}
            if question not in ours:
                continue
            bar = bar_of(question, place, ours)
            verdict = "" if bar is None else "yes" if ours[question] <= bar else f"no: {ours[question] / bar:.2g} times the bar"
            field = "; ".join(f"{who} {number(values[place])}" for who, values in FIELD.get(question, {}).items()
                              if place < len(values))
            rows.append([question, name, number(ours[question]), number(bar), verdict,
                         number(multiples(scene, "Bullet").get(question)), field])
    return table(["question", "scene", "ours, x E", "bar, x E", "reached", "Bullet here", "the field, x E"], rows)


def building(scenes):
    rows = []
    for name, scene in scenes.items():
        per_million = [number(1e6 * scene[key] / scene["triangles"]) if key in scene else ""
                       for key in ("build_seconds", "embree_build_seconds", "bullet_build_seconds")]
        rows.append([name, f"{scene['triangles']:,}", *per_million, number(scene.get("bytes_per_triangle")), number(scene.get("all_bytes_per_triangle"))])
    return table(["scene", "triangles", "ours, s a million", "Embree", "Bullet", "bytes a triangle that queries read",
                  "bytes in all"], rows)


def everything(scene):
    rows = []
    for row in scene["rows"]:
        timed = "sweep" in row["question"] or "ray" in row["question"]
        rows.append([row["question"], row["solver"], row["order"], f"{row['median_ns']:.0f}",
                     number(row.get("multiple_of_e")), f"{row['p10_ns']:.0f}", f"{row['p90_ns']:.0f}",
                     f"{100 * row['hit_share']:.0f}%", f"{row['mean_t']:.2f}" if timed else "",
                     number(row.get("nodes_opened")), number(row.get("triangles_tested")),
                     f"{row['checked'] - row['wrong']} of {row['checked']}" if row["checked"] else ""])
    return table(["question", "of", "order", "ns", "x E", "p10", "p90", "hits", "mean t", "nodes", "tested", "right"],
                 rows)


def page(report):
    scenes = {scene["scene"]: scene for scene in report["scenes"]}
    text = f"\n{report['machine']}; thread CPU time, median of {report['rounds']} rounds.\n"
    text += "\n### Against the bars and the field\n\n" + against_the_field(scenes)
    text += "\n### Building\n\n" + building(scenes)
    for name, scene in scenes.items():
        text += f"\n### All questions: {name}\n\n" + everything(scene)
    return text + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("report", type=pathlib.Path, help="what surefoot bench --json printed")
    parser.add_argument("--write", type=pathlib.Path, metavar="PAGE", help="put the tables between the marks in PAGE")
    arguments = parser.parse_args()
    text = page(json.loads(arguments.report.read_text(encoding="utf-8")))
    if arguments.write is None:
        print(text, end="")
        return
    old = arguments.write.read_text(encoding="utf-8")
    if not MARKS.search(old):
        sys.exit(f"{arguments.write} has no <!-- made by scripts/speed_table.py --> ... <!-- end --> to write between")
    arguments.write.write_text(MARKS.sub(lambda match: match[1] + text + match[2], old), encoding="utf-8")


if __name__ == "__main__":
    main()
