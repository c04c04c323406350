"""pylmp diff against real LAMMPS, and script against script, with differences that are known."""

from __future__ import annotations

import subprocess
import sys
import xml.dom.minidom
from pathlib import Path

import pytest

from pylmp.tools.diff.measure import histogram
from tests.diff.decks import BREAK, diff, liquid, scripts

np = pytest.importorskip("numpy")


@pytest.fixture(scope="module")
def fast(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict, Path]:
    """The fast engine against LAMMPS, chaos enough for the roundings to grow; the page beside it."""
    folder = tmp_path_factory.mktemp("fast")
    (script,) = scripts(folder, liquid(steps=1500, fixes='print "<&>"'))
    page = folder / "page.html"
    return diff(script, "--engine", "fast", "--noise", "--html", page), page


def test_exact_is_identical(tmp_path: Path) -> None:
    (script,) = scripts(tmp_path, liquid(steps=60))
    report = diff(script)
    assert report["verdict"] == "identical"
    (run,) = report["runs"]
    assert (run["first"], run["last"], run["atoms"]) == (0, 60, [108, 108])
    assert all(gap["largest"] == 0.0 for part in ("start", "end") for gap in run[part].values())
    assert len(run["curve"]) >= 15
    assert run["ulps"] == [[0, 324]]
    assert report["shadow"] is None


def test_fast_is_round_off(fast: tuple[dict, Path]) -> None:
    report, _ = fast
    assert report["verdict"] == "round-off"
    (run,) = report["runs"]
    assert 0.0 < run["start"]["f"]["relative"] < 1e-12
    assert sum(count for _, count in run["ulps"]) == 324
    assert run["end"]["x"]["largest"] > 1e-10
    assert {column["name"] for column in run["columns"] if column["first"] is not None} >= {"Temp", "Press"}


def test_roundings_grow_at_the_rate_of_the_reference(fast: tuple[dict, Path]) -> None:
    """The rate at which the engines part is the system's own, as its shadow shows it."""
    report, _ = fast
    mine, own = report["growth"]["rate"], report["shadow"]["growth"]["rate"]
    assert 0.6 < mine / own < 1.6
    assert own > 1e-3


def test_the_reference_has_noise(fast: tuple[dict, Path]) -> None:
    report, _ = fast
    two, unsorted = report["noise"]["itself on two processes"], report["noise"]["itself without sorting of atoms"]
    assert not two["identical"]
    assert two["runs"][0]["curve"][-1]["x"] > 1e-12
    assert unsorted["runs"]


def test_the_page_is_well_formed(fast: tuple[dict, Path]) -> None:
    report, path = fast
    page = xml.dom.minidom.parse(str(path))
    assert not page.getElementsByTagName("script")
    assert not [
        node for node in page.getElementsByTagName("*") if node.hasAttribute("src") or node.hasAttribute("href")
    ]
    lines = page.getElementsByTagName("polyline")
    assert len(lines) == 4  # the engines, the shadow, two kinds of noise
    drawn = lines[0].getAttribute("points").split()
    assert len(drawn) == sum(1 for point in report["runs"][0]["curve"] if point["x"] > 0.0)
    heights = [float(point.split(",")[1]) for point in drawn]
    assert heights[-1] < heights[0]  # up is more
    assert report["verdict"] in "".join(node.data for node in _texts(page))


def _texts(node) -> list:
    if node.nodeType == node.TEXT_NODE:
        return [node]
    return [text for child in node.childNodes for text in _texts(child)]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"epsilon": 1.001}, "forces differ"),
        ({"seed": 4711}, "velocities differ"),
        ({"fixes": "fix 2 all viscous 1e-6"}, "forces differ"),
        ({"dt": 0.004}, "atoms are"),
        ({"steps": 190}, "thermo lines"),
    ],
)
def test_another_script_is_different(tmp_path: Path, change: dict, said: str) -> None:
    report = diff(*scripts(tmp_path, liquid(steps=100), liquid(**{"steps": 100} | change)))
    assert report["verdict"] == "different"
    assert any(said in reason for reason in report["reasons"]), report["reasons"]


def test_an_atom_that_is_1e_14_away_is_round_off(tmp_path: Path) -> None:
    moved = liquid(steps=400, before="group one id 7\ndisplace_atoms one move 1e-14 0 0 units box")
    report = diff(*scripts(tmp_path, liquid(steps=400), moved))
    assert report["verdict"] == "round-off"
    assert 0.0 < report["runs"][0]["start"]["x"]["largest"] < 3e-14
    assert report["runs"][0]["curve"][-1]["x"] > 1e-13


def test_a_bond_that_breaks_a_step_later(tmp_path: Path) -> None:
    """It breaks where its length, 1.125 + step / 64, is first beyond the limit."""
    report = diff(*scripts(tmp_path, BREAK.format(limit=1.26), BREAK.format(limit=1.27)))
    first = report["runs"][0]["ledger"]["first"]
    assert report["verdict"] == "different"
    assert (first["ends"], first["mine"], first["theirs"], first["step"]) == ([1, 2], 9, 10, 9)
    assert first["margin"] == pytest.approx((1.27 - (1.125 + 9 / 64)) / 1.27, rel=1e-9)
    assert first["tie"] is False


def test_a_tie_is_no_bug(tmp_path: Path) -> None:
    """At step 8 the bond is 1.25 long, exactly: one script's limit is that, the other's one rounding less."""
    report = diff(*scripts(tmp_path, BREAK.format(limit=1.25), BREAK.format(limit="1.2499999999999998")))
    first = report["runs"][0]["ledger"]["first"]
    assert (first["mine"], first["theirs"], first["tie"]) == (9, 8, True)
    assert report["verdict"] == "round-off"
    assert "tie at step 8" in report["reasons"][0]


def test_ledger_lists_what_broke_in_lammps_too(tmp_path: Path) -> None:
    report = diff(*scripts(tmp_path, BREAK.format(limit=1.26)), "--ledger")
    assert report["verdict"] == "identical"
    assert report["runs"][0]["ledger"]["bonds"] == [[{"ends": [1, 2], "type": 1, "step": 9}]] * 2


def test_histogram() -> None:
    a = np.array([[1.0, 0.0, -1.0]])
    b = np.array([[np.nextafter(1.0, 2.0), -0.0, -1.0 - 5 * 2.0**-52]])
    assert histogram(a, b) == [(0, 1), (1, 1), (8, 1)]


def test_windows_from_the_same_state(tmp_path: Path) -> None:
    """Along a chaotic run the error of a window stays that of its steps; the exact engine's is none."""
    (script,) = scripts(tmp_path, liquid(steps=600, temp=3.0))
    report = diff(script, "--engine", "fast", "--resync", "100")
    windows = report["resync"]["windows"]
    assert [window["step"] for window in windows] == [0, 100, 200, 300, 400, 500]
    assert all(0.0 < window["x"] < 1e-11 for window in windows)
    assert windows[-1]["x"] < 0.1 * report["runs"][0]["curve"][-1]["x"]
    assert all(window["x"] == window["v"] == 0.0 for window in diff(script, "--resync", "100")["resync"]["windows"])


def test_windows_need_a_straight_script(tmp_path: Path) -> None:
    (script,) = scripts(tmp_path, liquid(steps=5) + "label here\n")
    done = subprocess.run(
        [sys.executable, "-m", "pylmp", "diff", script, "--resync", "5"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert "--resync cannot follow a script with label" in done.stderr
