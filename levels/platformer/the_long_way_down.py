"""The Long Way Down, the secret level: from the top of the sky to its bottom, by pads, dashes and slopes, without stopping.

    blender -b --factory-startup --python-exit-code 1 -P levels/platformer/the_long_way_down.py -- levels/platformer/the-long-way-down.glb
"""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))

from kit import Level  # noqa: E402

PALETTE = {
    "top": "#f2c6b0", "trim": "#ffe9d8", "side": "#b06a9a", "rock": "#774a86", "path": "#dba6a6", "accent": "#3fa9b5",
    "crystal": dict(colour="#5fd0dc", glow=0.55), "leaf": "#8a5aa8", "light leaf": "#c98ac4", "trunk": "#5d3f63", "far": "#a487b8", "far top": "#d9b7c9",
    "machine": "#3f7fae", "machine trim": "#a9dcf2", "fast ice": dict(colour="#bfe4f7", grip=0.06),
}


def pad(k, along, across, up, to, speed, radius=1.3):
    """A pad, and the way that it throws: `to` is where one lands, (along, across, up)."""
    k.bounce(along, across, up, speed=speed, radius=radius)
    k.way(along, to, "bounce", across=across, up=up + 0.15)


def the_summit(k):
    """Taught: pads. The first stands on the summit itself and throws on to a ledge; a miss costs nothing."""
    k.beat("The summit", "What is magenta throws you up.", eye=(-5, -2.5, 5), look=(13, 0, 1))
    k.island(-6, 18, 18, deep=9, chamfer=4)
    k.patch(-2, 6.5, 2.6)
    k.spawn(-3)
    k.prompt(4, "Jump on the pad", long=8, width=14)
    k.coins(0, 5, 3)
    pad(k, 8, 0, 0, (12.4, 0, 3.43), 14)
    k.coins(8, 11.4, 4, up=2.5, up1=5.2, arc=0.6)
    k.block(11, 17, 12, 0, 3.4, chamfer=0.5)
    k.patch(11.5, 16.5, 11, up=3.4, material="top")
    for a, x in ((-3, 6), (3, -7), (6, 6.8)):
        k.tree(a, x, tall=4.5)
    k.crystal(2, 6.5, size=1.5)
    k.bush(14, 4, up=3.4)
    k.flag(15.5, -4.5, up=3.43, tall=4)
    k.go(17, up=3.4)


def the_leap(k):
    """Tested: off the edge, thirteen metres down, into the middle of a pad, and on to the next island."""
    k.beat("The leap", "Down there is a pad. Trust it.", eye=(-2, -4, 5), look=(12, 0, -9))
    k.island(4.6, 15.4, 10, up=-13, deep=6, chamfer=2.5)
    pad(k, 12.0, 0, -13, (20.4, 0, -8.0), 17.5, radius=2.0)
    k.coins(3, 10.5, 5, up=0.4, up1=-10.0)
    k.coins(13, 18.6, 5, up=-8.0, up1=-6.6, arc=1.8)
    k.go(19, up=-8)
    k.island(0, 15, 13, deep=8, chamfer=2)
    k.checkpoint(4, "The chain")
    k.tree(3, -4.6, tall=4.5)
    k.crystal(11, 4.6, size=1.6)
    k.heart(4, 4)
    k.column(8, -11.4, 1.5, up=1.4, deep=5)    # a star: jump, jump, dash aside
    k.star(8, -11.4, 2.5)
    k.coin(8, -8.0, 2.9)
    k.go(15)


def the_chain(k):
    """Tested: pad after pad over the deep. Steer while you fly."""
    k.beat("The chain", "From pad to pad.", eye=(-5, -4, 5.5), look=(14, 1, -3))
    places = ((5.5, 0.0, -1.5), (13.5, 2.4, -3.0), (21.5, -1.2, -4.5))
    for i, (a, x, up) in enumerate(places):
        k.column(a, x, 2.1, up=up, deep=6, corners=12)
        after = (places + ((30.5, 0.0, -5.5),))[i + 1]
        pad(k, a, x, up, (after[0], after[1], after[2] + (0.15 if i < 2 else 0)), 12 if i < 2 else 13, radius=1.6)
        k.coins(a + 1.8, after[0] - 2.4, 3, across0=x, across1=after[1], up=up + 3.0, up1=after[2] + 3.0, arc=1.0)
    k.column(13.5, 9.6, 1.5, up=1.2, deep=6)   # a star: high from the second pad, and to the right
    k.star(13.5, 9.6, 2.3)
    k.coin(13.5, 6.8, 1.6)
    k.go(28.6, up=-5.5)
    k.island(0, 12, 13, deep=8, chamfer=2)
    k.checkpoint(4, "The gale")
    k.tree(3, 4.6, tall=5)
    k.rock(9.5, -4.5, size=1.1)
    k.go(6, turn=90)
    k.go(6.3)


