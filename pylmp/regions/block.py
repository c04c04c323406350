"""region ID block xlo xhi ylo yhi zlo zhi: bounds may be INF, EDGE or equal-style variables."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.region import Inside, Options, Region, Scale
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.model.surface import Contact, along_axis, closest, on_rectangle, to_point
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("block")
class Block(Region):
    style = "block"
    words = 6

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        words = args.words[args.at :]
        self._bounds = [self.bound(args, axis, high, scale[axis]) for axis in range(3) for high in (False, True)]
        self.shaped()
        if not self.varying:
            self._take()
            for d in range(3):
                if self.low[d] > self.high[d]:
                    axis, low, high = "xyz"[d], shortest(self.low[d]), shortest(self.high[d])
                    args.fail(
                        f"Illegal region block {axis}lo: {low} >= {axis}hi: {high}", words[2 * d],
                        hint="the lower bound comes first",
                    )  # fmt: skip
        ends = [bound.value for bound in self._bounds]
        self.extent = (ends[0], ends[2], ends[4]), (ends[1], ends[3], ends[5])

    def _take(self) -> None:
        values = [bound.number(self.sim) for bound in self._bounds]
        self.low, self.high = np.array(values[0::2]), np.array(values[1::2])

    def reshape(self) -> None:
        self._take()
        if (self.low > self.high).any():
            self.bad_value()

    def contains(self, x: Floats) -> Inside:
        return np.asarray(((x >= self.low) & (x <= self.high)).all(axis=1))

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        inside = self.contains(x)
        contacts = []
        for face in range(6):
            axis, high = face // 2, face % 2 == 1
            if self.open_face(face + 1):
                continue
            distance = self.high[axis] - x[:, axis] if high else x[:, axis] - self.low[axis]
            contacts.append(along_axis(distance, inside & (distance < cutoff), axis, high))
        return contacts

    def from_outside(self, x: Floats, cutoff: float) -> list[Contact]:
        far = np.asarray(((x <= self.low - cutoff) | (x >= self.high + cutoff)).any(axis=1))
        inside = np.asarray(((x > self.low) & (x < self.high)).all(axis=1))
        nearest: Floats = np.clip(x, self.low, self.high)
        if self.options.opened:
            faces = [on_rectangle(x, self.low, self.high, face) for face in range(6) if not self.open_face(face + 1)]
            if not faces:
                raise self.no_surface("block without faces")
            nearest = closest(x, faces, first=True)
        return [to_point(x, nearest, ~far & ~inside, cutoff)]
