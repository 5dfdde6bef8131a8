"""Cold Feet: ice that does not let go, ground that carries one away, and ways too low to stand in.

    blender -b --factory-startup --python-exit-code 1 -P levels/platformer/cold_feet.py -- levels/platformer/cold-feet.glb
"""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))

from kit import Level  # noqa: E402

PALETTE = {
    "top": "#eef3f8", "trim": "#ffffff", "side": "#8aaccb", "rock": "#5b7ea6", "path": "#d3deea", "accent": "#3d5f8c",
    "leaf": "#2f6f63", "light leaf": "#e9f2f6", "trunk": "#5d4a45", "far": "#a9bfd6", "far top": "#dbe6f0",
    "machine": "#454a63", "machine trim": "#8a90ad",
}


def the_pond(k):
    """Taught: ice. A frozen pond with snow all around; one glides, and nothing happens."""
    k.beat("The frozen pond", "Ice: set off early, brake early.", eye=(-4, -6, 5), look=(15, 1, 0))
    k.island(-6, 30, 24, deep=9, chamfer=5)
    k.patch(3, 23, 17, material="ice", chamfer=5)
    k.spawn(-2.5)
    k.prompt(2, "Ice lets you glide: brake early", long=8, width=16)
    k.coins(5, 12, 4, across1=4)
    k.coins(14, 21, 4, across0=3, across1=-3)
    for a, x, tall in ((-3, -7.5, 6), (6, 10.2, 5), (13, -10.3, 7), (20, 10.4, 6), (26, -7.5, 5)):
        k.pine(a, x, tall=tall)
    k.rock(9.5, -5, size=1.1, material="side")
    k.rock(17, 4.5, size=0.9, material="side")
    k.crystal(13, 10.2, size=1.6, material="ice")
    k.arch(26.5, 3.6, 3.8)
    k.checkpoint(28, "The floes")
    k.go(30)


def the_floes(k):
    """Tested: the same ice in pieces, over the deep. Snow on the far rim of each is where one can stop."""
    k.beat("Floes", "Land short, glide, jump.", eye=(-2.5, -4, 4.5))
    k.slab(2.6, 8.6, 5, thick=1.0, top="ice", trim="ice rim")
    k.coins(0.4, 2.4, 2, up=1.3)
    k.coins(3.6, 7.4, 3)
    k.slab(11.2, 17.2, 5, shift=1.4, up=0.3, thick=1.0, top="ice", trim="ice rim")
    k.coins(12.4, 16, 3, across0=1.4, up=1.2)
    k.slab(19.8, 25.8, 5, shift=-0.4, up=0.6, thick=1.0, top="ice", trim="ice rim")
    k.patch(24, 25.4, 4, shift=-0.4, up=0.6, material="top")
    k.coins(21, 24, 3, across0=-0.4, up=1.5)
    k.column(14.4, -5.6, 1.3, up=1.6, deep=5, top="top")     # a star beyond the second floe
    k.star(14.4, -5.6, 2.7)
    k.coin(14.3, -3.2, 2.6)
    k.go(28.6, up=0.8)


def the_burrow(k):
    """Taught: crouching. A tunnel as high as a table, on firm ground; beside it a wall that nobody gets over."""
    k.beat("The burrow", "Crouch, and go on.", eye=(-5, -5, 4), look=(9, 0, 0.5))
    k.island(0, 25, 14, deep=9, chamfer=2.5)
    k.prompt(4, "{crouch} to crouch", long=8, width=12)
    k.patch(1.2, 9, 2.6)
    for edge in (-1, 1):
        k.wall(10.0, 14.0, 10.0, 0, 6.4, shift=6.95 * edge, material="side")
    k.tunnel(10.2, 13.8, 2.6, 1.15, roof="side", thick=0.5)
    k.wall(10.1, 13.9, 3.8, 1.7, 6.1, material="side")
    k.coins(10.8, 13.2, 3, up=0.5)
    k.way(9.2, (14.8, 0, 0), "crouch")
    k.pine(4, 4.6, tall=5)
    k.pine(20, -4.8, tall=6)
    k.rock(6, -4.4, material="side")
    k.crystal(17, 4.6, size=1.3, material="ice")
    k.heart(20, 4)
    k.checkpoint(18, "The slope")
    k.go(25)


