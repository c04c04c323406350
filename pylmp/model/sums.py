"""Sums in a fixed order: one accumulator that starts at 0.0 and takes the terms from first to last, as LAMMPS does.

numpy's own sum adds in pairs and so rounds differently; its accumulate does not.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats


def total(terms: Floats) -> float:
    """Sum of a (k,) array, strictly first to last."""
    return float(np.add.accumulate(terms)[-1]) + 0.0 if len(terms) else 0.0


def totals(terms: Floats) -> Floats:
    """Column sums of a (k, m) array, each strictly first to last."""
    if len(terms) == 0:
        return np.zeros(terms.shape[1:])
    return np.asarray(np.add.accumulate(terms, axis=0)[-1] + 0.0)
