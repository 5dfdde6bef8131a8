"""A level's .glb as lists of triangles and markers, in the file's axes (+Y up), read with nothing but Python."""

import itertools
import json
import math
import struct

CELL = 4.0  # metres; triangles are found by the cells of the plan that they touch


def read(path):
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:], len(data)


class Node:
    def __init__(self, name, extras, place, triangles, surfaces):
        self.name, self.extras, self.place, self.triangles = name, extras, place, triangles
        self.surfaces = surfaces  # the name of each triangle's material
        self.kind = extras.get("kind")


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


class Level:
    def __init__(self, tree, binary, size):
        self.bytes = size
        self.nodes = [self.node(tree, binary, node) for node in tree["nodes"]]
        self.grid = {}
        for node in self.nodes:
            if node.triangles and node.kind != "decor":
                for t in node.triangles:
                    self.put(t, node)

    @staticmethod
    def node(tree, binary, node):
        place = tuple(node.get("translation", (0, 0, 0)))
        triangles, surfaces = [], []
        primitives = tree["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []
        for primitive in primitives:
            def values(accessor, kinds={5121: "B", 5123: "H", 5125: "I", 5126: "f"}):
                info = tree["accessors"][accessor]
                count = info["count"] * {"SCALAR": 1, "VEC3": 3}[info["type"]]
                start = tree["bufferViews"][info["bufferView"]].get("byteOffset", 0) + info.get("byteOffset", 0)
                return struct.unpack_from(f"<{count}{kinds[info['componentType']]}", binary, start)

            flat = values(primitive["attributes"]["POSITION"])
            points = [tuple(p + o for p, o in zip(flat[i:i + 3], place)) for i in range(0, len(flat), 3)]
            ids = values(primitive["indices"])
            triangles += [(points[ids[i]], points[ids[i + 1]], points[ids[i + 2]]) for i in range(0, len(ids), 3)]
            name = tree["materials"][primitive["material"]]["name"] if "material" in primitive else ""
            surfaces += [name] * (len(ids) // 3)
        return Node(node.get("name", ""), node.get("extras", {}).get("surefoot", {}), place, triangles, surfaces)

    def of(self, *kinds):
        return [node for node in self.nodes if node.kind in kinds]

    def put(self, t, node):
        x0, x1 = (f(p[0] for p in t) for f in (min, max))
        z0, z1 = (f(p[2] for p in t) for f in (min, max))
        for i in range(math.floor(x0 / CELL), math.floor(x1 / CELL) + 1):
            for k in range(math.floor(z0 / CELL), math.floor(z1 / CELL) + 1):
                self.grid.setdefault((i, k), []).append((t, node))

    def crossings(self, x, z):
        """(height, whether the face looks up, node) of every solid face on the plumb line through x, z."""
        for t, node in self.grid.get((math.floor(x / CELL), math.floor(z / CELL)), ()):
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = t
            area = (bz - az) * (cx - ax) - (bx - ax) * (cz - az)  # twice, seen from above; positive looks up
            if abs(area) < 1e-9:
                continue
            v = ((z - az) * (cx - ax) - (x - ax) * (cz - az)) / area
            w = ((bz - az) * (x - ax) - (bx - ax) * (z - az)) / area
            if v >= -1e-7 and w >= -1e-7 and v + w <= 1 + 1e-7:
                yield ay + v * (by - ay) + w * (cy - ay), area > 0, node

    def ground_below(self, place):
        return max((h for h, up, _ in self.crossings(place[0], place[2]) if up and h <= place[1] + 0.06), default=None)

    def height_above_ground(self, place, all_stops=False):
        """Above the still ground and what moves, at any of its stops if so wished; None over the deep."""
        tops = [self.ground_below(place)]
        if all_stops:
            for node in self.of("platform"):
                path = node.extras.get("path", [[0, 0, 0]])
                for a, b in zip(path, path[1:] + path[:1]):
                    for share in (0, 0.25, 0.5, 0.75):
                        off = [p + share * (q - p) for p, q in zip(a, b)]
                        at = [p - o for p, o in zip(place, off)]
                        if abs(at[0] - node.place[0]) > 8 or abs(at[2] - node.place[2]) > 8:
                            continue
                        tops += [h + off[1] for h, up, by in self.crossings(at[0], at[2])
                                 if by is node and up and h + off[1] <= place[1] + 0.06]
        tops = [t for t in tops if t is not None]
        return place[1] - max(tops) if tops else None

    def inside_solid(self, place):
        """The name of the node whose closed solids the place is in, or None: more fronts than backs above."""
        depth = {}
        for h, up, node in self.crossings(place[0] + 0.0013, place[2] + 0.0007):
            if h > place[1]:
                depth[node.name] = depth.get(node.name, 0) + (1 if up else -1)
        return next((name for name, count in sorted(depth.items()) if count > 0 and "one way" not in name
                     and not self.under_sheet(place, name)), None)

    def under_sheet(self, place, name):
        """Whether only a sheet without thickness is above: one-way floors have no underside."""
        surfaces = next(node for node in self.nodes if node.name == name)
        return "one way" in surfaces.surfaces

    def in_water(self, place):
        return any(all(abs(p - q) <= s / 2 + 1.0 for p, q, s in zip(place, node.place, node.extras["size"]))
                   for node in self.of("water"))

    def ground_within(self, place, aside, below):
        """Is there ground beside the place, at most so far aside and below: does a jump pass here?"""
        for r in (0, aside / 3, 2 * aside / 3, aside):
            for turn in range(0, 360, 30):
                x, z = place[0] + r * math.cos(math.radians(turn)), place[2] + r * math.sin(math.radians(turn))
                height = self.height_above_ground((x, place[1], z), all_stops=True)
                if height is not None and height <= below:
                    return True
        return False

    def falls_past(self, place):
        """Is there ground beside the place and not lower, to fall from, and ground below it to fall on to?"""
        below = self.ground_below(place)
        return below is not None and place[1] - below < 18 and any(
            up and -1.5 < h - place[1] < 25
            for r in (2, 4, 6, 8) for turn in range(0, 360, 20)
            for h, up, _ in self.crossings(place[0] + r * math.cos(math.radians(turn)), place[2] + r * math.sin(math.radians(turn))))

    def beside_way(self, place, near):
        """Is the place near the line of a way that needs a manoeuvre? One that is thrown flies above that line."""
        for way in self.of("way"):
            to, off = way.extras["to"], minus(place, way.place)
            if way.extras["how"] == "bounce" and 0 <= off[1] <= 7:
                to, off = (to[0], 0, to[2]), (off[0], 0, off[2])
            share = min(1, max(0, dot(off, to) / (dot(to, to) or 1)))
            rest = minus(off, [share * x for x in to])
            if dot(rest, rest) <= near * near:
                return True
        return False

    def solid_points(self):
        for node in self.nodes:
            if node.kind != "decor":
                for t in node.triangles:
                    yield from t

    def box(self):
        points = list(self.solid_points())
        return [min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)]

    def lowest_floor(self):
        """Of the places where something is collected or begins: the floor under the lowest of them."""
        floors = [self.ground_below(node.place) for node in self.of("coin", "star", "spawn", "goal", "checkpoint", "key", "heart")]
        return min(f for f in floors if f is not None)

    def thin_triangles(self):
        count = 0
        for node in self.nodes:
            for a, b, c in node.triangles:
                n = cross(minus(b, a), minus(c, a))
                count += dot(n, n) < 1e-12
        return count

    def fighting_faces(self):
        """Pairs of nodes with overlapping faces in one plane that look one way."""
        planes = {}
        for node in self.nodes:
            for t in node.triangles:
                n = cross(minus(t[1], t[0]), minus(t[2], t[0]))
                size = math.sqrt(dot(n, n))
                if size < 0.02:
                    continue
                n = tuple(x / size for x in n)
                middle = [sum(p[i] for p in t) / 3 for i in range(3)]
                key = tuple(round(x * 100) for x in n)
                planes.setdefault(key, []).append((dot(n, middle), t, node, n))
        for faces in planes.values():
            faces.sort(key=lambda f: f[0])
            for i, (d, t, node, n) in enumerate(faces):
                for other in itertools.islice(faces, i + 1, None):
                    if other[0] - d > 0.004:
                        break
                    if overlap_in_plane(t, other[1], n):
                        yield node.name, other[2].name, tuple(round(sum(p[k] for p in t) / 3, 1) for k in range(3))


def overlap_in_plane(s, t, n):
    """Do two triangles of one plane overlap by more than 5 mm? Separating axes are the edges' normals."""
    for triangle in (s, t):
        for i in range(3):
            axis = cross(n, minus(triangle[(i + 1) % 3], triangle[i]))
            size = math.sqrt(dot(axis, axis))
            if size == 0:
                return False
            a, b = ([dot(axis, p) / size for p in u] for u in (s, t))
            if min(max(a), max(b)) - max(min(a), min(b)) < 0.005:
                return False
    return True
