"""is_active() is_available() is_defined() extract_setting(): what formulas may ask of the program and its state.

Source: LAMMPS manual, variable.html and Library_properties.html.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NoReturn

from pylmp.model.registry import BONDS, COMMANDS, COMPUTES, DUMPS, FIXES, PAIRS, REGIONS, Registry
from pylmp.model.unknown import is_elsewhere
from pylmp.text.diagnostic import ScriptError
from pylmp.text.formula_error import FormulaError

if TYPE_CHECKING:
    from pylmp.references.scope import Scope

_PACKAGES = ("gpu", "intel", "kokkos", "omp")
_REGISTRIES: dict[str, Registry[Any]] = {
    "command": COMMANDS, "compute": COMPUTES, "fix": FIXES, "pair": PAIRS, "bond": BONDS, "dump": DUMPS, "region": REGIONS,
}  # fmt: skip
_ROOM = 16384  # LAMMPS makes room for so many atoms at a time
_FLAGS = "mu rmass radius ellipsoid omega torque angmom peri".split()


def _two(function: str, names: tuple[str, ...]) -> tuple[str, str]:
    if len(names) != 2:
        raise FormulaError(f"Invalid {function}() function in variable formula")
    return names[0], names[1]


def _unknown(function: str, category: str) -> NoReturn:
    raise ScriptError(f"Unknown category for info {function}(): {category}", manual="variable.html")


def is_defined(scope: Scope, names: tuple[str, ...], mode: str) -> float:
    """Is there something of that category by that name."""
    category, name = _two("is_defined", names)
    sim = scope.sim
    known: dict[str, Any] = {
        "compute": sim.computes, "dump": sim.output.dumps, "fix": [fix.id for fix in sim.fixes], "group": sim.groups.names,
        "region": sim.regions, "variable": scope.variables.known,
    }  # fmt: skip
    if category not in known:
        _unknown("is_defined", category)
    return float(name in known[category])


def is_available(scope: Scope, names: tuple[str, ...], mode: str) -> float:
    """Does this program have it: a compute, a fix, a command, a feature."""
    category, name = _two("is_available", names)
    if category == "feature":
        return float(name in ("gzip", "exceptions"))
    registry = _REGISTRIES.get(category)
    if registry is None or (registry.find(name) is None and not is_elsewhere(category, name)):
        _unknown("is_available", category)  # as LAMMPS says of styles too that it does not have
    return float(registry.find(name) is not None)


_RESPA = ("lj/cut", "zero")  # pair styles that LAMMPS can split for run_style respa


def is_active(scope: Scope, names: tuple[str, ...], mode: str) -> float:
    """Is a setting in force."""
    category, name = _two("is_active", names)
    sim = scope.sim
    if category == "package":
        if name not in _PACKAGES:
            raise ScriptError(f"Unknown name for info package category: {name}", hint=" ".join(_PACKAGES))
        return 0.0
    if category == "newton":
        states = {"pair": sim.newton_pair, "bond": sim.newton_bond, "any": sim.newton_pair or sim.newton_bond}
    elif category == "pair":
        pair = sim.pair
        if pair is None:
            return 0.0
        states = {"single": True, "respa": pair.name in _RESPA, "manybody": False, "tail": bool(pair.tail), "shift": pair.settings.shift}
    else:
        return _style(sim, category, name)
    if name not in states:
        raise ScriptError(f"Unknown name for info {category} category: {name}", hint=" ".join(states))
    return float(states[name])


def _style(sim: Any, category: str, name: str) -> float:
    bond = (sim.bond.parts[0].style.name if len(sim.bond.parts) == 1 else "hybrid") if sim.bond else "none"
    styles = {
        "comm_style": sim.communication, "min_style": sim.minimizing.style, "run_style": "verlet", "atom_style": sim.atom_style, "pair_style": sim.pair.name if sim.pair else "none",
        "bond_style": bond, "kspace_style": "none",
    }  # fmt: skip
    for kind in ("angle", "dihedral", "improper"):
        style = getattr(sim, kind)
        styles[f"{kind}_style"] = style.name if style else "none"
    if category not in styles:
        _unknown("is_active", category)
    return float(styles[category] == name)


def extract_setting(scope: Scope, names: tuple[str, ...], mode: str) -> float:
    """The numbers of LAMMPS's library function of that name."""
    if len(names) != 1:
        raise FormulaError("Invalid extract_setting() function in variable formula")
    sim, atoms = scope.sim, scope.sim.atoms
    known = {
        "bigint": 8, "tagint": 4, "imageint": 4, "box_exist": int(sim.has_box), "dimension": sim.dimension,
        "ntypes": sim.atom_types, "nbondtypes": sim.bond_types, "nangletypes": sim.angle_types, "ndihedraltypes": sim.dihedral_types,
        "nimpropertypes": sim.improper_types,
        "nlocal": atoms.n, "nghost": atoms.ghosts, "nall": atoms.total, "nmax": math.ceil(atoms.total / _ROOM) * _ROOM or 1,
        "world_size": 1, "world_rank": 0, "universe_size": 1, "universe_rank": 0, "comm_mode": 0, "nthreads": 1,
        "newton_bond": int(sim.newton_bond), "newton_pair": int(sim.newton_pair), "triclinic": 0, "kokkos_active": 0,
        "kokkos_nthreads": 0, "kokkos_ngpus": 0, "molecule_flag": int(sim.has_bonds), **{f"{name}_flag": 0 for name in _FLAGS},
        "q_flag": int(sim.style.charged),
    }  # fmt: skip
    if names[0] not in known:
        raise FormulaError(f"Unknown setting {names[0]} for extract_setting() function in variable formula")
    return float(known[names[0]])
