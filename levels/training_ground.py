"""The training ground: every thing that trips up a player, in one place to walk through.

    blender -b --factory-startup -P levels/training_ground.py -- levels/training-ground.glb

Written for Blender 3.4 (Debian 12: blender, python3-numpy); the same version writes the same bytes. Everything below is
in Blender's axes, metres, +Z up; the .glb has +Y up, so that (x, y, z) here is (x, z, -y) there. levels/README.md is the
map.
"""

import math
import random
import sys

import bpy

TERRACE = 2.4  # height of both terraces and of the bridge between them
BURIED = -0.1  # walls begin a little below the ground, so that no two faces share a plane

COLOURS = {
    "grass": (0.24, 0.42, 0.15),
    "sand": (0.72, 0.62, 0.42),
    "stone": (0.52, 0.52, 0.50),
    "rock": (0.38, 0.35, 0.32),
    "wood": (0.50, 0.33, 0.18),
    "ice": (0.62, 0.80, 0.92),
    "metal": (0.35, 0.40, 0.46),
    "plaster": (0.85, 0.80, 0.70),
}
FRICTION = {"ice": 0.03, "metal": 0.5, "wood": 0.7, "sand": 0.9}


class Builder:
    """Collects the faces of one node; corners are counter-clockwise when seen from the front."""

    def __init__(self, name, **extras):
        self.name, self.extras = name, extras
        self.vertices, self.index, self.faces, self.materials = [], {}, [], []

    def vertex(self, p):
        if p not in self.index:
            self.index[p] = len(self.vertices)
            self.vertices.append(p)
        return self.index[p]

    def face(self, material, *corners):
        self.faces.append([self.vertex(tuple(map(float, p))) for p in corners])
        self.materials.append(material)

    def prism(self, material, outline, bottom, top, skip=(), cap=True, floor=False, cap_material=None):
        """Walls over a counter-clockwise outline, but for the sides listed in `skip`, and a cap."""
        n = len(outline)
        for i in range(n):
            if i not in skip:
                (ax, ay), (bx, by) = outline[i], outline[(i + 1) % n]
                self.face(material, (ax, ay, bottom), (bx, by, bottom), (bx, by, top), (ax, ay, top))
        if cap:
            self.face(cap_material or material, *[(x, y, top) for x, y in outline])
        if floor:
            self.face(material, *[(x, y, bottom) for x, y in reversed(outline)])

    def box(self, material, x0, y0, x1, y1, bottom, top, **more):
        self.prism(material, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)], bottom, top, **more)

    def finish(self):
        mesh = bpy.data.meshes.new(self.name)
        mesh.from_pydata(self.vertices, [], self.faces)
        names = sorted(set(self.materials))
        for name in names:
            mesh.materials.append(material(name))
        mesh.polygons.foreach_set("material_index", [names.index(m) for m in self.materials])
        mesh.update()
        add_node(self.name, mesh, (0, 0, 0), self.extras)


def material(name):
    made = bpy.data.materials.get(name)
    if made is None:
        made = bpy.data.materials.new(name)
        made.use_nodes = True
        shader = made.node_tree.nodes["Principled BSDF"]
        shader.inputs["Base Color"].default_value = (*COLOURS[name], 1)
        shader.inputs["Roughness"].default_value = 0.1 if name == "ice" else 0.9
        made["surefoot"] = {"friction": FRICTION.get(name, 1.0), "slippery": int(name == "ice")}
    return made


def add_node(name, data, place, extras, heading=0.0):
    node = bpy.data.objects.new(name, data)
    node.location = place
    node.rotation_euler = (0, 0, heading)
    if extras:
        node["surefoot"] = extras
    bpy.context.scene.collection.objects.link(node)


def marker(name, place, heading=0.0, **extras):
    add_node(name, None, place, extras, heading)


