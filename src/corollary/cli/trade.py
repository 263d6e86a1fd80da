"""`corollary trade`: speed against accuracy, measured by the races in `benchmarks/trade`."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path

from corollary.cli.ending import refuse


def run(scenes: list[str], output: Path | None, as_json: bool, quick: bool) -> int:
    """The races live outside of the package, since no other command needs them."""
    folder = str(_folder())
    if folder not in sys.path:
        sys.path.insert(0, folder)
    return import_module("trade.command").run(scenes, output, as_json, quick)


def _folder() -> Path:
    """Where the package of races lies: inside an installed corollary, or beside the src of a checkout."""
    corollary = Path(__file__).resolve().parent.parent
    found = [
        folder
        for folder in (corollary / "benchmarks", corollary.parent.parent / "benchmarks")
        if (folder / "trade" / "command.py").is_file()
    ]
    if not found:
        refuse(
            f"the races are missing beside {corollary}; install Corollary anew, from its folder, or run it in a checkout"
        )
    return found[0]
