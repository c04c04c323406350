"""The bond loop, and the list it runs over."""

from __future__ import annotations

from pylmp.kernels.exact import coefficients, give_share, row
from pylmp.kernels.kinds import Function
from pylmp.laws import sqrt

LOST = -1.0  # a bond partner is nowhere: the kernel returns LOST minus the owner's row


def bond_list(newton: bool, memory: int) -> Function:
    """List the bonds of owned atoms, in row and slot order, each with the image of its partner closest to the owner.

    memory: numbers a bond remembers. An entry takes them from the slot of its first end, then, if the second end is owned
    too, from that end's slot: the later one wins, and of several slots with the same partner the last.
    """

    def closest(x: "f8*", same: "i8*", i: int, j: int) -> int:
        best = j
        least = -1.0
        while j >= 0:
            dx = x[3 * i] - x[3 * j]
            dy = x[3 * i + 1] - x[3 * j + 1]
            dz = x[3 * i + 2] - x[3 * j + 2]
            r2 = dx * dx + dy * dy + dz * dz
            if least < 0.0 or r2 < least:
                least = r2
                best = j
            j = same[j]
        return best

    def list_bonds(
        x: "f8*", tag: "i8*", first: "i8*", same: "i8*", num_bond: "i4*", bond_type: "i4*", bond_atom: "i4*",
        bond_history: "f8*", wide: "i8", mine: "u1*", tags: "i8", bonds: "i8*", history: "f8*", n: "i8", capacity: "i8",
        tolerant: "i8",
    ) -> "f8":
        """bonds: (row, row, type) a bond. mine[type]: listed here. Returns their number; see LOST; -0.5: no room."""
        count = 0
        for i in range(n):
            for q in range(num_bond[i]):
                kind = bond_type[i * wide + q]
                if kind <= 0 or mine[kind] == 0:
                    continue
                partner = bond_atom[i * wide + q]
                j = -1
                if partner < tags:
                    j = first[partner]
                if j < 0:
                    if tolerant != 0:
                        continue
                    return LOST - i
                j = closest(x, same, i, j)
                if not newton and i > j:
                    continue
                if count >= capacity:
                    return -0.5
                bonds[3 * count] = i
                bonds[3 * count + 1] = j
                bonds[3 * count + 2] = kind
                if memory > 0:
                    for p in range(num_bond[i]):
                        if bond_atom[i * wide + p] == partner:
                            for k in range(memory):
                                history[memory * count + k] = bond_history[(i * wide + p) * memory + k]
                    if j < n:
                        for p in range(num_bond[j]):
                            if bond_atom[j * wide + p] == tag[i]:
                                for k in range(memory):
                                    history[memory * count + k] = bond_history[(j * wide + p) * memory + k]
                count += 1
        return float(count)

    return list_bonds


def copy_back(memory: int) -> Function:
    """What listed bonds remember, back to the slots of their owned ends."""

    def remember(
        tag: "i8*", num_bond: "i4*", bond_atom: "i4*", bond_history: "f8*", wide: "i8", bonds: "i8*", history: "f8*",
        count: "i8", n: "i8",
    ) -> "f8":
        for b in range(count):
            if bonds[3 * b + 2] <= 0:
                continue
            for end in range(2):
                i = bonds[3 * b + end]
                if i >= n:
                    continue
                partner = tag[bonds[3 * b + 1 - end]]
                for q in range(num_bond[i]):
                    if bond_atom[i * wide + q] == partner:
                        for k in range(memory):
                            bond_history[(i * wide + q) * memory + k] = history[memory * b + k]
        return 0.0

    return remember


