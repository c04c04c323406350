"""if CONDITION then COMMAND... [elif CONDITION COMMAND...] [else COMMAND...]"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.condition import ConditionError, holds
from pylmp.text.words import Args, Word


@command("if", manual="if.html")
def if_(sim: Simulation, args: Args) -> None:
    """Carry out the commands of the first condition that holds."""
    args.need(3)
    true = _holds(sim, args, args.word())
    keyword = args.word()
    if keyword.text != "then":
        hint = 'if "condition" then "command"'
        args.fail(f'Illegal if command: expected "then" but found "{keyword.text}"', keyword, hint=hint)
    while True:
        commands = _commands(args)
        if true:
            if not commands and keyword.text != "else":
                part = "then" if keyword.text == "then" else "elif/else"
                args.fail(
                    f"Illegal if {part} command: missing argument(s)", keyword, hint="commands follow, each in quotes"
                )
            for one in commands:
                sim.script.execute_word(one)
            return
        if not len(args):
            return
        keyword = args.word()
        if keyword.text == "else":
            true = True
        elif len(args) < 2:
            args.fail("Illegal if elif/else command: missing argument(s)", keyword, hint='elif "condition" "command"')
        else:
            true = _holds(sim, args, args.word())


def _commands(args: Args) -> list[Word]:
    found = []
    while (word := args.peek()) is not None and word.text not in ("elif", "else"):
        found.append(args.word())
    return found


def _holds(sim: Simulation, args: Args, condition: Word) -> bool:
    try:
        return holds(sim.script.substitute_text(condition))
    except ConditionError as error:
        args.fail(str(error), condition, hint='numbers compared, as in "$x < 3 && $y == 1"')
