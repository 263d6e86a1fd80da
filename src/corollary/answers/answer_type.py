"""The interface of an answer type: what is expected, the blank cell, reading an answer, and the sentence on how it was read."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar, Literal

from corollary.answers.answer import Answer
from corollary.answers.preview import Preview, preview_of
from corollary.answers.question import Question
from corollary.formula.value import Value

FoundIn = Literal["variable", "function", "figure", "cell"]


class AnswerType(ABC):
    """One way to answer. Its folder holds `reading.py`, with the one instance `TYPE`, and `judging.py`.

    `word` is what people call such an answer. `found_in` tells where it stands in a notebook: the value of a variable, a
    function, the figures that a cell draws, or the text of a cell. `stated_by` is the author's word that answers such a
    part. `accepts` and `needs` are the attributes of a part's heading beside unit and points: `components`, `options`,
    `function`, `rows`. `lists_components`: the components are the members of a list (in a proof they are further symbols).
    `in_symbols`: the answer must be a formula, numbers will not do; `formulas_too`: numbers are asked for, and a formula will do.
    `in_lines`: it is written in lines, as many as it takes.
    `shows_letters`: options stand below the question with their letters; else its heading names them.
    """

    name: ClassVar[str]
    word: ClassVar[str]
    found_in: ClassVar[FoundIn] = "variable"
    stated_by: ClassVar[str] = "step"
    accepts: ClassVar[frozenset[str]] = frozenset()
    needs: ClassVar[frozenset[str]] = frozenset()
    lists_components: ClassVar[bool] = True
    in_symbols: ClassVar[bool] = False
    formulas_too: ClassVar[bool] = False
    in_lines: ClassVar[bool] = False
    shows_letters: ClassVar[bool] = True

    def heading(self, question: Question) -> str:
        """What kind of answer is expected, beside the question; "" where the cell says it better."""
        return ""

    def instructions(self, question: Question) -> str:
        """What has to be known to write the answer, below the question."""
        return ""

    @abstractmethod
    def blank(self, question: Question) -> str:
        """The source of the answer cell before anything is written."""

    @abstractmethod
    def read(self, value: Value, question: Question) -> Answer:
        """What the student's value says. Never raises, whatever it is."""

    def preview(self, value: Value, question: Question) -> Preview:
        """What `check` says of a value: how it is read, never whether it is right."""
        return preview_of(self.read(value, question))

    def preview_function(self, function: object, question: Question) -> Preview:
        """What `check` says of the function that stands under the question's name; it is not called."""
        raise NotImplementedError(f"a {self.name} answer is found in a {self.found_in}")
