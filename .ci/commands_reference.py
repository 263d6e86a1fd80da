"""Writes docs/commands.md: every command with its arguments, options and exit statuses, from the code.

`python .ci/commands_reference.py` writes it, `--check` says whether it is up to date (a test asks).
"""

from __future__ import annotations

import sys
from collections.abc import Iterator

import click
from reference_page import table, written

from corollary.cli.commands import app

OPENING = """\
# Commands

Every command with all it takes, made from the code by `python .ci/commands_reference.py`. `corollary COMMAND --help` prints the
same. What they are for is told [for instructors](instructor.md), [for authors](author.md) and
[from Python](library.md).

With `--json` a command prints one JSON document on standard output and nothing else there; messages go to standard error.

| exit status | means |
|---|---|
| 0 | done |
| 1 | something asked for does not hold: a problem fails verification, a key is wrong, a change waits for `--yes` |
| 2 | the command was called wrongly; a sentence says what to do |
| 130 | stopped by ctrl-C |

| variable | sets |
|---|---|
| `COROLLARY_BANK` | the banks where `--bank` is left out, parted as in `PATH` |
| `COROLLARY_COURSE` | the course's folder where `--course` is left out |
| `COROLLARY_DEBUG` | `1`: an error of the program ends with Python's traceback |
"""


def page() -> str:
    """The whole page."""
    context = click.Context(app)
    return (
        "\n".join([OPENING, *(line for name in app.list_commands(context) for line in _command(name))]) + "\n"
    )


def _command(name: str) -> Iterator[str]:
    command = app.commands[name]
    yield f"## {name}\n"
    yield f"{command.help}\n"
    if command.params:
        yield from table(("takes", "meaning"), map(_row, command.params))


def _row(parameter: click.Parameter) -> tuple[str, str]:
    context = click.Context(app)
    if isinstance(parameter, click.Option):
        names, words = parameter.get_help_record(context) or ("", "")
        return ", ".join(f"`{name}`" for name in reversed(names.split(", "))), words
    return f"`{parameter.make_metavar(context)}`", " ".join((getattr(parameter, "help", None) or "").split())


if __name__ == "__main__":
    sys.exit(written("commands.md", page(), sys.argv[1:]))
