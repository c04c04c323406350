"""Neighbor lists made from other lists, in their order."""

from __future__ import annotations

from pylmp.kernels.exact import INDEX_MASK
from pylmp.kernels.kinds import Function


def skipping() -> Function:
    """Take from a list the pairs of some types, in its order."""

    def skip(
        type_: "i8*", mine: "u1*", types: "i8", from_first: "i8*", source: "i4*", first: "i8*", neighbors: "i4*", n: "i8"
    ) -> "f8":
        """mine[ti*types + tj]: pairs to take. neighbors: as long as source."""
        count = 0
        for i in range(n):
            first[i] = count
            ti = type_[i] * types
            for q in range(from_first[i], from_first[i + 1]):
                entry = source[q]
                if mine[ti + type_[int(entry) & INDEX_MASK]] != 0:
                    neighbors[count] = entry
                    count += 1
        first[n] = count
        return float(count)

    return skip


def trimming() -> Function:
    """Take from a list the pairs within a cutoff."""

    def trim(
        x: "f8*", cut2: "f8", from_first: "i8*", source: "i4*", first: "i8*", neighbors: "i4*", n: "i8"
    ) -> "f8":
        """neighbors: as long as source."""
        count = 0
        for i in range(n):
            first[i] = count
            for q in range(from_first[i], from_first[i + 1]):
                entry = source[q]
                j = int(entry) & INDEX_MASK
                dx = x[3 * i] - x[3 * j]
                dy = x[3 * i + 1] - x[3 * j + 1]
                dz = x[3 * i + 2] - x[3 * j + 2]
                if dx * dx + dy * dy + dz * dz <= cut2:
                    neighbors[count] = entry
                    count += 1
        first[n] = count
        return float(count)

    return trim