def the_gale(k):
    """Taught again, at speed: dashes from slab to slab, each lower than the last."""
    k.beat("The gale", "Jump, dash, land, again.", eye=(-5, -2.5, 5), look=(14, 0, -3))
    k.prompt(-2, "{dash} in the air", long=7, width=10)
    edge, low = 0.0, 0.0
    for i, (gap, drop, shift) in enumerate(((7.2, 1.6, 0.0), (7.4, 1.8, 0.8), (7.2, 1.6, -0.6))):
        k.way(edge - 0.6, (edge + gap + 1.0, shift, low - drop), "dash", up=low)
        k.coins(edge + 1.2, edge + gap - 0.8, 3, across1=shift, up=low + 1.6, up1=low - drop + 1.6, arc=0.9)
        edge, low = edge + gap, low - drop
        k.slab(edge, edge + 4.6, 4.6, shift=shift, up=low, thick=0.8)
        edge += 4.6
    k.go(edge + 3.0, up=low - 0.6)
    k.island(0, 11, 13, deep=8, chamfer=2)
    k.checkpoint(4, "The run")
    k.heart(8, 4)
    k.tree(8, -4.6, tall=4.5)
    k.go(11)


def the_run(k):
    """Twisted: a slope of ice with gaps in it and pads at its foot; whoever brakes falls short."""
    k.beat("The run", "Do not brake.", eye=(-5, 2, 5), look=(14, 0, -4))
    k.ramp(-0.4, 16, 6.4, -0.05, -5.6, deep=1.2, top="fast ice")
    k.coins(3, 14, 4, up=0.0, up1=-3.9)
    k.ramp(18.6, 34, 6.4, -6.6, -12.0, deep=1.2, top="fast ice")
    k.coins(21, 32, 4, up=-6.3, up1=-10.2)
    for e in (-1, 1):
        k.ramp(-0.3, 15.9, 0.8, 0.6, -4.95, shift=3.5 * e, deep=1.9, top="trim")
        k.ramp(18.7, 33.9, 0.8, -5.95, -11.35, shift=3.5 * e, deep=1.9, top="trim")
    k.block(9.3, 9.7, 2.4, -3.2, -1.6, shift=-1.6, material="accent", top="accent")
    k.block(25.8, 26.2, 2.4, -9.0, -7.4, shift=1.6, material="accent", top="accent")
    k.slab(33.5, 41.4, 6.9, up=-12.1, thick=0.9)
    pad(k, 39.4, 0, -12.1, (48.6, 0, -9.6), 16, radius=1.8)
    k.coins(39.6, 46.6, 4, up=-8.8, up1=-7.6, arc=1.4)
    k.go(47, up=-9.6)
    k.island(0, 14, 13, deep=8, chamfer=2)
    k.checkpoint(4, "The see-saw")
    k.crystal(3, 4.6, size=1.6)
    k.tree(10, -4.6, tall=5)
    k.go(7, turn=-90)
    k.go(6.3)


