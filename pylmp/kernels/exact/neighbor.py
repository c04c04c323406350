"""The neighbor list: which pairs may interact until somebody has moved half the skin.

Atoms are counted into bins; the members of a bin stand in ascending row order. Bins that follow each other in x have
members that follow each other in memory, so a row of the stencil is one scan. The order of the list is LAMMPS's.
"""

from __future__ import annotations

from pylmp.kernels.exact import SPECIAL_SHIFT
from pylmp.kernels.kinds import Function

HALF, HALF_OWNED, FULL, HALF_TRICLINIC = "half", "half, newton off", "full", "half, triclinic"


def bins(dimension: int) -> Function:
    """Count atoms into bins. grid: nb(3), low(3) (first bin, counted from the box's low face), m(3) (bins a direction)."""

    def place(c: float, lo: float, hi: float, inverse: float, count: int) -> int:
        if c >= hi:
            return int((c - hi) * inverse) + count
        if c >= lo:
            return min(int((c - lo) * inverse), count - 1)
        return int((c - lo) * inverse) - 1

    def fill_bins(
        x: "f8*", lo: "f8*", hi: "f8*", inverse: "f8*", grid: "i8*", bin_of: "i8*", start: "i8*", member: "i8*",
        at: "i8*", total: "i8",
    ) -> "f8":
        """start[b] .. start[b+1]: members of bin b. member[p]: row at place p; at[row]: its place.

        start comes zeroed, with room for the bins and two more. Returns 0.0, or -1.0 - row for an atom outside the grid.
        """
        nbins = grid[6] * grid[7] * grid[8]
        for i in range(total):
            iz = 1
            if dimension == 3:
                iz = place(x[3 * i + 2], lo[2], hi[2], inverse[2], grid[2]) - grid[5]
            iy = place(x[3 * i + 1], lo[1], hi[1], inverse[1], grid[1]) - grid[4]
            ix = place(x[3 * i], lo[0], hi[0], inverse[0], grid[0]) - grid[3]
            if ix < 0 or iy < 0 or iz < 0 or ix >= grid[6] or iy >= grid[7] or iz >= grid[8]:
                return -1.0 - i
            b = (iz * grid[7] + iy) * grid[6] + ix
            bin_of[i] = b
            start[b + 2] += 1
        for b in range(nbins):
            start[b + 2] += start[b + 1]
        for i in range(total):  # start[b + 1] walks from the first place of bin b to that of the next
            b = bin_of[i] + 1
            at[i] = start[b]
            member[start[b]] = i
            start[b] += 1
        return 0.0

    return fill_bins


