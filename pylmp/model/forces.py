"""What setforce and addforce read alike."""

from __future__ import annotations

from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


def read_components(args: Args, elsewhere: tuple[str, ...], null: bool) -> list[float | None]:
    """fx fy fz as numbers; None for NULL where that is allowed. Keywords and variables are LAMMPS's only."""
    args.need(3)
    result: list[float | None] = []
    for _ in range(3):
        word = args.word()
        if word.text.startswith("v_"):
            raise Unsupported(f"LAMMPS has variables in {args.what}, pylmp's native engines do not", word.span)
        result.append(None if null and word.text == "NULL" else args.as_number(word))
    if len(args):
        word = args.word()
        if word.text in elsewhere:
            raise Unsupported(f"LAMMPS has {args.what} {word.text}, pylmp's native engines do not", word.span)
        args.fail(f"Unknown {args.what} keyword: {word.text}", word)
    return result
