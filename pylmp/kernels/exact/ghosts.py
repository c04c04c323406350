"""Ghost atoms: copies of owned atoms across periodic faces, in LAMMPS's order of swaps."""

from __future__ import annotations

from pylmp.kernels.kinds import Function


def borders(periodic: tuple[bool, bool, bool], dimension: int, flow: bool) -> Function:
    """Make the ghosts, in frame coordinates. flow: velocities change across a periodic face of a box that flows.

    Whether an image takes part in the flow LAMMPS reads from the wrong atom: number k of a swap from row k (place).

    For each periodic direction pairs of swaps: first copies of atoms near the low face, moved up by a box length, then
    near the high face, moved down. Later pairs of a direction copy only what the pair before made.
    """

    def make_ghosts(
        x: "f8*", v: "f8*", tag: "i8*", type_: "i8*", mask: "i8*", source: "i8*", axis: "i8*", sign: "f8*",
        swaps: "i8*", place: "i8*", lo: "f8*", hi: "f8*", cutoff: "f8*", rate: "f8*", group: "i8", n: "i8", capacity: "i8",
    ) -> "f8":
        """cutoff: (3,). Fill ghost rows; swaps[0] = number of swaps, swaps[1 + k] = first row of swap k. Returns owned + ghosts, -1: no room."""
        total = n
        count = 0
        for d in range(dimension):
            if not periodic[d]:
                continue
            length = hi[d] - lo[d]
            middle = 0.5 * (lo[d] + hi[d])
            first = 0
            last = total
            for q in range(2 * (int(cutoff[d] / length) + 1)):
                low = q % 2 == 0
                if low:
                    if q > 0:
                        first = last
                    last = total
                swaps[1 + count] = total
                count += 1
                shift = 1.0 if low else -1.0
                for i in range(first, last):
                    c = x[3 * i + d]
                    if low:
                        near = c <= lo[d] + cutoff[d] and (q < 2 or c >= middle)
                    else:
                        near = c >= hi[d] - cutoff[d] and (q < 2 or c <= middle)
                    if near:
                        if total >= capacity:
                            return -1.0
                        for k in range(3):
                            x[3 * total + k] = x[3 * i + k]
                            v[3 * total + k] = v[3 * i + k]
                        x[3 * total + d] += shift * length
                        if flow:
                            place[total] = total - swaps[count]
                            if mask[place[total]] & group != 0:
                                cross(v, 3 * total, d, shift, rate)
                        tag[total] = tag[i]
                        type_[total] = type_[i]
                        mask[total] = mask[i]
                        source[total] = i
                        axis[total] = d
                        sign[total] = shift
                        total += 1
        swaps[0] = count
        swaps[1 + count] = total
        return float(total)

    return make_ghosts


def index() -> Function:
    def index_tags(tag: "i8*", first: "i8*", same: "i8*", total: "i8") -> "f8":
        """first[ID] = lowest row of that ID (-1 as it comes: none), same[row] = next row of the same ID (-1: none)."""
        for i in range(total - 1, -1, -1):
            same[i] = first[tag[i]]
            first[tag[i]] = i
        return 0.0

    return index_tags


def cross(v: "f8*", at: int, d: int, sign: float, rate: "f8*") -> None:
    """The velocity (v[at] and the two after it) of an image beyond face d; rate: of the box's xx yy zz yz xz xy."""
    if d == 0:
        v[at] += sign * rate[0]
    elif d == 1:
        v[at] += sign * rate[5]
        v[at + 1] += sign * rate[1]
    else:
        v[at] += sign * rate[4]
        v[at + 1] += sign * rate[3]
        v[at + 2] += sign * rate[2]


def refresh(velocity: bool, triclinic: bool, flow: bool) -> Function:
    """Ghosts follow their source; a source may itself be a ghost, refreshed before. triclinic: a shift has several components."""

    def refresh_ghosts(
        x: "f8*", v: "f8*", mask: "i8*", source: "i8*", axis: "i8*", sign: "f8*", place: "i8*", lo: "f8*", hi: "f8*", h: "f8*",
        rate: "f8*", group: "i8", n: "i8", total: "i8",
    ) -> "f8":
        """h: (6,) of a triclinic box, xx yy zz yz xz xy."""
        for g in range(n, total):
            s = 3 * source[g]
            d = axis[g]
            x[3 * g] = x[s]
            x[3 * g + 1] = x[s + 1]
            x[3 * g + 2] = x[s + 2]
            if triclinic:
                x[3 * g + d] += sign[g] * h[d]
                if d == 1:
                    x[3 * g] += sign[g] * h[5]
                elif d == 2:
                    x[3 * g] += sign[g] * h[4]
                    x[3 * g + 1] += sign[g] * h[3]
            else:
                x[3 * g + d] += sign[g] * (hi[d] - lo[d])
            if velocity:
                v[3 * g] = v[s]
                v[3 * g + 1] = v[s + 1]
                v[3 * g + 2] = v[s + 2]
                if flow and mask[place[g]] & group != 0:
                    cross(v, 3 * g, d, sign[g], rate)
        return 0.0

    return refresh_ghosts


def reverse() -> Function:
    def return_forces(f: "f8*", source: "i8*", swaps: "i8*") -> "f8":
        """Add ghost forces to their sources, last swap first, each in row order."""
        for k in range(swaps[0] - 1, -1, -1):
            for g in range(swaps[1 + k], swaps[2 + k]):
                s = 3 * source[g]
                f[s] += f[3 * g]
                f[s + 1] += f[3 * g + 1]
                f[s + 2] += f[3 * g + 2]
        return 0.0

    return return_forces
