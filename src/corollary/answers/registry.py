"""Every kind by its name."""

from __future__ import annotations

from corollary.answers.answer_type import AnswerType
from corollary.answers.choice import ChoiceType
from corollary.answers.example import ExampleType
from corollary.answers.expression import ExpressionType
from corollary.answers.proof import ProofType
from corollary.answers.prose import TextType
from corollary.answers.value import ValueType
from corollary.answers.vector import VectorType
from corollary.problem.part import KindName

KINDS: dict[KindName, AnswerType] = {
    "value": ValueType(),
    "vector": VectorType(),
    "expression": ExpressionType(),
    "choice": ChoiceType(),
    "example": ExampleType(),
    "proof": ProofType(),
    "explain": TextType(),
    "code": TextType(),
    "plot": TextType(),
}
