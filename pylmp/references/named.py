"""Functions of formulas whose arguments are names: groups, regions, files, computes, features."""

from __future__ import annotations

import platform
import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model.paths import readable
from pylmp.references import features, group_functions, vectors
from pylmp.references.atom_values import by_tag
from pylmp.text.diagnostic import ScriptError
from pylmp.text.formula_error import FormulaError
from pylmp.text.words import Word

if TYPE_CHECKING:
    from pylmp.references.scope import Scope

_KINDS = ("atom", "bond", "angle", "dihedral", "improper")
_SPECIAL = "Invalid special function in variable formula"


def value(scope: Scope, function: str, names: tuple[str, ...], mode: str) -> Any:
    """A number; of gmask and its like one for each owned atom; of sort and rsort a vector."""
    if function in group_functions.FUNCTIONS:
        return group_functions.value(scope.sim, function, names)
    if function in vectors.FUNCTIONS:
        return vectors.value(scope, function, names, mode)
    return _OTHERS[function](scope, names, mode)


def _mask(function: str) -> Callable[..., Any]:
    def mask(scope: Scope, names: tuple[str, ...], mode: str) -> Any:
        """1 for atoms that are in the group, in the region, or in both."""
        sim = scope.sim
        if mode == "equal":
            raise FormulaError(f"{function.capitalize()} function in equal-style variable formula")
        if mode == "vector":
            raise ScriptError("Atom vector in vector-style variable formula")
        if len(names) != (2 if function == "grmask" else 1):
            raise FormulaError(_SPECIAL)
        inside = np.ones(sim.atoms.n, bool)
        if function != "rmask":
            bit = sim.groups.bit(names[0])
            if not bit:
                raise FormulaError("Group ID in variable formula does not exist", hint=f"groups: {' '.join(sim.groups.names)}")
            inside &= (sim.atoms.mask[: sim.atoms.n] & bit) != 0
        if function != "gmask":
            inside &= group_functions.region(sim, names[-1]).inside(sim.atoms.x[: sim.atoms.n])
        return inside.astype(float)

    return mask


def _next(scope: Scope, names: tuple[str, ...], mode: str) -> Any:
    """The current value of a file-style or atomfile-style variable, which then advances."""
    if len(names) != 1:
        raise FormulaError(_SPECIAL)
    (name,) = names
    variable = scope.variables.known.get(name)
    if variable is None:
        raise ScriptError(f"Variable ID '{name}' in variable formula does not exist")
    if variable.style not in ("file", "atomfile"):
        raise ScriptError(f"Variable {name}: Invalid variable style in special function next", hint="file or atomfile")
    if variable.style == "file":
        result: Any = scope.variables.number(name, scope)
    elif mode != "atom":
        raise ScriptError(f"Variable {name}: Atomfile variable in {mode}-style variable formula")
    else:
        result = by_tag(scope.sim, *variable.table)
    if not variable.advance():
        scope.variables.forget(name)
    return result


def _is_file(scope: Scope, names: tuple[str, ...], mode: str) -> float:
    if len(names) != 1:
        raise FormulaError("Invalid is_file() function in variable formula")
    try:
        return float(readable(scope.sim, Word(names[0])).is_file())
    except (OSError, ValueError):
        return 0.0


def _is_os(scope: Scope, names: tuple[str, ...], mode: str) -> float:
    if len(names) != 1:
        raise FormulaError("Invalid is_os() function in variable formula")
    try:
        name = f' "{platform.freedesktop_os_release()["PRETTY_NAME"]}"'
    except OSError:
        name = ""
    described = f"{platform.system()}{name} {platform.release()} {platform.machine()}"
    try:
        return float(re.search(names[0], described) is not None)
    except re.error:
        return 0.0


def _is_timeout(scope: Scope, names: tuple[str, ...], mode: str) -> float:
    if names != ("",):
        raise FormulaError("Invalid is_timeout() function in variable formula")
    return float(scope.sim.timer.passed)


def _label(function: str) -> Callable[..., float]:
    def label(scope: Scope, names: tuple[str, ...], mode: str) -> float:
        """The type that a label stands for, or whether it stands for one."""
        labels = scope.sim.labels
        if not labels.in_use:
            raise FormulaError(f"Cannot use {function}() function without a labelmap")
        if len(names) < 2:
            raise FormulaError(f"Invalid {function}({names[0]}) function in variable formula")
        kind, text = names[0], ",".join(names[1:])
        if kind not in _KINDS:
            raise FormulaError(f"Invalid kind {kind} in {function}() in variable", hint=" ".join(_KINDS))
        number = labels.number(kind, text)
        if function == "is_typelabel":
            return float(number > 0)
        if number == 0:
            raise FormulaError(f"Invalid {kind} type label {text} in {function}() in variable", hint=" ".join(labels.of(kind).values()))
        return float(number)

    return label


_OTHERS: dict[str, Callable[[Any, tuple[str, ...], str], Any]] = {
    "gmask": _mask("gmask"), "rmask": _mask("rmask"), "grmask": _mask("grmask"), "next": _next, "is_file": _is_file,
    "is_os": _is_os, "is_timeout": _is_timeout, "label2type": _label("label2type"), "is_typelabel": _label("is_typelabel"),
    "extract_setting": features.extract_setting, "is_active": features.is_active, "is_available": features.is_available,
    "is_defined": features.is_defined,
}  # fmt: skip
