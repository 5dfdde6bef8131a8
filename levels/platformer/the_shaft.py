"""The Shaft: up a tower by its walls. Ladders, boards to jump through, walls to slide down and to jump off.

    blender -b --factory-startup --python-exit-code 1 -P levels/platformer/the_shaft.py -- levels/platformer/the-shaft.glb
"""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))

from kit import Level  # noqa: E402

PALETTE = {
    "top": "#c3b2d4", "trim": "#e6dbf2", "side": "#76639a", "rock": "#5a4a80", "path": "#a996c2", "accent": "#4fa79b",
    "crystal": dict(colour="#5fe0cc", glow=0.6), "leaf": "#3f8a7d", "light leaf": "#79c2ae", "trunk": "#4e3a55", "far": "#8f86ae", "far top": "#b8aecb",
    "machine": "#3c6f92", "machine trim": "#9fd0e6",
}
WAY = 9.5    # from the tower's middle to the middle of the way around it; the tower's own faces are at 7
HALF = 2.5   # half the width of the way
WALL = 2.5   # where the tower's face is, to the right of the way
TOP = 57.3   # of the tower


def corner(k, section=None, deep=5):
    """The way turns right around a corner of the tower, and goes on at the near end of the next face."""
    k.island(-HALF, HALF, 2 * HALF + 0.6, shift=-0.3, deep=deep, chamfer=0.8)
    k.lamp(1.4, -1.9)
    if section:
        k.checkpoint(-0.4, section, across=-0.4)
    k.go(turn=90)


def windows(k, *places):
    """Lit windows in the tower's face beside the way: (along, up) of their sills."""
    for a, up in places:
        k.decor.extrude(k.frame, [(a - 0.32, up), (a + 0.32, up), (a + 0.32, up + 0.9), (a, up + 1.25), (a - 0.32, up + 0.9)],
                        WALL - 0.04, WALL + 0.04, [None] * 5, "window")


def the_foot(k):
    """Taught: ladders. A courtyard before the tower, and a ladder on its first step."""
    k.beat("The foot of the tower", "Walk against the rungs to climb.", eye=(-5, 2.5, 4.5), look=(14, 1, 4))
    k.island(-6, 15.6, 17, deep=9, chamfer=3)
    k.patch(-2, 9, 2.8)
    k.spawn(-2.5)
    k.prompt(6, "Walk into a ladder to climb it; {crouch} climbs down", long=8, width=12)
    k.coins(1, 8, 4)
    for a, x, tall in ((-3, 6, 5), (2, -6.5, 6), (8, 6.2, 4.5)):
        k.tree(a, x, tall=tall)
    k.rock(5.5, 4.6)
    k.crystal(11, -6.3, size=1.6)
    k.meadow(-4, 9, 15, 10)
    k.block(10.6, 15.3, 13, 0, 4.2, chamfer=0.5)
    k.patch(11.1, 14.9, 12, up=4.2, material="top")
    k.ladder(10.6, 0, 4.23)
    k.way(10.0, (11.6, 0, 4.23), "climb")
    k.coins(10.2, 10.2, 3, up=1.3, up1=3.7)
    # The tower itself, in courses of two tones without a ledge, and the corner of the way at its south-west.
    k.go(18.4, up=4.2)
    k.island(-3.6, 2.5, 5, deep=5, chamfer=0.6, up=-0.05)
    middle = k.frame.moved(WAY, WAY)
    keep, k.frame = k.frame, middle
    k.bare_wall(-7, 7, 14, -16, TOP - middle.z, bands=8)
    k.frame = keep


