"""pylmp bench: small scripts from end to end, its errors, the page it writes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from pylmp.cli import main
from pylmp.text.diagnostic import ScriptError
from pylmp.tools.bench import child, page, scaling
from pylmp.tools.bench.contenders import NAMES, contender
from pylmp.tools.bench.main import DECKS
from pylmp.tools.bench.measure import measure
from tests.bench import TINY


def bench(*words: str | Path, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "pylmp", "bench", *map(str, words)], env={**os.environ, **environment},
        capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip


@pytest.fixture
def tiny(tmp_path: Path) -> Path:
    script = tmp_path / "in.tiny"
    script.write_text(TINY)
    return script


# ---- from end to end -------------------------------------------------------------------------------------------------


def test_every_engine_runs_a_small_script(tiny: Path) -> None:
    done = bench(tiny, "--engines", ",".join(NAMES), "--repeat", "1", "--json", "--var", "steps", "20")
    assert done.returncode == 0, done.stdout + done.stderr
    (script,) = json.loads(done.stdout)["scripts"]
    assert script["title"] == "A small liquid."
    assert [engine["engine"] for engine in script["engines"]] == list(NAMES)
    for engine in script["engines"]:
        assert (engine["atoms"], engine["steps"], len(engine["runs"])) == (256, 20, 1)
        assert engine["ran"] == engine["engine"]
        assert engine["ratio"] > 0.0
        assert engine["peak_bytes"] > 1_000_000
        assert engine["ratio_by_cpu"] is None or engine["threads"] == 1
    assert [path.name for path in tiny.parent.iterdir()] == ["in.tiny"]


def test_the_engine_that_really_ran_is_named(tiny: Path) -> None:
    bonds = TINY.replace("units lj", "units lj\natom_style bond").replace("create_box 1 b", "create_box 1 b bond/types 1")
    quartic = "pair_modify compute no\nspecial_bonds lj/coul 1 1 1\nbond_style quartic\nbond_coeff 1 1200 -0.55 0.25 1.3 34.6878\n"
    tiny.write_text(bonds.replace("fix 1", f"{quartic}fix 1"))
    done = bench(tiny, "--engines", "fast", "--repeat", "1", "--var", "steps", "20")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "pylmp, fast (ran on exact)" in done.stdout
    assert "engine fast lacks pair_modify compute no with bond_style quartic" in done.stdout


def test_a_wrong_script_is_answered_with_its_error(tiny: Path) -> None:
    tiny.write_text(TINY.replace("lj/cut 2.5", "lj/cat 2.5"))
    done = bench(tiny, "--repeat", "1")
    assert done.returncode == 1
    for title in ("pylmp, fast failed", "LAMMPS, serial failed"):
        assert f"{title}: ERROR: Unrecognized pair style 'lj/cat'" in done.stdout
    assert "Traceback" not in done.stdout + done.stderr


def test_a_script_that_only_lammps_runs(tiny: Path) -> None:
    tiny.write_text(TINY.replace("fix 1", "suffix off\npair_style born 2.5\npair_coeff * * 1 1 1 1 1\nfix 1"))
    done = bench(tiny, "--repeat", "1", "--json")
    fast, serial = json.loads(done.stdout)["scripts"][0]["engines"]
    assert done.returncode == 5
    assert "LAMMPS has pair_style born" in fast["failed"]
    assert serial["failed"] is None


def test_what_cannot_be_measured(tiny: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    tiny.write_text("units lj\nprint 'nothing'\n")
    assert main(["bench", str(tiny), "--engines", "lammps", "--repeat", "1"]) == 1
    assert "ends without a run" in capfd.readouterr().out
    assert main(["bench", str(tmp_path / "in.none")]) == 1
    assert "Cannot open input script" in capfd.readouterr().err
    assert main(["bench", "--all", "--decks", str(tmp_path / "nowhere")]) == 1
    assert "--decks FOLDER" in capfd.readouterr().err
    for wrong in ([], [str(tiny), "--all"], [str(tiny), "--engines", "gpu"], [str(tiny), "--repeat", "0"], [str(tiny), "--var", "x"]):
        assert main(["bench", *wrong]) == 2
    assert "usage: pylmp bench" in capfd.readouterr().err


def test_without_lammps(tiny: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("pylmp.engines.lammps._packaged", lambda package, ending: None)
    monkeypatch.setattr("shutil.which", lambda name: None)
    for name in ("lammps", "mpi2"):
        assert main(["bench", str(tiny), "--engines", name, "--repeat", "1"]) == 1
        said = capfd.readouterr().err
        assert "ERROR: LAMMPS is not installed" in said
        assert "pylmp[reference]" in said
    assert main(["bench", str(tiny), "--engines", "fast", "--repeat", "1", "--var", "steps", "5"]) == 0


def test_a_run_without_end_is_ended(tiny: Path) -> None:
    begun = time.monotonic()
    done = bench(tiny, "--engines", "lammps,mpi2", "--repeat", "3", "--timeout", "1.5", "--var", "steps", "100000000")
    assert time.monotonic() - begun < 30.0
    assert done.returncode == 1
    assert done.stdout.count("no end after 1.5 s") == 2


def test_a_child_and_what_it_started_are_ended_together(tmp_path: Path) -> None:
    late = f"import time,pathlib; time.sleep(3); pathlib.Path({str(tmp_path / 'late')!r}).touch()"
    code = f"import subprocess,sys; subprocess.Popen([sys.executable, '-c', {late!r}]); import time; time.sleep(60)"
    with pytest.raises(subprocess.TimeoutExpired):
        child.run([sys.executable, "-c", code], tmp_path, os.environ, 1.0)
    time.sleep(3.5)
    assert not (tmp_path / "late").exists()


def test_memory_of_a_child(tmp_path: Path) -> None:
    """Measured from a process that is small itself, as the command is: no child counts for less than who started it."""
    code = (
        "import os, pathlib, sys\nfrom pylmp.tools.bench import child\nfor n in (1, 200_000_000):\n"
        "    done = child.run([sys.executable, '-c', f'print(len(bytearray(b\"x\") * {n}))'], pathlib.Path('.'), os.environ, None)\n"
        "    print(done.code, done.said.strip(), done.peak)\n"
    )
    said = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True).stdout.split()
    assert said[:2] + said[3:5] == ["0", "1", "0", "200000000"]
    small, large = int(said[2]), int(said[5])
    assert small < 80e6
    assert 200e6 < large < 440e6


# ---- scaling, page ---------------------------------------------------------------------------------------------------


def test_scaling_and_the_page_it_writes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scaling, "CELLS", (5, 6))
    who = [contender("fast"), contender("lammps")]
    switches = ["-var", "steps", "20"]
    results = scaling.scale(DECKS, who, 1, switches, None, False, lambda text: None)
    assert [(r.rows[0].samples[0].loop.atoms, r.rows[0].samples[0].loop.steps) for r in results] == [(500, 20), (864, 20)]
    head, *sizes = scaling.rows(results)
    assert head[1:] == ("pylmp, fast, CPU ns/atom/step", "LAMMPS, serial, CPU ns/atom/step", "pylmp, fast, MB", "LAMMPS, serial, MB")
    assert [row[0] for row in sizes] == ["500", "864"]
    assert len(scaling.growth(results)) == 2
    target = tmp_path / "page.md"
    target.write_text("# Mine\n\nbefore\n\n<!-- scaling -->\nold\n<!-- end -->\n\nafter\n")
    for said in ("first", scaling.text(results, bars=True)):
        plot = page.write(target, "scaling", said, results)
    text = target.read_text()
    assert text.startswith("# Mine\n\nbefore\n\n<!-- scaling -->\n")
    assert text.endswith("<!-- end -->\n\nafter\n")
    assert "| 864 " in text.replace("|   ", "| ")
    assert "old" not in text and "first" not in text
    assert plot.name == "page-scaling.svg"
    assert "ns of CPU time per atom and step" in plot.read_text()


def test_scaling_from_the_command_line(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(scaling, "CELLS", (4,))
    monkeypatch.setattr(scaling, "LARGEST", 5)
    words = ["bench", "--scaling", "--largest", "--engines", "lammps", "--repeat", "1", "--var", "steps", "20"]
    assert main(words) == 0
    said = capfd.readouterr().out
    assert "an atom's step of the largest takes" in said
    assert main([*words, "--json"]) == 0
    report = json.loads(capfd.readouterr().out)
    assert report["scaling"] is True
    assert [script["engines"][0]["atoms"] for script in report["scripts"]] == [256, 500]


def test_all_scripts_of_a_folder(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """One that fails does not keep the others from being measured."""
    for name, text in {"in.A_2": TINY, "in.A_1": TINY, "in.A2_x": "nonsense\n", "notes": "none"}.items():
        (tmp_path / name).write_text(text)
    assert main(["bench", "--all", "--decks", str(tmp_path), "--engines", "lammps", "--repeat", "1", "--json"]) == 1
    scripts = json.loads(capfd.readouterr().out)["scripts"]
    assert [script["script"] for script in scripts] == ["in.A_1", "in.A_2", "in.A2_x"]
    assert ["Unknown command: nonsense" in (script["engines"][0]["failed"] or "") for script in scripts] == [False, False, True]


def test_a_page_of_ratios(tiny: Path, tmp_path: Path) -> None:
    target = tmp_path / "new.md"
    assert main(["bench", str(tiny), "--engines", "lammps,opt", "--repeat", "1", "--write", str(target)]) == 0
    assert "`in.tiny`" in target.read_text()
    assert "LAMMPS, -sf opt" in (tmp_path / "new-bench.svg").read_text()
    target.write_text("no marks")
    with pytest.raises(ScriptError, match="has no lines"):
        page.write(target, "bench", "", [])


def test_the_manual_s_words_are_put_for_lammps(tiny: Path) -> None:
    tiny.write_text(TINY.replace("run 5\n", "").replace("fix 1", "dump 1 all custom 5 d id\ndump_modify 1 write_header no\nfix 1"))
    result = measure(tiny, [contender("lammps")], 1, ["-var", "steps", "20"], None)
    assert result.code == 0, result.rows[0].said
    assert "header no" in result.notes[0]
