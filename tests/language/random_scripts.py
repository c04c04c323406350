"""Scripts of language features in any order, right and wrong: variables of every style, nested ifs, loops, includes, every function.

Left out is what kills the release: conditions with an open parenthesis, a jump out of an included file,
loops over what is no range, vectors defined anew.
"""

from __future__ import annotations

import random

_NUMBERS = ["0", "1", "2", "3", "-1", "2.5", "1e-3", "7", "12", "0.1", "100", "1e10", "-0.5", "10"]
_ONE = ["sqrt", "exp", "ln", "log", "abs", "sin", "cos", "tan", "asin", "acos", "atan", "ceil", "floor", "round", "sign"]
_TWO = ["atan2", "ramp", "vdisplace", "stagger"]
_THREE = ["random", "normal", "swiggle", "cwiggle", "stride", "logfreq", "logfreq2", "logfreq3", "ternary", "stride2"]
_SPECIAL = ["is_defined", "is_available", "is_active", "is_file", "extract_setting", "sum", "min", "max", "ave", "trap", "slope", "sort", "rsort", "next",
            "is_os", "is_timeout", "label2type", "is_typelabel", "count", "mass", "bound", "gmask", "step"]  # fmt: skip
_WORDS = ["a", "b", "x y", "pair,lj/cut", "variable,e", "command,run", "fix,nve", "v_v", "v_e", "v_i", "box_exist", "dimension", "nofile", "all", "all,xmin", "ntypes",
          "feature,gzip", "compute,thermo_temp", "package,gpu", "group,all", "thermo,step", "loop", ""]  # fmt: skip
_SIGNS = ["+", "-", "*", "/", "%", "^", "==", "!=", "<", "<=", ">", ">=", "&&", "||", "|^"]


def formula(r: random.Random, depth: int = 2) -> str:
    """Mostly a right formula."""
    kind = r.random()
    if depth == 0 or kind < 0.15:
        return r.choice([*_NUMBERS, "PI", "v_e", "v_i", "v_s", "v_f", "v_n", "v_v[1]", "v_v[2]", "v_l", "v_zz", "step", "dt", "version", "vol", "yes", "no", "on"])
    args = [formula(r, depth - 1) for _ in range(5)]
    if kind < 0.4:
        return f"{args[0]}{r.choice(_SIGNS)}{args[1]}"
    if kind < 0.5:
        return f"({args[0]})"
    if kind < 0.58:
        return f"{r.choice('-!')}{args[0]}"
    if kind < 0.72:
        return f"{r.choice(_ONE)}({args[0]})"
    if kind < 0.78:
        return f"{r.choice(_TWO)}({args[0]},{args[1]})"
    if kind < 0.88:
        numbers = ",".join(r.choice(_NUMBERS[1:4] + _NUMBERS) for _ in range(6 if r.random() < 0.2 else 3))
        return f"{r.choice(_THREE)}({numbers})"
    if kind < 0.97:
        return f"{r.choice(_SPECIAL)}({r.choice(_WORDS)})"
    return f"{args[0]} {r.choice(_SIGNS)} {args[1]}"


def _text(r: random.Random) -> str:
    pieces = ["a", " b", "  ", "$e", "${e}", "${s}", "$i", "${v}", "$n", "$f", "${l}", f"$({formula(r)})", f"$({formula(r)}:%.4g)", "#", "$", "%", "1.0", "\\n", "${zz}", "&", "'"]
    weights = [4, 4, 2, 2, 3, 3, 3, 2, 2, 2, 2, 5, 2, 0.5, 0.1, 1, 2, 1, 0.2, 0.3, 0.3]
    return "".join(r.choices(pieces, weights, k=r.randint(1, 5)))


def _quoted(r: random.Random, text: str) -> str:
    quote = r.choice(['"', '"', '"""'] + (["'"] if "'" not in text else []))
    return f"{quote}{text}{quote}"


def _condition(r: random.Random) -> str:
    sides = [r.choice(["$e", "${i}", "$s", "3", "2.50", "a", "b", "$(1+1)", "${n}", "1e2", "-4"]) for _ in range(4)]
    signs = [r.choice(["==", "!=", "<", "<=", ">", ">=", "|^", "&&", "||"]) for _ in range(3)]
    return r.choice([
        f"{sides[0]} {signs[0]} {sides[1]}", f"{sides[0]}{signs[0]}{sides[1]}", f"({sides[0]} {signs[0]} {sides[1]}) {r.choice(['&&', '||', '|^'])} ({sides[2]} {signs[1]} {sides[3]})",
        f"!({sides[0]} < {sides[1]})", sides[0], f"!{sides[0]}", f"{sides[0]} {signs[0]} {sides[1]} {signs[1]} {sides[2]}",
    ])  # fmt: skip


