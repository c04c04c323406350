"""What `pylmp restart info` says of a restart file: as a value for programs, as lines for people."""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.io.restart import layout
from pylmp.io.restart.content import Content, Force
from pylmp.text.number import eight, shortest

SCHEMA = 1


def summary(name: str, content: Content) -> dict[str, Any]:
    """Plain values only, ready for JSON."""
    header = content.header
    box = {"lo": header["lo"], "hi": header["hi"], "boundary": boundary(content)}
    if header["triclinic"]:
        box["tilt"] = [header[tilt] for tilt in ("xy", "xz", "yz")]
    counts = {f"{kind}s": header[f"{kind}s"] for kind in layout.KINDS if header[f"{kind}s"]}
    return {
        "schema": SCHEMA, "file": name, "version": header["version"], "step": header["step"], "time": _time(content),
        "timestep": header["timestep"], "units": header["units"], "dimension": header["dimension"],
        "newton": [bool(header["newton pair"]), bool(header["newton bond"])], "box": box,
        "atom_style": header["atom style"][0], "atoms": content.n, **counts,
        "types": {kind: header[f"{kind} types"] for kind in ("atom", *layout.KINDS) if header[f"{kind} types"]},
        "broken_bonds": broken(content), "mass": content.mass,
        "special_bonds": {"lj": header["special lj"], "coul": header["special coul"]},
        "groups": {group: int(_members(content, slot)) for group, slot in content.groups.items()},
        "forces": {kind: _force(force) for kind, force in content.forces.items()},
        "fixes": [{"id": identity, "style": style, "bytes": len(state)} for identity, style, state in content.fixes],
        "fixes_per_atom": [{"id": k.identity, "style": k.style, "numbers": k.width} for k in content.kept],
    }  # fmt: skip


def boundary(content: Content) -> list[str]:
    letters = [layout.FACES[code] for code in content.header["boundary"]]
    return [a if a == b else a + b for a, b in zip(letters[0::2], letters[1::2], strict=True)]


def broken(content: Content) -> int:
    """Bonds of type 0, each counted once."""
    atoms = content.atoms
    if "num_bond" not in atoms:
        return 0
    used = np.arange(atoms["bond_type"].shape[1]) < atoms["num_bond"][:, None]
    found = int((used & (atoms["bond_type"] == 0)).sum())
    return found if content.header["newton bond"] else found // 2


def _time(content: Content) -> float:
    header = content.header
    return float(header["time"] + (header["step"] - header["time step"]) * header["timestep"])


def _members(content: Content, slot: int) -> int:
    return int(((content.atoms["mask"] >> slot & 1) != 0).sum())


def _force(force: Force) -> dict[str, Any]:
    said: dict[str, Any] = {"style": force.style}
    if force.settings:
        said["settings"] = force.settings
    if force.columns:
        said["coefficients"] = {str(k): list(row) for k, row in enumerate(zip(*force.columns, strict=True), 1)}
    if force.pairs:
        said["coefficients"] = {f"{i} {j}": row for (i, j), row in force.pairs.items()}
    if force.parts:
        said["styles"] = [_force(part) for part in force.parts]
    return said


def lines(name: str, content: Content) -> list[str]:
    """The same for people."""
    said = summary(name, content)
    box, types = said["box"], said["types"]
    corner = (" ".join(eight(x) for x in box[face]) for face in ("lo", "hi"))
    shape = "triclinic" if "tilt" in box else "orthogonal"
    tilt = f", tilt {' '.join(eight(x) for x in box['tilt'])}" if "tilt" in box else ""
    newton = " ".join("on" if flag else "off" for flag in said["newton"])
    rows = [
        ("", f"{name}: restart file of LAMMPS {said['version']}, step {said['step']}, time {eight(said['time'])}"),
        ("units", f"{said['units']}, timestep {shortest(said['timestep'])}, dimension {said['dimension']}, newton {newton}"),
        ("box", f"{shape} ({') to ('.join(corner)}){tilt}, boundary {' '.join(box['boundary'])}"),
        ("atoms", f"{said['atoms']}, {types.get('atom', 0)} types, atom_style {said['atom_style']}"),
    ]  # fmt: skip
    for kind in layout.KINDS:
        if f"{kind}s" in said:
            gone = f", {said['broken_bonds']} of them broken" if kind == "bond" and said["broken_bonds"] else ""
            rows.append((f"{kind}s", f"{said[f'{kind}s']}, {types.get(kind, 0)} types{gone}"))
    rows.append(("masses", " ".join(shortest(mass) for mass in said["mass"])))
    weights = (f"{what} {' '.join(shortest(w) for w in said['special_bonds'][what])}" for what in ("lj", "coul"))
    rows.append(("special_bonds", " ".join(weights)))
    rows.append(("groups", ", ".join(f"{group} ({count})" for group, count in said["groups"].items())))
    for kind, force in said["forces"].items():
        rows += _force_rows(f"{kind}_style", f"{kind}_coeff", force)
    for fix in said["fixes"]:
        rows.append(("fix", f"{fix['id']} {fix['style']} keeps {fix['bytes']} bytes"))
    for fix in said["fixes_per_atom"]:
        rows.append(("fix", f"{fix['id']} {fix['style']} keeps {fix['numbers']} numbers an atom"))
    return [f"  {label:<14}{text}" if label else text for label, text in rows]


def _force_rows(label: str, coeff: str, force: dict[str, Any]) -> list[tuple[str, str]]:
    settings = ", ".join(f"{name} {shortest(value)}" for name, value in force.get("settings", {}).items())
    rows = [(label, f"{force['style']}{': ' + settings if settings else ''}")]
    for types, row in force.get("coefficients", {}).items():
        rows.append((coeff, f"{types} {' '.join(shortest(value) for value in row)}"))
    for part in force.get("styles", []):
        rows += _force_rows("  of it", coeff, part)
    return rows
