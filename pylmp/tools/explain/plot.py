"""Energy and force of a bond or pair style against distance, drawn with matplotlib (an extra)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.registry import BONDS, PAIRS
from pylmp.model.style import BondStyle, PairStyle
from pylmp.text.diagnostic import ScriptError

# Coefficients to draw with when none are given: those of the manual's examples, in lj units where it has any.
EXAMPLES: dict[tuple[str, str], tuple[float, ...]] = {
    ("bond_style", "quartic"): (1200.0, -0.55, 0.25, 1.3, 34.6878), ("bond_style", "fene"): (30.0, 1.5, 1.0, 1.0),
    ("bond_style", "fene/expand"): (30.0, 1.5, 1.0, 1.0, 0.5), ("bond_style", "harmonic"): (80.0, 1.2), ("bond_style", "morse"): (1.0, 2.0, 1.2),
    ("bond_style", "nonlinear"): (100.0, 1.1, 1.4), ("bond_style", "gromos"): (80.0, 1.2), ("bond_style", "harmonic/shift"): (10.0, 0.5, 1.0),
    ("bond_style", "harmonic/shift/cut"): (10.0, 0.5, 1.0), ("bond_style", "bpm/spring"): (1.0, 0.05, 0.1),
    ("bond_style", "bpm/spring/plastic"): (1.0, 0.1, 0.0, 0.02), ("pair_style", "lj/cut"): (1.0, 1.0), ("pair_style", "lj/expand"): (1.0, 1.0, 0.5),
    ("pair_style", "morse"): (1.0, 5.0, 1.0), ("pair_style", "soft"): (10.0,), ("pair_style", "bpm/spring"): (1.0, 1.0, 0.0),
}  # fmt: skip
_LENGTHS = ("r0", "Rc", "R0", "rc", "sigma", "delta")  # coefficients that are places on the axis
_CUT = 2.5


def curve(kind: str, name: str, coeffs: list[float] | None) -> tuple[Floats, Floats, Floats, dict[str, float]]:
    """(n,) distances, energies, forces (positive: repulsive), and the places to mark. Raises ScriptError for styles without one law."""
    style = (BONDS if kind == "bond_style" else PAIRS).find(name) if kind in ("bond_style", "pair_style") else None
    if style is None or style.law is None or getattr(style, "data", None) or (style.read is not None and isinstance(style, BondStyle)):
        raise ScriptError(f"{kind} {name} has no one curve to draw", hint="a bond_style or pair_style with a formula")
    alias = {"quartic/breakable": "quartic", "quartic/unbreakable": "quartic"}.get(name, name)
    given = tuple(coeffs) if coeffs else EXAMPLES.get((kind, alias), (0.0,) * 0)
    names = [one.name for one in style.coeffs]
    if len(given) < len(names) - getattr(style, "optional_coeffs", 0):
        raise ScriptError(f"{kind} {name} needs coefficients to be drawn", hint=f"--coeffs {' '.join(names)}")
    given = (*given, *(0.0,) * (len(names) - len(given)))
    said = dict(zip(names, given, strict=False))
    marks = {label: value for label, value in said.items() if label in _LENGTHS and value > 0.0}
    marks |= {f"Rc + {label}": said["Rc"] + said[label] for label in ("B1", "B2") if {"Rc", label} <= said.keys()}
    with np.errstate(all="ignore"):
        if isinstance(style, BondStyle):
            return *_bond(style, given, marks), marks
        return *_pair(style, given, marks), marks


def _options(style: Any) -> dict[str, Any]:
    from pylmp.model.console import Console
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args

    return dict(style.parse(Simulation(Console()), Args(style.name, [])))


def _bond(style: BondStyle, given: tuple[float, ...], marks: dict[str, float]) -> tuple[Floats, Floats, Floats]:
    length = style.length(given, _options(style)) or max(marks.values(), default=1.0)
    if style.subtract_pair:
        length = marks["Rc"]
    if style.reference:
        length = marks["r0"] = 1.0
        marks["(1 + eps_c) r0"] = 1.0 + given[1]
        if "eps_p" in (names := [one.name for one in style.coeffs]):
            marks["(1 + eps_p) r0"] = 1.0 + given[names.index("eps_p")]
    far = max([1.6 * length, *(1.15 * value for value in marks.values())])
    if style.reference:
        far = 1.0 + 1.4 * given[1]
    if "R0" in marks:  # beyond sqrt(0.9) R0 the force is no longer the slope of the energy
        far = 0.948 * marks["R0"] + marks.get("delta", 0.0)
        marks["R0 + delta" if "delta" in marks else "R0"] = marks.pop("R0") + marks.get("delta", 0.0)
    r = np.linspace(max(0.5 * length, 1.0 - 1.4 * given[1] if style.reference else 0.0), far, 800)
    memory = {"r0": np.full_like(r, 1.0)}
    history = tuple(memory.get(name, np.zeros_like(r)) for name in style.history)
    force, energy, _, alive = style.law(_options(style))(r * r, np.zeros_like(r), history, given)
    there = np.broadcast_to(np.asarray(alive, bool), r.shape)
    return r, np.where(there, energy + 0.0 * r, np.nan), np.where(there, force * r, np.nan)


def _pair(style: PairStyle, given: tuple[float, ...], marks: dict[str, float]) -> tuple[Floats, Floats, Floats]:
    cut = given[1] if style.name == "bpm/spring" else _CUT
    marks["cutoff"] = style.reach(given, cut)
    assert style.law is not None
    nearest = 0.01 if style.name == "soft" else 0.85 * min(marks.values()) if "delta" not in marks else 0.85 * marks["sigma"] + marks["delta"]
    r = np.linspace(nearest, 1.1 * marks["cutoff"], 800)
    options = {"cut": cut, "anharmonic": False}
    row = style.row(given, cut, False)
    force, energy = style.law(options)(r * r, np.zeros_like(r), np.ones_like(r), row)
    return r, energy + 0.0 * r, force * r


def window(values: Floats) -> tuple[float, float]:
    """What of a curve is worth seeing: the well, and as much again above it; all of one that has none."""
    seen = values[np.isfinite(values)]
    if not len(seen) or seen.min() == seen.max():
        return -1.0, 1.0
    low, last = float(seen.min()), float(seen[-1])
    behind = seen[int(seen.argmin()) :]
    depth = max(last, float(behind.max())) - low
    if depth < 1e-3 * (float(seen.max()) - low) and last == low:
        return low, float(seen.max())
    return low, min(float(seen.max()), low + 2.5 * depth) if depth > 0.0 else float(seen.max())


def draw(kind: str, name: str, coeffs: list[float] | None, path: Path) -> None:
    """Write a picture; its kind by the suffix of the name. Raises ScriptError without matplotlib."""
    r, energy, force, marks = curve(kind, name, coeffs)
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise ScriptError("There is no matplotlib to draw with", hint='pip install "pylmp[plot]", or pip install matplotlib') from None
    figure = Figure(figsize=(7.0, 6.0), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    for axes, values, label in ((upper, energy, "energy"), (lower, force, "force (repulsive: above 0)")):
        axes.plot(r, values, color="#1f4e9c")
        low, high = window(values)
        axes.set_ylim(low - 0.08 * (high - low), high)
        axes.axhline(0.0, color="#999999", linewidth=0.6)
        axes.set_ylabel(label)
        for text, place in marks.items():
            axes.axvline(place, color="#b04010", linewidth=0.8, linestyle="--")
            if axes is upper:
                where = {"xycoords": ("data", "axes fraction"), "ha": "left", "va": "bottom", "rotation": 30}
                axes.annotate(text, (place, 1.0), fontsize=8, color="#b04010", **where)
    lower.set_xlabel("distance")
    lower.set_xlim(float(r[0]), max(float(r[-1]), 1.02 * max(marks.values(), default=0.0)))
    given = coeffs or EXAMPLES.get((kind, name), ())
    figure.suptitle(f"{kind} {name} {' '.join(f'{value:g}' for value in given)}")
    try:
        figure.savefig(path, dpi=120)
    except (ValueError, OSError) as error:
        raise ScriptError(f"Cannot draw {path}: {error}", hint="a name that ends with .png, .svg or .pdf") from None
