"""A level in the making: where the way has got to, what stands there, and the file that it becomes."""

import random
import sys

import bpy

from .export import finish_file, link_node, material_of
from .pieces import Pieces
from .scenery import Scenery
from .shapes import Frame, Mesh
from .things import Things

# Colours that mean the same in every level, as displayed; a palette adds the level's own.
COMMON = {
    "wood": dict(colour="#a9743f"),
    "dark wood": dict(colour="#6f4a2f"),
    "one way": dict(colour="#c69255", one_way=1),
    "ladder": dict(colour="#b9823f", ladder=1),
    "bounce": dict(colour="#d63fa4", glow=0.3),
    "bounce rim": dict(colour="#8d2a72"),
    "deadly": dict(colour="#e8452c", deadly=1, glow=0.5),
    "spikes": dict(colour="#e8642c", deadly=1, glow=0.15),
    "spike base": dict(colour="#5a3a3a"),
    "ice": dict(colour="#a5def2", grip=0.06),
    "ice rim": dict(colour="#d8f3fb", grip=0.06),
    "belt arrow": dict(colour="#ffd76a"),
    "crumble": dict(colour="#c9a27c"),
    "crumble side": dict(colour="#8a6b52"),
    "red door": dict(colour="#c23b4a"), "red door trim": dict(colour="#7a2430"),
    "blue door": dict(colour="#3f6fd0"), "blue door trim": dict(colour="#27427d"),
    "coin door": dict(colour="#d9a92e"), "coin door trim": dict(colour="#8a6a1c"),
    "beacon": dict(colour="#fff3c4", glow=0.8),
    "lamp": dict(colour="#ffdf9a", glow=0.9),
    "window": dict(colour="#ffcf7d", glow=0.75),
    "dark": dict(colour="#2c2f3a"),
}
# What is drawn on a material; a level may say otherwise.
DRAWINGS = {
    "top": "patches", "path": "patches", "side": "strata", "rock": "strata", "wood": "boards", "dark wood": "boards",
    "one way": "boards", "crumble": "boards", "crumble side": "boards", "plank": "boards", "trunk": "boards",
}


class Level(Pieces, Scenery, Things):
    """`palette` names the colours of the level's own materials: top, trim, side, rock, path, accent, leaf, light leaf,
    trunk, far, far top, machine, machine trim. `drawings` says where they are not drawn on as usual."""

    def __init__(self, title, idea, order, par, palette, far_towers=False, drawings=(), **extras):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.materials = {**COMMON, **{role: value if isinstance(value, dict) else dict(colour=value)
                                       for role, value in palette.items()}}
        self.materials.setdefault("crystal", dict(self.materials["accent"], glow=0.45))
        for role, drawing in {**DRAWINGS, **dict(drawings)}.items():
            if role in self.materials and drawing != "none":
                self.materials[role] = dict(self.materials[role], drawing=drawing)
        self.frame = Frame()
        self.dice = random.Random(order)
        self.count = {}
        self.checkpoints = self.beats = 0
        self.still, self.decor = Mesh(), Mesh()
        self.section = "start"
        self.low, self.high = [1e9] * 3, [-1e9] * 3
        self.far_towers = far_towers
        self.node("level", None, (0, 0, 0), kind="level", title=title, idea=idea, order=order, par=par, **extras)

    def play(self, *beats):
        """Builds the beats in order. Each is a function with a docstring; the still ground of each is a node of its own."""
        for beat in beats:
            self.section = beat.__name__.replace("_", " ")
            beat(self)
            self.close_section()
        self.section = "horizon"
        self.horizon(self.low, self.high)
        self.close_section()

    def close_section(self):
        for p in self.still.vertices:
            self.low, self.high = [min(a, b) for a, b in zip(self.low, p)], [max(a, b) for a, b in zip(self.high, p)]
        if self.still.faces:
            self.node(f"ground: {self.section}", self.still, (0, 0, 0))
        if self.decor.faces:
            self.node(f"scenery: {self.section}", self.decor, (0, 0, 0), kind="decor")
        self.still, self.decor = Mesh(), Mesh()

    def go(self, along=0.0, across=0.0, up=0.0, turn=0.0):
        """The way moves on: along, to the right, up, and then turns right by so many degrees."""
        self.frame = self.frame.moved(along, across, up, turn)

    def numbered(self, kind):
        self.count[kind] = self.count.get(kind, 0) + 1
        return f"{kind} {self.count[kind]:02}"

    def node(self, node, mesh, place, heading=0.0, **extras):
        data = None
        if mesh is not None:
            data = bpy.data.meshes.new(node)
            data.from_pydata(mesh.vertices, [], mesh.faces)
            names = sorted(set(mesh.materials))
            for material in names:
                data.materials.append(material_of(material, self.materials[material]))
            data.polygons.foreach_set("material_index", [names.index(m) for m in mesh.materials])
            data.update()
        link_node(node, data, place, heading, extras)

    def write(self):
        """Writes the file that the command line names behind `--`."""
        finish_file(sys.argv[sys.argv.index("--") + 1])
