"""Figures, asked for: a cell that draws one."""

from __future__ import annotations

from typing import final

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType
from corollary.answers.explain import reading as explain
from corollary.answers.question import Question
from corollary.formula.value import Value
from corollary.messages import N_, catalogue

_ = catalogue(__name__)


@final
class PlotType(AnswerType):
    name, word, stated_by = "plot", N_("Figure"), "plot"
    found_in = "figure"

    def blank(self, question: Question) -> str:
        remark = _(
            'Draw here. Name both axes, each with its unit: plt.xlabel("t [s]"), and label the curves when there are several.'
        )
        return f"import matplotlib.pyplot as plt\n\n# {remark}\n\nplt.show()"

    def read(self, value: Value, question: Question) -> Answer:
        """The source of a program that draws, as text."""
        return explain.TYPE.read(value, question)


TYPE = PlotType()
