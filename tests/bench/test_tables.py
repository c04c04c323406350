"""pylmp bench: what it reads of logs, its table, its JSON."""

from __future__ import annotations

import json
from pathlib import Path

from pylmp.tools.bench import table
from pylmp.tools.bench.contenders import contender
from pylmp.tools.bench.log import Loop, complaint, loops
from pylmp.tools.bench.measure import Result, Row, Sample, _compare
from pylmp.tools.bench.report import as_dict
from tests.bench import TINY
from tests.support import lammps

# ---- logs ------------------------------------------------------------------------------------------------------------


def test_the_loops_of_lammps_s_own_log(tmp_path: Path) -> None:
    runs = loops(lammps(TINY, tmp_path).log)
    assert [(run.steps, run.atoms) for run in runs] == [(5, 256), (50, 256)]
    assert all(run.seconds > 0.0 and run.share is not None for run in runs)
    assert all(run.instead is None for run in runs)
    assert list(runs[1].sections) == ["Pair", "Neigh", "Comm", "Output", "Modify", "Other"]
    assert 0.5 < sum(runs[1].sections.values()) / runs[1].seconds < 1.01


def test_who_stepped_in_is_read_run_by_run() -> None:
    end = "Loop time of {} on 1 procs for 10 steps with 4 atoms\n\n99.5% CPU use with {} MPI tasks x 1 OpenMP threads\n"
    log = f"Engine exact for this run: engine fast lacks neighbor nsq\n{end.format(0.5, 1)}{end.format(0.25, 2)}"
    assert loops(log) == [
        Loop(0.5, 10, 4, 0.995, "exact", "engine fast lacks neighbor nsq"),
        Loop(0.25, 10, 4, 1.99),
    ]
    assert loops("Loop time of 0.1 on 1 procs for 3 steps with 2 atoms\n") == [Loop(0.1, 3, 2, None)]
    assert loops("no run here\n") == []


def test_what_a_failed_run_said() -> None:
    assert complaint("much\nERROR: Illegal fix command (in.x:3)\nLast input line: fix 1\n").startswith("ERROR: Illegal fix")
    assert complaint("killed") == "killed"
    assert len(complaint("x" * 9000)) == 500


# ---- table -----------------------------------------------------------------------------------------------------------


def rows() -> list[Row]:
    """LAMMPS 1, 4, 2 s; fast, half of each, at half a processor; mpi2 failed."""
    result = []
    for name, times, share in (("fast", (0.5, 2.0, 1.0), 0.5), ("lammps", (1.0, 4.0, 2.0), 1.0)):
        samples = [Sample(Loop(t, 10, 1000, share), t + 0.25, 0.25, 2_000_000) for t in times]
        first = Sample(Loop(1.0, 10, 1000, share), 9.25, 8.25, 0) if name == "fast" else None
        result.append(Row(contender(name), first, samples))
    result.append(Row(contender("mpi2"), None, [], 1, "ERROR: no"))
    _compare(result)
    return result


def test_ratios_are_those_of_each_round() -> None:
    fast, serial, failed = rows()
    assert (fast.ratio, fast.by_cpu) == (2.0, 4.0)
    assert (serial.ratio, serial.by_cpu) == (1.0, 1.0)
    assert (failed.ratio, failed.by_cpu) == (None, None)
    assert fast.compiling == 8.0


def test_no_ratio_of_processor_times_that_are_zero() -> None:
    fast, serial = (Row(contender(name), None, [Sample(Loop(0.001, 10, 9, 0.0), 1.0, 0.9, 0)]) for name in ("fast", "lammps"))
    _compare([fast, serial])
    assert (fast.ratio, fast.by_cpu) == (1.0, None)


def test_the_table_says_medians_and_spread() -> None:
    result = Result(Path("in.x"), "a title", rows(), [])
    lines = table.text([result]).splitlines()
    assert lines[:2] == ["in.x: 1000 atoms, 10 steps, 3 rounds", "  a title"]
    assert lines[2].split()[:4] == ["engine", "ns/atom/step", "least", "most"]
    assert lines[3].split() == "pylmp, fast 100000 50000 200000 50000 10.0 2.00 4.00 50% 0.25 9.25".split()
    assert lines[4].split() == "LAMMPS, serial 200000 100000 400000 200000 5.00 1.00 1.00 100% 0.25 -".split()
    assert lines[5].split()[:5] == ["LAMMPS,", "mpiexec", "-n", "2", "failed"]
    assert lines[6] == "  LAMMPS, mpiexec -n 2 failed: ERROR: no"
    assert len({len(line) for line in table.markdown([result]).splitlines()[:5]}) == 1


def test_the_parts_of_a_loop() -> None:
    """Of the processor's time: half of what a loop took that was kept waiting for half of it."""
    row = Row(contender("fast"), None, [Sample(Loop(t, 10, 1000, 0.5, sections={"Pair": t / 2, "Other": t / 4}), t, 0.0, 0) for t in (1, 2, 4)])
    head, cells = table.parts([Result(Path("in.x"), "", [row], [])])
    assert dict(zip(head, cells, strict=True)) == {"script": "`in.x`", "engine": "pylmp, fast"} | {
        name: {"Pair": "50000", "Other": "25000"}.get(name, "0.00") for name in table.PARTS
    }


def test_json_holds_every_run() -> None:
    whole = json.loads(json.dumps(as_dict([Result(Path("in.x"), "a title", rows(), ["n"])], {"cores": 2})))
    assert (whole["schema"], whole["machine"]) == (1, {"cores": 2})
    (script,) = whole["scripts"]
    fast, serial, failed = script["engines"]
    assert [run["seconds"] for run in fast["runs"]] == [0.5, 2.0, 1.0]
    assert {k: fast[k] for k in ("ran", "median", "least", "most", "ratio", "ratio_by_cpu", "steps_per_second", "peak_bytes")} == {
        "ran": "fast", "median": 1.0, "least": 0.5, "most": 2.0, "ratio": 2.0, "ratio_by_cpu": 4.0, "steps_per_second": 10.0,
        "peak_bytes": 2_000_000,
    }  # fmt: skip
    assert serial["first"] is None
    assert (failed["failed"], failed["runs"]) == ("ERROR: no", [])
    assert "median" not in failed
