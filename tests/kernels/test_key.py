"""The key of a kernel is its content: what changes the machine code changes it, and nothing else does."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

from pylmp.kernels.key import key

LAWS = """
from pylmp.laws import select, sqrt
CONSTANT = {constant}
def helper(r2):
    return {helper}
def law(r2, k):
    {comment}
    r = sqrt(r2)
    return select(r < CONSTANT, {formula}, {zero})
def compose(law, flag, table):
    def loop(x: "f8*", n: "{count}") -> "f8":
        total = 0.0
        for i in range(n):
            total += law(x[i], table[1])
            if flag:
                total += 1.0
        return total
    return loop
kernel = compose({law}, {flag}, {table})
"""
PLAIN = {
    "constant": "1.5", "helper": "r2 * 2.0", "comment": "'Words.'", "formula": "k * r + helper(r2) + 48.0", "zero": "0.0",
    "count": "i8", "law": "law", "flag": "True", "table": "(1.0, 2.0)",
}  # fmt: skip


def of(prefix: str = "", **changes: str) -> str:
    space: dict = {}
    exec(prefix + LAWS.format(**{**PLAIN, **changes}), space)
    return key(space["kernel"])


@pytest.mark.parametrize(
    "change",
    [
        {"constant": "1.6"}, {"constant": "2"}, {"helper": "r2 * 3.0"}, {"helper": "r2 * 2"}, {"helper": "2.0 * r2"},
        {"formula": "k * r + helper(r2) + 49.0"}, {"formula": "helper(r2) + k * r + 48.0"}, {"zero": "-0.0"},
        {"flag": "False"}, {"flag": "1"}, {"flag": "None"}, {"table": "(1.0, 2.5)"}, {"table": "(1, 2.0)"},
        {"table": "(1.0, 2.0, 3.0)"}, {"count": "i4"}, {"law": "lambda r2, k: r2"},
    ],
    ids=str,
)  # fmt: skip
def test_a_change_of_content_is_a_new_key(change: dict[str, str]) -> None:
    assert of(**change) != of()


def test_what_does_not_shape_code_keeps_the_key() -> None:
    assert of(comment="'Other words.'") == of()
    assert of(comment="'Words.'  # and a comment") == of()
    assert of(prefix="\n\n# moved down\n") == of()


def test_the_key_does_not_depend_on_the_process() -> None:
    line = "from tests.kernels.test_key import of; print(of())"
    for seed in ("1", "2"):
        done = subprocess.run(
            [sys.executable, "-c", line],
            env={"PYTHONHASHSEED": seed, "PATH": ""},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.stdout.strip() == of(), done.stderr


def test_compiler_settings_and_processor_are_part_of_it(monkeypatch) -> None:
    from pylmp.kernels import key as module

    plain = of()
    module._machine.cache_clear()
    monkeypatch.setenv("NUMBA_OPT", "1")
    assert of() != plain
    monkeypatch.delenv("NUMBA_OPT")
    module._machine.cache_clear()
    monkeypatch.setattr(module, "_processor", lambda: "another")
    assert of() != plain
    module._machine.cache_clear()
    monkeypatch.undo()
    assert of() == plain
    module._machine.cache_clear()


@pytest.mark.parametrize(
    "captured", [object(), [1.0], {1.0}, {"a": 1}, np.float64(1.0).dtype], ids=lambda v: type(v).__name__
)
def test_what_cannot_be_described_is_refused_by_name(captured: object) -> None:
    def impossible(n: "i8") -> "f8":
        return 0.0 if captured else 1.0

    with pytest.raises(TypeError, match="kernel impossible.*captures"):
        key(impossible)
