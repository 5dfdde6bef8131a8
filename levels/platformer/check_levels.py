#!/usr/bin/env python3
"""Is every level of the platformer whole? Reads the .glb files alone, as the game does.

    levels/platformer/check_levels.py                    # all beside this file
    levels/platformer/check_levels.py my-level.glb       # one
    levels/platformer/check_levels.py --self-test        # spoils a level in many ways and sees each found
"""

import copy
import math
import pathlib
import sys

sys.dont_write_bytecode = True

from level_file import Level, read  # noqa: E402

HERE = pathlib.Path(__file__).parent
STILL_TRIANGLES = 12_000
FILE_BYTES = 600_000
SOLID_KINDS = {"platform", "turntable", "crumble", "door", "bounce", "hazard"}
NUMBERS = {  # kind: {extra: (least, most)}; all of them must be there
    "level": {"order": (1, 99), "par": (20, 900), "kill_y": (-500, 500), "stars_needed": (0, 300)},
    "goal": {"radius": (0.5, 6)},
    "checkpoint": {"order": (1, 20)},
    "beat": {"order": (1, 20)},
    "platform": {"speed": (0.3, 12), "pause": (0, 10), "phase": (0, 120)},
    "turntable": {"deg_per_s": (-180, 180)},
    "crumble": {"delay": (0.2, 5), "back": (1, 30)},
    "bounce": {"speed": (5, 25)},
    "enemy": {"sight": (2, 40), "leash": (2, 40)},
    "hazard": {"damage": (1, 3)},
}
WORDS = {
    ("level", "music"): {"calm", "lively"}, ("level", "sky"): {"day", "dusk", "night", "cave"},
    ("platform", "loop"): {"back", "round", "once"}, ("platform", "starts"): {"always", "ridden"},
    ("enemy", "type"): {"chaser", "patroller", "jumper", "shooter"},
    ("way", "how"): {"ride", "wall_jump", "dash", "bounce", "swim", "climb", "crouch"},
}
ALLOWED = {"level", "spawn", "goal", "checkpoint", "coin", "star", "heart", "key", "prompt", "water", "camera", "enemy",
           "beat", "way", "decor"} | SOLID_KINDS


def vectors(value):
    return isinstance(value, list) and all(
        isinstance(p, list) and len(p) == 3 and all(isinstance(x, (int, float)) and math.isfinite(x) for x in p) for p in value)


def check_marks(level):
    """What is there, how often, and with which numbers."""
    names = [node.name for node in level.nodes]
    for name in sorted({n for n in names if names.count(n) > 1}):
        yield f"two nodes are named '{name}'"
    for kind, count in (("level", 1), ("spawn", 1), ("goal", 1), ("star", 3)):
        found = len(level.of(kind))
        if found != count:
            yield f"{found} nodes of kind {kind} instead of {count}"
    for kind, least, most in (("coin", 30, 120), ("checkpoint", 3, 8), ("beat", 6, 12), ("heart", 1, 8)):
        if not least <= len(level.of(kind)) <= most:
            yield f"{len(level.of(kind))} of kind {kind}, not {least} to {most}"
    for kind in ("checkpoint", "beat"):
        orders = sorted(node.extras.get("order", 0) for node in level.of(kind))
        if orders != list(range(1, len(orders) + 1)):
            yield f"{kind}s are numbered {orders}"
    for node in level.nodes:
        kind = node.kind
        if kind and kind not in ALLOWED:
            yield f"'{node.name}' is of the unknown kind {kind}"
        for extra, (least, most) in NUMBERS.get(kind, {}).items():
            if kind == "hazard" and extra not in node.extras:
                yield f"'{node.name}' has no {extra}"
            value = node.extras.get(extra)
            if not isinstance(value, (int, float)) or not least <= value <= most:
                yield f"'{node.name}': {extra} is {value}, not {least} to {most}"
        for (of, extra), words in WORDS.items():
            if kind == of and node.extras.get(extra) not in words:
                yield f"'{node.name}': {extra} is {node.extras.get(extra)}"
        for extra in ("path", "route"):
            if extra in node.extras and not vectors(node.extras[extra]):
                yield f"'{node.name}': {extra} is no list of places"
        if kind == "platform" and (len(node.extras.get("path", [])) < 2 or node.extras["path"][0] != [0, 0, 0]):
            yield f"'{node.name}': a path has two stops or more and begins at 0, 0, 0"
        for extra in ("size", "to", "eye", "look"):
            if extra in node.extras and not vectors([node.extras[extra]]):
                yield f"'{node.name}': {extra} has not three numbers"
        if "size" in node.extras and min(node.extras["size"]) <= 0:
            yield f"'{node.name}': an empty box"
        if kind == "way" and "by" in node.extras and node.extras["by"] not in names:
            yield f"'{node.name}': there is no '{node.extras['by']}'"
    doors = {node.extras.get("door") for node in level.of("door")} - {None}
    keys = {node.extras.get("door") for node in level.of("key")}
    if doors != keys:
        yield f"doors {sorted(doors)} but keys {sorted(keys)}"
    for node in level.of("door"):
        if node.extras.get("coins", 0) > len(level.of("coin")) * 0.6:
            yield f"'{node.name}' wants {node.extras['coins']} of {len(level.of('coin'))} coins"


def check_times(level):
    """Medals are in order, and par is a time between the best of them and the least."""
    for node in level.of("level"):
        par = node.extras.get("par", 0)
        gold, silver, bronze = (node.extras.get(medal, par * share) for medal, share in (("gold", 1), ("silver", 1.35), ("bronze", 1.9)))
        if not gold <= silver <= bronze or not gold <= par <= bronze:
            yield f"par {par} s, gold {gold} s, silver {silver} s, bronze {bronze} s are not in order"
        if not 60 <= gold <= 240 or bronze > 420:
            yield f"gold at {gold} s and bronze at {bronze} s: a first run would not last two to six minutes"


