#!/usr/bin/env python3
"""Writes the level of docs/game-in-a-day.md, a .glb such as Blender exports, with nothing but Python.

    examples/game_in_a_day/make_level.py examples/game_in_a_day/level.glb           writes it
    examples/game_in_a_day/make_level.py --check examples/game_in_a_day/level.glb   is it the one that would be written?

Metres, +Y up. The hero begins in the south (+Z) and goes north: an island, a platform over a gap, an island with an enemy,
a lift, and the goal.
"""

import json
import math
import pathlib
import struct
import sys

FACES = ((0, 1, 3, 2), (5, 4, 6, 7), (4, 0, 2, 6), (1, 5, 7, 3), (2, 3, 7, 6), (4, 5, 1, 0))  # counter-clockwise from outside


class Level:
    def __init__(self):
        self.materials, self.nodes, self.meshes, self.accessors, self.views, self.binary = [], [], [], [], [], b""

    def keep(self, values, kind, component, target):
        """Puts numbers into the binary part and returns the number of their accessor."""
        form, width = {5126: ("f", 3), 5125: ("I", 1)}[component]
        self.views.append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": 4 * len(values), "target": target})
        self.binary += struct.pack(f"<{len(values)}{form}", *values)
        accessor = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values) // width, "type": kind}
        if kind == "VEC3":
            accessor |= {"min": [min(values[i::3]) for i in range(3)], "max": [max(values[i::3]) for i in range(3)]}
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def node(self, name, place, kind=None, **more):
        extras = {"extras": {"surefoot": {"kind": kind}}} if kind else {}
        self.nodes.append({"name": name, "translation": place, **extras, **more})

    def box(self, name, material, size, place, kind=None):
        """A box of this size with the middle of its top at `place`. Tops of grass are tiles of 2 m in two shades."""
        corners = [(x * size[0] / 2, y * size[1], z * size[2] / 2) for z in (1, -1) for y in (-1, 0) for x in (-1, 1)]
        quads = {material: [[corners[corner] for corner in face] for face in FACES]}
        if material == "grass":
            quads = {"earth": quads[material][:4] + quads[material][5:], "grass": [], "light grass": []}
            for i in range(math.ceil(size[0] / 2)):
                for k in range(math.ceil(size[2] / 2)):
                    west, north = 2 * i - size[0] / 2, 2 * k - size[2] / 2
                    east, south = min(west + 2, size[0] / 2), min(north + 2, size[2] / 2)
                    quads["light grass" if (i + k) % 2 else "grass"].append(
                        [(west, 0, south), (east, 0, south), (east, 0, north), (west, 0, north)])
        self.meshes.append({"primitives": [self.primitive(material, faces) for material, faces in quads.items()]})
        self.node(name, place, kind, mesh=len(self.meshes) - 1)

    def primitive(self, material, quads):
        if material not in self.materials:
            self.materials.append(material)
        points = [number for quad in quads for corner in quad for number in corner]
        indices = [4 * i + corner for i in range(len(quads)) for corner in (0, 1, 2, 0, 2, 3)]
        return {"attributes": {"POSITION": self.keep(points, "VEC3", 5126, 34962)},
                "indices": self.keep(indices, "SCALAR", 5125, 34963), "material": self.materials.index(material)}

    def to_bytes(self):
        tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(self.nodes)))}],
                "nodes": self.nodes, "meshes": self.meshes, "materials": [{"name": name} for name in self.materials],
                "accessors": self.accessors, "bufferViews": self.views, "buffers": [{"byteLength": len(self.binary)}]}
        text = json.dumps(tree, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
        chunks += struct.pack("<II", len(self.binary), 0x004E4942) + self.binary
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def build():
    level = Level()
    level.box("south", "grass", (12, 1, 20), (0, 0, -4))
    level.box("back wall", "brick", (12, 3, 0.5), (0, 3, 6.25))
    level.box("crate", "wood", (1.6, 1, 1.6), (-2.5, 1, -4))
    level.box("ledge", "stone", (2, 0.5, 2), (4, 0.5, -1))
    level.box("post west", "brick", (1, 3, 1), (-4, 3, -11))
    level.box("post east", "brick", (1, 3, 1), (4, 3, -11))
    level.box("ferry", "metal", (3, 0.4, 3), (0, 0, -16), "platform")
    level.node("ferry.end", (0, 0, -22), "end")
    level.box("middle", "grass", (16, 1, 13), (0, 0, -30.5))
    level.box("wall", "brick", (6, 2, 0.8), (-3, 2, -30))
    level.box("stair low", "stone", (2, 0.35, 1), (6, 0.35, -29))
    level.box("stair high", "stone", (2, 0.7, 3), (6, 0.7, -31))
    level.box("lift", "metal", (3, 0.4, 3), (0, 0, -39), "platform")
    level.node("lift.end", (0, 4, -39), "end")
    level.box("north", "grass", (10, 1, 8), (0, 4, -45))
    level.node("spawn", (0, 0, 3), "spawn")
    for i, place in enumerate([(0, 0, -1), (-2.5, 1, -4), (0, 0, -9), (6, 0.7, -31), (-3, 0, -34), (0, 4, -43)]):
        level.node(f"coin {i}", place, "coin")
    level.node("checkpoint south", (0, 0, -12), "checkpoint")
    level.node("checkpoint middle", (0, 0, -25.5), "checkpoint")
    level.node("enemy", (-4, 0, -34), "enemy")
    level.node("goal", (0, 4, -47), "goal")
    return level


def main():
    *check, path = sys.argv[1:] or [""]
    if not path or check not in ([], ["--check"]):
        sys.exit(__doc__)
    level = build().to_bytes()
    if not check:
        pathlib.Path(path).write_bytes(level)
    elif pathlib.Path(path).read_bytes() != level:
        sys.exit(f"{path} is not what this program writes: write it anew")


if __name__ == "__main__":
    main()
