"""Tides: water to swim and dive in, boards that crumble, and dashes over what is too wide to jump.

    blender -b --factory-startup --python-exit-code 1 -P levels/platformer/tides.py -- levels/platformer/tides.glb
"""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))

from kit import Level  # noqa: E402

PALETTE = {
    "top": "#efdcae", "trim": "#fff3d2", "side": "#dc9d7d", "rock": "#a06f70", "path": "#d9bf8b", "accent": "#2f8f98",
    "leaf": "#3aa06b", "light leaf": "#8ccf7c", "trunk": "#96704c", "far": "#a7c4d2", "far top": "#d6ddc9",
    "machine": "#3f7fa8", "machine trim": "#a8dcec", "crumble": "#b98f6a", "crumble side": "#7d5b45",
}


def pool(k, along0, along1, width, deep, rim=1.2):
    """A basin, its water, and a ramp of sand at its far end that leads out."""
    k.basin(along0, along1, width, deep, rim=rim)
    k.water(along0 + rim - 0.04, along1 - rim + 0.04, width + 0.08, -0.35, deep - 0.35 + 0.1)
    k.ramp(along1 - rim - 5.0, along1 - rim + 0.3, min(width, 5), -2.8, -0.06, deep=1.0, top="path")


def the_lagoon(k):
    """Taught: swimming. A lagoon with a ramp out of it, and coins that lead down and up again."""
    k.beat("The lagoon", "In, down to the coins, and out by the ramp.", eye=(-4.5, -3, 5), look=(15, 1, -1))
    k.island(-6, 9, 18, deep=9, chamfer=3)
    k.spawn(-2.5)
    k.prompt(5, "In water: {jump} rises, {crouch} dives", long=8, width=16)
    k.coins(1, 7, 3)
    for a, x, tall in ((-3, 6, 5.5), (2, -7, 6.5), (6.5, 6.8, 5)):
        k.palm(a, x, tall=tall)
    k.rock(4, 5, size=1.0)
    k.meadow(-4, 7, 16, 8)
    k.go(8.6)
    pool(k, 0, 22, 14, 4.6)
    k.way(0.6, (21.6, 0, 0), "swim")
    k.coins(3, 9, 4, up=-0.8, up1=-3.4)
    k.coins(10.5, 14.5, 3, up=-3.4, up1=-2.0)
    for a, x, size in ((5, -4.5, 1.2), (12, 5, 1.5), (16.5, -5, 1.0)):
        k.rock(a, x, up=-4.6, size=size, material="side")
    # A star on the floor, under a stone table by the right wall.
    k.wall(8.2, 9.0, 3.4, -4.6, -2.9, shift=5.2, material="accent")
    k.wall(11.4, 12.2, 3.4, -4.6, -2.9, shift=5.2, material="accent")
    k.slab(7.8, 12.6, 4.2, shift=5.0, up=-2.4, thick=0.5)
    k.star(10.2, 5.2, -3.6)
    k.go(21.9)


def the_sluice(k):
    """Tested: a wall in the water. The way is under it."""
    k.beat("The sluice", "Over it nobody gets. Look below.", eye=(-4, -1.5, 4.5), look=(12, 0, -1))
    k.island(0, 8, 14, deep=9, chamfer=2)
    k.checkpoint(4, "The sluice")
    k.palm(2, 5, tall=5.5)
    k.palm(6, -5.2, tall=6)
    k.go(7.6)
    pool(k, 0, 20, 9, 5.4)
    k.wall(7.6, 8.6, 23, -2.9, 5.4, material="side")
    for edge in (-1, 1):
        k.block(7.2, 9.0, 3.2, -5.3, -2.9, shift=edge * 3.0, material="accent", top="accent")
    k.way(0.6, (19.5, 0, 0), "swim")
    k.coins(3, 8, 4, up=-1.2, up1=-4.2)
    k.coins(9.5, 13, 3, up=-4.0, up1=-2.2)
    k.go(19.9)


