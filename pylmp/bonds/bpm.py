"""What all bpm bond styles share: their keywords and their restrictions.

Source: LAMMPS manual, bond_bpm_spring.html; sentences and the order of checks as measured on LAMMPS 22 Jul 2025, which
checks less than the manual says (docs/departures.md).
"""

from __future__ import annotations

import re
from typing import Any

from pylmp.model.blob import FLAG, Blob
from pylmp.model.many_body import has_many_body
from pylmp.model.style import Law, Options, Restriction
from pylmp.text.words import Args, Word

ATTRIBUTES = ("id1", "id2", "time", "x", "y", "z", "x/ref", "y/ref", "z/ref")
ONES = (1.0, 1.0, 1.0)
RESTART = Blob(  # what bpm/spring/plastic keeps in restart files; other styles add to it
    settings=(("overlay/pair", FLAG), ("break", FLAG), ("smooth", FLAG), ("normalize", FLAG)), alone=("overlay/pair", "break"),
    defaults=(("overlay/pair", False), ("break", True), ("store/local", None)),
)  # fmt: skip


def parse(sim: Any, args: Args, more: tuple[str, ...] = ()) -> Options:
    """store/local ID N attributes, overlay/pair, smooth, normalize, break, and more yes/no keywords of a style: in any order.

    Like the release, in two passes: first store/local, overlay/pair and break wherever they stand, then the words left over.
    """
    options: Options = {"overlay/pair": False, "smooth": True, "normalize": False, "break": True, "store/local": None}
    options |= dict.fromkeys(more, False)
    last: dict[str, Word] = {}
    first = args.peek()
    if first is not None and first.text not in options and len(args) > 2 and args.words[args.at + 2].text in ATTRIBUTES:
        if sim.strict:
            args.fail(
                f"Illegal bond bpm command, invalid argument {first.text}", first, hint="store/local before the fix ID"
            )
        sim.console.warning(
            f"[D001] the manual's example leaves out the keyword store/local, which LAMMPS 22 Jul 2025 requires: "
            f"bond_style {args.owner} store/local {first.text} ..."
        )
        options["store/local"] = _store(args, first)
    left = []
    while len(args):
        word = args.word()
        last[word.text] = word
        if word.text == "store/local":
            options["store/local"] = _store(args, word)
        elif word.text in ("overlay/pair", "break"):
            options[word.text] = args.yes()
        else:
            left.append(args.at - 1)
    while left:
        args.at = left.pop(0)
        word = args.word()
        if word.text not in ("smooth", "normalize", *more):
            args.fail(
                f"Illegal bond bpm command, invalid argument {word.text}", word,
                hint=" ".join(["keywords: store/local overlay/pair smooth normalize break", *more]),
            )  # fmt: skip
        options[word.text] = args.yes()
        left = [at for at in left if at != args.at - 1]
    if options["smooth"] and not options["break"]:
        args.fail(
            "Illegal bond bpm command, must turn off smoothing with break no option",
            last["break"],
            hint="break no smooth no",
        )
    args.rest()
    return options


def slowed(smooth: bool) -> Law:
    """(elastic force, separation times velocity difference, r, r0, gamma, eps_c) -> force over r, with drag, smoothed."""

    def finish(force: Any, dot: Any, r: Any, r0: Any, gamma: Any, eps_c: Any) -> Any:
        ri = 1.0 / r
        force = force - gamma * dot * ri
        force = force * ri
        if smooth:
            s = (r - r0) / (r0 * eps_c)
            s = s * s
            s = s * s
            s = s * s
            force = force * (1.0 - s)
        return force

    return finish


def _store(args: Args, keyword: Word) -> tuple[str, int, tuple[str, ...]]:
    """Fix ID, interval, attributes."""
    identity = args.word()
    if not len(args):
        args.fail("Expected integer parameter instead of NULL or empty string in input script or data file", identity)
    every = args.word()
    steps = args.as_integer(every)
    attributes = []
    while (word := args.peek()) is not None and word.text in ATTRIBUTES:
        attributes.append(args.word().text)
    if not attributes and (word is None or word.text != "store/local"):
        args.fail(
            "Storing local data must include at least one value to output",
            keyword,
            hint=f"one of {' '.join(ATTRIBUTES)}",
        )
    if steps <= 0:
        args.fail("Illegal fix STORE/LOCAL command", every, hint="N is a positive number of steps")
    if not re.fullmatch(r"\w+", identity.text, re.ASCII):
        args.fail("Fix ID must be alphanumeric or underscore characters", identity)
    return identity.text, steps, tuple(attributes)


def _overlay(sim: Any, options: Options) -> bool:
    return bool(options["overlay/pair"]) and (sim.special.lj != ONES or sim.special.coul != ONES)


def _pairs_off(options: Options) -> bool:
    return bool(options["break"]) and not options["overlay/pair"]


def _keeper(sim: Any, options: Options) -> Any:
    """The fix that has the ID given after store/local, or None."""
    return next((fix for fix in sim.fixes if fix.id == options["store/local"][0]), None)


RESTRICTIONS = (
    Restriction(
        "B207", lambda sim, options: f"Cannot find fix STORE/LOCAL id {options['store/local'][0]}",
        lambda sim, options: bool(options["store/local"]) and _keeper(sim, options) is None,
        "the fix that store/local made was deleted: give bond_style again",
    ),
    Restriction(
        "B208", lambda sim, options: f"Incorrect fix style matched, not STORE/LOCAL: {_keeper(sim, options).style}",
        lambda sim, options: bool(options["store/local"]) and _keeper(sim, options).style != "STORE/LOCAL",
        "give store/local a fix ID that no fix command uses",
    ),
    Restriction(
        "B201", "With overlay/pair yes, BPM bond styles require a value of 1.0 for all special_bonds weights", _overlay,
        "special_bonds lj/coul 1 1 1",
    ),
    Restriction(
        "B202", "With overlay/pair no and break yes, BPM bond styles require Newton bond off",
        lambda sim, options: _pairs_off(options) and sim.newton_bond, "newton on off, before the box is created",
    ),
    Restriction(
        "B203", "With overlay/pair no, BPM bond styles require special LJ weights = 0,1,1",
        lambda sim, options: _pairs_off(options) and sim.special.lj != (0.0, 1.0, 1.0),
        "special_bonds lj 0 1 1 coul 1 1 1",
    ),
    Restriction(
        "B204", "With overlay/pair no and break yes, BPM bond styles requires special Coulomb weights = 1,1,1",
        lambda sim, options: _pairs_off(options) and sim.special.coul != ONES,
        "special_bonds lj 0 1 1 coul 1 1 1 (lj alone sets the Coulomb weights to 0)",
    ),
    Restriction(
        "B205", "Bond style bpm cannot break with 3,4-body interactions",
        lambda sim, options: bool(options["break"]) and has_many_body(sim),
        "break no, or angle_style none, dihedral_style none, improper_style none",
    ),
    Restriction(
        "B206", "Bond bpm/spring requires ghost atoms store velocity", lambda sim, _: not sim.comm.velocity,
        "comm_modify vel yes",
    ),
)  # fmt: skip
