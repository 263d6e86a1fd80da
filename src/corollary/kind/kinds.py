"""Every kind by its name."""

from __future__ import annotations

from corollary.kind.choice import ChoiceType
from corollary.kind.example import ExampleType
from corollary.kind.expression import ExpressionType
from corollary.kind.kind import AnswerType
from corollary.kind.proof import ProofType
from corollary.kind.prose import TextType
from corollary.kind.value import ValueType
from corollary.kind.vector import VectorType
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
