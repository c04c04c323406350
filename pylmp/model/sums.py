"""Sums in a fixed order: one accumulator that starts at 0.0 and takes the terms from first to last, as LAMMPS does.

numpy's own sum adds in pairs and so rounds differently; its accumulate does not.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats

_TERMS = 2**17  # at a time: a bound on memory


def total(terms: Floats) -> float:
    """Sum of a (k,) array, strictly first to last."""
    if not len(terms):
        return 0.0
    last = float(np.add.accumulate(terms[:_TERMS])[-1])
    for begin in range(_TERMS, len(terms), _TERMS):
        last = float(np.add.accumulate(np.append(last, terms[begin : begin + _TERMS]))[-1])
    return last + 0.0


def totals(terms: Floats) -> Floats:
    """Column sums of a (k, m) array, each strictly first to last."""
    if len(terms) == 0:
        return np.zeros(terms.shape[1:])
    return np.asarray(np.add.accumulate(terms, axis=0)[-1] + 0.0)
