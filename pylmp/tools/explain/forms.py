"""Which word of a line is which argument: grammar/forms.txt, one form a line."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from pylmp.text.grammar import folder


@dataclass(frozen=True)
class Argument:
    """literal: the word stands as it is. name, unit as in the form."""

    name: str
    unit: str = ""
    literal: bool = False
    optional: bool = False


@dataclass(frozen=True)
class Form:
    """arguments behind the command's name; many: others may follow. keywords: name -> default."""

    command: str
    arguments: tuple[Argument, ...]
    many: bool
    keywords: dict[str, str]

    @property
    def literals(self) -> int:
        return sum(argument.literal for argument in self.arguments)

    def fits(self, words: list[str]) -> bool:
        """The literal words of the form stand where they should."""
        needed = sum(not argument.optional for argument in self.arguments)
        return len(words) >= needed and all(words[k] == one.name for k, one in enumerate(self.arguments) if one.literal)

    def __str__(self) -> str:
        words = [f"[{one.name}]" if one.optional else one.name for one in self.arguments]
        return " ".join([self.command, *words, *(["..."] if self.many else [])])


@dataclass(frozen=True)
class Given:
    """One argument of a line. default: the script does not say it."""

    name: str
    value: str
    unit: str = ""
    default: bool = False


@cache
def forms() -> dict[str, tuple[Form, ...]]:
    """By command."""
    found: dict[str, list[Form]] = {}
    for line in (folder() / "forms.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            form = _form(line)
            found.setdefault(form.command, []).append(form)
    return {name: tuple(each) for name, each in found.items()}


def _form(line: str) -> Form:
    head, _, tail = line.partition(" | ")
    command, *words = head.split()
    keywords = {}
    for entry in filter(None, (part.strip() for part in tail.split(";"))):
        name, _, value = entry.partition(" ")
        if name == "orient":
            axis, _, value = value.partition(" ")
            name = f"orient {axis}"
        keywords[name] = value
    arguments = []
    for word in words:
        if word != "...":
            name, _, unit = word.strip("[]").partition(":")
            arguments.append(Argument(name, unit, literal=name != name.upper() or not name[0].isalpha(), optional=word.startswith("[")))
    return Form(command, tuple(arguments), "..." in words, keywords)


def form_of(command: str, words: list[str]) -> Form | None:
    """The most special form that a line fits."""
    fitting = [form for form in forms().get(command, ()) if form.fits(words)]
    return max(fitting, key=lambda form: (form.literals, len(form.arguments)), default=None)


def read(command: str, words: list[str]) -> list[Given]:
    """The arguments of a line by name, then the keywords it leaves out with their defaults."""
    form = form_of(command, words)
    if form is None:
        return [Given("", word) for word in words]
    box = "units" in words and words[words.index("units") + 1 : words.index("units") + 2] == ["box"]
    given, rest = [], list(words)
    for one in form.arguments:
        if not rest or (one.optional and rest[0] in form.keywords):
            continue
        word = rest.pop(0)
        unit = "distance" if one.unit == "distance*" and box else one.unit
        given.append(Given("" if one.literal else one.name, word, unit))
    return given + _keywords(form, rest)


def _keywords(form: Form, rest: list[str]) -> list[Given]:
    found: list[Given] = []
    named: set[str] = set()
    loose: list[str] = []
    while rest:
        word = rest.pop(0)
        name = f"orient {rest[0]}" if word == "orient" and rest else word
        if name not in form.keywords:
            loose.append(word)
            continue
        if word == "orient":
            rest.pop(0)
        values: list[str] = []
        while rest and rest[0] not in form.keywords and (len(values) < max(1, len(form.keywords[name].split())) or not form.many):
            values.append(rest.pop(0))
        named.add(name)
        found.append(Given(name, " ".join(values)))
    others = [Given("", " ".join(loose))] if loose else []
    for name in form.keywords:  # lj/coul stands for lj and coul
        if "/" in name and set(name.split("/")) <= set(form.keywords):
            named |= set(name.split("/")) if name in named else {name}
    return others + found + [Given(name, value, default=True) for name, value in form.keywords.items() if name not in named]
