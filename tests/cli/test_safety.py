"""A script that was found somewhere: what it may not do, and what it may not take. docs/safety.md."""

from __future__ import annotations

import ast
import gzip
import time
from pathlib import Path

import pytest

import pylmp
from pylmp.cli import main

BOX = "region b block 0 4 0 4 0 4\ncreate_box 1 b\nmass 1 1\n"
TABLE = "pair_style table linear 10\npair_coeff 1 1 ../out/t.tab X\n"
DATA = "t\n\n1 atoms\n1 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # atomic\n\n1 1 0.5 0.5 0.5\n"
# line by line: what is refused, the switch that its sentence names
READS = [
    "include ../out/in.other", "jump ../out/in.other", "read_data ../out/a.data", "read_restart ../out/a.rst", "read_restart ../out/a.*",
    BOX + "read_dump ../out/a.dump 0 x", BOX + "rerun ../out/a.dump dump x", "variable f file ../out/lines", "variable f equal is_file(../out/lines)\nprint $f",
    "atom_modify map yes\n" + BOX + "variable f atomfile ../out/lines", BOX + TABLE, "include /etc/hostname", "include link",
]  # fmt: skip
WRITES = [
    'print x file ../x', 'print x append /tmp/pylmp.x', "log ../x", BOX + "write_data ../x", BOX + "write_restart ../x", BOX + "restart 5 ../x",
    BOX + "dump d all atom 1 ../x", BOX + "dump d all atom 1 ../*.x", BOX + "write_dump all atom ../x", BOX + "fix a all ave/time 1 1 1 c_thermo_temp file ../x",
    BOX + "fix a all print 1 x file ../x", "info system out overwrite ../x", BOX + "labelmap write ../x", "print x file .profile", "print x file link", "print x file sub/.y/z",
    BOX + "write_data link",
]  # fmt: skip
OTHERS = [("shell true", "shell"), ("shell cd sub", "shell"), ("variable h getenv HOME", "env")]


