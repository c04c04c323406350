"""Tests of one scene run in one process (pytest -n, --dist loadgroup): the kernels of a scene are compiled once, not in two processes at the same time."""

from __future__ import annotations

from pathlib import Path

import pytest

HERE = Path(__file__).parent


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        scene = getattr(item, "callspec", None)
        if scene is not None and HERE in item.path.parents:
            item.add_marker(pytest.mark.xdist_group(scene.id.rstrip("0123456789")))
