"""The instrumented copy of a script: the same run, plus full-precision records around each run command.

Every program runs such a copy. Before a ``run`` or ``minimize`` line the thermo output is switched to 17 digits and a dump and, where bonds
can break, a count of bonds are set up; after it they are taken down, and atoms and bonds are appended to two files.
Commands inside ``if`` are left alone (their thermo lines still count).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

COPY = "in.diff"
ATOMS = "pylmp-diff.atoms"
BONDS = "pylmp-diff.bonds"
CURVE = "pylmp-diff.curve."  # and the number of the run command, counted as they are carried out
COUNT = "pylmp-diff.count."
STEPS = "pylmp-diff.steps."
LEDGER = "pylmp-diff.ledger."
MARK = "pylmp-diff run "  # said in the log where a run command begins
POINTS = 16  # of a run at which positions are compared
NUDGE = 1e-14  # of the largest coordinate: by how much a shadow's atoms are moved
MEMORY = {"bpm/spring/plastic": " b1 b2", "bpm/spring": " b1"}  # what a style's bonds remember
LENGTH, R0, YIELD = "c_pylmp_bonds[1]", "c_pylmp_bonds[3]", "c_pylmp_bonds[4]"  # the last two of bpm styles
BREAKABLE = ("quartic", "bpm/", "hybrid")
_PRECISE = "format float %.17g"
_PLAIN = 4  # lines before a run that add no dump and no fix


@dataclass(frozen=True)
class Extras:
    """What a copy does besides. perturbed: atoms are moved a little before the first run. unsorted: atoms are never sorted.

    ledger: numbers of run commands in which all bonds are listed at the steps of the file STEPS.
    """

    perturbed: bool = False
    unsorted: bool = False
    ledger: Sequence[int] = ()


def instrument(lines: list[str], extras: Extras | None = None) -> list[str]:
    """The physical lines of the copy."""
    extras = extras or Extras()
    result = ["variable pylmp_k equal 0"]
    bonds = ""
    stores_bonds = False
    flat = any(line.split()[:2] == ["dimension", "2"] for line in lines)
    idle = any(line.split()[:1] == ["delete_bonds"] for line in lines)  # of bonds that are turned off LAMMPS's energy is undefined
    fresh = True
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
                if fresh:
                    result += _first(extras, flat)
                    fresh = False
                before, pending = _around(bonds if stores_bonds else "", not idle, _steps(words), extras)
                if " pre no" in " ".join(words):  # LAMMPS takes no new dump or fix into such a run
                    before, pending = before[:_PLAIN], [line for line in pending if line.startswith("write_dump")][:1]
                result += before
        result.append(line)
        going_on = line.rstrip().endswith("&")
        if pending and not going_on:
            result += pending
            pending = []
    return result


def _first(extras: Extras, flat: bool) -> list[str]:
    lines = ["atom_modify sort 0 0.0"] if extras.unsorted else []
    if extras.perturbed:
        ends = [f"abs(bound(all,{d}{m}))" for d in "xyz" for m in ("min", "max")]
        lines += [f"variable pylmp_nudge equal {NUDGE}*({'+'.join(ends)})/3"]
        lines += [f"displace_atoms all random $(v_pylmp_nudge) $(v_pylmp_nudge) {'0' if flat else '$(v_pylmp_nudge)'} 4711 units box"]
    return lines


def _steps(words: list[str]) -> str:
    """A formula of how many steps the command makes, or empty where its words do not tell."""
    if words[0] == "minimize":
        return words[3] if len(words) > 3 else ""
    amount = words[1].strip("\"'") if len(words) > 1 else ""
    if amount.count("(") != amount.count(")") or "&" in amount:
        return ""
    return f"{amount}-step" if words[2:3] == ["upto"] else amount


def _around(bonds: str, energies: bool, steps: str, extras: Extras) -> tuple[list[str], list[str]]:
    """Lines before and after a run command; bonds is the bond style in force, or empty; energies: of bonds too; steps a formula."""
    before = [
        "thermo_modify format none", f"thermo_modify {_PRECISE}",
        "variable pylmp_k equal $(v_pylmp_k+1)", f'print "{MARK}${{pylmp_k}}"',
        f"variable pylmp_every equal ceil(({steps or 1000}+1)/{POINTS})",
        f"dump pylmp_curve all custom ${{pylmp_every}} {CURVE}${{pylmp_k}} id x y z vx vy vz fx fy fz",
        f"dump_modify pylmp_curve first yes append yes sort id {_PRECISE}",
    ]  # fmt: skip
    after = [
        "undump pylmp_curve",
        f"write_dump all custom {ATOMS} id type x y z vx vy vz fx fy fz ix iy iz modify append yes sort id {_PRECISE}",
    ]
    if bonds and bonds not in ("none", "zero"):
        memory = MEMORY.get(bonds, "")
        # LAMMPS's single force under hybrid has no meaning for bpm, nor has an energy of bpm
        asked = ["dist", *(["engpot"] if energies and not bonds.startswith("bpm/") else []), *(["force"] if bonds != "hybrid" else []), *memory.split()]
        before += [
            "compute pylmp_ends all property/local batom1 batom2 btype",
            f"compute pylmp_bonds all bond/local {' '.join(asked)}",
        ]
        listed = " ".join([f"c_pylmp_ends[{k}]" for k in (1, 2, 3)] + [f"c_pylmp_bonds[{k}]" for k in range(1, 1 + len(asked))])
        if len(asked) == 1:
            listed = listed.replace("c_pylmp_bonds[1]", "c_pylmp_bonds")
        breaks = bonds.startswith(BREAKABLE)
        counted = "bonds" if bonds.startswith("bpm/") else "sum(c_pylmp_types)"  # those of quartic stay among bonds, as type 0
        if breaks:
            before += ["compute pylmp_types all count/type bond"] if counted != "bonds" else []
            before += [
                f"variable pylmp_live equal {counted}",
                f"fix pylmp_count all ave/time 1 1 1 v_pylmp_live file {COUNT}${{pylmp_k}}",
            ]
        if extras.ledger:
            before += [
                f"variable pylmp_steps file {STEPS}${{pylmp_k}}",
                "variable pylmp_when equal next(pylmp_steps)",
                f"dump pylmp_ledger all local 1 {LEDGER}${{pylmp_k}} {listed}",
                f"dump_modify pylmp_ledger every v_pylmp_when first yes append yes {_PRECISE}",
            ]
            after += ["undump pylmp_ledger", "variable pylmp_steps delete"]
        if breaks:
            after += ["unfix pylmp_count", "variable pylmp_live delete", *(["uncompute pylmp_types"] if counted != "bonds" else [])]
        after += [
            f"write_dump all local {BONDS} {listed} modify append yes {_PRECISE}",
            "uncompute pylmp_bonds",
            "uncompute pylmp_ends",
        ]
    return before, after
