"""Physics as equations: what the textbook says, and what its letters mean here.

Every file here is a topic, and every public function in it a law: `from corollary.laws import momentum` finds them all. A package
of somebody else's adds topics by entry points of the group `corollary.laws`, each of which names a module; its laws are then
found under `corollary.laws`, too (where names clash, the laws here win).
"""

from __future__ import annotations

import inspect
import pkgutil
from collections.abc import Callable
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any

from corollary.laws.law import Law, law, wrong
from corollary.plug_ins import load, plug_ins

GROUP = "corollary.laws"


def laws_in(topic: ModuleType) -> dict[str, Callable[..., Any]]:
    """The laws of a topic by name: each public function written there."""
    return {
        name: value
        for name, value in vars(topic).items()
        if inspect.isfunction(value) and value.__module__ == topic.__name__ and not name.startswith("_")
    }


def _topics() -> list[ModuleType]:
    names = [each.name for each in pkgutil.iter_modules(__path__) if each.name != "law"]
    return [import_module(f"{__name__}.{name}") for name in sorted(names)]


_OWN = {name: value for topic in _topics() for name, value in laws_in(topic).items()}
globals().update(_OWN)
__all__ = ["Law", "law", "wrong"]
__all__ += sorted(_OWN)  # pyright: ignore[reportUnsupportedDunderAll]


@cache
def _plugged_in() -> dict[str, Callable[..., Any]]:
    """The laws of installed packages. Raises ImportError for a law that two of them claim, PlugInFault for what cannot be loaded."""
    found: dict[str, Callable[..., Any]] = {}
    for entry in plug_ins(GROUP).values():
        for name, value in laws_in(load(entry, "the laws")).items():
            if name in found:
                where = f"{found[name].__module__} and {value.__module__}"
                raise ImportError(f"the law {name} is in both {where}; import it from its own module")
            found[name] = value
    return found


def library() -> dict[str, Callable[..., Any]]:
    """Every law by name, those of installed packages among them. Raises ImportError, PlugInFault."""
    return {**_plugged_in(), **_OWN}


def __getattr__(name: str) -> Any:
    """A law that is not ours, from an installed package."""
    if not name.startswith("_") and name in _plugged_in():
        return _plugged_in()[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
