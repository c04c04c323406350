"""Points within a few rounding errors of a region's surface: inside or outside as LAMMPS says, whichever way it is turned."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from pylmp.engines.exact import Exact
from pylmp.interpreter import Interpreter
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from pylmp.model.transform import rotated, unit
from tests.setup.both import library

POINTS = 4000
BOX = ["units lj", "lattice none 1", "region all block -100 100 -100 100 -100 100", "create_box 1 all"]


def on_lammps(lines: list[str], x: np.ndarray) -> np.ndarray:
    lmp = library()
    for line in ("clear", "atom_modify map yes", *BOX):
        lmp.command(line)
    lmp.create_atoms(len(x), list(range(1, len(x) + 1)), [1] * len(x), x.ravel().tolist())
    for line in (*lines, "group g region r"):
        lmp.command(line)
    order = np.argsort(np.array(lmp.numpy.extract_atom("id"))[: len(x)])
    assert (np.array(lmp.numpy.extract_atom("x"))[: len(x)][order] == x).all()
    return (np.array(lmp.numpy.extract_atom("mask"))[: len(x)][order] & 2) != 0


def on_pylmp(lines: list[str], x: np.ndarray) -> np.ndarray:
    sim = Simulation(Console(None, None), Exact())
    Interpreter(sim).run("\n".join([*BOX, *lines]), "in.script")
    return sim.regions["r"].inside(x)


def shapes(random: np.random.Generator) -> Iterator[tuple[str, np.ndarray]]:
    """(style and its words, points on its surface)"""

    def numbers(low: float, high: float, count: int) -> list[float]:
        return random.uniform(low, high, count).tolist()

    c, half, n = numbers(-3, 3, 3), numbers(0.5, 5, 3), POINTS
    direction = random.normal(size=(n, 3))
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    yield f"sphere {c[0]} {c[1]} {c[2]} {half[0]}", c + half[0] * direction
    yield f"ellipsoid {' '.join(map(str, c + half))}", c + half * direction
    bounds = [numbers(-3, 0, 1) + numbers(1, 3, 1) for _ in range(3)]
    corners = np.stack([random.choice(pair, n) for pair in bounds], axis=1)
    yield "block " + " ".join(f"{low} {high}" for low, high in bounds), corners
    normal = numbers(-1, 1, 3)
    flat = random.uniform(-5, 5, (n, 3))
    flat[:, 2] = c[2] - ((flat[:, 0] - c[0]) * normal[0] + (flat[:, 1] - c[1]) * normal[1]) / normal[2]
    yield f"plane {' '.join(map(str, c + normal))}", flat
    for axis in range(3):
        (low, high), (first, second) = bounds[axis], half[:2]
        angle, along = random.uniform(0, 6.3, n), random.uniform(low, high, n)
        along[::5], along[1::5] = low, high
        for words, radius in (
            (f"cylinder {'xyz'[axis]} {c[0]} {c[1]} {first} {low} {high}", np.full(n, first)),
            (f"cone {'xyz'[axis]} {c[0]} {c[1]} {first} {second} {low} {high}", first + (along - low) * (second - first) / (high - low)),
        ):  # fmt: skip
            x = np.zeros((n, 3))
            x[:, axis] = along
            x[:, [d for d in range(3) if d != axis]] = np.stack(
                [c[0] + radius * np.cos(angle), c[1] + radius * np.sin(angle)], axis=1
            )
            yield words, x


@pytest.mark.parametrize("seed", range(3))
def test_points_at_surfaces(seed: int) -> None:
    random = np.random.default_rng(seed)
    for words, x in shapes(random):
        angle, shift = float(random.uniform(-3, 3)), random.uniform(-2, 2, 2).tolist()
        point, axis = random.uniform(-3, 3, 3).tolist(), random.uniform(-1, 1, 3).tolist()
        turned = rotated(x, tuple(point), unit(tuple(axis)), angle)
        turn = f" rotate v_turn {' '.join(map(str, point + axis))}"
        variables = [
            f"variable {name} equal {value}" for name, value in (("turn", angle), ("u", shift[0]), ("w", shift[1]))
        ]
        for suffix, near in (
            ("", x), (" side out", x), (turn, turned), (turn + " move v_u NULL v_w", turned + [shift[0], 0.0, shift[1]]),
        ):  # fmt: skip
            jittered = near + random.integers(-4, 5, near.shape) * np.spacing(np.abs(near))
            lines = [*variables, f"region r {words}{suffix}"]
            inside = on_lammps(lines, jittered)
            assert 0 < inside.sum() < len(x)
            assert (inside == on_pylmp(lines, jittered)).all(), (words, suffix)
