"""read_data FILE keywords...; bond/history is pylmp's own: with what write_data FILE bond/history kept, a run goes on exactly."""

from __future__ import annotations

from pylmp.io.data_read import Options, read_data
from pylmp.io.packed import Unpackable, read_packed
from pylmp.model.groups import MAX_GROUPS
from pylmp.model.paths import readable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import KIND
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_NAMES = "atom", "bond", "angle", "dihedral", "improper"
_COUNTS = (*(f"extra/{k}/types" for k in _NAMES), *(f"extra/{k}/per/atom" for k in (*_NAMES[1:], "special")))


@command("read_data")
def read_data_command(sim: Simulation, args: Args) -> None:
    """Make the box and the atoms, bonds, velocities, masses and coefficients of a file; or add to what is there."""
    name = args.word()
    options = Options()
    group = ""
    while len(args):
        group = _keyword(sim, args, options) or group
    if sim.has_box and options.add is None:
        args.fail(
            "Cannot use read_data without add keyword after simulation box is defined",
            args.owner,
            hint="add append, or clear",
        )
    if not sim.has_box and options.add is not None:
        args.fail("Cannot use read_data add before simulation box is defined", args.owner)
    if options.add is None and options.offsets:
        args.fail("Cannot use read_data offset without add keyword", args.owner, hint="add append offset ...")
    if options.add is not None and any(options.types.values()):
        args.fail("Cannot use any read_data extra/*/types keyword with add keyword", args.owner, hint="in the first read_data")
    if options.add is not None and options.history:
        args.fail("Cannot use read_data bond/history with add keyword", args.owner, hint="in the first read_data")
    if options.add is None and any(options.shift):
        args.fail("Cannot use read_data shift without add keyword", args.owner, hint="add append shift ...")
    if sim.dimension == 2 and sim.boundary[2][0] != "p":
        args.fail("Cannot run 2d simulation with nonperiodic Z dimension", args.owner, hint="boundary x y p")
    path = readable(sim, name)
    try:
        text = read_packed(path)
    except OSError as error:
        args.fail(f"Cannot open file {path}: {error.strerror}", name)
    except Unpackable as error:
        args.fail(f"Cannot read file {path}: {error}", name, hint="gzip -t tells whether it is whole")
    if group:
        options.group = _group(sim, args, group)
    read_data(sim, path, text, options)


def _keyword(sim: Simulation, args: Args, options: Options) -> str:
    """Read one keyword; returns the name of a group if it is that."""
    key = args.word()
    if key.text in _COUNTS:
        _count(sim, args, key, options)
    elif key.text == "nocoeff":
        options.coeffs = False
    elif key.text == "group":
        _need(args, key, 1)
        return args.word().text
    elif key.text == "shift":
        _need(args, key, 3)
        options.shift = args.number(), args.number(), args.number()
    elif key.text == "add":
        _need(args, key, 1)
        word = args.word()
        if word.text in ("append", "merge"):
            options.add = word.text
        else:
            _need(args, key, 1)
            options.add, options.molecule_offset = args.as_integer(word), args.integer()
    elif key.text == "bond/history" and not sim.strict:
        sim.console.warning("[D005] read_data ... bond/history is pylmp's own; LAMMPS 22 Jul 2025 has no such keyword")
        options.history = True
    elif key.text == "offset":
        _offset(args, key, options)
    elif key.text == "fix":
        raise Unsupported(
            f"LAMMPS has read_data {key.text}, pylmp's native engines do not", key.span, manual=args.manual
        )
    else:
        args.fail(f"Unknown read_data keyword {key.text}", key, hint="add offset shift group nocoeff extra/...")
    return ""


def _need(args: Args, key: Word, count: int) -> None:
    if len(args) < count:
        args.fail(f"Illegal read_data {key.text} command: missing argument(s)", key)


def _count(sim: Simulation, args: Args, key: Word, options: Options) -> None:
    _need(args, key, 1)
    word = args.word()
    name = key.text.split("/")[1]
    kind = KIND.get(name)
    allowed = kind is None or kind in sim.style.kinds or (key.text.endswith("per/atom") and sim.has_bonds)
    if not allowed:
        args.fail(f"No {name}s allowed with atom style {sim.atom_style}", word)
    value = args.as_integer(word)
    if value < 0:
        args.fail(f"Illegal read_data {key.text} value {value}", word, hint="0 or more")
    (options.types if key.text.endswith("types") else options.per_atom)[name] = value


def _offset(args: Args, key: Word, options: Options) -> None:
    """Numbers that are added to the types of the file."""
    _need(args, key, 5)
    values = [args.integer() for _ in _NAMES]
    if min(values) < 0:
        args.fail("Illegal read_data offset value(s)", hint="0 or more")
    options.offsets = dict(zip(_NAMES, values, strict=True))


def _group(sim: Simulation, args: Args, name: str) -> int:
    """The bit of a group, which is made if it is new."""
    bit = sim.groups.bit(name)
    if bit == 0:
        bit = sim.groups.free_bit()
        if bit == 0:
            args.fail(f"Too many groups (max {MAX_GROUPS})")
        sim.groups.names[name] = bit
    return bit
