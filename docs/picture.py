"""Draws docs/hysteresis.svg from a run of inputs/plastic_cyclic.

usage: python docs/picture.py
"""

from __future__ import annotations

import contextlib
import os
import tempfile
from pathlib import Path

from pylmp.cli import main

DOCS = Path(__file__).parent


def loop() -> list[tuple[float, float]]:
    """(length, force) of the bond of inputs/plastic_cyclic, frame by frame. LAMMPS's force is negative when it pulls."""
    deck = (DOCS.parent / "inputs" / "plastic_cyclic" / "in.plastic_cyclic").resolve()
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        if main([str(deck), "-screen", "none", "-log", "none"]) != 0:
            raise SystemExit("the deck did not run")
        text = Path("loop.dump").read_text()
    rows = [frame.splitlines()[-1].split() for frame in text.split("ITEM: TIMESTEP\n")[1:]]
    return [(float(row[0]), -float(row[1])) for row in rows]


def picture(points: list[tuple[float, float]]) -> str:
    """An SVG of force against length."""
    width, height, left, bottom = 640, 400, 70, 60
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    x0, x1, y0, y1 = min(xs) - 0.03, max(xs) + 0.03, min(ys) - 0.25, max(ys) + 0.25

    def place(x: float, y: float) -> tuple[float, float]:
        across = left + (x - x0) / (x1 - x0) * (width - left - 20)
        return across, height - bottom - (y - y0) / (y1 - y0) * (height - bottom - 20)

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="14">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
    ]
    for k in range(5):
        x, y = 0.8 + 0.1 * k, -1.0 + 0.5 * k
        a, _ = place(x, y0)
        _, b = place(x0, y)
        parts.append(f'<line x1="{a:.1f}" y1="20" x2="{a:.1f}" y2="{height - bottom}" stroke="#ddd"/>')
        parts.append(f'<line x1="{left}" y1="{b:.1f}" x2="{width - 20}" y2="{b:.1f}" stroke="#ddd"/>')
        parts.append(f'<text x="{a:.1f}" y="{height - bottom + 20}" text-anchor="middle">{x:.1f}</text>')
        parts.append(f'<text x="{left - 8}" y="{b + 5:.1f}" text-anchor="end">{y:.1f}</text>')
    path = " ".join(f"{a:.1f},{b:.1f}" for a, b in (place(*p) for p in points))
    parts.append(f'<polyline points="{path}" fill="none" stroke="#0b5fa5" stroke-width="2.5"/>')
    for number, (index, dx, dy, text) in enumerate(
        (
            (0, 10, 6, "start"),
            (5, -24, -12, "yields"),
            (20, -88, -12, "unloads"),
            (30, -38, 24, "yields back"),
            (60, 12, -10, "loads again"),
            (70, -20, -12, "yields"),
        )
    ):
        index = min(index, len(points) - 1)
        a, b = place(*points[index])
        parts.append(f'<circle cx="{a:.1f}" cy="{b:.1f}" r="4" fill="#b5461f"/>')
        parts.append(f'<text x="{a + dx:.1f}" y="{b + dy:.1f}" fill="#b5461f">{number + 1} {text}</text>')
    parts.append(
        f'<text x="{(width + left) / 2:.0f}" y="{height - 14}" text-anchor="middle">length of the bond (sigma)</text>'
    )
    parts.append(
        f'<text transform="translate(20 {(height - bottom) / 2:.0f}) rotate(-90)" text-anchor="middle">tension (epsilon/sigma)</text>'
    )
    return "\n".join([*parts, "</svg>", ""])


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    (DOCS / "hysteresis.svg").write_text(picture(loop()))
