"""An explanation as one page for a browser: the script at the left, what it does at the right; nothing comes from the network."""

from __future__ import annotations

from html import escape
from pathlib import Path

from pylmp.tools.explain.pages import about
from pylmp.tools.explain.text import kept
from pylmp.tools.explain.units import named
from pylmp.tools.explain.watch import Story, Told

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 70rem; padding: 0 1rem; color: #1d1d1f; background: #fff }
code, .line { font-family: ui-monospace, Menlo, Consolas, monospace; font-size: 13px }
details { border-top: 1px solid #ddd; padding: .35rem 0 } summary { cursor: pointer; white-space: pre-wrap }
summary .at { color: #888; display: inline-block; min-width: 3.5rem } .change { color: #06642c } .says { color: #777 } .wrong { color: #b00020 }
table { border-collapse: collapse; margin: .3rem 0 } td { padding: .1rem .8rem .1rem 0; vertical-align: top } .default { color: #777 } ul { margin: .2rem 0 }
@media (prefers-color-scheme: dark) { body { color: #eee; background: #161618 } details { border-color: #333 } .change { color: #7bd88f } }
"""


def whole(story: Story) -> str:
    """The whole page."""
    title = escape(Path(story.script).name)
    blocks = "".join(_command(one) for one in story.commands)
    rows = "".join(f"<tr><td>{escape(name)}</td><td>{escape(text)}</td></tr>" for name, text in story.facts.items())
    end = f"<p>{escape(story.end)}.</p>" if story.end else ""
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>{_STYLE}</style></head><body>\n'
        f"<h1><code>{title}</code></h1>\n<p>Each command, what it does here and what it changes. No step was made.</p>\n{blocks}{end}\n"
        f"<h2>At the end of the script</h2>\n<table>{rows}</table>\n</body></html>\n"
    )


def _command(one: Told) -> str:
    parts = []
    link = ""
    page = about(one.words)
    if page is not None:
        formula = "".join(f"<pre>{escape(line)}</pre>" for line in page.formula)
        parts.append(f"<p>{escape(page.meaning)}</p>{formula}")
        link = f'<p><a href="{escape(page.link)}">manual</a></p>'
    rows = ""
    for given in one.arguments:
        if given.name:
            mark = ' class="default"' if given.default else ""
            unit = f" ({kept(one.words[0])})" if given.default else " " + named(given.unit, one.units)
            rows += f"<tr{mark}><td>{escape(given.name.lower())}</td><td><code>{escape(given.value)}</code>{escape(unit)}</td></tr>"
    parts.append(f"<table>{rows}</table>" if rows else "")
    parts += [f'<div class="change">{escape(change)}</div>' for change in one.changes]
    parts += [f'<div class="says">{escape(line)}</div>' for line in one.says]
    if one.run is not None:
        run = one.run
        lacks = f": engine fast lacks {escape(', '.join(run.fallbacks))}" if run.fallbacks else ""
        parts.append(f"<p>Engine {run.engine}{lacks}. Memory {escape(run.memory)}. Time {escape(run.time)}, for {run.steps} steps.</p>")
        for head, texts in (("Each step", run.computed), ("Left out", run.left_out)):
            parts.append(f"<p>{head}</p><ul>{''.join(f'<li>{escape(text)}</li>' for text in texts)}</ul>")
    if one.problem is not None:
        parts.append(f'<div class="wrong">{escape(one.problem.message)} {escape(one.problem.hint)}</div>')
    times = f" ({one.visits} times)" if one.visits > 1 else ""
    wrong = " wrong" if one.problem else ""
    head = f'<summary class="line{wrong}"><span class="at">{one.span.line}</span>{escape(" ".join(one.words))}{times}</summary>'
    return f"<details>{head}{''.join(parts)}{link}</details>\n"
