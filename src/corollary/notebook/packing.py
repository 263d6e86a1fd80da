"""The code that reads answers, as text that can stand in a notebook: modules in the order of their imports, comments and all."""

from __future__ import annotations

import ast
import re
import sys
from functools import cache
from importlib.resources import files

PACKAGE = "corollary_check"  # what the readers are called where corollary is not installed


@cache
def readers(*roots: str) -> tuple[tuple[str, str], ...]:
    """The (name, source) of the named modules ("sheet/as_read") and of everything of ours that they import, imported first.

    Raises ValueError when one of them could not run in a notebook: it needs more than Python itself, or holds the quotes
    that its text is put between.
    """
    found: dict[str, str] = {}
    for root in roots:
        _follow(root, found)
    names = [place.rpartition("/")[2] for place in found]
    if len(set(names)) != len(names):
        raise ValueError(f"two of the readers {', '.join(found)} have the same name")
    return tuple(zip(names, found.values(), strict=True))


def _follow(place: str, found: dict[str, str]) -> None:
    if place in found:
        return
    text = files("corollary").joinpath(place + ".py").read_text(encoding="utf-8")
    if "'''" in text:
        raise ValueError(f"{place}.py holds ''' and so cannot stand in a notebook as plain text")
    for module in _imports(text):
        family = module.partition(".")[0]
        if family == "corollary":
            _follow(module.removeprefix("corollary.").replace(".", "/"), found)
        elif family not in sys.stdlib_module_names:
            raise ValueError(f"{place}.py imports {module}, which a student's computer may not have")
    found[place] = re.sub(
        r"^from corollary(?:\.\w+)*\.(\w+) import", rf"from {PACKAGE}.\1 import", text, flags=re.MULTILINE
    )


def _imports(text: str) -> list[str]:
    """The modules imported at the top; what a function imports when it is called is its own affair."""
    modules = []
    for node in ast.parse(text).body:
        match node:
            case ast.ImportFrom(module=str(module)):
                modules.append(module)
            case ast.Import(names=names):
                modules += [alias.name for alias in names]
            case _:
                pass
    return modules
