"""The key as data, as `corollary key --json` shows it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from corollary.derive.statements import Code, Explain, Plot
from corollary.formula.text import text
from corollary.grading.from_json import finite
from corollary.grading.key import Key
from corollary.problem.part import Part
from corollary.units.unit import canonical, si_unit

T = TypeVar("T")


def key_record(key: Key) -> dict[str, Any]:
    """Every part of a variant: values in SI with their formulas, or what its answer type has."""
    problem = key.variant.problem
    return {
        "code": problem.code,
        "given": {name: finite(value) for name, value in key.variant.si.items()},
        "parts": {part.id: part_key(key, part) for part in problem.parts},
    }


def part_key(key: Key, part: Part) -> dict[str, Any]:
    """One part."""
    solution = key.solution
    if part.id in key.truths:
        truth = key.truths[part.id]
        entry: dict[str, Any] = {"value": _one(truth.values, finite, part), "unit": si_name(part)}
        if (in_givens := key.find(truth).in_givens) is not None:
            entry["expression"] = _one(in_givens, text, part)
            return entry | {"certified": truth.proven}
        return entry | {"certified": False, "error": truth.error}
    if part.id in key.choices:
        return {"choice": key.choices[part.id]}
    if part.id in solution.examples:
        example = solution.examples[part.id]
        return {
            "unit": si_name(part),
            "laws": [f"{law.name}: {text(law.textbook)}" for law in example.laws],
            "free": example.free,
        }
    if part.id in solution.proofs:
        proof = solution.proofs[part.id]
        return {
            "laws": [text(relation) for law in proof.laws for relation in law.here],
            "target": text(proof.target.here[0]),
        }
    entry = {}
    for each in solution.entries:
        match each:
            case Code() if each.statement.part == part.id:
                entry |= {"function": part.signature, "example": each.example.strip()}
            case Plot() if each.statement.part == part.id:
                entry |= {"plot": each.statement.because}
            case Explain() if each.statement.part == part.id:
                entry |= {"rubric": list(each.rubric), "answer": each.answer}
            case _:
                continue
    return entry


def si_name(part: Part) -> str:
    """The SI unit in which a value is given: `rad` for an angle."""
    if part.unit.text in {"deg", "rad"}:
        return "rad"
    return (
        canonical(si_unit(part.unit.dimension))
        if part.unit.factor != 1 or part.unit.pi
        else canonical(part.unit)
    )


def _one(values: Sequence[T], show: Callable[[T], object], part: Part) -> object:
    """A list for what has components, else the one."""
    return [show(value) for value in values] if part.components else show(values[0])
