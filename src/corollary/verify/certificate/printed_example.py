"""The printed numbers as an example that fulfils all hypotheses of a lemma, so that it does not speak of nothing."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from corollary.formula.ast import Call, Expr
from corollary.formula.ball import evaluate
from corollary.formula.exact import exactly
from corollary.formula.rational_pi import RationalPi
from corollary.verify.certificate.coq import NotAlgebraic

HALF_ANGLE = (
    10**6
)  # the largest denominator of the tangent of half an angle, whose sine and cosine are rational then
PI = Fraction(314159265358979, 10**14)
TACTIC = "first [ lra | field; lra | nra ]"


def witnesses(
    givens: Mapping[str, RationalPi], roots: Mapping[Expr, str], meant: Mapping[str, Expr]
) -> dict[str, Fraction]:
    """A rational number for each letter: the givens (angles rounded), roots, sines and cosines, and what is found. Raises NotAlgebraic."""
    found = {name: value.ratio * PI**value.pi for name, value in givens.items()}
    angles = dict[Expr, tuple[Fraction, Fraction]]()
    for tree, letter in roots.items():
        if not isinstance(tree, Call):
            raise NotAlgebraic("it has a root of another kind")
        known = {name: RationalPi(value) for name, value in found.items()}
        (inner,) = tree.arguments
        if tree.function == "sqrt":
            exact = exactly(tree, known)
            if exact is None or exact.pi:
                raise NotAlgebraic("a root is irrational at the printed numbers")
            found[letter] = exact.ratio
            continue
        if inner not in angles:
            half = Fraction(math.tan(float(evaluate(inner, known, 64).mid()) / 2)).limit_denominator(
                HALF_ANGLE
            )
            angles[inner] = 2 * half / (1 + half**2), (1 - half**2) / (1 + half**2)
        found[letter] = angles[inner][0 if tree.function == "sin" else 1]
    known = {name: RationalPi(value) for name, value in found.items()}
    for name, tree in meant.items():
        exact = exactly(tree, known)
        if exact is None or exact.pi:
            raise NotAlgebraic("what is found is irrational at the printed numbers")
        found[name] = exact.ratio
    return found
