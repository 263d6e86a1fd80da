"""Where tables are printed: as wide as the terminal is, and where there is none as wide as they are."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rich.console import Console

UNLIMITED: Final = 10_000
"""Columns. A pipe has no width of its own; rich takes 80, and what does not fit would be cut off for whoever reads it there."""


def console(*, stderr: bool = False) -> Console:
    """A console on standard output, or on standard error."""
    from rich.console import Console  # only by commands that print tables

    stream = sys.stderr if stderr else sys.stdout
    limited = stream.isatty() or "COLUMNS" in os.environ
    return Console(stderr=stderr, width=None if limited else UNLIMITED)
