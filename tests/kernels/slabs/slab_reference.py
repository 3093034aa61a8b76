"""Slab transport in plain Python: slow, and meant to be obviously right.

It shares nothing with the compiled kernels but the definition of the random numbers. It works in the wind's
frame: column + 1 is downwind (within 45 degrees), rows grow to the wind's left. What differs on a lattice of
hexagons is in ``hex_reference``.
"""

import math
from dataclasses import dataclass, field

from barchan.slabs.rules import Rules
from barchan.streams import GOLDEN, MASK, derive, mix

FACES = [(0, 1), (1, 0), (0, -1), (-1, 0)]
CORNERS = [(1, 1), (1, -1), (-1, -1), (-1, 1)]
CELL = 1 << 32
SCALE = 1 << 20
FORCED_TRIES = 1000


@dataclass
class Draws:
    """The random sequence of one poll."""

    state: int

    def next(self) -> int:
        self.state = (self.state + GOLDEN) & MASK
        return mix(self.state)


def high(draw):
    return draw >> 32


def low(draw):
    return draw & 0xFFFFFFFF


def below(half, count):
    return half * count >> 32


def shuffled(count, key):
    items = list(range(count))
    for last in range(count - 1, 0, -1):
        other = below(high(derive(key, last)), last + 1)
        items[last], items[other] = items[other], items[last]
    return items


