"""LAMMPS's way to choose exactly so many of n things at random."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.random import RanMars

_LEAST, _MOST = 0.01, 0.99


def select_subset(seed: int, wanted: int, count: int) -> NDArray[np.bool_]:
    """(count,) bool, wanted of them true; wanted <= count.

    Rounds over those not chosen, or, when there are too many, over those chosen: each flips with the probability that would make the
    number right. What a round did not walk is never looked at again. Measured on LAMMPS 22 Jul 2025.
    """
    random = RanMars(seed)
    chosen = np.zeros(count, bool)
    active = {False: np.arange(count), True: np.zeros(0, np.int64)}
    while (have := int(chosen.sum())) != wanted:
        surplus = have > wanted
        walked = active[surplus]
        threshold = min(max(abs(wanted - have) / len(walked), _LEAST), _MOST)
        flips = np.array([random.uniform() < threshold for _ in range(len(walked))], bool)
        chosen[walked[flips]] = not surplus
        active = {surplus: walked[~flips], not surplus: walked[flips]}
    return chosen