def the_boards(k):
    """Taught: boards that are jumped through from below and stood on from above. A fall ends on the floor."""
    k.beat("Boards", "Jump up through the boards.", eye=(-4, -4.5, 4), look=(10, 0.5, 3))
    k.prompt(2, "Boards can be jumped through from below", long=7, width=8)
    k.island(2.2, 16.8, 5, up=-0.08, deep=5, chamfer=0.6)
    windows(k, (4.2, 2.6), (5.6, 6.6), (14.6, 2.4), (14.6, 9.2))
    for i, (a, up) in enumerate(((8, 2.1), (11.2, 4.2), (8, 6.3))):
        k.one_way(a - 1.8, a + 1.8, 4.2, up=up)
        k.coin(a, 0, up + 0.9)
        for edge in ((), (-1, 1), (-1,))[i]:
            k.block(a + 1.65 * edge - 0.12, a + 1.65 * edge + 0.12, 0.24, 0, up - 0.32, shift=-1.9, material="dark wood", top="dark wood")
    k.coins(8, 8, 2, up=1.2, up1=1.9)
    k.slab(11.6, 17.0, 4.4, up=6.86, thick=0.7)
    k.coins(12.4, 15, 2, up=7.8)
    k.slab(6.4, 9.6, 2.2, shift=-6.0, up=8.2, thick=0.6)     # a star outside, beyond a wide jump
    k.star(8, -6.0, 9.3)
    k.coin(8, -3.6, 8.9)
    k.go(19, up=6.9)
    corner(k, "The shaft")


def the_shaft(k):
    """Taught: off the walls. A shaft between the tower and an outer wall, with a floor: slide, jump, jump."""
    k.beat("The shaft", "Jump at the wall; slide; jump off it.", eye=(-4, 1.0, 3.5), look=(10, 0.5, 3))
    k.prompt(4, "{jump} while sliding down a wall to jump off it", long=8, width=8)
    k.island(2.2, 16.8, 5, up=-0.12, deep=5, chamfer=0.6)
    k.bare_wall(7, 12.6, 1.0, -0.6, 8.0, shift=-0.95, bands=2)     # 2.95 m from the tower
    k.block(12.2, 17.0, 4.96, 0, 5.34)
    k.patch(12.7, 16.4, 4.2, up=5.34, material="top")
    k.way(9.6, (13.6, 1.0, 5.43), "wall_jump", across=1.0)
    k.coins(9.6, 11, 4, across0=1.0, up=1.4, up1=5.6)
    k.heart(4, -1.6, 0.9)
    k.camera(6, 13, 5, 9, pitch=25, distance=6.5, up=0)
    k.go(19, up=5.4)
    corner(k, "The open shaft")


def the_open_shaft(k):
    """Tested: the same with nothing below. In by a jump, up by three, out at the far end."""
    k.beat("The open shaft", "No floor: keep jumping.", eye=(-4, 1.2, 3.5), look=(9, 0.5, 2))
    k.slab(1.6, 5.4, 4.6, thick=0.8, up=-0.03)
    k.bare_wall(6.2, 12.8, 1.0, -3, 8.2, shift=-1.05, bands=3)    # 3.05 m from the tower
    k.slab(6.4, 8.4, 2.6, shift=0.95, up=-1.2, thick=0.6)          # a small floor at the beginning: the last help
    k.block(12.4, 17.0, 4.96, -1.5, 5.14)
    k.patch(12.9, 16.4, 4.2, up=5.14, material="top")
    k.way(4.6, (13.8, 1.0, 5.23), "wall_jump", across=0.8)
    k.coins(9.4, 11.2, 4, across0=0.95, up=0.6, up1=5.4)
    k.camera(6, 13, 5, 10, pitch=25, distance=6.5, up=0)
    k.go(19, up=5.2)
    corner(k, "The gallery")


def the_gallery(k):
    """Tested: a shooter on a pillar outside. From cover to cover, between two shots."""
    k.beat("The gallery", "Wait behind stone, run between the shots.", eye=(-5, -3.5, 4), look=(10, -1, 0.5))
    k.prompt(1, "It shoots: stone stops bullets", long=6, width=8)
    k.island(2.2, 16.8, 5.2, up=-0.12, deep=5, chamfer=0.6)
    windows(k, (4.6, 2.4), (7.4, 2.4), (10.2, 2.4))
    for a in (4.6, 9.2, 13.8):
        k.wall(a - 0.9, a + 0.9, 0.6, 0, 2.2, shift=-1.9, material="accent")
    k.column(9.4, -12.5, 2.2, up=1.0, deep=14)
    k.enemy("shooter", 9.4, -12.5, 1.0, sight=18, leash=4)
    k.coins(4.4, 14, 5, across0=0.4)
    k.one_way(14.8, 17.4, 3.0, shift=1.0, up=2.3)      # a board on the tower, and a star on a shelf above it
    k.slab(11.6, 14.2, 1.8, shift=1.7, up=4.4, thick=0.5)
    k.star(12.8, 1.6, 5.5)
    k.heart(16.4, -1.4, 0.9)
    k.go(19)
    corner(k, "The long climb")


