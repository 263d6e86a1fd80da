"""Functions written by the student: the blank, and whether the function can be called as the question says."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from types import FunctionType
from typing import final

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType
from corollary.answers.explain import reading as explain
from corollary.answers.preview import Preview
from corollary.answers.question import Question
from corollary.formula.value import Value
from corollary.messages import N_, catalogue
from corollary.units.unit import show

_ = catalogue(__name__)


@final
class CodeType(AnswerType):
    name, word, stated_by = "code", N_("Program"), "code"
    found_in = "function"
    accepts = needs = frozenset({"function"})

    def heading(self, question: Question) -> str:
        if "plot" in question.types:
            return _("A function {signature}, and a plot made with it.", signature=question.signature)
        return _("A function {signature}.", signature=question.signature)

    def blank(self, question: Question) -> str:
        unit = show(question.unit)
        returns = "\n\n    " + _("Returns values in {unit}.", unit=unit) + "\n    " if unit else ""
        return f'def {question.signature}:\n    """{question.title}.{returns}"""\n    ...'

    def read(self, value: Value, question: Question) -> Answer:
        """The source of a program, as text."""
        return explain.TYPE.read(value, question)

    def preview_function(self, function: object, question: Question) -> Preview:
        call = question.signature.strip()
        if function is None:
            return Preview(False, _("no function yet; write the function above and run its cell"))
        if not callable(function):
            return Preview(
                False,
                _(
                    "is of the type {type}, not a function; keep the line that begins with def",
                    type=type(function).__name__,
                ),
            )
        if not _takes(function, question.arguments):
            parameters = ", ".join(inspect.signature(function).parameters)
            return Preview(
                False,
                _(
                    "takes ({parameters}), but it will be called with ({arguments})",
                    parameters=parameters,
                    arguments=", ".join(question.arguments),
                ),
            )
        if isinstance(function, FunctionType) and _empty(function):
            return Preview(False, _("{function} is still empty", function=call))
        return Preview(True, _("{function} is there", function=call))


def _takes(function: Callable[..., object], arguments: tuple[str, ...]) -> bool:
    """Whether it can be called with these, by name, as it is when it is marked: in any order, with more that have defaults."""
    try:
        inspect.signature(function).bind(**dict.fromkeys(arguments))
    except TypeError:
        return False
    except ValueError:  # what is written in C tells no signature; it is tried when it is marked
        return True
    return True


def _empty(function: FunctionType) -> bool:
    """Whether the body is still the dots it was handed out with: then it compiles to what dots compile to."""
    words = "    'words'\n" if function.__doc__ else ""
    space: dict[str, FunctionType] = {}
    exec(f"def stub({', '.join(inspect.signature(function).parameters)}):\n{words}    ...", space)
    stub, code, first = space["stub"].__code__, function.__code__, int(bool(words))
    return (code.co_code, code.co_names, code.co_consts[first:]) == (
        stub.co_code,
        stub.co_names,
        stub.co_consts[first:],
    )


TYPE = CodeType()
