"""Truncated, garbled and oversized restart files: a sentence that names the file, exit 1 (or 5), never a traceback, nothing half read."""

from __future__ import annotations

import contextlib
import io
import random
import struct
import warnings
from functools import cache
from pathlib import Path

import pytest

from pylmp.engines.exact import Exact
from pylmp.interpreter import Interpreter
from pylmp.io.restart.stream import Unpacker
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from tests.restart.scenes import SCENES
from tests.setup.both import library, on_lammps, sentence

SCENE = "plastic, recorded"
FLIPS = 700


@cache
def whole(folder: Path) -> bytes:
    """LAMMPS's file of a scene with all sections."""
    setup, again = SCENES[SCENE]
    assert not on_lammps(f"{setup}group two type 2\n{again}run 5 post no\nwrite_restart whole\n", folder).error
    return (folder / "whole").read_bytes()


@pytest.fixture
def data(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    return whole(tmp_path_factory.getbasetemp())


def read(data: bytes, folder: Path) -> tuple[Simulation, str, str]:
    """What read_restart makes of data, the sentence it ends with, and its hint."""
    (folder / "file").write_bytes(data)
    sim = Simulation(Console(io.StringIO(), io.StringIO()), Exact())
    with contextlib.chdir(folder), warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            Interpreter(sim).run("read_restart file\nmass * 1\n", "in.script")
        except ScriptError as error:
            return sim, error.diagnostic.message, error.diagnostic.hint
    return sim, "", ""


def boundaries(data: bytes) -> list[int]:
    """Where the reader stops after each value of the file."""
    places: set[int] = set()
    raw = Unpacker.raw

    def noting(self: Unpacker, size: int) -> bytes:
        places.add(self.at)
        return raw(self, size)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Unpacker, "raw", noting)
        from pylmp.io.restart.decode import decode

        decode(data, "file")
    return sorted(places)


def test_cut_anywhere(data: bytes, tmp_path: Path) -> None:
    """Cut short, it does not end as it should; with a false end, what is missing is named."""
    cuts = boundaries(data)
    assert len(cuts) > 100
    for cut in cuts:
        for short in (data[:cut], data[:cut] + data[-16:]):
            sim, says, hint = read(short, tmp_path)
            assert says and "file, byte " in hint, (cut, says, hint)
            assert not sim.has_box and sim.atoms.n == 0, cut


def test_bytes_flipped(data: bytes, tmp_path: Path) -> None:
    """Whatever byte changes: a sentence, or numbers that no reader can know to be wrong."""
    chance = random.Random(4711)
    refused = 0
    for _ in range(FLIPS):
        wrong = bytearray(data)
        for _ in range(chance.choice((1, 1, 1, 4))):
            at = chance.randrange(min(len(wrong), 3000) if chance.random() < 0.7 else len(wrong))
            wrong[at] = chance.randrange(256)
        sim, says, _ = read(bytes(wrong), tmp_path)
        refused += bool(says)
        if says:
            assert not sim.has_box, says
    assert refused > FLIPS // 5


def test_numbers_made_extreme(data: bytes, tmp_path: Path) -> None:
    """Each value of the file in turn becomes the largest, the smallest, no number."""
    for at in boundaries(data)[3:]:
        for extreme in (b"\xff\xff\xff\x7f", b"\x00\x00\x00\x80", b"\xff\xff\xff\xff", struct.pack("<d", float("nan"))):
            wrong = data[:at] + extreme + data[at + len(extreme) :]
            sim, says, _ = read(wrong, tmp_path)
            if says:
                assert not sim.has_box, says


def test_oversized(data: bytes, tmp_path: Path) -> None:
    for more in (b"x", data, b"\0" * 1000, b"\0" * 1000 + data[-16:]):
        sim, says, hint = read(data + more, tmp_path)
        assert says and "file, byte " in hint and not sim.has_box




@pytest.mark.parametrize("change", ["nothing", "text", "letters", "swapped", "turned", "order", "revision", "end"])
def test_lammps_says_the_same(change: str, data: bytes, tmp_path: Path) -> None:
    """The sentences about the file as a whole are LAMMPS's own."""
    wrong = {
        "nothing": b"", "text": b"hello", "letters": b"x" * 5000,
        "swapped": data[:16] + struct.pack("<i", 0x1000) + data[20:], "turned": data[:16] + struct.pack(">i", 1) + data[20:],
        "order": data[:16] + struct.pack("<i", 7) + data[20:],
        "revision": data[:20] + struct.pack("<i", 99) + data[24:], "end": data[:-16],
    }[change]  # fmt: skip
    (tmp_path / "file").write_bytes(wrong)
    with contextlib.chdir(tmp_path):
        lmp = library()
        lmp.command("clear")
        with pytest.raises(Exception) as caught:
            lmp.command("read_restart file")
    assert read(wrong, tmp_path)[1] == sentence(str(caught.value))
