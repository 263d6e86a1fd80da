"""The key as data, as `corollary key --json` shows it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, TypeVar

from corollary.answers.evaluation import BITS
from corollary.answers.option_names import option_named
from corollary.answers.registry import answer_type
from corollary.derive.numbered_list import solution_for
from corollary.derive.solution import Solution, Unknown
from corollary.derive.statements import Code, Explain, Plot
from corollary.formula.arithmetics import exactly
from corollary.formula.ast import Expr
from corollary.formula.ball import Undefined, evaluate
from corollary.formula.plain_text import text
from corollary.grading.forces_on_body import as_answered, free_body
from corollary.grading.from_json import finite
from corollary.grading.key import answers, option_that_holds
from corollary.grading.replay import Answered
from corollary.problem.part import Part
from corollary.problem.variant import Variant
from corollary.units.unit import canonical, si_unit

T = TypeVar("T")
FIGURES = 17  # of a decimal beyond the doubles: as many as a double needs
LONGEST = 400  # characters of an exact rational that is still worth reading


def key_record(solution: Solution, variant: Variant) -> dict[str, Any]:
    """Every part of a variant: values in SI with their formulas, or what its answer type has.

    A part without a value for these numbers says why, and the others keep theirs.
    """
    problem = variant.problem
    try:
        solution = solution_for(solution, variant.exact)
    except Undefined as why:
        parts = {part.id: {"why": f"no value for these numbers: {why}"} for part in problem.parts}
    else:
        found = _answers(solution, variant)
        parts = {part.id: _part(solution, variant, part, found) for part in problem.parts}
    return {
        "code": problem.code,
        "given": {name: finite(value) for name, value in variant.si.items()},
        "parts": parts,
    }


def _answers(solution: Solution, variant: Variant) -> dict[str, dict[str, Any]]:
    """What is found for each part that asks for a quantity."""
    entries: dict[str, dict[str, Any]] = {}
    for find, stated in zip(solution.unknowns, answers(solution, variant), strict=True):
        if find.part:
            try:
                entries[find.part] = _quantity(find, variant, stated)
            except Undefined as why:
                entries[find.part] = {"why": f"no value for these numbers: {why}"}
    return entries


def _quantity(find: Unknown, variant: Variant, stated: Answered) -> dict[str, Any]:
    if stated.why:
        return {"why": stated.why}
    part, numbers = variant.problem.part(find.part), stated.values
    if part.of and find.in_givens is not None:
        domain = {
            each.symbol: list(each.ends) for each in variant.problem.variables if each.symbol in part.of
        }
        return {"unit": si_name(part), "expression": _one(find.in_givens, text, part), "domain": domain}
    entry: dict[str, Any] = {"value": _one(numbers, finite, part), "unit": si_name(part)}
    if part.column_units:
        entry["units"] = [si_name(replace(part, unit=each)) for each in part.units]
    if find.in_givens is None:
        # Absolute, in SI: the largest of the components.
        proven = {"bound": True} if stated.bound else {}
        return entry | {"certified": False, "error": finite(max(stated.errors))} | proven
    entry["expression"] = _one(find.in_givens, text, part)
    if not all(map(math.isfinite, numbers)):
        decimals = [decimal(tree, variant) for tree in find.in_givens]
        return entry | {"certified": False, "decimal": _one(decimals, str, part)}
    rationals = [_rational(tree, variant) for tree in find.in_givens]
    if all(rationals):
        entry["exact"] = _one(rationals, str, part)
    return entry | {"certified": stated.certified}


def decimal(tree: Expr, variant: Variant) -> str:
    """A value that doubles cannot hold, in SI, rounded: `1.0000000000000000e+400`. Raises Undefined."""
    return evaluate(tree, variant.exact, BITS).str(FIGURES, radius=False)


def _rational(tree: Expr, variant: Variant) -> str:
    """The value as a fraction, `43/5`; nothing where it is none, or too long to be of use."""
    value = exactly(tree, variant.exact)
    if value is None or (value.pi and value.ratio):
        return ""
    written = str(value.ratio) if abs(value.ratio.numerator).bit_length() < 4 * LONGEST else ""
    return written if len(written) <= LONGEST else ""


def _part(
    solution: Solution, variant: Variant, part: Part, found: dict[str, dict[str, Any]]
) -> dict[str, Any]:
    if part.id in found:
        return found[part.id]
    if part.id in solution.choices:
        try:
            letter = option_that_holds(solution.choices[part.id].options, variant.exact, part.id)
        except Undefined as why:
            return {"why": f"no option for these numbers: {why}"}
        lettered = answer_type(part.answer_type).shows_letters
        return {"choice": letter} | ({} if lettered else {"word": option_named(part, letter)})
    if part.id in solution.examples:
        example = solution.examples[part.id]
        return {
            "unit": si_name(part),
            "laws": [f"{law.name}: {text(law.textbook)}" for law in example.laws],
            "free": example.free,
        }
    if part.id in solution.forces:
        return _forces(solution, variant, part)
    if part.id in solution.proofs:
        proof = solution.proofs[part.id]
        return {
            "laws": [text(relation) for law in proof.laws for relation in law.here],
            "target": text(proof.target.here[0]),
        }
    entry: dict[str, Any] = {}
    for each in solution.entries:
        match each:
            case Code() if each.statement.part == part.id:
                entry |= {"function": part.signature, "example": each.example_for(variant.si)}
            case Plot() if each.statement.part == part.id:
                entry |= {"plot": each.statement.because}
            case Explain() if each.statement.part == part.id:
                entry |= {"rubric": list(each.rubric), "answer": each.answer}
            case _:
                continue
    return entry


def _forces(solution: Solution, variant: Variant, part: Part) -> dict[str, Any]:
    """Each force with its direction, in degrees from the right, and the laws in which it stands."""
    try:
        body = free_body(solution.forces[part.id], variant)
    except Undefined as why:
        return {"why": f"no forces for these numbers: {why}"}
    return {
        "forces": dict(each.split(": ") for each in as_answered(body, part).split("; ")),
        "laws": [text(relation) for each in solution.forces[part.id].balances for relation in each.law.here],
    }


def si_name(part: Part) -> str:
    """The SI unit in which a value is given: `rad` for an angle."""
    if part.unit.is_difference:
        return "K"
    if part.unit.text in {"deg", "rad"}:
        return "rad"
    return canonical(si_unit(part.unit.dimension)) if not part.unit.bare else canonical(part.unit)


def _one(values: Sequence[T], show: Callable[[T], object], part: Part) -> object:
    """A list for what has components, else the one."""
    return (
        [show(value) for value in values]
        if part.components or part.answer_type == "list"
        else show(values[0])
    )
