"""What moves, what is collected and what is only marked. Extras are in the file's axes, +Y up."""

import math

from .export import file_axes
from .shapes import Mesh, rectangle, ring


class Things:
    # Marks.

    def mark(self, kind, along, across, up, node=None, **extras):
        # Only what looks somewhere is turned: -Z of the file looks along the way. All else keeps the file's axes.
        heading = -self.frame.heading if kind in ("spawn", "checkpoint") else 0
        self.node(node or self.numbered(kind), None, self.frame.at(along, across, up), heading=heading, kind=kind,
                  **extras)

    def offset(self, along, across=0.0, up=0.0):
        return file_axes(self.frame.turn(along, across, up))

    def size(self, long, width, tall):
        """A box along the way, as [x, y, z] of the file."""
        x, y, z = self.frame.turn(long, width, tall)
        (ax, ay), (bx, by) = self.frame.axes()
        x, y = abs(ax) * long + abs(bx) * width, abs(ay) * long + abs(by) * width
        return [round(x, 3), round(z, 3), round(y, 3)]

    def beat(self, name, text, eye=(-9, 0, 5), look=(8, 0, 0.5)):
        """A beat begins here; its picture is taken from `eye` towards `look`, both (along, across, up)."""
        self.beats += 1
        place = self.frame.at()
        self.node(f"beat {self.beats:02}", None, place, kind="beat", order=self.beats, name=name, text=text,
                  eye=self.offset(*eye), look=self.offset(*look))

    def spawn(self, along, across=0.0, up=0.0):
        self.mark("spawn", along, across, up, node="spawn")

    def checkpoint(self, along, section, across=0.0, up=0.0):
        """A post at the side of the way, which is only drawn, and a round plate to run over."""
        self.checkpoints += 1
        self.still.loft(self.frame.moved(along, across, up), ring(1.3, 12), [(0.05, 0.1), (-0.05, 0)], ["trim"], top="path")
        self.mark("checkpoint", along, across, up + 0.05, order=self.checkpoints, section=section)

    def goal(self, along, across=0.0, up=0.0, radius=1.6):
        """A round dais with four columns under a ring, and a beam that is seen from afar."""
        here = self.frame.moved(along, across, up)
        self.still.loft(here, ring(2.9, 16), [(0.3, 0.1), (0.2, 0), (-0.1, -0.1)], ["trim", "accent"], top="path")
        self.still.loft(here.moved(up=0.3), ring(1.7, 16), [(0.06, 0.08), (-0.05, 0)], ["beacon"], top="beacon")
        for i in range(4):
            post = here.moved(turn=45 + 90 * i).moved(2.4)
            self.still.loft(post, ring(0.26, 8), [(3.7, 0), (0.55, 0.04), (0.5, -0.08), (0.2, -0.1)], ["accent", "trim", "trim"])
        self.still.loft(here, ring(2.95, 16), [(4.3, 0.25), (4.15, 0), (3.7, 0)], ["trim", "accent"], top="trim", bottom="accent")
        self.decor.loft(here.moved(up=4.35), ring(0.9, 8), [(1.7, 0.9), (0.8, 0), (0.0, 0.6)], ["beacon"] * 2, bottom="beacon")
        self.mark("goal", along, across, up + 0.36, node="goal", radius=radius)

    def prompt(self, along, text, long=8.0, width=8.0, tall=5.0, across=0.0, up=0.0):
        self.mark("prompt", along, across, up + tall / 2 - 0.5, text=text, size=self.size(long, width, tall))

    def way(self, along, to, how, across=0.0, up=0.0, by=None):
        """Where the way needs more than walking and jumping: from here to `to`, (along, across, up) from the frame."""
        extras = {"by": by} if by else {}
        self.mark("way", along, across, up, how=how,
                  to=self.offset(to[0] - along, to[1] - across, to[2] - up), **extras)

    def camera(self, along0, along1, width, tall, pitch, distance, yaw=None, across=0.0, up=0.0):
        """Within this box the camera stands behind, or at `yaw`, and looks down by `pitch`."""
        self.mark("camera", (along0 + along1) / 2, across, up + tall / 2, size=self.size(along1 - along0, width, tall),
                  yaw=round((-self.frame.heading if yaw is None else yaw) % 360, 1), pitch=pitch, distance=distance)

    def water(self, along0, along1, width, surface, deep, shift=0.0):
        self.mark("water", (along0 + along1) / 2, shift, surface - deep / 2, size=self.size(along1 - along0, width, deep))

    # What is collected.

    def coin(self, along, across=0.0, up=0.9):
        self.mark("coin", along, across, up)

    def coins(self, along0, along1, count, across0=0.0, across1=None, up=0.9, up1=None, arc=0.0):
        """A line of coins; `arc` lifts its middle, as a jump does."""
        across1 = across0 if across1 is None else across1
        up1 = up if up1 is None else up1
        for i in range(count):
            t = i / (count - 1) if count > 1 else 0.5
            self.coin(along0 + (along1 - along0) * t, across0 + (across1 - across0) * t,
                      up + (up1 - up) * t + arc * 4 * t * (1 - t))

    def coin_ring(self, along, across, radius, count, up=0.9):
        for i in range(count):
            turn = 2 * math.pi * i / count
            self.coin(along + radius * math.cos(turn), across + radius * math.sin(turn), up)

    def star(self, along, across=0.0, up=1.1):
        self.mark("star", along, across, up)

    def heart(self, along, across=0.0, up=0.9):
        self.mark("heart", along, across, up)

    def key(self, along, across=0.0, up=1.0, door="red"):
        self.mark("key", along, across, up, door=door)

    def enemy(self, type, along, across=0.0, up=0.0, route=(), sight=9.0, leash=8.0):
        """`route` has places as (along, across) or (along, across, up) from the enemy."""
        self.mark("enemy", along, across, up, type=type, route=[self.offset(*p) for p in route], sight=sight, leash=leash)

    # What moves. Each is a node of its own with the middle of what moves as its origin.

    def mover(self, kind, along, across, up, shape, **extras):
        place = self.frame.at(along, across, up)
        mesh = Mesh(place)
        shape(mesh, self.frame.moved(along, across, up))
        node = self.numbered(kind)
        self.node(node, mesh, place, kind=kind, **extras)
        return node

    def platform(self, along, across=0.0, up=0.0, to=(), long=3.0, width=3.0, speed=2.5, pause=1.0, loop="back",
                 starts="always", phase=0.0, thick=0.5):
        """A board that goes to each of `to`, (along, across, up) from where it stands, and back. `up` is its top."""
        def shape(mesh, here):
            top = here.moved(up=thick / 2)
            mesh.loft(top, rectangle(width, long, 0.35),
                      [(0, 0.1), (-0.1, 0), (-thick * 0.6, 0), (-thick, 0.3)], ["machine trim", "machine trim", "machine"],
                      top="machine", bottom="machine")
            mesh.loft(top.moved(up=0.03), rectangle(width - 0.9, long - 0.9, 0.25), [(0, 0.02), (-0.06, 0)], ["machine trim"], top="machine trim")
            mesh.loft(top.moved(up=-thick - 0.25), rectangle(width * 0.4, long * 0.4, 0.2), [(0.3, 0), (0, 0), (-0.2, 0.25)], ["dark", "machine trim"],
                      bottom="machine trim")

        path = [[0, 0, 0]] + [self.offset(*stop) for stop in to]
        return self.mover("platform", along, across, up - thick / 2, shape, path=path, speed=speed, pause=pause,
                          loop=loop, starts=starts, phase=phase)

    def turntable(self, along, across=0.0, up=0.0, radius=3.0, deg_per_s=30.0, arms=0, thick=0.5):
        """A disc that turns, or a hub with arms."""
        def shape(mesh, here):
            if arms == 0:
                mesh.loft(here, ring(radius, 20), [(0, 0.1), (-0.1, 0), (-thick * 0.7, 0), (-thick, 0.3)],
                          ["machine trim", "machine trim", "machine"], top="machine", bottom="machine")
                for i in range(6):
                    spoke = here.moved(turn=60 * i).moved(radius * 0.62, 0, 0.03)
                    mesh.loft(spoke, rectangle(0.5, radius * 0.5, 0.1), [(0, 0.02), (-0.06, 0)], ["machine trim"], top="machine trim")
                mesh.loft(here, ring(0.7, 10), [(0.04, 0.05), (-0.05, 0)], ["accent"], top="accent")
            else:
                for i in range(arms):
                    arm = here.moved(turn=360 / arms * i).moved((radius + 1.2) / 2)
                    mesh.loft(arm, rectangle(2.4, radius - 1.2, 0.2), [(-0.01, 0.1), (-0.11, 0), (-thick, 0), (-thick - 0.1, 0.2)],
                              ["machine trim", "machine", "machine"], top="machine", bottom="machine")
                mesh.loft(here, ring(2.0, 12, 15), [(0.02, 0.1), (-0.08, 0), (-thick - 0.2, 0), (-thick - 0.4, 0.3)],
                          ["machine trim", "machine trim", "machine"], top="machine trim", bottom="machine")

        return self.mover("turntable", along, across, up, shape, deg_per_s=deg_per_s)

    def crumble(self, along0, along1, width, shift=0.0, up=0.0, delay=0.7, back=4.0):
        """Cracked boards that fall a moment after they are stepped on."""
        long, thick = along1 - along0, 0.4

        def shape(mesh, here):
            rows = 2 if long > 2 else 1
            for i in range(rows):
                for k in (-1, 1):
                    piece = here.moved(long * ((i + 0.5) / rows - 0.5), k * width / 4, thick / 2)
                    mesh.loft(piece, rectangle(width / 2 - 0.03, long / rows - 0.03, 0.12), [(0, 0.07), (-0.07, 0), (-thick + 0.1, 0), (-thick, 0.2)],
                              ["crumble side", "crumble", "crumble side"], top="crumble", bottom="crumble side")

        return self.mover("crumble", (along0 + along1) / 2, shift, up - thick / 2, shape, delay=delay, back=back)

    def bounce(self, along, across=0.0, up=0.0, speed=11.0, radius=1.2):
        """A pad that throws upwards: (speed^2 / 44) metres high."""
        def shape(mesh, here):
            mesh.loft(here, ring(radius, 14), [(0.15, 0.3), (-0.1, 0), (-0.2, 0)], ["bounce", "bounce rim"], top="bounce", bottom="bounce rim")

        return self.mover("bounce", along, across, up + 0.15, shape, speed=speed)

    def door(self, along, width=3.0, tall=3.0, up=0.0, across=0.0, door=None, coins=None):
        """Slides up out of the way: with the key of its colour, or once so many coins are collected."""
        colour = f"{door} door" if door else "coin door"

        def shape(mesh, here):
            mesh.extrude(here, [(-0.2, -tall / 2), (0.2, -tall / 2), (0.2, tall / 2), (-0.2, tall / 2)], -width / 2, width / 2, [colour] * 4, colour)
            for x in (-width * 0.3, 0, width * 0.3):
                mesh.extrude(here, [(-0.27, -tall / 2 + 0.15), (0.27, -tall / 2 + 0.15), (0.27, tall / 2 - 0.15), (-0.27, tall / 2 - 0.15)],
                             x - 0.18, x + 0.18, [colour + " trim"] * 4, colour + " trim")

        extras = {"door": door} if door else {"coins": coins}
        return self.mover("door", along, across, up + tall / 2, shape, **extras)

    def roller(self, along, across=0.0, up=0.0, width=3.0, radius=0.55, to=(), speed=3.0, pause=0.4, damage=1):
        """A spiked roller across the way that goes to and fro."""
        def shape(mesh, here):
            corners = 8
            outline = ring(radius, corners, 22.5)
            mesh.extrude(here, outline, -width / 2, width / 2, ["spikes" if i % 2 else "deadly" for i in range(corners)], "spike base")

        path = [[0, 0, 0]] + [self.offset(*stop) for stop in to]
        return self.mover("hazard", along, across, up, shape, damage=damage, path=path, speed=speed, pause=pause, loop="back")

    def sweeper(self, along, across=0.0, up=0.0, reach=3.5, deg_per_s=70.0, arms=2, damage=1):
        """Bars that turn about a post, low enough to be jumped over."""
        def shape(mesh, here):
            mesh.loft(here, ring(0.4, 8), [(0.55, 0.1), (0.45, 0), (-0.4, 0)], ["dark", "dark"], top="dark", bottom="dark")
            for i in range(arms):
                arm = here.moved(turn=360 / arms * i).moved((reach + 0.3) / 2)
                mesh.loft(arm, rectangle(0.4, reach - 0.3), [(0.2, 0.08), (0.12, 0), (-0.12, 0), (-0.2, 0.08)], ["deadly", "spikes", "deadly"], top="deadly", bottom="deadly")

        return self.mover("hazard", along, across, up + 0.45, shape, damage=damage, deg_per_s=deg_per_s)