def the_jetty(k):
    """Taught: boards that fall. Below is water, and a ramp back."""
    k.beat("The jetty", "Old boards: do not linger.", eye=(-4, -2, 4.5), look=(11, 0, 0))
    k.island(0, 8, 14, deep=9, chamfer=2)
    k.prompt(4, "Cracked boards fall: keep going", long=7, width=12)
    k.palm(2.4, -5, tall=5)
    k.rock(6, 5, size=0.9)
    k.heart(3, 4)
    k.go(7.6)
    pool(k, 0, 19, 10, 4.0)
    for i in range(5):
        k.crumble(1.6 + 3.3 * i, 4.2 + 3.3 * i, 3.0, up=0.35)
    k.coins(3, 16, 5, up=1.3)
    k.go(18.9)


def the_old_bridge(k):
    """Tested: the same boards over the deep, with one rock in the middle to breathe on."""
    k.beat("The old bridge", "Run, jump, run.", eye=(-4, 2, 4.5), look=(13, 0, -0.5))
    k.island(0, 9, 14, deep=9, chamfer=2)
    k.checkpoint(4.5, "The old bridge")
    k.palm(3, 5, tall=6)
    k.palm(5.5, -5, tall=5)
    k.go(9)
    k.crumble(0.8, 4.2, 3.0, up=0)
    k.crumble(6.2, 9.2, 3.0, up=0.2, shift=0.8)
    k.crumble(11.4, 14.2, 3.0, up=0.4)
    k.column(17.8, 0, 1.9, up=0.6, deep=8)
    k.crumble(21.8, 24.6, 2.8, up=0.6, shift=-0.8)
    k.crumble(26.9, 29.6, 2.8, up=0.8)
    k.coins(2, 13, 5, up=1.3)
    k.coins(22, 29, 4, up=1.7)
    k.column(17.8, 6.8, 1.3, up=1.8, deep=5)   # a star beside the rock: two jumps there and back
    k.star(17.8, 6.8, 2.9)
    k.coin(17.8, 3.9, 2.8)
    k.go(32, up=0.6)


def the_moles(k):
    """Tested: a long swim against two moles, over the first or under it; coins show which is quicker."""
    k.beat("The moles", "Over or under: dive in time.", eye=(-4.5, -2.5, 5), look=(14, 0, -1))
    k.island(0, 8, 15, deep=9, chamfer=2)
    k.palm(2.4, 5.4, tall=6)
    k.palm(5.6, -5.4, tall=5)
    k.rock(3, -5, size=0.9)
    k.go(7.6)
    pool(k, 0, 29, 11, 5.0)
    k.wall(6.6, 7.6, 13.2, -2.3, 1.0, material="accent")
    k.wall(14.0, 15.0, 13.2, -5.2, -1.9, material="accent")
    k.coins(2.5, 6, 3, up=-1.0, up1=-3.2)
    k.coins(8.2, 13, 4, up=-3.4, up1=-1.2)
    k.coins(15.8, 20, 3, up=-1.0, up1=-2.2)
    for a, x, size in ((4, -4.2, 1.1), (11, 4.2, 1.4), (18.5, -4.2, 1.2)):
        k.rock(a, x, up=-5.0, size=size, material="side")
    k.crystal(10.6, -4.2, size=1.4, up=-5.0)
    k.way(0.6, (28.6, 0, 0), "swim")
    k.go(28.9)