def cut_badly(x0, y0, x1, y1, dice, coarse, fine, boundary=lambda *box: False):
    """A rectangle as (cell's centre, triangle) in the plane: cells of many sizes that meet in T-junctions, among them
    slivers a millimetre wide and needles half a millimetre at the base. Along a `boundary` cells are a quarter of
    `fine`."""
    wide, deep = x1 - x0, y1 - y0
    size = max(wide, deep)
    if size > coarse or (size > fine and dice.random() < 0.6) or (size > fine / 4 and boundary(x0, y0, x1, y1)):
        mx, my = (x0 + x1) / 2, (y0 + y1) / 2
        if wide > 1.5 * deep:
            parts = [(x0, y0, mx, y1), (mx, y0, x1, y1)]
        elif deep > 1.5 * wide:
            parts = [(x0, y0, x1, my), (x0, my, x1, y1)]
        else:
            parts = [(x0, y0, mx, my), (mx, y0, x1, my), (x0, my, mx, y1), (mx, my, x1, y1)]
        for part in parts:
            yield from cut_badly(*part, dice, coarse, fine, boundary)
        return
    for triangle in cut_cell(x0, y0, x1, y1, dice):
        yield ((x0 + x1) / 2, (y0 + y1) / 2), triangle


def cut_cell(x0, y0, x1, y1, dice):
    kind = dice.random()
    if kind < 0.06:
        yield from cut_rows(x0, x1, [y0, y0 + 0.001, y1])
    elif kind < 0.12:
        mx = x0 + dice.choice((0.25, 0.5, 0.75)) * (x1 - x0)
        foot = [(x0, y0), (mx, y0), (mx + 0.0005, y0), (x1, y0)]
        for a, b in zip(foot, foot[1:]):
            yield [a, b, (x0, y1)]
        yield [(x1, y0), (x1, y1), (x0, y1)]
    elif kind < 0.56:
        yield from cut_rows(x0, x1, [y0, y1])
    else:
        yield [(x0, y0), (x1, y0), (x0, y1)]
        yield [(x1, y0), (x1, y1), (x0, y1)]


def cut_rows(x0, x1, rows):
    for low, high in zip(rows, rows[1:]):
        yield [(x0, low), (x1, low), (x1, high)]
        yield [(x0, low), (x1, high), (x0, high)]


# The ground: grass, with a paved court to start from, a rink of ice, and sand around the things to climb.

HALF_X, HALF_Y = 36, 28
SPAWN = (0, -20)
RINK = (0, -4)


def ground_material(x, y):
    if math.hypot(x - SPAWN[0], y - SPAWN[1]) < 5.5:
        return "stone"
    if math.hypot(x - RINK[0], y - RINK[1]) < 4.5:
        return "ice"
    if abs(x) < 1.25 and y < 12 or (abs(y + 12) < 1.25 and abs(x) < 26):
        return "sand"
    return "grass"


def on_boundary(x0, y0, x1, y1):
    return len({ground_material(x, y) for x in (x0, (x0 + x1) / 2, x1) for y in (y0, (y0 + y1) / 2, y1)}) > 1


def build_ground():
    floor = Builder("ground", kind="feature", feature="floor, finely and badly cut")
    dice = random.Random(1)
    for x in range(-HALF_X, HALF_X, 8):
        for y in range(-HALF_Y, HALF_Y, 8):
            for centre, triangle in cut_badly(x, y, x + 8, y + 8, dice, 4, 1, on_boundary):
                floor.face(ground_material(*centre), *[(px, py, 0) for px, py in triangle])
    floor.finish()

    def height(x, y):
        out = math.hypot(max(0, abs(x) - HALF_X), max(0, abs(y) - HALF_Y)) / 12
        waves = 4 + 1.5 * math.sin(0.31 * x + 0.5) * math.cos(0.27 * y) + 0.8 * math.sin(0.83 * x - 0.61 * y)
        return 0.0 if out == 0 else out * out * (3 - 2 * min(out, 1)) * waves

    hills = Builder("hills", kind="feature", feature="terrain")
    step = 2
    for x in range(-HALF_X - 12, HALF_X + 12, step):
        for y in range(-HALF_Y - 12, HALF_Y + 12, step):
            if -HALF_X <= x < HALF_X and -HALF_Y <= y < HALF_Y:
                continue
            a, b, c, d = ((px, py, height(px, py)) for px, py in
                          ((x, y), (x + step, y), (x + step, y + step), (x, y + step)))
            hills.face("grass", a, b, c)
            hills.face("grass", a, c, d)
    hills.finish()


