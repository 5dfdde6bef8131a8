"""First Steps: a walk over floating meadows that teaches to run, to jump, to jump twice and to hold on to ledges.

    blender -b --factory-startup --python-exit-code 1 -P levels/platformer/first_steps.py -- levels/platformer/first-steps.glb
"""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))

from kit import Level  # noqa: E402

PALETTE = {
    "top": "#7dbb52", "trim": "#b4dc74", "side": "#c79a68", "rock": "#946b4c", "path": "#e6cd9c", "accent": "#f2ead8",
    "leaf": "#4c9a4f", "light leaf": "#8ec75a", "trunk": "#7a5538", "far": "#9dbccb", "far top": "#bcd6c4",
    "machine": "#6f86b5", "machine trim": "#b9c8e6",
}


def the_meadow(k):
    """Taught: running and looking around. A wide meadow with nothing that hurts; a path, and coins along it."""
    k.beat("The meadow", "Run, and look around: the path and the coins lead on.", eye=(-1, -6, 5), look=(14, 1, 0))
    k.island(-6, 24, 18, deep=9, chamfer=3.5)
    k.patch(1, 22.6, 2.6)
    k.spawn(0)
    k.prompt(2, "{move} to run, {camera} to look around", long=12, width=16)
    k.coins(7, 19, 4)
    for a, x, tall in ((-3, -6, 5.5), (5, 6.5, 4.5), (11, -6.6, 6), (17, 6.4, 5)):
        k.tree(a, x, tall=tall)
    k.rock(8, 4.6, size=1.0)
    k.rock(-2.5, 5.2, size=0.7)
    k.rock(20.5, -4.5, size=1.2)
    for a, x in ((3, -4.4), (14, 4.2), (19.8, 5.6)):
        k.bush(a, x)
    k.meadow(-4, 22, 16, 26)
    # A star for who looks back: an islet behind the start, a jump and a half away.
    k.column(-11.6, 0, 1.6, up=0.6, deep=4)
    k.star(-11.6, 0, 1.7)
    k.coin(-8.2, 0, 2.3)
    k.go(24)


def the_brook(k):
    """Taught, and nobody falls: two gaps over a bed that is only a metre down, with steps out of it."""
    k.beat("The dry brook", "Jump. Below is only sand.", eye=(-7, -5, 4))
    k.prompt(-2.5, "{jump} to jump", long=7, width=10)
    k.island(-0.6, 14.6, 14, up=-1.0, deep=7, chamfer=2.5, top="path", trim="path")
    k.slab(2.6, 5.6, 4.2, up=0, thick=1.2)
    k.coins(0.2, 2.4, 3, up=1.0, arc=0.7)
    k.slab(8.4, 11.4, 4.2, up=0, thick=1.2)
    k.coins(5.8, 8.2, 3, up=1.0, arc=0.7)
    k.coins(11.6, 13.8, 3, up=1.0, arc=0.7)
    k.slab(12.4, 14.3, 3, shift=4.8, up=-0.5, thick=0.6)  # steps out of the brook
    for a, x, size in ((2, -5, 0.8), (7, 5.2, 1.1), (10.5, -5.4, 0.9)):
        k.rock(a, x, -1, size)
    k.tuft(6, -4, -1)
    k.tuft(9, 4.5, -1)
    k.go(14)
    k.island(0, 16, 14, deep=8, chamfer=2)
    k.patch(1, 15, 2.4)
    k.tree(5, -5, tall=5)
    k.tree(12, 5, tall=6)
    k.meadow(1, 15, 12, 14)
    k.checkpoint(8, "The stones")
    k.go(16)


