"""What atoms of an atom style carry beyond ID, type, position, velocity. Source: LAMMPS manual, atom_style.html, read_data.html."""

from __future__ import annotations

from dataclasses import dataclass

from pylmp.model.topology import ANGLE, BOND, DIHEDRAL, IMPROPER, KINDS, Kind


@dataclass(frozen=True)
class AtomStyle:
    """columns: of a line of a data file before x y z, by their names in model/atoms.py; after: behind x y z; kinds: what is stored."""

    name: str
    columns: tuple[str, ...]
    kinds: tuple[Kind, ...] = ()
    after: tuple[str, ...] = ()

    @property
    def charged(self) -> bool:
        return "q" in self.columns + self.after


_PLAIN, _MOLECULE = ("tag", "type"), ("tag", "molecule", "type")
ATOM_STYLES = {
    style.name: style
    for style in (
        AtomStyle("atomic", _PLAIN),
        AtomStyle("charge", (*_PLAIN, "q")),
        AtomStyle("bond", _MOLECULE, (BOND,)),
        AtomStyle("angle", _MOLECULE, (BOND, ANGLE)),
        AtomStyle("molecular", _MOLECULE, KINDS),
        AtomStyle("full", (*_MOLECULE, "q"), KINDS),
    )
}
assert KINDS == (BOND, ANGLE, DIHEDRAL, IMPROPER)
