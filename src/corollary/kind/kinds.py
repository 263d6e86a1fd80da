"""Every kind by its name."""

from __future__ import annotations

from corollary.kind.choice import Choice
from corollary.kind.example import Example
from corollary.kind.expression import Expression
from corollary.kind.kind import Kind
from corollary.kind.proof import Proof
from corollary.kind.prose import Written
from corollary.kind.value import Value
from corollary.kind.vector import Vector
from corollary.problem.part import KindName

KINDS: dict[KindName, Kind] = {
    "value": Value(),
    "vector": Vector(),
    "expression": Expression(),
    "choice": Choice(),
    "example": Example(),
    "proof": Proof(),
    "explain": Written(),
    "code": Written(),
    "plot": Written(),
}
