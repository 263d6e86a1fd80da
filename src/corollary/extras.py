"""The extras of this distribution: the command that installs one."""

from __future__ import annotations

from corollary.version import DISTRIBUTION


def installing(extra: str) -> str:
    """The command that installs the libraries of an extra. Double quotes, which every shell takes, cmd.exe too."""
    return f'pip install "{DISTRIBUTION}[{extra}]"'
