"""House rules for files: short, nothing of one machine in them, no ways out to a shell."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PARTS = ("pylmp", "tests", "grammar", "inputs", "docs", ".ci")
KINDS = {".py", ".lark", ".md", ".toml", ".lock", ".svg", ""}
TEXTS = sorted(
    path
    for part in (*(ROOT / name for name in PARTS), *filter(Path.is_file, ROOT.glob("*")))
    for path in (part.rglob("*") if part.is_dir() else [part])
    if path.is_file() and "__pycache__" not in path.parts and (path.suffix in KINDS or path.name.startswith("in."))
)
SOURCES = [path for path in TEXTS if path.suffix in (".py", ".lark")]
LONGEST = 300

# Spelled in pieces, so that this file does not name what it forbids.
MACHINE = re.compile(
    "|".join(["/" + "work/", "/" + "root/", "/" + "home/", "index" + "[-_]url", "pypi" + r"\.org", "file:" + "//"])
)


def name(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def test_there_is_something_to_look_at() -> None:
    assert len(SOURCES) > 150
    assert {"pyproject.toml", "Makefile", ".ci/run", "requirements.lock", "README.md"} <= {name(path) for path in TEXTS}


@pytest.mark.parametrize("path", SOURCES, ids=name)
def test_no_file_is_long(path: Path) -> None:
    assert len(path.read_text().splitlines()) <= LONGEST


def test_no_machine_is_named() -> None:
    found = [
        f"{name(path)}:{number}: {line.strip()[:100]}"
        for path in TEXTS
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if MACHINE.search(line)
    ]
    assert not found, "\n".join(found)


@pytest.mark.parametrize("path", [p for p in SOURCES if name(p).startswith("pylmp/") and p.suffix == ".py"], ids=name)
def test_a_script_cannot_reach_a_shell_or_python(path: Path) -> None:
    """No eval or exec, no shell, no pickle; processes are started with a list of words only: by the engines' oracle, and by shell where a user allows it."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Call):
            called = ast.unparse(node.func)
            where = f"{name(path)}:{node.lineno}: {called}"
            assert called not in ("eval", "exec", "compile", "os.system", "os.popen"), where
            assert not any(word.arg == "shell" for word in node.keywords), where
        if isinstance(node, ast.Import):
            assert not {alias.name for alias in node.names} & {"pickle", "marshal", "shelve"}, name(path)


@pytest.mark.parametrize("package", ["commands", "fixes", "computes", "regions"])
def test_a_file_is_named_after_what_it_holds(package: str) -> None:
    for path in (ROOT / "pylmp" / package).glob("*.py"):
        names = re.findall(r'@(?:command|\w+\.register)\("([^"]+)"', path.read_text())
        if names:
            assert path.stem.rstrip("_") in [word.replace("/", "_") for word in names], name(path)


def test_files_say_what_they_are() -> None:
    silent = [
        name(path)
        for path in SOURCES
        if path.suffix == ".py" and path.stat().st_size and not ast.get_docstring(ast.parse(path.read_text()))
    ]
    assert not silent
