"""Which errors only follow from earlier ones, and are not worth a word."""

from __future__ import annotations

import re

_NAMED = {
    "fix": 1,
    "compute": 1,
    "dump": 1,
    "region": 1,
    "group": 1,
    "variable": 1,
    "lattice": 0,
    "label": 1,
    "thermo_style": 0,
}
_BOX = ("create_box", "read_data", "read_restart", "region")
_FREE = {"print", "variable", "echo", "log", "shell", "info", "thermo_modify", "dump_modify", "write_data", "write_dump", "write_restart", "unfix", "uncompute",
         "undump", "thermo", "timer", "velocity", "set"}  # fmt: skip
_OF_STYLE = {"pair_coeff": "pair_style", "pair_modify": "pair_style", "bond_coeff": "bond_style", "angle_coeff": "angle_style",
             "dihedral_coeff": "dihedral_style", "improper_coeff": "improper_style", "dump_modify": "dump", "fix_modify": "fix",
             "compute_modify": "compute", "create_atoms": "lattice"}  # fmt: skip
_COMPLETE = {
    "run",
    "minimize",
    "rerun",
    "create_bonds",
    "velocity",
    "delete_atoms",
    "displace_atoms",
    "write_data",
    "write_restart",
    "write_dump",
    "replicate",
}
_PARTS = re.compile(r"[A-Za-z0-9_]+")


class Failures:
    """What failed so far."""

    def __init__(self) -> None:
        self._names: set[str] = set()
        self._variables: set[str] = set()
        self._commands: set[str] = set()
        self._weighty = False

    def clear(self) -> None:
        """Names of variables outlive the simulation."""
        self._names &= self._variables
        self._commands.clear()
        self._weighty = False

    def note(self, words: list[str]) -> None:
        """A command failed, or its effect is not known."""
        if not words:
            return
        name = words[0]
        self._commands.add(name)
        if name not in _FREE:
            self._weighty = True
        at = _NAMED.get(name)
        if at and len(words) > at:
            self._names.add(words[at])
            if name == "variable":
                self._variables.add(words[at])

    def explain(self, words: list[str], message: str, has_box: bool) -> bool:
        """Could an error of this command be the consequence of what failed before?"""
        if not words:
            return False
        name = words[0]
        if not has_box and self._commands & set(_BOX):
            if "box" in message or name in ("create_atoms", "create_box", *_COMPLETE):
                return True
        if _OF_STYLE.get(name) in self._commands or (name in _COMPLETE and self._weighty):
            return True
        return bool(self._names & self._mentioned(words))

    @staticmethod
    def _mentioned(words: list[str]) -> set[str]:
        found = set()
        for word in words[1:]:
            for part in _PARTS.findall(word):
                found.add(part)
                found.add(re.sub(r"^[vcfVCF]_", "", part))
        return found