def _if(r: random.Random, depth: int) -> str:
    def branch() -> str:
        parts = []
        for _ in range(r.randint(1, 2)):
            inner = _if(r, depth - 1) if depth and r.random() < 0.4 else r.choice(["print 'yes $e'", "print no", "variable e equal 4", "next i", "break", "variable s string x", "print $(v_e)", "foo"])
            quote = '"""' if '"' in inner else '"'
            parts.append(f"{quote}{inner}{quote}")
        return " ".join(parts)

    line = f'if "{_condition(r)}" then {branch()}'
    if r.random() < 0.3:
        line += f' elif "{_condition(r)}" {branch()}'
    if r.random() < 0.5:
        line += f" else {branch()}"
    return line


def _variable(r: random.Random) -> str:
    name = r.choice("eeiswnfl") if r.random() < 0.9 else r.choice(["zz", "a_1", "b-c"])
    style = {"e": "equal", "i": "index", "s": "string", "w": "vector", "n": "internal", "f": "format", "l": "loop"}.get(name, r.choice(["equal", "index"]))
    if r.random() < 0.1:
        style = r.choice(["equal", "index", "string", "vector", "internal", "format", "loop", "uloop", "universe", "world", "getenv", "delete", "timer", "file", "foo"])
    rest = {
        "equal": lambda: r.choice([formula(r), f'"{formula(r)}"', f"$({formula(r)})"]),
        "index": lambda: " ".join(r.choices(["1", "2.5", "a", "b c", '"b c"', "$e", "'q r'"], k=r.randint(1, 3))),
        "string": lambda: _quoted(r, _text(r)),
        "vector": lambda: r.choice(["[1,2,3]", "[4.5]", "v_v*2", "v_v+v_v", '"[1, 2]"', "[1,x]", "sqrt(v_v)", "v_e", "sort(v_v)", "v_v^2-1"]),
        "internal": lambda: r.choice(_NUMBERS),
        "format": lambda: "e " + r.choice(["%.3f", "%8.4g", "%d", "%-6.2e|", "%s", "%g", "%+05.1f", "x%.1fy"]),
        "loop": lambda: r.choice(["3", "2 4", "12 pad", "3 pad"]),
        "uloop": lambda: "3", "universe": lambda: "p q r", "world": lambda: "w", "getenv": lambda: "NO_SUCH", "delete": lambda: "", "timer": lambda: "", "file": lambda: "inc.txt",
    }.get(style, lambda: "1")()  # fmt: skip
    return f"variable {name} {style} {rest}"


def _command(r: random.Random) -> str:
    kind = r.random()
    if kind < 0.3:
        return f"print {_quoted(r, _text(r))}"
    if kind < 0.5:
        return _variable(r)
    if kind < 0.65:
        return _if(r, 2)
    if kind < 0.8:
        return f'print "$({formula(r, 3)})"'
    return r.choice([
        "next i", "next l", "next i l", "include inc.txt", 'print "in loop ${l}"\nnext l\njump SELF again', "echo both", "echo none", "echo log",
        "variable e delete", "print $s", "print ${v}  # comment", "label again", "clear", "print 'a' &\n  screen yes", "print 'x' file out.txt\ninclude out.txt", "log none", "log log append",
        "variable q equal v_e+$e", "variable e equal v_zz", "variable zz equal 2*v_e", "$s", "print \"\"\"two\nlines $e\"\"\"", "suffix off", "units lj", "timer loop",
    ])  # fmt: skip


def script(seed: int) -> str:
    r = random.Random(seed)
    head = ["variable e equal 1+2", "variable i index 1 2 b", "variable s string hello", "variable v vector [3,1.5,2]", "variable n internal 0.25", "variable f format e %6.2f", "variable l loop 3"]
    write = 'print """print included\nlabel there\nprint "there $e"\n""" file inc.txt screen no'
    lines = [*head, write, *(["label again"] if r.random() < 0.7 else []), *(_command(r) for _ in range(r.randint(2, 7)))]
    return "\n".join(lines) + "\n"
