"""The forces on a body judged one by one: those that are missing, those that do not act, and those in another direction."""

from __future__ import annotations

import math
from collections import Counter

from corollary.answers.answer import Answer, DirectedForce, NamedForces, Numbers
from corollary.answers.evaluation import number
from corollary.answers.expected import Expected, FreeBody
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.spellings import main_spelling
from corollary.answers.verdict import Mistaken, Right, Verdict, Wrong
from corollary.answers.ways import DEGREES, of_a_slope
from corollary.formula.ball import Undefined
from corollary.messages import catalogue

_ = catalogue(__name__)

NEAR = math.radians(2)  # an angle read off a drawing


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Right when exactly the forces that act are named, each in its direction; else what is wrong with which."""
    assert isinstance(answer, NamedForces)
    body = expected.free_body
    assert body is not None
    words = dict(zip(expected.question.options, expected.question.option_texts, strict=True))
    names = {letter: main_spelling(text) for letter, text in words.items()}
    given = Counter(each.letter for each in answer.pulls)
    acting = Counter(letter for letter, _angle in body.forces)
    extra, missing = list((given - acting).elements()), list((acting - given).elements())
    turned = sorted({each.letter for each in answer.pulls if each.letter in acting and not _fits(each, body)})
    if not (extra or missing or turned):
        return Right()
    if len(extra) == 1 and not missing and not turned and (why := body.misconceptions.get(extra[0])):
        return Mistaken(why)
    sentences = [
        body.misconceptions.get(letter) or _extra(names[letter], letter in acting) for letter in extra
    ]
    if missing:
        sentences.append(_("Not named: {names}.", names=", ".join(names[letter] for letter in missing)))
    if turned:
        sentences.append(
            _("Look at the direction again: {names}.", names=", ".join(names[letter] for letter in turned))
        )
    return Wrong(" ".join(sentences))


def _extra(name: str, twice: bool) -> str:
    if twice:
        return _("You name this force too often: {name}.", name=name)
    return _("This force does not act on the body: {name}.", name=name)


def _fits(pull: DirectedForce, body: FreeBody) -> bool:
    """Whether a force of this name acts in this direction."""
    angle = _angle(pull, body)
    return angle is not None and any(
        abs(math.remainder(angle - other, math.tau)) <= NEAR
        for letter, other in body.forces
        if letter == pull.letter
    )


def _angle(pull: DirectedForce, body: FreeBody) -> float | None:
    """Counter-clockwise from the right, in rad; None where a formula has no value."""
    match pull.angle:
        case None:
            slope = (body.slope or 0.0) if of_a_slope(pull.way) else 0.0
            return math.radians(DEGREES[pull.way]) + slope
        case Numbers(values):
            return values[0]
        case formulas:
            try:
                return number(formulas.trees[0], body.givens())
            except Undefined:
                return None


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` is the answer in one text, by angles: as it is, as a list, without one force, with one turned round."""
    assert isinstance(truth, str)
    lines = truth.split("; ")
    name, _colon, angle = lines[0].partition(": ")
    turned = f"{name}: {float(angle.removesuffix(' deg')) + 180:.6g} deg"
    named = {line.partition(": ")[0] for line in lines}
    other = [main_spelling(text) for text in question.option_texts if main_spelling(text) not in named]
    return (
        Sample(truth, "right"),
        Sample(lines[::-1], "right"),
        *((Sample(lines[1:], "wrong"),) if len(lines) > 1 else ()),
        Sample([turned, *lines[1:]], "wrong"),
        *(Sample([*lines, f"{each}: up"], "wrong") for each in other[:1]),
        Sample(["xyzzy: up"], "unread"),
        Sample([f"{name}: somewhere"], "unread"),
        Sample([], "unread"),
        Sample(None, "unread"),
        Sample(3, "unread"),
    )
