"""C's printf formats, as thermo_modify and dump_modify take them, carried out by Python's ``%``.

Python shares C's flags, widths and precisions. Different are length modifiers and the sign of a nan, which C prints.
"""

from __future__ import annotations

import math
import re

_CONVERSION = re.compile(r"%%|%([-+ #0]*)(\d*)(\.\d*)?(?:hh|h|ll|l|j|z|t|L|q)?([diouxXeEfFgG])")
_WHOLE = "diouxX"


class Format:
    """One conversion with text around it, e.g. ``%-8.3f|``.

    whole  the conversion is one for integers
    Raises ValueError if text holds more than one conversion or one that does not take a number.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.whole = False
        count = 0

        def translate(found: re.Match[str]) -> str:
            nonlocal count
            if found[0] == "%%":
                return "%%"
            count += 1
            self.whole = found[4] in _WHOLE
            return f"%{found[1]}{found[2]}{found[3] or ''}{found[4]}"

        self.python = _CONVERSION.sub(translate, text)
        if count > 1 or "%" in _CONVERSION.sub("", text):
            raise ValueError(text)
        if count == 0:
            self.python += "%.0s"

    def __call__(self, value: float) -> str:
        if self.whole:
            value = int(value) if math.isfinite(value) else 0
        text: str = self.python % value
        if value != value and math.copysign(1.0, value) < 0.0:
            return text.replace("nan", "-nan").replace("NAN", "-NAN")
        return text
