"""The pair loop: every listed pair once (newton on) or once per owned end, in list order."""

from __future__ import annotations

from pylmp.kernels.exact import INDEX_MASK, SPECIAL_SHIFT, coefficients, give_share
from pylmp.kernels.kinds import Function


def pair_loop(
    law: Function, width: int, *, newton: bool, velocity: bool, one_type: bool, weighted: bool, tally: bool,
    tabled: bool = False, watch: Function = None, last: bool = True, share: bool = False, fdotr: bool = True,
) -> Function:  # fmt: skip
    """Compose the loop of one scene around law(r2, dot, factor, c) -> (force over r, energy).

    tabled  c ends with data, a table that the law looks things up in
    watch   None, or watch(r2, c) -> this pair must be reported
    share   each atom gets its share of energy and virial
    fdotr   with newton on, the virial is summed over the forces on all atoms at the end, not over pairs
    last    of the styles that act one after the other: the virial is summed over the forces of all

    The law is evaluated for every listed pair and yields zero beyond its cutoff: without the unpredictable branch the
    loop is 1.65 times faster, and adding zeros changes nothing, as long as they are zeros.
    """
    load = coefficients(width, tabled)
    watched = watch is not None

    def forces(
        x: "f8*", v: "f8*", f: "f8*", type_: "i8*", first: "i8*", neighbors: "i4*", table: "f8*", types: "i8",
        data: "f8*", weights: "f8*", virial: "f8*", shares: "f8*", noted: "i8*", n: "i8",
        total: "i8",
    ) -> "f8":
        """Add pair forces to f (owned and ghost rows); returns the energy, adds to virial (6) when tallying.

        shares: (rows, SHARES) added to where each atom gets its share. noted: how many pairs must be reported, and the two rows
        of the first.
        """
        energy = 0.0
        c = load(table, (types + 1) * width, data, table, 0)
        for i in range(n):
            xi = x[3 * i]
            yi = x[3 * i + 1]
            zi = x[3 * i + 2]
            fx = f[3 * i]
            fy = f[3 * i + 1]
            fz = f[3 * i + 2]
            ti = type_[i] * types
            for q in range(first[i], first[i + 1]):
                j = int(neighbors[q])
                factor = 1.0
                if weighted:
                    factor = weights[(j >> SPECIAL_SHIFT) & 3]
                    j = j & INDEX_MASK
                dx = xi - x[3 * j]
                dy = yi - x[3 * j + 1]
                dz = zi - x[3 * j + 2]
                r2 = dx * dx + dy * dy + dz * dz
                if not r2 < 1.0e300:  # no number: zero times it would be none either
                    continue
                dot = 0.0
                if velocity:
                    dot = (
                        dx * (v[3 * i] - v[3 * j])
                        + dy * (v[3 * i + 1] - v[3 * j + 1])
                        + dz * (v[3 * i + 2] - v[3 * j + 2])
                    )
                if not one_type:
                    c = load(table, (ti + type_[j]) * width, data, table, 0)
                if watched:
                    if watch(r2, c):
                        if noted[0] == 0:
                            noted[1] = i
                            noted[2] = j
                        noted[0] += 1
                force, e = law(r2, dot, factor, c)
                fx += dx * force
                fy += dy * force
                fz += dz * force
                if newton or j < n:
                    f[3 * j] -= dx * force
                    f[3 * j + 1] -= dy * force
                    f[3 * j + 2] -= dz * force
                if tally:
                    if newton:
                        energy += e
                        if not fdotr:
                            virial[0] += dx * dx * force
                            virial[1] += dy * dy * force
                            virial[2] += dz * dz * force
                            virial[3] += dx * dy * force
                            virial[4] += dx * dz * force
                            virial[5] += dy * dz * force
                    else:
                        ends = 2 if j < n else 1
                        for _ in range(ends):
                            energy += 0.5 * e
                            virial[0] += 0.5 * (dx * dx * force)
                            virial[1] += 0.5 * (dy * dy * force)
                            virial[2] += 0.5 * (dz * dz * force)
                            virial[3] += 0.5 * (dx * dy * force)
                            virial[4] += 0.5 * (dx * dz * force)
                            virial[5] += 0.5 * (dy * dz * force)
                if share:
                    give_share(shares, i, e, force, dx, dy, dz)
                    if newton or j < n:
                        give_share(shares, j, e, force, dx, dy, dz)
            f[3 * i] = fx
            f[3 * i + 1] = fy
            f[3 * i + 2] = fz
        if tally and newton and fdotr and last:
            xx = yy = zz = xy = xz = yz = 0.0
            for i in range(total):
                xx += x[3 * i] * f[3 * i]
                yy += x[3 * i + 1] * f[3 * i + 1]
                zz += x[3 * i + 2] * f[3 * i + 2]
                xy += x[3 * i] * f[3 * i + 1]
                xz += x[3 * i] * f[3 * i + 2]
                yz += x[3 * i + 1] * f[3 * i + 2]
            virial[0] += xx
            virial[1] += yy
            virial[2] += zz
            virial[3] += xy
            virial[4] += xz
            virial[5] += yz
        return energy

    return forces
