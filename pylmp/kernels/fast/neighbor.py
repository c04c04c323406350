"""The full neighbor list: atoms counted into cells, each cell compared with the cells around it.

Distances are compared in single precision with a margin, so that the list holds every pair within the cutoff and a few
beyond it; the force kernel asks again. A cell collects the atoms around it once, periodic images shifted, and then each of
its atoms is compared with sixteen of them at a time.
"""

from __future__ import annotations

from pylmp.kernels.fast import FAR, SPAN
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES, WIDE, compress, count_up, gather, load, splat_single, splat_whole, store
from pylmp.laws import select

# why a list was not made: room for candidates, for listed rows, for woven rows is too small, and the caller makes more; a row has too many.
# None is below 0.0, all is well: the sum over parts of a list says if all are.
ROOM, FULL, SHORT, MANY = 1.0, 2.0, 3.0, 4.0


def extents() -> Function:
    def extent(x: "f8*", scratch: "f8*", least: "f8*", most: "f8*", n: "i8") -> "f8":
        """least, most: (3,) lowest and highest coordinates, those that are not numbers left out. scratch: (48,)."""
        for d in range(3):
            least[d] = x[d]
            most[d] = x[d]
        whole = 3 * LANES * (n // LANES)
        if whole > 0:  # three vectors hold eight rows, each lane one coordinate
            a = load(x, 0, LANES)
            b = load(x, LANES, LANES)
            c = load(x, 2 * LANES, LANES)
            low_a = a
            low_b = b
            low_c = c
            for k in range(0, whole, 3 * LANES):
                next_a = load(x, k, LANES)
                next_b = load(x, k + LANES, LANES)
                next_c = load(x, k + 2 * LANES, LANES)
                a = select(next_a > a, next_a, a)
                b = select(next_b > b, next_b, b)
                c = select(next_c > c, next_c, c)
                low_a = select(next_a < low_a, next_a, low_a)
                low_b = select(next_b < low_b, next_b, low_b)
                low_c = select(next_c < low_c, next_c, low_c)
            store(scratch, 0, low_a)
            store(scratch, LANES, low_b)
            store(scratch, 2 * LANES, low_c)
            store(scratch, 3 * LANES, a)
            store(scratch, 4 * LANES, b)
            store(scratch, 5 * LANES, c)
            for k in range(3 * LANES):
                least[k % 3] = min(least[k % 3], scratch[k])
                most[k % 3] = max(most[k % 3], scratch[3 * LANES + k])
        for k in range(whole, 3 * n):
            least[k % 3] = min(least[k % 3], x[k])
            most[k % 3] = max(most[k % 3], x[k])
        return 0.0

    return extent


def sorting() -> Function:
    def into_cells(
        x: "f8*", corner: "f8*", inverse: "f8*", counts: "i8*", cell: "i4*", start: "i4*", order: "i4*",
        near_x: "f4*", near_y: "f4*", near_z: "f4*", n: "i8",
    ) -> "f8":
        """Count atoms into cells. start[c] .. start[c + 1]: places of cell c; order[p]: row at place p; near: its position from corner.

        start has room for the cells and two more. Returns 0.0, or -1.0 - row of an atom whose position is not a number.
        """
        cells = counts[0] * counts[1] * counts[2]
        for c in range(cells + 2):
            start[c] = 0
        for i in range(n):
            dx = x[3 * i] - corner[0]
            dy = x[3 * i + 1] - corner[1]
            dz = x[3 * i + 2] - corner[2]
            if not dx * dx + dy * dy + dz * dz < FAR * FAR:
                return -1.0 - i
            cx = min(max(int(dx * inverse[0]), 0), counts[0] - 1)
            cy = min(max(int(dy * inverse[1]), 0), counts[1] - 1)
            cz = min(max(int(dz * inverse[2]), 0), counts[2] - 1)
            c = (cz * counts[1] + cy) * counts[0] + cx
            cell[i] = c
            start[c + 2] += 1
        for c in range(cells):
            start[c + 2] += start[c + 1]
        for i in range(n):  # start[c + 1] walks from the first place of cell c to that of the next
            c = int(cell[i]) + 1
            p = start[c]
            start[c] = p + 1
            order[p] = i
            near_x[p] = x[3 * i] - corner[0]
            near_y[p] = x[3 * i + 1] - corner[1]
            near_z[p] = x[3 * i + 2] - corner[2]
        return 0.0

    return into_cells


def listing(periodic: tuple[bool, bool, bool], flat: bool, excluding: bool) -> Function:
    """flat: all atoms lie in one plane of cells. excluding: some pairs are left out."""
    px, py, pz = periodic
    layers = 0 if flat else 1

    def collect(
        x: "f4*", y: "f4*", z: "f4*", rows: "i4*", from_: int, to: int, near_x: "f4*", near_y: "f4*", near_z: "f4*", order: "i4*",
        m: int, sx: float, sy: float, sz: float,
    ) -> int:
        """Append places from_ to to, shifted, to the candidates; returns their number."""
        for p in range(from_, to, WIDE):
            store(x, m, load(near_x, p, WIDE) + splat_single(sx, WIDE))
            store(y, m, load(near_y, p, WIDE) + splat_single(sy, WIDE))
            store(z, m, load(near_z, p, WIDE) + splat_single(sz, WIDE))
            store(rows, m, load(order, p, WIDE))
            m += min(WIDE, to - p)
        return m

    def list_rows(
        start: "i4*", order: "i4*", near_x: "f4*", near_y: "f4*", near_z: "f4*", counts: "i8*", lengths: "f8*", limit2: "f8*",
        x: "f4*", y: "f4*", z: "f4*", rows: "i4*", room: "i8", left_first: "i8*", left_out: "i4*", stamp: "i4*",
        found: "i4*", edge: "u1*", at_first: "i4*", listed: "i4*", at: "i8", stop_listed: "i8", one: "i8", from_row: "i8", to_row: "i8",
        from_place: "i8", to_place: "i8",
    ) -> "f8":
        """Rows from_row to to_row, in the order of cells, of the cells that begin at places from_place to to_place. found[i]: how many neighbors row i
        has, listed[at_first[i] ...], from at to stop_listed for all: their rows. edge[i]: some may be periodic images in x (1), y (2), z (4).

        x, y, z, rows: room for candidates. left_out[left_first[i]:left_first[i + 1]]: rows that are no neighbors of row i; stamp: (rows,)
        of -1, scratch. Returns 0.0, ROOM, FULL, or MANY: a row has more than one.
        """
        reach2 = limit2[0]
        for cz in range(counts[2]):
            for cy in range(counts[1]):
                here = (cz * counts[1] + cy) * counts[0]
                if start[here] >= to_place or start[here + counts[0]] <= from_place:
                    continue
                for cx in range(counts[0]):
                    c = here + cx
                    begin = int(start[c])
                    end = int(start[c + 1])
                    if begin == end or begin < from_place or begin >= to_place:
                        continue
                    if order[begin] >= to_row or order[end - 1] < from_row:  # rows of a cell ascend
                        continue
                    m = 0
                    image = 0
                    for oz in range(-layers, layers + 1):
                        zz = cz + oz
                        sz = 0.0
                        if zz < 0 or zz >= counts[2]:
                            if not pz:
                                continue
                            sz = -lengths[2] if zz < 0 else lengths[2]
                            zz += counts[2] if zz < 0 else -counts[2]
                            image |= 4
                        for oy in range(-1, 2):
                            yy = cy + oy
                            sy = 0.0
                            if yy < 0 or yy >= counts[1]:
                                if not py:
                                    continue
                                sy = -lengths[1] if yy < 0 else lengths[1]
                                yy += counts[1] if yy < 0 else -counts[1]
                                image |= 2
                            row = (zz * counts[1] + yy) * counts[0]
                            first = int(start[row + max(cx - 1, 0)])
                            last = int(start[row + min(cx + 1, counts[0] - 1) + 1])
                            if m + last - first + 2 * WIDE > room:
                                return ROOM
                            m = collect(x, y, z, rows, first, last, near_x, near_y, near_z, order, m, 0.0, sy, sz)
                            if px and (cx == 0 or cx == counts[0] - 1):
                                image |= 1
                                if cx == 0:
                                    first = int(start[row + counts[0] - 1])
                                    last = int(start[row + counts[0]])
                                    if m + last - first + 2 * WIDE > room:
                                        return ROOM
                                    m = collect(x, y, z, rows, first, last, near_x, near_y, near_z, order, m, -lengths[0], sy, sz)
                                if cx == counts[0] - 1:
                                    first = int(start[row])
                                    last = int(start[row + 1])
                                    if m + last - first + 2 * WIDE > room:
                                        return ROOM
                                    m = collect(x, y, z, rows, first, last, near_x, near_y, near_z, order, m, lengths[0], sy, sz)
                    store(x, m, splat_single(FAR, WIDE))
                    store(rows, m, splat_whole(0, WIDE))
                    for p in range(begin, end):
                        i = int(order[p])
                        if i < from_row or i >= to_row:
                            continue
                        if at + m + WIDE > stop_listed:
                            return FULL
                        first = at
                        xi = splat_single(near_x[p], WIDE)
                        yi = splat_single(near_y[p], WIDE)
                        zi = splat_single(near_z[p], WIDE)
                        for k in range(0, m, WIDE):
                            dx = load(x, k, WIDE) - xi
                            dy = load(y, k, WIDE) - yi
                            dz = load(z, k, WIDE) - zi
                            j = load(rows, k, WIDE)
                            take = (dx * dx + dy * dy + dz * dz < reach2) & (j != i)
                            at += compress(listed, at, j, take)
                        if excluding and left_first[i] < left_first[i + 1]:
                            for q in range(left_first[i], left_first[i + 1]):
                                stamp[int(left_out[q])] = i
                            stop = at
                            at = first
                            for k in range(first, stop, WIDE):
                                valid = count_up(k, WIDE) < stop
                                j = select(valid, load(listed, k, WIDE), splat_whole(i, WIDE))
                                at += compress(listed, at, j, valid & (gather(stamp, j, 0) != i))
                        if at - first > one:
                            return MANY
                        at_first[i] = first
                        found[i] = at - first
                        edge[i] = image
        return 0.0

    return list_rows


def placing() -> Function:
    def place(found: "i4*", edge: "u1*", first: "i8*", depth: "i4*", edges: "u1*", room: "i8", begin: "i8", end: "i8") -> "f8":
        """Where the rows of blocks begin to end go, behind those before: first[b], depth[b] entries of each of the eight rows; edges[b]: edge of any.

        Returns 0.0, or SHORT: they take more than room.
        """
        at = first[begin]
        for b in range(begin, end):
            deepest = 0
            image = 0
            for k in range(LANES * b, LANES * b + LANES):
                deepest = max(deepest, int(found[k]))
                image |= int(edge[k])
            depth[b] = deepest
            edges[b] = image
            at += LANES * deepest
            first[b + 1] = at
        return 0.0 if at <= room else SHORT

    return place


def weaving(types: int) -> Function:
    """types: of atoms, where entries hold them; else 1."""

    def weave(
        listed: "i4*", at_first: "i4*", found: "i4*", kinds: "i4*", first: "i8*", depth: "i4*", neighbors: "i4*", filler: "i8",
        begin: "i8", end: "i8",
    ) -> "f8":
        """Rows of eight atoms side by side, blocks begin to end. neighbors[first[b] + 8 k ...]: entry k of the eight rows of block b; filler: the
        row that pads."""
        for b in range(begin, end):
            at = first[b]
            have = load(found, LANES * b, LANES)
            rows = load(at_first, LANES * b, LANES)
            for k in range(int(depth[b])):
                j = select(have > k, gather(listed, rows, k), splat_whole(filler, LANES)) * splat_whole(3, LANES)
                if types > 1:
                    j = j + (gather(kinds, j, 0) - splat_whole(1, LANES)) * splat_whole(SPAN, LANES)
                store(neighbors, at, j)
                at += LANES
        return 0.0

    return weave
