"""Plug-ins of installed packages: their entry points by group and name, and loading them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from corollary.version import DISTRIBUTION

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


class PlugInFault(LookupError):
    """An installed package cannot be used as it is; one sentence names it and says why."""


@cache
def plug_ins(group: str, ours: tuple[str, ...] = ()) -> Mapping[str, EntryPoint]:
    """The entry points of a group by name; `ours` are the names of that sort that we use.

    Raises PlugInFault for a name that two packages use, or we and another.
    """
    from importlib.metadata import entry_points  # slow, and needed only for what is not ours

    found: dict[str, EntryPoint] = {}
    for entry in entry_points(group=group):
        other = found.setdefault(entry.name, entry)
        owners = [DISTRIBUTION] if entry.name in ours else [_package(other)] if other != entry else []
        if owners:
            raise PlugInFault(
                f"{owners[0]} and {_package(entry)} are both installed and both bring {entry.name} ({group}); "
                "uninstall one of them, or ask its authors for another name"
            )
    return MappingProxyType(found)


def load(entry: EntryPoint, what: str, module: str = "") -> Any:
    """What an entry point names, or a module of the package that it names; `what` says what that is. Raises PlugInFault."""
    try:
        return import_module(f"{entry.value}.{module}") if module else entry.load()
    except Exception as error:  # whatever a package of somebody else's raises while it is imported
        raise fault(entry, what, f"{type(error).__name__}: {error}") from error


def fault(entry: EntryPoint, what: str, why: str) -> PlugInFault:
    return PlugInFault(
        f"{what} {entry.name} of {_package(entry)} cannot be used: {entry.value}: {why.rstrip('.')}; "
        "update that package or uninstall it"
    )


@cache
def state(groups: tuple[str, ...]) -> str:
    """The programs of all packages that bring something in these groups, as they are: looked up once, however many ask."""
    from corollary import user_cache  # only here: where modules are carried as texts there are no files

    names = {entry.module.partition(".")[0] for group in groups for entry in plug_ins(group).values()}
    specs = [spec for name in sorted(names) if (spec := find_spec(name)) is not None]
    folders = [Path(place) for spec in specs for place in spec.submodule_search_locations or ()]
    return user_cache.state(path for folder in folders for path in sorted(folder.rglob("*.py")))


def _package(entry: EntryPoint) -> str:
    """The name a package is installed and uninstalled by."""
    return entry.dist.name if entry.dist is not None else entry.module.partition(".")[0]
