"""What happens around bonds in the fast engine: what they remember goes back to the atoms, broken ones are booked."""

from __future__ import annotations

from pylmp.kernels.kinds import Function


def copy_back(memory: int) -> Function:
    def remember(
        tag: "i8*", num_bond: "i8*", bond_atom: "i8*", bond_history: "f8*", wide: "i8", owner: "i4*", bond_to: "i4*", bond_kind: "i4*",
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

    def forget(i: int, partner: int, num_special: "i8*", special_: "i8*", wide: int) -> None:
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
        broken: "i4*", count: "i8", owner: "i4*", bond_to: "i4*", tag: "i8*", num_bond: "i8*", bond_type: "i8*", bond_atom: "i8*",
        bond_history: "f8*", wide: "i8", num_special: "i8*", special_: "i8*", most: "i8", left_first: "i8*", left_out: "i4*",
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
