"""The log's account of neighbor lists, and the words at the start of a run."""

from __future__ import annotations

import math
from dataclasses import dataclass

from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.simulation import Simulation
from pylmp.model.wish import Wish
from pylmp.text.number import eight


@dataclass(frozen=True)
class Request:
    """One list somebody asked for. who: "pair lj/cut", "compute rdf" or "command create_bonds".

    copy     it is the list with this number
    cutoff   how far, if not as far as the pair style reaches
    """

    who: str
    full: bool = False
    occasional: bool = False
    copy: int = 0
    cutoff: float = 0.0


def announce(sim: Simulation, *requests: Request) -> None:
    """Describe the neighbor lists: of requests, the pair style's, of computes; warn of a box thinner than the skin."""
    if sim.pair is not None:
        own = (*requests, Request(f"pair {sim.pair.name}"))
        _lists(sim, (*own, *_of_computes(sim, len(own))))
    if (sim.box.length < sim.neighbor.skin)[: sim.dimension].any():
        sim.console.warning("Proc sub-domain size < neighbor skin, could lead to lost atoms")


def _of_computes(sim: Simulation, own: int) -> list[Request]:
    """What computes ask for; own: the number of the pair style's list."""
    result = []
    for compute in sim.computes.values():
        wish = compute.wish(sim)
        if wish is not None:
            copy = own if wish == Wish() else 0
            result.append(Request(f"compute {compute.style}", wish.full, True, copy, wish.cutoff))
    return result


def _lists(sim: Simulation, requests: tuple[Request, ...]) -> None:
    """Print `Neighbor list info ...`, unless the same lists were announced before; a command's list is new each time."""
    if sim.announced == requests and not any(request.who.startswith("command") for request in requests):
        return
    sim.announced = requests
    cutoff = sim.neighbor_cutoff
    if cutoff == 0.0:
        return
    settings = sim.neighbor
    reach = ghost_cutoff(sim, warn=True)
    size = settings.bin_size or 0.5 * cutoff
    low, high = sim.box.bounds
    lengths = high - low
    bins = " ".join(str(math.ceil(float(length) / size)) for length in lengths)
    count = len(requests)
    occasional = sum(request.occasional for request in requests)
    check = "yes" if settings.check else "no"
    lines = [
        "Neighbor list info ...",
        f"  update: every = {settings.every} steps, delay = {settings.delay} steps, check = {check}",
        f"  max neighbors/atom: {settings.one}, page size: {settings.page}",
        f"  master list distance cutoff = {eight(cutoff)}",
        f"  ghost atom cutoff = {eight(reach)}",
        *([f"  binsize = {eight(size)}, bins = {bins}"] if settings.style == "bin" else []),
        f"  {count} neighbor lists, perpetual/occasional/extra = {count - occasional} {occasional} 0",
    ]
    for number, request in enumerate(requests, 1):
        lines += _describe(sim, number, request)
    sim.console.both("\n".join(lines) + "\n")


def _describe(sim: Simulation, number: int, request: Request) -> list[str]:
    tilted = "/tri" if sim.box.triclinic else ""
    newton = "on" if sim.newton_pair else "off"
    only = "" if sim.has_bonds else "atomonly/"
    if request.full:
        build, stencil = f"full/bin/{only}".rstrip("/"), f"full/bin/{sim.dimension}d"
    elif sim.newton_pair:
        build, stencil = f"half/bin/{only}newton{tilted}", f"half/bin/{sim.dimension}d{tilted}"
    else:
        build, stencil = f"half/bin/{only}newtoff", f"full/bin/{sim.dimension}d"
    grid = "standard"
    if sim.neighbor.style == "nsq":
        build, stencil, grid = build.replace("/bin", "/nsq").replace("/atomonly", ""), "none", "none"
    copy = f", copy from ({request.copy})" if request.copy else ""
    cut = f", cut {eight(request.cutoff)}" if request.cutoff else ""
    return [
        f"  ({number}) {request.who}, {'occasional' if request.occasional else 'perpetual'}{copy}",
        f"      attributes: {'full' if request.full else 'half'}, newton {newton}{cut}",
        f"      pair build: {'copy' if copy else build}",
        f"      stencil: {'none' if copy else stencil}",
        f"      bin: {'none' if copy else grid}",
    ]
