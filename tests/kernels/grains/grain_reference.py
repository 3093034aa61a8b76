"""Grains in flight the slow and obvious way: one grain after the other, in plain Python.

Numbers are 32-bit where the kernels' are, so that both give the same bits.
"""

import math

import numpy as np

from barchan.directions import downwind
from barchan.grains.rules import entrainment_of
from barchan.streams import GOLDEN, MASK, derive, mix

F = np.float32


def draw(start, number):
    return (mix((start + GOLDEN * number) & MASK) >> 11) * 2.0**-53


def bits(number):
    return int(F(number).view(np.int32))


def look_up(table, number):
    return table.values[min(max((bits(number) - int(table.first)) >> 17, 0), table.values.size - 1)]


class Grain:
    flies = False


class ReferenceFlight:
    """A bed and its grains, one iteration at a time, for the published rules.

    ``stream`` are the slope of the wind over each mesh cell and, where given, speed-up and part to the left.
    """

    def __init__(self, model, bed, wind, stream=None):
        self.stream = stream
        self.model, self.rules, self.bed, self.wind = model, model.parameters, bed, wind
        self.closures = {one.key: one for one in self.rules.closures()}
        ground = model.ground_of(bed, wind.direction)
        self.air = model.blow(ground, wind)
        self.friction = self.rules.friction_velocity(model.speed(wind))
        self.lift_off = entrainment_of(model.setting(wind))
        self.grains = [Grain() for _ in range(model.pool.size)]
        self.left = self.moved = self.capped = 0
        self.travel = [0, 0]

    @property
    def canopy(self):
        return self.closures["canopy"]

    def height(self, row, col):
        part = self.bed.lattice.thickness / 2**20
        ground = self.bed.ground - self.bed.ground.min()
        level = int(np.rint(ground[row, col] / self.bed.lattice.thickness * 2**20)) + (
            int(self.bed.sand[row, col]) << 20
        )
        return F(level * part)

    def corners(self, x, y):
        """Rows and columns of the stacks about a place, and the place between them."""
        (rows, cols), (joined_y, joined_x) = self.bed.lattice.shape, self.bed.lattice.periodic
        row, col = int(y), int(x)
        north = (row + 1) % rows if joined_y else min(row + 1, rows - 1)
        east = (col + 1) % cols if joined_x else min(col + 1, cols - 1)
        return row, north, col, east, float(x) - col, float(y) - row

    def surface(self, x, y):
        """Height and slopes of the interpolated surface."""
        row, north, col, east, part_x, part_y = self.corners(x, y)
        sw, se, nw, ne = (float(self.height(r, c)) for r in (row, north) for c in (col, east))
        low, high = sw + part_x * (se - sw), nw + part_x * (ne - nw)
        size = self.bed.lattice.cell_size
        slope_x = ((se - sw) * (1.0 - part_y) + (ne - nw) * part_y) / size
        return low + part_y * (high - low), slope_x, (high - low) / size

    def nearest(self, x, y):
        row, north, col, east, part_x, part_y = self.corners(x, y)
        return (north if F(part_y) >= 0.5 else row), (east if F(part_x) >= 0.5 else col)

    def base(self, x, y):
        row, north, col, east, _, _ = self.corners(x, y)
        sw, se, nw, ne = (self.height(r, c) for r in (row, north) for c in (col, east))
        mean = F(0.25) * ((sw + se) + (nw + ne))
        if not self.canopy.stands:
            return mean
        return mean + F(max(self.canopy.displacement * self.plants(x, y) - self.rules.displacement, 0.0))

    def plants(self, x, y):
        """Height of the plants about a place."""
        row, north, col, east, _, _ = self.corners(x, y)
        height = self.bed.arrays["plant_height"]
        return 0.25 * ((height[row, col] + height[north, col]) + (height[row, east] + height[north, east]))

    def taken(self, x, y):
        """Wind speed that these take."""
        if not self.canopy.stands:
            return F(0.0)
        ratio = max(self.canopy.roughness * self.plants(x, y) / self.rules.roughness_length, 1.0)
        return F(self.friction / 0.4 * np.log(ratio))

    def fly(self, grain):
        air = self.air
        height = grain.z + air.rise_before * grain.w - self.base(grain.x, grain.y)
        wind = look_up(air.wind, height)
        wind -= min(self.taken(grain.x, grain.y), max(wind, F(0.0)))
        climb = turn = F(0.0)
        if self.stream is not None:
            rise, *speed = (part[int(grain.y), int(grain.x)] for part in self.stream)
            if speed:
                wind = wind * speed[0]
                turn = speed[1] * wind
            climb = rise * wind
        grain.u, grain.v = grain.u + air.wind_y * turn, grain.v - air.wind_x * turn
        grain.w -= climb
        lag_x, lag_y = wind * air.wind_x - grain.u, wind * air.wind_y - grain.v
        share = look_up(
            air.drag, lag_x * lag_x + lag_y * lag_y + (grain.w - air.early_fall) * (grain.w - air.early_fall)
        )
        u = grain.u + share * lag_x
        v = grain.v + share * lag_y
        w = grain.w - share * (grain.w - air.early_fall) - air.fall
        grain.x += air.before * grain.u + air.after * u
        grain.y += air.before * grain.v + air.after * v
        grain.z += air.rise_before * grain.w + air.rise_after * w
        length, time = air.before + air.after, air.rise_before + air.rise_after
        grain.x += -length * air.wind_y * turn
        grain.y += length * air.wind_x * turn
        grain.z += time * climb
        grain.u, grain.v, grain.w = u - air.wind_y * turn, v + air.wind_x * turn, w + climb

    def over_edges(self, grain):
        (rows, cols), (joined_y, joined_x) = self.bed.lattice.shape, self.bed.lattice.periodic
        for axis, size, joined in ((0, cols, joined_x), (1, rows, joined_y)):
            place = (grain.x, grain.y)[axis]
            if 0 <= place < size:
                continue
            if not joined:
                return False
            if place < 0:
                place += F(size)
                grain.laps[axis] -= 1
            if place >= size:
                place -= F(size)
                grain.laps[axis] += 1
            grain.x, grain.y = (place, grain.y) if axis == 0 else (grain.x, place)
        return True

    def bounce(self, grain):
        """Whether the grain flies on."""
        surface, east, north = self.surface(grain.x, grain.y)
        normal = np.array([-east, -north, 1.0]) / math.sqrt(1.0 + east * east + north * north)
        velocity = np.array([float(grain.u), float(grain.v), float(grain.w)])
        into = velocity[0] * normal[0] + velocity[1] * normal[1] + velocity[2] * normal[2]
        out = self.closures["bounce"].normal_damping * abs(into)
        velocity = self.closures["bounce"].tangential_damping * (velocity - into * normal) + out * normal
        grain.z = F(surface)
        squared = velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2]
        if squared < self.closures["bounce"].stop_speed ** 2 or grain.bounces >= self.rules.max_bounces:
            return False
        grain.bounces += 1
        grain.u, grain.v, grain.w = (F(part) for part in velocity)
        return True

    def lift(self, grain, start):
        """The cell that gives a parcel, if one does."""
        rows, cols = self.bed.lattice.shape
        if draw(start, 1) >= self.lift_off.probability:
            return None
        x, y = F(draw(start, 2) * cols), F(draw(start, 3) * rows)
        row, col = self.nearest(x, y)
        if self.bed.sand[row, col] == 0:
            return None
        wind = downwind(self.wind.direction)
        surface, east, north = self.surface(x, y)
        if not self.lift_off.from_lee and east * wind[0] + north * wind[1] < 0.0:
            return None
        rule = self.lift_off
        angle = rule.min_angle + draw(start, 4) * (rule.max_angle - rule.min_angle)
        up = rule.min_speed + draw(start, 5) * (rule.max_speed - rule.min_speed)
        along = up / math.tan(angle)
        grain.flies, grain.bounces, grain.laps = True, 0, [0, 0]
        grain.x, grain.y, grain.z = x, y, F(surface)
        grain.u, grain.v, grain.w = F(along * wind[0]), F(along * wind[1]), F(up)
        grain.start = x, y
        return row, col

    def iterate(self, key):
        """All grains fly and land on the bed as it is, then the bed changes, in the order of grains."""
        changes = []
        for slot, grain in enumerate(self.grains):
            rest = None
            if grain.flies:
                self.fly(grain)
                inside = self.over_edges(grain)
                if inside and grain.z >= self.surface(grain.x, grain.y)[0]:
                    continue
                if inside and self.bounce(grain):
                    continue
                rest = self.nearest(grain.x, grain.y) if inside else "out"
                self.book(grain, inside)
                grain.flies = False
            changes.append((grain, rest, self.lift(grain, derive(key, slot))))
        for grain, rest, source in changes:
            if rest == "out":
                self.left += self.rules.carried
            elif rest:
                self.lay_down(*rest)
            if source and self.take_up(*source):
                self.moved += self.rules.carried
            elif source:
                grain.flies = False

    def patch(self, row, col):
        """The stacks about one that a grain's sand may lie on beside it, and how many parcels each."""
        (rows, cols), (joined_y, joined_x) = self.bed.lattice.shape, self.bed.lattice.periodic
        for r in (row - 1, row, row + 1):
            for c in (col - 1, col, col + 1):
                inside = (joined_y or 0 <= r < rows) and (joined_x or 0 <= c < cols)
                if inside and (r, c) != (row, col):
                    yield (r % rows, c % cols), (2 if r == row or c == col else 1)

    def lay_down(self, row, col):
        rest = self.rules.carried
        for cell, parcels in self.patch(row, col) if rest > 1 else ():
            self.bed.sand[cell] += parcels
            rest -= parcels
        self.bed.sand[row, col] += rest

    def take_up(self, row, col):
        """Whether the sand of a grain was there and was taken."""
        rest, taken = self.rules.carried, []
        for cell, parcels in self.patch(row, col) if rest > 1 else ():
            taken.append((cell, min(parcels, self.bed.sand[cell])))
            rest -= taken[-1][1]
        if self.bed.sand[row, col] < rest:
            return False
        for cell, parcels in [*taken, ((row, col), rest)]:
            self.bed.sand[cell] -= parcels
        return True

    def book(self, grain, inside):
        self.capped += bool(inside and grain.bounces >= self.rules.max_bounces) * self.rules.carried
        for axis, (there, start) in enumerate(zip((grain.x, grain.y), grain.start, strict=True)):
            size = self.bed.lattice.shape[1 - axis]
            way = (float(there) - float(start) + grain.laps[axis] * size) * 2**16
            self.travel[axis] += int(np.rint(way)) * self.rules.carried


