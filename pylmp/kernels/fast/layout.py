"""A full list as the exact engine keeps it, row after row, to rows of eight atoms side by side."""

from __future__ import annotations

from pylmp.kernels.exact import INDEX_MASK, SPECIAL_SHIFT
from pylmp.kernels.fast.neighbor import SHORT
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES


def laying_out(weighted: bool) -> Function:
    """weighted: entries are given the weights of their special kinds."""

    def lay_out(
        begins: "i8*", entries: "i4*", kinds: "f8*", first: "i8*", depth: "i4*", neighbors: "i4*", weights: "f8*", room: "i8",
        filler: "i8", blocks: "i8", n: "i8",
    ) -> "f8":
        """begins (n + 1,), entries: the list. kinds (4,): weights. neighbors, weights (room,): entry k of the eight rows of block b at
        first[b] + 8 k, depth[b] of them; filler: the row that pads. Returns 0.0, or SHORT: they are more than room."""
        at = 0
        for b in range(blocks):
            deepest = 0
            for i in range(LANES * b, min(LANES * b + LANES, n)):
                deepest = max(deepest, int(begins[i + 1] - begins[i]))
            if at + LANES * deepest > room:
                return SHORT
            first[b] = at
            depth[b] = deepest
            for lane in range(LANES):
                i = LANES * b + lane
                begin = 0
                many = 0
                if i < n:
                    begin = int(begins[i])
                    many = int(begins[i + 1]) - begin
                for k in range(many):
                    entry = int(entries[begin + k])
                    neighbors[at + LANES * k + lane] = 3 * (entry & INDEX_MASK)
                    if weighted:
                        weights[at + LANES * k + lane] = kinds[(entry >> SPECIAL_SHIFT) & 3]
                for k in range(many, deepest):
                    neighbors[at + LANES * k + lane] = 3 * filler
                    if weighted:
                        weights[at + LANES * k + lane] = 1.0
            at += LANES * deepest
        return 0.0

    return lay_out
