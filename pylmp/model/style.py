"""What a bond or pair style is: a value. One file holds its formula, coefficients, keywords, restrictions and law."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from pylmp.model.blob import Blob
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args

Options = dict[str, Any]
Law = Callable[..., Any]


@dataclass(frozen=True)
class Coeff:
    """One coefficient of bond_coeff or pair_coeff: its name in the formula, its unit in LAMMPS's wording."""

    name: str
    unit: str


@dataclass(frozen=True)
class Restriction:
    """One documented restriction: a stable code, LAMMPS's own sentence, the test that finds it broken, what to type."""

    code: str
    says: str | Callable[[Simulation, Options], str]
    broken: Callable[[Simulation, Options], bool]
    hint: str

    def check(self, sim: Simulation, options: Options, manual: str) -> None:
        """Raise ScriptError if broken."""
        if self.broken(sim, options):
            says = self.says if isinstance(self.says, str) else self.says(sim, options)
            raise ScriptError(says, hint=self.hint, code=self.code, manual=manual)


def no_options(sim: Simulation, args: Args) -> Options:
    """A bond style without keywords."""
    word = args.peek()
    if word is not None:
        args.fail(f"Illegal {args.what} argument: {word.text}", word, hint="this style has no keywords")
    return {}


def always(value: Any) -> Callable[[Options], Any]:
    return lambda options: value


NEVER = always(False)


@dataclass(frozen=True)
class BondStyle:
    """A bond style.

    law            options -> law(r2, dot, h, c) -> (force over r, energy, h, alive). r2: squared length; dot: separation times
                   velocity difference; h: what the bond remembers; c: its coefficients
    parse          reads the words after the style name
    history        names of what a bond remembers
    evolves        what a bond remembers changes with its evaluation; else LAMMPS never copies it back to the atoms
    reference      history[0] is the length at the first evaluation (r0)
    velocity       the law needs dot
    adapts         names by which fix adapt may change the coefficients
    can_break      options -> may the law say that a bond is not alive
    on_break       "zero": the slot keeps the bond as type 0; "remove": the slot goes, the bond count falls
    breaks_in_setup     a bond may break before the first step
    lower_id_first      atom 1 of a bond is the lower ID
    subtract_pair       the pair interaction of bonded atoms is taken out again
    single         (r2, c, pair energy) -> energy of one bond alone, where subtract_pair makes its order of operations matter
    updates_special     options -> broken pairs become ordinary neighbors
    length         (coefficients, options) -> length for LAMMPS's estimate of the communication cutoff
    misplaces      under hybrid LAMMPS mixes up what it first remembers (BondList.misplace)
    mixable        stands in bond_style hybrid beside styles that say the same; None: beside any
    freeze         coefficients -> those with which evaluating one bond alone leaves its memory as it is
    writes         write_data prints its coefficients
    omp            the manual lists an /omp name: the same law
    read           (sim, words of bond_coeff, options) -> (coeffs, numbers that the law looks up): c then ends with where these begin,
                   and with the array of all; None: bond_coeff gives coeffs themselves
    volumes        options -> it asks for volumes of atoms (model/bond_volumes.py); its c ends with a number of each bond
    watch          options -> (r2, c) -> this bond must be reported
    report         (sim, part, bonds (k, 3) rows and type) does so, in order: a warning, or a ScriptError
    report_alone   (sim, part, r2 (k,), types (k,)) the same where bonds are evaluated one by one, outside the loop over all
    check          (options, args, coefficients) fails where they do not fit together
    cautions       (sim, options) -> warnings before every run
    release        its name in the LAMMPS release, "" if it has none
    optional_coeffs   how many of the last coefficients may be left out (0.0 then)
    restart        what a restart file holds of it; unless a style without keywords says otherwise, its coefficients in order
    """

    name: str
    manual: str
    coeffs: tuple[Coeff, ...]
    law: Callable[[Options], Law]
    parse: Callable[[Simulation, Args], Options] = no_options
    restrictions: tuple[Restriction, ...] = ()
    history: tuple[str, ...] = ()
    evolves: bool = False
    reference: bool = False
    velocity: bool = False
    can_break: Callable[[Options], bool] = NEVER
    on_break: str = ""
    breaks_in_setup: bool = False
    lower_id_first: bool = False
    subtract_pair: bool = False
    single: Callable[..., Any] | None = None
    freeze: Callable[[Any], Any] = lambda coeffs: coeffs
    updates_special: Callable[[Options], bool] = NEVER
    length: Callable[[tuple[float, ...], Options], float] = lambda coeffs, options: 0.0
    misplaces: bool = False
    mixable: bool | None = False
    writes: bool = True
    omp: bool = False
    read: Callable[[Simulation, Args, Options], tuple[tuple[float, ...], Any]] | None = None
    volumes: Callable[[Options], bool] = NEVER
    watch: Callable[[Options], Law] | None = None
    report: Callable[[Simulation, Any, Any], None] | None = None
    report_alone: Callable[[Simulation, Any, Any, Any], None] | None = None
    check: Callable[[Options, Args, tuple[float, ...]], None] = lambda options, args, coeffs: None
    cautions: Callable[[Simulation, Options], list[str]] = lambda sim, options: []
    release: str = ""
    adapts: tuple[str, ...] = ()
    optional_coeffs: int = 0
    restart: Blob | None = None

    def __post_init__(self) -> None:
        if self.restart is None and self.parse is no_options:
            object.__setattr__(self, "restart", Blob())
        if self.restart is not None and self.restart.kept and not self.restart.coeffs:
            object.__setattr__(self, "restart", replace(self.restart, coeffs=tuple(c.name for c in self.coeffs)))


