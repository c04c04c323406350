"""Unit systems: LAMMPS's conversion constants."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Units:
    """boltz: Boltzmann's constant; mvv2e: mass velocity^2 to energy; ftm2v: force time/mass to velocity;
    nktv2p: N k T/V to pressure; dt, skin: the defaults of timestep and neighbor; norm: thermo_modify norm's default."""

    name: str
    boltz: float
    mvv2e: float
    ftm2v: float
    nktv2p: float
    dt: float
    skin: float
    norm: bool


UNITS = {"lj": Units("lj", 1.0, 1.0, 1.0, 1.0, 0.005, 0.3, True)}
