"""Unit systems: LAMMPS's conversion constants. Source: read from LAMMPS 22 Jul 2025 by its extract_global interface."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Units:
    """Constants of one unit system.

    boltz    Boltzmann's constant, energy per temperature
    mvv2e    mass velocity^2 to energy
    ftm2v    force time/mass to velocity
    mv2d     mass/volume to density
    nktv2p   N k T/V to pressure
    qqr2e    charge^2/distance to energy
    angstrom   one Angstrom in distance units
    dt skin  defaults of timestep and neighbor
    norm     default of thermo_modify norm
    """

    name: str
    boltz: float
    mvv2e: float
    ftm2v: float
    mv2d: float
    nktv2p: float
    qqr2e: float
    angstrom: float
    dt: float
    skin: float
    norm: bool = False


_48 = 48.88821291  # its square: grams/mole (Angstrom/femtosecond)^2 in kcal/mole
_MV2D = 1.0 / 0.602214129

UNITS = {
    units.name: units
    for units in (
        Units("lj", 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.005, 0.3, norm=True),
        Units("real", 0.0019872067, _48 * _48, 1.0 / (_48 * _48), _MV2D, 68568.415, 332.06371, 1.0, 1.0, 2.0),
        Units("metal", 8.617343e-5, 1.0364269e-4, 1.0 / 1.0364269e-4, _MV2D, 1.6021765e6, 14.399645, 1.0, 0.001, 2.0),
        Units("si", 1.3806504e-23, 1.0, 1.0, 1.0, 1.0, 8.9876e9, 1.0e-10, 1.0e-8, 0.001),
        Units("cgs", 1.3806504e-16, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0e-8, 1.0e-8, 0.1),
        Units("electron", 3.16681534e-6, 1.06657236, 0.937582899, 1.0, 2.94210108e13, 1.0, 1.88972612, 0.001, 2.0),
        Units("micro", 1.3806504e-8, 1.0, 1.0, 1.0, 1.0, 8.987556e6, 1.0e-4, 2.0, 0.1),
        Units("nano", 0.013806504, 1.0, 1.0, 1.0, 1.0, 230.7078669, 0.1, 0.00045, 0.1),
    )
}