def listing(mode: str, one_type: bool, weighted: bool, periodic: tuple[bool, bool, bool], near: float) -> Function:
    """Compose the list kernel.

    mode      HALF: each pair once, own bin first, then the upper half of the stencil;
              HALF_OWNED: newton pair off, each pair of owned atoms once and every owned-ghost pair; FULL: both directions;
              HALF_TRICLINIC: each pair once, over all bins, owned-ghost pairs by their IDs
    one_type  one cutoff for all pairs
    weighted  some bonded neighbors are scaled or left out
    near      coordinates of an atom and its own image that differ by less count as equal in a triclinic box
    """
    half, full, triclinic = mode == HALF, mode == FULL, mode == HALF_TRICLINIC
    once = mode in (HALF_OWNED, HALF_TRICLINIC)
    px, py, pz = periodic

    def kind_of(tag: int, num: "i4*", special: "i4*", i: int, wide: int) -> int:
        for q in range(num[3 * i + 2]):
            if special[i * wide + q] == tag:
                if q < num[3 * i]:
                    return 1
                return 2 if q < num[3 * i + 1] else 3
        return 0

    def mine(tag: "i8*", i: int, j: int, dx: float, dy: float, dz: float) -> bool:
        """Triclinic: does the pair of owned i and ghost j belong to i? Else to the owned atom behind j and an image of i."""
        if tag[i] > tag[j]:
            return (tag[i] + tag[j]) % 2 != 0
        if tag[i] < tag[j]:
            return (tag[i] + tag[j]) % 2 == 0
        if abs(dz) > near:
            return dz <= 0.0
        if abs(dy) > near:
            return dy <= 0.0
        return dx <= 0.0

    def list_neighbors(
        x: "f8*", type_: "i8*", tag: "i8*", bin_of: "i8*", start: "i8*", member: "i8*", at: "i8*", place: "f8*",
        rows: "i8*", cut2: "f8*", types: "i8", num: "i4*", special: "i4*", wide: "i8", policy: "i8*", halves: "f8*",
        first: "i8*", neighbors: "i4*", n: "i8", total: "i8", capacity: "i8",
    ) -> "f8":
        """rows[0]: stencil rows, then (first bin, last bin) of each, relative to an atom's bin. Returns entries, -1: no room."""
        for p in range(total):
            m = member[p]
            place[3 * p] = x[3 * m]
            place[3 * p + 1] = x[3 * m + 1]
            place[3 * p + 2] = x[3 * m + 2]
        count = 0
        single = cut2[types + 1]
        for i in range(n):
            first[i] = count
            xi = x[3 * i]
            yi = x[3 * i + 1]
            zi = x[3 * i + 2]
            own = bin_of[i]
            ti = type_[i] * types
            for r in range(-1 if half else 0, rows[0]):
                if half and r < 0:
                    begin = at[i] + 1
                    end = start[own + 1]
                else:
                    begin = start[own + rows[1 + 2 * r]]
                    end = start[own + rows[2 + 2 * r] + 1]
                if count + end - begin > capacity:
                    return -1.0
                for p in range(begin, end):
                    dx = xi - place[3 * p]
                    dy = yi - place[3 * p + 1]
                    dz = zi - place[3 * p + 2]
                    r2 = dx * dx + dy * dy + dz * dz
                    j = member[p]
                    if one_type:
                        take = r2 <= single
                    else:
                        take = r2 <= cut2[ti + type_[j]]
                    if once:
                        take = take and j > i
                        if triclinic and take and j >= n:
                            take = mine(tag, i, j, dx, dy, dz)
                    elif full:
                        take = take and j != i
                    if half and r < 0 and take and j >= n:
                        # a ghost in the own bin: the pair belongs to the lower one of the two in z, then y, then x
                        if dz > 0.0 or (dz == 0.0 and (dy > 0.0 or (dy == 0.0 and dx > 0.0))):
                            take = False
                    if weighted:
                        if take:
                            entry = j
                            kind = kind_of(tag[j], num, special, i, wide)
                            if kind > 0 and policy[kind] != 1:
                                far = (
                                    (px and abs(dx) > halves[0])
                                    or (py and abs(dy) > halves[1])
                                    or (pz and abs(dz) > halves[2])
                                )
                                if not far:
                                    if policy[kind] == 0:
                                        continue
                                    entry = j | (kind << SPECIAL_SHIFT)
                            neighbors[count] = entry
                            count += 1
                    else:
                        neighbors[count] = j
                        count += 1 if take else 0
        first[n] = count
        return float(count)

    return list_neighbors


def moved() -> Function:
    def anybody_moved(x: "f8*", held: "f8*", limit2: "f8*", n: "i8") -> "f8":
        """1.0 if an atom is farther than sqrt(limit2[0]) from where the list was built.

        Counted without a branch in stretches, which the compiler turns into vector instructions.
        """
        limit = limit2[0]
        for start in range(0, n, 512):
            far = 0
            for i in range(start, min(start + 512, n)):
                dx = x[3 * i] - held[3 * i]
                dy = x[3 * i + 1] - held[3 * i + 1]
                dz = x[3 * i + 2] - held[3 * i + 2]
                far += 1 if dx * dx + dy * dy + dz * dz > limit else 0
            if far > 0:
                return 1.0
        return 0.0

    return anybody_moved
