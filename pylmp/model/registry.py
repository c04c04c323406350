"""Styles and commands by name.

A style or a command is one file in its package. Nothing lists them: a registry imports the package's modules
when it is first asked for a name, and each module adds itself. Another distribution brings its own through
an entry point in the group of the same name (``pylmp.bonds``, ``pylmp.fixes``, ...), whose value is a module.
"""

from __future__ import annotations

import difflib
import importlib
import pkgutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

T = TypeVar("T")


class Registry(Generic[T]):
    """The values of one kind (bond styles, commands, ...) by the name a script uses."""

    def __init__(self, kind: str, package: str) -> None:
        self.kind = kind
        self.package = package
        self._values: dict[str, T] = {}
        self._loaded = False

    def add(self, name: str, value: T) -> T:
        self._values[name] = value
        return value

    def register(self, *names: str) -> Callable[[Any], Any]:
        """Decorator for classes and functions that are known by one or several names."""

        def remember(value: Any) -> Any:
            for name in names:
                self.add(name, value)
            return value

        return remember

    def find(self, name: str) -> T | None:
        """The value called name, or None. Imports the package's modules only when it must."""
        if name not in self._values and not self._loaded:
            module = name.replace("/", "_").replace("-", "_")
            if module.isidentifier():
                try:
                    importlib.import_module(f"{self.package}.{module}")
                except ModuleNotFoundError as error:
                    if error.name != f"{self.package}.{module}":
                        raise
            if name not in self._values:
                self.load()
        return self._values.get(name)

    def load(self) -> None:
        """Import every module of the package and every entry point of the group."""
        if self._loaded:
            return
        from importlib.metadata import entry_points  # 10 ms, which a script of known names does not spend

        self._loaded = True
        home = importlib.import_module(self.package)
        for module in pkgutil.iter_modules(home.__path__):
            importlib.import_module(f"{self.package}.{module.name}")
        for entry in entry_points(group=self.package):
            entry.load()

    def names(self) -> list[str]:
        self.load()
        return sorted(self._values)

    def near(self, name: str) -> str:
        """The known name most like name, or an empty string."""
        return next(iter(difflib.get_close_matches(name, self.names(), 1)), "")

    def __iter__(self) -> Iterator[tuple[str, T]]:
        self.load()
        return iter(sorted(self._values.items(), key=lambda item: item[0]))


@dataclass(frozen=True)
class Command:
    """One input command: ``run(simulation, args)`` carries it out.

    needs_box  LAMMPS refuses it before the box exists, with "{Name} command before simulation box is defined"
    """

    name: str
    run: Callable[[Any, Any], None]
    manual: str
    needs_box: bool = False


COMMANDS: Registry[Command] = Registry("command", "pylmp.commands")
BONDS: Registry[Any] = Registry("bond style", "pylmp.bonds")
ANGLES: Registry[Any] = Registry("angle style", "pylmp.angles")
DIHEDRALS: Registry[Any] = Registry("dihedral style", "pylmp.dihedrals")
IMPROPERS: Registry[Any] = Registry("improper style", "pylmp.impropers")
PAIRS: Registry[Any] = Registry("pair style", "pylmp.pairs")
FIXES: Registry[Any] = Registry("fix style", "pylmp.fixes")
COMPUTES: Registry[Any] = Registry("compute style", "pylmp.computes")
DUMPS: Registry[Any] = Registry("dump style", "pylmp.dumps")
REGIONS: Registry[Any] = Registry("region style", "pylmp.regions")
MINIMIZERS: Registry[Any] = Registry("minimize style", "pylmp.minimizers")
THERMOS: Registry[Any] = Registry("thermo style", "pylmp.thermo")

# By the word that LAMMPS's `info styles` has for a kind.
REGISTRIES: dict[str, Registry[Any]] = {
    "minimize": MINIMIZERS, "pair": PAIRS, "bond": BONDS, "angle": ANGLES, "dihedral": DIHEDRALS, "improper": IMPROPERS,
    "fix": FIXES, "compute": COMPUTES, "region": REGIONS, "dump": DUMPS, "command": COMMANDS,
}  # fmt: skip


def command(name: str, *, manual: str = "", needs_box: bool = False) -> Callable[[Any], Any]:
    """Make the decorated function ``run(simulation, args)`` the input command name."""

    def remember(run: Callable[[Any, Any], None]) -> Callable[[Any, Any], None]:
        COMMANDS.add(name, Command(name, run, manual or f"{name}.html", needs_box))
        return run

    return remember
