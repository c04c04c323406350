"""P107."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.model.scene import Scene
from pylmp.text.span import Span
from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class RecordsLost(Rule):
    """A dump reads the records of broken bonds less often than store/local shows them.

    store/local shows at each N-th step the bonds that broke in the N steps before. A dump of every other such step writes half
    of them, and nothing says that the others are missing.

    Okay:
        atom_style bond
        newton on off
        comm_modify vel yes cutoff 2
        special_bonds lj 0 1 1 coul 1 1 1
        region cell block 0 5 0 5 0 5
        create_box 1 cell bond/types 1
        mass 1 1.0
        bond_style bpm/spring store/local broken 100 time id1 id2
        bond_coeff 1 1.0 0.1 0.1
        dump 1 all local 100 broken.dump f_broken[1] f_broken[2]
        run 0

    Bad:
        atom_style bond
        newton on off
        comm_modify vel yes cutoff 2
        special_bonds lj 0 1 1 coul 1 1 1
        region cell block 0 5 0 5 0 5
        create_box 1 cell bond/types 1
        mass 1 1.0
        bond_style bpm/spring store/local broken 100 time id1 id2
        bond_coeff 1 1.0 0.1 0.1
        dump 1 all local 1000 broken.dump f_broken[1] f_broken[2]
        run 0
    """

    code = "P107"
    name = "records-lost"
    manual = "bond_bpm_spring.html"

    def __init__(self) -> None:
        self._places: dict[str, Span | None] = {}

    def after(self, look: Look, words: list[Word]) -> None:
        if words[0].text == "dump" and len(words) > 4:
            self._places[words[1].text] = words[4].span

    def run(self, look: Look, scene: Scene, steps: int) -> None:
        for identity, dump in look.sim.output.dumps.items():
            every = dump.schedule.every
            for found in getattr(dump, "sources", ()):
                source = found.source(look.sim)
                if (
                    getattr(source, "style", "") != "STORE/LOCAL"
                    or not isinstance(every, int)
                    or every <= source.interval
                ):
                    continue
                look.warn(
                    self, self._places.get(identity),
                    f"Fix {source.id} shows new records every {source.interval} steps, this dump writes every {every}: the others are lost",
                    f"dump every {source.interval} steps, or store/local every {every}",
                )  # fmt: skip
