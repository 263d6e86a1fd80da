"""The certificate of a solution on record: the script's hash and what checked it, for as long as problem and solution are the same."""

from __future__ import annotations

import hashlib
import json
from typing import Any

from corollary import user_cache
from corollary.derive.load import source
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.version import __version__


def keep(bank: Bank, problem: Problem, text: str, checker: str, proven: list[str]) -> dict[str, Any]:
    """What is on record of a script that `checker` has accepted; `proven` names its lemmas. Raises NotDerivable."""
    found = {"sha256": hashlib.sha256(text.encode()).hexdigest(), "checker": checker, "lemmas": proven}
    user_cache.write(_name(problem), _origin(bank, problem), json.dumps(found).encode())
    return found


def on_record(bank: Bank, problem: Problem) -> dict[str, Any] | None:
    """What `keep` wrote of this very problem and solution. Raises NotDerivable."""
    text = user_cache.read(_name(problem), _origin(bank, problem))
    return None if text is None else json.loads(text)


def _name(problem: Problem) -> str:
    return user_cache.name_of(f"certificate-{problem.name}", problem.path)


def _origin(bank: Bank, problem: Problem) -> str:
    texts = __version__.encode(), problem.path.read_bytes(), source(bank, problem)
    return hashlib.sha256(b"\0".join(hashlib.sha256(each).digest() for each in texts)).hexdigest()
