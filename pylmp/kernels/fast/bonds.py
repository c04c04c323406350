"""What happens around bonds in the fast engine: what they remember goes back to the atoms, broken ones are booked."""

from __future__ import annotations

from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES

MISSING = -1.0  # a partner is nowhere: the kernel returns MISSING minus the number of the atom's slot


def counting(newton: bool) -> Function:
    """Compose the count of listed bonds of each row; newton: a bond is stored at one end, and counts at both."""

    def count_bonds(
        num_bond: "i4*", bond_type: "i4*", bond_atom: "i4*", wide: "i8", mine: "u1*", by_tag: "i8*", tags: "i8", held: "i4*", n: "i8",
        tolerant: "i8",
    ) -> "f8":
        """mine[type]: listed here. by_tag (tags,): row of each ID, -1 of none. held: adds to it. See MISSING; tolerant: such bonds are none."""
        for i in range(n):
            for q in range(i * wide, i * wide + num_bond[i]):
                if bond_type[q] <= 0 or mine[bond_type[q]] == 0:
                    continue
                partner = bond_atom[q]
                j = -1
                if partner < tags:
                    j = int(by_tag[partner])
                if j < 0:
                    if tolerant == 0:
                        return MISSING - q
                    continue
                held[i] += 1
                if newton:
                    held[j] += 1
        return 0.0

    return count_bonds


def laying(newton: bool, memory: int) -> Function:
    """Compose the layout: entries of a row are the bonds that it stores, then those that others do."""

    def lay_bonds(
        num_bond: "i4*", bond_type: "i4*", bond_atom: "i4*", bond_history: "f8*", wide: "i8", mine: "u1*", by_tag: "i8*", tags: "i8",
        first: "i8*", held: "i4*", to: "i4*", kind: "i4*", owner: "i4*", home: "i4*", history: "f8*", slots: "i8", n: "i8",
    ) -> "f8":
        """held: zeros; counts what a row has. Other arguments as in FastBonds."""
        for end in range(2 if newton else 1):
            for i in range(n):
                for q in range(i * wide, i * wide + num_bond[i]):
                    if bond_type[q] <= 0 or mine[bond_type[q]] == 0:
                        continue
                    partner = bond_atom[q]
                    if partner >= tags or by_tag[partner] < 0:
                        continue
                    row = i
                    other = int(by_tag[partner])
                    if end == 1:
                        row = other
                        other = i
                    at = first[row // LANES] + LANES * held[row] + row % LANES
                    held[row] += 1
                    to[at] = 3 * other
                    kind[at] = bond_type[q]
                    owner[at] = row
                    home[at] = other
                    for k in range(memory):
                        history[k * slots + at] = bond_history[q * memory + k]
        return 0.0

    return lay_bonds


def leaving_out() -> Function:
    """Compose who is left out: special neighbors whose weight is zero."""

    def leave_out(
        num_special: "i4*", special_: "i4*", wide: "i8", zero: "u1*", by_tag: "i8*", tags: "i8", first: "i8*", rows: "i4*", room: "i8",
        n: "i8",
    ) -> "f8":
        """zero (3,): pairs one, two, three bonds away are. first (n + 1,), rows: as in LeftOut. Returns how many; rows beyond room are not written."""
        count = 0
        for i in range(n):
            first[i] = count
            begin = 0
            for k in range(3):
                end = int(num_special[3 * i + k])
                if zero[k] != 0:
                    for q in range(i * wide + begin, i * wide + end):
                        if count < room:
                            rows[count] = i  # nobody is a neighbor of himself anyway
                            if special_[q] < tags and by_tag[special_[q]] >= 0:
                                rows[count] = by_tag[special_[q]]
                        count += 1
                begin = max(begin, end)
        first[n] = count
        return float(count)

    return leave_out


def copy_back(memory: int) -> Function:
    def remember(
        tag: "i8*", num_bond: "i4*", bond_atom: "i4*", bond_history: "f8*", wide: "i8", owner: "i4*", bond_to: "i4*", bond_kind: "i4*",
        history: "f8*", slots: "i8",
    ) -> "f8":
        """What bonds remember, to the slots of the atoms that store them. owner: row of each slot; -1: nobody's."""
        for p in range(slots):
            i = int(owner[p])
            if i < 0 or bond_kind[p] <= 0:
                continue
            partner = tag[bond_to[p] // 3]
            for q in range(num_bond[i]):
                if bond_atom[i * wide + q] == partner:
                    for k in range(memory):
                        bond_history[(i * wide + q) * memory + k] = history[k * slots + p]
        return 0.0

    return remember


def booking(zero: bool, memory: int, shifts: bool, special: bool) -> Function:
    """Compose what follows a break.

    zero     the atom keeps the bond, as type 0; else its last slot moves into the hole, and with shifts what that one remembers
    special  the two atoms are bonded neighbors no longer
    """

    def forget(i: int, partner: int, num_special: "i4*", special_: "i4*", wide: int) -> None:
        near = num_special[3 * i]
        used = num_special[3 * i + 2]
        for q in range(near):
            if special_[i * wide + q] == partner:
                for p in range(q, used - 1):
                    special_[i * wide + p] = special_[i * wide + p + 1]
                num_special[3 * i] = near - 1
                num_special[3 * i + 1] = near - 1
                num_special[3 * i + 2] = near - 1
                return

    def book(
        broken: "i4*", count: "i8", owner: "i4*", bond_to: "i4*", tag: "i8*", num_bond: "i4*", bond_type: "i4*", bond_atom: "i4*",
        bond_history: "f8*", wide: "i8", num_special: "i4*", special_: "i4*", most: "i8", left_first: "i8*", left_out: "i4*",
    ) -> "f8":
        """broken: slots, one at each end of a bond."""
        for k in range(count):
            p = int(broken[k])
            i = int(owner[p])
            j = int(bond_to[p]) // 3
            partner = tag[j]
            for q in range(num_bond[i]):
                if bond_atom[i * wide + q] == partner:
                    if zero:
                        bond_type[i * wide + q] = 0
                        continue
                    if bond_type[i * wide + q] <= 0:
                        continue
                    last = num_bond[i] - 1
                    bond_type[i * wide + q] = bond_type[i * wide + last]
                    bond_atom[i * wide + q] = bond_atom[i * wide + last]
                    if shifts:
                        for m in range(memory):
                            bond_history[(i * wide + q) * memory + m] = bond_history[(i * wide + last) * memory + m]
                            bond_history[(i * wide + last) * memory + m] = 0.0
                    num_bond[i] = last
                    break
            if special:
                forget(i, partner, num_special, special_, most)
                for q in range(left_first[i], left_first[i + 1]):
                    if left_out[q] == j:
                        left_out[q] = i
        return 0.0

    return book


def clearing() -> Function:
    def clear(bond_kind: "i4*", slots: "i8") -> "f8":
        """Bonds that broke since the last list are gone: the new list has their atoms."""
        for p in range(slots):
            bond_kind[p] = max(int(bond_kind[p]), 0)
        return 0.0

    return clear
