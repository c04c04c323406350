"""rerun on the exact engine: states from elsewhere, one after the other; forces and output of each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace as with_changes
from typing import TYPE_CHECKING

from pylmp.model.engine import RunReport
from pylmp.model.fix import hooks
from pylmp.model.ghosts import ghost_cutoff

if TYPE_CHECKING:
    from pylmp.engines.exact import Run


def replay(run: Run, frames: Iterator[None]) -> RunReport:
    """frames makes a state the simulation's each time it is asked for one. Atoms are not sorted; what is due is written."""
    sim = run.sim

    def loop() -> int:
        count = 0
        for count, _ in enumerate(frames, 1):
            sim.init_modify()
            run.bind_hooks()
            ghost_cutoff(sim, warn=True, setup=True)
            run.start_over(sort=False)
            for hook in hooks(sim.fixes, "setup"):
                hook(sim)
            run.call("end_of_step")
            if count == 1:
                sim.output.setup(sim)
            else:
                sim.output.jump(sim)
                if sim.output.due(sim):
                    sim.output.write(sim)
            if sim.interrupts.number:
                break
        sim.output.close(sim)
        return count

    report, count = run.timed(loop)
    return with_changes(report, steps=count)
