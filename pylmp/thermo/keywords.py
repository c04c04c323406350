"""The keywords of thermo_style custom: column header, whether it is an integer, what it needs, how it is computed.

Names and meanings: LAMMPS manual, thermo_style.html. Normalised keywords are divided by the number of atoms where
thermo_modify norm is on. Products are written in the order that LAMMPS 22 Jul 2025 rounds in.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.asking import ENERGY
from pylmp.model.sums import total
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.thermo.table import Thermo

Value = Callable[["Thermo"], float]


@dataclass(frozen=True)
class Keyword:
    """whole: an integer column. needs, in the order of evaluation: letters of t (temperature), p (pressure), s (its tensor), e
    (potential energy), r (a run in progress)."""

    header: str
    value: Value
    whole: bool = False
    needs: str = ""


def _ke(t: Thermo) -> float:
    return t.per_atom(t.temperature() * (0.5 * t.dof() * t.sim.units.boltz))


def _pe(t: Thermo) -> float:
    return t.per_atom(t.potential())


def _etotal(t: Thermo) -> float:
    return _pe(t) + _ke(t)


def _enthalpy(t: Thermo) -> float:
    volume = t.per_atom(t.sim.box.volume)
    return _etotal(t) + t.pressure() * volume / t.sim.units.nktv2p


def _pair(t: Thermo) -> float:
    energy = t.sim.tally.pair
    if t.sim.pair and t.sim.pair.tail:
        energy += t.sim.pair.tails(t.sim)[0] / t.sim.box.volume
    return t.per_atom(energy)


def _tail(t: Thermo) -> float:
    if not t.sim.tally.has(ENERGY, t.sim.step):
        raise ScriptError("Energy was not tallied on needed timestep for thermo keyword etail", hint="use it on thermo steps")
    return t.per_atom(t.sim.pair.tails(t.sim)[0] / t.sim.box.volume) if t.sim.pair else 0.0


def _bond(t: Thermo) -> float:
    return t.per_atom(t.sim.tally.bond)


def _couple(t: Thermo) -> float:
    energy = 0.0
    for fix in t.sim.fixes:
        if getattr(fix, "couples", False):
            energy += fix.scalar(t.sim)  # type: ignore[attr-defined]
    return t.per_atom(energy)


def _density(t: Thermo) -> float:
    return t.sim.units.mv2d * total(t.sim.masses()) / t.sim.box.volume


def _force_max(t: Thermo) -> float:
    f = t.sim.atoms.f[: t.sim.atoms.n]
    return float(np.abs(f).max()) if len(f) else 0.0


def _force_norm(t: Thermo) -> float:
    f = t.sim.atoms.f[: t.sim.atoms.n]
    return math.sqrt(total(f[:, 0] * f[:, 0] + f[:, 1] * f[:, 1] + f[:, 2] * f[:, 2]))


def _lists(name: str) -> Value:
    return lambda t: getattr(t.sim.lists, name, 0)


def _length(d: int) -> Value:
    return lambda t: float(t.sim.box.length[d])


def _face(side: str, d: int) -> Value:
    return lambda t: float(getattr(t.sim.box, side)[d])


def _tilt(k: int) -> Value:
    return lambda t: float(t.sim.box.tilt[k])


def _cell_b(t: Thermo) -> float:
    h = t.sim.box.h
    return math.sqrt(h[1] * h[1] + h[5] * h[5])


def _cell_c(t: Thermo) -> float:
    h = t.sim.box.h
    return math.sqrt(h[2] * h[2] + h[3] * h[3] + h[4] * h[4])


def _angle(cosine: Value) -> Value:
    """In degrees; 90 of an orthogonal box."""
    return lambda t: math.acos(cosine(t)) * 180.0 / math.pi if t.sim.box.triclinic else 90.0


def _cos_alpha(t: Thermo) -> float:
    h = t.sim.box.h
    return float((h[5] * h[4] + h[1] * h[3]) / _cell_b(t) / _cell_c(t))


def _vector(which: int, d: int) -> Value:
    """A component of a cell vector: a along x, b in the xy plane."""
    at = {(0, 0): 0, (1, 1): 1, (2, 2): 2, (2, 1): 3, (2, 0): 4, (1, 0): 5}.get((which, d))
    return lambda t: 0.0 if at is None else float(t.sim.box.h[at])


def _spacing(d: int) -> Value:
    return lambda t: float(t.sim.spacing[d])


def _stress(component: int) -> Value:
    return lambda t: float(t.pressure_tensor()[component])


def _constant(value: float) -> Value:
    return lambda t: value


_zero = _constant(0.0)

KEYWORDS: dict[str, Keyword] = {
    "step": Keyword("Step", lambda t: t.sim.step, whole=True),
    "elapsed": Keyword("Elapsed", lambda t: t.sim.step - t.sim.output.first, whole=True, needs="r"),
    "elaplong": Keyword("Elaplong", lambda t: t.sim.step - t.sim.begin, whole=True, needs="r"),
    "dt": Keyword("Dt", lambda t: t.sim.dt),
    "time": Keyword("Time", lambda t: t.sim.output.time()),
    "cpu": Keyword("CPU", lambda t: t.cpu(), needs="r"),
    "tpcpu": Keyword("T/CPU", lambda t: t.pace("tpcpu", t.sim.output.time()), needs="r"),
    "spcpu": Keyword("S/CPU", lambda t: t.pace("spcpu", t.sim.step), needs="r"),
    "cpuremain": Keyword("CPULeft", lambda t: t.remaining(), needs="r"),
    "part": Keyword("Part", _zero, whole=True),
    "timeremain": Keyword("TimeoutLeft", lambda t: t.sim.timer.left),
    "atoms": Keyword("Atoms", lambda t: t.sim.atoms.n, whole=True),
    "temp": Keyword("Temp", lambda t: t.temperature(), needs="t"),
    "press": Keyword("Press", lambda t: t.pressure(), needs="p"),
    "pe": Keyword("PotEng", _pe, needs="e"),
    "ke": Keyword("KinEng", _ke, needs="t"),
    "etotal": Keyword("TotEng", _etotal, needs="te"),
    "evdwl": Keyword("E_vdwl", _pair, needs="e"),
    "ecoul": Keyword("E_coul", _zero, needs="e"),
    "epair": Keyword("E_pair", _pair, needs="e"),
    "ebond": Keyword("E_bond", _bond, needs="e"),
    "eangle": Keyword("E_angle", _zero, needs="e"),
    "edihed": Keyword("E_dihed", _zero, needs="e"),
    "eimp": Keyword("E_impro", _zero, needs="e"),
    "emol": Keyword("E_mol", _bond, needs="e"),
    "elong": Keyword("E_long", _zero, needs="e"),
    "etail": Keyword("E_tail", _tail),
    "enthalpy": Keyword("Enthalpy", _enthalpy, needs="tpe"),
    "ecouple": Keyword("Ecouple", _couple),
    "econserve": Keyword("Econserve", lambda t: _etotal(t) + _couple(t), needs="te"),
    "vol": Keyword("Volume", lambda t: t.sim.box.volume),
    "density": Keyword("Density", _density),
    "lx": Keyword("Lx", _length(0)),
    "ly": Keyword("Ly", _length(1)),
    "lz": Keyword("Lz", _length(2)),
    "xlo": Keyword("Xlo", _face("lo", 0)),
    "xhi": Keyword("Xhi", _face("hi", 0)),
    "ylo": Keyword("Ylo", _face("lo", 1)),
    "yhi": Keyword("Yhi", _face("hi", 1)),
    "zlo": Keyword("Zlo", _face("lo", 2)),
    "zhi": Keyword("Zhi", _face("hi", 2)),
    "xy": Keyword("Xy", _tilt(0)),
    "xz": Keyword("Xz", _tilt(1)),
    "yz": Keyword("Yz", _tilt(2)),
    "xlat": Keyword("Xlat", _spacing(0)),
    "ylat": Keyword("Ylat", _spacing(1)),
    "zlat": Keyword("Zlat", _spacing(2)),
    "bonds": Keyword("Bonds", lambda t: t.sim.bonds, whole=True),
    "angles": Keyword("Angles", lambda t: t.sim.angles, whole=True),
    "dihedrals": Keyword("Diheds", lambda t: t.sim.dihedrals, whole=True),
    "impropers": Keyword("Impros", lambda t: t.sim.impropers, whole=True),
    **{
        f"{name}vec{axis}": Keyword(f"{name.upper()}vec{axis}", _vector(which, d))
        for which, name in enumerate("abc")
        for d, axis in enumerate("xyz")
    },
    "cella": Keyword("Cella", _length(0)),
    "cellb": Keyword("Cellb", _cell_b),
    "cellc": Keyword("Cellc", _cell_c),
    "cellalpha": Keyword("CellAlpha", _angle(_cos_alpha)),
    "cellbeta": Keyword("CellBeta", _angle(lambda t: float(t.sim.box.h[4] / _cell_c(t)))),
    "cellgamma": Keyword("CellGamma", _angle(lambda t: float(t.sim.box.h[5] / _cell_b(t)))),
    "pxx": Keyword("Pxx", _stress(0), needs="s"),
    "pyy": Keyword("Pyy", _stress(1), needs="s"),
    "pzz": Keyword("Pzz", _stress(2), needs="s"),
    "pxy": Keyword("Pxy", _stress(3), needs="s"),
    "pxz": Keyword("Pxz", _stress(4), needs="s"),
    "pyz": Keyword("Pyz", _stress(5), needs="s"),
    "nbuild": Keyword("Nbuild", _lists("builds"), whole=True),
    "ndanger": Keyword("Ndanger", _lists("dangerous"), whole=True),
    "fmax": Keyword("Fmax", _force_max),
    "fnorm": Keyword("Fnorm", _force_norm),
}
