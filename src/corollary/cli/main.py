"""The entry point of the command `corollary`."""

from __future__ import annotations

import gc
import re
import sys
from itertools import pairwise
from typing import Any, Final

NOT_NEEDED: Final = "rfc3987_syntax"
"""Builds the grammars of all kinds of addresses, in 1.5 s, as soon as jsonschema finds it, which nbformat imports; no notebook's
schema asks for an address, and jsonschema does without where it is missing."""


def main() -> None:
    """Runs a command; a request that cannot be understood is answered in one sentence."""
    loaded: dict[str, Any] = sys.modules
    loaded.setdefault(NOT_NEEDED, None)
    gc.set_threshold(
        50_000, 20, 20
    )  # algebra makes many small objects: solving takes 13 % less time than with Python's own threshold
    hear_ctrl_c_everywhere()
    try:
        sys.exit(_status())
    except KeyboardInterrupt:  # before a command was at work, or after
        sys.exit(130)


def hear_ctrl_c_everywhere() -> None:
    """A ctrl-C that falls into a destructor or a weak reference's callback, where Python drops exceptions, comes once more."""
    usual = sys.unraisablehook

    def hook(dropped: sys.UnraisableHookArgs) -> None:
        if not issubclass(dropped.exc_type, KeyboardInterrupt):
            return usual(dropped)
        import signal  # only now: they take time to load
        import threading

        later = threading.Timer(0.01, signal.pthread_kill, (threading.main_thread().ident, signal.SIGINT))
        later.daemon = True
        return later.start()

    if sys.platform != "win32":  # which sends a thread no signal
        sys.unraisablehook = hook


def _numbers_last(words: list[str]) -> list[str]:
    """The words of a command; for `read`, an answer such as `-56.0 J` is no option, and stands behind `--`."""
    numbers = [
        word
        for before, word in pairwise(words)
        if re.match(r"-[\d.,(]", word) and not before.startswith("--")
    ]
    if words[:1] != ["read"] or len(numbers) != 1 or "--" in words:
        return words
    return [*(word for word in words if word != numbers[0]), "--", *numbers]


def _status() -> int:
    import click

    from corollary.cli.commands import app
    from corollary.cli.ending import REFUSED, STOPPED, say
    from corollary.cli.terminal import write_whatever_comes

    write_whatever_comes()
    try:
        return app(_numbers_last(sys.argv[1:]), standalone_mode=False) or 0
    except click.ClickException as error:
        sentence = error.format_message()
        if sentence.startswith("Usage:"):  # no command was named
            say(sentence)
        else:
            named = " ".join(["corollary", *(name for name in sys.argv[1:2] if name in app.commands)])
            say(f"corollary: {sentence[0].lower()}{sentence[1:].rstrip('.')}; `{named} --help` says how")
        return REFUSED
    except click.Abort:
        return STOPPED
