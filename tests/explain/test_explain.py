"""What pylmp explain says is complete, and true: counts, box and defaults are those of real LAMMPS."""

from __future__ import annotations

import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from pylmp.cli import main
from pylmp.model.appetite import appetite
from pylmp.model.registry import REGISTRIES, THERMOS
from pylmp.model.units import UNITS
from pylmp.text.diagnostic import ScriptError
from pylmp.text.grammar import rules
from pylmp.tools.explain.forms import form_of, forms, read
from pylmp.tools.explain.pages import KINDS, command_page, style_page
from pylmp.tools.explain.plot import EXAMPLES, curve, draw
from pylmp.tools.explain.units import named
from pylmp.tools.explain.watch import watch
from tests.setup.both import on_lammps
from tests.support import lammps

ROOT = Path(__file__).parents[2]
STYLES = [(kind, name) for kind, word in KINDS.items() for name in REGISTRIES[word].names() if not name.isupper()]
STYLES += [("thermo_style", name) for name in THERMOS.names()]
MELT = """units lj
lattice fcc 0.8442
region box block 0 6 0 6 0 6
create_box 2 box
create_atoms 1 box
set group all type/fraction 2 0.25 12345
mass 1 1.0
mass 2 2.0
group heavy type 2
velocity all create 1.44 87287
pair_style lj/cut 2.5
pair_coeff * * 1.0 1.0
fix 1 all nve
"""


@pytest.mark.parametrize("name", sorted(rules()))
def test_each_command_can_be_explained(name: str) -> None:
    page = command_page(name)
    assert page.meaning and page.syntax and page.link.startswith("https://docs.lammps.org/") and page.link.endswith(".html")
    assert name in forms()


@pytest.mark.parametrize(("kind", "name"), STYLES)
def test_each_style_can_be_explained(kind: str, name: str) -> None:
    page = style_page(kind, name)
    assert (page.meaning or page.formula) and page.link.endswith(".html") and page.name == f"{kind} {name}"
    for coefficient, unit in page.coeffs:
        for system in UNITS:
            assert coefficient and (unit == "unitless" or named(unit, system)), unit


def test_forms_are_of_commands_and_styles_that_are_there() -> None:
    assert set(forms()) <= set(rules())
    for kind, each in forms().items():
        for form in each:
            name = {"fix": 2, "compute": 2, "region": 1}.get(kind, 0 if kind.endswith("_style") else None)
            if name is not None and len(form.arguments) > name and form.arguments[name].literal and form.arguments[name].name != "delete":
                assert (kind, form.arguments[name].name) in STYLES, form


@pytest.mark.parametrize("what", ["fix nosuch", "bond_style quartik", "nosuch", "in.nosuch", "bond_style table --plot x.png", "run --plot x.png", "bond_style morse --plot x.txt"])
def test_what_cannot_be_explained(what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["explain", *what.split()]) == 1
    said = capsys.readouterr().err
    assert said.startswith("ERROR: ") and "hint: " in said and not list(tmp_path.iterdir())


# ---- a script ---------------------------------------------------------------------------------------------------

DECKS = ["quartic_network", "plastic_tension_2d", "hybrid_bonds", "fene_melt", "micelle", "crystal_shear", "disk_impact", "indentation"]


