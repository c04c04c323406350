"""How one of the six numbers of a box changes with time: the parameters of fix deform. Source: LAMMPS manual, fix_deform.html."""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.box import Box
    from pylmp.model.simulation import Simulation

_FACES = {"final": 2, "delta": 2, "scale": 1, "vel": 1, "erate": 1, "trate": 1, "volume": 0, "wiggle": 2, "variable": 2}
_TILT = {"final": 1, "delta": 1, "vel": 1, "erate": 1, "trate": 1, "wiggle": 2, "variable": 2}
_LENGTHS = {"final": 2, "delta": 2, "vel": 1, "wiggle": 1}  # how many of the numbers are lengths
_TURN = 2.0 * math.pi
ALONG = (0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)  # of x y z yz xz xy: where a tilt points, and the length it grows with
Pair = tuple[float, float]


@dataclass(frozen=True)
class Start:
    """The box that rates, volumes and ramps refer to: (lo, hi) three times; yz xz xy."""

    faces: tuple[Pair, Pair, Pair]
    tilt: tuple[float, float, float]
    volume: float

    @classmethod
    def of(cls, box: Box) -> Start:
        x, y, z = zip(box.lo.tolist(), box.hi.tolist(), strict=True)
        yz, xz, xy = box.h[3:].tolist()
        a, b, c = (float(length) for length in box.length)
        return cls((x, y, z), (yz, xz, xy), a * b * c)


@dataclass
class Change:
    """style, numbers: as the script says; names: of variables. stop: faces at the end of the run, or twice the tilt; extremes: least
    and most of a tilt. Volume and variable leave both at 0, as in LAMMPS."""

    style: str
    numbers: list[float]
    names: tuple[str, ...] = ()
    stop: Pair = (0.0, 0.0)
    extremes: Pair = (0.0, 0.0)

    def scale(self, spacing: float) -> None:
        """Lattice units to distances."""
        for k in range(min(_LENGTHS.get(self.style, 0), len(self.numbers))):
            self.numbers[k] *= spacing

    def check(self, sim: Simulation) -> None:
        """The variables are there."""
        for name in self.names:
            style = Variables(sim).style(name)
            if style is None:
                raise ScriptError(f"Variable name {name} for fix deform does not exist", hint=f"variable {name} equal ...")
            if style not in EQUAL_STYLES:
                raise ScriptError(f"Variable {name} for fix deform is invalid style", hint="an equal-style variable")

    # ---- where it ends ----------------------------------------------------------------------------------------

    def plan_faces(self, lo: float, hi: float, time: float) -> None:
        value = self.numbers[0] if self.numbers else 0.0
        shift = 0.0
        if self.style == "final":
            self.stop = value, self.numbers[1]
        elif self.style == "delta":
            self.stop = lo + value, hi + self.numbers[1]
        elif self.style == "scale":
            shift = 0.5 * value * (hi - lo)
            self.stop = 0.5 * (lo + hi) - shift, 0.5 * (lo + hi) + shift
        elif self.style == "vel":
            self.stop = lo - 0.5 * time * value, hi + 0.5 * time * value
        elif self.style == "erate":
            shift = 0.5 * time * value * (hi - lo)
            self.stop = lo - shift, hi + shift
            if self.stop[1] <= self.stop[0]:
                raise ScriptError("Final box dimension due to fix deform is < 0.0", hint="a smaller rate or fewer steps")
        elif self.style == "trate":
            shift = 0.5 * ((hi - lo) * math.exp(value * time))
            self.stop = 0.5 * (lo + hi) - shift, 0.5 * (lo + hi) + shift
        elif self.style == "wiggle":
            shift = 0.5 * value * math.sin(_TURN * time / self.numbers[1])
            self.stop = lo - shift, hi + shift

    def plan_tilt(self, tilt: float, across: float, time: float) -> None:
        """across: the length of the box in the direction the tilt grows with."""
        value = self.numbers[0] if self.numbers else 0.0
        stop = tilt
        if self.style == "final":
            stop = value
        elif self.style == "delta":
            stop = tilt + value
        elif self.style == "vel":
            stop = tilt + time * value
        elif self.style == "erate":
            stop = tilt + time * value * across
        elif self.style == "trate":
            if tilt == 0.0:
                raise ScriptError("Cannot use fix deform trate on a box with zero tilt", hint="erate, or a tilt to begin with")
            stop = tilt * math.exp(value * time)
        elif self.style == "wiggle":
            stop = tilt + value * math.sin(_TURN * time / self.numbers[1])
        self.stop = stop, stop
        self.extremes = self._swing_between(tilt, time) if self.style == "wiggle" else (min(tilt, stop), max(tilt, stop))

    def _swing_between(self, tilt: float, time: float) -> Pair:
        """What LAMMPS takes for the least and most of a wiggle: for some amplitudes and times it is not (measured)."""
        size, period = self.numbers
        now = size * math.sin(_TURN * time / period)
        if size >= 0.0:
            least = tilt if time < 0.5 * period else tilt - now if time < 0.75 * period else tilt - size
            return least, tilt + (now if time < 0.25 * period else size)
        if time < 0.5 * period:
            return tilt + (now if time < 0.25 * period else size), tilt
        return (tilt + size, tilt + now) if time < 0.75 * period else (tilt - size, tilt + size)

    # ---- where it is now --------------------------------------------------------------------------------------

    def faces(self, sim: Simulation, lo: float, hi: float, part: float, elapsed: float) -> Pair:
        """Faces after part of the run; lo, hi at its start."""
        if self.style == "trate":
            shift = 0.5 * ((hi - lo) * math.exp(self.numbers[0] * elapsed))
            return 0.5 * (lo + hi) - shift, 0.5 * (lo + hi) + shift
        if self.style == "wiggle":
            shift = 0.5 * self._swing(elapsed)
            return lo - shift, hi + shift
        if self.style == "variable":
            shift = Variables(sim).number(self.names[0])
            return lo - 0.5 * shift, hi + 0.5 * shift
        return lo + part * (self.stop[0] - lo), hi + part * (self.stop[1] - hi)

    def tilt(self, sim: Simulation, tilt: float, part: float, elapsed: float) -> float:
        if self.style == "trate":
            return tilt * math.exp(self.numbers[0] * elapsed)
        if self.style == "wiggle":
            return tilt + self._swing(elapsed)
        if self.style == "variable":
            return tilt + Variables(sim).number(self.names[0])
        return tilt + part * (self.stop[0] - tilt)

    def rate_at_start(self, start: tuple[float, ...], time: float) -> float:
        """How fast a length or a tilt grows, which is known beforehand where it grows evenly; start: both faces, or the tilt."""
        if self.style not in ("final", "delta", "scale", "vel", "erate") or time == 0.0:
            return 0.0
        if len(start) == 1:
            return (self.stop[0] - start[0]) / time
        return (self.stop[1] - start[1]) / time - (self.stop[0] - start[0]) / time

    def rate(self, sim: Simulation, h: float, elapsed: float, before: float) -> float:
        """How fast it grows now; h: how large it was so far; before: the rate so far."""
        if self.style == "trate":
            return self.numbers[0] * h
        if self.style == "wiggle":
            return _TURN / self.numbers[1] * self.numbers[0] * math.cos(_TURN * elapsed / self.numbers[1])
        if self.style == "variable":
            return Variables(sim).number(self.names[1])
        return before

    def _swing(self, elapsed: float) -> float:
        return self.numbers[0] * math.sin(_TURN * elapsed / self.numbers[1])


