"""Verdicts turned into points by the problem set's scheme."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.grading.advice import advice
from corollary.grading.feedback import revealed
from corollary.grading.grade import Grade, PartGrade
from corollary.grading.key import Key
from corollary.grading.verdict_text import sentence
from corollary.problem.problem_set import Scheme

USUAL = Scheme()


def share(verdict: Verdict, scheme: Scheme, answer_type: str = "value") -> float:
    """What part of the points a verdict on an answer of this type earns; of a table, the mean of its entries'."""
    match verdict:
        case Follows(entries=entries) | Mistaken(entries=entries) | Wrong(entries=entries) if (
            entries and not _for_nothing(verdict)
        ):
            return sum(share(each, scheme, answer_type) for each in entries) / len(entries)
        case Right():
            return 1.0
        case Follows():
            return 0.0 if verdict.nothing else scheme.follows
        case Slip():
            return 0.0 if verdict.nothing else scheme.slip
        case Mistaken():
            return 0.0 if verdict.nothing else scheme.choice if _by_choosing(answer_type) else scheme.mistaken
        case Wrong() | Unread() | Unmarked():
            return 0.0
        case _:
            assert_never(verdict)


def _for_nothing(verdict: Follows | Mistaken | Wrong) -> bool:
    return not isinstance(verdict, Wrong) and verdict.nothing


def _by_choosing(name: str) -> bool:
    """Whether such an answer is one of a few that the sheet names, so that a guess may meet it."""
    return answer_type(name).stated_by == "choice"


def grade(
    key: Key,
    judged: Mapping[str, tuple[tuple[Verdict, ...], str]],
    scheme: Scheme = USUAL,
    weight: float = 1.0,
    *,
    reveal: bool = False,
) -> Grade:
    """Points and feedback for each part. Of two answer types each is worth half; the verdict reported is the first that is not right."""
    parts: list[PartGrade] = []
    for part in key.variant.problem.parts:
        verdicts, answer = judged[part.id]
        out_of = part.points * weight
        earned = sum(
            share(verdict, scheme, name) for name, verdict in zip(part.answer_types, verdicts, strict=True)
        )
        points = out_of * earned / len(verdicts)
        decisive = next((verdict for verdict in verdicts if not isinstance(verdict, Right)), verdicts[0])
        feedback = _feedback(part.answer_types, verdicts)
        if isinstance(decisive, Wrong) and len(verdicts) == 1 and (thought := advice(key, part)):
            feedback = f"{feedback} {thought}"
        if reveal and not isinstance(decisive, Right) and (solution := revealed(key, part, answer)):
            feedback = f"{feedback} {solution}"
        parts.append(PartGrade(part, decisive, round(points, 6), out_of, answer, feedback))
    return Grade(key.variant, tuple(parts))


def _feedback(answer_types: tuple[str, ...], verdicts: tuple[Verdict, ...]) -> str:
    if len(verdicts) == 1:
        return sentence(verdicts[0])
    return " ".join(
        f"{answer_type(name).word}: {sentence(verdict)}"
        for name, verdict in zip(answer_types, verdicts, strict=True)
    )
