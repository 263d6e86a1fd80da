"""Modules imported from text that a notebook carries; this module is carried too, and alone: it needs Python itself only."""

from __future__ import annotations

import sys
from base64 import b64decode
from collections.abc import Mapping, Sequence
from importlib import import_module
from importlib.abc import InspectLoader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.metadata import PackageNotFoundError, version
from importlib.util import spec_from_loader
from types import ModuleType
from typing import Any


class Carried(MetaPathFinder, InspectLoader):
    """Finds and loads modules among `sources`, by their dotted names."""

    def __init__(self, sources: Mapping[str, str]) -> None:
        self.sources = sources

    def find_spec(
        self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        return spec_from_loader(fullname, self) if fullname in self.sources else None

    def is_package(self, fullname: str) -> bool:
        return any(name.startswith(fullname + ".") for name in self.sources)

    def get_source(self, fullname: str) -> str:
        return self.sources[fullname]


def checker(carried: Mapping[str, Any], space: Mapping[str, Any]) -> object:
    """`check` for the answers in `space`, made of the code that is carried, or of the same code where it is installed."""
    names = [
        "corollary.notebook.check",
        "corollary.units.unit_table",
        "corollary.messages",
        *(f"{folder}.reading" for folder in carried["folders"].values()),
    ]
    same = all(_installed(package) == its_version for package, its_version in carried["versions"].items())
    modules = _imported(carried["modules"], [] if same else names)
    check, units, messages, *readings = [import_module(name) for name in names] if same else modules
    for row in carried["units"]:
        units.register(*row)
    for domain, text in carried["catalogues"].items():
        messages.carry(domain, carried["language"], b64decode(text))
    types = {name: module.TYPE for name, module in zip(carried["folders"], readings, strict=True)}
    return check.Check(types, carried["questions"], space, carried["modules"], carried["language"])


def _installed(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _imported(sources: Mapping[str, str], names: Sequence[str]) -> list[ModuleType]:
    """The modules of these names, from their carried text. What is installed of another version is untouched by it."""
    packages = {name.partition(".")[0] for name in sources}
    installed = {name: sys.modules.pop(name) for name in _loaded(packages)}
    finder = Carried(sources)
    sys.meta_path.insert(0, finder)
    try:
        return [import_module(name) for name in names]
    finally:
        sys.meta_path.remove(finder)
        for name in _loaded(packages):
            del sys.modules[name]
        sys.modules.update(installed)


def _loaded(packages: set[str]) -> list[str]:
    return [name for name in sys.modules if name.partition(".")[0] in packages]
