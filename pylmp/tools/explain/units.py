"""What units are called in each unit system. Source: LAMMPS manual, units.html."""

from __future__ import annotations

import re

_KINDS = ("mass", "distance", "time", "energy", "velocity", "force", "temperature", "pressure")
_NAMES = {
    "lj": ("m", "sigma", "tau", "epsilon", "sigma/tau", "epsilon/sigma", "epsilon/kB", "epsilon/sigma^3"),
    "real": ("g/mol", "Angstrom", "fs", "kcal/mol", "Angstrom/fs", "(kcal/mol)/Angstrom", "K", "atm"),
    "metal": ("g/mol", "Angstrom", "ps", "eV", "Angstrom/ps", "eV/Angstrom", "K", "bar"),
    "si": ("kg", "m", "s", "J", "m/s", "N", "K", "Pa"),
    "cgs": ("g", "cm", "s", "erg", "cm/s", "dyn", "K", "dyn/cm^2"),
    "electron": ("amu", "Bohr", "fs", "Hartree", "Bohr/atu", "Hartree/Bohr", "K", "Pa"),
    "micro": ("pg", "um", "us", "pg um^2/us^2", "um/us", "pg um/us^2", "K", "pg/(um us^2)"),
    "nano": ("ag", "nm", "ns", "ag nm^2/ns^2", "nm/ns", "ag nm/ns^2", "K", "ag/(nm ns^2)"),
}


def named(unit: str, system: str) -> str:
    """A unit of a form or a coefficient ("force/distance") in the words of a system ("eV/Angstrom/Angstrom"); "" if it has none.

    distance* is a distance in lattice spacings; steps, degrees and the like stay as they are.
    """
    if unit in ("", "unitless"):
        return ""
    if unit == "distance*":
        return "lattice spacings"
    names = dict(zip(_KINDS, _NAMES[system], strict=True))
    alone = unit in names

    def word(found: re.Match[str]) -> str:
        name = names.get(found[0], found[0])
        return name if alone or not re.search(r"[/ ^]", name) else f"({name})"

    return re.sub(r"[a-z]+", word, unit)
