"""Clockwork: ferries, lifts, turning discs, a great wheel and a train; and the first thing that runs after one.

    blender -b --factory-startup --python-exit-code 1 -P levels/platformer/clockwork.py -- levels/platformer/clockwork.glb
"""

import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))

from kit import Level  # noqa: E402

PALETTE = {
    "top": "#e2d6b8", "trim": "#f6ecd2", "side": "#5f8a90", "rock": "#456570", "path": "#c7b893", "accent": "#b98a54",
    "leaf": "#5c9a86", "light leaf": "#8fc2a4", "trunk": "#6d5546", "far": "#9db4bd", "far top": "#c6cfc8",
    "machine": "#4d5fb0", "machine trim": "#a3b2f0",
}


def the_yard(k):
    """Taught: a board that goes to and fro, over a court that is only a step down."""
    k.beat("The yard", "Step on, ride, step off. Below is firm ground.", eye=(-3, -5.5, 4.5), look=(14, 1, 0))
    k.island(-6, 9, 16, deep=9, chamfer=3)
    k.patch(-2, 7.6, 2.6)
    k.spawn(-2.5)
    k.prompt(4, "Boards move: what stands on them is taken along", long=9, width=14)
    k.coins(1.5, 7, 4)
    k.island(8.4, 23.6, 18, up=-1.1, deep=8, chamfer=2, top="path", trim="path")
    ferry = k.platform(11.2, 0, 0.1, to=[(9.6, 0, 0)], long=3.2, width=3.6, speed=2.5, pause=1.2)
    k.way(8.2, (24, 0, 0), "ride", by=ferry)
    k.coins(12.5, 19.5, 4, up=1.0)
    k.column(16, -5.6, 1.5, up=1.9, deep=4)     # a star for who jumps from the ferry
    k.star(16, -5.6, 3.0)
    k.coin(16, -3.4, 2.9)
    for a, x in ((10, 6.5), (21.5, -6.5)):
        k.rock(a, x, -1.1, 0.9)
    k.gear(22.6, 6.4, 0.6, 2.6, teeth=10)
    k.gear(22.55, -8.2, -0.8, 2.0, teeth=8)
    k.island(23, 38, 14, deep=9, chamfer=2.5)
    k.patch(24.4, 36.6, 2.4)
    k.lamp(26, 4.5)
    k.lamp(34, -4.5)
    k.tree(28, -4.6, tall=4.5)
    k.checkpoint(31, "The ferries")
    for a, x, tall in ((-4, 5.5, 5), (3, -6, 4.2)):
        k.tree(a, x, tall=tall)
    k.bush(6, 6)
    k.meadow(-4, 7, 14, 8)
    k.go(38)


def the_ferries(k):
    """Tested: two boards that meet over the deep. Who waits for the meeting steps over; who does not has to jump."""
    k.beat("Two ferries", "They meet half way.", eye=(-7, -4.5, 4.5), look=(10, 0, 0))
    first = k.platform(2.1, 0, 0, to=[(4.6, 0, 0)], speed=2.2, pause=1.2)
    second = k.platform(15.1, 0, 0, to=[(-4.6, 0, 0)], speed=2.2, pause=1.2)
    k.way(-0.8, (8.6, 0, 0), "ride", by=first)
    k.way(8.8, (18.0, 0, 0), "ride", by=second)
    k.coins(2, 6.5, 3, up=1.0)
    k.coins(10.6, 15, 3, up=1.0)
    for side in (-1, 1):
        k.column(8.6, 4.6 * side, 0.8, up=4.5, deep=12, corners=8)
    k.gear(9.0, 0, 6.2, 3.4, teeth=14)
    k.go(17.2)


