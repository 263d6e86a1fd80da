"""Keys as plain data and back: enough to judge by in plain Python, where no scene can be run."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from corollary.answers.registry import BUILT_IN
from corollary.derive.serialize import from_data, to_data
from corollary.derive.solution import (
    AppliedLaw,
    Rule,
    SceneOutcome,
    Solution,
    SolvedRoute,
    Unknown,
)
from corollary.derive.statements import Mistake, Route, Statement
from corollary.formula.ball import Undefined
from corollary.grading.expectations import expected_of
from corollary.grading.key import Key, Truth
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.variant import Variant

NOT_JUDGED = {"proof", "code", "plot", "explain"}
"""What takes ideals, a sandbox, or a person."""


def judged(part: Part) -> bool:
    """Whether an answer to the part is judged by such data."""
    return len(part.answer_types) == 1 and part.answer_type in BUILT_IN and part.answer_type not in NOT_JUDGED


def serialized(key: Key) -> dict[str, Any]:
    """The key as JSON can hold it: the derivation without its laws' texts and its programs, and what scenes gave wherever judging
    an answer that rests on no wrong one runs them."""
    solution, problem = _bare(key.solution), key.variant.problem
    bare = replace(key, solution=solution)
    for part in filter(judged, problem.parts):
        quantity = expected_of(bare, part).quantity
        for way in quantity.routes() if quantity else ():
            for several in (way.misconceptions, way.slips):
                with suppress(Undefined):
                    tuple(several() if several else ())
    return {
        "code": problem.code,
        "givens": to_data(problem.givens),
        "parts": to_data(problem.parts),
        "drawn": to_data(key.variant.values),
        "values": to_data(key.values),
        "truths": {
            part: [to_data(getattr(truth, each.name)) for each in fields(truth)]
            for part, truth in key.truths.items()
        },
        "choices": dict(key.choices),
        "solution": {
            name: to_data(getattr(solution, name))
            for name in ("unknowns", "choices", "examples", "paths", "forces")
        },
    }


def key_of(data: Mapping[str, Any]) -> Key:
    """The key that `serialized` wrote, with every part."""
    givens, parts = from_data(data["givens"]), from_data(data["parts"])
    problem = Problem(data["code"], "", "", "", "", "", givens, (), parts, "", "", Path(), 0)
    content = {name: from_data(each) for name, each in data["solution"].items()}
    solution = Solution(problem=problem, proofs={}, entries=(), **content)
    truths = {part: Truth(*map(from_data, each)) for part, each in data["truths"].items()}
    variant = Variant(problem, from_data(data["drawn"]), None)
    return Key(solution, variant, from_data(data["values"]), truths, data["choices"])


def _bare(solution: Solution) -> Solution:
    return replace(
        solution,
        unknowns=tuple(map(_unknown, solution.unknowns)),
        choices={
            part: replace(each, statement=_statement(part), options={})
            for part, each in solution.choices.items()
        },
        examples={
            part: replace(each, statement=_statement(part), laws=tuple(map(_law, each.laws)))
            for part, each in solution.examples.items()
        },
        forces={
            part: replace(each, statement=_statement(part), balances=())
            for part, each in solution.forces.items()
        },
        proofs={},
        entries=(),
        neglected=(),
    )


def _unknown(find: Unknown) -> Unknown:
    """Of an unknown only what is named here: a field that is added later stays out."""
    return Unknown(
        statement=_statement(find.part),
        names=find.names,
        laws=(),
        local=_recording(find.local),
        in_givens=find.in_givens,
        routes=tuple(SolvedRoute(Route("", (), 0), _recording(each.rule)) for each in find.routes),
        mistakes=tuple(Mistake(each.text, _recording(each.rule), 0) for each in find.mistakes),
        rejected=(),
        dimensions=find.dimensions,
        scale=find.scale,
        note=None,
    )


def _statement(part: str) -> Statement:
    return Statement(part, "", 0)


def _law(law: AppliedLaw) -> AppliedLaw:
    return AppliedLaw(law.name, "", "", law.textbook, law.vectors, law.here)


def _recording(rule: Rule) -> Rule:
    return replace(rule, runs={}, bank="") if isinstance(rule, SceneOutcome) else rule
