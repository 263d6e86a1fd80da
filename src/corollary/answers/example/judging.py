"""An example judged by putting its numbers into the laws, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.answer import Answer, Numbers
from corollary.answers.evaluation import as_exact, holds_nearly, number
from corollary.answers.expected import Expected
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.tolerance import within
from corollary.answers.verdict import Right, Unread, Verdict, Wrong
from corollary.formula.ball import Undefined
from corollary.messages import catalogue

_ = catalogue(__name__)

TOLERANCE = 0.01  # of the larger side of a law: two figures are enough for numbers one makes up


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Right when every law holds to one per cent of its larger side, and it is none of the excluded sets."""
    assert isinstance(answer, Numbers)
    wanted = expected.requirement
    assert wanted is not None
    scale = abs(number(wanted.scale, wanted.known))
    try:
        pairs = zip(wanted.names, answer.values, strict=True)
        mine = {**wanted.known, **{name: as_exact(value) for name, value in pairs}}
        for trees, why in wanted.excluded:
            values = tuple(number(tree, wanted.known) for tree in trees)
            if within(answer.values, values, 2 * TOLERANCE, scale):
                return Wrong(_("No: {why}.", why=why))
        broken = [
            law.name.lower()
            for law in wanted.laws
            if not all(holds_nearly(equation, mine, TOLERANCE) for equation in law.equations)
        ]
    except Undefined:
        zeros = [
            f"`{name}`"
            for name, value in zip(expected.question.components, answer.values, strict=False)
            if not value
        ]
        if zeros:
            return Unread(
                _(
                    "With 0 for {names} a law has no value; choose another number.",
                    names=_(" and ").join(zeros),
                )
            )
        return Unread(_("With these numbers a law has no value; choose others."))
    if broken:
        return Wrong(_("Your numbers do not satisfy this law: {laws}.", laws=_(" and ").join(broken)))
    return Right(_("Every law holds for your numbers."))


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` is one good example. What is wrong is not shifted alike, for a law may leave a direction free: (1, 1) and (2, 2)."""
    assert not isinstance(truth, str)
    truth = [question.unit.from_si(value) for value in truth]
    scale = max(map(abs, truth)) or 1.0
    return (
        Sample(list(truth), "right"),
        Sample([value + (0.31 + 0.17 * place) * scale for place, value in enumerate(truth)], "wrong"),
        Sample(list(truth)[:-1], "unread"),
        Sample("any", "unread"),
        Sample([None] * len(truth), "unread"),
    )