def bond_loop(
    law: Function, width: int, memory: int, pair_law: Function, pair_width: int, *,
    newton: bool, velocity: bool, lower_id_first: bool, reference: bool, can_break: bool, one_type: bool, tally: bool,
    tabled: bool = False, individual: bool = False, watch: Function = None, share: bool = False,
) -> Function:  # fmt: skip
    """Compose the loop around law(r2, dot, history, c) -> (force over r, energy, history, alive).

    pair_law   not None: pair_law(r2, dot, pair_table, at, pair_data) is taken out again (quartic's subtraction)
    reference  the first remembered number is the length at the first evaluation
    tabled     c ends with data, a table that the law looks things up in
    individual c ends with own[entry], a number of this bond alone
    watch      None, or watch(r2, c) -> this bond must be reported
    share      each atom gets its share of energy and virial
    """
    load, recall = coefficients(width, tabled, individual), row(memory)
    subtract, watched = pair_law is not None, watch is not None

    def forces(
        x: "f8*", v: "f8*", f: "f8*", tag: "i8*", type_: "i8*", bonds: "i8*", history: "f8*", count: "i8", table: "f8*",
        data: "f8*", own: "f8*", pair_table: "f8*", pair_data: "f8*", types: "i8", sums: "f8*", virial: "f8*",
        pair_virial: "f8*", shares: "f8*", pair_shares: "f8*", broken: "i8*", noted: "i8*", may_break: "i8", n: "i8",
    ) -> "f8":
        """Adds to f; sums[0] += bond energy, sums[1] += pair energy taken out. broken: entries that broke, in order. Returns how many.

        shares, pair_shares: (rows, SHARES) added to where each atom gets its share. noted: how many bonds must be reported,
        then their entries in order.
        """
        energy = 0.0
        taken = sums[1]
        breaks = 0
        notes = 0
        c = load(table, width, data, own, 0)
        for b in range(count):
            kind = bonds[3 * b + 2]
            if kind <= 0:
                continue
            i = bonds[3 * b]
            j = bonds[3 * b + 1]
            if lower_id_first and tag[j] < tag[i]:
                i, j = j, i
            dx = x[3 * i] - x[3 * j]
            dy = x[3 * i + 1] - x[3 * j + 1]
            dz = x[3 * i + 2] - x[3 * j + 2]
            r2 = dx * dx + dy * dy + dz * dz
            if reference and not history[memory * b] >= 1.0e-10:
                history[memory * b] = sqrt(r2)
                for k in range(1, memory):
                    history[memory * b + k] = 0.0
            dot = 0.0
            if velocity:
                dot = (
                    dx * (v[3 * i] - v[3 * j])
                    + dy * (v[3 * i + 1] - v[3 * j + 1])
                    + dz * (v[3 * i + 2] - v[3 * j + 2])
                )
            if individual or not one_type:
                c = load(table, kind * width, data, own, b)
            if watched:
                if watch(r2, c):
                    notes += 1
                    noted[notes] = b
            force, e, remembered, alive = law(r2, dot, recall(history, memory * b), c)
            if can_break:
                if not alive and may_break != 0:
                    bonds[3 * b + 2] = 0
                    broken[breaks] = b
                    breaks += 1
                    continue
            if memory > 0:
                for k in range(memory):
                    history[memory * b + k] = remembered[k]
            mine = newton or i < n
            yours = newton or j < n
            if mine:
                f[3 * i] += dx * force
                f[3 * i + 1] += dy * force
                f[3 * i + 2] += dz * force
            if yours:
                f[3 * j] -= dx * force
                f[3 * j + 1] -= dy * force
                f[3 * j + 2] -= dz * force
            if tally:
                energy = add(energy, e, mine, yours)
                add_virial(virial, force, dx, dy, dz, mine, yours)
            if share:
                if mine:
                    give_share(shares, i, e, force, dx, dy, dz)
                if yours:
                    give_share(shares, j, e, force, dx, dy, dz)
            if subtract:
                at = (type_[i] * types + type_[j]) * pair_width
                pair_force, pe = pair_law(r2, dot, pair_table, at, pair_data)
                pair_force = -pair_force
                if mine:
                    f[3 * i] += dx * pair_force
                    f[3 * i + 1] += dy * pair_force
                    f[3 * i + 2] += dz * pair_force
                if yours:
                    f[3 * j] -= dx * pair_force
                    f[3 * j + 1] -= dy * pair_force
                    f[3 * j + 2] -= dz * pair_force
                if tally:
                    taken = add(taken, -pe, mine, yours)
                    add_virial(pair_virial, pair_force, dx, dy, dz, mine, yours)
                if share:
                    if mine:
                        give_share(pair_shares, i, -pe, pair_force, dx, dy, dz)
                    if yours:
                        give_share(pair_shares, j, -pe, pair_force, dx, dy, dz)
        sums[0] = energy
        sums[1] = taken
        noted[0] = notes
        return float(breaks)

    def add(total: float, e: float, mine: bool, yours: bool) -> float:
        """Whole with newton bond on, else half per owned end."""
        if newton:
            return total + e
        if mine:
            total += 0.5 * e
        if yours:
            total += 0.5 * e
        return total

    def add_virial(virial: "f8*", force: float, dx: float, dy: float, dz: float, mine: bool, yours: bool) -> None:
        if newton:
            virial[0] += dx * dx * force
            virial[1] += dy * dy * force
            virial[2] += dz * dz * force
            virial[3] += dx * dy * force
            virial[4] += dx * dz * force
            virial[5] += dy * dz * force
            return
        ends = (1 if mine else 0) + (1 if yours else 0)
        for _ in range(ends):
            virial[0] += 0.5 * (dx * dx * force)
            virial[1] += 0.5 * (dy * dy * force)
            virial[2] += 0.5 * (dz * dz * force)
            virial[3] += 0.5 * (dx * dy * force)
            virial[4] += 0.5 * (dx * dz * force)
            virial[5] += 0.5 * (dy * dz * force)

    return forces
