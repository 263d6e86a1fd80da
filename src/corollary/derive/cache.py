"""A cache of solved derivations: what has been solved from the same two files by the same programs is not solved again."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import fields
from functools import cache
from importlib.metadata import entry_points
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import corollary
from corollary.atomic import write_whole
from corollary.derive.load import load, source
from corollary.derive.parts import unsolved
from corollary.derive.serialize import NotSerializable, from_data, to_data
from corollary.derive.solution import Solution
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.problem import Problem

ROOMS = (
    "formula",
    "units",
    "answers",
    "laws",
    "problem",
    "derive",
    "author.py",
)  # what decides how a derivation is solved
ALGEBRA = ("sympy", "mpmath")
PLUG_INS = ("corollary.laws", "corollary.banks")
LARGEST = 8_000_000


def solution_of(bank: Bank, problem: Problem) -> Solution:
    """The derivation solved, or as it was solved before from the same files by the same programs. Raises NotDerivable.

    The file lies in the user's cache folder, readable to the user alone since it holds answers. It can be deleted at any
    time; what is stale, damaged, or not the user's own is solved anew and written over.
    """
    if not bank.solution(problem).is_file():
        return _solved(bank, problem)
    origin = _origin(bank, problem)
    place = _place(bank, problem)
    found = None if place is None else _read(place, origin, bank, problem)
    if found is None:
        found = _solved(bank, problem)
        if place is not None:
            _write(place, origin, found)
    return found


def _solved(bank: Bank, problem: Problem) -> Solution:
    from corollary.derive.solve import solve  # only here: the algebra takes half a second to load

    return solve(bank, problem)


def _read(place: Path, origin: str, bank: Bank, problem: Problem) -> Solution | None:
    """What the cache holds, if it is what would be solved now."""
    with suppress(OSError, ValueError, TypeError, KeyError, ArithmeticError, RecursionError):
        with place.open("rb") as file:
            if os.fstat(file.fileno()).st_uid != os.getuid():
                return None
            made_from, checked, text = file.read(LARGEST).split(b"\n", 2)
        if (made_from.decode(), checked.decode()) != (origin, hashlib.sha256(text).hexdigest()):
            return None
        content = from_data(json.loads(text))
        entries = content.pop("entries")
        return Solution(
            problem=problem,
            **content,
            entries=unsolved(load(bank, problem).derivation) if entries is None else entries,
        )
    return None


def _write(place: Path, origin: str, solution: Solution) -> None:
    """Written aside and moved, so that whoever reads at the same time finds all of it or nothing new."""
    content: dict[str, Any] = {
        each.name: getattr(solution, each.name) for each in fields(solution) if each.name != "problem"
    }
    with suppress(OSError, NotSerializable, ValueError, RecursionError):
        try:
            data = to_data(content)
        except (
            NotSerializable
        ):  # programs among the entries: these are loaded from the solution file each time
            data = to_data(content | {"entries": None})
        text = json.dumps(data, separators=(",", ":")).encode()
        place.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        checked = hashlib.sha256(text).hexdigest().encode()
        write_whole(place, b"\n".join((origin.encode(), checked, text)), mode=0o600)


def _origin(bank: Bank, problem: Problem) -> str:
    """Tells apart whatever could be solved differently: the problem as read, its solution, our own programs, the algebra."""
    plug_ins = b"" if bank == chapter_bank() else _plug_ins()  # the chapter's own bank needs none of them
    return hashlib.sha256(
        b"\0".join((_programs(), plug_ins, repr(problem).encode(), source(bank, problem)))
    ).hexdigest()


@cache
def _programs() -> bytes:
    """By size and moment of change, not by text: reading them all takes longer than a key. A copy elsewhere is solved anew."""
    package = Path(corollary.__file__).parent
    algebra = [Path(spec.origin) for name in ALGEBRA if (spec := find_spec(name)) and spec.origin]
    digest = hashlib.sha256(repr((corollary.__version__, sys.version)).encode())
    digest.update(
        _state(sorted([path for room in ROOMS for path in _sources(package / room)] + algebra)).encode()
    )
    return digest.digest()


@cache
def _plug_ins() -> bytes:
    """The packages that bring laws and banks, as they are now: looked up once, however many problems a command solves."""
    names = {entry.module.partition(".")[0] for group in PLUG_INS for entry in entry_points(group=group)}
    specs = [spec for name in sorted(names) if (spec := find_spec(name)) is not None]
    folders = [Path(place) for spec in specs for place in spec.submodule_search_locations or ()]
    return _state([path for folder in folders for path in sorted(folder.rglob("*.py"))]).encode()


def _state(paths: Iterable[Path]) -> str:
    states = [(path, path.stat()) for path in paths]
    return "".join(f"{path} {state.st_size} {state.st_mtime_ns}\n" for path, state in states)


def _sources(room: Path) -> list[Path]:
    return [room] if room.suffix else list(room.rglob("*.py"))


def _place(bank: Bank, problem: Problem) -> Path | None:
    """One file for each problem of each bank, so that what is stale is written over; None where there is no cache folder."""
    with suppress(RuntimeError):  # a user without a home
        name = hashlib.sha256(str(bank.solution(problem)).encode()).hexdigest()[:16]
        return cache_folder() / f"{problem.name}-{name}.json"
    return None


def cache_folder() -> Path:
    """The platform's folder for what may be lost. Raises RuntimeError when the user has no home."""
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    if named.is_absolute():
        return named / "corollary"
    return Path.home() / ("Library/Caches" if sys.platform == "darwin" else ".cache") / "corollary"
