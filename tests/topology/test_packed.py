"""Data files that are gzip-compressed: both programs read ours; bombs, torn and false ones end with a sentence."""

from __future__ import annotations

import gzip
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pylmp.io import packed
from pylmp.text.diagnostic import ScriptError
from tests.setup.both import on_lammps, on_pylmp
from tests.support import simulate
from tests.topology.support import Network

HEAD = "units lj\natom_style full\n"


def test_written_compressed_and_read_by_both(tmp_path: Path) -> None:
    (tmp_path / "in.data").write_text(Network(3, "full", 3, "ppp").text())
    plain = on_pylmp(f"{HEAD}read_data in.data\nwrite_data a.data.gz\nwrite_data a.data\n", tmp_path)
    assert gzip.decompress((tmp_path / "a.data.gz").read_bytes()) == (tmp_path / "a.data").read_bytes()
    for program in (on_lammps, on_pylmp):
        made = program(f"{HEAD}read_data {tmp_path}/a.data.gz\n", tmp_path)
        assert not made.error
        for name in ("x", "v", "id", "type", "image"):
            assert np.array_equal(made.arrays[name], plain.arrays[name])


def test_several_members_and_plain_text_under_a_false_name(tmp_path: Path) -> None:
    text = Network(4, "full", 3, "ppp").text()
    half = len(text) // 2
    (tmp_path / "two.gz").write_bytes(gzip.compress(text[:half].encode()) + gzip.compress(text[half:].encode()))
    (tmp_path / "text.gz").write_text(text)  # as LAMMPS writes it
    (tmp_path / "plain").write_text(text)
    arrays = [on_pylmp(f"{HEAD}read_data {name}\n", tmp_path).arrays["x"] for name in ("two.gz", "text.gz", "plain")]
    assert np.array_equal(arrays[0], arrays[2]) and np.array_equal(arrays[1], arrays[2])


def test_torn_files(tmp_path: Path) -> None:
    whole = gzip.compress(Network(5, "full", 3, "ppp").text().encode())
    sentences = set()
    for end in range(2, len(whole), 37):
        (tmp_path / "torn.gz").write_bytes(whole[:end])
        sentences.add(on_pylmp(f"{HEAD}read_data torn.gz\n", tmp_path).error)
    assert "Unexpected end of data file" in sentences
    damaged = bytearray(whole)
    damaged[len(whole) // 2] ^= 0x55
    (tmp_path / "torn.gz").write_bytes(bytes(damaged))
    with pytest.raises(ScriptError, match="Cannot read file torn.gz: it is damaged"):
        simulate(f"{HEAD}read_data torn.gz\n", tmp_path)


def test_bombs_are_refused_early(tmp_path: Path) -> None:
    """256 megabytes of blank lines in a quarter of one: refused after 64, in little memory."""
    with gzip.open(tmp_path / "bomb.gz", "wb") as bomb:
        for _ in range(1 << 8):
            bomb.write(b"\n" * (1 << 20))
    code = (
        "import re, sys\nfrom pathlib import Path\nfrom pylmp.io.packed import Unpackable, read_packed\n"
        "try:\n    read_packed(Path(sys.argv[1]))\nexcept Unpackable as error:\n    print(error)\n"
        "print(re.search(r'VmHWM:\\s+(\\d+)', Path('/proc/self/status').read_text())[1])"  # its own, not its parent's
    )
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path / "bomb.gz")], capture_output=True, text=True, check=True)
    said, kilobytes = done.stdout.splitlines()
    assert said.startswith("it unpacks to more than")
    assert int(kilobytes) < 400_000


def test_the_limit_follows_the_size_of_the_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(packed, "_ALLOWED", 1000)
    path = tmp_path / "x.gz"
    path.write_bytes(gzip.compress(b"a" * 900))
    assert packed.read_packed(path) == "a" * 900
    path.write_bytes(gzip.compress(b"a" * 90_000))
    with pytest.raises(packed.Unpackable, match="more than"):
        packed.read_packed(path)
