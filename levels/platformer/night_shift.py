"""Night Shift: all four kinds of enemies, keys and doors, and everything that was learnt before.

    blender -b --factory-startup --python-exit-code 1 -P levels/platformer/night_shift.py -- levels/platformer/night-shift.glb
"""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))

from kit import Level  # noqa: E402

PALETTE = {
    "top": "#6f86a0", "trim": "#c3cfe6", "side": "#71608f", "rock": "#4b4a78", "path": "#a7a3b4", "accent": "#a06ab8",
    "leaf": "#2f7a72", "light leaf": "#58a592", "trunk": "#4a3f5a", "far": "#3c4672", "far top": "#56628f",
    "machine": "#2f7f86", "machine trim": "#8fe0dc",
}


def house(k, along0, along1, width, tall, shift=0.0, up=0.0):
    """A dark house with lit windows, to run around and to stand on."""
    k.wall(along0, along1, width, up, up + tall, shift=shift)
    long = along1 - along0
    for side in (-1, 1):
        for i in range(max(1, int(long // 2))):
            a = along0 + long * (i + 0.5) / max(1, int(long // 2))
            x = shift + side * (width / 2 + 0.03)
            k.decor.extrude(k.frame, [(a - 0.35, up + tall * 0.45), (a + 0.35, up + tall * 0.45), (a + 0.35, up + tall * 0.75), (a - 0.35, up + tall * 0.75)],
                            x - 0.04, x + 0.04, [None] * 4, "window")


def rampart(k, along, far=17.0, **lock):
    """A wall across the way with a door in it, and bastions at its ends, out over the deep where nobody gets around."""
    for edge in (-1, 1):
        k.wall(along - 0.5, along + 0.5, far - 1.7, 0, 7.0, shift=(far + 1.7) / 2 * edge)
        k.tower(along, far * edge, 1.8, -9, 8.4, corners=10)
        k.lamp(along, far * edge, up=8.4, tall=1.0)
    k.wall(along - 0.45, along + 0.45, 3.6, 3.3, 7.2)
    k.door(along, width=3.2, tall=3.1, **lock)


def the_gate_house(k):
    """Taught: keys and doors. A guard walks his round, and the key lies on it; the door is in sight."""
    k.beat("The gate house", "The red key opens the red door.", eye=(-5, -3, 5.5), look=(14, 1, 0))
    k.island(-6, 22.4, 20, deep=9, chamfer=3)
    k.patch(-2, 20.8, 3)
    k.spawn(-3)
    k.prompt(2, "A key opens the door of its colour", long=8, width=16)
    k.key(15, -6.5, 1.0, door="red")
    k.enemy("patroller", 11, -8, 0, route=[(0, 0), (8, 0), (8, 5), (0, 5)], sight=7, leash=8)
    house(k, 6, 10, 4, 3.4, shift=6)
    house(k, 12, 15, 4, 2.6, shift=6.2)
    house(k, 4, 8, 3.5, 2.4, shift=-6)
    for a, x in ((3, 2.6), (12, 2.6), (20, -2.6)):
        k.lamp(a, x)
    k.coins(2, 9, 4)
    k.coins(12, 18, 3, across0=-6.5)
    rampart(k, 21.7, door="red")
    k.island(21.6, 31.6, 7, up=-0.03, deep=6, chamfer=0.5)
    k.checkpoint(26, "The street", up=-0.03)
    k.go(31)


def the_street(k):
    """Tested: chasers between houses. On the roofs nobody bites."""
    k.beat("The street", "They wait in the alleys. The roofs are yours.", eye=(-4, -2.5, 5), look=(15, 0, 0.5))
    k.island(-0.6, 32, 20, up=-0.04, deep=9, chamfer=2)
    house(k, 5, 11, 5, 2.3, shift=-5)
    house(k, 14, 19, 5, 2.6, shift=-5)
    house(k, 22, 27, 5, 2.9, shift=-5)
    house(k, 6, 13, 5, 3.6, shift=6)
    house(k, 18, 26, 5, 4.4, shift=6)
    k.enemy("chaser", 13, 0, -0.04, sight=8, leash=9)
    k.enemy("chaser", 23, 1, -0.04, sight=8, leash=9)
    k.coins(6, 10, 3, across0=-5, up=3.2)
    k.coins(15, 18, 3, across0=-5, up=3.5)
    k.coins(23, 26, 3, across0=-5, up=3.8)
    k.coins(5, 28, 5, across0=0.5)
    k.star(22, 6, 5.6)       # on the highest roof: two jumps and an edge
    k.coin(15.6, 6, 4.2)
    k.slab(14.4, 16.8, 3.0, shift=6, up=3.2, thick=0.5)
    for a, x in ((3, -2), (16, 2.6), (29, -2)):
        k.lamp(a, x)
    k.heart(29.5, 6)
    k.go(32)


def the_yard(k):
    """Tested: jumpers among columns over the deep. Where you can jump, they can."""
    k.beat("The columns", "What you can jump, they can.", eye=(-5, -4, 5.5), look=(13, 0, 0))
    k.column(4.4, -0.6, 2.0, up=0.4, deep=8)
    k.column(10.2, 1.4, 2.2, up=0.8, deep=8)
    k.column(16.2, -0.8, 2.0, up=1.2, deep=8)
    k.column(10.0, -5.0, 1.8, up=1.0, deep=7)
    k.enemy("jumper", 10.2, 1.4, 0.8, sight=9, leash=9)
    k.coins(3.6, 5.2, 2, across0=-0.6, up=1.4)
    k.coins(6.8, 8, 2, across0=0.4, across1=0.8, up=2.2)
    k.coins(12.6, 14, 2, across0=0.6, across1=0.1, up=2.4)
    k.coin(10.0, -5.0, 2.0)
    k.go(20.2, up=1.2)
    k.island(0, 11, 15, deep=9, chamfer=2.5)
    k.checkpoint(5.5, "The gallery")
    k.lamp(2.5, 4)
    k.lamp(8.5, -4)
    k.tree(9, 5, tall=4.5)
    k.go(5.5, turn=90)
    k.go(7.2)


def the_gallery(k):
    """Tested: two shooters over a bridge; ferries carry the cover along."""
    k.beat("The gallery", "Stay behind what moves.", eye=(-5, 2, 5.5), look=(14, 0, 0))
    k.island(-0.2, 3, 6, up=-0.04, deep=6)
    k.column(11, -13, 2.2, up=2.6, deep=12)
    k.enemy("shooter", 11, -13, 2.6, sight=17, leash=4)
    k.column(21, 13, 2.2, up=2.6, deep=12)
    k.enemy("shooter", 21, 13, 2.6, sight=17, leash=4)
    first = k.platform(5.0, 0, 0, to=[(7.0, 0, 0)], long=3.4, width=3.6, speed=2.0, pause=1.2)
    k.way(2.4, (15.2, 0, 0), "ride", by=first)
    k.slab(14.0, 18.4, 5.0, thick=0.9)
    k.wall(15.0, 17.4, 0.5, 0, 2.0, shift=2.0, material="accent")
    k.wall(15.0, 17.4, 0.5, 0, 2.0, shift=-2.0, material="accent")
    second = k.platform(20.6, 0, 0, to=[(7.0, 0, 0)], long=3.4, width=3.6, speed=2.2, pause=1.0)
    k.way(17.8, (30.4, 0, 0), "ride", by=second)
    k.coins(5, 12, 4, up=1.0)
    k.coins(21, 27, 4, up=1.0)
    k.go(29.4)
    k.island(0, 14, 15, deep=9, chamfer=2.5)
    k.checkpoint(4, "The works")
    k.heart(4, 4)
    house(k, 7, 11, 4, 3.0, shift=4.6)
    k.lamp(3, -4)
    k.go(14)


def the_works(k):
    """Tested: what turns, rolls and falls, below a low roof; the blue key lies at the end of a side way."""
    k.beat("The works", "Under, over, between. The blue key is aside.", eye=(-8, -4, 5.5), look=(13, 0, 0))
    k.island(-0.6, 27, 13, up=-0.04, deep=9, chamfer=1.5)
    for edge in (-1, 1):
        k.wall(3, 7.4, 9.0, 0, 6.0, shift=6.35 * edge)
    k.tunnel(3.1, 7.3, 2.6, 1.15, up=-0.04, roof="side", thick=0.5)
    k.wall(3.2, 7.2, 3.8, 1.75, 5.8)
    k.way(2.2, (8.4, 0, 0), "crouch")
    k.coins(4, 6.6, 3, up=0.55)
    k.sweeper(12.6, 0, up=-0.04, reach=3.6, deg_per_s=65, arms=2)
    k.coin_ring(12.6, 0, 2.6, 4)
    k.roller(18, -3.5, 0.55, width=0.9, to=[(0, 7, 0)], speed=3.0)
    k.roller(20.5, 3.5, 0.55, width=0.9, to=[(0, -7, 0)], speed=3.6)
    k.coins(17, 22, 3)
    for a in (9.5, 15, 21.5):
        k.lamp(a, -5)
    # The blue key: three boards to the right, the last of which crumbles.
    k.slab(15.6, 18.6, 3.0, shift=10.0, up=0.6, thick=0.6)
    k.crumble(15.8, 18.4, 2.6, shift=14.8, up=1.0)
    k.column(17.1, 19.8, 1.7, up=1.4, deep=6)
    k.key(17.1, 19.8, 2.4, door="blue")
    k.coins(17.1, 17.1, 3, across0=9.4, across1=15.4, up=1.8, up1=2.2)
    rampart(k, 25.5, far=14, door="blue")
    k.go(27)


def the_back_stairs(k):
    """Twisted: off the walls, up a chimney that a shooter looks into; then a dash over the yard."""
    k.beat("The back stairs", "Up between the walls, then far across.", eye=(-0.5, -4.0, 4.5), look=(11, 0.5, 2.5))
    k.island(-0.6, 9.6, 11, up=-0.08, deep=9, chamfer=1.5)
    k.checkpoint(1.6, "The back stairs")
    for edge in (-1, 1):
        k.bare_wall(4.6, 9.2, 1.0, -0.6, 8.0, shift=2.0 * edge, bands=2)      # 3 m apart
    k.block(8.6, 16.4, 8.0, -2, 5.2, chamfer=0.4)
    k.patch(9.1, 16.0, 7.2, up=5.2, material="top")
    k.way(5.6, (10.4, 0, 5.23), "wall_jump")
    k.coins(7, 7.8, 3, up=1.4, up1=5.0)
    k.camera(4, 9, 5, 9, pitch=25, distance=6.5)
    k.column(22, -10, 2.0, up=6.4, deep=12)
    k.enemy("shooter", 22, -10, 6.4, sight=15, leash=4)
    k.wall(12.4, 13.2, 3, 5.2, 7.0, shift=0, material="accent")
    k.way(15.8, (24.4, 0, 5.2), "dash", up=5.23)
    k.coins(17, 22.4, 4, up=6.6, arc=1.3)
    k.slab(10.6, 13.2, 2.4, shift=8.6, up=7.0, thick=0.6)     # a star: from the roof aside, two jumps
    k.star(11.9, 8.6, 8.1)
    k.coin(12.2, 5.8, 7.8)
    k.go(23.4, up=5.2)
    k.island(0, 14, 15, deep=9, chamfer=2.5)
    k.checkpoint(5, "The square")
    k.tree(3, -5, tall=5)
    k.tree(11, 5, tall=4.5)
    k.lamp(3, 4)
    k.heart(9, -4)
    k.go(7, turn=-90)
    k.go(7.2)


def the_square(k):
    """Concluded: a square with one of each. The door at its end wants coins; they lie in plain sight."""
    k.beat("The square", "One of each; the golden door wants twenty coins.", eye=(-5, 1.5, 6), look=(15, 0, 0))
    k.prompt(2, "The golden door opens for 20 coins", long=8, width=16)
    k.island(-0.6, 31, 24, up=-0.04, deep=10, chamfer=4)
    k.patch(6, 26, 14, up=-0.04, chamfer=4)
    k.block(14.6, 17.4, 2.8, 0, 1.2, chamfer=0.5, material="accent")
    k.block(15.2, 16.8, 1.6, 1.2, 2.6, chamfer=0.3, material="accent")
    k.enemy("patroller", 10, -6, -0.01, route=[(0, 0), (0, 12), (12, 12), (12, 0)], sight=8, leash=9)
    k.enemy("chaser", 22, 3, -0.01, sight=8, leash=8)
    k.enemy("jumper", 20, -5, -0.01, sight=8, leash=8)
    k.column(16, 18, 2.0, up=2.2, deep=10)
    k.enemy("shooter", 16, 18, 2.2, sight=14, leash=4)
    for a, x in ((8, 7), (24, -7), (8, -7), (24, 7)):
        k.wall(a - 1.2, a + 1.2, 0.7, 0, 2.0, shift=x, material="side")
    k.coin_ring(16, 0, 5, 10)
    k.coins(6, 10, 3, across0=-9, across1=-9)
    k.coins(22, 26, 3, across0=9, across1=9)
    for a, x in ((4, 9), (4, -9), (25, 10), (25, -10)):
        k.lamp(a, x)
    k.star(16, 0, 4.2)     # over the block in the middle of it all
    rampart(k, 29.9, far=19, coins=20)
    k.go(31)
    k.island(-0.4, 20, 15, up=0.0, deep=10, chamfer=3)
    k.patch(1.5, 9, 2.8)
    for side in (-1, 1):
        k.tree(4, 5 * side, tall=5)
        k.lamp(8, 3.2 * side)
    k.coins(3, 8, 3)
    k.goal(13.5)


if __name__ == "__main__":
    level = Level("Night Shift", "Four kinds of enemies, three doors, and all of the above.", order=6, par=150, silver=210, bronze=320, palette=PALETTE,
                  far_towers=True, drawings={"side": "bricks", "path": "bricks"}, kill_y=-9,
                  music="lively", sky="night", secret=False, stars_needed=0)
    level.play(the_gate_house, the_street, the_yard, the_gallery, the_works, the_back_stairs, the_square)
    level.write()