EIGHT = [(0, 1), (1, 0), (0, -1), (-1, 0), (1, 1), (1, -1), (-1, -1), (-1, 1)]
"""Steps (row, column) to the neighbours, in the order in which sand is exchanged with them."""


def smooth(level, sand, rule, parcel, joined):
    """Wang & Hu's filter on a field of levels (parts) and of sand, both changed in place; parcels moved.

    Beyond an open edge the bed goes on as it is at the edge, but exchanges no sand.
    """
    before = level.astype(object)
    (rows, cols), (joined_y, joined_x) = before.shape, joined
    face, corner = (2 - math.sqrt(2)) / 4, (math.sqrt(2) - 1) / 4

    def beside(row, col, step):
        r, c = row + step[0], col + step[1]
        r = r % rows if joined_y else min(max(r, 0), rows - 1)
        return r, c % cols if joined_x else min(max(c, 0), cols - 1)

    def is_sharp(cell):
        sums = [sum(before[beside(*cell, step)] for step in steps) for steps in (EIGHT[:4], EIGHT[4:])]
        return abs(face * float(sums[0]) + corner * float(sums[1]) - float(before[cell])) >= rule.least

    sharp = [cell for cell in np.ndindex(rows, cols) if is_sharp(cell)]
    places, moved = set(sharp), 0
    for cell in sharp:
        for number, step in enumerate(EIGHT):
            other = beside(*cell, step)
            beyond = any(
                abs(other[axis] - cell[axis]) != abs(step[axis]) for axis in (0, 1) if not joined[axis]
            )
            if beyond or (other in places and other <= cell):
                continue
            weight = face if number < 4 else corner
            parcels = int(rule.gain * weight * float(before[other] - before[cell]) / parcel)
            parcels = min(max(parcels, -int(sand[cell])), int(sand[other]))
            for place, gain in ((cell, parcels), (other, -parcels)):
                sand[place] += gain
                level[place] += gain * parcel
            moved += abs(parcels)
    return moved