@pytest.mark.parametrize("deck", DECKS)
def test_what_a_script_has_made_is_what_lammps_has_made(deck: str, tmp_path: Path) -> None:
    """Before the first run of decks: box, counts, groups, size of a step; and the temperature."""
    folder = ROOT / "inputs" / deck
    lines = next(folder.glob("in.*")).read_text().split("\n")
    first = next(k for k, line in enumerate(lines) if line.split()[:1] in (["run"], ["minimize"]))
    lines = [line for line in lines[:first] if line.split()[:1] != ["dump"] and line.split()[:1] != ["dump_modify"]]
    for path in folder.iterdir():
        if path.is_file() and not path.name.startswith("in."):
            (tmp_path / path.name).write_bytes(path.read_bytes())
    (tmp_path / "in.cut").write_text("\n".join(lines) + "\n")
    found = watch(tmp_path / "in.cut", []).facts
    asked = 'print "BOX $(xlo:%.7g) $(ylo:%.7g) $(zlo:%.7g) $(xhi:%.7g) $(yhi:%.7g) $(zhi:%.7g)"\nprint "DT $(dt:%.7g) ATOMS $(atoms)"\n'
    groups = {name[6:]: text for name, text in found.items() if name.startswith("group ")}
    asked += "".join(f'print "GROUP {name} $(count({name}))"\n' for name in groups)
    asked += 'print "BONDS $(bonds)"\n' if "bonds" in found else ""
    asked += 'run 0 post no\nprint "T $(temp:%.6g)"\n' if "temperature" in found else ""
    text = re.sub(r"quartic/(un)?breakable", "quartic", "\n".join(lines))
    done = lammps(f"{text}\n{asked}", tmp_path)
    log = done.log
    box = re.search(r"^BOX (.*)$", log, re.M)
    assert box, done.screen[-800:]
    numbers = re.findall(r"[-+\d.e]+", found["box"].split(") ")[0] + " " + found["box"].split("to ")[1].split(")")[0])
    assert np.allclose([float(w) for w in numbers[:6]], [float(w) for w in box[1].split()], rtol=1e-6, atol=1e-12)
    assert re.search(rf"^DT {re.escape(found['timestep'].split()[0])} ATOMS {found['atoms']}$", log, re.M), found
    for name, told in groups.items():
        assert f"GROUP {name} {told.split()[0]}\n" in log
    if "bonds" in found:
        assert f"\nBONDS {found['bonds']}\n" in log
    if "temperature" in found:
        assert float(log.split("\nT ")[1].split("\n")[0]) == pytest.approx(float(found["temperature"].split()[0]), rel=2e-6)


def test_nothing_is_written_nothing_moves_and_the_compiler_stays_away(tmp_path: Path) -> None:
    script = MELT + (
        "dump d all custom 10 d.dump id x\ndump e all atom 10 e.*.dump\nrestart 10 r.a r.b\nfix p all print 5 x file p.txt\nfix a all ave/time 1 1 1 c_thermo_temp file a.txt\n"
        "log other.log\nprint hello file hello.txt\nwrite_data before.data\nrun 1000\nwrite_restart x.rst\nwrite_dump all atom w.dump\ninfo system out overwrite info.txt\n"
        "labelmap atom 1 A 2 B\nlabelmap write labels\nminimize 1e-4 1e-4 100 100\nshell touch shelled\nprint \"$(step) $(xcm(all,x))\"\n"
    )  # fmt: skip
    (tmp_path / "in.script").write_text(script)
    code = "import sys\nfrom pylmp.cli import main\ncode = main(['explain', 'in.script'])\nprint('LOADED', 'numba' in sys.modules)\nsys.exit(code)"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0 and not done.stderr and "LOADED False" in done.stdout
    assert [path.name for path in tmp_path.iterdir()] == ["in.script"]
    assert "-> step: 0 -> 1000" in done.stdout and "Cannot run shell touch" in done.stdout and "The same scene as at line" not in done.stdout
    at = float(re.search(r"\|  1100 (\S+)", done.stdout)[1])  # type: ignore[index]
    start = MELT + 'print "at $(xcm(all,x))"\n'
    assert at == pytest.approx(float(re.search(r"^at (\S+)", "\n".join(on_lammps(start, tmp_path).log), re.M)[1]), rel=1e-12)  # type: ignore[index]


def explain(tmp_path: Path, capsys: pytest.CaptureFixture[str], script: str, *more: str, at: str = "") -> str:
    path = tmp_path / "in.script"
    path.write_text(script)
    assert main(["explain", f"{path}{at}", *more]) == 0
    return capsys.readouterr().out


def test_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = explain(tmp_path, capsys, MELT, at=":10")
    assert "velocity all create 1.44 87287" in text and "create_atoms" not in text
    for told in ("t            1.44 epsilon/kB", "seed         87287", "dist uniform, ", "loop all", "-> temperature: 1.44 epsilon/kB", "velocity.html"):
        assert told in text, told
    assert "a 1.0 (kcal/mol)/Angstrom" not in text
    assert main(["explain", f"{tmp_path}/in.script:99"]) == 1