def the_lift(k):
    """Taught: up. A lift along a wall, and another that does not wait as long."""
    k.beat("Lifts", "Boards go up as well.", eye=(-5, 5.5, 4), look=(11, 0, 3))
    k.island(0, 12, 14, deep=9, chamfer=2.5)
    k.patch(1.2, 11.4, 2.4)
    k.checkpoint(5, "The lifts")
    lift = k.platform(14.1, 0, 0, to=[(0, 0, 5.0)], long=3.4, width=3.6, speed=2.2, pause=1.3)
    k.way(11.2, (17, 0, 5.0), "ride", by=lift)
    k.coins(14.1, 14.1, 3, up=2.2, up1=5.2)
    k.island(16.2, 25, 12, up=5.0, deep=12, chamfer=1.5)
    for side in (-1, 1):
        k.wall(16.6, 17.8, 1.2, 5.0, 8.4, shift=3.6 * side, material="side")
    k.gear(16.0, 4.6, 2.2, 2.4, teeth=9)
    k.gear(16.05, -4.4, 0.6, 1.9, teeth=8)
    k.tree(3, -5, tall=4.5)
    k.lamp(9.6, 4.4)
    k.bush(22.5, 4.2, up=5.0)
    again = k.platform(27.1, 0, 5.0, to=[(0, 0, 3.4)], long=3.2, width=3.2, speed=2.6, pause=0.8, phase=1.0)
    k.way(24.2, (30, 0, 8.4), "ride", up=5.0, by=again)
    k.coins(18.5, 23, 4, up=5.9)
    k.heart(20, -4, up=5.9)
    k.go(29.1, up=8.4)


def the_discs(k):
    """Tested: discs that turn under the feet, three in a row, each the other way."""
    k.beat("Turning discs", "Walk against the turning.", eye=(2, -7, 6), look=(13, 9, -1))
    k.island(0, 12, 13, deep=12, chamfer=2.5)
    k.patch(1.2, 8, 2.4)
    k.checkpoint(4, "The discs")
    k.lamp(2, -4.6)
    k.tree(9.5, -4.2, tall=4.5)
    k.go(6, turn=90)
    k.prompt(4, "What turns takes you along, too", long=8, width=10)
    k.go(6.5)
    for i, (a, x, spin) in enumerate(((4.6, 0, 40), (12.4, 1.0, -50), (20.2, 0, 60))):
        k.turntable(a, x, 0.1 * i, radius=3.1, deg_per_s=spin)
    k.coins(2.4, 6.8, 4, up=1.0)
    k.coins(10.4, 14.4, 3, across0=1, up=1.1)
    k.coins(18.2, 22.2, 3, up=1.2)
    k.column(12.4, 7.4, 1.3, up=1.6, deep=5)
    k.star(12.4, 7.4, 2.7)
    k.go(25, up=0.2)


def the_court(k):
    """Taught: somebody. A court with a chaser: run in a curve, jump on his head, or leave him behind."""
    k.beat("The court", "It runs after you. It minds being jumped on.", eye=(-5, -5, 6), look=(11, 0, 0))
    k.island(0, 24, 19, deep=10, chamfer=3)
    k.patch(5, 19, 11, chamfer=3.5)
    k.prompt(2.5, "Jump on its head, or keep away", long=7, width=12)
    k.enemy("chaser", 14.5, 0, 0.03, sight=9, leash=9)
    for a, x in ((8.4, -4), (8.4, 4), (15.6, -4), (15.6, 4)):
        k.block(a - 0.55, a + 0.55, 1.1, 0, 1.7, shift=x, material="side", chamfer=0.2)
        k.lamp(a, x, up=1.7, tall=1.4)
    k.coin_ring(12, 0, 4.2, 8, up=0.95)
    for side in (-1, 1):
        k.tree(4, 7.2 * side, tall=5)
        k.tree(20, 7.2 * side, tall=4.4)
        k.bush(12, 8.0 * side)
    k.arch(21, 3.8, 3.6)
    k.checkpoint(22.6, "The great wheel")
    k.go(24)


def the_great_wheel(k):
    """Twisted: a wheel that ticks on, stop by stop. Up and over; from its height a star is two jumps away."""
    k.beat("The great wheel", "On at the near side, off at the far side.", eye=(-2, -7.5, 4), look=(9, 0, 3))
    r, count = 5.2, 6
    hub = (8.2, 1.2)
    turns = [math.radians(180 - 360 / count * i) for i in range(count)]
    stops = [(hub[0] + r * math.cos(turn), hub[1] + r * math.sin(turn)) for turn in turns]
    boards = []
    for i, (a, up) in enumerate(stops):  # each begins at another stop, and all tick on together
        ride = stops[i + 1:] + stops[:i]
        boards.append(k.platform(a, 0, up, to=[(b - a, 0, v - up) for b, v in ride], long=2.6, width=3.6, speed=2.8,
                                 pause=1.0, loop="round"))
    k.way(-0.8, (16.6, 0, 1.0), "ride", by=boards[0])
    for x in (-3.2, 2.7):
        k.gear(hub[0], x, hub[1], 3.6, teeth=14, facing="right")
        k.column(hub[0], x - 0.25, 0.7, up=hub[1] - 3.4, deep=12, corners=8)
    k.coins(5.6, 10.8, 4, up=6.9, arc=0.5)
    k.column(hub[0] + 2.6, 6.4, 1.4, up=6.6, deep=18, corners=8)
    k.star(hub[0] + 2.6, 6.4, 7.7)
    k.go(15.4, up=1.0)
    k.island(0, 13, 13, deep=10, chamfer=2.5)
    k.patch(1.2, 8, 2.4)
    k.tree(3, 4.6, tall=5)
    k.rock(10, 4.4, size=1.0)
    k.lamp(3, -4.6)
    k.checkpoint(4.5, "The train")
    k.go(6.5, turn=-90)
    k.go(6.5)


