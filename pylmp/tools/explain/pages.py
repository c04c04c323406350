"""What a command or a style is, taken from its own file: syntax, meaning, formula, coefficients with units, restrictions, keywords."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
from dataclasses import dataclass, field
from typing import Any

from pylmp.model.atom_style import ATOM_STYLES
from pylmp.model.registry import COMMANDS, REGISTRIES, THERMOS, Registry
from pylmp.model.style import Restriction
from pylmp.text.diagnostic import MANUAL, ScriptError
from pylmp.tools.explain.forms import form_of, forms

# What a user calls a kind of style, by the word of `info styles`.
KINDS = {
    "pair_style": "pair", "bond_style": "bond", "angle_style": "angle", "dihedral_style": "dihedral", "improper_style": "improper", "fix": "fix",
    "compute": "compute", "dump": "dump", "region": "region", "min_style": "minimize",
}  # fmt: skip
_SOURCE = re.compile(r"\s*Source: LAMMPS manual,\s*([\w.]+)[^.]*\.(?:\s*Order of operations[^.]*\.)?", re.DOTALL)


@dataclass(frozen=True)
class Page:
    """name: as a script writes it. syntax: a line. meaning: in words. formula: lines. coeffs: (name, unit). rules: (code, sentence, hint)."""

    name: str
    syntax: str
    meaning: str
    formula: tuple[str, ...] = ()
    coeffs: tuple[tuple[str, str], ...] = ()
    rules: tuple[tuple[str, str, str], ...] = ()
    keywords: dict[str, str] = field(default_factory=dict)
    remembers: tuple[str, ...] = ()
    manual: str = ""

    @property
    def link(self) -> str:
        return MANUAL + self.manual


_STYLED = {"fix": 3, "compute": 3, "dump": 3, "region": 2, **dict.fromkeys((k for k in KINDS if k.endswith("_style")), 1)}  # which word


def about(words: list[str]) -> Page | None:
    """What a line is about: its style, if it names one that is known, else its command; None for neither."""
    at = _STYLED.get(words[0])
    for look in (lambda: style_page(words[0], words[at or 0]), lambda: command_page(words[0])):
        try:
            if at is not None and at < len(words):
                return look()
            return command_page(words[0])
        except ScriptError:
            continue
    return None


def command_page(name: str) -> Page:
    """Of a command. Raises ScriptError for a name that is none."""
    found = COMMANDS.find(name)
    if found is None:
        near = COMMANDS.near(name)
        raise ScriptError(f"There is no command {name}", hint=f"did you mean {near}?" if near else "pylmp explain run, pylmp explain fix nve")
    several = forms().get(name, ())
    keywords = several[0].keywords if len(several) == 1 else {}
    return _page(name, inspect.getmodule(found.run), found.run.__doc__ or "", found.manual, keywords)


def style_page(kind: str, name: str) -> Page:
    """Of a style; kind: fix, compute, pair_style ... Raises ScriptError for a name that is none."""
    if kind == "atom_style":
        if name in ATOM_STYLES:
            return Page(f"atom_style {name}", f"atom_style {name}", "", manual="atom_style.html")
    registry: Registry[Any] = THERMOS if kind == "thermo_style" else REGISTRIES[KINDS[kind]]
    style = registry.find(name)
    if style is None:
        near = registry.near(name)
        raise ScriptError(f"There is no {kind} {name}", hint=f"did you mean {near}?" if near else f"known: {' '.join(registry.names())}")
    own = {"fix": ["ID", "all", name], "compute": ["ID", "all", name], "dump": ["ID", "all", name], "region": ["ID", name]}.get(kind, [name])
    forms_of = [one for one in forms().get(kind, ()) if name in [argument.name for argument in one.arguments if argument.literal]]
    form = form_of(kind, own) if not forms_of else forms_of[0]
    keywords = form.keywords if form is not None and forms_of else {}
    module = inspect.getmodule(style if isinstance(style, type) else getattr(style, "law", style) or style)
    if not isinstance(style, type):  # a value: found by the file that holds it
        module = importlib.import_module(f"{registry.package}.{_file(registry, name)}")
    page = _page(f"{kind} {name}", module, "", getattr(style, "manual", "") or _manual(kind, name, module), keywords)
    if isinstance(style, type):
        return page
    coeffs = tuple((one.name, one.unit) for one in getattr(style, "coeffs", ()))
    return Page(
        page.name, page.syntax, page.meaning, page.formula, coeffs, tuple(_rule(one) for one in getattr(style, "restrictions", ())), page.keywords,
        tuple(getattr(style, "history", ())), page.manual,
    )  # fmt: skip


def _file(registry: Registry[Any], name: str) -> str:
    """The module that registers a name: the one called like it, or the longest one the name begins or ends with."""
    home = importlib.import_module(registry.package)
    wanted = name.replace("/", "_").replace("-", "_")
    files = [module.name for module in pkgutil.iter_modules(home.__path__)]
    return wanted if wanted in files else max((file for file in files if wanted.startswith(file)), key=len)


def _rule(rule: Restriction) -> tuple[str, str, str]:
    return rule.code, rule.says if isinstance(rule.says, str) else "", rule.hint


def _manual(kind: str, name: str, module: Any) -> str:
    found = _SOURCE.search(module.__doc__ or "")
    if found:
        return found[1].removesuffix(".html") + ".html"
    return {"region": "region.html", "dump": "dump.html", "min_style": "min_style.html", "thermo_style": "thermo_style.html"}.get(
        kind, f"{kind.removesuffix('_style')}_{name.replace('/', '_')}.html"
    )


def _page(name: str, module: Any, meaning: str, manual: str, keywords: dict[str, str]) -> Page:
    text = _SOURCE.sub("", inspect.cleandoc(module.__doc__ or "")).strip()
    head, _, body = text.partition("\n\n")
    syntax, colon, said = head.partition(": ")
    if not colon or (" = " in syntax or "\n" in syntax):
        syntax, said = head.rstrip(":"), ""
    formula = tuple(line.strip() for line in body.split("\n") if line.startswith("    "))
    prose = " ".join(" ".join(line for line in body.split("\n") if not line.startswith("    ")).split())
    if "E = " in said or "F = " in said:
        formula, said = (said.strip(), *formula), ""
    words = " ".join(filter(None, (said.replace("\n", " "), " ".join(meaning.split()), prose)))
    return Page(name, " ".join(syntax.split()), words[:1].upper() + words[1:], formula, keywords=keywords, manual=manual)