def test_the_scene_says_what_is_left_out_and_why_an_engine_is_chosen(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = explain(tmp_path, capsys, MELT + "run 100\nrun 200\n")
    for told in ("Engine fast", "up to 2.5, from a list up to 2.8", "fix 1 (nve): before the forces, behind the forces", "bonds: atom_style atomic has none", "for 100 steps", "The same scene as at line 14"):
        assert told in text, told
    flat = MELT.replace("fix 1 all nve", "") + "run 1\n"
    assert "motion: no fix integrates" in explain(tmp_path, capsys, flat)


def test_the_engine_that_is_told_is_the_one_that_runs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for script in (MELT + "run 1\n", MELT + "neigh_modify exclude type 1 2\nneighbor 0.3 nsq\nrun 1\n"):
        told = re.search(r"^  Engine (\w+)", explain(tmp_path, capsys, script), re.M)
        assert main([str(tmp_path / "in.script"), "-log", "none"]) == 0
        ran = re.search(r"^Engine (\w+)", capsys.readouterr().out, re.M)
        assert told and ran and told[1] == ran[1]


def test_errors_are_told_and_the_rest_goes_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = explain(tmp_path, capsys, MELT + "fix 2 all langevin 1 1\nfix 3 all rigid single\nprint \"$(nosuch)\"\nvariable i loop 5\nlabel a\nprint $i\nnext i\njump SELF a\nrun 7\n")
    assert "!  " in text and "LAMMPS has fix rigid" in text and "(5 times)" in text and "for 7 steps" in text
    endless = explain(tmp_path, capsys, "label a\njump SELF a\n")
    assert "no more than 20000 commands are looked at" in endless


class Tags(HTMLParser):
    """Elements that are open at the end; where links go; what would be loaded."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.loads: list[str] = []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        if tag != "meta":
            self.open.append(tag)
        self.loads += [value or "" for name, value in attributes if name in ("src", "data", "srcset") or (name == "href" and tag != "a")]

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_a_page_for_a_browser(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script = MELT + 'variable x string "<b>&</b>"\nprint "<script>alert(1)</script> $x"\nrun 10\n'
    explain(tmp_path, capsys, script, "--html", str(tmp_path / "page.html"))
    text = (tmp_path / "page.html").read_text()
    tags = Tags()
    tags.feed(text)
    assert not tags.open and not tags.loads and "<script" not in text and "@import" not in text and "url(" not in text
    assert text.count("<details>") == len(script.splitlines()) and "864" in text and "Engine fast" in text


# ---- defaults, units, estimates ---------------------------------------------------------------------------------

HEAD = MELT + "compute c all msd\n"
LINES = [  # lines that leave out all keywords; what their form calls the defaults is then written out
    "velocity all create 2.0 4711", "velocity all set 0.1 NULL NULL", "velocity heavy ramp vx 0 1 y 0 6", "fix 2 all langevin 1 1 0.5 4711",
    "fix 2 all temp/berendsen 1 2 0.3", "region r sphere 3 3 3 2\ngroup g region r", "displace_atoms all random 0.05 0.05 0.05 99", "displace_atoms heavy move 0.01 0 0",
    "fix 2 all indent 10 sphere 3.1 2.9 3.2 1.1", "fix 2 all viscous 0.2", "fix 2 all deform 1 x erate 0.1",
    "compute m all msd\nthermo_style custom step temp c_m[4]", "compute m all reduce sum vx\nthermo_style custom step c_m",
    "compute m all group/group heavy\nthermo_style custom step c_m", "neigh_modify", "min_modify\nminimize 1e-3 1e-3 20 40", "pair_modify",
    "fix 2 heavy recenter NULL INIT 3", "fix 2 heavy move linear 0.1 0 0",
]  # fmt: skip


@pytest.mark.parametrize("line", LINES)
def test_defaults_are_those_of_lammps(line: str, tmp_path: Path) -> None:
    """LAMMPS does the same with a keyword left out as with its default written out."""
    words = line.split("\n")[0].split()
    form = form_of(words[0], words[1:])
    assert form is not None
    extra = [f"{name} {value}" for name, value in form.keywords.items() if value not in ("none", "GROUP") and (name, words[0]) not in SAID_OTHERWISE]
    said = "\n".join([f"{' '.join(words)} {' '.join(extra)}", *line.split("\n")[1:]])
    short, full = (on_lammps(f"{HEAD}{text}\nrun 5\n", tmp_path) for text in (line, said))
    if words[0].endswith("_modify"):  # a line of its own may not be empty
        short = on_lammps("\n".join([HEAD, *line.split("\n")[1:]]) + "\nrun 5\n", tmp_path)
    assert not short.error and not full.error, (short.error, full.error, said)
    assert np.array_equal(short.arrays["x"], full.arrays["x"]) and np.array_equal(short.arrays["v"], full.arrays["v"])
    rows = [[row for row in made.log if re.match(r"\s+\d+ ", row)] for made in (short, full)]
    assert rows[0] == rows[1]


# keywords that take no value as their default has it, or that this deck cannot say
SAID_OTHERWISE = {("scale", "fix"), ("bias", "velocity"), ("compute", "pair_modify"), ("table", "pair_modify"), ("binsize", "neigh_modify"), ("include", "neigh_modify"), ("every", "fix")}


def test_units_are_named_in_each_system() -> None:
    assert named("force", "real") == "(kcal/mol)/Angstrom" and named("energy/distance^2", "metal") == "eV/Angstrom^2"
    assert named("temperature", "si") == "K" and named("unitless", "lj") == "" and named("distance*", "cgs") == "lattice spacings"
    given = {one.name: one for one in read("region", ["b", "block", *"010101", "units", "box"])}
    assert given["XLO"].unit == "distance" and given["units"].value == "box" and given["side"].default


def test_counts_that_memory_is_estimated_from(tmp_path: Path) -> None:
    """Ghosts and neighbors of a liquid, as LAMMPS counts them."""
    from pylmp.model.console import Console
    from pylmp.model.simulation import Simulation
    from tests.support import simulate

    sim, _ = simulate(MELT.replace("fix 1 all nve", ""), tmp_path)
    sim.init()
    wanted = appetite(sim)
    log = lammps(MELT + "run 0\n", tmp_path / "lammps").log
    ghosts = float(re.search(r"Nghost:\s+(\S+)", log)[1])  # type: ignore[index]
    neighbors = float(re.search(r"Total # of neighbors = (\d+)", log)[1])  # type: ignore[index]
    assert wanted.ghosts == pytest.approx(ghosts, rel=0.1) and wanted.neighbors == pytest.approx(neighbors, rel=0.1)
    assert isinstance(Simulation(Console()), Simulation)


@pytest.mark.parametrize("shape", ["block 0 40 0 40 3 3.5", "sphere 20 20 20 3", "block 0 40 3 3.5 3 3.5"])
def test_sheets_balls_and_threads_in_a_large_box_are_not_taken_for_more_than_they_are(shape: str, tmp_path: Path) -> None:
    from tests.support import simulate

    head = f"units lj\nlattice sc 8.0\nregion b block 0 40 0 40 0 40\nregion s {shape}\ncreate_box 1 b\ncreate_atoms 1 region s\nmass 1 1\n"
    force = "displace_atoms all random 0.01 0.01 0.01 5\npair_style lj/cut 2.5\npair_coeff * * 1 1\n"
    sim, _ = simulate(head + force, tmp_path)
    sim.init()
    log = lammps(head + force + "run 0\n", tmp_path / "lammps").log
    neighbors = float(re.search(r"Total # of neighbors = (\d+)", log)[1])  # type: ignore[index]
    assert 0.6 * neighbors < appetite(sim).neighbors < 2.5 * neighbors


@pytest.mark.parametrize(("kind", "name"), EXAMPLES)
def test_curves(kind: str, name: str) -> None:
    """The force that is drawn is the slope of the energy that is drawn; what is marked lies in the picture."""
    r, energy, force, marks = curve(kind, name, None)
    assert all(0.0 <= place <= 1.1 * r[-1] for place in marks.values()) and marks
    if name.startswith("bpm/"):  # the energies of these are not those of their forces
        return
    slope = -np.gradient(energy, r, edge_order=2)
    inner = np.isfinite(slope) & np.isfinite(force)
    scale = np.abs(force[inner]) + 0.02 * np.nanmedian(np.abs(force))
    assert (np.abs(slope - force)[inner] < 0.03 * scale).mean() > 0.98  # but where the energy ends with a step, and at the ends


def test_pictures(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "quartic.svg"
    assert main(["explain", "bond_style", "quartic", "--plot", str(path)]) == 0
    assert "<svg" in path.read_text() and "Drawn" in capsys.readouterr().out
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(ScriptError, match="no matplotlib") as refused:
        draw("bond_style", "quartic", None, path)
    assert "pip install" in refused.value.diagnostic.hint
