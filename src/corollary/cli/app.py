"""The command `corollary`: what it is called with, and how a command of its table becomes one of its own."""

from __future__ import annotations

from functools import partial
from typing import Any

import click

from corollary.cli.ending import run
from corollary.cli.left_out import completed
from corollary.cli.parameters import BANK, COURSE
from corollary.version import __version__


class Commands(click.Group):
    """The commands in the order in which a course needs them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.commands)


app = Commands(
    "corollary",
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Physics exercises whose answers are derived from the laws: numbers for each student, marks for what they hand in.",
)
click.version_option(__version__, message="%(version)s", help="Show the version and leave.")(app)


def command(
    name: str, sentence: str, *parameters: click.Parameter, module: str = "", settings: bool = True
) -> None:
    """One more command: `run` of its module in this folder gets the parameters by name, and gives the exit status.

    `settings`: what is left out is as the course has it.
    """
    of_course = partial(completed, course_needed=COURSE in parameters, any_bank=BANK in parameters)
    callback = partial(run, module or name, of_course if settings else dict[str, Any])
    app.add_command(click.Command(name, params=list(parameters), help=sentence, callback=callback))
