"""The log's account of neighbor lists, and the words at the start of a run."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.pair_lists import Planned, plan, reaches
from pylmp.model.simulation import Simulation
from pylmp.model.wish import Wish
from pylmp.text.number import eight, shortest


@dataclass(frozen=True)
class Request:
    """One list somebody asked for. who: "pair lj/cut", "compute rdf" or "command create_bonds".

    how, origin: made from another one. cut: its one cutoff, skin included, reach: without; 0.0: each pair of types has its own.
    skipped: pairs of types it leaves out. asked: the cutoff that its owner asked for. added: nobody asked for it, others are made
    from it. owner: a number of the style or compute that asked.
    """

    who: str
    full: bool = False
    occasional: bool = False
    how: str = field(default="", compare=False)
    origin: Request | None = field(default=None, compare=False)
    cut: float = field(default=0.0, compare=False)
    reach: float = field(default=0.0, compare=False)
    skipped: frozenset[tuple[int, int]] = frozenset()
    asked: float = 0.0
    added: bool = False
    owner: int = 0


def pair_requests(sim: Simulation) -> tuple[Request, ...]:
    """The lists of the pair styles."""
    if sim.pair is None or sim.neighbor_cutoff == 0.0:
        return ()
    made: dict[Planned, Request] = {}

    def request(planned: Planned) -> Request:
        if planned not in made:
            origin = request(planned.origin) if planned.origin else None
            who = f"pair {planned.part.style.name}" if planned.part else "neighbor class addition"
            cut = planned.cut + sim.neighbor.skin if planned.cut else 0.0
            made[planned] = Request(
                who, planned.full, how=planned.how, origin=origin, cut=cut, reach=planned.cut, skipped=planned.skipped, asked=planned.asked,
                added=planned.part is None, owner=sim.pair.born,
            )  # fmt: skip
        return made[planned]

    return tuple(request(planned) for planned in plan(sim))


def announce(sim: Simulation, *requests: Request) -> None:
    """Describe the neighbor lists: of requests, the pair style's, of computes; warn of a box thinner than the skin."""
    if sim.pair is not None:
        own = pair_requests(sim)
        added = tuple(request for request in own if request.added)
        own = own[: len(own) - len(added)]
        _lists(sim, (*requests, *own, *_of_computes(sim, (*own, *added)), *added))
    if (sim.box.length < sim.neighbor.skin)[: sim.dimension].any():
        sim.console.warning("Proc sub-domain size < neighbor skin, could lead to lost atoms")


def _of_computes(sim: Simulation, own: tuple[Request, ...]) -> list[Request]:
    """What computes ask for; own: the pair styles' lists."""
    whole = next((each for each in own if not (each.full or each.skipped) and reaches(sim, each.reach)), None)
    result = []
    for compute in sim.computes.values():
        wish = compute.wish(sim)
        if wish is not None:
            origin = whole if wish == Wish() else None
            how = "copy" if origin else ""
            who = f"compute {compute.style}"
            result.append(Request(who, wish.full, True, how=how, origin=origin, cut=wish.cutoff, asked=wish.cutoff, owner=compute.born))
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
        origin = next((k for k, other in enumerate(requests, 1) if other is request.origin), 0)
        lines += _describe(sim, number, request, origin)
    sim.console.both("\n".join(lines) + "\n")


def _describe(sim: Simulation, number: int, request: Request, origin: int) -> list[str]:
    """origin: the number of the list that this one is made from, 0 if it is built."""
    tilted = "/tri" if sim.box.triclinic else ""
    newton = "on" if sim.newton_pair else "off"
    only = "" if sim.has_bonds else "atomonly/"
    if origin:
        build, stencil = request.how, "none"
    elif request.full:
        build, stencil = f"full/bin/{only}".rstrip("/"), f"full/bin/{sim.dimension}d"
    elif sim.newton_pair:
        build, stencil = f"half/bin/{only}newton{tilted}", f"half/bin/{sim.dimension}d{tilted}"
    else:
        build, stencil = f"half/bin/{only}newtoff", f"full/bin/{sim.dimension}d"
    grid = "standard"
    if sim.neighbor.style == "nsq":
        build, stencil, grid = build.replace("/bin", "/nsq").replace("/atomonly", ""), "none", "none"
    if origin:
        build, stencil, grid = request.how, "none", "none"
    made = f", {request.how} from ({origin})" if origin else ""
    cut = f", cut {shortest(request.cut)}" if request.cut else ""
    return [
        f"  ({number}) {request.who}, {'occasional' if request.occasional else 'perpetual'}{made}",
        f"      attributes: {'full' if request.full else 'half'}, newton {newton}{cut}",
        f"      pair build: {build}",
        f"      stencil: {stencil}",
        f"      bin: {grid}",
    ]
