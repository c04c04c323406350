"""Files garbled in every way: truncated, grown, with bytes, numbers and lines that do not belong there."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import numpy as np
from hypothesis import strategies as st

from pylmp.engines.exact import Exact
from pylmp.interpreter import Interpreter
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Diagnostic, ScriptError

Edit = tuple[str, float, bytes, int]

_NUMBERS = b"0|-1|1.5|1e300|-1e300|1e-300|1e20|nan|inf|2147483647|3000000000|999999999|99999999999999999999".split(b"|")
_PIECES = [
    b"\x00", b"\r\n", "\u00e9".encode(), b"\xff\xfe", b"1e999", b"9" * 30, b"-", b" ", b"\n", b"#", b"\t", b"*", b"x", b"\x0c",
    "\u2028".encode(), b"ITEM: ", b"1 " * 50, b"\xff\xff\xff\x7f", b"\x00\x00\x00\x80", *_NUMBERS,
]  # fmt: skip
_KINDS = ("drop", "insert", "overwrite", "cut", "repeat", "swap lines", "number", "number")
EDITS = st.lists(
    st.tuples(st.sampled_from(_KINDS), st.floats(0, 1, exclude_max=True), st.sampled_from(_PIECES), st.integers(1, 400)),
    min_size=1, max_size=4,
)  # fmt: skip


def garbled(data: bytes, edits: list[Edit]) -> bytes:
    """edits: (what, where as a share of the length, with what, how far)."""
    for kind, share, piece, reach in edits:
        at = int(share * len(data))
        if kind == "drop":
            data = data[:at] + data[at + reach % 13 :]
        elif kind == "insert":
            data = data[:at] + piece + data[at:]
        elif kind == "overwrite":
            data = data[:at] + piece + data[at + len(piece) :]
        elif kind == "cut":
            data = data[:at]
        elif kind == "repeat":
            data = data[: at + reach] + data[at:]
        elif kind == "number" and (found := re.compile(rb"[-+.\deE]+").search(data, at)):
            data = data[: found.start()] + piece + data[found.end() :]
        elif kind == "swap lines":
            lines = data.split(b"\n")
            one, other = int(share * len(lines)), reach % len(lines)
            lines[one], lines[other] = lines[other], lines[one]
            data = b"\n".join(lines)
    return data


def refusal(script: str, folder: Path) -> Diagnostic | None:
    """What pylmp has against a script whose files are in folder. Whatever it raises but a ScriptError escapes."""
    sim = Simulation(Console(None, io.StringIO()), Exact())
    with contextlib.chdir(folder), np.errstate(all="ignore"):  # as at the door
        try:
            Interpreter(sim).run(script, "in.script")
        except ScriptError as error:
            return error.diagnostic
    return None
