"""What kind of neighbor list a compute wishes for."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Wish:
    """full: both directions of every pair. cutoff: how far, skin included; 0.0: as far as the pair style reaches."""

    full: bool = False
    cutoff: float = 0.0
