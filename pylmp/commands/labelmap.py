"""labelmap atom|bond|angle|dihedral|improper TYPE LABEL ... | clear | write FILE"""

from __future__ import annotations

from pylmp.io.whole_file import write_whole
from pylmp.model.labels import is_label
from pylmp.model.paths import writable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_KINDS = "atom", "bond", "angle", "dihedral", "improper"


@command("labelmap", needs_box=True)
def labelmap(sim: Simulation, args: Args) -> None:
    """Give types names, forget all names, or write them as commands."""
    hint = "labelmap KIND TYPE LABEL ..., labelmap clear, labelmap write FILE"
    if not len(args):
        args.fail("Incorrect number of arguments for labelmap command", args.owner, hint=hint)
    what = args.word()
    if what.text in ("clear", "write"):
        if len(args) != (1 if what.text == "write" else 0):
            args.fail(f"Incorrect number of arguments for labelmap {what.text} command", what, hint=hint)
        if what.text == "clear":
            sim.labels.by_type.clear()
        else:
            _write(sim, args, args.word())
        return
    if what.text not in _KINDS:
        args.fail(f"Unknown labelmap keyword {what.text}", what, hint=" ".join((*_KINDS, "clear", "write")))
    if len(args) < 2:
        args.fail(f"Illegal labelmap {what.text} command: missing argument(s)", args.words[-1], hint=hint)
    if len(args) % 2:
        args.fail("Incorrect number of arguments for labelmap command", args.words[-1], hint=hint)
    types = getattr(sim, f"{what.text}_types")
    if types < 1:
        args.fail(f"No {what.text} types allowed with current box settings", what)
    while len(args):
        _assign(sim, args, what.text, types)


def _assign(sim: Simulation, args: Args, kind: str, types: int) -> None:
    word = args.word()
    number = args.as_integer(word)
    if not 1 <= number <= types:
        args.fail(f"Labelmap {kind} type {number} must be within 1-{types}", word)
    name = args.word()
    label = name.text.strip()
    if not is_label(label):
        hint = "no blanks, and no digit, * or # in front"
        args.fail(f"Type label string {label} for {kind} type {number} is invalid", name, hint=hint)
    other = sim.labels.number(kind, label)
    if other not in (0, number):
        args.fail(f"The {kind} type label {label} is already in use for type {other}", name)
    sim.labels.assign(kind, number, label)


def _write(sim: Simulation, args: Args, name: Word) -> None:
    lines = []
    for kind in _KINDS:
        if labels := sim.labels.of(kind):
            pairs = (f'{number} """ {labels[number]} """' for number in sorted(labels))
            lines.append(f"labelmap {kind} {' '.join(pairs)}\n")
    path = writable(sim, name)
    try:
        write_whole(path, "".join(lines))
    except OSError as error:
        args.fail(f"Cannot open label map file {path}: {error.strerror}", name)
