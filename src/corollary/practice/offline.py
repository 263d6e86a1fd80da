"""Answers read and judged by a key of plain data, by the modules that mark, in plain Python in a browser."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from corollary.answers.preview import Preview
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Right, Unmarked, Unread, Verdict
from corollary.derive.solution import SceneOutcome
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.plain_key import judged, key_of
from corollary.grading.replay import ancestors
from corollary.messages import catalogue

_ = catalogue(__name__)

Answer = str | Sequence[str]


@dataclass(frozen=True)
class Offline:
    """An exercise that came as `data`, which `grading.plain_key.serialized` made."""

    data: Mapping[str, object]

    @cached_property
    def key(self) -> Key:
        """With every part, judged here or not."""
        return key_of(self.data)

    @cached_property
    def _judged(self) -> Key:
        problem = self.key.variant.problem
        some = replace(problem, parts=tuple(filter(judged, problem.parts)))
        return replace(self.key, variant=replace(self.key.variant, problem=some))

    def preview(self, name: str, answer: Answer) -> Preview:
        """How an answer is read, never whether it is right."""
        problem = self.key.variant.problem
        part = problem.part(name)
        return answer_type(part.answer_type).preview(from_json(answer), question_in(self.key.variant, part))

    def verdict(self, name: str, answers: Mapping[str, Answer]) -> Verdict:
        """On a part that is judged here, with the others' answers to carry on from."""
        key = self._judged
        found = judge(key, {part: from_json(answer) for part, answer in answers.items()})
        (verdict,), _as_read = found[name]
        wrong = [part for part, ((first,), _read) in found.items() if not isinstance(first, Right | Unread)]
        if not isinstance(verdict, Right | Follows | Unread | Unmarked) and _beyond(key, name, wrong):
            return Unmarked(
                _(
                    "With your earlier answers, this part needs a simulation, which this page cannot run: compare"
                    " with the worked solution."
                )
            )
        return verdict


def _beyond(key: Key, name: str, wrong: Sequence[str]) -> bool:
    """Whether a wrong answer goes into a scene on the way to the part, which would have to be run with it."""
    if name not in key.truths:
        return False
    place, unknowns = key.truths[name].place, key.solution.unknowns
    scenes = [
        at for at in (*ancestors(key.solution, place), place) if isinstance(unknowns[at].local, SceneOutcome)
    ]
    held = {key.truths[part].place for part in wrong if part in key.truths and part != name}
    return any(held & ancestors(key.solution, at) for at in scenes)


def known(verdict: Verdict) -> bool:
    """Whether a part counts as answered: right, or right but for an earlier answer."""
    return isinstance(verdict, Right) or (isinstance(verdict, Follows) and not verdict.nothing)
