"""Forces of a block of eight atoms: its neighbors, its bonds, one law evaluated in eight lanes at once."""

from __future__ import annotations

from typing import Any

from pylmp.kernels.exact import SHARES
from pylmp.kernels.fast import columns, no_weight, places, recalling, remembering, weight
from pylmp.kernels.fast.choosing import by_other, choice, rows_of, rows_of_pairs, unpacking
from pylmp.kernels.fast.terms import BondTerm, PairTerm
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import (
    LANES,
    compress,
    count_up,
    gather,
    gather_rows,
    load,
    scatter,
    some,
    splat,
    splat_whole,
    store,
    total,
)  # fmt: skip
from pylmp.laws import select, sqrt

TALLIES = 15  # pair energy, bond energy, pair energy that bonds take out, virials of pairs and of bonds: xx yy zz xy xz yz


def force_loop(
    pair: PairTerm | None, bond: BondTerm | None, periodic: tuple[bool, bool, bool], level: int,
    *, listed: bool = True, weighted: bool = False, adds: bool = False,
) -> Function:  # fmt: skip
    """Compose the kernel of one scene.

    periodic  images are found from the positions; False where ghosts stand for them
    level     0: forces alone, 1: energy and virial too, 2: instead each atom's share of them
    listed    walk the neighbor list; else the pair law is there for bonds that need it
    weighted  each entry of the neighbor list has a weight
    adds      forces and shares are added to what others left there
    """
    px, py, pz = periodic
    paired, bonded = pair is not None and listed, bond is not None
    tally, share = level > 0, level > 1
    pair = pair or PairTerm(None, 0, False, 1)
    bond = bond or BondTerm(None, 0, 0, False, 1, False, False, False, None, None)
    pair_law, pair_width, pair_velocity, few = pair.law, pair.width, pair.velocity, pair.types
    bond_law, memory, few_bonds, can_break, instead = bond.law, bond.memory, bond.types, bond.can_break, bond.instead
    bond_velocity, reference, subtract, alone = bond.velocity, bond.reference, bond.alone is not None, bond.alone
    bond_width, watched, watch = bond.width, bond.watch is not None, bond.watch
    moving = pair_velocity or bond_velocity
    pair_rows, pair_row, pair_columns = rows_of_pairs(few, few, pair_width), by_other(few, few, pair_width), columns(pair_width)
    bond_rows, bond_columns = rows_of(few_bonds, bond_width), columns(bond_width)
    choose, choose_bond = choice(few, pair_width), choice(few_bonds, bond_width)
    apart, kind_of = unpacking(few, pair.packed), unpacking(few, False)
    recall, remember = recalling(memory), remembering(memory)
    kinds_needed = ((paired or instead) and few != 1) or subtract

    def for_types(law: Function) -> Function:
        """The law of pairs, with the coefficients of their types; c: those of few, for each type of the other atom."""

        def evaluate(r2, dot, factor, ti, tj, table, types, c):
            if few:
                return law(r2, dot, factor, choose(c, tj))
            return law(r2, dot, factor, pair_columns(table, (ti * types + tj) * pair_width))

        return evaluate

    factor_at = weight if weighted else no_weight
    of_pair, of_alone = for_types(pair_law), for_types(alone)

    def give(shares, at, k, value):
        """Half of a value is the row's share."""
        value = 0.5 * value
        if adds:
            value = value + gather(shares, at, k)
        scatter(shares, at, k, value)

    def give_all(shares, at, e, xx, yy, zz, xy, xz, yz):
        give(shares, at, 0, e)
        give(shares, at, 1, xx)
        give(shares, at, 2, yy)
        give(shares, at, 3, zz)
        give(shares, at, 4, xy)
        give(shares, at, 5, xz)
        give(shares, at, 6, yz)

    def fold(d: Any, length: float) -> Any:
        """The nearest periodic image."""
        d = select(d > 0.5 * length, d - length, d)
        return select(d < -0.5 * length, d + length, d)

    def forces(
        x: "f8*", v: "f8*", f: "f8*", kinds: "i4*", first: "i8*", depth: "i4*", edges: "u1*", neighbors: "i4*", weights: "f8*", table: "f8*",
        types: "i8", bond_first: "i8*", bond_depth: "i4*", bond_to: "i4*", bond_kind: "i4*", history: "f8*", slots: "i8",
        bond_table: "f8*", lengths: "f8*", sums: "f8*", pair_shares: "f8*", bond_shares: "f8*", broken: "i4*", noted: "i4*", may_break: "i8*",
        begin: "i8", end: "i8",
    ) -> "f8":
        """Set f in the rows of blocks begin to end; sums (TALLIES,) is set at level 1, shares (rows, SHARES) of the
        atoms at level 2.

        may_break[0]: 0 where no bond may. kinds: types of atoms, kinds[3 i] of row i. bond_kind: type of each slot, 0 none, below 0 broken since the last list. broken:
        slots of bonds that broke, one at each end. noted: how many bonds must be reported, then their slots. Returns how many broke.
        """
        lx = lengths[0]
        ly = lengths[1]
        lz = lengths[2]
        breaks = 0
        notes = 0
        pe = splat(0.0, LANES)
        be = splat(0.0, LANES)
        te = splat(0.0, LANES)
        pxx = splat(0.0, LANES)
        pyy = splat(0.0, LANES)
        pzz = splat(0.0, LANES)
        pxy = splat(0.0, LANES)
        pxz = splat(0.0, LANES)
        pyz = splat(0.0, LANES)
        bxx = splat(0.0, LANES)
        byy = splat(0.0, LANES)
        bzz = splat(0.0, LANES)
        bxy = splat(0.0, LANES)
        bxz = splat(0.0, LANES)
        byz = splat(0.0, LANES)
        rows = pair_rows(table, types)
        bond_types = bond_rows(bond_table, 0, bond_width)
        for b in range(begin, end):
            i = places(b)
            xi, yi, zi = gather_rows(x, i)
            fx = splat(0.0, LANES)
            fy = splat(0.0, LANES)
            fz = splat(0.0, LANES)
            ui = splat(0.0, LANES)
            vi = splat(0.0, LANES)
            wi = splat(0.0, LANES)
            if moving:
                ui, vi, wi = gather_rows(v, i)
            ti = splat_whole(0, LANES)
            if kinds_needed:
                ti = gather(kinds, i, 0)
            c = pair_row(rows, ti)
            if paired:
                image_x = edges[b] & 1 != 0
                image_y = edges[b] & 2 != 0
                image_z = edges[b] & 4 != 0
                for k in range(first[b], first[b] + LANES * depth[b], LANES):
                    j, tj = apart(load(neighbors, k, LANES), kinds)
                    xj, yj, zj = gather_rows(x, j)
                    dx = xi - xj
                    dy = yi - yj
                    dz = zi - zj
                    if px:
                        if image_x:
                            dx = fold(dx, lx)
                    if py:
                        if image_y:
                            dy = fold(dy, ly)
                    if pz:
                        if image_z:
                            dz = fold(dz, lz)
                    r2 = dx * dx + dy * dy + dz * dz
                    dot = splat(0.0, LANES)
                    if pair_velocity:
                        uj, vj, wj = gather_rows(v, j)
                        dot = dx * (ui - uj) + dy * (vi - vj) + dz * (wi - wj)
                    force, e = of_pair(r2, dot, factor_at(weights, k), ti, tj, table, types, c)
                    gx = dx * force
                    gy = dy * force
                    gz = dz * force
                    fx = fx + gx
                    fy = fy + gy
                    fz = fz + gz
                    if tally:
                        pe = pe + e
                        pxx = pxx + dx * gx
                        pyy = pyy + dy * gy
                        pzz = pzz + dz * gz
                        pxy = pxy + dx * gy
                        pxz = pxz + dx * gz
                        pyz = pyz + dy * gz
            if bonded:
                for k in range(bond_first[b], bond_first[b] + LANES * bond_depth[b], LANES):
                    kind = load(bond_kind, k, LANES)
                    j = load(bond_to, k, LANES)
                    xj, yj, zj = gather_rows(x, j)
                    dx = xi - xj
                    dy = yi - yj
                    dz = zi - zj
                    if px:
                        dx = fold(dx, lx)
                    if py:
                        dy = fold(dy, ly)
                    if pz:
                        dz = fold(dz, lz)
                    r2 = dx * dx + dy * dy + dz * dz
                    dot = splat(0.0, LANES)
                    if moving:
                        uj, vj, wj = gather_rows(v, j)
                        dot = dx * (ui - uj) + dy * (vi - vj) + dz * (wi - wj)
                    active = kind > 0
                    if reference:
                        new = active & (load(history, k, LANES) < 1.0e-10)
                        if some(new):
                            store(history, k, select(new, sqrt(r2), load(history, k, LANES)))
                            for m in range(1, memory):
                                store(history, m * slots + k, select(new, 0.0, load(history, m * slots + k, LANES)))
                    if watched:
                        if few_bonds:
                            worth = active & watch(r2, choose_bond(bond_types, kind))
                        else:
                            at = select(active, kind, splat_whole(1, LANES)) * bond_width
                            worth = active & watch(r2, bond_columns(bond_table, at))
                        if some(worth):
                            notes += compress(noted, 1 + notes, count_up(k, LANES), worth)
                    if few_bonds:
                        force, e, remembered, alive = bond_law(r2, dot, recall(history, k, slots), choose_bond(bond_types, kind))
                    else:
                        at = select(active, kind, splat_whole(1, LANES)) * bond_width
                        force, e, remembered, alive = bond_law(r2, dot, recall(history, k, slots), bond_columns(bond_table, at))
                    if can_break:
                        if may_break[0] != 0:
                            gone = active & ~alive
                            if some(gone):
                                breaks += compress(broken, breaks, count_up(k, LANES), gone)
                                store(bond_kind, k, select(gone, -kind if instead else splat_whole(0, LANES), kind))
                                active = active & alive
                    if memory > 0:
                        remember(history, k, slots, remembered, active)
                    force = select(active, force, 0.0)
                    if tally:
                        be = be + select(active, e, 0.0)
                        bxx = bxx + dx * dx * force
                        byy = byy + dy * dy * force
                        bzz = bzz + dz * dz * force
                        bxy = bxy + dx * dy * force
                        bxz = bxz + dx * dz * force
                        byz = byz + dy * dz * force
                    other = splat(0.0, LANES)
                    if subtract:
                        other, e = of_alone(r2, dot, 1.0, ti, kind_of(j, kinds)[1], table, types, c)
                        other = select(active, -other, 0.0)
                        e = select(active, -e, 0.0)
                        if tally:
                            te = te + e
                    if instead:
                        before = kind < 0
                        if some(before):
                            other, e = of_pair(r2, dot, 1.0, ti, kind_of(j, kinds)[1], table, types, c)
                            other = select(before, other, 0.0)
                            if tally:
                                pe = pe + select(before, e, 0.0)
                    if subtract or instead:
                        if tally:
                            pxx = pxx + dx * dx * other
                            pyy = pyy + dy * dy * other
                            pzz = pzz + dz * dz * other
                            pxy = pxy + dx * dy * other
                            pxz = pxz + dx * dz * other
                            pyz = pyz + dy * dz * other
                        force = force + other
                    fx = fx + dx * force
                    fy = fy + dy * force
                    fz = fz + dz * force
            if adds:
                fx, fy, fz = fx + gather(f, i, 0), fy + gather(f, i, 1), fz + gather(f, i, 2)
            scatter(f, i, 0, fx)
            scatter(f, i, 1, fy)
            scatter(f, i, 2, fz)
            if share:
                at = count_up(LANES * b, LANES) * splat_whole(SHARES, LANES)
                give_all(pair_shares, at, pe + te, pxx, pyy, pzz, pxy, pxz, pyz)
                give_all(bond_shares, at, be, bxx, byy, bzz, bxy, bxz, byz)
                pe = be = te = splat(0.0, LANES)
                pxx = pyy = pzz = pxy = pxz = pyz = splat(0.0, LANES)
                bxx = byy = bzz = bxy = bxz = byz = splat(0.0, LANES)
        if watched:
            noted[0] = notes
        if tally and not share:  # each pair was met at both ends
            sums[0] = 0.5 * total(pe)
            sums[1] = 0.5 * total(be)
            sums[2] = 0.5 * total(te)
            sums[3] = 0.5 * total(pxx)
            sums[4] = 0.5 * total(pyy)
            sums[5] = 0.5 * total(pzz)
            sums[6] = 0.5 * total(pxy)
            sums[7] = 0.5 * total(pxz)
            sums[8] = 0.5 * total(pyz)
            sums[9] = 0.5 * total(bxx)
            sums[10] = 0.5 * total(byy)
            sums[11] = 0.5 * total(bzz)
            sums[12] = 0.5 * total(bxy)
            sums[13] = 0.5 * total(bxz)
            sums[14] = 0.5 * total(byz)
        return float(breaks)

    return forces
