"""The instrumented copy of a script: the same run, plus full-precision state after each run command.

Both programs run the same copy. Before every ``run`` line the thermo output is switched to 17 digits; after it the
atoms and the bonds are appended to two files. Commands inside ``if`` are left alone (their thermo lines still count).
"""

from __future__ import annotations

ATOMS = "pylmp-diff.atoms"
BONDS = "pylmp-diff.bonds"
_MEMORY = {"bpm/spring/plastic": " b1 b2", "bpm/spring": " b1"}  # what a style's bonds remember
_PRECISE = "format float %.17g"


def instrument(lines: list[str]) -> list[str]:
    """The physical lines of the copy."""
    result: list[str] = []
    bonds = ""
    stores_bonds = False
    pending: list[str] = []  # after a run command that goes on over several physical lines
    going_on = False
    for line in lines:
        words = line.split("#")[0].split()
        if not going_on:
            if words[:1] == ["atom_style"] and len(words) > 1:
                stores_bonds = words[1] in ("bond", "angle", "molecular", "full")
            elif words[:1] == ["clear"]:
                bonds, stores_bonds = "", False
            elif words[:1] == ["bond_style"] and len(words) > 1:
                bonds = words[1]
            elif words[:1] in (["run"], ["minimize"]):
                before, pending = _around(bonds if stores_bonds else "")
                result += before
        result.append(line)
        going_on = line.rstrip().endswith("&")
        if pending and not going_on:
            result += pending
            pending = []
    return result


def _around(bonds: str) -> tuple[list[str], list[str]]:
    """Lines before and after a run command; bonds is the bond style in force, or empty."""
    before = ["thermo_modify format none", f"thermo_modify {_PRECISE}"]
    after = [
        f"write_dump all custom {ATOMS} id type x y z vx vy vz fx fy fz ix iy iz modify append yes sort id {_PRECISE}"
    ]
    if bonds and bonds not in ("none", "zero"):
        memory = _MEMORY.get(bonds, "")
        force = "" if bonds == "hybrid" else " force"  # LAMMPS's single force under hybrid has no meaning for bpm
        before += [
            "compute pylmp_ends all property/local batom1 batom2 btype",
            f"compute pylmp_bonds all bond/local dist engpot{force}{memory}",
        ]
        columns = [f"c_pylmp_ends[{k}]" for k in (1, 2, 3)] + [
            f"c_pylmp_bonds[{k}]" for k in range(1, 3 + bool(force) + len(memory.split()))
        ]
        after += [
            f"write_dump all local {BONDS} {' '.join(columns)} modify append yes {_PRECISE}",
            "uncompute pylmp_bonds",
            "uncompute pylmp_ends",
        ]
    return before, after
