"""write_data FILE [nocoeff] [nofix] [nolabelmap] [noinit] [pair ii|ij] [types numeric|labels] [bond/history]

bond/history is pylmp's own: comment lines at the end hold what data files lack to continue a run exactly (io/data_history.py).
"""

from __future__ import annotations

from pathlib import Path

from pylmp.io.data_write import Contents, data_text, warn_unmixed
from pylmp.io.packed import write_packed
from pylmp.io.ready import initialise, wrap_atoms
from pylmp.model.paths import writable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word


@command("write_data", needs_box=True)
def write_data(sim: Simulation, args: Args) -> None:
    """Write atoms, velocities, bonds, angles, ..., masses and coefficients; * in the name becomes the step."""
    name = args.word()
    contents, ready = Contents(), False
    while len(args):
        key = args.word()
        if key.text == "nocoeff":
            contents.coeffs = False
        elif key.text == "nofix":
            pass  # no fix here adds a section
        elif key.text == "noinit":
            ready = True
        elif key.text == "bond/history" and not sim.strict:
            sim.console.warning("[D005] write_data ... bond/history is pylmp's own; LAMMPS 22 Jul 2025 has no such keyword")
            contents.history = True
        elif key.text == "nolabelmap":
            contents.labels = False
        elif key.text == "pair":
            contents.pairs = _choice(args, key, ("ii", "ij")) == "ij"
        elif key.text == "types":
            contents.named = _choice(args, key, ("numeric", "labels")) == "labels"
        elif key.text == "triclinic/general":
            args.fail("Write_data triclinic/general for system that is not general triclinic", key)
        else:
            args.fail(f"Unknown write_data keyword: {key.text}", key, hint="nocoeff nofix nolabelmap pair types")

    if not ready:
        sim.console.both("System init for write_data ...\n")
        initialise(sim)
        for listed in sim.bond_lists:
            listed.copy_back(sim)
        wrap_atoms(sim)
    if sim.atoms.n != sim.natoms and sim.output.thermo.lost == "error":
        args.fail(
            "Atom count is inconsistent, cannot write data file", args.owner,
            hint=f"{sim.natoms - sim.atoms.n} atoms were lost: they are outside the box",
        )  # fmt: skip
    if contents.coeffs and not contents.pairs and (not ready or sim.ran):
        warn_unmixed(sim)
    writable(sim, name)
    if sim.script.dry:
        return
    path = Path(name.text.replace("*", str(sim.step), 1))
    try:
        write_packed(path, data_text(sim, contents))
    except OSError as error:
        args.fail(
            f"Cannot open data file {path}: {error.strerror}", name, hint="an existing folder that may be written to"
        )


def _choice(args: Args, key: Word, choices: tuple[str, ...]) -> str:
    if not len(args):
        args.fail(f"Illegal write_data {key.text} command: missing argument(s)", key, hint=" or ".join(choices))
    word = args.word()
    if word.text not in choices:
        args.fail(f"Unknown write_data {key.text} option: {word.text}", word, hint=" or ".join(choices))
    return word.text
