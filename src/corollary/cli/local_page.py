"""A page on this machine, its address printed and opened, served until ctrl-C; and the files of a problem, watched for changes."""

from __future__ import annotations

import webbrowser
from contextlib import suppress
from pathlib import Path

from corollary.cli.ending import say
from corollary.course.one_page_server import OnePageServer
from corollary.problem.bank import Bank
from corollary.problem.packed_pictures import pictures_of


def edition(bank: Bank, path: Path) -> str:
    """Tells the files of a problem apart from what they were: its own, its pictures, its solution, the programs beside that, and the
    bank's ready-made scenes."""
    solution, scenes = bank.solution_beside(path), bank.home_of(path).scenes
    beside = [*solution.parent.glob("*.py"), *solution.with_suffix("").rglob("*.py"), *scenes.glob("*.py")]
    with suppress(OSError):
        beside += pictures_of(path)
    states: list[str] = []
    for each in (path, *sorted(set(beside))):
        with suppress(OSError):  # an editor that moves a file into place leaves none for a moment
            found = each.stat()
            states.append(f"{each.name} {found.st_mtime_ns} {found.st_size}")
    return "; ".join(states)


def serve(server: OnePageServer, what: str, no_browser: bool) -> None:
    """`what` is said of the page behind its address; the server is closed at the end."""
    with server:
        print(server.address, flush=True)
        say(f"this address is for you alone; {what}")
        if not no_browser:
            webbrowser.open(server.address)
        with suppress(KeyboardInterrupt):
            server.serve_forever()
