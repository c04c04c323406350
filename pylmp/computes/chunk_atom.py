"""compute ID GROUP chunk/atom type | molecule | bin/1d DIM ORIGIN DELTA | bin/2d .. | bin/3d .. | bin/sphere X Y Z RMIN RMAX N |
c_ID | f_ID | v_NAME  [region R] [nchunk once|every] [limit N max|exact] [ids once|nfreq|every] [compress yes|no]
[discard yes|no|mixed] [bound DIM LO HI] [pbc yes|no] [units box|lattice|reduced]

Which chunk each atom belongs to, from 1; 0 for none. The scalar is the number of chunks. Source: LAMMPS manual, compute_chunk_atom.html.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.computes.chunk_options import Options, read_options
from pylmp.model.atom_inputs import AtomInput, read_atom_input
from pylmp.model.atoms import Floats, Ints
from pylmp.model.bins import Layers, Shells, Spacing
from pylmp.model.compute import Compute
from pylmp.model.reference import parse
from pylmp.model.region import named
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_BINS = {"bin/1d": 1, "bin/2d": 2, "bin/3d": 3}


@COMPUTES.register("chunk/atom")
class ChunkAtom(Compute):
    """layers: the bins of a bin style. source: the compute, fix or variable that gives IDs. compressed: IDs without gaps."""

    style = "chunk/atom"
    columns = 0

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        word = args.word()
        self.kind = word.text
        self.layers: Layers | Shells | None = None
        self.source: AtomInput | None = None
        if self.kind in _BINS:
            self.layers = Layers([Spacing.read(args) for _ in range(_BINS[self.kind])])
            axes = [spacing.axis for spacing in self.layers.spacings]
            if len(set(axes)) < len(axes) or any(spacing.delta <= 0.0 for spacing in self.layers.spacings):
                args.fail(f"Illegal compute chunk/atom {self.kind} command", word, hint="DIM ORIGIN DELTA, each dimension once")
        elif self.kind == "bin/sphere":
            self.layers = Shells.read(args)
        elif self.kind == "bin/cylinder":
            raise Unsupported("LAMMPS has compute chunk/atom bin/cylinder, pylmp's native engines do not", word.span)
        elif self.kind not in ("type", "molecule"):
            self.source = self._input(sim, args, word)
        self.options: Options = read_options(sim, args, self.layers is not None)
        if self.layers is not None:
            if sim.box.triclinic and self.options.units != "reduced":
                args.fail("Compute chunk/atom for triclinic boxes requires units reduced", args.owner, hint="units reduced")
            self.layers.scale(sim, self.options.units, self.options.bounds, self.options.pbc)
        self.compressed = self.options.compress
        self.once = self.options.once
        if self.once is None:  # every where the number of chunks may change by itself
            fixed = self.kind == "type" or (self.kind == "molecule" and not self.options.region)
            self.once = not self.compressed and (fixed or (self.layers is not None and self.options.units == "reduced"))
        self._count = self._numbered = -1
        self._checked = False
        self._original = np.zeros(0, np.int64)
        self._assigned: tuple[int, Ints] = (-1, np.zeros(0, np.int64))

    @property
    def coordinates(self) -> int:
        """Coordinates of a bin's middle; 0 where chunks are no bins."""
        return self.layers.coordinates if self.layers is not None else 0

    @staticmethod
    def _input(sim: Simulation, args: Args, word: Word) -> AtomInput:
        found = parse(word.text)
        if found is None or len(found.brackets) > 1 or "*" in word.text:
            hint = "type molecule bin/1d bin/2d bin/3d bin/sphere c_ID f_ID v_NAME"
            args.fail(f"Invalid compute chunk/atom argument {word.text}", word, hint=hint)
        odd = "compute chunk /atom" if found.kind == "c" else ""  # LAMMPS's own
        return read_atom_input(sim, args, word, owner=odd)

    def init(self, sim: Simulation) -> None:
        if self.options.region:
            named(sim, self.options.region, "compute chunk/atom")
        if self.source is not None:
            self.source.check(sim, "compute chunk/atom")
        self._numbered, self._assigned = -1, (-1, self._assigned[1])

    def setup(self, sim: Simulation) -> None:
        if self.once and self.layers is not None:
            self.number(sim)

    # ---- which atom is where ----------------------------------------------------------------------------------

    def number(self, sim: Simulation) -> int:
        """How many chunks: found once a step, or once for all where nchunk once says so."""
        if self._numbered == sim.step or (self._count >= 0 and self.once):
            return self._count
        self._numbered = sim.step
        if self.layers is not None:
            self.layers.lay(sim)
        if self.layers is not None and self._count >= 0 and not self.compressed:
            self._count = self.layers.count
            return self._count
        ids, inside = self._raw(sim), self._inside(sim)
        self._count = self._found(sim, ids, inside)
        if self.kind == "molecule" and not self._checked:
            self._checked = True
            if np.isin(ids[~inside & (ids > 0)], ids[inside]).any():
                sim.console.warning("One or more chunks do not contain all atoms in molecule")
        if self.compressed:
            self._original = np.unique(ids[inside])
            self._count = len(self._original)
        limit = self.options.limit
        if limit:
            self._count = limit if self.options.exact else min(self._count, limit)
        return self._count

    def assign(self, sim: Simulation) -> tuple[Ints, int]:
        """(n,) chunk of each owned atom, and the number of chunks: found once a step.

        As in LAMMPS atoms are put into bins again after they were counted, which matters with units reduced (model/bins.py).
        """
        count = self.number(sim)
        step, ids = self._assigned
        if step != sim.step or len(ids) != sim.atoms.n:
            ids, inside = self._raw(sim), self._inside(sim)
            if self.compressed:
                at = np.searchsorted(self._original, ids)
                known = at < len(self._original)
                known[known] = self._original[at[known]] == ids[known]
                inside, ids = inside & known, at + 1
            if self.layers is None and self.options.discard == "no":
                ids = np.minimum(ids, count)
            ids = np.where(inside & (ids > 0) & (ids <= count), ids, 0)
            self._assigned = sim.step, ids
        return ids, count

    def _inside(self, sim: Simulation) -> NDArray[np.bool_]:
        """(n,) owned atoms of the group that are inside the region now."""
        inside = self.members(sim)
        if self.options.region:
            inside &= named(sim, self.options.region, "compute chunk/atom").inside(sim.atoms.x[: sim.atoms.n])
        return np.asarray(inside)

    def _raw(self, sim: Simulation) -> Ints:
        """(n,) IDs before anything is left out; 0 outside all bins."""
        n = sim.atoms.n
        if self.kind == "type":
            return sim.atoms.type[:n].copy()
        if self.kind == "molecule":
            return sim.atoms.molecule[:n].copy()
        if self.layers is not None:
            return self.layers.place(sim, self.options.discard)
        assert self.source is not None
        return self.source.values(sim, np.arange(n), "compute chunk/atom").astype(np.int64)

    def _found(self, sim: Simulation, ids: Ints, inside: NDArray[np.bool_]) -> int:
        """The number of chunks before compression and limits."""
        if self.kind == "type":
            return sim.atom_types
        if self.layers is not None:
            return self.layers.count
        return int(ids[inside].max(initial=0))

    def original(self, sim: Simulation) -> Ints:
        return self._original[: self._count]

    def centers(self, sim: Simulation) -> Floats:
        assert self.layers is not None
        return self.layers.centers()[: self._count]  # also of compressed chunks, as LAMMPS does

    # ---- what it offers ---------------------------------------------------------------------------------------

    def scalar(self, sim: Simulation) -> float:
        """The number of chunks."""
        return float(self.assign(sim)[1])

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,) chunk of each atom."""
        return self.assign(sim)[0].astype(float)
