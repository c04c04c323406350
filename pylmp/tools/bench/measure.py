"""Measuring: the contenders run a script in turn, round after round, each run in a folder of its own."""

from __future__ import annotations

import shutil
import statistics
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from pylmp.tools.bench import child
from pylmp.tools.bench.contenders import SERIAL, Contender
from pylmp.tools.bench.log import Loop, complaint, loops
from pylmp.tools.diff.dialect import translate

OK, WRONG, UNSUPPORTED = 0, 1, 5


@dataclass(frozen=True)
class Sample:
    """One run. loop: the script's last run command. rest: seconds of the process outside of all loops. peak: bytes."""

    loop: Loop
    whole: float
    rest: float
    peak: int

    @property
    def cpu(self) -> float:
        """Processor seconds of the loop, of a program of one thread."""
        return self.loop.seconds * min(1.0, 1.0 if self.loop.share is None else self.loop.share)


@dataclass
class Row:
    """One contender's runs. first: a native engine's run before the measured ones, which may compile.

    ratio: LAMMPS serial's loop over this one's, median of the rounds; by_cpu: the same of processor time, for one thread.
    """

    contender: Contender
    first: Sample | None = None
    samples: list[Sample] = field(default_factory=list)
    code: int = OK
    said: str | None = None
    ratio: float | None = None
    by_cpu: float | None = None

    @property
    def seconds(self) -> list[float]:
        return [sample.loop.seconds for sample in self.samples]

    def median(self, of: Callable[[Sample], float]) -> float:
        return statistics.median(of(sample) for sample in self.samples)

    @property
    def work(self) -> int:
        """Atoms times steps of the measured loop."""
        loop = self.samples[0].loop
        return loop.atoms * loop.steps

    @property
    def compiling(self) -> float | None:
        """Seconds the first run took longer than the others: kernels that were not in the store."""
        return max(0.0, self.first.whole - self.median(lambda s: s.whole)) if self.first and self.samples else None


@dataclass
class Result:
    """One script measured. title: its first line, if that is a comment. notes: what was changed for LAMMPS."""

    script: Path
    title: str
    rows: list[Row]
    notes: list[str]

    @property
    def code(self) -> int:
        return next((row.code for row in self.rows if row.code), OK)


def measure(
    script: Path,
    contenders: Sequence[Contender],
    repeat: int,
    switches: Sequence[str],
    timeout: float | None,
    tell: Callable[[str], None] = lambda text: None,
) -> Result:
    """Run the script `repeat` times on each contender. One that fails leaves, with what it said; the others go on.

    Raises ScriptError when the script is not there.
    """
    lines = script.read_text(errors="surrogateescape").splitlines()
    dialect = translate(lines)
    title = lines[0].lstrip("# ") if lines and lines[0].startswith("#") else script.name
    result = Result(script, title, [Row(one) for one in contenders], dialect.notes)

    def attempt(row: Row, which: str) -> Sample | None:
        tell(f"{script.name}: {row.contender.title}, {which}")
        rewritten = dialect.rewritten if dialect.notes and not row.contender.native else None
        return _attempt(row, script, rewritten, switches, timeout)

    for row in result.rows:
        if row.contender.native:
            row.first = attempt(row, "first run")
    for k in range(repeat):
        for row in result.rows:
            if row.said is None and (sample := attempt(row, f"round {k + 1} of {repeat}")):
                row.samples.append(sample)
    _compare(result.rows)
    return result


def _attempt(row: Row, script: Path, rewritten: list[str] | None, switches: Sequence[str], timeout: float | None) -> Sample | None:
    """One run; None if it failed, and then the row says how."""
    with tempfile.TemporaryDirectory(prefix="pylmp-bench-") as place:
        folder = Path(place)
        for path in script.parent.iterdir():
            if path.is_file() and path.name != "log.lammps":
                shutil.copy2(path, folder / path.name)
        if rewritten:
            (folder / script.name).write_text("\n".join(rewritten) + "\n", errors="surrogateescape")
        one = row.contender
        try:
            done = child.run(one.command(script.name, switches), folder, one.environment, timeout)
        except subprocess.TimeoutExpired:
            row.code, row.said = WRONG, f"no end after {timeout:g} s; --timeout gives it longer"
            return None
        log = folder / "log.lammps"
        text = log.read_text(errors="replace") if log.is_file() else ""
    if done.code:
        row.code = UNSUPPORTED if one.native and done.code == UNSUPPORTED else WRONG
        row.said = complaint(text if "ERROR" in text else text + done.said) or f"exit code {done.code}"
        return None
    runs = loops(text)
    if not runs or not runs[-1].steps or not runs[-1].atoms or runs[-1].seconds <= 0.0:
        row.code, row.said = WRONG, "nothing to measure: the script ends without a run of some steps"
        return None
    return Sample(runs[-1], done.seconds, done.seconds - sum(run.seconds for run in runs), done.peak)


def _compare(rows: list[Row]) -> None:
    """Ratios to LAMMPS serial, round by round: what slows the machine down for a while slows both."""
    serial = next((row for row in rows if row.contender.name == SERIAL and row.said is None), None)
    if serial is None:
        return
    for row in rows:
        if row.said is None:
            pairs = list(zip(serial.samples, row.samples, strict=True))
            row.ratio = statistics.median(a.loop.seconds / b.loop.seconds for a, b in pairs)
            shares = [a.cpu / b.cpu for a, b in pairs if a.cpu > 0.0 and b.cpu > 0.0]  # a very short loop may seem to take none
            if row.contender.threads == 1 and shares:
                row.by_cpu = statistics.median(shares)
