"""A simulation: everything a script has said so far, and the atoms."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.kernels.store import release
from pylmp.kernels.team import Team
from pylmp.model.asking import Asking
from pylmp.model.atom_style import ATOM_STYLES
from pylmp.model.atoms import MOST_TYPES, Atoms, check_count
from pylmp.model.box import Box
from pylmp.model.checks import check_integration, check_neighbor_settings
from pylmp.model.console import Console
from pylmp.model.groups import Groups
from pylmp.model.interrupts import Interrupts
from pylmp.model.labels import Labels
from pylmp.model.minimize import MinSettings
from pylmp.model.output import Output, add_default_computes
from pylmp.model.settings import CommSettings, NeighborSettings, SortSettings, SpecialSettings, Tally
from pylmp.model.timer import Timer
from pylmp.model.topology import KINDS, Kind
from pylmp.model.units import UNITS, Units
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.compute import Compute
    from pylmp.model.engine import Engine
    from pylmp.model.fix import Fix


class Simulation:
    """State of one run of pylmp. Commands change it, engines advance it, tools read it.

    units dimension boundary newton_pair newton_bond atom_style   as the script's commands say
    box                None until it is created
    atoms              per-atom arrays
    atom_types bond_types angle_types dihedral_types improper_types   counts, fixed by create_box or read_data
    mass               (atom_types + 1,) float64, index 0 unused, 0.0 where not set
    bonds angles dihedrals impropers   LAMMPS's global counts (thermo keywords of these names)
    pair, bond         force fields (model/pair.py, model/bond.py) or None
    angle dihedral improper   their force styles (model/many_body.py) or None
    fixes computes     in order of definition
    regions lattice    by ID; the lattice in force
    step dt            current step, timestep size
    ticks              (1,) the step in progress, for kernels that look at it while Python does not (Fix.calls)
    asking             which computes are wanted at which steps
    tally              energies and virials of the last step that summed them
    report             RunReport of the last run, None before
    interrupts         whether Ctrl-C or SIGTERM came
    engine             who carries out runs
    team               threads that help with kernels
    script             the interpreter that feeds commands (flow control, variables)
    """

    atoms: Atoms
    output: Output
    timer: Timer
    step: int
    begin: int
    end: int
    dt: float
    bonds: int
    angles: int
    dihedrals: int
    impropers: int

    def __init__(self, console: Console, engine: Engine | None = None) -> None:
        self.console = console
        self.engine = engine
        self.team = Team()
        self.script: Any = None
        self.strict = False
        self.watchful = False  # runs stop where positions are no numbers (model/sanity.py)
        self.timer = Timer()
        self.interrupts = Interrupts()
        self.suffixed = False  # the script named a suffix
        self.clear()

    def clear(self) -> None:
        """Back to the state before the first command (variables, log and directory stay)."""
        release()
        self.units: Units = UNITS["lj"]
        self.dimension = 3
        self.boundary: tuple[tuple[str, str], ...] = (("p", "p"),) * 3
        self.newton_pair = self.newton_bond = True
        self.style = ATOM_STYLES["atomic"]
        self.map_style = ""  # the kind of ID map a script asked for; only restart files tell of it
        self._box: Box | None = None
        self.atoms = Atoms()
        self.atom_types = self.bond_types = self.angle_types = self.dihedral_types = self.improper_types = 0
        self.mass = np.zeros(1)
        self.bonds = self.angles = self.dihedrals = self.impropers = 0
        self.pair: Any = None
        self.bond: Any = None
        self.angle: Any = None
        self.dihedral: Any = None
        self.improper: Any = None
        self.labels = Labels()
        self.special = SpecialSettings()
        self.extra_special = 0
        self.extra_slots: dict[str, int] = {}  # what read_data's extra/KIND/per/atom asked for, by kind
        self.neighbor = NeighborSettings(skin=self.units.skin)
        self.comm = CommSettings()
        self.communication = "brick"  # comm_style
        self.layout = "uniform"  # of the boxes of processes, of which there is one
        self.sort = SortSettings()
        self.groups = Groups()
        self.regions: dict[str, Any] = {}
        self.lattice: Any = None
        self.fixes: list[Fix] = []
        self._computes: dict[str, Compute] | None = None
        self.asking = Asking(self)
        self.output = Output(self)
        self.step = 0
        self.ticks = np.zeros(1, np.int64)
        self.dt = self.units.dt
        self.begin = self.end = 0  # steps that ramps of the current run refer to
        self.tally = Tally()
        self.report: Any = None
        self.lists: Any = None  # the engine's ghosts and neighbor lists of the last run
        self.ran = False  # a run was set up before
        self.breaks: Any = None  # bonds broken since the special lists were last edited
        self.bond_lists: list[Any] = []  # bond lists of the last run, with what bonds remember
        self.announced: Any = None  # neighbor lists the log has described
        self.lost_bonds = "error"  # thermo_modify lost/bond
        self.natoms = 0  # LAMMPS's global count; atoms.n falls below it when atoms are lost
        self.waiting: Any = None  # what a restart file brought for fixes to come
        self.relaxing = False  # a minimization is set up or in progress
        self.minimizing = MinSettings()

    @property
    def halted(self) -> bool:
        """Time is up or a fix asked for the end: the run in progress stops, others are skipped."""
        return self.timer.stops(self.step)

    @halted.setter
    def halted(self, halted: bool) -> None:
        self.timer.passed = halted

    def finish(self) -> None:
        """The script ends or starts over: fixes end what they write, dumps are closed."""
        for fix in self.fixes:
            fix.removed(self)
        for dump in self.output.dumps.values():
            dump.close()

    @property
    def box(self) -> Box:
        if self._box is None:
            raise ScriptError("No simulation box is defined", hint="create_box or read_data comes first")
        return self._box

    @box.setter
    def box(self, box: Box) -> None:
        self._box = box

    @property
    def computes(self) -> dict[str, Compute]:
        """By ID in order of definition; those of the thermo table come first."""
        if self._computes is None:
            self._computes = {}
            add_default_computes(self, self._computes)
        return self._computes

    @property
    def has_box(self) -> bool:
        return self._box is not None

    @property
    def atom_style(self) -> str:
        return self.style.name

    @property
    def has_bonds(self) -> bool:
        """The atom style stores bonds, and molecule IDs."""
        return bool(self.style.kinds)

    @property
    def ghost_velocity(self) -> bool:
        return self.comm.velocity

    @property
    def neighbor_cutoff(self) -> float:
        """Largest pair cutoff plus skin; 0.0 without a pair style."""
        largest = float(self.pair.cut.max()) if self.pair else 0.0
        return largest + self.neighbor.skin if largest > 0.0 else 0.0

    @property
    def spacing(self) -> tuple[float, float, float]:
        """Lattice spacings; 1.0 before any lattice command."""
        return self.lattice.spacing if self.lattice else (1.0, 1.0, 1.0)

    def define_types(self, atom_types: int, bond_types: int, *other_types: int) -> None:
        """Fix the numbers of types when the box comes to be; other_types: of angles, dihedrals, impropers."""
        for count in (atom_types, bond_types, *other_types):
            check_count(count, MOST_TYPES, "types")
        self.atom_types, self.bond_types = atom_types, bond_types
        self.angle_types, self.dihedral_types, self.improper_types = (*other_types, 0, 0, 0)[:3]
        self.mass = np.zeros(atom_types + 1)
        if self.pair is not None:
            self.pair.types = atom_types
        if self.bond is not None:
            self.bond.types = bond_types
            for part in self.bond.parts:
                part.table = np.zeros((bond_types + 1, part.table.shape[1]))
                part.mine = np.zeros(bond_types + 1, np.uint8)
        for kind in KINDS[1:]:
            if kind.style(self) is not None:
                kind.style(self).types = kind.types(self)

    def masses(self) -> Any:
        """(n,) mass of each owned atom."""
        return self.mass[self.atoms.type[: self.atoms.n]]

    def init(self) -> None:
        """Every part checks itself. Commands call io/ready.py's initialise, which also announces lists and readies the output."""
        if self.pair:
            self.pair.init(self)
        for bonded in self.style.kinds:
            self._init_bonded(bonded)
        for kind in range(1, self.atom_types + 1):
            if self.mass[kind] == 0.0:
                raise ScriptError(
                    f"Not all per-type masses are set. Type {kind} is missing.", hint=f"mass {kind} 1.0", manual="mass.html"
                )
        self.init_modify()
        check_neighbor_settings(self)

    def init_modify(self) -> None:
        """What fixes, computes and regions check; any compute may be wanted at this step."""
        if self.waiting is not None:
            self.waiting.drop(self)
        self.box.deforming = any(fix.changes_box for fix in self.fixes)
        self.box.rate_group = 0  # unless fix deform gives one
        for region in self.regions.values():
            region.init()
        for fix in self.fixes:
            if hasattr(fix, "init"):
                fix.init(self)
        for compute in self.computes.values():
            compute.dynamic = compute.recount
            compute.init(self)
            compute.ready = True
        self.asking.init(self.step)
        check_integration(self)

    def _init_bonded(self, kind: Kind) -> None:
        if kind.style(self) is not None:
            kind.style(self).init(self)
        elif kind.total(self):
            self.console.warning(f"{kind.plural.capitalize()} are defined but no {kind.name} style is set")
            k = KINDS.index(kind)
            if k < 3 and (self.special.lj[k] != 1.0 or self.special.coul[k] != 1.0):
                self.console.warning(f"Likewise 1-{k + 2} special neighbor interactions != 1.0")
