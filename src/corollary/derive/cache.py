"""A cache of solved derivations: what has been solved from the same two files by the same programs is not solved again."""

from __future__ import annotations

import hashlib
import json
import sys
from contextlib import suppress
from dataclasses import fields
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from corollary import plug_ins, user_cache
from corollary.derive.load import load, source
from corollary.derive.numbered_list import listed
from corollary.derive.parts import unsolved
from corollary.derive.serialize import NotSerializable, from_data, to_data
from corollary.derive.solution import Regime, Solution
from corollary.problem.bank import Bank, bank_of, chapter_bank
from corollary.problem.problem import Problem
from corollary.version import __version__

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


HELD = {"entries", "regimes"}  # by the whole solution


def solution_of(bank: Bank, problem: Problem) -> Solution:
    """The derivation solved, or as it was solved before from the same files by the same programs. Raises NotDerivable.

    One file for each problem of each bank in the user's cache folder, so that what is stale is written over. It can be
    deleted at any time; what is stale, damaged, or not the user's own is solved anew.
    """
    place = bank.solution(problem)
    if not place.is_file():
        return _solved(bank, problem)
    origin = _origin(bank, problem)
    name = user_cache.name_of(problem.name, place)
    found = _recalled(user_cache.read(name, origin), bank, problem)
    if found is None:
        found = _solved(bank, problem)
        with suppress(NotSerializable, ValueError, RecursionError):
            user_cache.write(name, origin, _text(found))
    return found


def _solved(bank: Bank, problem: Problem) -> Solution:
    from corollary.derive.solve import solve  # only here: the algebra takes half a second to load

    return solve(bank, problem)


def _recalled(text: bytes | None, bank: Bank, problem: Problem) -> Solution | None:
    """What the cache holds, if it is a solution."""
    if text is None:
        return None
    with suppress(ValueError, TypeError, KeyError, ArithmeticError, RecursionError):
        content = from_data(json.loads(text))
        entries = content.pop("entries")
        if entries is None:
            entries = unsolved(load(bank, problem).derivation)
        regimes = tuple(
            Regime(text, conditions, line, Solution(problem=problem, **found, entries=entries), place)
            for text, conditions, line, found, place in content.pop("regimes")
        )
        found = Solution(problem=problem, **content, regimes=regimes, entries=entries)
        return listed(found) if any(find.numbering for find in found.unknowns) else found
    return None


def _text(solution: Solution) -> bytes:
    solution = solution.template or solution
    content: dict[str, Any] = {
        each.name: getattr(solution, each.name)
        for each in fields(solution)
        if each.name not in ("problem", "template")
    }
    shared = content.keys() - HELD
    content["regimes"] = [
        (
            each.text,
            each.conditions,
            each.line,
            {name: getattr(each.solution, name) for name in shared},
            each.place,
        )
        for each in solution.regimes
    ]
    try:
        data = to_data(content)
    except NotSerializable:  # programs among the entries: these are loaded from the solution file each time
        data = to_data(content | {"entries": None})
    return json.dumps(data, separators=(",", ":")).encode()


def _origin(bank: Bank, problem: Problem) -> str:
    """Tells apart whatever could be solved differently: the problem as read, its solution, our own programs, the algebra."""
    brought = (
        "" if bank_of(problem) == chapter_bank() else plug_ins.state(PLUG_INS)
    )  # the chapter's own bank needs none of them
    return hashlib.sha256(
        b"\0".join((_programs(), brought.encode(), repr(problem).encode(), source(bank, problem)))
    ).hexdigest()


@cache
def _programs() -> bytes:
    algebra = [Path(spec.origin) for name in ALGEBRA if (spec := find_spec(name)) and spec.origin]
    state = user_cache.programs(ROOMS) + user_cache.state(algebra)
    return hashlib.sha256(f"{__version__} {sys.version} {state}".encode()).digest()