def build_court():
    columns = Builder("columns", kind="feature", feature="columns")
    for i in range(8):
        angle = math.radians(22.5 + 45 * i)
        x, y = SPAWN[0] + 5 * math.cos(angle), SPAWN[1] + 5 * math.sin(angle)
        ring = [(x + 0.32 * math.cos(math.radians(30 * k)), y + 0.32 * math.sin(math.radians(30 * k))) for k in range(12)]
        columns.prism("stone", ring, BURIED, 3.0, cap=False)
        wide = [(x + 0.5 * s, y + 0.5 * t) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        columns.prism("stone", wide, 3.0, 3.3, floor=True)
    columns.finish()


def build_terrace(name, x0, x1):
    terrace = Builder(name, kind="feature", feature="terrace", height=TERRACE)
    terrace.box("stone", x0, 4, x1, 10, BURIED, TERRACE, cap=False)
    dice = random.Random(2)
    for _, triangle in cut_badly(x0, 4, x1, 10, dice, 3, 0.75):
        terrace.face("stone", *[(x, y, TERRACE) for x, y in triangle])
    terrace.finish()


def build_stairs():
    """Six flights up to the western terrace, every tread 0.3 m deep. The flight of 0.5 m ends 0.1 m above it."""
    for i, riser in enumerate((0.1, 0.2, 0.3, 0.4, 0.5, 0.6)):
        flight = Builder(f"stairs {riser:.1f}", kind="feature", feature="stairs", riser=riser, tread=0.3)
        count = math.ceil(TERRACE / riser - 1e-9)
        x0 = -32.4 + 2.5 * i
        x1 = x0 + 2.0
        for k in range(count):
            y0, y1 = 4 - 0.3 * (count - k), 4 - 0.3 * (count - k - 1)
            low, high = (riser * k if k else BURIED), riser * (k + 1)
            flight.face("wood", (x0, y0, high), (x1, y0, high), (x1, y1, high), (x0, y1, high))
            flight.face("stone", (x0, y0, low), (x1, y0, low), (x1, y0, high), (x0, y0, high))
            flight.face("stone", (x1, y0, BURIED), (x1, y1, BURIED), (x1, y1, high), (x1, y0, high))
            flight.face("stone", (x0, y1, BURIED), (x0, y0, BURIED), (x0, y0, high), (x0, y1, high))
        top = riser * count
        if top > TERRACE + 1e-6:
            flight.face("stone", (x1, 4, TERRACE), (x0, 4, TERRACE), (x0, 4, top), (x1, 4, top))
        flight.finish()


def build_ramps():
    """Eight ramps up to the eastern terrace, 10 to 80 degrees. The western half of those up to 40 degrees is ice."""
    dice = random.Random(3)
    for i, angle in enumerate(range(10, 90, 10)):
        ramp = Builder(f"ramp {angle}", kind="feature", feature="ramp", angle_deg=angle)
        run = TERRACE / math.tan(math.radians(angle))
        x0 = 13.9 + 2.45 * i
        x1 = x0 + 2.0
        y0 = 4 - run
        for half, substance in ((x0, "ice" if angle <= 40 else "stone"), (x0 + 1, "stone")):
            for _, triangle in cut_badly(half, y0, half + 1, 4, dice, 2, 0.5):
                ramp.face(substance, *[(x, y, TERRACE * (y - y0) / run) for x, y in triangle])
        ramp.face("stone", (x1, y0, BURIED), (x1, 4, BURIED), (x1, 4, TERRACE), (x1, y0, 0))
        ramp.face("stone", (x0, 4, BURIED), (x0, y0, BURIED), (x0, y0, 0), (x0, 4, TERRACE))
        ramp.finish()


def build_bridge(x0, x1):
    bridge = Builder("bridge", kind="feature", feature="planks with gaps of a centimetre", width=2.0)
    count = round((x1 - x0) / 0.25)
    for i in range(count):
        a = x0 + 0.25 * i
        bridge.box("wood", a + 0.005, 6, a + 0.245, 8, TERRACE - 0.06, TERRACE, floor=True)
    for y in (6.25, 7.55):
        bridge.box("wood", x0, y, x1, y + 0.2, TERRACE - 0.3, TERRACE - 0.061, floor=True)
    bridge.finish()
    beam = Builder("beam", kind="feature", feature="beam", width=0.25)
    beam.box("metal", x0, 9.2, x1, 9.45, TERRACE - 0.25, TERRACE, floor=True)
    beam.finish()


def build_ledges(west, east):
    """Along the northern faces of the terraces: a solid ledge of 0.3 m, and a sheet of 0.5 m without thickness."""
    solid = Builder("ledge", kind="feature", feature="ledge", width=0.3, height=1.2)
    solid.box("stone", west[0], 10, west[1], 10.3, 1.0, 1.2, skip=(0,), floor=True)
    solid.finish()
    sheet = Builder("ledge without thickness", kind="feature", feature="ledge", width=0.5, height=1.2)
    for i in range(int(east[1] - east[0])):
        x = east[0] + i
        sheet.face("metal", (x, 10, 1.2), (x + 1, 10, 1.2), (x + 1, 10.5, 1.2), (x, 10.5, 1.2))
    sheet.finish()


def build_thin_walls():
    sheets = Builder("thin walls without thickness", kind="feature", feature="thin walls", thickness=0.0)
    plates = Builder("thin walls of a centimetre", kind="feature", feature="thin walls", thickness=0.01)
    for i in range(6):
        y = 14 + 2 * i
        shift = 1.2 * (i % 2)
        a, b = (8 + shift, y, BURIED), (12 + shift, y, BURIED)
        c, d = (12 + shift, y, 2.5), (8 + shift, y, 2.5)
        sheets.face("plaster", *((a, b, c, d) if i % 2 == 0 else (d, c, b, a)))
        plates.box("plaster", -13.2 + shift, y, -9.2 + shift, y + 0.01, BURIED, 2.5)
    # Two more at right angles, so that there are corners made of sheets.
    sheets.face("plaster", (8, 14, BURIED), (8, 24, BURIED), (8, 24, 2.5), (8, 14, 2.5))
    plates.box("plaster", -13.21, 14, -13.2, 24, BURIED, 2.5)
    sheets.finish()
    plates.finish()


def build_corners():
    """Corners of 10 to 170 degrees that point south: outer ones (wedges) in the west, inner ones in the east."""
    for i, angle in enumerate(range(10, 180, 20)):
        half = math.radians(angle / 2)
        column, row = i % 3, i // 3
        y = -24.5 + 4.4 * row
        x = -30 + 5.5 * column
        wedge = Builder(f"outer corner {angle}", kind="feature", feature="outer corner", angle_deg=angle)
        dx, dy = 1.6 * math.sin(half), 1.6 * math.cos(half)
        wedge.prism("rock", [(x, y), (x + dx, y + dy), (x - dx, y + dy)], BURIED, 2.2)
        wedge.finish()

        x, y = 18 + 5.5 * column, y + 1.8
        nook = Builder(f"inner corner {angle}", kind="feature", feature="inner corner", angle_deg=angle)
        dx, dy, t = 2 * math.sin(half), -2 * math.cos(half), 0.12
        ox, oy = t * math.cos(half), t * math.sin(half)
        right, right_out = (x + dx, y + dy), (x + dx + ox, y + dy + oy)
        left, left_out = (x - dx, y + dy), (x - dx - ox, y + dy + oy)
        tip, tip_out = (x, y), (x, y + t / math.sin(half))
        nook.prism("plaster", [tip, right, right_out, tip_out, left_out, left], BURIED, 2.2, cap=False)
        nook.face("plaster", *[(*p, 2.2) for p in (tip, right, right_out, tip_out)])
        nook.face("plaster", *[(*p, 2.2) for p in (tip, tip_out, left_out, left)])
        nook.finish()


def build_dome():
    dome = Builder("dome", kind="feature", feature="dome", radius=4.5)
    segments, rings, radius, y0 = 48, 16, 4.5, 19

    def at(ring, segment):
        rise, turn = math.pi / 2 * ring / rings, 2 * math.pi * (segment % segments) / segments
        return (radius * math.cos(rise) * math.cos(turn), y0 + radius * math.cos(rise) * math.sin(turn),
                radius * math.sin(rise))

    for ring in range(rings):
        for k in range(segments):
            a, b = at(ring, k), at(ring, k + 1)
            if ring == rings - 1:
                dome.face("stone", a, b, (0, y0, radius))
            else:
                c, d = at(ring + 1, k + 1), at(ring + 1, k)
                dome.face("stone", a, b, c)
                dome.face("stone", a, c, d)
    dome.finish()


def build_low_ceilings():
    walls = Builder("low ceiling walls", kind="feature", feature="tunnel", width=3.0)
    walls.box("plaster", 22.7, 13, 23, 25, BURIED, 2.6)
    walls.box("plaster", 26, 13, 26.3, 25, BURIED, 2.6)
    walls.finish()
    for y, clear in ((13, 1.9), (17, 1.7), (21, 1.2)):
        roof = Builder(f"low ceiling {clear}", kind="feature", feature="low ceiling", height=clear)
        roof.box("wood", 23, y, 26, y + 4, clear, 2.6, skip=(1, 3), floor=True)
        roof.finish()


def build_crevice():
    crevice = Builder("crevice", kind="feature", feature="crevice", widest=1.2, narrowest=0.0, length=11.0)
    crevice.prism("rock", [(-30, 13), (-24.6, 13), (-24, 24), (-24, 25), (-30, 25)], BURIED, 3.0, skip=(2,))
    crevice.prism("rock", [(-23.4, 13), (-18, 13), (-18, 25), (-24, 25), (-24, 24)], BURIED, 3.0, skip=(3,))
    crevice.finish()


def place_markers():
    marker("spawn", (*SPAWN, 0), kind="spawn")
    marker("goal", (0, 19, 4.5), kind="goal")
    # A tour for the middle of a body, a metre above the floor.
    tour = [(0, -20, 1), (0, -12, 1), (-28.9, -12, 1), (-28.9, 0.2, 1), (-28.9, 4.6, 3.4), (-20, 7, 3.4), (20, 7, 3.4),
            (17.35, 5, 3.4), (17.35, -6, 1), (12.5, -6, 1), (12.5, 12, 1), (6.5, 12.5, 1), (6.5, 24, 1), (-8, 26, 1),
            (-15.5, 26, 1), (-15.5, 12, 1), (-24, 12, 1), (-24, 18, 1)]
    for order, place in enumerate(tour):
        marker(f"tour {order:02}", place, kind="waypoint", route="tour", order=order)


def main():
    target = sys.argv[sys.argv.index("--") + 1]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    west, east = (-33.0, -17.0), (13.5, 33.5)
    build_ground()
    build_court()
    build_terrace("terrace west", *west)
    build_terrace("terrace east", *east)
    build_stairs()
    build_ramps()
    build_bridge(west[1], east[0])
    build_ledges(west, east)
    build_thin_walls()
    build_corners()
    build_dome()
    build_low_ceilings()
    build_crevice()
    place_markers()
    bpy.ops.export_scene.gltf(filepath=target, export_format="GLB", export_extras=True, export_yup=True,
                              export_normals=False, export_texcoords=False, export_colors=False,
                              export_animations=False, export_skins=False, export_morph=False)


main()
