"""package omp N [neigh yes|no]"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args

_ABSENT = {"gpu": "without GPU package installed", "intel": "without INTEL package installed", "kokkos": "without KOKKOS package enabled"}


@command("package")
def package(sim: Simulation, args: Args) -> None:
    """Accepted for omp, without effect: there is one thread."""
    if sim.has_box:
        args.fail("Package command after simulation box is defined", args.owner, hint="it comes before the box")
    if not len(args):
        args.missing()
    name = args.word()
    if name.text in _ABSENT:
        args.fail(f"Package {name.text} command {_ABSENT[name.text]}", name)
    if name.text != "omp":
        args.fail(f"Unknown package keyword: {name.text}", name, hint="omp")
    if not len(args):
        args.fail("Illegal package omp command", name, hint="package omp N")
    if args.integer() < 0:
        args.fail("Illegal number of OpenMP threads requested", hint="0 or a positive number")
    while len(args):
        if not args.take("neigh"):
            args.fail("Illegal package omp command", args.peek(), hint="neigh yes or neigh no")
        args.yes()
    sim.console.note("package omp changes nothing: pylmp runs on one thread")
