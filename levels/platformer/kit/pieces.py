"""What is stood on: islands, slabs, columns, ramps, stairs, walls, towers, ladders. Lengths are along the way.

`along0, along1` is the stretch, `width` goes to both sides of the way, which `shift` moves to the right; `up` is the
height of the top above the way's ground.
"""

from .export import file_axes
from .shapes import rectangle, ring

LIP = 0.12   # how far a top stands out over its body
BEVEL = 0.08


class Pieces:
    def island(self, along0, along1, width, shift=0.0, up=0.0, deep=6.0, chamfer=0.9, top="top", trim="trim"):
        """Ground with a bright rim over a cliff in layers that narrows downwards and ends in the air."""
        long = along1 - along0
        here = self.frame.moved((along0 + along1) / 2, shift, up)
        small = min(long, width) / 2
        self.cliff(here, rectangle(width, long, min(chamfer, small * 0.6)), small, deep, top, trim)

    def column(self, along, across, radius=1.2, up=0.0, deep=6.0, corners=10, top="top", trim="trim"):
        """A round stepping stone, else as an island."""
        here = self.frame.moved(along, across, up)
        self.cliff(here, ring(radius, corners, 180 / corners), radius, deep, top, trim)

    def cliff(self, here, outline, small, deep, top, trim):
        def lean():
            return (self.dice.uniform(-0.12, 0.12) * small, self.dice.uniform(-0.12, 0.12) * small)

        self.still.loft(here, outline,
                        [(0, BEVEL), (-BEVEL, 0), (-0.38, 0), (-0.45, LIP), (-0.22 * deep - 0.4, LIP + 0.08 * small),
                         (-0.24 * deep - 0.4, LIP + 0.2 * small), (-0.55 * deep - 0.4, 0.42 * small, lean()),
                         (-0.57 * deep - 0.4, 0.52 * small, lean()), (-deep - 0.4, 0.85 * small, lean())],
                        [trim, trim, "side", "side", "side", "rock", "rock", "rock"], top=top, bottom="rock")

    def slab(self, along0, along1, width, shift=0.0, up=0.0, thick=0.45, chamfer=0.25, top="top", trim="trim",
             body="side", mesh=None):
        """A board with rounded rims that floats, or lies on something."""
        here = self.frame.moved((along0 + along1) / 2, shift, up)
        low = -max(thick, 3 * BEVEL)
        (mesh or self.still).loft(here, rectangle(width, along1 - along0, chamfer),
                                  [(0, BEVEL), (-BEVEL, 0), (low * 0.55, 0), (low, 0.15)],
                                  [trim, trim, body], top=top, bottom=body)

    def patch(self, along0, along1, width, shift=0.0, up=0.0, material="path", chamfer=0.4):
        """A floor of another substance, three centimetres proud of the ground."""
        here = self.frame.moved((along0 + along1) / 2, shift, up)
        self.still.loft(here, rectangle(width, along1 - along0, chamfer), [(0.03, 0.03), (-0.1, 0)], [material],
                        top=material)

    def belt(self, along0, along1, width, speed, shift=0.0, up=0.0):
        """A conveyor on the ground: `speed` [m/s] along the way, or against it if negative. Arrows are only drawn.

        Its kerbs are low and lean by 45 degrees: on a steeper one somebody would neither stand nor be carried on.
        """
        run = file_axes(self.frame.turn(speed))
        name = f"belt {len([n for n in self.materials if n.startswith('belt')]) + 1}"
        same = [n for n, m in self.materials.items() if n.startswith("belt") and m.get("conveyor") == run]
        if not same:
            self.materials[name] = dict(self.materials["machine"], conveyor=run)
        self.patch(along0, along1, width, shift, up, material=same[0] if same else name, chamfer=0.1)
        for edge in (-1, 1):
            here = self.frame.moved((along0 + along1) / 2, shift + edge * (width / 2 + 0.12), up)
            self.still.loft(here, rectangle(0.24, along1 - along0 + 0.1), [(0.12, 0.10), (0.02, 0), (-0.1, 0)], ["machine trim"] * 2, top="machine trim")
        count = max(1, int((along1 - along0) / 1.6))
        point = 0.35 if speed > 0 else -0.35
        for i in range(count):
            a = along0 + (along1 - along0) * (i + 0.5) / count
            for side in (-1, 1):
                here = self.frame.moved(0, shift, up + 0.045)
                corners = [here.at(a + point, 0), here.at(a - point, 0.4 * side * width), here.at(a - point - 0.5 * point, 0.4 * side * width),
                           here.at(a - 0.5 * point, 0)]
                self.decor.face("belt arrow", *(corners if (side < 0) == (speed > 0) else corners[::-1]))

    def block(self, along0, along1, width, up0, up1, shift=0.0, material="side", top="trim", chamfer=0.0):
        """A plain body with a bevelled top; begins a little below up0."""
        here = self.frame.moved((along0 + along1) / 2, shift)
        self.still.loft(here, rectangle(width, along1 - along0, chamfer),
                        [(up1, BEVEL), (up1 - BEVEL, 0), (up0 - 0.15, 0)], [top, material], top=top, bottom=material)

    def wall(self, along0, along1, width, up0, up1, shift=0.0, material="side", cap="trim"):
        """A wall with a plinth and a coping that stands out."""
        here = self.frame.moved((along0 + along1) / 2, shift)
        self.still.loft(here, rectangle(width, along1 - along0),
                        [(up1, BEVEL - LIP), (up1 - BEVEL, -LIP), (up1 - 0.3, -LIP), (up1 - 0.36, 0), (up0 + 0.35, 0),
                         (up0 + 0.3, -0.08), (up0 - 0.2, -0.08)],
                        [cap, cap, cap, material, cap, cap], top=cap, bottom=material)

    def bare_wall(self, along0, along1, width, up0, up1, shift=0.0, material="side", bands=2, stripe="rock"):
        """A smooth wall to slide down and jump off: courses of two tones in one plane, and nothing that stands out."""
        here = self.frame.moved((along0 + along1) / 2, shift)
        step = (up1 - up0) / (2 * bands + 1)
        heights = [up1 - step * i for i in range(2 * bands + 2)]
        rings = [(up1, BEVEL), (up1 - BEVEL, 0)] + [(h, 0) for h in heights[1:]]
        tones = ["trim"] + [material if i % 2 == 0 else stripe for i in range(len(heights) - 1)]
        self.still.loft(here, rectangle(width, along1 - along0), rings, tones, top="trim", bottom=material)

    def tower(self, along, across, radius, up0, up1, corners=14, material="side", cap="trim", top="top"):
        """A round tower: a foot, rings of stone, and a head that stands out."""
        here = self.frame.moved(along, across)
        tall = up1 - up0
        rings = [(up1, BEVEL - 0.25), (up1 - BEVEL, -0.25), (up1 - 0.5, -0.25), (up1 - 0.8, 0)]
        bands = [cap, cap, material]
        count = max(1, int(tall // 4))
        for i in range(1, count):
            h = up1 - 0.8 - (tall - 1.4) * i / count
            rings += [(h + 0.15, 0), (h + 0.1, -0.06), (h - 0.1, -0.06), (h - 0.15, 0)]
            bands += [material, cap, cap, cap]
        rings += [(up0 + 0.5, 0), (up0 + 0.4, -0.2), (up0 - 0.2, -0.2)]
        bands += [material, cap, cap]
        self.still.loft(here, ring(radius, corners, 180 / corners), rings, bands, top=top, bottom=material)

    def ramp(self, along0, along1, width, up0, up1, shift=0.0, deep=1.2, top="path", side="side"):
        """A sloping board; its ends go into what it leads to."""
        self.still.extrude(self.frame.moved(0, shift), [(along0, up0), (along0, up0 - deep), (along1, up1 - deep), (along1, up1)],
                           -width / 2, width / 2, [side, side, side, top], side)

    def stairs(self, along0, along1, width, up0, up1, steps, shift=0.0, deep=1.2, top="path", side="side"):
        """A flight; the last tread is at up1. Under it is a sloping body."""
        run, rise = (along1 - along0) / steps, (up1 - up0) / steps
        profile, materials = [(along0, up0 - deep)], [side]
        for i in range(steps):
            profile += [(along0 + run * i, up0 + rise * i - (0.05 if i == 0 else 0)), (along0 + run * i, up0 + rise * (i + 1))]
            materials += [side, top]
        profile.append((along1, up1))
        materials.append(side)
        profile.append((along1, up1 - deep))
        materials[0] = side
        materials.append(side)
        self.still.extrude(self.frame.moved(0, shift), profile, -width / 2, width / 2, materials, side)
        for edge in (-1, 1):  # strings along both sides, a hand's breadth higher than the treads
            x = shift + edge * (width / 2 + 0.13)
            self.still.extrude(self.frame.moved(0, x), [(along0 - 0.1, up0 + 0.1), (along0 - 0.1, up0 - deep - 0.1),
                                                        (along1 + 0.05, up1 - deep - 0.1), (along1 + 0.05, up1 + 0.18)],
                               -0.13, 0.13, ["trim"] * 4, "trim")

    def ladder(self, along, up0, up1, across=0.0, width=1.2):
        """Rungs on a wall at `along`; climbed by who comes along the way. Leads on to the ground at up1."""
        here = self.frame.moved(0, across)
        self.still.extrude(here, [(along - 0.1, up0), (along + 0.05, up0), (along + 0.05, up1 - 0.12), (along - 0.1, up1 - 0.12)],
                           -width / 2, width / 2, ["dark wood", None, "ladder", "ladder"], "ladder")
        for edge in (-1, 1):
            x = edge * (width / 2 - 0.06)
            self.decor.extrude(here, [(along - 0.22, up0), (along - 0.1, up0), (along - 0.1, up1 + 0.5), (along - 0.22, up1 + 0.5)],
                               x - 0.07, x + 0.07, ["dark wood"] * 4, "dark wood")
        count = max(2, int((up1 - up0) / 0.45))
        for i in range(count):
            h = up0 + (up1 - up0) * (i + 0.5) / count
            self.decor.extrude(here, [(along - 0.17, h), (along - 0.11, h), (along - 0.11, h + 0.08), (along - 0.17, h + 0.08)],
                               -width / 2 + 0.13, width / 2 - 0.13, ["wood"] * 4, None)

    def one_way(self, along0, along1, width, shift=0.0, up=0.0):
        """A floor that is jumped through from below: one solid sheet, and boards below it that are only drawn."""
        here = self.frame.moved(0, shift)
        self.still.face("one way", here.at(along0, width / 2, up), here.at(along1, width / 2, up),
                        here.at(along1, -width / 2, up), here.at(along0, -width / 2, up))
        long = along1 - along0
        count = max(2, round(long / 0.6))
        for i in range(count):
            a, b = along0 + long * i / count + 0.04, along0 + long * (i + 1) / count - 0.04
            self.decor.extrude(here, [(a, up - 0.03), (a, up - 0.15), (b, up - 0.15), (b, up - 0.03)], -width / 2, width / 2,
                               [None, "dark wood", None, "wood"], "wood")
        for x in (-width / 2 + 0.25, width / 2 - 0.25):
            self.decor.extrude(here, [(along0, up - 0.16), (along0, up - 0.3), (along1, up - 0.3), (along1, up - 0.16)],
                               x - 0.1, x + 0.1, ["dark wood"] * 3 + [None], "dark wood")

    def tunnel(self, along0, along1, width, height, up=0.0, shift=0.0, thick=0.6, roof="rock"):
        """Two walls and a roof over ground that is there already."""
        for edge in (-1, 1):
            x = shift + edge * (width / 2 + thick / 2)
            self.block(along0, along1, thick, up, up + height + 0.02, shift=x, material="side", top="side")
        here = self.frame.moved((along0 + along1) / 2, shift, up + height)
        self.still.loft(here, rectangle(width + 2 * thick + 0.4, along1 - along0 + 0.4, 0.2),
                        [(0.7, 0.5), (0.4, 0), (0, 0)], [roof, "trim"], top=roof, bottom="rock")

    def arch(self, along, width, height, up=0.0, shift=0.0, thick=0.7, material="accent"):
        """A gate across the way: two posts and a lintel."""
        for edge in (-1, 1):
            x = shift + edge * (width + thick) / 2
            self.wall(along - thick / 2, along + thick / 2, thick, up, up + height, shift=x, material=material)
        here = self.frame.moved(along, shift, up + height)
        self.still.loft(here, rectangle(width + 2 * thick + 1.0, thick + 0.5, 0.15),
                        [(0.55, 0.1), (0.45, 0), (0.1, 0), (-0.02, 0.1)], ["trim", material, material], top="trim",
                        bottom=material)

    def basin(self, along0, along1, width, deep, shift=0.0, rim=1.2, floor="path"):
        """A trough for water: a floor at `deep` below the way, walls around it that end at the way's height."""
        self.island(along0 - 0.2, along1 + 0.2, width + 2 * rim + 0.4, shift, up=-deep, deep=5, chamfer=1.2, top=floor, trim="side")
        for edge in (-1, 1):
            self.block(along0, along1, rim, -deep, -0.025, shift=shift + edge * (width + rim) / 2)
        for a in (along0 + rim / 2, along1 - rim / 2):
            self.block(a - rim / 2 + 0.03, a + rim / 2 - 0.03, width + 0.2, -deep + 0.06, -0.05, shift=shift)

    def spikes(self, along0, along1, width, shift=0.0, up=0.0, tall=0.5):
        """A bed of spikes: deadly."""
        here = self.frame.moved((along0 + along1) / 2, shift, up)
        self.still.loft(here, rectangle(width, along1 - along0), [(0.1, 0.05), (0.05, 0), (-0.1, 0)], ["spike base"] * 2,
                        top="spikes")
        rows, columns = max(1, round((along1 - along0) / 0.6)), max(1, round(width / 0.6))
        for i in range(rows):
            for k in range(columns):
                a = along0 + (along1 - along0) * (i + 0.5) / rows
                x = shift + width * ((k + 0.5) / columns - 0.5)
                self.still.loft(self.frame.moved(a, x, up), ring(0.22, 4, 45), [(tall, 0.22), (0.1, 0)], ["spikes"])
