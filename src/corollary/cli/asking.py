"""A question before something is lost: answered on the terminal, or by `--yes`; with neither nothing happens."""

from __future__ import annotations

import sys

import click

from corollary.cli.ending import say


def agreed(question: str, yes: bool) -> bool:
    """Whether to go on. Without a terminal and without `yes` it is no, and what to do is said."""
    if yes:
        return True
    if not (sys.stdin.isatty() and sys.stderr.isatty()):
        say(f"{question} Nothing is changed; --yes agrees")
        return False
    return click.confirm(question, default=False, err=True)
