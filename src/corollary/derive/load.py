"""The only door to `solutions/`: a problem's derivation, its scene, and nothing else of the file."""

from __future__ import annotations

import importlib.util
import inspect
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, cast

from corollary.answers.questions import checked
from corollary.derive.beside import importable, modules_beside
from corollary.derive.cases import Branch
from corollary.derive.derivation import Derivation
from corollary.derive.statements import SOLUTION
from corollary.formula.ast import Name, Number, Relation
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem

if TYPE_CHECKING:
    import sympy


class NotDerivable(Exception):
    """A solution that does not derive what it should; says where (file and line) and what to do."""

    def __init__(self, path: Path, line: int, sentence: str):
        self.path, self.line, self.sentence = path, line, sentence
        super().__init__(f"{path.name}:{line}: {sentence}" if line else f"{path.name}: {sentence}")

    def __reduce__(self):
        """So that it can be raised in one process and caught in another."""
        return NotDerivable, (self.path, self.line, self.sentence)


@dataclass(frozen=True, slots=True)
class Loaded:
    """What a solution file says: the derivation (of its first case), the line where derive begins, and what to simulate."""

    path: Path
    derivation: Derivation
    line: int
    scene: Callable[..., Any] | None
    branches: tuple[Branch, ...]


def symbol_of(problem: Problem, name: str) -> sympy.Symbol:
    """A given as a symbol; it is positive (or not negative, …) when a `require:` of the problem says so."""
    import sympy  # only here: a solution that is in the cache is used without it

    known: dict[str, bool] = {}
    turned = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
    for condition in problem.conditions:
        relation = condition.relation
        if isinstance(relation.left, Number) and relation.sign in turned:  # 0 < m
            relation = Relation(turned[relation.sign], relation.right, relation.left)
        match relation:  # pyright: ignore[reportMatchNotExhaustive]
            case Relation(sign, Name(left), Number(value)) if condition.hard and left == name and value == 0:
                known |= {
                    ">": {"positive": True},
                    ">=": {"nonnegative": True},
                    "<": {"negative": True},
                    "<=": {"nonpositive": True},
                }.get(sign, {})
    return sympy.Symbol(name, real=True, **known)


def load(bank: Bank, problem: Problem) -> Loaded:
    """The derivation of a problem. Raises NotDerivable when the file is missing, fails, or asks for givens that are not there.

    Raises Malformed when a part's heading does not fit its answer type.
    """
    checked(problem)
    path = bank.solution(problem)
    if not path.is_file():
        raise NotDerivable(
            path, 0, f"is missing; {problem.path.name} needs a solution there, with a function derive(…)"
        )
    with importable(path):
        return _loaded(problem, path)


def _loaded(problem: Problem, path: Path) -> Loaded:
    module = _module(path)
    derive = getattr(module, "derive", None)
    if not inspect.isfunction(derive):
        raise NotDerivable(path, 1, "defines no function derive(…) with the givens as arguments")
    line = derive.__code__.co_firstlineno
    wanted = list(inspect.signature(derive).parameters)
    have = [given.symbol for given in problem.givens if not given.words]  # words are for the statement
    if strange := [name for name in wanted if name not in have]:
        raise NotDerivable(
            path,
            line,
            f"derive takes {', '.join(strange)}, not among the givens of {problem.code} ({', '.join(have)})",
        )
    from corollary.laws.law import own_letters  # only here, as sympy above

    symbols = {name: symbol_of(problem, name) for name in have}
    try:
        with own_letters(symbols):
            derivation = derive(**{name: symbols[name] for name in wanted})
    except (Exception, SystemExit) as error:
        raise NotDerivable(
            path, line_in(error, path) or line, f"derive fails: {type(error).__name__}: {error}"
        ) from error
    stated = cast("tuple[Any, ...]", derivation) if isinstance(derivation, tuple) else ()
    if not all(isinstance(each, Branch) for each in stated) or not stated:
        raise NotDerivable(path, line, "derive must return derivation(…)")
    scene = getattr(module, "scene", None)
    return Loaded(path, stated[0].derivation, line, scene if inspect.isfunction(scene) else None, stated)


def source(bank: Bank, problem: Problem) -> bytes:
    """The text of a solution, with that of the modules beside it that it imports. Raises NotDerivable when it is missing."""
    path = bank.solution(problem)
    try:
        own = path.read_bytes()
        return b"\0".join((own, *(each.read_bytes() for each in modules_beside(path, own))))
    except OSError as error:
        raise NotDerivable(path, 0, f"cannot be read: {error.strerror}") from None


def line_in(error: BaseException, path: Path) -> int:
    """The deepest line of the file that took part in an exception."""
    lines = [
        frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)
    ]
    return lines[-1] or 0 if lines else 0


def _module(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(SOLUTION + path.stem, path)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    try:
        # Compiled anew: Python takes its own copy for the same file when size and second are, as after a quick change of a sign.
        exec(compile(path.read_bytes(), str(path), "exec", dont_inherit=True), vars(module))
    except SyntaxError as error:
        raise NotDerivable(path, error.lineno or 1, f"is not Python: {error.msg}") from None
    except (Exception, SystemExit) as error:
        raise NotDerivable(
            path, line_in(error, path), f"cannot be loaded: {type(error).__name__}: {error}"
        ) from error
    return module