@dataclass(frozen=True)
class PairStyle:
    """A pair style.

    law        options -> law(r2, dot, factor, c) -> (force over r, energy), zero beyond the cutoff; None computes nothing
    settings   reads pair_style's words; options["cut"] is the global cutoff, if the style has one
    read       reads pair_coeff's words -> (coefficients, cutoff)
    mix        (coefficients, cutoff of type i, of type j, mixing rule) -> those of the unlike pair; None: not defined
    mixes_energy   LAMMPS counts the pairs it mixes
    row        (coefficients, cutoff, shift) -> the numbers the law receives
    tail       (coefficients, cutoff, atoms of type i, of type j) -> (energy, pressure) integrals, or None
    alone      options -> law of a pair that LAMMPS evaluates alone, for bond_style quartic; None: the same as law
    reach      (coefficients, cutoff) -> distance at which the law ends
    data       (coefficients, cutoff) -> numbers that the law looks up; its c ends with where they begin, and with the array
    watch      options -> (r2, c) -> this pair must be reported
    report     (sim, part, row, row) raises the ScriptError of the first such pair
    adapts     names by which fix adapt may change the coefficients; a row then ends with the square of the law's reach
    restart    what a restart file holds of it
    write      (coefficients, cutoff, whole, options) -> numbers of a line of Pair Coeffs (whole: PairIJ Coeffs); None: no such section
    """

    name: str
    manual: str
    coeffs: tuple[Coeff, ...]
    law: Callable[[Options], Law] | None
    settings: Callable[[Simulation, Args], Options]
    read: Callable[[Simulation, Args, Options], tuple[tuple[Any, ...], float]]
    row: Callable[[tuple[float, ...], float, bool], tuple[float, ...]]
    mix: Callable[..., tuple[tuple[float, ...], float]] | None = None
    mixes_energy: bool = True
    velocity: bool = False
    restrictions: tuple[Restriction, ...] = ()
    tail: Callable[[tuple[float, ...], float, float, float], tuple[float, float]] | None = None
    alone: Callable[[Options], Law] | None = None
    reach: Callable[[tuple[float, ...], float], float] = lambda coeffs, cut: cut
    data: Callable[[tuple[Any, ...], float], Any] | None = None
    watch: Callable[[Options], Law] | None = None
    report: Callable[[Simulation, Any, int, int], None] | None = None
    write: Callable[[tuple[float, ...], float, bool, Options], list[float]] | None = field(
        default=lambda coeffs, cut, whole, options: [*coeffs, cut] if whole else list(coeffs)
    )
    adapts: tuple[str, ...] = ()
    restart: Blob | None = None
