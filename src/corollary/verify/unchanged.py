"""Earlier verifications in the user's cache folder, so that only what changed since is verified again."""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Generator, Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from corollary import plug_ins, user_cache
from corollary.derive.load import NotDerivable, source
from corollary.problem.bank import Bank
from corollary.problem.packed_pictures import packed_file, unused
from corollary.problem.problem import Problem
from corollary.verify.checked import Checked
from corollary.verify.mutation.score_record import from_data
from corollary.verify.obligations.obligation import Settled
from corollary.verify.side_by_side import Todo, VerifyEach, verify_each

LIBRARIES = ("sympy", "python-flint", "numpy", "scipy", "z3-solver", "matplotlib", "numba")
"""What a verdict may depend on besides our own programs."""
PLUG_INS = ("corollary.laws", "corollary.banks", "corollary.answers")


@contextmanager
def verify_changed(
    todo: Todo, count: int, verify_those: VerifyEach = verify_each, *, anew: bool = False
) -> Generator[Iterator[Checked]]:
    """As `verify_those` does it, in the same order; what held before, and is the same, is not verified again, unless `anew`.
    Complaints are not kept."""
    before = [None if anew else _recalled(bank, problem, count) for bank, problem in todo]
    changed = [each for each, found in zip(todo, before, strict=True) if found is None]
    with verify_those(changed, count) as verified:

        def in_order() -> Iterator[Checked]:
            for (bank, problem), found in zip(todo, before, strict=True):
                yield found if found is not None else _written(next(verified), bank, problem, count)

        yield in_order()


def _recalled(bank: Bank, problem: Problem, count: int) -> Checked | None:
    with suppress(NotDerivable, ValueError, TypeError, KeyError):
        text = user_cache.read(_name(problem), origin(bank, problem, count))
        if text is not None:
            found: dict[str, Any] = json.loads(text)
            found["obligations"] = tuple(Settled(**each) for each in found["obligations"])
            found["mutation"] = from_data(found["mutation"])
            for name in ("complaints", "notes", "unread"):
                found[name] = tuple(found[name])
            found["why"] = tuple((reason, times) for reason, times in found["why"])
            return Checked(**found)
    return None


def _written(checked: Checked, bank: Bank, problem: Problem, count: int) -> Checked:
    if checked.ok:
        with suppress(NotDerivable):
            text = json.dumps(asdict(checked), ensure_ascii=False).encode()
            user_cache.write(_name(problem), origin(bank, problem, count), text)
    return checked


def _name(problem: Problem) -> str:
    return user_cache.name_of(f"verified-{problem.name}", problem.path)


def origin(bank: Bank, problem: Problem, count: int) -> str:
    """Tells apart whatever could be verified differently: the problem with its translations, its solution, all programs.

    Raises NotDerivable where the solution cannot be read.
    """
    beside = sorted(problem.path.parent.glob(f"{problem.path.stem}*.md"))
    texts = [packed_file(path) for path in beside if path.is_file()]
    own = source(bank, problem) if bank.solution(problem).is_file() else b""
    parts = (
        _programs(),
        plug_ins.state(PLUG_INS).encode(),
        str(count).encode(),
        repr(problem).encode(),
        own,
        repr(unused(problem.path)).encode(),
        *texts,
    )
    return hashlib.sha256(b"\0".join(parts)).hexdigest()


@cache
def _programs() -> bytes:
    found = [platform.python_version()]
    for library in LIBRARIES:
        try:
            found.append(f"{library} {version(library)}")
        except PackageNotFoundError:
            found.append(f"{library} is not there")
    return hashlib.sha256(f"{found} {user_cache.programs(['.'])}".encode()).digest()
