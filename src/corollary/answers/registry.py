"""Every answer type by its name: those of this package, and what other packages bring under `corollary.answers`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Protocol

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Verdict

if TYPE_CHECKING:  # what is expected is made of certified numbers, which reading an answer does not need
    from corollary.answers.expected import Expected

GROUP = "corollary.answers"
BUILT_IN = ("value", "vector", "expression", "choice", "example", "code", "plot", "explain", "proof")


class UnknownAnswerType(LookupError):
    """No package that is installed brings an answer type of this name."""


class Judging(Protocol):
    """What `judging.py` of an answer type holds. `judge` is handed what its `reading` made of an answer that could be read."""

    def judge(self, answer: Answer, expected: Expected) -> Verdict: ...

    def samples(self, truth: Truth, question: Question) -> Sequence[Sample]: ...


def folder(name: str) -> str:
    """The package that holds an answer type: `corollary.answers.value`. Raises UnknownAnswerType."""
    found = f"{GROUP}.{name}" if name in BUILT_IN else _brought().get(name)
    if found is None:
        raise UnknownAnswerType(f"there is no answer type {name}; there are {', '.join(known())}")
    return found


def known() -> tuple[str, ...]:
    """The names of all answer types."""
    return (*BUILT_IN, *sorted(_brought()))


@cache
def answer_type(name: str) -> AnswerType:
    """How such an answer is asked for and read. Raises UnknownAnswerType."""
    return _loaded(name, "reading", "TYPE").TYPE


@cache
def judging(name: str) -> Judging:
    """How such an answer is judged; loaded only when something is judged. Raises UnknownAnswerType."""
    return _loaded(name, "judging", "judge")  # type: ignore[return-value]


def _loaded(name: str, module: str, wanted: str) -> Any:
    """A module of an answer type. What is wrong with another package's is said in a sentence that names it."""
    place = f"{folder(name)}.{module}"
    if name in BUILT_IN:
        return import_module(place)
    try:
        found = import_module(place)
    except Exception as error:
        raise UnknownAnswerType(
            f"the answer type {name} is installed, but {place} cannot be loaded: {type(error).__name__}: {error}"
        ) from error
    if wanted not in vars(found):
        raise UnknownAnswerType(f"the answer type {name} is installed, but {place} has no {wanted}")
    return found


@cache
def _brought() -> Mapping[str, str]:
    """Answer types of other packages, each with the folder that its entry point names."""
    from importlib.metadata import entry_points  # slow, and needed only for a name that is not built in

    return {point.name: point.value for point in entry_points(group=GROUP)}