def the_narrows(k):
    """Taught: the dash. Eight metres of water between two jetties; who falls short swims."""
    k.beat("The narrows", "Jump, jump again, dash.", eye=(-4, 1.5, 4.5), look=(12, 0, 0))
    k.island(0, 10, 14, deep=9, chamfer=2)
    k.prompt(6, "{dash} to dash, also in the air", long=8, width=12)
    k.checkpoint(4, "The narrows")
    k.palm(2, -5, tall=5.5)
    k.rock(7.5, 5, size=1.0)
    k.go(9.6)
    pool(k, 0, 16, 10, 4.0)
    k.slab(-1, 3.2, 4.0, up=0.5, thick=0.6, top="plank", trim="plank", body="dark wood")
    k.slab(10.6, 16.4, 4.0, up=0.5, thick=0.6, top="plank", trim="plank", body="dark wood")
    for a in (0.6, 2.6, 11.2, 13.6):
        for edge in (-1, 1):
            k.block(a - 0.15, a + 0.15, 0.3, -4.0, 0.1, shift=1.6 * edge, material="dark wood", top="dark wood")
    k.way(2.4, (11.6, 0, 0.5), "dash", up=0.5)
    k.coins(3.6, 10.2, 5, up=1.6, arc=1.6)
    k.go(15.9)
    k.island(0, 9, 14, deep=9, chamfer=2)
    k.palm(3, 5, tall=6)
    k.go(4.5, turn=90)
    k.go(6.7)


def the_teeth(k):
    """Tested: dashes over the deep, and on the island between them something that jumps as well."""
    k.beat("The teeth", "Jump, jump, dash; mind the jumper.", eye=(-3, -2, 4.5), look=(13, 0, 0))
    k.way(-0.6, (7.9, 0, 0), "dash")
    k.coins(1.2, 6.2, 4, up=1.6, arc=1.4)
    k.go(7.2)
    k.island(0, 17, 15, deep=9, chamfer=3)
    k.enemy("jumper", 11, 0, 0.0, sight=10, leash=9)
    for a, x, size in ((4.5, -4.5, 1.3), (9, 4.8, 1.5), (13.5, -4, 1.1)):
        k.rock(a, x, size=size)
    k.block(6, 8.6, 2.6, 0, 1.3, shift=-1.5, material="side", chamfer=0.4)
    k.palm(3, 5.4, tall=5)
    k.palm(14.5, 5, tall=6)
    k.coin_ring(11, 0, 3, 6)
    k.checkpoint(15, "The broken pier")
    k.column(11.5, 14.2, 1.6, up=0.4, deep=6)   # a star: a dash aside, and back
    k.star(11.5, 14.2, 1.5)
    k.go(17)
    k.way(-0.6, (7.7, 0, 0.2), "dash")
    k.coins(1.2, 6.0, 4, up=1.7, arc=1.4)
    k.go(7.0, up=0.2)


def the_broken_pier(k):
    """Twisted: what falls and what is too far, at once. A dash on to boards that will not wait, three times."""
    k.beat("The broken pier", "Dash, land, run: the boards do not wait.", eye=(-4.5, 2.5, 5), look=(14, 0, 0))
    k.island(0, 8, 14, deep=9, chamfer=2)
    k.palm(2.4, -5, tall=5.5)
    k.lamp(6.6, 3.2)
    k.go(8)
    edge, up = 0.0, 0.0
    for i in range(2):
        k.way(edge - 0.6, (edge + 7.8, 0, up + 0.1), "dash", up=up)
        k.coins(edge + 1.2, edge + 6.0, 3, up=up + 1.7, arc=1.3)
        edge += 7.0
        k.slab(edge, edge + 2.4, 3.6, up=up + 0.1, thick=0.6, top="plank", trim="plank", body="dark wood")
        k.crumble(edge + 2.7, edge + 5.7, 3.2, up=up + 0.1, delay=0.9)
        k.crumble(edge + 8.0, edge + 11.0, 3.2, up=up + 0.4, delay=0.9)
        k.coins(edge + 3.6, edge + 10, 3, up=up + 1.2, up1=up + 1.5, arc=0.5)
        edge += 13.6
        up += 0.6
        k.column(edge + 1.8, 0, 2.0, up=up, deep=6)
        edge += 3.6
    k.go(edge + 2.6, up=up + 0.3)
    k.island(0, 6, 12, deep=9, chamfer=2)
    k.checkpoint(3, "The well")
    k.palm(3.4, 4.4, tall=5)
    k.go(6)


