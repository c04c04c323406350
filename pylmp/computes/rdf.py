"""compute ID GROUP rdf NBIN [I1 J1 I2 J2 ...] [cutoff R]: radial distribution functions of pairs of types, and their integrals.

A row a bin: its middle, then g(r) and the number of neighbors up to there for each pair of type ranges; none: all with all.
g = count / (shell/V N_i (N_j - duplicates/N_i)). Source: LAMMPS manual, compute_rdf.html.
"""

from __future__ import annotations

import math

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.occasional import listed_pairs
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.wish import Wish
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest
from pylmp.text.words import Args


@COMPUTES.register("rdf")
class RadialDistribution(Compute):
    style = "rdf"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        self.bins = self.length = args.integer()
        if self.bins <= 0:
            args.fail("Number of bins for compute rdf must be > 0", hint="a positive number")
        texts = [word.text for word in args.words]
        count = (texts.index("cutoff") if "cutoff" in texts else len(texts)) - args.at
        if count % 2:
            args.fail("Must provide atom types in pairs for compute rdf command", args.peek(), hint="I1 J1 I2 J2")
        types = [args.types(sim.atom_types) for _ in range(count)]
        everything = range(1, sim.atom_types + 1)
        self.ranges = list(zip(types[::2], types[1::2], strict=True)) or [(everything, everything)]
        self.columns = 1 + 2 * len(self.ranges)
        self.cutoff = 0.0
        while len(args):
            key = args.word()
            if key.text != "cutoff":
                args.fail(f"Unknown compute rdf keyword {key.text}", key, hint="cutoff R")
            args.need(1, key.text)
            self.cutoff = max(args.number(), 0.0)

    def wish(self, sim: Simulation) -> Wish:
        return Wish(cutoff=self.cutoff + sim.neighbor.skin if self.cutoff > 0.0 else 0.0)

    def init(self, sim: Simulation) -> None:
        if self.cutoff > 0.0:
            far, reach = self.cutoff + sim.neighbor.skin, ghost_cutoff(sim)
            if far > reach:
                raise ScriptError(
                    f"Compute rdf cutoff plus skin {shortest(far)} exceeds ghost atom range {shortest(reach)} - use comm_modify cutoff "
                    "command to increase it", hint=f"comm_modify cutoff {far:g}",
                )  # fmt: skip
        if self.cutoff == 0.0 and sim.pair is None:
            raise ScriptError("Compute rdf requires a pair style or an explicit cutoff", hint="pair_style comes first")
        members = self.members(sim)
        self.counts = np.bincount(sim.atoms.type[: sim.atoms.n][members], minlength=sim.atom_types + 1)
        self.atoms = sim.natoms

    def array(self, sim: Simulation) -> Floats:
        """(bins, 1 + 2 pairs of ranges)"""
        if sim.natoms != self.atoms:
            self.init(sim)
        width = (self.cutoff if self.cutoff > 0.0 else float(sim.pair.cut.max())) / self.bins
        table = np.zeros((self.bins, self.columns))
        table[:, 0] = (np.arange(self.bins) + 0.5) * width
        for m, (first, second) in enumerate(zip(*self._pairs(sim, width), strict=True)):
            table[:, 1 + 2 * m : 3 + 2 * m] = self._normalized(sim, m, first + second, width)
        return table

    def _pairs(self, sim: Simulation, width: float) -> tuple[list[Floats], list[Floats]]:
        """Histograms for each pair of ranges: of pairs i-j as listed, and of the same pairs seen from j."""
        pairs, atoms = listed_pairs(sim, self.wish(sim)), sim.atoms
        weights = np.array([[1.0, *sim.special.lj], [1.0, *sim.special.coul]])[:, pairs.kind]
        mine = (atoms.mask & self.bit) != 0
        bin_of = (np.sqrt(pairs.r2) * (1.0 / width)).astype(np.int64)
        take = mine[pairs.i] & mine[pairs.j] & (bin_of < self.bins) & (weights != 0.0).any(axis=0)
        pairs, bin_of = pairs.take(take), bin_of[take]
        one, other = atoms.type[pairs.i], atoms.type[pairs.j]
        both = (pairs.j < atoms.n) if not sim.newton_pair else np.ones(len(bin_of), bool)
        result: tuple[list[Floats], list[Floats]] = ([], [])
        for a, b in self.ranges:
            for store, i, j, chosen in ((result[0], one, other, True), (result[1], other, one, both)):
                inside = (i >= a.start) & (i < a.stop) & (j >= b.start) & (j < b.stop) & chosen
                store.append(np.bincount(bin_of[inside], minlength=self.bins).astype(float))
        return result

    def _normalized(self, sim: Simulation, m: int, histogram: Floats, width: float) -> Floats:
        """(bins, 2) g(r) and its running integral."""
        a, b = self.ranges[m]
        some, others = int(self.counts[a.start : a.stop].sum()), int(self.counts[b.start : b.stop].sum())
        common = int(self.counts[max(a.start, b.start) : max(min(a.stop, b.stop), max(a.start, b.start))].sum())
        free = float(others) - float(common) / some if some > 0 else 0.0
        x, y, z = (float(side) for side in sim.box.length)
        constant = 4.0 * math.pi / (3.0 * x * y * z) if sim.dimension == 3 else math.pi / (x * y)
        result = np.zeros((self.bins, 2))
        near = 0.0
        for k in range(self.bins):
            low, high = k * width, (k + 1) * width
            shell = constant * (high * high * high - low * low * low if sim.dimension == 3 else high * high - low * low)
            g = float(histogram[k]) / (shell * free * some) if shell * free != 0.0 else 0.0
            if some:
                near += g * shell * free
            result[k] = g, near
        return result