def the_long_climb(k):
    """Twisted: a ladder, boards, and spikes where one would like to land."""
    k.beat("The long climb", "Ladder, boards, and a bed of spikes.", eye=(-4, -5, 4.5), look=(10, 0.5, 3))
    k.island(2.2, 16.8, 5, up=-0.08, deep=5, chamfer=0.6)
    k.block(5, 9, 4.96, 0, 4.4)
    k.patch(5.4, 8.6, 4.4, up=4.4, material="top")
    k.ladder(5, 0, 4.43, across=0.6)
    k.way(4.4, (6.0, 0.6, 4.43), "climb", across=0.6)
    k.coins(4.6, 4.6, 3, across0=0.6, up=1.4, up1=3.9)
    k.spikes(9.4, 16.8, 4.0, up=0, tall=0.5)
    windows(k, (3.6, 2.6), (7, 7.2), (14.4, 3.4))
    k.one_way(10.6, 13.4, 3.6, up=5.4, shift=0.4)
    k.coin(12, 0.4, 6.3)
    k.one_way(13.9, 16.9, 3.6, up=7.4, shift=0.4)
    k.coin(15.4, 0.4, 8.3)
    k.one_way(10.4, 13.2, 3.6, up=9.4, shift=0.4)
    k.coin(11.8, 0.4, 10.3)
    k.slab(14.0, 17.0, 4.6, up=9.86, thick=0.7)
    k.coins(14.8, 16.2, 2, up=10.8)
    k.go(19, up=9.9)
    corner(k, "The chimney")


def the_chimney(k):
    """Twisted: up between two walls, on to a board, up again; the mouth is narrow and the sky is in it."""
    k.beat("The chimney", "Up, rest on the board, up.", eye=(-4, 1.0, 3.5), look=(9, 0.5, 4))
    k.island(2.2, 12.4, 5, up=-0.12, deep=5, chamfer=0.6)
    k.bare_wall(6.4, 12.2, 1.0, -0.6, 11.4, shift=-0.95, bands=3)
    k.block(11.8, 17.0, 4.96, -1.5, 9.34)
    k.patch(12.3, 16.4, 4.2, up=9.34, material="top")
    k.one_way(9.4, 11.7, 2.86, shift=1.03, up=4.8)
    k.way(8.2, (10.6, 1.0, 4.8), "wall_jump", across=1.0)
    k.way(10.2, (13.0, 1.0, 9.43), "wall_jump", across=1.0, up=4.8)
    k.coins(8.2, 9.0, 3, across0=1.0, up=1.4, up1=4.0)
    k.coins(10.6, 11.2, 3, across0=1.0, up=6.0, up1=9.4)
    k.slab(7.6, 10.6, 2.2, shift=-5.6, up=12.0, thick=0.6)    # a star above the outer wall's head
    k.star(9, -5.6, 13.1)
    k.coin(9.2, -3.2, 12.8)
    k.camera(6, 13, 5, 12, pitch=25, distance=6.5, up=0)
    k.go(19, up=9.4)
    corner(k, "The pit")


def the_pit(k):
    """Twisted: down first. A pit between two walls, too deep to jump out of: what was a way up is the only way on."""
    k.beat("The pit", "Drop in. Out is up the walls.", eye=(-4, 0.6, 5.0), look=(9, 0.6, -2.5))
    k.block(2.4, 6.4, 4.8, -6.9, -0.06, material="side", top="trim")   # down to the pit's floor: nobody gets under it
    k.patch(2.8, 6.0, 4.2, up=-0.06, material="top")
    k.bare_wall(6.2, 12.8, 1.0, -6.2, 4.6, shift=-0.95, bands=3)      # 2.95 m from the tower, and around the entrance
    k.block(6.15, 12.6, 3.0, -6.7, -5.2, shift=0.95, material="side", top="path")
    k.block(12.2, 17.0, 4.96, -6.4, 0.84)
    k.patch(12.7, 16.4, 4.2, up=0.84, material="top")
    k.lamp(6.9, 2.1, up=-5.2, tall=2.0)
    k.way(9.6, (13.6, 1.0, 0.93), "wall_jump", across=1.0, up=-5.2)
    k.coins(7.6, 7.6, 3, across0=1.0, up=0.6, up1=-3.6)
    k.coins(9.8, 11, 3, across0=1.0, up=-2.6, up1=1.4)
    k.crystal(15.6, -1.4, size=1.0, up=0.87)
    windows(k, (4.4, 2.4), (15, 3.4))
    k.go(19, up=0.9)
    corner(k, "The watched stair")