def the_well(k):
    """Twisted: a tower full of water. In at its foot, up through the middle, out over its rim."""
    k.beat("The well", "Swim up.", eye=(-3, -3.5, 4), look=(12, 0, 4))
    k.island(0, 19, 16, deep=10, chamfer=2.5)
    k.prompt(4, "{jump} swims up", long=7, width=12)
    tall = 9.6
    for edge in (-1, 1):
        k.wall(6.5, 13.7, 1.0, 0, tall, shift=3.1 * edge, material="side")
        k.wall(6.65, 7.31, 1.6, 0.01, 3.4, shift=1.9 * edge, material="accent")
    k.wall(6.56, 7.4, 5.4, 3.43, tall - 0.04, material="side")
    k.wall(12.8, 13.6, 5.4, 0.03, tall - 0.72, material="side")
    k.water(7.3, 12.9, 5.3, tall - 0.75, tall - 0.7)
    k.block(11.4, 12.9, 5.3, tall - 2.2, tall - 1.5, material="accent", top="path")
    k.block(12.2, 12.95, 5.34, tall - 2.0, tall - 1.1, material="accent", top="path")
    k.way(5.6, (13.3, 0, tall - 0.72), "swim")
    k.coins(10, 10, 5, up=1.4, up1=tall - 1.6)
    k.slab(13.6, 19.4, 5, up=tall - 1.4, thick=0.7)
    for edge in (-1, 1):
        k.palm(4, 6 * edge, tall=6)
    k.rock(17, 5.5, size=1.2)
    k.bush(17, -5.6)
    k.heart(17, 0, tall - 0.5)
    k.go(19.4, up=tall - 1.4)


def the_harbour(k):
    """Concluded: boards, a dash, a dive; the lighthouse shows the way from the lagoon on."""
    k.beat("The harbour", "Down to the lighthouse.", eye=(-5, -5, 5), look=(14, 0, -5))
    k.crumble(1.6, 4.6, 3.0, up=-0.6)
    k.crumble(6.6, 9.6, 3.0, up=-1.8)
    k.coins(2, 9, 4, up=0.6, up1=-0.7)
    k.slab(12, 16.4, 4.2, up=-3.4, thick=0.8)
    k.way(16.0, (24.0, 0, -3.8), "dash", up=-3.4)
    k.coins(17.2, 22.4, 4, up=-1.8, up1=-2.4, arc=1.2)
    k.go(23.4, up=-3.8)
    k.island(0, 9, 16, deep=9, chamfer=2)
    k.checkpoint(4.5, "The harbour")
    k.palm(3, 6, tall=5)
    k.palm(6, -6, tall=6)
    k.go(8.6)
    pool(k, 0, 18, 13, 4.2)
    k.wall(7.0, 8.0, 15.2, -2.4, 0.9, material="accent")      # a mole: over it, or under it
    k.coins(3, 13, 5, up=-1.4)
    k.way(0.6, (17.6, 0, 0), "swim")
    k.go(17.9)
    k.island(0, 21, 17, deep=10, chamfer=4)
    k.patch(1.2, 10, 2.8)
    k.enemy("jumper", 8, 3.5, 0.0, sight=8, leash=7)
    k.tower(15, 6.0, 1.8, 0, 9.5, corners=12, material="trim", cap="accent")
    k.lamp(15, 6.0, up=9.5, tall=1.0)
    k.palm(5, -5.6, tall=6)
    k.palm(12, -6, tall=5.5)
    k.coins(3, 8, 3)
    k.goal(15, -0.5)


if __name__ == "__main__":
    palette = {**PALETTE, "plank": "#b98a5c"}
    level = Level("Tides", "Swim, run over what falls, dash over the rest.", order=5, par=105, silver=155, bronze=240, palette=palette, kill_y=-14,
                  music="calm", sky="day", secret=False, stars_needed=0)
    level.play(the_lagoon, the_sluice, the_jetty, the_old_bridge, the_moles, the_narrows, the_teeth,
               the_broken_pier, the_well, the_harbour)
    level.write()