@dataclass
class Field:
    """A bed in the wind's frame and the rules of its transport."""

    sand: list[list[int]]
    ground: list[list[float]]  # in slabs
    rules: object  # SlabParameters
    aspect: float
    face_limit: int
    corner_limit: int
    hop: float
    angle: float = 0.0
    wrap_along: bool = True
    wrap_across: bool = True
    extra: Rules = field(default_factory=Rules)
    mobile: list[list[int]] | None = None  # in units of 1/SCALE
    stabilised_limits: tuple[int, int] = (0, 0)
    release_limits: tuple[int, int] | None = None
    tally: dict = field(
        default_factory=lambda: dict.fromkeys(("moved", "left", "capped", "exhausted", "x", "y"), 0)
    )

    @property
    def rows(self):
        return len(self.sand)

    @property
    def cols(self):
        return len(self.sand[0])

    def __post_init__(self):
        base = [[round(g * SCALE) for g in row] for row in self.ground]
        lowest = min(map(min, base))
        self.base = [[g - lowest for g in row] for row in base]
        self.near = None
        self.aside = []
        self.start = None
        self.begin()

    def height(self, row, col):
        """Height of the surface in units of 1/SCALE slabs."""
        return self.base[row][col] + self.sand[row][col] * SCALE

    def neighbour(self, row, col, step):
        r, c = row + step[0], col + step[1]
        if not 0 <= r < self.rows:
            if not self.wrap_across:
                return None
            r %= self.rows
        if not 0 <= c < self.cols:
            if not self.wrap_along:
                return None
            c %= self.cols
        return r, c

    # --- the shadow zone ---------------------------------------------------------------------------

    def in_shadow(self, row, col, place=None):
        """Whether a cell lies in shadow, or a place (fixed-point cells, x and y) in it."""
        if self.rules.shadow_from == "place":
            return self.in_shadow_of_boxes(row, col, *place)
        fall = math.tan(math.radians(self.rules.shadow_angle)) / self.aspect
        start = 0.5 if self.rules.shadow_from == "edge" else 0.0
        here = self.height(row, col)
        for k in range(1, self.cols + 1):
            c = col - k
            if c < 0 and not self.wrap_along:
                return False
            height = self.height_at(row, k, c % self.cols)
            if height is None:
                return False
            distance = k / math.cos(self.angle) - start
            if height - here > distance * fall * SCALE:
                return True
        return False

    def in_shadow_of_boxes(self, row, col, x, y):
        """Walk upwind from a place, edge by edge, and look at the box behind each edge."""
        fall = math.tan(math.radians(self.rules.shadow_angle)) / self.aspect * SCALE
        column_fall = fall / math.cos(self.angle)
        row_fall = fall / abs(math.sin(self.angle)) if self.angle else 1e300
        upwind = 1 if self.angle < 0.0 else -1
        to_column = x % CELL / CELL * column_fall
        to_row = (y % CELL if upwind < 0 else CELL - y % CELL) / CELL * row_fall
        here, start = self.height(row, col), self.rise_of_top(row, col, row, col, x, y)
        highest = max(map(max, self.heights())) + 2 * self.face_limit * SCALE
        r, c = row, col
        while min(to_column, to_row) < highest - here:
            if to_column <= to_row:
                edge, to_column, c = to_column, to_column + column_fall, c - 1
            else:
                edge, to_row, r = to_row, to_row + row_fall, r + upwind
            if (c < 0 and not self.wrap_along) or (not 0 <= r < self.rows and not self.wrap_across):
                return False
            seen = self.height if self.sees(row, r - row) else self.height_before
            height = seen(r % self.rows, c % self.cols)
            if height - here - start + self.rise_of_top(r, c, row, col, x, y) > edge:
                return True
        return False

    def rise_of_top(self, r, c, row, col, x, y):
        """How much higher a box is under the line from a place in (row, col) than in its middle."""
        if self.rules.stack_tops == "level" or self.angle == 0.0:
            return 0.0
        left = -math.sin(self.angle), math.cos(self.angle)
        in_col, in_row = x % CELL / CELL - 0.5, y % CELL / CELL - 0.5
        aside = (in_col + col - c) * left[0] + (in_row + row - r) * left[1]
        return self.slope_to(left, (r, c), row, FACES, 2) * aside

    def slope_to(self, left, cell, start_row, steps, weight):
        """Slope of the surface to the wind's left, by a cell's neighbours, within the repose limit.

        The cell may lie beyond a joined edge. Which rows are seen as they are now is counted from the row in
        which the line starts.
        """
        slope = 0.0
        row, col = cell[0] % self.rows, cell[1] % self.cols
        for step in steps:
            beside = self.neighbour(row, col, step)
            rows = 0 if beside is None else round(step[0])
            seen = self.height if self.sees(start_row, cell[0] - start_row + rows) else self.height_before
            beside = beside or (row, col)
            slope += seen(*beside) * (step[1] * left[0] + step[0] * left[1]) / weight
        limit = self.face_limit * SCALE
        return max(-limit, min(limit, slope))

    def heights(self):
        """Height of the surface, row by row; what was there when the round began counts too."""
        now = [[self.height(row, col) for col in range(self.cols)] for row in range(self.rows)]
        return now + self.before

    def height_at(self, row, k, col):
        """Height where the ray crosses a column ``k`` upwind, interpolated between two cells."""
        if self.angle == 0.0:
            return self.height(row, col)
        offset = -k * math.tan(self.angle)
        lower = math.floor(offset + 1e-9)
        weight = max(offset - lower, 0.0)
        heights = []
        seen = self.height if self.sees(row, offset) else self.height_before
        for r in (row + lower, row + lower + 1):
            if 0 <= r < self.rows or self.wrap_across:
                heights.append(float(seen(r % self.rows, col)))
            elif weight > 0.0 or r == row + lower:
                return None
            else:
                heights.append(0.0)
        return heights[0] + weight * (heights[1] - heights[0]) if weight > 0.0 else heights[0]

    # --- avalanches --------------------------------------------------------------------------------

    def neighbour_groups(self):
        """Steps to the neighbours; those of the first group come first."""
        return [FACES, CORNERS if self.rules.neighbourhood == "moore" else []]

    def steps_about(self):
        """Steps to all cells that an avalanche may upset, in the order in which they are asked."""
        return FACES + CORNERS

    def order(self, sliding, draws=None):
        """Neighbours in the order in which they are checked."""
        wind = (math.sin(self.angle), math.cos(self.angle))
        left = (math.cos(self.angle), -math.sin(self.angle))
        sign = 1 if sliding else -1

        def dot(a, b):
            return round(a[0] * b[0] + a[1] * b[1], 9)

        groups = self.neighbour_groups()
        result = []
        for at, group in enumerate(groups):
            if draws is None:
                ways = sorted(group, key=lambda s: (-sign * dot(s, wind), -dot(s, left)))
            else:
                ways = drawn_order(group, draws, 4 * at)
            if not self.rules.upwind_avalanches:
                ways = [s for s in ways if sign * dot(s, wind) > -1e-9]
            result += ways
        return result

    def is_stabilised(self, row, col):
        threshold = round(self.extra.stabilised_mobility * SCALE)
        return self.mobile is not None and self.mobile[row][col] <= threshold

    def limit(self, row, col, corner, at_rest=False):
        """The step down from a cell that still holds, in units of 1/SCALE slabs."""
        limit = (self.face_limit, self.corner_limit)[corner]
        if self.is_stabilised(row, col):
            limit = self.stabilised_limits[corner]
        if at_rest and self.release_limits is not None:
            limit += self.release_limits[corner] - (self.face_limit, self.corner_limit)[corner]
        return limit * SCALE

    def steepest(self, row, col, here, sliding, order, at_rest=False):
        """The first of the steepest ways whose step does not hold."""
        best, way = 0.0, None
        for step in order:
            there = self.neighbour(row, col, step)
            if there is None or (not sliding and self.sand[there[0]][there[1]] == 0):
                continue
            rise = (here - self.height(*there)) if sliding else (self.height(*there) - here)
            corner = step in CORNERS
            higher = (row, col) if sliding else there
            weight = math.sqrt(0.5) if corner and self.rules.corner_limit != "face" else 1.0
            if rise > self.limit(*higher, corner, at_rest) and rise * weight > best:
                best, way = rise * weight, there
        return way

    def chain(self, row, col, sliding, draws):
        """Follow an avalanche from a cell to the one that changes."""
        while True:
            here = self.height(row, col) + (SCALE if sliding else -SCALE)
            way = self.steepest(row, col, here, sliding, self.order(sliding))
            if way is None:
                return row, col
            if self.rules.neighbour_order == "downslope":
                way = self.drawn(row, col, here, sliding, draws.next())
            if self.rules.neighbour_order == "random":
                way = self.steepest(row, col, here, sliding, self.order(sliding, draws.next()))
            row, col = way

    def drawn(self, row, col, here, sliding, draw):
        """A neighbour drawn in proportion to its step beyond one slab, of all that slabs may slide to."""
        shares = []
        for step in self.steps_about():
            there = None if step is None else self.neighbour(row, col, step)
            if step not in self.order(sliding) or there is None:
                continue
            rise = (here - self.height(*there)) if sliding else (self.height(*there) - here)
            corner = step in CORNERS
            if not sliding and self.sand[there[0]][there[1]] == 0:
                continue
            if not sliding and self.is_stabilised(*there) and rise <= self.limit(*there, corner):
                continue
            weight = math.sqrt(0.5) if corner and self.rules.corner_limit != "face" else 1.0
            if rise > SCALE:
                shares.append((there, float(rise - SCALE) * weight))
        left = high(draw) / 2**32 * sum(share for _, share in shares)
        for there, share in shares:
            left -= share
            if left < 0:
                return there
        return shares[-1][0]

    def slide(self, row, col, risen, key):
        """Let sand slide where a cell's change took a slope over the release, until all of it rests."""
        here = self.height(row, col)
        if self.steepest(row, col, here, risen, self.order(risen), at_rest=True) is None:
            return
        queue, waiting = [], {}

        def upset(cell, moving):
            if cell not in waiting:
                queue.append(cell)
            waiting[cell] = moving or waiting.get(cell, False)

        def upset_about(cell, first):
            for k in range(8):
                upset(self.neighbour(*cell, self.steps_about()[(first + k) % 8]) or cell, False)

        upset((row, col), False)
        upset_about((row, col), 0)
        orders = self.sequences()
        moves = 0
        while queue:
            cell = queue.pop(0)
            moving = waiting.pop(cell)
            if self.sand[cell[0]][cell[1]] == 0:
                continue
            draw = mix((key + moves) & MASK)
            turn = draw % len(orders)
            way = self.steepest(*cell, self.height(*cell), True, orders[turn], not moving)
            if way is None:
                continue
            if self.rules.neighbour_order == "downslope":
                way = self.drawn(*cell, self.height(*cell), True, mix(draw))
            self.change(*cell, -1)
            self.change(*way, 1)
            moves += 1
            upset(way, True)
            upset_about(cell, turn)
            upset(cell, True)

    def sequences(self):
        """The orders in which an avalanche that runs until all holds may check neighbours."""
        allowed = self.order(True)
        if self.rules.neighbour_order != "random":
            return [allowed]
        orders = []
        for start in range(8):
            ways = [(start + place * (1 if start < 4 else -1)) % 4 for place in range(4)]
            order = [FACES[way] for way in ways] + [CORNERS[way] for way in ways]
            orders.append([step for step in order if step in allowed])
        return orders

    def change(self, row, col, count):
        self.sand[row][col] += count

    # --- one poll ----------------------------------------------------------------------------------

    def gives(self, row, col, draws):
        if self.rules.shadow_from == "place":
            self.start = self.place_in(row, col, draws.next())
        chance = high(draws.next()) if self.mobile is not None else 0
        if self.sand[row][col] == 0:
            return False
        if self.mobile is not None:
            erosion = self.extra.erosion
            share, shift = round(erosion.factor * 2**32), round(erosion.offset * 2**32)
            if chance >= self.mobile[row][col] * share // SCALE + shift:
                return False
        if self.extra.hop is not None and self.hop_from(row, col) == 0:
            return False
        return self.rules.lee_erosion or not self.in_shadow(row, col, self.start)

    def begin(self):
        """Look at the surface, as at the beginning of each round."""
        self.before = [[self.height(row, col) for col in range(self.cols)] for row in range(self.rows)]
        heights = [height for row in self.before for height in row]
        self.mean = sum(heights) // len(heights)
        self.deviation = sum(abs(height - self.mean) for height in heights)

    def hop_from(self, row, col):
        """Hop (cells) from a cell, by its height over a reference taken when the round began."""
        rule = self.extra.hop
        if rule is None:
            return self.hop
        share = 0.5 / (self.rows * self.cols) if rule.follows_relief else 0.0
        reference = float(self.mean) - share * float(self.deviation)
        rise = self.height(row, col) / SCALE - reference / SCALE
        hop = self.hop + rule.linear * rise
        if rise > 0:
            hop += rule.quadratic * rise * rise
        hop = min(max(hop, -float(self.cols)), float(self.cols))
        return float(math.floor(hop + 0.5)) if rule.whole else hop

    def move(self, row, col, draws):
        hop = self.hop_from(row, col)
        self.tally["moved"] += 1
        if self.release_limits is None:
            self.change(*self.chain(row, col, False, draws), -1)
        else:
            self.change(row, col, -1)
            self.slide(row, col, False, draws.next())
        self.land(self.carry(*self.take_off(row, col, hop, draws)), draws)

    def land(self, landed, draws):
        """Lay a slab down where it landed (None: it left); one that is set aside lands later."""
        if landed == "aside":
            return
        if landed is None:
            self.tally["left"] += 1
        elif self.release_limits is None:
            self.change(*self.chain(*landed, True, draws), 1)
        else:
            self.change(*landed, 1)
            self.slide(*landed, True, draws.next())

    def take_off(self, row, col, hop, draws):
        dx, dy = self.fixed(hop)
        x, y = col * CELL, row * CELL
        if self.rules.shadow_from == "place":
            x, y = self.start
        elif dx % CELL or dy % CELL or (self.extra.hop is not None and not self.extra.hop.whole):
            draw = draws.next()
            x, y = x + high(draw), y + low(draw)
        return x, y, dx, dy, 0, draws

    def carry(self, x, y, dx, dy, hops, draws):
        while hops < self.rules.max_hops:
            if self.hops_far(x, y, dx, dy):
                self.aside.append((x, y, dx, dy, hops, draws))
                return "aside"
            hops += 1
            x, y, stopped = self.fly(x, y, dx, dy)
            if x is None:
                return None
            row, col = self.cell(x, y)
            chance = high(draws.next())
            if stopped or chance < self.chance_to_settle(row, col) or self.in_shadow(row, col, (x, y)):
                return row, col
            if self.extra.hop is not None and self.extra.hop.every_hop:
                hop = self.hop_from(row, col)
                if hop == 0:
                    return row, col
                dx, dy = self.fixed(hop)
        self.tally["capped"] += 1
        return row, col

    def place_among_near(self, row):
        return (row - self.near[0]) % self.rows

    def cell(self, x, y):
        """Row and column of the cell that a place lies in."""
        return y // CELL, x // CELL

    def hops_far(self, x, y, dx, dy):
        """Whether a hop leads out of the near rows."""
        if self.near is None:
            return False
        there = (self.place_among_near(y // CELL) * CELL + y % CELL + dy) // CELL
        return not 0 <= there < len(self.near)

    def sees(self, row, offset):
        """Whether a ray from a row meets only near rows as far as this offset."""
        if self.near is None:
            return True
        rows = math.ceil(abs(offset) - 1e-9)
        at = self.place_among_near(row)
        return 0 <= (at + rows if offset > 0.0 else at - rows) < len(self.near)

    def height_before(self, row, col):
        return self.before[row][col]

    def look_about(self, first_row, rows):
        """Take the rows of a band, and some on either side, for the near ones if the wind is oblique."""
        margin = (self.rules.band_rows - 1) // 4
        self.near = None
        if self.angle != 0.0 and rows + 2 * margin < self.rows and not self.rules.forced_erosion:
            self.near = [(first_row - margin + k) % self.rows for k in range(rows + 2 * margin)]

    def end_round(self):
        """Land the slabs that were set aside, in the order of their polls."""
        self.near = None
        late, self.aside = self.aside, []
        for flight in late:
            self.land(self.carry(*flight), flight[-1])

    def place_in(self, row, col, draw):
        """A place in a cell, drawn evenly."""
        return col * CELL + high(draw), row * CELL + low(draw)

    def fixed(self, hop):
        return round(hop * (math.cos(self.angle) * CELL)), round(hop * (math.sin(self.angle) * CELL))

    def chance_to_settle(self, row, col):
        settle = round((self.rules.p_s if self.sand[row][col] > 0 else self.rules.p_ns) * 2**32)
        if self.mobile is None:
            return settle
        return 2**32 - (2**32 - settle) * self.mobile[row][col] // SCALE

    def fly(self, x, y, dx, dy):
        """One hop: the new place (None: the slab left) and whether something stopped it on the way."""
        test = self.rules.path_test
        pieces = max(1, -(-max(abs(dx), abs(dy)) // CELL)) if test != "off" else 1
        here, flown = (x, y), (0, 0)
        for piece in range(1, pieces + 1):
            part = (dx, dy) if piece == pieces else (dx // pieces * piece, dy // pieces * piece)
            there = self.place_after(x + part[0], y + part[1])
            if None in there:
                if piece < pieces:  # over the edge and back, where the edge is not straight
                    continue
                self.travel(dx, dy)
                return None, None, False
            if test != "off" and self.blocked(here, there):
                self.travel(*flown)
                return *here, True
            here, flown = there, part
        self.travel(*flown)
        return *here, False

    def blocked(self, here, there):
        row, col = self.cell(*here)
        r, c = self.cell(*there)
        top = self.height(r, c) if self.rules.path_test == "surface" else self.base[r][c]
        limit = self.corner_limit if r != row and c != col else self.face_limit
        return (r, c) != (row, col) and top - self.height(row, col) > limit * SCALE

    def place_after(self, x, y):
        """A place brought back into the field, with None where it lies outside."""
        return self.place(x, self.cols, self.wrap_along), self.place(y, self.rows, self.wrap_across)

    def place(self, place, size, wrap):
        if 0 <= place < size * CELL:
            return place
        return place % (size * CELL) if wrap else None

    def travel(self, dx, dy):
        self.tally["x"] += dx >> 16
        self.tally["y"] += dy >> 16

    # --- the polls of a step -----------------------------------------------------------------------

    def bands(self, key):
        """First row and number of rows of each band, in their order."""
        size = self.rules.band_rows
        count = -(-self.rows // size)
        for band in shuffled(count, key):
            yield band, band * size, min(size, self.rows - band * size)

    def step(self, key, first, count):
        self.begin()
        if self.rules.polling == "repeated":
            self.at_random(key, first, count)
        elif self.rules.forced_erosion:
            self.each_once_forced(key, first, count)
        else:
            self.each_once(key, first, count)

    def at_random(self, key, first, count):
        poll_key, row_key = derive(key, 0), derive(key, 1)
        draws = [derive(row_key, first + pair) for pair in range((count + 1) // 2)]
        chosen = [below(half(draw), self.rows) for draw in draws for half in (high, low)][:count]
        poll = first
        for _, first_row, rows in self.bands(derive(key, 2)):
            self.look_about(first_row, rows)
            for _ in range(sum(first_row <= row < first_row + rows for row in chosen)):
                start = derive(poll_key, poll)
                draws = Draws(start)
                row, col = first_row + below(low(start), rows), below(high(start), self.cols)
                if not self.gives(row, col, draws):
                    forced = self.rules.forced_erosion
                    found = self.another(row, col, first_row, rows, draws) if forced else None
                    if found is None and forced:
                        self.tally["exhausted"] += 1
                        return
                    if found is not None:
                        self.move(*found, draws)
                else:
                    self.move(row, col, draws)
                poll += 1
        self.end_round()

    def another(self, row, col, first_row, rows, draws):
        for _ in range(FORCED_TRIES):
            draw = draws.next()
            row, col = first_row + below(low(draw), rows), below(high(draw), self.cols)
            if self.gives(row, col, draws):
                return row, col
        cell = row * self.cols + col
        for _ in range(self.rows * self.cols):
            cell = (cell + 1) % (self.rows * self.cols)
            if self.gives(cell // self.cols, cell % self.cols, draws):
                return cell // self.cols, cell % self.cols
        return None

    def round(self, poll_key, key, number, start, stop, target=None):
        cells = self.rows * self.cols
        for band, first_row, rows in self.bands(derive(key, 0)):
            size = rows * self.cols
            order = shuffled(size, derive(key, 1 + band))
            self.look_about(first_row, rows)
            for at in range(start * size // cells, stop * size // cells):
                row, col = first_row + order[at] // self.cols, order[at] % self.cols
                draws = Draws(derive(poll_key, number * cells + first_row * self.cols + at))
                if self.gives(row, col, draws):
                    self.move(row, col, draws)
                    if self.tally["moved"] == target:
                        return
        self.end_round()

    def each_once(self, key, first, count):
        cells = self.rows * self.cols
        for number in range(first // cells, (first + count - 1) // cells + 1):
            start, stop = max(first - number * cells, 0), min(first + count - number * cells, cells)
            self.begin()
            self.round(derive(key, 0), derive(derive(key, 3), number), number, start, stop)

    def each_once_forced(self, key, first, count):
        target = self.tally["moved"] + count
        slice_key = derive(derive(key, 4), first)
        number = 0
        while self.tally["moved"] < target:
            before = self.tally["moved"]
            self.round(slice_key, derive(slice_key, number), number, 0, self.rows * self.cols, target)
            if self.tally["moved"] == before:
                self.tally["exhausted"] += 1
                return
            number += 1


def drawn_order(group, draw, first):
    """A group of neighbours in a drawn sequence."""
    places = list(range(len(group)))
    for last in range(len(group) - 1, 0, -1):
        other = below(high(derive(draw, first + last)), last + 1)
        places[last], places[other] = places[other], places[last]
    return [step for _, step in sorted(zip(places, group, strict=False))]
