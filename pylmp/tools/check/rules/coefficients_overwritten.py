"""P105."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.text.span import Span
from pylmp.text.words import Args, Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look

_USES = {"run", "minimize", "rerun", "write_data", "write_restart", "create_bonds", "info"}
_RESETS = {"pair_style": "pair_coeff", "bond_style": "bond_coeff"}


class CoefficientsOverwritten(Rule):
    """Coefficients are replaced before anything used them.

    The last line that names a type wins: a line for all types after one for some of them makes the first one void, and what
    it says is not what is computed.

    Okay:
        region cell block 0 1 0 1 0 1
        create_box 2 cell
        pair_style lj/cut 2.5
        pair_coeff * * 1.0 1.0
        pair_coeff 1 2 0.5 1.0

    Bad:
        region cell block 0 1 0 1 0 1
        create_box 2 cell
        pair_style lj/cut 2.5
        pair_coeff 1 2 0.5 1.0
        pair_coeff * * 1.0 1.0
    """

    code = "P105"
    name = "coefficients-overwritten"
    manual = "pair_coeff.html"

    def __init__(self) -> None:
        self._lines: list[tuple[str, Span, set[tuple[int, int]], tuple[str, ...]]] = []  # what each line still says

    def after(self, look: Look, words: list[Word]) -> None:
        name = words[0].text
        if name == "clear" or name in _USES:
            self._lines = []
        elif name in _RESETS:
            self._lines = [line for line in self._lines if line[0] != _RESETS[name]]
        elif name in _RESETS.values() and words[0].span is not None and not look.branching:
            self._set(look, name, words, words[0].span)

    def _set(self, look: Look, name: str, words: list[Word], span: Span) -> None:
        sim = look.sim
        args = Args(name, words[1:], words[0])
        if name == "pair_coeff":
            if sim.pair is None or sim.pair.name.startswith("hybrid"):  # several lines may add up
                return
            first, second = args.types(sim.atom_types), args.types(sim.atom_types)
            types = {(i, j) for i in first for j in second if i <= j}
        else:
            if sim.bond is None:
                return
            types = {(kind, kind) for kind in args.types(sim.bond.types)}
        values = tuple(word.text for word in args.rest())
        for which, place, left, said in self._lines:
            if which != name or place == span or not left & types:
                continue
            left -= types
            if not left and said != values:
                look.warn(self, place, f"Line {span.line} sets all of this anew before it is used", "the general line first, then the exceptions")  # fmt: skip
        self._lines = [line for line in self._lines if line[2] and line[1] != span]
        self._lines.append((name, span, types, values))
