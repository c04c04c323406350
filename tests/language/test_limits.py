"""Scripts that would blow up: a sentence in good time, no traceback, no end of memory."""

from __future__ import annotations

from pathlib import Path

import pytest

from pylmp.cli import main

BOX = "region b block 0 4 0 4 0 4\ncreate_box 1 b\ncreate_atoms 1 single 1 1 1\nmass 1 1\n"
CHAINS = {"equal": ("1", "${a97}", "98"), "atom": ("x", "$(v_a97[1])", "98"), "vector": ("[1,2]", "${a97}", "[98,99]")}


def run(script: str, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *more: str) -> tuple[int, str]:
    monkeypatch.chdir(folder)
    (folder / "in.script").write_text(script)
    code = main(["in.script", "-log", "none", *more])
    text = capsys.readouterr().out
    assert "pylmp itself failed" not in text, text
    return code, text


@pytest.mark.parametrize(
    "script",
    [
        f"print $({'(' * 100000}1{')' * 100000})\n",
        f'if "{"(" * 100000}1 == 1{")" * 100000}" then "print 1"\n',
        f'variable a equal "{"-" * 100000}1"\nprint "$a"\n',
    ],
    ids=["immediate", "condition", "signs"],
)
def test_a_hundred_thousand_parentheses(script: str, tmp_path: Path, monkeypatch, capsys) -> None:  # type: ignore[no-untyped-def]
    code, text = run(script, tmp_path, monkeypatch, capsys)
    assert code == 0 and "\n1\n" in text


@pytest.mark.parametrize("style", CHAINS)
def test_long_chains_of_variables(style: str, tmp_path: Path, monkeypatch, capsys) -> None:  # type: ignore[no-untyped-def]
    start, shown, value = CHAINS[style]
    lines = [f"variable a0 {style} {start}", *(f"variable a{k} {style} v_a{k - 1}+1" for k in range(1, 98)), f'print "{shown}"']
    code, text = run(BOX + "\n".join(lines) + "\n", tmp_path, monkeypatch, capsys)
    assert code == 0 and f"\n{value}\n" in text


@pytest.mark.parametrize("style", ["equal", "atom", "vector"])
def test_circles_of_variables(style: str, tmp_path: Path, monkeypatch, capsys) -> None:  # type: ignore[no-untyped-def]
    shown = "$(v_a[1])" if style != "equal" else "$a"
    script = BOX + "".join(f"variable {a} {style} v_{b}\n" for a, b in ("ab", "bc", "ca")) + f'print "{shown}"\n'
    code, text = run(script, tmp_path, monkeypatch, capsys)
    assert code == 1 and "has a circular dependency" in text


def test_a_loop_without_end_has_a_budget(tmp_path: Path, monkeypatch, capsys) -> None:  # type: ignore[no-untyped-def]
    code, text = run("label a\njump SELF a\n", tmp_path, monkeypatch, capsys, "--max-commands", "5000")
    assert code == 1 and "stopped after 5000 commands" in text and "in.script:" in text


@pytest.mark.parametrize("script", [f'print "{"x" * 1100000}"\n', 'variable x string 0123456789\nlabel a\nvariable x string "$x$x"\njump SELF a\n'])
def test_lines_end(script: str, tmp_path: Path, monkeypatch, capsys) -> None:  # type: ignore[no-untyped-def]
    code, text = run(script, tmp_path, monkeypatch, capsys)
    assert code == 1 and "longer than 1000000 characters" in text and len(text) < 3000


@pytest.mark.parametrize("formula", ["logfreq2(1,2,1)", "logfreq2(1,1e300,2)", "logfreq3(1,1e18,1e19)", "stride(1e400,0*1e400,1)", "x[1e400]", "stagger(1e400,1)"])
def test_functions_that_would_not_return(formula: str, tmp_path: Path, monkeypatch, capsys) -> None:  # type: ignore[no-untyped-def]
    code, _ = run(BOX + f'reset_timestep 1000000\nprint "$({formula})"\n', tmp_path, monkeypatch, capsys)
    assert code in (0, 1)


@pytest.mark.parametrize(("line", "allow"), [("variable h getenv HOME", "env"), ("shell true", "shell"), ('print "x" file ../x', "write")])
def test_what_needs_permission(line: str, allow: str, tmp_path: Path, monkeypatch, capsys) -> None:  # type: ignore[no-untyped-def]
    inner = tmp_path / "inner"
    inner.mkdir()
    code, text = run(f"{line}\n", inner, monkeypatch, capsys)
    assert code == 1 and f"--allow {allow}" in text and "in.script:1:" in text
    assert run(f"{line}\n", inner, monkeypatch, capsys, "--allow", allow)[0] == 0