def the_stones(k):
    """Tested: the same jumps over the deep. Round stones, each a little higher; the last is wide."""
    k.beat("Stones over the deep", "The same jump, but now one can fall.", eye=(-7, -5, 5))
    k.coins(0.4, 2.4, 3, up=1.0, arc=0.7)
    k.column(4.4, 0, 1.8, up=0.2, deep=5)
    k.column(9.8, 1.0, 1.7, up=0.6, deep=7)
    k.coins(6.2, 8.2, 3, across0=0.3, across1=0.8, up=1.4, arc=0.6)
    k.column(15.0, -0.6, 1.7, up=1.0, deep=5)
    k.coins(11.6, 13.4, 3, across0=0.6, across1=-0.3, up=1.8, arc=0.6)
    k.go(19.4, up=1.0)
    k.island(0, 14, 14, deep=8, chamfer=2.5)
    k.patch(1.2, 8.4, 2.4)
    k.arch(3, 3.6, 3.8)
    k.tree(10.5, -4.5, tall=6.5)
    k.bush(4, 5)
    k.rock(11.8, 2.6, size=1.0)
    k.meadow(1, 13, 12, 10, clear=2.4)
    k.heart(11.5, -1.5)
    k.go(7, turn=90)


def the_steps(k):
    """Taught: the second jump. Terraces two metres high, on firm ground all around."""
    k.beat("Terraces", "In the air, jump again.", eye=(-6.5, 1.0, 4.5), look=(12, 0, 1.5))
    k.prompt(1.5, "{jump} again in the air", long=9, width=12)
    k.go(7)  # to the eastern edge of the meadow with the arch
    k.island(-0.6, 20, 12, up=-0.04, deep=9, chamfer=2)
    k.block(4, 16.5, 8, 0, 2.1, material="side", top="trim", chamfer=0.4)
    k.patch(4.6, 9.6, 6.8, up=2.1, material="top")
    k.coins(2.4, 5, 3, up=1.0, up1=3.1, arc=0.9)
    k.block(10, 16.2, 7.2, 2.1, 4.2, material="side", top="trim", chamfer=0.4)
    k.patch(10.5, 15.7, 6.2, up=4.2, material="top")
    k.coins(8.4, 11, 3, up=3.1, up1=5.2, arc=0.9)
    k.tree(1.5, 4.6, tall=4)
    k.bush(7, 2.8, up=2.1)
    k.bush(7.4, -2.9, up=2.1, size=0.5)
    k.meadow(1, 4, 11, 6)
    k.checkpoint(13, "The wide gaps", up=4.2)
    k.go(16.2, up=4.2)


def the_wide_gaps(k):
    """Tested: two jumps over almost five metres of nothing. Slabs in white stone, and a beacon beyond."""
    k.beat("Wide gaps", "Too far for one jump, easy for two.", eye=(-7, 4, 4.5))
    k.coins(0.5, 4.3, 4, up=1.1, arc=1.5)
    k.slab(4.6, 9.4, 4.6, thick=0.8)
    k.coins(9.9, 13.5, 4, across1=0.4, up=1.1, arc=1.6)
    k.slab(14.0, 18.8, 4.6, shift=0.6, up=0.2, thick=0.8)
    k.column(16.4, 8.2, 1.5, up=1.6, deep=4)   # a star above and beside the way
    k.star(16.4, 8.2, 2.7)
    k.coin(16.4, 5.0, 2.8)
    k.coins(19.3, 22.7, 4, across0=0.6, across1=0, up=1.4, up1=1.9, arc=1.4)
    k.go(23.4, up=0.8)
    k.island(0, 15, 14, deep=9, chamfer=2.5)
    k.patch(1.2, 8.4, 2.4)
    k.tree(3, 4.8, tall=5)
    k.tree(11.5, 4.4, tall=6)
    k.rock(11, -3.8, size=0.8)
    k.meadow(1, 14, 12, 12)
    k.checkpoint(5.4, "The high stones")
    k.go(15)


def the_high_stones(k):
    """Twisted: wide gaps that climb. Round stones in a bow, each higher: the second jump has to come at the top of the first."""
    k.beat("High stones", "Jump again at the top of the jump.", eye=(-7, -1.5, 5.5), look=(14, -4, 2))
    k.prompt(-3, "Wait for the top of the jump, then {jump} again", long=7, width=12)
    places = ((5.4, -0.6, 1.2), (11.8, -3.0, 2.6), (17.0, -7.4, 4.0), (19.6, -13.8, 5.4))
    before = (0.0, 0.0, 0.0)
    for a, x, up in places:
        k.column(a, x, 1.9, up=up, deep=6)
        k.coins(before[0] + 0.45 * (a - before[0]), before[0] + 0.8 * (a - before[0]), 2,
                across0=before[1] + 0.45 * (x - before[1]), across1=before[1] + 0.8 * (x - before[1]), up=before[2] + 2.6, up1=up + 1.5)
        before = (a, x, up)
    k.go(19.6, across=-18.6, up=5.4, turn=-90)
    k.island(-0.4, 14.5, 13, deep=9, chamfer=2)
    k.patch(1.2, 13, 2.4)
    k.tree(4, 4.6, tall=5)
    k.tree(9, -4.4, tall=6)
    k.bush(11, 4.8)
    k.meadow(1, 13, 11, 14)
    k.heart(11, 2.6)
    k.checkpoint(6, "The ledges")
    k.go(14)


