"""Keys as plain data and back: enough to judge by in plain Python, where no scene can be run."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import astuple, replace
from pathlib import Path
from typing import Any

from corollary.answers.registry import BUILT_IN
from corollary.derive.serialize import View, from_data, to_data
from corollary.derive.solution import (
    AppliedLaw,
    Rule,
    SceneOutcome,
    Solution,
    SolvedRoute,
    Unknown,
)
from corollary.derive.statements import Choice, Forces, Mistake, Route, Statement
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


JUDGED_BY: View = {
    Unknown: {
        "statement",
        "names",
        "local",
        "in_givens",
        "routes",
        "mistakes",
        "dimensions",
        "scale",
        "numbering",
    },
    Statement: {"part"},
    SolvedRoute: {"stated", "rule"},
    Route: set(),
    Mistake: {"text", "rule"},
    Choice: {"statement", "mistakes"},
    Forces: {"statement", "forces", "mistakes", "slope"},
    AppliedLaw: {"name", "textbook", "vectors", "here"},
    SceneOutcome: {"scene", "settings", "observe", "runs"},
}
"""What of a derivation judging takes: no reasons, no sources, no path, and nothing that is added later."""


def serialized(key: Key) -> dict[str, Any]:
    """The key as JSON can hold it: the derivation without its laws' texts and its programs, and what scenes gave wherever judging
    an answer that rests on no wrong one runs them."""
    problem = key.variant.problem
    solution = replace(key.solution, unknowns=tuple(map(_recording, key.solution.unknowns)))
    for part in filter(judged, problem.parts):
        quantity = expected_of(replace(key, solution=solution), part).quantity
        for way in quantity.routes() if quantity else ():
            for several in (way.misconceptions, way.slips):
                with suppress(Undefined):
                    tuple(several() if several else ())
    return {
        "code": problem.code,
        "givens": to_data(problem.givens),
        "variables": to_data(problem.variables),
        "parts": to_data(problem.parts),
        "drawn": to_data(key.variant.values),
        "index": key.variant.index,
        "values": to_data(key.values),
        "truths": {part: to_data(astuple(truth)) for part, truth in key.truths.items()},
        "choices": dict(key.choices),
        "solution": {
            name: to_data(getattr(solution, name), JUDGED_BY)
            for name in ("unknowns", "choices", "examples", "paths", "forces")
        },
    }


def key_of(data: Mapping[str, Any]) -> Key:
    """The key that `serialized` wrote, with every part."""
    givens, parts = from_data(data["givens"]), from_data(data["parts"])
    problem = Problem(
        data["code"], "", "", "", "", "", givens, (), parts, "", "", Path(), 0,
        variables=tuple(from_data(data["variables"])),
    )  # fmt: skip
    content = {name: from_data(each) for name, each in data["solution"].items()}
    solution = Solution(problem=problem, proofs={}, entries=(), **content)
    truths = {part: Truth(*from_data(each)) for part, each in data["truths"].items()}
    variant = Variant(problem, from_data(data["drawn"]), data["index"])
    return Key(solution, variant, from_data(data["values"]), truths, data["choices"])


def _recording(find: Unknown) -> Unknown:
    """With rules that keep what their scenes give."""

    def keeping(rule: Rule) -> Rule:
        return replace(rule, runs={}) if isinstance(rule, SceneOutcome) else rule

    routes = tuple(replace(each, rule=keeping(each.rule)) for each in find.routes)
    mistakes = tuple(Mistake(each.text, keeping(each.rule), each.line) for each in find.mistakes)
    return replace(find, local=keeping(find.local), routes=routes, mistakes=mistakes)
