#!/usr/bin/env python3
"""Draws a level's plan as SVG, north up: ground in its own colours, low to high, and what matters on it.

    levels/platformer/draw_map.py levels/platformer/tides.glb docs/levels/tides-map.svg
"""

import html
import pathlib
import sys

sys.dont_write_bytecode = True

from level_file import Level, cross, minus, read  # noqa: E402

SCALE = 4.0  # units of the picture for a metre
DOTS = {"coin": ("#e8a800", 0.35), "heart": ("#d8304a", 0.7), "key": ("#d8304a", 0.8), "enemy": ("#5a2070", 0.8),
        "star": ("#fff06a", 1.1)}
MARGIN = 9.0


def colours(tree):
    shown = {}
    for material in tree["materials"]:
        rgb = material["extras"]["surefoot"]["colour"]
        shown[material["name"]] = "#" + "".join(f"{round(255 * c):02x}" for c in rgb)
    return shown


def faces(level):
    """(height, surface, corners) of what looks up and is worth drawing, low to high."""
    for node in level.nodes:
        if node.kind == "decor":
            continue
        for t, surface in zip(node.triangles, node.surfaces):
            n = cross(minus(t[1], t[0]), minus(t[2], t[0]))
            if n[1] > 0.6 * (n[0] ** 2 + n[1] ** 2 + n[2] ** 2) ** 0.5 and n[1] > 0.5:
                yield sum(p[1] for p in t) / 3, surface, t


def draw(path):
    tree, rest, size = read(path)
    level, shown = Level(tree, rest, size), colours(tree)
    drawn = sorted(faces(level), key=lambda face: face[0])
    points = [p for _, _, t in drawn for p in t]
    x0, z0 = min(p[0] for p in points) - MARGIN, min(p[2] for p in points) - MARGIN
    x1, z1 = max(p[0] for p in points) + MARGIN, max(p[2] for p in points) + MARGIN

    def at(p):
        return f"{(p[0] - x0) * SCALE:.0f} {(p[2] - z0) * SCALE:.0f}"

    def place(p):
        x, y = at(p).split()
        return f'cx="{x}" cy="{y}"'

    title = level.of("level")[0].extras["title"]
    wide, tall = (x1 - x0) * SCALE, (z1 - z0) * SCALE
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide:.0f} {tall:.0f}" font-family="sans-serif">',
           f"<title>{html.escape(title)}, from above</title>", f'<rect width="{wide:.0f}" height="{tall:.0f}" fill="#dfe8ee"/>']
    strokes = 'stroke="#00000030" stroke-width="0.4" stroke-linejoin="round"'
    last, run = None, []

    def flush():
        if run:
            out.append(f'<path fill="{last}" {strokes} d="{"".join(run)}"/>')
            run.clear()

    for _, surface, t in drawn:
        if shown[surface] != last:
            flush()
            last = shown[surface]
        run.append(f"M{at(t[0])}L{at(t[1])} {at(t[2])}Z")
    flush()
    for kind, (colour, radius) in DOTS.items():
        for node in level.of(kind):
            out.append(f'<circle {place(node.place)} r="{radius * SCALE:.1f}" fill="{colour}" stroke="#00000080" stroke-width="0.6"/>')
    for node in level.of("checkpoint"):
        out.append(f'<circle {place(node.place)} r="{1.3 * SCALE:.1f}" fill="none" stroke="#0a8fa0" stroke-width="2"/>')
    for kind, word in (("spawn", "start"), ("goal", "goal")):
        x, y = at(level.of(kind)[0].place).split()
        out.append(f'<text x="{x}" y="{y}" font-size="15" text-anchor="middle" fill="#000" stroke="#fff" stroke-width="3" '
                   f'paint-order="stroke">{word}</text>')
    for node in level.of("beat"):
        x, y = at(node.place).split()
        out.append(f'<circle cx="{x}" cy="{y}" r="9" fill="#fff" stroke="#000"/><text x="{x}" y="{int(y) + 4}" font-size="12" '
                   f'text-anchor="middle">{node.extras["order"]}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_text(draw(pathlib.Path(sys.argv[1])), encoding="utf-8")