def the_slope(k):
    """Tested: running and crouching is sliding. A long slope of ice, bars to slide under or to go around, and a jump at its end."""
    k.beat("The slope", "Run, crouch, slide under the bars.", eye=(-7, 3, 5.5), look=(12, 0, -3))
    k.prompt(-2, "Run and {crouch} to slide", long=8, width=12)
    k.ramp(-0.4, 34, 6.4, 0.02, -10.2, deep=1.4, top="ice", side="side")
    for edge in (-1, 1):  # banks of snow on both sides
        k.ramp(-0.3, 33.9, 1.0, 0.75, -9.45, shift=3.6 * edge, deep=2.0, top="trim", side="side")
    for a, side in ((11, 1), (20, -1), (29, 1)):  # across most of the slope: who does not slide has to go around
        low = -10.2 * (a + 0.4) / 34.4
        k.block(a - 0.25, a + 0.25, 5.2, low + 1.45, low + 2.1, shift=-1.2 * side, material="accent", top="accent")
        k.coins(a - 2, a + 2, 3, across0=-0.6 * side, up=low + 1.4, up1=low + 0.2)
    k.rock(15.5, 1.8, up=-4.9, size=0.8, material="side")
    k.rock(24.5, -1.8, up=-7.6, size=0.8, material="side")
    k.go(36.6, up=-10.4)
    k.island(0, 13, 14, deep=9, chamfer=2.5)
    k.patch(1.2, 8, 2.6)
    k.pine(3, -4.8, tall=5)
    k.pine(10, 4.8, tall=6)
    k.checkpoint(5, "The belts")
    k.go(6.5, turn=90)
    k.go(6.5)


def the_belts(k):
    """Taught: belts. One carries along, one against; a railing keeps everybody on."""
    k.beat("Belts", "One helps, one does not.", eye=(-6, 3.5, 4.5), look=(12, 0, 0))
    k.prompt(-1.5, "The arrows show which way it carries", long=7, width=10)
    k.island(-0.6, 27, 11, up=-0.04, deep=9, chamfer=1.5)
    k.belt(2, 12.5, 3.2, 3.5, up=-0.04)
    k.belt(14.5, 25, 3.2, -3.0, up=-0.04)
    for edge in (-1, 1):
        k.wall(1.5, 25.5, 0.5, 0, 0.9, shift=4.4 * edge)
        k.lamp(13.5, 3.4 * edge)
    k.coins(4, 11, 4)
    k.coins(16, 23.5, 4)
    k.go(27)


def the_guard(k):
    """Tested: belts that carry aside, over the deep, and a guard on the island between."""
    k.beat("The guard", "It turns round when it hears steps.", eye=(-6, 5, 5.5), look=(14, 0, 0))
    k.slab(2.4, 12.4, 5.4, thick=1.0)
    k.go(7.4, turn=90)
    k.belt(-2.3, 2.3, 4.0, 2.2)
    k.go(turn=-90)
    k.go(-7.4)
    k.coins(4, 11, 4, across0=-0.8)
    k.go(14.8)
    k.island(0, 18, 15, deep=10, chamfer=2.5)
    k.enemy("patroller", 5, -3.5, 0.0, route=[(0, 0), (0, 7), (8, 7), (8, 0)], sight=8, leash=9)
    k.block(8, 10, 2, 0, 1.6, shift=0, chamfer=0.3)
    k.star(9, 0, 4.5)     # above the block: from its top by two jumps
    k.coin(9, 0, 2.5)
    k.pine(3, 5.8, tall=5)
    k.pine(15, -5.8, tall=6)
    k.rock(13.5, 5, material="side")
    k.checkpoint(15.5, "The sorting hall")
    k.coins(4, 13, 3, across0=3.5)
    k.go(18)


def the_sorting_hall(k):
    """Tested: belts side by side that run each its own way, and bars across them: under one by sliding, over the next."""
    k.beat("The sorting hall", "Change lanes, slide under, jump over.", eye=(-6, 4.5, 5.5), look=(14, 0, -0.5))
    k.prompt(-2, "Slide under the high bars: run and {crouch}", long=6, width=12)
    k.island(-0.6, 36, 13, up=-0.04, deep=10, chamfer=2)
    for a, speeds in ((2.0, (3.0, -2.4, 3.0)), (19.5, (-2.6, 3.2, -2.6))):
        for lane, speed in enumerate(speeds):
            k.belt(a, a + 13.5, 2.3, speed, shift=3.1 * (lane - 1), up=-0.04)
    for a, low, high in ((7.0, 1.18, 1.9), (11.6, 0.25, 0.62), (24.4, 1.18, 1.9), (29.0, 0.25, 0.62)):
        for edge in (-1, 1):
            k.block(a - 0.35, a + 0.35, 0.7, -0.04, 2.4, shift=5.35 * edge, material="accent", top="accent")
        k.block(a - 0.22, a + 0.22, 10.0, low, high, material="accent", top="accent")
    for edge in (-1, 1):
        k.wall(1.5, 34, 0.5, 0, 0.9, shift=5.9 * edge)
        k.lamp(17.5, 3.4 * edge)
    k.way(5.6, (8.4, 0, -0.04), "crouch")
    k.way(23.0, (25.8, 0, -0.04), "crouch")
    k.coins(4, 10, 3, across0=-3.1, up=0.55)
    k.coins(13.5, 22, 3, across0=-3.1, across1=0, up=0.9)
    k.coins(26, 32, 3, across0=0.0, up=0.9)
    k.go(36)
    k.island(0, 9, 13, deep=9, chamfer=2)
    k.patch(1.2, 8, 2.6)
    k.pine(4.5, 4.8, tall=5)
    k.crystal(5, -4.6, size=1.5, material="ice")
    k.checkpoint(5, "The cold store")
    k.go(9)


