"""C's printf formats, as thermo_modify and dump_modify take them, carried out by Python's ``%``.

Python shares C's flags, widths and precisions. Different are length modifiers and the sign of a nan, which C prints.
"""

from __future__ import annotations

import math
import re

from pylmp.text.diagnostic import ScriptError

_CONVERSION = re.compile(r"%%|%([-+ #0]*)(\d*)(\.\d*)?(?:hh|h|ll|l|j|z|t|L|q)?([diouxXeEfFgGs])")
_WHOLE = "diouxX"
_DIGITS = 4  # of a width or a precision


class Format:
    """One conversion with text around it, e.g. ``%-8.3f|``.

    whole, words  the conversion is one for integers, for strings
    Raises ValueError if text holds more than one conversion, or one that is none of C's for numbers and strings.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.whole = self.words = False
        count = 0

        def translate(found: re.Match[str]) -> str:
            nonlocal count
            if found[0] == "%%":
                return "%%"
            count += 1
            if max(len(found[2]), len((found[3] or "").lstrip("."))) > _DIGITS:
                raise ScriptError(f"The format {text[:40]} asks for more characters than a line has room for", hint="a width below 10000", code="S110")
            self.whole, self.words = found[4] in _WHOLE, found[4] == "s"
            return f"%{found[1]}{found[2]}{found[3] or ''}{found[4]}"

        self.python = _CONVERSION.sub(translate, text)
        if count > 1 or "%" in _CONVERSION.sub("", text):
            raise ValueError(text)
        if count == 0:
            self.python += "%.0s"

    def __call__(self, value: float | str) -> str:
        if isinstance(value, str):
            return self.python % value
        if self.whole:
            value = int(value) if math.isfinite(value) else 0
        if math.isnan(value) and math.copysign(1.0, value) < 0.0:
            signed: str = self.python % -math.inf
            return signed.replace("inf", "nan").replace("INF", "NAN")
        text: str = self.python % value
        return text


def pieces(text: str) -> list[str]:
    """text cut behind each conversion; what follows the last belongs to it."""
    ends = [found.end() for found in _CONVERSION.finditer(text) if found[0] != "%%"]
    if not ends:
        return [text]
    starts = [0, *ends[:-1]]
    return [text[start:end] for start, end in zip(starts, [*ends[:-1], len(text)], strict=True)]
