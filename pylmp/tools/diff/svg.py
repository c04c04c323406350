"""Curves as inline SVG: logarithmic heights over steps, labelled axes, colours of the page's style (they follow dark and light)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

WIDE, HIGH, LEFT, RIGHT, TOP, BOTTOM = 720, 320, 78, 16, 14, 46
DASHES = ("", "6 4", "2 3", "9 3 2 3")
COLOURS = 4  # the page's classes c0 to c3


@dataclass
class Series:
    """One curve. points: (step, height); heights that are not above 0 are left out."""

    title: str
    points: Sequence[tuple[float, float]]


def chart(series: Sequence[Series], across: str, up: str) -> str:
    """An <svg> element with a legend below it, or "" if there is nothing to draw."""
    drawn = [Series(s.title, [(x, y) for x, y in s.points if y > 0.0 and math.isfinite(y)]) for s in series]
    every = [point for s in drawn for point in s.points]
    if not every:
        return ""
    low, high = _decades([y for _, y in every])
    left, right = min(x for x, _ in every), max(x for x, _ in every)
    right = right if right > left else left + 1

    def place(x: float, y: float) -> tuple[float, float]:
        across_ = LEFT + (x - left) / (right - left) * (WIDE - LEFT - RIGHT)
        return across_, HIGH - BOTTOM - (math.log10(y) - low) / (high - low) * (HIGH - TOP - BOTTOM)

    parts = [f'<svg viewBox="0 0 {WIDE} {HIGH}" role="img" aria-label="{escape(up)} over {escape(across)}">']
    stride = max(1, math.ceil((high - low) / 6))
    for decade in range(low, high + 1, stride):
        _, y = place(left, 10.0**decade)
        parts.append(f'<line class="grid" x1="{LEFT}" x2="{WIDE - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>')
        parts.append(f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">1e{decade}</text>')
    for tick in ticks(left, right):
        x, _ = place(tick, 10.0**low)
        parts.append(f'<line class="grid" x1="{x:.1f}" x2="{x:.1f}" y1="{HIGH - BOTTOM}" y2="{HIGH - BOTTOM + 5}"/>')
        parts.append(f'<text x="{x:.1f}" y="{HIGH - BOTTOM + 19}" text-anchor="middle">{tick:g}</text>')
    parts.append(f'<text x="{(LEFT + WIDE - RIGHT) / 2}" y="{HIGH - 8}" text-anchor="middle">{escape(across)}</text>')
    middle = (TOP + HIGH - BOTTOM) / 2
    parts.append(f'<text transform="translate(16 {middle}) rotate(-90)" text-anchor="middle">{escape(up)}</text>')
    for k, one in enumerate(drawn):
        look = f'class="c{k % COLOURS}" stroke-dasharray="{DASHES[k % len(DASHES)]}"'
        places = [place(x, y) for x, y in one.points]
        parts.append(f'<polyline {look} points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in places)}"/>')
        parts += [f'<circle class="c{k % COLOURS} dot" cx="{x:.1f}" cy="{y:.1f}" r="2.5"/>' for x, y in places]
    parts.append("</svg>")
    return "".join(parts) + _legend(drawn)


def _legend(series: Sequence[Series]) -> str:
    lines = []
    for k, one in enumerate(series):
        dash = DASHES[k % len(DASHES)]
        note = "" if one.points else " (nothing above 0)"
        lines.append(
            f'<span><svg class="key" viewBox="0 0 36 8"><line class="c{k % COLOURS}" stroke-dasharray="{dash}" x1="0" x2="36" y1="4" y2="4"/></svg> '
            f"{escape(one.title)}{note}</span>"
        )
    return f'<p class="legend">{" ".join(lines)}</p>'


def _decades(heights: Sequence[float]) -> tuple[int, int]:
    low, high = math.floor(math.log10(min(heights))), math.ceil(math.log10(max(heights)))
    return (low, high) if high > low else (low, low + 1)


def ticks(low: float, high: float) -> list[float]:
    """About 6 round numbers from low to high."""
    rough = (high - low) / 6
    unit = 10.0 ** math.floor(math.log10(rough))
    step = next(unit * m for m in (1, 2, 5, 10) if unit * m >= rough * 0.999)
    first = math.ceil(low / step)
    return [k * step for k in range(first, math.floor(high / step + 1e-9) + 1)]
