"""The entry point of the command `corollary`."""

from __future__ import annotations

import sys

import click

from corollary.cli.commands import app
from corollary.cli.ending import REFUSED, STOPPED, say


def main() -> None:
    """Runs a command; a request that cannot be understood is answered in one sentence."""
    try:
        status = app(standalone_mode=False)
    except click.ClickException as error:
        status, sentence = REFUSED, error.format_message()
        if sentence.startswith("Usage:"):  # no command was named
            say(sentence)
        else:
            say(f"corollary: {sentence[0].lower()}{sentence[1:].rstrip('.')}; `{_named()} --help` says how")
    except click.Abort:
        status = STOPPED
    sys.exit(status or 0)


def _named() -> str:
    """The command that was meant, as far as it is one."""
    return " ".join(["corollary", *(name for name in sys.argv[1:2] if name in app.commands)])
