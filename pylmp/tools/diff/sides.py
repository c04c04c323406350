"""The runs that are compared: one folder each, the instrumented copy of a script in it, and the program that carries it out."""

from __future__ import annotations

import os
import shutil
import sys
from dataclasses import dataclass, field, replace
from pathlib import Path

from pylmp.engines import lammps
from pylmp.text.diagnostic import ScriptError
from pylmp.tools.bench.child import Child, run
from pylmp.tools.diff import ledger
from pylmp.tools.diff.dialect import Dialect, translate
from pylmp.tools.diff.instrument import COPY, Extras, instrument


@dataclass
class Side:
    """One run. title: what reports call it. program: exact, fast, auto (pylmp's engines), lammps, or mpi2 (LAMMPS on two processes)."""

    title: str
    script: Path
    folder: Path
    program: str
    switches: list[str]
    permits: list[str]
    timeout: float | None
    plain: bool = False  # the script as it is, without records
    extras: Extras = field(default_factory=Extras)
    dialect: Dialect = field(default_factory=Dialect)

    @property
    def is_lammps(self) -> bool:
        return self.program in ("lammps", "mpi2")

    def run(self, lists: dict[int, list[int]] | None = None) -> None:
        """Prepare the folder and carry out the copy. lists: run commands and the steps at which their bonds are listed.

        Raises Failed when the program ends with an error, subprocess.TimeoutExpired, and ScriptError when it is not installed.
        """
        lines = self.script.read_text(errors="surrogateescape").splitlines()
        if self.is_lammps:
            self.dialect = translate(lines)
            lines = self.dialect.rewritten
        self.fresh()
        if not self.plain:
            lines = instrument(lines, self.extras)
        for k, steps in (lists or {}).items():
            ledger.ask(self.folder, k, steps)
        self.carry_out(lines)

    def fresh(self) -> None:
        """An empty folder with the files that lie beside the script."""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        for path in self.script.parent.iterdir():
            if path.is_file():
                shutil.copy2(path, self.folder / path.name)

    def carry_out(self, lines: list[str]) -> None:
        """Run these lines in the folder as it is."""
        (self.folder / COPY).write_text("\n".join(lines) + "\n", errors="surrogateescape")
        done = self._start()
        if done.code:
            raise Failed(self.title, done)

    def _start(self) -> Child:
        if not self.is_lammps:
            command = [sys.executable, "-m", "pylmp", COPY, "-nocite", *self.switches, *self.permits, "--engine", self.program]
            return run(command, self.folder, os.environ, self.timeout)
        there = lammps.find()
        command = [there.program, "-in", COPY, "-nocite", *self.switches]
        if self.program == "mpi2":
            command = [lammps.mpiexec(), "-n", "2", *command]
        return run(command, self.folder, there.environment, self.timeout)

    def variant(self, title: str, name: str, **changes: object) -> Side:
        """The same with changes, in a folder beside this one's."""
        return replace(self, title=title, folder=self.folder.with_name(name), **changes)  # type: ignore[arg-type]


class Failed(ScriptError):
    """A program stopped with an error. side: its title; said: its words from ERROR on."""

    def __init__(self, side: str, done: Child) -> None:
        text = done.said.strip()
        at = text.find("ERROR")
        self.side, self.code = side, done.code
        self.said = text[at if at >= 0 else -500 :][:1000]
        super().__init__(f"{side} stopped with exit code {done.code}:\n{self.said}")
