"""The force field of angles, dihedrals or impropers: a style and its coefficients. The styles here, none and zero, exert no forces."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pylmp.model.blob import Blob
from pylmp.model.topology import Kind
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args


@dataclass(frozen=True)
class ManyBodyStyle:
    """parse: words after the style's name -> does it take coefficients at all. read: words of KIND_coeff, the type range first, and the
    number of types -> types and coefficients. width: numbers a type has. restart: what a restart file holds of it."""

    name: str
    manual: str
    width: int
    parse: Callable[[Args], bool]
    read: Callable[[Args, int], tuple[range, tuple[float, ...]]]
    restart: Blob | None = None


class ManyBody:
    """given: coefficients by type, those that KIND_coeff named. takes_coeffs: false after nocoeff."""

    def __init__(self, kind: Kind, style: ManyBodyStyle, takes_coeffs: bool, types: int) -> None:
        self.kind = kind
        self.style = style
        self.takes_coeffs = takes_coeffs
        self.types = types
        self.given: dict[int, tuple[float, ...]] = {}

    @property
    def name(self) -> str:
        return self.style.name

    def coeff(self, sim: Simulation, args: Args) -> None:
        """The words of KIND_coeff."""
        if self.takes_coeffs:
            kinds, values = self.style.read(args, self.types)
        else:
            kinds, values = args.types(self.types), (0.0,) * self.style.width
            args.rest()
        self.given.update(dict.fromkeys(kinds, values))

    def init(self, sim: Simulation) -> None:
        """Raises ScriptError if a type has no coefficients."""
        what = self.kind.name
        says = ""
        if not self.given:
            says = f"{what.capitalize()} coeffs are not set. Status:\n{what.capitalize()} style not yet initialized"
        elif len(self.given) < self.types:
            rows = (f"\n{k:6d}: is {'set' if k in self.given else 'not set'}" for k in range(1, self.types + 1))
            says = f"All {what} coeffs are not set. Status:{''.join(rows)}"
        if says:
            raise ScriptError(says, hint=f"{what}_coeff * ... sets all", manual=f"{what}_coeff.html")

    def write_coeffs(self) -> list[tuple[int, tuple[float, ...]]]:
        """(type, coefficients) for a data file."""
        return [(kind, self.given[kind]) for kind in range(1, self.types + 1)]


def has_many_body(sim: Simulation) -> bool:
    """Some angle, dihedral or improper style is defined."""
    return any(style is not None for style in (sim.angle, sim.dihedral, sim.improper))