def read_change(args: Args, tilt: bool) -> Change:
    """A parameter's style and values."""
    args.need(1)
    style = args.word()
    words = _TILT if tilt else _FACES
    if style.text not in words:
        args.fail(f"Illegal fix deform command argument: {style.text}", style, hint=" ".join(words))
    args.need(words[style.text], style.text)
    if style.text == "variable":
        names = [args.word(), args.word()]
        for name in names:
            if not name.text.startswith("v_"):
                args.fail(f"Illegal fix deform variable name {name.text}", name, hint="v_NAME")
        return Change(style.text, [], tuple(name.text[2:] for name in names))
    change = Change(style.text, [args.number() for _ in range(words[style.text])])
    if style.text == "wiggle" and change.numbers[1] <= 0.0:
        args.fail("Illegal fix deform wiggle period, must be positive")
    return change


@dataclass(frozen=True)
class Share:
    """How a length keeps the volume: it follows the length leader; other is the third one: "fixed", "follows" too, or "leads" too."""

    leader: int
    other: int
    role: str


def volume_shares(args: Args, changes: dict[int, Change]) -> dict[int, Share]:
    """For each length of style volume, what it depends on."""
    styles = [changes[k].style if k in changes else "" for k in range(3)]
    result = {}
    for k in range(3):
        if styles[k] != "volume":
            continue
        a, b = (k + 1) % 3, (k + 2) % 3
        leading = [d for d in (a, b) if styles[d] not in ("", "volume")]
        if not leading:
            args.fail("Fix deform volume setting is invalid", args.owner, hint="some other length must be driven")
        if len(leading) == 2:
            result[k] = Share(a, b, "leads")
        else:
            other = b if leading[0] == a else a
            result[k] = Share(leading[0], other, "follows" if styles[other] == "volume" else "fixed")
    return result


# ---- restart files: six records of LAMMPS's; only what it reads back is filled in

_RECORD = struct.Struct("<ii28d40x")  # style, how it shares the volume, numbers
_STYLES = "", "final", "delta", "scale", "vel", "erate", "trate", "volume", "wiggle", "variable"
_SHARES = "fixed", "leads", "follows"
_LO, _TILTED, _VOLUME = 11, 19, 26  # places among the numbers: lo and hi, tilt, volume


def pack(changes: dict[int, Change], shares: dict[int, Share], start: Start) -> bytes:
    result = b""
    for k in range(6):
        numbers = [0.0] * 28
        if k < 3:
            numbers[_LO], numbers[_LO + 1] = start.faces[k]
            numbers[_VOLUME] = start.volume
        else:
            numbers[_TILTED] = start.tilt[k - 3]
        share = _SHARES.index(shares[k].role) if k in shares else 0
        result += _RECORD.pack(_STYLES.index(changes[k].style if k in changes else ""), share, *numbers)
    return result


def unpack(changes: dict[int, Change], shares: dict[int, Share], state: bytes) -> Start:
    """Raises ScriptError if the records are of other parameters."""
    if len(state) != 6 * _RECORD.size:
        raise ScriptError("Fix deform settings not consistent with restart", hint="another fix deform")
    records = list(_RECORD.iter_unpack(state))
    for k, (style, share, *_) in enumerate(records):
        mine = _STYLES.index(changes[k].style if k in changes else "")
        if (style, share) != (mine, _SHARES.index(shares[k].role) if k in shares else 0):
            raise ScriptError("Fix deform settings not consistent with restart", hint="the parameters of the run that wrote it")
    x, y, z = ((record[2 + _LO], record[3 + _LO]) for record in records[:3])
    yz, xz, xy = (record[2 + _TILTED] for record in records[3:])
    return Start((x, y, z), (yz, xz, xy), records[0][2 + _VOLUME])
