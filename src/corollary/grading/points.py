"""Verdicts turned into points by the problem set's scheme."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import assert_never

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong, word
from corollary.grading.advice import advice_for
from corollary.grading.feedback import revealed
from corollary.grading.key import Key
from corollary.grading.part_grades import Grade, PartGrade
from corollary.grading.verdict_text import sentence
from corollary.problem.problem_set import Scheme

USUAL = Scheme()
NOTHING = "nothing"


def share(verdict: Verdict, scheme: Scheme, answer_type: str = "value") -> float:
    """What part of the points a verdict on an answer of this type earns; of a table, the mean of its entries'."""
    return _share(basis(verdict), scheme, answer_type)


def basis(verdict: Verdict) -> str:
    """What a verdict's share goes by, in a word that a record keeps; of a table one for each entry, joined by `+`."""
    match verdict:
        case Follows(entries=entries) | Mistaken(entries=entries) | Wrong(entries=entries) if (
            entries and not _for_nothing(verdict)
        ):
            return "+".join(map(basis, entries))
        case Right():
            return "right"
        case Follows() | Slip() | Mistaken():
            return NOTHING if verdict.nothing else word(verdict)
        case Wrong() | Unread() | Unmarked():
            return NOTHING
        case _:
            assert_never(verdict)


def _share(basis: str, scheme: Scheme, answer_type: str) -> float:
    shares = {
        "right": 1.0,
        "follows": scheme.follows,
        "slip": scheme.slip,
        "mistaken": scheme.choice if _by_choosing(answer_type) else scheme.mistaken,
        NOTHING: 0.0,
    }
    entries = basis.split("+")
    return sum(shares[each] for each in entries) / len(entries)


def with_points(part: PartGrade, scheme: Scheme, weight: float) -> PartGrade:
    """The same verdict, with the points that it earns by this scheme."""
    names = part.basis or (basis(part.verdict),)
    out_of = part.part.points * weight
    earned = sum(
        _share(each, scheme, name) for name, each in zip(part.part.answer_types, names, strict=False)
    )
    return replace(part, points=round(out_of * earned / len(names), 6), out_of=out_of)


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
    wrong_before: int | None = None,
) -> Grade:
    """Points and feedback for each part. Of two answer types each is worth half; the verdict reported is the first that is not right.

    `wrong_before`: how many wrong answers came before, to whom may try again; each is told something else.
    """
    parts: list[PartGrade] = []
    for part in key.variant.problem.parts:
        verdicts, answer = judged[part.id]
        decisive = next((verdict for verdict in verdicts if not isinstance(verdict, Right)), verdicts[0])
        feedback = _feedback(part.answer_types, verdicts)
        if (
            isinstance(decisive, Wrong)
            and len(verdicts) == 1
            and (thought := advice_for(key, part, wrong_before))
        ):
            feedback = f"{feedback} {thought}" if decisive.why else thought
        if reveal and not isinstance(decisive, Right) and (solution := revealed(key, part, answer)):
            feedback = f"{feedback} {solution}"
        names = tuple(map(basis, verdicts))
        judged_part = PartGrade(
            part, decisive, 0.0, 0.0, answer, feedback, () if _is_usual(decisive, names) else names
        )
        parts.append(with_points(judged_part, scheme, weight))
    return Grade(key.variant, tuple(parts))


def _is_usual(verdict: Verdict, names: tuple[str, ...]) -> bool:
    """Whether the verdict's own word says as much."""
    named = word(verdict)
    return names == (named if named in {"right", "follows", "slip", "mistaken"} else NOTHING,)


def _feedback(answer_types: tuple[str, ...], verdicts: tuple[Verdict, ...]) -> str:
    if len(verdicts) == 1:
        return sentence(verdicts[0])
    return " ".join(
        f"{answer_type(name).word}: {sentence(verdict)}"
        for name, verdict in zip(answer_types, verdicts, strict=True)
    )