def the_seesaw(k):
    """Tested: a slope into a pad, a dash out of its throw's landing, and once more: down, up, far, without a rest."""
    k.beat("The see-saw", "Slide down, fly up, dash on.", eye=(-3, -1.5, 4.5), look=(14, 0, -3.5))
    k.ramp(-0.4, 14, 6.0, -0.05, -4.6, deep=1.2, top="fast ice")
    k.coins(3, 12, 3, up=0.0, up1=-2.9)
    k.slab(13.5, 21.0, 6.4, up=-4.7, thick=0.9)
    pad(k, 19.0, 0, -4.7, (28.2, 0, -2.2), 16, radius=1.8)
    k.coins(19.2, 26.2, 4, up=-1.4, up1=-0.2, arc=1.4)
    k.slab(26.6, 31.4, 5.0, up=-2.2, thick=0.8)
    k.flag(27.4, 2.0, up=-2.2, tall=4)
    k.way(30.8, (39.8, 0.6, -3.8), "dash", up=-2.2)
    k.coins(32.6, 37.6, 3, across1=0.6, up=-0.6, up1=-2.2, arc=0.9)
    k.slab(38.6, 42.2, 5.6, shift=0.6, up=-3.8, thick=0.8)
    k.go(42.0, across=0.6, up=-3.85)
    k.ramp(0, 15, 5.6, 0, -5.2, deep=1.2, top="fast ice")
    for e in (-1, 1):
        k.ramp(0.1, 14.9, 0.8, 0.6, -4.6, shift=3.1 * e, deep=1.9, top="trim")
    k.coins(2, 13, 4, up=0.4, up1=-3.6)
    k.go(17.6, up=-6.2)
    k.island(0, 12, 13, deep=8, chamfer=2)
    k.checkpoint(4, "The eye of the needle")
    k.tree(8, 4.6, tall=5)
    k.crystal(8, -4.6, size=1.4)
    k.go(12)


def the_needle(k):
    """Twisted: a fall through three rings of stone, pads beside them for who would rather climb back; a star in the ring."""
    k.beat("The eye of the needle", "Through the rings.", eye=(-4, -3, 5), look=(9, 0, -6))
    for i, (a, up) in enumerate(((6.0, -3.5), (8.5, -9.5), (11.0, -15.5))):
        for e in (-1, 1):
            k.slab(a - 3.4, a + 3.4, 1.6, shift=2.6 * e, up=up, thick=0.7)
            k.slab(a + 2.6 * e - 0.85, a + 2.6 * e + 0.85, 3.5, up=up - 0.05, thick=0.6)
        k.coins(a, a, 2, up=up + 1.6, up1=up - 0.8)
    k.island(3, 24, 14, up=-22, deep=8, chamfer=3)
    k.star(11, 0, -18.6)     # under the third ring: from its rim, or by the pad below
    k.bounce(11, 0, -22, speed=11, radius=1.5)
    k.checkpoint(17, "The last drop", up=-22)
    k.tree(20, 4.8, up=-22, tall=5)
    k.tree(20, -4.8, up=-22, tall=4.5)
    k.coins(14.5, 22, 3, up=-21.1)
    k.heart(6, -4.5, -21.1)
    k.go(24, up=-22)


def the_last_drop(k):
    """Concluded: pad, dash, slope, pad, and the ground at last."""
    k.beat("The last drop", "All of it once more, and land.", eye=(-6, 0, 5), look=(15, 0, -5))
    k.column(5.6, 0, 2.1, up=-2.5, deep=6, corners=12)
    pad(k, 5.6, 0, -2.5, (13.4, 0, -3.0), 12, radius=1.6)
    k.coins(7, 11.6, 3, up=0.5, up1=-0.4, arc=0.8)
    k.slab(11.6, 16.4, 4.6, up=-3.0, thick=0.8)
    k.way(15.8, (24.8, 0, -5.0), "dash", up=-3.0)
    k.coins(17.4, 22.4, 3, up=-1.4, up1=-3.0, arc=0.8)
    k.slab(23.6, 27, 5.6, up=-5.0, thick=0.8)
    k.ramp(26.8, 42, 5.6, -5.05, -10.4, deep=1.2, top="fast ice")
    k.coins(29, 40, 4, up=-4.6, up1=-8.7)
    k.go(44.6, up=-11.4)
    k.island(0, 26, 18, deep=11, chamfer=5)
    k.patch(6, 14, 2.8)
    for side in (-1, 1):
        k.tree(6, 6 * side, tall=6)
        k.tree(13, 6.6 * side, tall=5)
        k.crystal(18, 6.4 * side, size=2.0)
    k.meadow(3, 15, 16, 12)
    k.coins(6, 13, 3)
    k.goal(19)


if __name__ == "__main__":
    level = Level("The Long Way Down", "Pads, dashes and slopes, downhill all the way.", order=7, par=95, silver=140, bronze=220, palette=PALETTE, kill_y=-78,
                  music="lively", sky="dusk", secret=True, stars_needed=12)
    level.play(the_summit, the_leap, the_chain, the_gale, the_run, the_seesaw, the_needle,
               the_last_drop)
    level.write()
