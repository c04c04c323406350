"""What the codes mean that are no rule's of their own."""

from __future__ import annotations

from pylmp.tools.check.rule import rules

CODES = {
    "E001": "LAMMPS refuses this",
    "W001": "LAMMPS warns of this",
    "N001": "LAMMPS has this, pylmp does not",
    "N002": "only a run knows which branch is taken; all are checked",
    "N003": "a loop is not followed to its end",
    "N004": "a file that the script itself writes",
    "N009": "this line could not be checked",
}


def describe(code: str) -> str:
    """One sentence."""
    for rule in rules():
        if rule.code == code:
            return (rule.__doc__ or "").strip().splitlines()[0]
    return CODES.get(code, "pylmp refuses this")
