"""An answer put into other letters: a given has been called otherwise since its sheet was handed out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import cast

from corollary.answers.answer import Answer, Chain, Entries, Equation, Formulas, Unclear
from corollary.formula.ast import Name, substitute


def in_letters(answer: Answer, meant: Mapping[str, str]) -> Answer:
    """The answer with each letter replaced by what is `meant`; how it was read stays in the letters it was written in."""
    match answer:
        case Formulas():
            return _formulas(answer, meant)
        case Unclear(readings=readings):
            found = tuple(_formulas(each, meant) if isinstance(each, Formulas) else each for each in readings)
            return replace(answer, readings=found)
        case Entries(entries):
            renamed = tuple(in_letters(each, meant) for each in entries)
            return replace(answer, entries=cast("tuple[Formulas, ...]", renamed))
        case Chain(steps):
            # A letter of the student's own may be what a given is called now: it is another one.
            own = {step.defines for step in steps if step.defines in set(meant.values()) - meant.keys()}
            meant = {**meant, **{letter: f"{letter}_own" for letter in own}}
            return replace(answer, steps=tuple(_step(step, meant) for step in steps))
        case _:
            return answer


def _formulas(answer: Formulas, meant: Mapping[str, str]) -> Formulas:
    letters = _as_names(meant)
    return replace(answer, trees=tuple(substitute(tree, letters) for tree in answer.trees))


def _step(step: Equation, meant: Mapping[str, str]) -> Equation:
    letters = _as_names(meant)
    return replace(
        step,
        relation=substitute(step.relation, letters),
        defines=meant.get(step.defines, step.defines),
        otherwise=None if step.otherwise is None else substitute(step.otherwise, letters),
    )


def _as_names(meant: Mapping[str, str]) -> dict[str, Name]:
    return {letter: Name(other) for letter, other in meant.items()}
