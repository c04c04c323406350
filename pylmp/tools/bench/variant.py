"""A script rewritten for a sweep: its last run with another timestep or skin, for the same simulated time, its energy written as it goes."""

from __future__ import annotations

import re
from collections.abc import Sequence

from pylmp.text.diagnostic import ScriptError

SAMPLES = 100  # lines of the thermo table in the last run
FORCES = "bench.forces"
COLUMNS = "step time dt ke etotal econserve"
_RUN = re.compile(r"^\s*run\s+(\S+)(.*)$")
_QUARTIC = re.compile(r"^\s*bond_style\s+quartic(/breakable)?\s*(#.*)?$")
_COEFF = re.compile(r"^\s*bond_coeff\s+\S+(?:\s+\S+){4}\s+(\S+)\s*(#.*)?$")
_BROKEN = (
    "compute bench_n all nbond/atom", "compute bench_b all reduce sum c_bench_n", "variable bench_b equal 0.5*c_bench_b",
)  # fmt: skip


def last_run(lines: Sequence[str]) -> int:
    """Raises ScriptError where there is none to measure."""
    found = [k for k, line in enumerate(lines) if _RUN.match(line)]
    if not found:
        raise ScriptError("The script has no line that begins with run", hint="a sweep varies the last one")
    return found[-1]


def changed(lines: Sequence[str], dt: float, skin: float | None, samples: int = SAMPLES) -> list[str]:
    """The script up to its last run, with dt times the timestep and as many fewer steps; skin: of its neighbor lists, if not its own."""
    at = last_run(lines)
    match = _RUN.match(lines[at])
    assert match is not None
    steps = re.sub(r"\$\{(\w+)\}|\$(\w)", lambda m: f"v_{m[1] or m[2]}", match[1])
    bonds = [*_BROKEN] if depth(lines) is not None else []
    return [
        *lines[:at],
        *([f"neighbor {skin!r} bin"] if skin is not None else []),
        f"timestep $(dt*{dt!r}:%.17g)",
        f"variable bench_steps equal ceil(({steps})/{dt!r})",
        f"thermo $(ceil(v_bench_steps/{samples}))",
        *bonds,
        f"thermo_style custom {COLUMNS}{' v_bench_b' if bonds else ''}",
        "thermo_modify norm no format float %.17g",
        f"run $(v_bench_steps){match[2]}",
    ]


def first_forces(lines: Sequence[str]) -> list[str]:
    """The script up to its first run, of which the forces after ten steps are left: in a crystal at rest there are none."""
    at = next(k for k, line in enumerate(lines) if _RUN.match(line))
    return [
        *lines[:at], f"dump bench all custom 10 {FORCES} id fx fy fz", "dump_modify bench sort id format float %.17g", "run 10 post no",
    ]  # fmt: skip


def depth(lines: Sequence[str]) -> float | None:
    """U0, which every quartic bond that breaks takes with it; None: no such bonds, or not one number for all."""
    if not any(_QUARTIC.match(line) for line in lines):
        return None
    found = {m[1] for line in lines if (m := _COEFF.match(line))}
    try:
        return float(found.pop()) if len(found) == 1 else None
    except ValueError:
        return None