def the_ledges(k):
    """Taught: hands. The first wall is low enough to be seen over; the second needs two jumps and the edge."""
    k.beat("Ledges", "Jump at a wall and hold on to its edge.", eye=(-7.5, 2.5, 4.5), look=(14, 0, 2.5))
    k.prompt(-3, "Jump at the edge to hold on; {jump} or forward to climb", long=8, width=12)
    k.island(-0.6, 22, 13, up=-0.05, deep=10, chamfer=2)
    k.block(4, 18.5, 9, 0, 2.0, chamfer=0.3)
    k.patch(4.5, 9.4, 8, up=2.0, material="top")
    k.coins(2.2, 4.8, 3, up=1.2, up1=3.0, arc=0.5)
    k.block(9.8, 18.3, 8.4, 2.0, 5.0, chamfer=0.3)
    k.patch(10.3, 17.8, 7.6, up=5.0, material="top")
    k.coins(9.0, 9.0, 3, across0=-1.6, across1=1.6, up=4.1)
    k.tree(1.8, -5, tall=4.5)
    k.bush(6.6, -3.4, up=2.0)
    k.bush(16.6, 2.6, up=5.0)
    k.tree(16.4, -2.6, up=5.0, tall=4)
    # A star below the top, on a shelf at the western side: let go over the edge, and two jumps back.
    k.slab(12.5, 15.5, 2.6, shift=-7.4, up=2.6, thick=0.6)
    k.star(14, -7.4, 3.7)
    k.coin(14, -5.2, 4.8)
    k.checkpoint(13.2, "The pillars", up=5.0)
    k.go(18.3, up=5.0)


def the_pillars(k):
    """Tested: hands over the deep. Pillars higher than two jumps, and from the last of them a run of drops."""
    k.beat("The pillars", "Two jumps, and hold on. Then run down.", eye=(-6.5, 4, 4.5), look=(13, 0, 3.5))
    for a, x, up in ((3.2, 0.0, 2.7), (8.0, 1.6, 5.4), (12.8, -0.6, 8.1)):
        k.block(a - 1.9, a + 1.9, 4.0, up - 9, up, shift=x, material="side", top="trim", chamfer=0.5)
        k.patch(a - 1.4, a + 1.4, 3.0, shift=x, up=up, material="top")
        k.coins(a - 0.8, a + 0.8, 2, across0=x, up=up + 0.95)
    k.tree(13.6, -1.6, up=8.1, tall=3.2)
    k.slab(18.2, 22.4, 4.2, shift=0.4, up=6.0, thick=0.8)
    k.coins(15.2, 18.0, 3, across1=0.4, up=9.2, up1=7.6, arc=0.5)
    k.slab(26.6, 30.8, 4.2, shift=-0.6, up=4.0, thick=0.8)
    k.coins(22.9, 26.2, 3, across1=-0.6, up=7.2, up1=5.6, arc=0.6)
    k.go(35.0, up=2.0)
    k.coins(-3.6, -0.6, 3, up=3.2, up1=1.8, arc=0.5)
    k.island(0, 16, 14, deep=9, chamfer=2.5)
    k.patch(1.2, 15, 2.4)
    k.tree(5, -5, tall=5.5)
    k.tree(12, 5, tall=5)
    k.rock(10.5, -4.6, size=1.0)
    k.meadow(1, 15, 12, 14)
    k.checkpoint(8, "The old tower")
    k.go(16)


