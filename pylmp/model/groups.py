"""Groups: up to 32 names, one bit each in every atom's mask. Bit 0 is all."""

from __future__ import annotations

MAX_GROUPS = 32


class Groups:
    """names: their bits. dynamic: names of those whose members change during a run."""

    def __init__(self) -> None:
        self.names: dict[str, int] = {"all": 1}
        self.dynamic: set[str] = set()

    def bit(self, name: str) -> int:
        """The mask bit of group name, 0 if there is no such group."""
        return self.names.get(name, 0)

    def free_bit(self) -> int:
        """An unused bit, 0 if all are taken."""
        used = sum(self.names.values())
        return next((1 << k for k in range(MAX_GROUPS) if not used >> k & 1), 0)