def the_train(k):
    """Twisted: a long ride with bars across it. Stand, look ahead, jump."""
    k.beat("The train", "Jump over what comes.", eye=(-6, 4, 4.5), look=(14, 0, 0))
    k.prompt(-2.5, "Bars ahead: jump in time", long=7, width=10)
    train = k.platform(3.0, 0, 0, to=[(26.0, 0, 0)], long=4.6, width=3.4, speed=3.6, pause=2.0)
    k.way(-0.8, (33, 0, 0), "ride", by=train)
    for a in (9.5, 16.5, 23.5):
        for side in (-1, 1):
            k.column(a, 2.9 * side, 0.55, up=1.5, deep=9, corners=8, top="trim")
        k.block(a - 0.2, a + 0.2, 6.0, 0.35, 0.72, material="accent", top="accent")
        k.coins(a - 1.6, a + 1.6, 3, up=1.3, arc=1.0)
    k.gear(13, -5.5, -2.5, 3.0, teeth=12, facing="right")
    k.gear(20, 5.0, -2.0, 2.6, teeth=10, facing="right")
    k.go(31.8)
    k.island(0, 10, 12, deep=10, chamfer=2)
    k.patch(1.2, 9, 2.4)
    k.lamp(3, 4.2)
    k.tree(6, -4.2, tall=4.5)
    k.checkpoint(5, "The clock tower")
    k.go(10)


def the_clock_tower(k):
    """Concluded: lift, arms, lift. Everything turns around the tower that was in sight from the yard on."""
    k.beat("The clock tower", "Lift, arms, lift: up to the bell.", eye=(-2, -7.5, 4.5), look=(14, 2, 6))
    k.tower(18, 0, 4.6, -14, 10.0, corners=16)
    k.gear(13.3, 0, 6.6, 2.6, teeth=12, thick=0.3)
    lift = k.platform(2.0, 0, 0, to=[(0, 0, 3.2)], speed=2.2, pause=1.0)
    k.way(-0.8, (4.6, 0, 3.2), "ride", by=lift)
    k.coins(2, 2, 2, up=2.0, up1=3.6)
    k.slab(4.0, 9.0, 4.0, shift=0, up=3.2, thick=0.8)
    k.coins(5, 8, 3, up=4.1)
    k.turntable(9.6, 9.8, 3.3, radius=4.6, deg_per_s=35, arms=4)
    k.slab(6.2, 9.0, 3.2, shift=3.2, up=3.26, thick=0.8)
    k.coin_ring(9.6, 9.8, 3.4, 6, up=4.3)
    k.slab(15.6, 20.4, 3.6, shift=8.8, up=3.6, thick=0.8)
    top = k.platform(24.7, 8.8, 3.6, to=[(0, 0, 6.4), (0, -6.6, 6.4)], long=3.2, width=3.2, speed=2.6, pause=1.2)
    k.slab(20.2, 22.6, 3.0, shift=8.8, up=3.57, thick=0.6)
    k.way(22, (21.4, 2.0, 10), "ride", across=8.8, up=3.6, by=top)
    k.coins(24.7, 24.7, 3, across0=8.8, up=5.6, up1=9.4)
    k.heart(18, 8.8, up=4.5)
    k.goal(18, 0, up=10.0)


if __name__ == "__main__":
    level = Level("Clockwork", "Ride what moves: ferries, lifts, discs, a wheel, a train.", order=2, par=120, silver=170, bronze=260, palette=PALETTE,
                  kill_y=-9, music="lively", sky="day", far_towers=True, drawings={"side": "bricks", "path": "bricks"}, secret=False, stars_needed=0)
    level.play(the_yard, the_ferries, the_lift, the_discs, the_court, the_great_wheel, the_train, the_clock_tower)
    level.write()
