"""The judges of the chapter's bank, loaded as its solutions load them."""

from __future__ import annotations

from typing import Any

from corollary.derive.beside import LazyModule
from corollary.problem.bank import chapter_bank


def judges(file: str, names: str) -> list[Any]:
    """What has these names in a file below `solutions/`, which lies in a folder of its own beside the solution it is for."""
    path = chapter_bank().folder / "solutions" / file
    module = LazyModule(path, path.parents[1])
    return [getattr(module, name) for name in names.split()]
