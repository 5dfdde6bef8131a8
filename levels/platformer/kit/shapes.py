"""Shapes: closed solids made of few faces, in a frame that walks along the level's way.

Everything here is in Blender's axes, metres, +Z up. A `Frame` is a place and a heading; a place in it is told as
(along, across, up): along the way, to the right of it, and above its ground.
"""

import math


class Frame:
    """A place on the way and the heading there: 0 degrees is north (+Y), 90 is east (+X)."""

    def __init__(self, x=0.0, y=0.0, z=0.0, heading=0.0):
        self.x, self.y, self.z, self.heading = x, y, z, heading

    def axes(self):
        turn = math.radians(self.heading)
        s, c = round(math.sin(turn), 9), round(math.cos(turn), 9)
        return (s, c), (c, -s)  # along, across

    def at(self, along=0.0, across=0.0, up=0.0):
        (ax, ay), (bx, by) = self.axes()
        return (round(self.x + along * ax + across * bx, 4), round(self.y + along * ay + across * by, 4),
                round(self.z + up, 4))

    def turn(self, along, across=0.0, up=0.0):
        """A direction, without the place."""
        (ax, ay), (bx, by) = self.axes()
        return (round(along * ax + across * bx, 4), round(along * ay + across * by, 4), round(up, 4))

    def moved(self, along=0.0, across=0.0, up=0.0, turn=0.0):
        return Frame(*self.at(along, across, up), (self.heading + turn) % 360)


class Mesh:
    """Collects the faces of one node; corners are counter-clockwise when seen from the front."""

    def __init__(self, origin=(0.0, 0.0, 0.0)):
        self.origin = origin
        self.vertices, self.index, self.faces, self.materials = [], {}, [], []

    def vertex(self, p):
        key = tuple(round(a - b, 4) + 0.0 for a, b in zip(p, self.origin))
        if key not in self.index:
            self.index[key] = len(self.vertices)
            self.vertices.append(key)
        return self.index[key]

    def face(self, material, *corners):
        ids = [self.vertex(p) for p in corners]
        kept = [v for i, v in enumerate(ids) if v != ids[i - 1]]  # a ring that shrank to a point leaves triangles
        if len(set(kept)) == len(kept) >= 3:
            self.faces.append(kept)
            self.materials.append(material)

    def triangles(self):
        return sum(len(face) - 2 for face in self.faces)

    def loft(self, frame, outline, rings, materials, top=None, bottom=None):
        """Stacked rings of one outline, joined by bands; `materials` has one for each band.

        `outline`: (across, along) counter-clockwise from above, about the frame's place. `rings`: (up, inset) from the
        highest to the lowest; an inset draws the outline in on both axes, a third number shifts the ring by (across,
        along).
        """
        wide = max(abs(x) for x, _ in outline)
        deep = max(abs(y) for _, y in outline)
        placed = []
        for up, inset, *shift in rings:
            sx, sy = (max(0.0, half - inset) / half for half in (wide, deep))
            dx, dy = shift[0] if shift else (0, 0)
            placed.append([frame.at(y * sy + dy, x * sx + dx, up) for x, y in outline])
        n = len(outline)
        for upper, lower, material in zip(placed, placed[1:], materials):
            for i in range(n):
                j = (i + 1) % n
                self.face(material, lower[i], lower[j], upper[j], upper[i])
        if top:
            self.face(top, *placed[0])
        if bottom:
            self.face(bottom, *reversed(placed[-1]))

    def extrude(self, frame, profile, across0, across1, materials, side):
        """A profile of (along, up) drawn from one side to the other; `materials` has one for each of its edges."""
        n = len(profile)
        area = sum(profile[i][0] * profile[(i + 1) % n][1] - profile[(i + 1) % n][0] * profile[i][1] for i in range(n))
        edges = list(zip(profile, profile[1:] + profile[:1], materials))
        if area < 0:
            profile = profile[::-1]
            edges = [(b, a, material) for a, b, material in reversed(edges)]
        for (a, u), (b, v), material in edges:
            if material:
                self.face(material, frame.at(a, across1, u), frame.at(a, across0, u), frame.at(b, across0, v),
                          frame.at(b, across1, v))
        if side:
            self.face(side, *[frame.at(a, across1, u) for a, u in profile])
            self.face(side, *[frame.at(a, across0, u) for a, u in reversed(profile)])


def rectangle(wide, deep, chamfer=0.0):
    """(across, along), counter-clockwise, with cut corners if there is a chamfer."""
    x, y, c = wide / 2, deep / 2, chamfer
    if c <= 0:
        return [(-x, -y), (x, -y), (x, y), (-x, y)]
    return [(-x + c, -y), (x - c, -y), (x, -y + c), (x, y - c), (x - c, y), (-x + c, y), (-x, y - c), (-x, -y + c)]


def ring(radius, corners, turn=0.0):
    step = 360 / corners
    return [(radius * math.cos(math.radians(step * i + turn)), radius * math.sin(math.radians(step * i + turn)))
            for i in range(corners)]
