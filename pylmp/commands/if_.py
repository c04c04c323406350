"""if CONDITION then COMMAND... [elif CONDITION COMMAND...] [else COMMAND...]"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.condition import ConditionError, holds
from pylmp.text.words import Args, Word


@command("if", manual="if.html")
def if_(sim: Simulation, args: Args) -> None:
    """Carry out the commands of the first condition that holds."""
    if len(args) < 3:
        args.missing()
    condition = args.word()
    then = args.word()
    if then.text != "then":
        args.illegal(then, hint='if "condition" then "command"')
    while True:
        commands = _commands(args)
        if not commands:
            args.illegal(args.peek() or args.words[-1], hint="commands follow, each in quotes")
        if _holds(sim, args, condition):
            for one in commands:
                sim.script.execute(one.text, one.span)
            return
        if not len(args):
            return
        keyword = args.word()
        if keyword.text == "else":
            for one in _commands(args):
                sim.script.execute(one.text, one.span)
            return
        condition = args.word()


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