def check_size(level):
    still = sum(len(node.triangles) for node in level.nodes if not node.kind or node.kind == "decor")
    if still > STILL_TRIANGLES:
        yield f"{still} triangles that stand still, more than {STILL_TRIANGLES}"
    if level.bytes > FILE_BYTES:
        yield f"{level.bytes} bytes, more than {FILE_BYTES}"


def check_footing(level):
    """What stands somewhere stands over ground; coins are within reach; the deep is below all ground."""
    for kind, least, most in (("spawn", -0.05, 0.3), ("goal", -0.05, 0.3), ("checkpoint", -0.05, 0.3),
                              ("enemy", -0.05, 0.3), ("heart", 0.3, 2.5), ("key", 0.3, 2.5), ("star", 0.3, 4.0)):
        for node in level.of(kind):
            below = level.height_above_ground(node.place, all_stops=True)
            if below is None or not least <= below <= most:
                yield f"'{node.name}' is {below if below is None else round(below, 2)} m above ground"
    for node in level.of("coin"):
        inside = level.inside_solid(node.place)
        if inside:
            yield f"'{node.name}' is within '{inside}'"
        below = level.height_above_ground(node.place, all_stops=True)
        if below is not None and 0.3 <= below <= 2.5 or level.in_water(node.place):
            continue
        if not level.ground_within(node.place, 3.6, 3.2) and not level.beside_way(node.place, 3.2) \
                and not level.falls_past(node.place):
            yield f"'{node.name}' is out of reach: no ground near"
    low, high = level.box()
    kill = level.of("level")[0].extras.get("kill_y", 0) if level.of("level") else 0
    lowest = level.lowest_floor()
    if not lowest - 14 <= kill <= lowest - 2:
        yield f"kill_y is {kill}, the lowest floor is at {lowest:.1f}"
    for node in level.of("platform", "hazard"):
        for stop in node.extras.get("path", []):
            place = [a + b for a, b in zip(node.place, stop)]
            if not all(a - 8 <= p <= b + 8 for a, p, b in zip(low, place, high)):
                yield f"'{node.name}' leaves the level at {place}"


def check_surfaces(level):
    """No two faces in one plane fight for the eye: coplanar, facing one way, of different solids, overlapping."""
    seen = set()
    for name, other, place in level.fighting_faces():
        if (name, other) not in seen:
            seen.add((name, other))
            yield f"faces of '{name}' and '{other}' lie in one plane at {place}"
    if level.thin_triangles():
        yield f"{level.thin_triangles()} triangles without area"


CHECKS = (check_marks, check_times, check_size, check_footing, check_surfaces)


def problems(level):
    return [problem for check in CHECKS for problem in check(level)]


def self_test():
    """Each way to spoil a good level has to be found."""
    path = HERE / "first-steps.glb"
    tree, rest, size = read(path)

    def first(tree, kind):
        return next(n for n in tree["nodes"] if n.get("extras", {}).get("surefoot", {}).get("kind") == kind)

    def moved(kind, up):
        def change(tree):
            node = first(tree, kind)
            x, y, z = node.get("translation", (0, 0, 0))
            node["translation"] = [x, y + up, z]
        return change

    def extra(kind, name, value):
        def change(tree):
            first(tree, kind)["extras"]["surefoot"][name] = value
        return change

    def doubled(kind):
        def change(tree):
            tree["nodes"].append(copy.deepcopy(first(tree, kind)))
        return change

    def copied_ground(tree):
        ground = copy.deepcopy(next(n for n in tree["nodes"] if "mesh" in n and n["name"].startswith("ground")))
        ground["name"] = "again"
        tree["nodes"].append(ground)

    faults = {"a second goal": doubled("goal"), "a coin in the sky": moved("coin", 30), "a floating spawn": moved("spawn", 2),
              "a buried star": moved("star", -3), "kill_y above the ground": extra("level", "kill_y", 3),
              "a par of nothing": extra("level", "par", 0), "silver before gold": extra("level", "silver", 70),
              "a level that is over in no time": extra("level", "gold", 30), "checkpoints out of order": extra("checkpoint", "order", 9),
              "an unknown kind": extra("heart", "kind", "hart"), "a ground twice": copied_ground,
              "a coin in a wall": moved("coin", -1.2)}
    missed = 0
    before = set(problems(Level(tree, rest, size)))
    for name, how in faults.items():
        spoilt = copy.deepcopy(tree)
        how(spoilt)
        found = set(problems(Level(spoilt, rest, size))) - before
        print(f"{'found ' if found else 'MISSED'}  {name}" + (f": {sorted(found)[0]}" if found else ""))
        missed += not found
    return missed


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    paths = [pathlib.Path(p) for p in sys.argv[1:]] or sorted(HERE.glob("*.glb"))
    bad = 0
    for path in paths:
        level = Level(*read(path))
        found = problems(level)
        bad += len(found)
        still = sum(len(node.triangles) for node in level.nodes if not node.kind)
        drawn = sum(len(node.triangles) for node in level.nodes)
        print(f"{path.name}: {still} still triangles, {drawn} in all, {len(level.of('coin'))} coins, "
              f"{len(level.of('checkpoint'))} checkpoints, {level.bytes // 1000} kB: {len(found) or 'no'} problems")
        for problem in found:
            print(f"    {problem}")
    return bad


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
