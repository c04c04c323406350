"""Whatever a script holds: an exit code, a sentence, never a traceback."""

from __future__ import annotations

import io
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pylmp.cli import main
from pylmp.text.grammar import rules

_WORDS = [
    "all", "1", "2", "*", "1*2", "0.5", "-1", "1e9", "nan", "lj", "bond", "p", "yes", "no", "on", "off", "b", "block", "sphere",
    "index", "loop", "equal", "string", "delete", "v_a", "$a", "${a}", "$(1/0)", "$(v_a+1)", "${nope}", "$", "then", "else",
    "'print x'", '"a b"', '"', "'", '"""', "#", "&", "&\n", "SELF", "here", "nve", "temp", "lj/cut", "harmonic", "custom",
    "step", "create", "type", "set", "append", "file", "../x", "/etc/passwd", "\u00e9", "\u201cq\u201d", "\udcff", "\x01",
]  # fmt: skip
_LINES = st.builds(
    lambda name, words: " ".join([name, *words]),
    st.sampled_from([*rules(), "shell", "minimize", "nonsense", "$a", "${b}", ""]),
    st.lists(st.one_of(st.sampled_from(_WORDS), st.text(max_size=4)), max_size=7),
)
_OPENING = "variable a index 3 4\nunits lj\natom_style bond\nregion b block 0 3 0 3 0 3\n"
_BOX = "create_box 2 b bond/types 2 extra/bond/per/atom 4\nlattice sc 1\ncreate_atoms 1 box\nmass * 1\n"


def run(script: str, folder: Path) -> tuple[int, str]:
    (folder / "in.fuzz").write_text(script, errors="surrogateescape", newline="")
    screen = io.StringIO()
    with redirect_stdout(screen), redirect_stderr(screen):
        code = main([str(folder / "in.fuzz"), "-log", "none", "-skiprun"])
    return code, screen.getvalue()


@settings(max_examples=250, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    lines=st.lists(_LINES.filter(lambda line: not line.startswith(("jump", "create_atoms"))), max_size=6),
    box=st.booleans(),
)
def test_no_script_ends_in_a_traceback(lines: list[str], box: bool, tmp_path: Path, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    monkeypatch.chdir(tmp_path)
    code, text = run(_OPENING + (_BOX if box else "") + "\n".join(lines), tmp_path)
    assert code in range(256)
    assert "pylmp itself failed" not in text, text
    assert "Traceback" not in text


@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(formula=st.text(alphabet="0123456789.eE+-*/^%()[]<>=!&|, v_acPIsqrtlnxfstep", max_size=30))
def test_no_formula_ends_in_a_traceback(formula: str, tmp_path: Path) -> None:
    code, text = run(f'{_OPENING}{_BOX}variable q equal "{formula}"\nprint "$q"\n', tmp_path)
    assert code in (0, 1, 5)
    assert "pylmp itself failed" not in text, text


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.binary(max_size=80))
def test_no_bytes_end_in_a_traceback(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "in.bytes").write_bytes(data)
    screen = io.StringIO()
    with redirect_stdout(screen), redirect_stderr(screen):
        code = main([str(tmp_path / "in.bytes"), "-log", "none", "-skiprun"])
    assert code in range(256)
    assert "pylmp itself failed" not in screen.getvalue()


def test_deep_and_long_formulas(tmp_path: Path) -> None:
    for formula in (
        "(" * 20000 + "1" + ")" * 20000,
        "+".join(["1"] * 20000),
        "-" * 20000 + "1",
        "ternary(1,2," * 3000 + "3" + ")" * 3000,
    ):
        code, text = run(f'print "$({formula})"\n', tmp_path)
        assert code == 0
        assert "failed" not in text