def the_old_tower(k):
    """Twisted: all of it, twice around one tower. Jumps, wide gaps, a ledge at the top, and the next is always in sight."""
    k.beat("The old tower", "Twice around the tower: jump, jump twice, hold on.", eye=(-7, -2.5, 5), look=(14, 0, 5))
    k.tower(15, 0, 4.2, -10, 11.0, corners=14)
    k.slab(2.6, 6.4, 4.6, shift=-0.9, up=0.4, thick=0.8)
    k.coins(0.4, 2.3, 3, up=1.1, up1=1.5, arc=0.6)
    k.slab(8.6, 12.8, 3.6, shift=-6.6, up=1.4, thick=0.8)
    k.coins(6.6, 9.0, 4, across0=-2.6, across1=-5.4, up=1.6, up1=2.4, arc=0.7)
    k.slab(17.6, 21.6, 3.8, shift=-6.6, up=2.2, thick=0.8)
    k.coins(13.5, 17.1, 4, across0=-7.0, across1=-6.7, up=2.6, up1=3.1, arc=1.0)
    k.slab(20.0, 24.0, 4.0, shift=0.4, up=3.1, thick=0.8)
    k.coins(20.2, 21.4, 3, across0=-4.5, across1=-1.8, up=3.4, up1=4.0, arc=0.6)
    # Once more around, higher, and from the far side of the gate on to the head: from here there is no way past it.
    k.slab(17.4, 21.4, 3.6, shift=6.8, up=4.2, thick=0.8)
    k.slab(9.0, 13.0, 3.6, shift=7.0, up=5.0, thick=0.8)
    k.coins(16.6, 13.6, 3, across0=6.9, up=5.6, up1=6.0, arc=1.0)
    k.slab(3.0, 7.0, 4.0, shift=0.6, up=6.0, thick=0.8)
    k.coins(8.2, 7.4, 2, across0=5.0, across1=3.0, up=6.7, up1=7.2)
    k.slab(7.4, 11.4, 3.6, shift=-6.0, up=7.0, thick=0.8)
    k.slab(13.0, 17.0, 3.8, shift=-6.9, up=8.2, thick=0.8)
    k.coins(15.0, 15.0, 3, across0=-5.6, across1=-2.6, up=10.6, up1=12.0)
    k.flag(15, 0, up=11.0, tall=5)
    k.heart(13.2, 1.6, up=11.9)
    k.go(15, up=11.0, turn=90)


def the_way_down(k):
    """Concluded: from the head of the tower the whole way is seen; a last run of drops and wide jumps to the gate."""
    k.beat("The gate", "Down and home.", eye=(-8, -5, 4.5), look=(16, 0, -3))
    k.slab(7.6, 12.6, 4.4, up=-1.2, thick=0.8)
    k.coins(4.2, 7.4, 3, up=0.9, up1=0.0, arc=0.9)
    k.slab(17.4, 22.4, 4.4, shift=-1, up=-3.2, thick=0.8)
    k.coins(13.0, 17.0, 3, across1=-0.8, up=-0.1, up1=-2.0, arc=1.2)
    k.slab(27.4, 32.4, 4.4, shift=0.6, up=-5.2, thick=0.8)
    k.coins(23.0, 27.0, 3, across0=-0.8, across1=0.4, up=-2.1, up1=-4.0, arc=1.2)
    k.go(37.4, across=0, up=-6.6)
    k.coins(-4.6, -0.6, 4, up=2.2, up1=1.0, arc=1.2)
    k.island(0, 24, 16, deep=11, chamfer=4)
    k.patch(1.2, 13, 2.8)
    k.coins(4, 11, 4)
    for side in (-1, 1):
        k.tree(4, 5.2 * side, tall=5)
        k.tree(10, 5.8 * side, tall=6)
        k.bush(7, 4.4 * side)
    k.meadow(1, 14, 14, 14)
    k.goal(17.5)


if __name__ == "__main__":
    level = Level("First Steps", "Run, jump, jump again, hold on.", order=1, par=90, silver=130, bronze=200, palette=PALETTE, kill_y=-9, music="calm",
                  sky="day", secret=False, stars_needed=0)
    level.play(the_meadow, the_brook, the_stones, the_steps, the_wide_gaps, the_high_stones, the_ledges, the_pillars,
               the_old_tower, the_way_down)
    level.write()
