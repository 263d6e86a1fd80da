"""Every answer type by its name: those of this package, and what other packages bring under `corollary.answers`."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Protocol

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Verdict
from corollary.plug_ins import fault, load, plug_ins

if TYPE_CHECKING:  # what is expected is made of certified numbers, which reading an answer does not need
    from corollary.answers.expected import Expected

GROUP = "corollary.answers"
BUILT_IN = (
    "value", "integer", "vector", "interval", "list", "table", "expression", "choice", "word", "forces", "example", "code", "plot", "explain", "proof"
)  # fmt: skip


class UnknownAnswerType(LookupError):
    """No package that is installed brings an answer type of this name."""


class Judging(Protocol):
    """What `judging.py` of an answer type holds. `judge` is handed what its `reading` made of an answer that could be read."""

    def judge(self, answer: Answer, expected: Expected) -> Verdict: ...

    def samples(self, truth: Truth, question: Question) -> Sequence[Sample]: ...


def folder(name: str) -> str:
    """The package that holds an answer type: `corollary.answers.value`. Raises UnknownAnswerType."""
    if name in BUILT_IN:
        return f"{GROUP}.{name}"
    if (entry := plug_ins(GROUP, BUILT_IN).get(name)) is None:
        raise _unknown(name)
    return entry.value


def known() -> tuple[str, ...]:
    """The names of all answer types."""
    return (*BUILT_IN, *sorted(plug_ins(GROUP, BUILT_IN)))


@cache
def answer_type(name: str) -> AnswerType:
    """How such an answer is asked for and read. Raises UnknownAnswerType."""
    return _loaded(name, "reading", "TYPE").TYPE


@cache
def judging(name: str) -> Judging:
    """How such an answer is judged; loaded only when something is judged. Raises UnknownAnswerType."""
    return _loaded(name, "judging", "judge")  # type: ignore[return-value]


def _loaded(name: str, module: str, wanted: str) -> Any:
    """A module of an answer type. Raises PlugInFault for another package's that cannot be used."""
    if name in BUILT_IN:
        return import_module(f"{folder(name)}.{module}")
    if (entry := plug_ins(GROUP, BUILT_IN).get(name)) is None:
        raise _unknown(name)
    found = load(entry, "the answer type", module)
    if wanted not in vars(found):
        raise fault(entry, "the answer type", f"its {module}.py has no {wanted}")
    return found


def _unknown(name: str) -> UnknownAnswerType:
    return UnknownAnswerType(f"there is no answer type {name}; choose one of {', '.join(known())}")