@pytest.fixture
def inner(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working directory, files outside it, a link to one of them."""
    for name in ("inner", "inner/sub", "out"):
        (tmp_path / name).mkdir()
    for name, text in (("in.other", "print seen\n"), ("a.data", DATA), ("lines", "1\n1 2.0\n"), ("a.rst", "x"), ("a.1", "x"), ("a.dump", ""), ("t.tab", "")):
        (tmp_path / "out" / name).write_text(text)
    (tmp_path / "inner" / "link").symlink_to(tmp_path / "out" / "in.other")
    monkeypatch.chdir(tmp_path / "inner")
    return tmp_path / "inner"


def run(folder: Path, script: str, capsys: pytest.CaptureFixture[str], *switches: str) -> tuple[int, str]:
    (folder / "in.script").write_text(script + "\n")
    code = main(["in.script", "-log", "none", *switches])
    text = capsys.readouterr().out
    assert "pylmp itself failed" not in text, text
    return code, text


@pytest.mark.parametrize(("script", "what"), [*((s, "read") for s in READS), *((s, "write") for s in WRITES), *OTHERS])
def test_refused_unless_allowed(script: str, what: str, inner: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = {path: path.read_bytes() for path in inner.parent.rglob("*") if path.is_file() and path.name != "in.script"}
    code, text = run(inner, script, capsys)
    line = len(script.splitlines())
    assert code == 1 and f"--allow {what}" in text and f"in.script:{line}:" in text, text
    assert {path: path.read_bytes() for path in inner.parent.rglob("*") if path.is_file() and path.name != "in.script"} == before
    if what != "write":
        _, text = run(inner, script, capsys, "--allow", f"env,{what}")
        assert "--allow" not in text
        _, text = run(inner, script, capsys, "--trust")
        assert "--allow" not in text


def test_what_stands_beside_the_script_is_read(inner: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As where runs are started in a folder of their own; what is written stays in the working directory."""
    (inner.parent / "out" / "in.main").write_text("include ../out/in.other\nread_data ../out/a.data\nmass 1 1\nwrite_data here.data\n")
    assert main(["../out/in.main", "-log", "none"]) == 0
    assert "seen" in capsys.readouterr().out and (inner / "here.data").exists()
    (inner.parent / "out" / "in.main").write_text("print x file ../out/y\n")
    assert main(["../out/in.main", "-log", "none"]) == 1
    assert run(inner, "print x file /dev/null\nlog /dev/null", capsys)[0] == 0


def test_a_log_that_nobody_asked_for_follows_no_link_out_of_the_folder(inner: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As it may come with somebody's archive."""
    target = inner.parent / "out" / "precious"
    target.write_text("precious")
    (inner / "in.script").write_text("print x\n")
    (inner / "log.lammps").symlink_to(target)
    assert main(["in.script"]) == 1 and "-log FILE says where" in capsys.readouterr().err
    assert target.read_text() == "precious"
    assert main(["in.script", "-log", "log.lammps"]) == 0 and "print x" in target.read_text()


def test_permissions_are_a_list(inner: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script = "shell true\nprint x file ../x"
    assert run(inner, script, capsys, "--allow", "shell,write")[0] == run(inner, script, capsys, "--allow", "shell", "--allow", "write")[0] == 0
    assert main(["in.script", "--allow", "everything"]) == 2
    assert run(inner, "variable n getenv OMP_NUM_THREADS", capsys)[0] == 0


BIG = {
    "random": (BOX + "create_atoms 1 random 2000000000 5 NULL", "There is no memory for 2000000000 atoms: about 800 GB"),
    "replicate": (BOX + "create_atoms 1 single 1 1 1\nreplicate 1000 1000 1000", "There is no memory for 1000000000 atoms"),
    "box": ("units real\nlattice fcc 0.001\nregion b block 0 1000 0 1000 0 1000 units box\ncreate_box 1 b\ncreate_atoms 1 box", "There is no memory for about 4e+18 atoms"),
    "region": (
        "units real\nlattice fcc 0.001\nregion b block 0 99 0 99 0 99 units box\nregion s sphere 50 50 50 5 units box\ncreate_box 1 b\ncreate_atoms 1 region s",
        "There is no memory for about 2.",  # e12: 4 a cell of 1e-9, in 4/3 pi 125
    ),
    "types": ("region b block 0 4 0 4 0 4\ncreate_box 2000000000 b", "Failed to allocate"),
    "data": ("read_data big.data", "Unexpected end of data file"),
    "lists": (
        "region b block 0 40 0 40 0 40\nlattice sc 1\ncreate_box 1 b\nmass 1 1\ncreate_atoms 1 box\npair_style lj/cut 100\npair_coeff 1 1 1 1\nfix 1 all nve\nrun 1",
        "There is no memory for the lists of 64000 atoms",
    ),
    "format": (BOX + "create_atoms 1 single 1 1 1\nthermo_modify format float %2000000000g\nrun 0", "asks for more characters"),
    "precision": (BOX + "create_atoms 1 single 1 1 1\nthermo_modify format float %.2000000000g\nrun 0", "asks for more characters"),
    "pad": (BOX + "dump d all custom 1 d.* id\ndump_modify d pad 2000000000", "Invalid dump_modify pad argument"),
    "bomb": ("read_data bomb.data.gz", "it unpacks to more than"),
    "jumps": ("label a\njump SELF a", "jumped 200000 times and changed nothing but variables"),
    "count": ("variable i equal 0\nlabel a\nvariable i equal $i+1\njump SELF a", "--max-jumps"),
}  # fmt: skip


@pytest.mark.parametrize("name", BIG)
def test_what_is_too_much_is_refused_before_it_is_taken(name: str, inner: Path, capsys: pytest.CaptureFixture[str]) -> None:
    import resource

    (inner / "big.data").write_text(DATA.replace("1 atoms", "2000000000 atoms"))
    if name == "bomb":
        (inner / "bomb.data.gz").write_bytes(gzip.compress(b"0" * (1 << 28), 1))
    script, sentence = BIG[name]
    before, started = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.monotonic()
    code, text = run(inner, script, capsys, *(("--max-jumps", "5000") if name == "count" else ()))
    assert code == 1 and sentence in text and "in.script:" in text + "in.script:" * ("data:" in text), text
    assert time.monotonic() - started < 10.0
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 700_000  # kB


def test_loops_that_do_something_are_not_counted(inner: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script = "variable i loop 300\nlabel a\nrun 0\nnext i\njump SELF a"
    assert run(inner, BOX + "create_atoms 1 single 1 1 1\n" + script, capsys, "--max-jumps", "50")[0] == 0
    idle = "variable i loop 300\nlabel a\nnext i\njump SELF a"
    assert run(inner, idle, capsys, "--max-jumps", "50")[0] == 1
    for more in (("--max-jumps", "0"), ("--trust",), ("--max-jumps", "500")):
        assert run(inner, idle, capsys, *more)[0] == 0


def test_no_text_becomes_a_program() -> None:
    """No eval, exec, pickle, marshal in the package; a shell is started by the shell command alone."""
    for path in Path(pylmp.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            where = f"{path}:{getattr(node, 'lineno', 0)}"
            if isinstance(node, ast.Call):
                name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
                assert isinstance(node.func, ast.Attribute) or name not in ("eval", "exec", "compile", "__import__"), where
                assert ast.unparse(node.func) not in ("os.system", "os.popen", "tempfile.mktemp") and not any(word.arg == "shell" for word in node.keywords), where
                assert "/bin/sh" not in ast.dump(node) or path.name == "shell.py", where
            if isinstance(node, ast.Import | ast.ImportFrom):
                names = [alias.name for alias in node.names] + [getattr(node, "module", None) or ""]
                assert not {name.split(".")[0] for name in names} & {"pickle", "marshal", "shelve", "dill", "code"}, where