def the_watched_stair(k):
    """Twisted: stone from which to wait, a ladder and boards; and somebody outside who shoots at whoever hangs on them too long."""
    k.beat("The watched stair", "Wait for the shot, then climb.", eye=(-4, -4.5, 4.5), look=(11, -0.5, 4))
    k.island(2.2, 16.8, 5, up=-0.08, deep=5, chamfer=0.6)
    k.wall(2.9, 4.7, 0.6, 0, 2.2, shift=-1.9, material="accent")
    k.block(7.4, 11.4, 4.96, 0, 4.4)
    k.patch(7.8, 11.0, 4.4, up=4.4, material="top")
    k.ladder(7.4, 0, 4.43, across=0.8)
    k.way(6.8, (8.4, 0.8, 4.43), "climb", across=0.8)
    k.wall(8.0, 10.0, 0.6, 4.4, 6.4, shift=-1.8, material="accent")
    k.coins(7.0, 7.0, 3, across0=0.8, up=1.4, up1=3.9)
    k.column(10, -13.0, 2.2, up=5.4, deep=14)
    k.enemy("shooter", 10, -13.0, 5.4, sight=17, leash=4)
    windows(k, (4.4, 2.4), (6.2, 6.8), (13.2, 2.8), (15.6, 2.8))
    k.one_way(12.2, 15.0, 3.6, shift=0.5, up=6.4)
    k.one_way(14.6, 17.2, 3.4, shift=0.5, up=8.5)
    k.coin(13.6, 0.5, 7.3)
    k.coin(15.9, 0.5, 9.4)
    k.slab(10.4, 13.8, 3.6, shift=0.4, up=10.4, thick=0.7)
    k.coins(11.4, 12.8, 2, across0=0.4, up=11.3)
    k.slab(15.2, 18.6, 4.2, shift=0.2, up=11.36, thick=0.7)
    k.heart(17.2, -1.0, 12.3)
    k.go(19, up=11.4)
    corner(k, "The last stretch")


def the_roof(k):
    """Concluded: the last ladder, a run along the edge, and the gate on the roof, over all that was climbed."""
    k.beat("The roof", "One more wall.", eye=(-2, -6, 4), look=(9, 5, 2))
    top = TOP - k.frame.z        # the roof, above the way here
    k.island(2.2, 12.5, 5, up=-0.08, deep=5, chamfer=0.6)
    k.coins(5, 9.5, 4)
    k.go(9.5, turn=90)
    k.block(0.2, 2.6, 3.4, 0, top - 2.2, material="side")
    k.coins(1.0, 1.8, 2, up=top - 1.3, up1=top - 0.2)
    k.go(WALL, up=top)
    k.patch(1, 13, 12, material="top", chamfer=2)
    for a, x in ((2, -5.6), (2, 5.6), (12, -5.6), (12, 5.6)):
        k.lamp(a, x, up=0.03)
    k.crystal(10.5, -4.6, size=1.6, up=0.03)
    k.crystal(10.5, 4.6, size=1.8, up=0.03)
    k.coins(1.2, 4.4, 3, up=0.95)
    k.goal(7.5, up=0.03)


if __name__ == "__main__":
    level = Level("The Shaft", "Up by the walls: ladders, boards, and jumps from side to side.", order=4, par=80, silver=120, bronze=190, palette=PALETTE,
                  far_towers=True, drawings={"side": "bricks", "rock": "bricks", "path": "bricks"},
                  kill_y=-9, music="lively", sky="dusk", secret=False, stars_needed=0)
    level.play(the_foot, the_boards, the_shaft, the_open_shaft, the_gallery, the_long_climb, the_chimney, the_pit,
               the_watched_stair, the_roof)
    level.write()
