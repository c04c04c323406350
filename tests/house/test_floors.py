"""The floors of docs/house.md: a module imports only from its own floor and from floors below it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "pylmp"
FLOORS = {
    "text": 0, "kernels": 0, "laws": 0,
    "model": 1,
    "commands": 2, "bonds": 2, "pairs": 2, "fixes": 2, "minimizers": 2, "computes": 2, "dumps": 2, "regions": 2, "thermo": 2, "io": 2,
    "angles": 2, "dihedrals": 2, "impropers": 2,
    "interpreter": 3, "references": 3, "survey": 3, "script": 3,
    "engines": 4,
    "tools": 5,
    "cli": 6, "session": 6, "__main__": 6, "__init__": 6,
}  # fmt: skip
COMPILER = {"kernels/compile.py", "kernels/alphabet.py", "kernels/atomic.py", *(f"kernels/simd/{name}.py" for name in ("vector", "word", "memory", "emit"))}  # who may know numba
AT_ONCE = COMPILER - {"kernels/compile.py"}  # only the compiler imports them
LINKER = {*COMPILER, "kernels/load.py"}  # and who llvmlite
FILES = sorted(PACKAGE.rglob("*.py"))
NAMES = [path.relative_to(PACKAGE).as_posix() for path in FILES]


def imports(path: Path) -> Iterator[tuple[str, ast.stmt]]:
    """Dotted names a file imports when it runs; what only the type checker sees is left out."""
    tree = ast.parse(path.read_text())
    unseen = {
        id(inner)
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING")
        for inner in ast.walk(node)
    }
    for node in ast.walk(tree):
        if id(node) in unseen:
            continue
        if isinstance(node, ast.Import):
            yield from ((alias.name, node) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}:{node.lineno}: say where it comes from in full"
            whole = node.module or ""
            yield from ((f"{whole}.{alias.name}" if whole == "pylmp" else whole, node) for alias in node.names)


def room(dotted: str) -> str | None:
    """The part of pylmp a dotted name lies in; None outside, and for the package's own names (its version)."""
    words = dotted.split(".")
    return words[1] if words[0] == "pylmp" and len(words) > 1 and not words[1].startswith("__") else None


def test_every_part_has_a_floor() -> None:
    parts = {path.stem if path.parent == PACKAGE else path.relative_to(PACKAGE).parts[0] for path in FILES}
    assert parts == set(FLOORS)


@pytest.mark.parametrize("path", FILES, ids=NAMES)
def test_imports_point_downwards(path: Path) -> None:
    inside = path.relative_to(PACKAGE)
    here = inside.parts[0].removesuffix(".py")
    for dotted, node in imports(path):
        there = room(dotted)
        if there is None:
            continue
        assert FLOORS[there] <= FLOORS[here], f"{inside}:{node.lineno}: {here} imports {dotted} from above"
        assert {here, there} != {"text", "kernels"}, f"{inside}:{node.lineno}: text and kernels never meet"


@pytest.mark.parametrize("path", FILES, ids=NAMES)
def test_only_the_compiler_knows_numba(path: Path) -> None:
    inside = path.relative_to(PACKAGE).as_posix()
    for dotted, node in imports(path):
        package = dotted.split(".")[0]
        where = f"{inside}:{node.lineno}"
        assert package != "numba" or inside in COMPILER, where
        assert package != "llvmlite" or inside in LINKER, where
        if package in ("numba", "llvmlite") and inside not in AT_ONCE:
            assert node.col_offset > 0, f"{where}: imported before it is needed"
        if dotted.startswith("pylmp.kernels.alphabet"):
            assert inside == "kernels/compile.py" and node.col_offset > 0, where


def test_an_import_from_above_would_be_seen(tmp_path: Path) -> None:
    file = tmp_path / "low.py"
    file.write_text(
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import pylmp.cli\ndef f():\n    import pylmp.engines\n"
    )
    assert [room(dotted) for dotted, _ in imports(file)] == [None, "engines"]
