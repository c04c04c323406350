"""The resynchronised comparison: every N steps both programs start from the same state, the reference's restart file.

The reference carries out the script once and leaves a restart file every N steps. Then each program reads all of them in turn, says again
what restart files do not hold (pairs, fixes, computes, variables, neighbor settings; see KEPT), and makes N steps: the error of N steps,
measured along a run of any length, and never drowned by chaos.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from pylmp.text.diagnostic import ScriptError
from pylmp.tools.diff import measure, read
from pylmp.tools.diff.dialect import translate
from pylmp.tools.diff.sides import Side

# What a window says again after read_restart, in the script's order.
KEPT = frozenset(
    "lattice region variable compute uncompute compute_modify fix unfix fix_modify pair_style pair_coeff pair_modify special_bonds "
    "neighbor neigh_modify comm_modify comm_style timestep run_style".split()
)
BENT = ("jump", "next", "label", "if", "include", "clear", "rerun", "python")
_RESTART = "pylmp-resync."
_ATOMS, _BONDS = "pylmp-resync.atoms", "pylmp-resync.bonds"


@dataclass
class Window:
    """step: where it begins. x, v: largest differences at its end. bonds: how many only one program has there."""

    run: int
    step: int
    x: float
    v: float
    bonds: int


@dataclass
class Resync:
    every: int
    windows: list[Window]


def resync(mine: Side, theirs: Side, every: int) -> Resync:
    """Raises Failed and subprocess.TimeoutExpired as runs do, and ScriptError for a script that does not go straight on."""
    lines = _joined(theirs.script.read_text(errors="surrogateescape").splitlines())
    bent = next((words[0] for line in lines if (words := line.split()) and words[0] in BENT), None)
    if bent or not any(line.split()[:1] == ["run"] for line in lines):
        raise ScriptError(
            f"--resync cannot follow a script with {bent}" if bent else "--resync finds no run command in the script",
            hint="it needs run commands on lines of their own, one after the other",
        )
    master = theirs.variant(theirs.title, "resync", plain=True)
    master.fresh()
    master.carry_out(_for(master, _leaving(lines, every)))
    starts = _starts(master.folder)
    for side in (sides := [side.variant(side.title, f"{side.folder.name}-resync", plain=True) for side in (mine, theirs)]):
        side.fresh()
        for path in master.folder.glob(f"{_RESTART}*"):
            shutil.copy2(path, side.folder / path.name)
        own = _joined(side.script.read_text(errors="surrogateescape").splitlines())
        text = [line for run, step, steps in starts for line in _window(own, run, step, min(every, steps))]
        side.carry_out(_for(side, text))
    return Resync(every, _measured(starts, *(side.folder for side in sides)))


def _for(side: Side, lines: list[str]) -> list[str]:
    return translate(lines).rewritten if side.is_lammps else lines


def _joined(lines: list[str]) -> list[str]:
    """One command a line."""
    result: list[str] = []
    open_ = False
    for line in lines:
        text = line.rstrip()
        piece = text.removesuffix("&")
        if open_:
            result[-1] += piece
        else:
            result.append(piece)
        open_ = text.endswith("&")
    return result


def _leaving(lines: list[str], every: int) -> list[str]:
    """The script, with a restart file at the beginning of each run, every so many steps, and at the end."""
    result, run = [], 0
    for line in lines:
        if line.split()[:1] == ["run"]:
            run += 1
            result += [f"write_restart {_RESTART}{run}.*", f"restart {every} {_RESTART}{run}.*", line, "restart 0"]
        else:
            result.append(line)
    return [*result, f"write_restart {_RESTART}{run + 1}.*"]


def _starts(folder: Path) -> list[tuple[int, int, int]]:
    """(run, step, steps left in the run) of each window."""
    found = sorted((int(run), int(step)) for _, run, step in (p.name.rsplit(".", 2) for p in folder.glob(f"{_RESTART}*.*")))
    first = {run: min(step for r, step in found if r == run) for run, _ in found}
    return [(run, step, first[run + 1] - step) for run, step in found if run + 1 in first and step < first[run + 1]]


def _window(lines: list[str], run: int, step: int, steps: int) -> list[str]:
    """Read the state at step of this run command of a script, prepare what was in force there, make the steps, leave the state."""
    result = ["clear", f"read_restart {_RESTART}{run}.{step}"]
    bonded = False
    seen = 0
    for line in lines:
        words = line.split("#")[0].split()
        if words[:1] == ["run"]:
            seen += 1
            if seen == run:
                break
        if words[:1] == ["bond_style"]:
            bonded = words[1:2] not in (["none"], ["zero"])
        tabled = words[:1] == ["bond_style"] and "table" in words  # a table's numbers are in no restart file
        if words and (words[0] in KEPT or (words[0] == "group" and "dynamic" in words) or tabled):
            result.append(line)
    if bonded:
        result.append("compute pylmp_ends all property/local batom1 batom2")
    result += ["thermo_style one", f"thermo {steps}", f"run {steps} post no"]
    result.append(f"write_dump all custom {_ATOMS} id x y z vx vy vz modify append yes sort id format float %.17g")
    if bonded:
        result.append(f"write_dump all local {_BONDS} c_pylmp_ends[1] c_pylmp_ends[2] modify append yes")
    return result


def _measured(starts: list[tuple[int, int, int]], mine: Path, theirs: Path) -> list[Window]:
    atoms = [read.numbers(folder / _ATOMS) for folder in (mine, theirs)]
    bonds = [read.numbers(folder / _BONDS) for folder in (mine, theirs)]
    windows = []
    for k, (run, step, _) in enumerate(starts):
        x, v = measure.apart(atoms[0][k], atoms[1][k])
        sets = [{frozenset(map(int, row)) for row in frames[k].values} for frames in bonds if len(frames) == len(starts)]
        windows.append(Window(run, step, x, v, len(sets[0] ^ sets[1]) if len(sets) == 2 else 0))
    return windows
