"""Many molecules of two atoms, each with a length of its own, far from each other: one set-up evaluates a law at all of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tests.hard.laws import Case
from tests.support import frames

APART = 8.0  # between molecules: beyond all cutoffs, a power of two


def script(case: Case, r: np.ndarray, folder: Path, before: np.ndarray | None = None) -> str:
    """It writes the forces on atoms of molecules of lengths r; its data file goes into folder.

    before: lengths at the first evaluation, which bonds may remember (1 if not given).
    """
    remembers = bool(case.memory)
    many = len(r)
    first = (np.ones(many) if before is None else before) if remembers else r
    wide = int(np.ceil(np.sqrt(many)))
    y, z = APART * (np.arange(many) % wide), APART * (np.arange(many) // wide)
    atoms = [
        f"{2 * k + 1} {k + 1} 1 0 {y[k]:g} {z[k]:g}\n{2 * k + 2} {k + 1} 1 {x!r} {y[k]:g} {z[k]:g}"
        for k, x in enumerate(first.tolist())
    ]
    bonds = [f"{k + 1} 1 {2 * k + 1} {2 * k + 2}" for k in range(many)] if case.kind == "bond" else []
    side = APART * wide
    text = f"two atoms\n\n{2 * many} atoms\n1 atom types\n" + (f"{many} bonds\n1 bond types\n" if bonds else "")
    text += f"-4 12 xlo xhi\n-4 {side} ylo yhi\n-4 {side} zlo zhi\n\nMasses\n\n1 1\n\nAtoms # bond\n\n" + "\n".join(atoms) + "\n"
    text += "\nBonds\n\n" + "\n".join(bonds) + "\n" if bonds else ""
    (folder / "pairs.data").write_text(text)
    special = "lj 0 1 1 coul 1 1 1" if remembers else "lj/coul 1 1 1"
    pairs = case.script if case.kind == "pair" else ("pair_style zero 3.0", "pair_coeff * *")
    style, coeff = case.script if bonds else ("bond_style zero", "")
    lines = [
        "units lj", "atom_style bond", "boundary f f f", "atom_modify map array sort 0 0", "comm_modify vel yes cutoff 4", "newton on off",
        f"special_bonds {special}", pairs[0], "read_data pairs.data", pairs[1], *([style] if bonds else []), coeff, "fix 1 all nve",
    ]  # fmt: skip
    if remembers:
        values = "\n".join(f"{2 * k + 2} {x!r}" for k, x in enumerate(r.tolist()))
        (folder / "lengths.txt").write_text(f"{many}\n{values}\n")
        lines += ["run 0", "variable r atomfile lengths.txt", "variable at atom (id%2==0)*v_r+(id%2==1)*x", "set group all x v_at"]
    lines += ["dump 1 all custom 1 forces.dump id fx", "dump_modify 1 sort id format float %.17g", "run 0"]
    return "\n".join(lines) + "\n"


def forces(folder: Path) -> np.ndarray:
    """Of the second atom of each molecule, along x, as the run wrote them."""
    return frames(folder / "forces.dump")[-1][2][1::2, 1]


def expected(case: Case, r: np.ndarray) -> np.ndarray:
    """Force along x on the second atom of each molecule: law times separation, rounded as every program must.

    Bonds bpm do not break in a set-up, however long they are: their smoothing factor turns the force around then.
    """
    with np.errstate(all="ignore"):
        force, _, holds = case.at(r * r, case.c)
        return np.where(np.broadcast_to(holds, r.shape) | bool(case.memory), r * force, 0.0)