def the_cold_store(k):
    """Twisted: crouched on a belt that runs the wrong way, and rollers on ice: what was learnt, at once."""
    k.beat("The cold store", "Low, slippery, and the wrong way.", eye=(-5, 3, 4.5), look=(12, 0, 0))
    k.island(-0.6, 33, 12, up=-0.04, deep=10, chamfer=1.5)
    k.belt(3.2, 9.4, 2.4, -0.8, up=-0.04)
    k.tunnel(3.6, 9.0, 3.2, 1.15, up=-0.04, roof="side", thick=0.5)
    k.wall(3.5, 9.1, 4.5, 1.75, 5.6, material="side")
    for edge in (-1, 1):
        k.wall(3.4, 9.2, 8.6, 0, 6.0, shift=6.75 * edge, material="side")
    k.way(2.6, (10.4, 0, 0), "crouch")
    k.coins(4.5, 8, 3, up=0.55)
    k.patch(11.5, 30, 8.4, up=-0.04, material="ice", chamfer=1)
    for edge in (-1, 1):
        k.wall(11.5, 30, 0.5, 0, 0.9, shift=5.0 * edge)
    k.roller(16, -2.2, 0.55, width=0.9, to=[(0, 4.4, 0)], speed=2.6)
    k.roller(21, 2.2, 0.55, width=0.9, to=[(0, -4.4, 0)], speed=3.0)
    k.roller(26, -2.2, 0.55, width=0.9, to=[(0, 4.4, 0)], speed=3.4)
    k.coins(13, 29, 5)
    k.column(21, 8.4, 1.3, up=2.4, deep=6)   # a star beyond the railing
    k.star(21, 8.4, 3.5)
    k.heart(31.5, 4, up=0.9)
    k.checkpoint(31.6, "The last slope")
    k.go(33)


def the_last_slope(k):
    """Concluded: a slope, floes, and a belt that hurls towards the gate: everything, and downhill."""
    k.beat("Downhill", "Slide, jump, land, glide.", eye=(-7, -4, 5), look=(14, 0, -3))
    k.ramp(-0.4, 18, 6.0, -0.06, -6, deep=1.4, top="ice", side="side")
    for edge in (-1, 1):
        k.ramp(-0.3, 17.9, 1.0, 0.65, -5.3, shift=3.4 * edge, deep=2.0, top="trim", side="side")
    k.coins(3, 15, 4, up=0.0, up1=-4.0)
    k.slab(20.2, 26, 5.4, up=-6.4, thick=1.0, top="ice", trim="ice rim")
    k.coins(18.4, 22, 3, up=-4.9, up1=-5.4, arc=0.4)
    k.slab(28.6, 38.6, 5.0, up=-6.6, thick=1.0)
    k.belt(29.4, 38.2, 3.2, 4.0, up=-6.6)
    k.coins(30.5, 37, 4, up=-5.7)
    k.go(42.4, up=-7.2)
    k.coins(-3.2, -0.6, 3, up=2.2, up1=1.4, arc=0.5)
    k.island(0, 24, 16, deep=10, chamfer=4)
    k.patch(1.2, 13, 2.8)
    for side in (-1, 1):
        k.pine(4, 5.2 * side, tall=6)
        k.pine(10, 5.8 * side, tall=7)
        k.crystal(14, 6.0 * side, size=1.8, material="ice")
    k.goal(17.5)


if __name__ == "__main__":
    level = Level("Cold Feet", "Glide, slide, crouch, and do not trust the ground.", order=3, par=95, silver=140, bronze=220, palette=PALETTE,
                  kill_y=-27, music="calm", sky="day", secret=False, stars_needed=0)
    level.play(the_pond, the_floes, the_burrow, the_slope, the_belts, the_guard, the_sorting_hall, the_cold_store,
               the_last_slope)
    level.write()
