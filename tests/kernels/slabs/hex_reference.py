"""Slab transport on hexagons in plain Python: every cell is looked up by the place of its centre.

It works with distances on the plane alone: a slab lands in the cell whose centre is nearest, a neighbour is
the cell at one cell's distance. Nothing is taken from the kernel's tables.
"""

import math

from tests.kernels.slabs.slab_reference import CELL, SCALE, Field, high, low

ROW = math.sqrt(3.0) / 2
WAYS = [0, 60, 120, 180, 240, 300]


class HexField(Field):
    """A bed of hexagons. Steps to neighbours are unit vectors (across, along)."""

    def centre(self, row, col):
        """Where a cell's centre lies (cells)."""
        return col + 0.5 * (row % 2), row * ROW

    def cell_at(self, x, y):
        """Row and column of the cell with its centre at (x, y)."""
        row = round(y / ROW)
        return row, round(x - 0.5 * (row % 2))

    def inside(self, row, col):
        """The cell brought back into the field, or None."""
        if not (self.wrap_across or 0 <= row < self.rows) or not (self.wrap_along or 0 <= col < self.cols):
            return None
        return row % self.rows, col % self.cols

    # --- neighbours --------------------------------------------------------------------------------

    def neighbour(self, row, col, step):
        if step is None:
            return None
        x, y = self.centre(row, col)
        return self.inside(*self.cell_at(x + step[1], y + step[0]))

    def neighbour_groups(self):
        return [[unit(way) for way in WAYS]]

    def steps_about(self):
        return [unit(way) if way is not None else None for way in (0, None, 180, None, 60, 120, 240, 300)]

    def sequences(self):
        allowed = self.order(True)
        if self.rules.neighbour_order != "random":
            return [allowed]
        orders = []
        for start in range(12):
            turned = [60 * (start + (k if start < 6 else -k)) % 360 for k in range(6)]
            orders.append([unit(way) for way in turned if unit(way) in allowed])
        return orders

    # --- the shadow zone ---------------------------------------------------------------------------

    def in_shadow(self, row, col, place=None):
        if self.rules.shadow_from == "place":
            return self.in_shadow_of_prisms(row, col, *place)
        fall = math.tan(math.radians(self.rules.shadow_angle)) / self.aspect
        start = 0.5 if self.rules.shadow_from == "edge" else 0.0
        here = self.height(row, col)
        wind = (math.sin(self.angle), math.cos(self.angle))
        across = max((120, 60, 0), key=lambda way: round(abs(self.sine(way, wind)), 9))
        spacing = ROW / abs(self.sine(across, wind))
        length = self.cols / wind[1]
        if abs(self.angle) > math.pi / 4:
            length = self.rows * ROW / abs(wind[0])
        for k in range(1, math.ceil(length / spacing - 1e-9) + 1):
            height = self.height_on_line(row, col, k, spacing, across, wind)
            if height is None:
                return False
            if height - here > (k * spacing - start) * fall * SCALE:
                return True
        return False

    def sine(self, way, wind):
        """Sine of the angle from the wind to a line of cells."""
        step = unit(way)
        return wind[1] * step[0] - wind[0] * step[1]

    def height_on_line(self, row, col, k, spacing, across, wind):
        """Height where the ray crosses the ``k``-th line of cells upwind, between two cells of it."""
        x0, y0 = self.centre(row, col)
        x, y = x0 - k * spacing * wind[1], y0 - k * spacing * wind[0]
        step = unit(across)
        upwind = -1 if self.sine(across, wind) > 0 else 1
        on_line = (x0 + upwind * k * ROW * step[0], y0 - upwind * k * ROW * step[1])
        # the line's cells lie one cell apart; one of them, found by trial, counts them off
        base = next(
            (on_line[0] + t / 2 * step[1], on_line[1] + t / 2 * step[0])
            for t in (0, 1)
            if self.is_centre(on_line[0] + t / 2 * step[1], on_line[1] + t / 2 * step[0])
        )
        along = (x - base[0]) * step[1] + (y - base[1]) * step[0]
        lower = math.floor(along + 1e-9)
        weight = along - lower if along - lower >= 1e-9 else 0.0
        seen = self.height if self.sees(row, (y - y0) / ROW) else self.height_before
        heights = []
        for number in (lower, lower + 1)[: 2 if weight else 1]:
            cell = self.inside(*self.cell_at(base[0] + number * step[1], base[1] + number * step[0]))
            if cell is None:
                return None
            heights.append(float(seen(*cell)))
        return heights[0] + weight * (heights[1] - heights[0]) if weight else heights[0]

    def in_shadow_of_prisms(self, row, col, x, y):
        """Walk upwind from a place, and go on to the neighbour that is the first to be as near as the cell.

        The line leaves a hexagon where it comes to the bisector between its centre and a neighbour's.
        """
        fall = math.tan(math.radians(self.rules.shadow_angle)) / self.aspect * SCALE
        middle, centre = self.middle(row, col), self.centre(row, col)
        start = centre[0] + (x - middle[0]) / CELL, centre[1] + (y - middle[1]) / CELL / ROW
        upwind = -math.cos(self.angle), -math.sin(self.angle)
        here, rise = self.height(row, col), self.rise_of_prism(row, col, row, start)
        highest = max(map(max, self.heights())) + 2 * self.face_limit * SCALE
        r, c = row, col
        while True:
            distance, (r, c) = min(self.ways_out(start, upwind, r, c))
            if distance * fall >= highest - here or self.inside(r, c) is None:
                return False
            seen = self.height if self.sees(row, r - row) else self.height_before
            height = seen(*self.inside(r, c)) + self.rise_of_prism(r, c, row, start)
            if height - here - rise > distance * fall:
                return True

    def rise_of_prism(self, row, col, start_row, start):
        """How much higher a prism is under the line through a point than in its middle."""
        if self.rules.stack_tops == "level" or self.angle == 0.0:
            return 0.0
        left = -math.sin(self.angle), math.cos(self.angle)
        x, y = self.centre(row, col)
        aside = (start[0] - x) * left[0] + (start[1] - y) * left[1]
        return self.slope_to(left, (row, col), start_row, map(unit, WAYS), 3) * aside

    def ways_out(self, start, upwind, row, col):
        """Distances along the line to the bisectors with the neighbours that it nears, and those cells."""
        x, y = self.centre(row, col)
        for step in map(unit, WAYS):
            nearing = upwind[0] * step[1] + upwind[1] * step[0]
            if nearing > 1e-9:
                to_face = (x + step[1] / 2 - start[0]) * step[1] + (y + step[0] / 2 - start[1]) * step[0]
                yield to_face / nearing, self.cell_at(x + step[1], y + step[0])

    def is_centre(self, x, y):
        cx, cy = self.centre(*self.cell_at(x, y))
        return math.hypot(cx - x, cy - y) < 1e-6

    # --- flight: places are exact, in 1/CELL of a cell's width and of its height from corner to corner ---

    def middle(self, row, col):
        return col * CELL + (CELL // 2 if row % 2 else 0) + CELL // 2, row * (3 * CELL // 4) + CELL // 2

    def nearest(self, x, y):
        """Row and column of the cell whose centre is nearest; a height is 2/sqrt(3) widths."""
        low_row, low_col = y // (3 * CELL // 4), x // CELL
        near = [(r, c) for r in range(low_row - 2, low_row + 3) for c in range(low_col - 2, low_col + 3)]

        def far(cell):
            mx, my = self.middle(*cell)
            return 3 * (x - mx) ** 2 + 4 * (y - my) ** 2, -cell[0], -cell[1]

        return min(near, key=far)

    def cell(self, x, y):
        return self.nearest(x, y)

    def place_after(self, x, y):
        row, col = self.nearest(x, y)
        inside = self.inside(row, col)
        if inside is None:
            return None, None
        was, now = self.middle(row, col), self.middle(*inside)
        return x + now[0] - was[0], y + now[1] - was[1]

    def take_off(self, row, col, hop, draws):
        dx, dy = self.fixed(hop)
        x, y = self.middle(row, col)
        if self.rules.shadow_from == "place":
            x, y = self.start
        elif dx % CELL or dy % CELL or (self.extra.hop is not None and not self.extra.hop.whole):
            x, y = self.place_in(row, col, draws.next())
        return x, y, dx, dy, 0, draws

    def place_in(self, row, col, draw):
        x, y = self.middle(row, col)
        px, py = high(draw), low(draw) * 3 // 4
        mx, my = self.middle(*self.nearest(px, py))
        return x + px - mx, y + py - my

    def hops_far(self, x, y, dx, dy):
        if self.near is None:
            return False
        row, there = self.nearest(x, y)[0], self.nearest(x + dx, y + dy)[0]
        return not 0 <= self.place_among_near(row) + there - row < len(self.near)

    def fixed(self, hop):
        heights = math.sin(self.angle) * ROW
        return round(hop * (math.cos(self.angle) * CELL)), round(hop * (heights * CELL))


def unit(way):
    """The step (across, along) of one cell in a direction (degrees anticlockwise from along)."""
    return round(math.sin(math.radians(way)), 12), round(math.cos(math.radians(way)), 12)
