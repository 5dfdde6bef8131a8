"""What is only looked at: trees, rocks, lamps, far islands. None of it is solid but the trunks."""

import math

from .shapes import Frame, rectangle, ring


class Scenery:
    def tree(self, along, across, up=0.0, tall=4.0, leaf="leaf", light="light leaf"):
        here = self.frame.moved(along, across, up)
        thin = 0.09 * tall ** 0.8
        self.still.loft(here, ring(thin, 6), [(tall * 0.55, thin * 0.35), (0.25, 0.05), (-0.1, -0.1)], ["trunk"] * 2, top="trunk")
        for h, size, material in ((0.62, 0.36, leaf), (0.86, 0.26, light)):
            lean = (self.dice.uniform(-0.05, 0.05) * tall, self.dice.uniform(-0.05, 0.05) * tall)
            self.ball(self.decor, here.moved(lean[1], lean[0], h * tall), size * tall, material, 7, 0.8)

    def ball(self, mesh, here, radius, material, corners=8, flat=1.0):
        """Rounded, in four bands."""
        rings = []
        for degrees in (90, 48, 8, -35, -90):
            c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            rings.append((s * radius * flat, radius * (1 - c)))
        mesh.loft(here, ring(radius, corners, self.dice.uniform(0, 40)), rings, [material] * 4)

    def pine(self, along, across, up=0.0, tall=5.0, leaf="leaf", snow="light leaf"):
        here = self.frame.moved(along, across, up)
        self.still.loft(here, ring(0.05 * tall, 6), [(tall * 0.3, 0), (-0.1, -0.05)], ["trunk"])
        for low, high, radius in ((0.18, 0.55, 0.30), (0.42, 0.78, 0.23), (0.66, 1.0, 0.15)):
            turn = self.dice.uniform(0, 60)
            self.decor.loft(here, ring(radius * tall, 7, turn),
                            [(high * tall, radius * tall), ((low * 0.45 + high * 0.55) * tall, radius * tall * 0.52),
                             (low * tall, 0)], [snow, leaf], bottom=leaf)

    def palm(self, along, across, up=0.0, tall=5.0):
        here = self.frame.moved(along, across, up)
        lean = self.dice.uniform(-0.8, 0.8)
        self.still.loft(here, ring(0.22, 6), [(tall, 0.1, (lean, 0.3)), (tall * 0.5, 0.06, (lean * 0.3, 0.1)), (-0.1, -0.08)],
                        ["trunk", "trunk"], top="trunk")
        crown = here.moved(0.3, lean, tall)
        for i in range(7):
            leaf = crown.moved(turn=360 / 7 * i + self.dice.uniform(-8, 8))
            tone = "leaf" if i % 2 else "light leaf"
            a, b, c, d = (leaf.at(0, 0, 0.1), leaf.at(1.1, 0.36, 0.35), leaf.at(2.2, 0, -0.5), leaf.at(1.1, -0.36, 0.35))
            e = leaf.at(1.1, 0, 0.5)
            for corners in ((a, b, e), (e, b, c), (a, e, d), (e, c, d)):
                self.decor.face(tone, *corners)
                self.decor.face(tone, *[(x, y, z - 0.04) for x, y, z in reversed(corners)])

    def rock(self, along, across, up=0.0, size=0.9, material="rock"):
        here = self.frame.moved(along, across, up, self.dice.uniform(0, 90))
        lean = (self.dice.uniform(-0.15, 0.15) * size, self.dice.uniform(-0.15, 0.15) * size)
        self.still.loft(here, ring(size * 0.75, 7), [(size * 0.75, size * 0.45, lean), (size * 0.45, size * 0.1, lean), (-0.15, 0)],
                        [material, material], top="side")

    def bush(self, along, across, up=0.0, size=0.7):
        self.ball(self.decor, self.frame.moved(along, across, up + size * 0.35), size, "leaf" if self.dice.random() < 0.5 else "light leaf",
                  6, 0.75)

    def tuft(self, along, across, up=0.0, material="light leaf", size=0.4):
        """Three blades of grass, a flower's worth."""
        for i in range(3):
            here = self.frame.moved(along, across, up, 120 * i + self.dice.uniform(0, 60))
            a, b, c = here.at(0.02, -0.07, -0.02), here.at(0.02, 0.07, -0.02), here.at(size * 0.6, 0, size)
            self.decor.face(material, a, b, c)
            self.decor.face(material, c, b, here.at(-0.02, 0, -0.02))
            self.decor.face(material, here.at(-0.02, 0, -0.02), a, c)

    def meadow(self, along0, along1, width, count, shift=0.0, up=0.0, clear=1.6):
        """Tufts strewn over the ground, but not where one runs."""
        for _ in range(count):
            side = self.dice.choice((-1, 1))
            self.tuft(self.dice.uniform(along0, along1), shift + side * self.dice.uniform(clear, max(clear + 0.1, width / 2 - 0.4)), up,
                      self.dice.choice(("light leaf", "leaf", "accent")), self.dice.uniform(0.25, 0.5))

    def lamp(self, along, across, up=0.0, tall=2.4):
        here = self.frame.moved(along, across, up)
        self.still.loft(here, ring(0.12, 6), [(tall, 0.04), (0.3, 0), (0.25, -0.1), (-0.1, -0.12)], ["dark", "dark", "dark"])
        self.decor.loft(here, ring(0.28, 6), [(tall + 0.65, 0.26), (tall + 0.5, 0.0), (tall + 0.45, 0.08), (tall + 0.02, 0.12), (tall, 0.05)],
                        ["dark", "dark", "lamp", "dark"], bottom="dark")

    def flag(self, along, across, up=0.0, tall=4.5, cloth="accent"):
        here = self.frame.moved(along, across, up)
        self.still.loft(here, ring(0.1, 6), [(tall, 0.03), (-0.1, 0)], ["trunk"], top="trunk")
        a, b, c = here.at(0, 0.1, tall - 0.1), here.at(0, 1.7, tall - 0.55), here.at(0, 0.1, tall - 1.0)
        self.decor.face(cloth, a, b, c)
        self.decor.face(cloth, *[here.at(0.03, x, h) for x, h in ((0.1, tall - 1.0), (1.7, tall - 0.55), (0.1, tall - 0.1))])

    def gear(self, along, across, up, radius, thick=0.5, teeth=10, material="machine", facing="back"):
        """A still wheel of a clockwork: its face looks back along the way, to the right of it, or up."""
        outline = []
        for i in range(teeth):
            for share, r in ((0.0, 0.82), (0.2, 1.0), (0.5, 1.0), (0.7, 0.82)):
                turn = math.radians(360 / teeth * (i + share))
                outline.append((radius * r * math.cos(turn), radius * r * math.sin(turn)))
        here = self.frame.moved(along, across, up)
        n = len(outline)

        def at(k, h):
            x, y = outline[k % n]
            return here.at(*{"back": (-h, x, y), "right": (x, h, y), "up": (y, x, h)}[facing])

        for k in range(n):
            self.decor.face("machine trim", at(k, 0), at(k + 1, 0), at(k + 1, thick), at(k, thick))
        self.decor.face(material, *[at(k, thick) for k in range(n)])
        self.decor.face(material, *[at(k, 0) for k in reversed(range(n))])
        hub = [(0.3 * x, 0.3 * y) for x, y in ring(radius, 8)]
        outline, n = hub, 8
        for k in range(n):
            self.decor.face("accent", at(k, thick), at(k + 1, thick), at(k + 1, thick + 0.12), at(k, thick + 0.12))
        self.decor.face("accent", *[at(k, thick + 0.12) for k in range(n)])

    def crystal(self, along, across, up=0.0, size=1.2, material="crystal"):
        here = self.frame.moved(along, across, up)
        for _ in range(3):
            lean = (self.dice.uniform(-0.4, 0.4) * size, self.dice.uniform(-0.4, 0.4) * size)
            tall = size * self.dice.uniform(0.6, 1.2)
            thin = size * 0.2
            self.decor.loft(here.moved(lean[1] * 0.4, lean[0] * 0.4), ring(thin, 5), [(tall, thin, lean), (tall * 0.7, 0, (lean[0] * 0.7, lean[1] * 0.7)), (-0.1, thin * 0.3)],
                            [material, material])

    def horizon(self, low, high, count=8):
        """Pale islands out of reach, all around the box of the level (x, y, z of its corners)."""
        middle = [(a + b) / 2 for a, b in zip(low, high)]
        for i in range(count):
            turn = math.radians(360 / count * i + self.dice.uniform(-12, 12))
            away, radius = self.dice.uniform(48, 80), self.dice.uniform(10, 17)
            x, y = (m + c * ((h - l) / 2 + away + radius) for m, c, l, h in zip(middle, (math.cos(turn), math.sin(turn)), low, high))
            self.far_island(Frame(x, y, low[2] + self.dice.uniform(0.1, 0.9) * (high[2] - low[2]) - 3, self.dice.uniform(0, 90)), radius)

    def far_island(self, here, radius):
        self.decor.loft(here, ring(radius, 8), [(0, 0.12 * radius), (-0.06 * radius, 0), (-0.5 * radius, 0.25 * radius), (-1.2 * radius, 0.8 * radius)],
                        ["far top", "far", "far"], top="far top", bottom="far")
        for _ in range(3):
            spot = here.moved(self.dice.uniform(-0.5, 0.5) * radius, self.dice.uniform(-0.5, 0.5) * radius)
            tall = radius * self.dice.uniform(0.4, 0.9)
            if self.far_towers:
                self.decor.loft(spot, rectangle(radius * 0.28, radius * 0.28), [(tall * 1.4, 0.03 * radius), (tall * 1.37, 0), (-0.3, 0)],
                                ["far top", "far"], top="far top")
            else:
                self.decor.loft(spot, ring(tall * 0.3, 6), [(tall, tall * 0.3), (tall * 0.25, 0), (-0.3, tall * 0.15)], ["far top", "far"])
