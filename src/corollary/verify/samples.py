"""Each answer type's own samples judged as they are named, and the claims of proofs shown."""

from __future__ import annotations

from corollary.answers.answer import Equation
from corollary.answers.evaluation import number
from corollary.answers.expected import Claim
from corollary.answers.proof.argument import sufficient
from corollary.answers.proof.judging import grounds_of
from corollary.answers.proof.rates import derivative, with_known_rates
from corollary.answers.proof.truth import truths
from corollary.answers.question import Question
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type, judging
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import described, word
from corollary.formula.ast import Relation
from corollary.formula.plain_text import text
from corollary.grading.expectations import expected_of
from corollary.grading.forces_on_body import as_answered, free_body
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, named
from corollary.problem.part import Part
from corollary.verify.checked import Tally

NOT_RIGHT = ("wrong", "slip", "mistaken")


def check_samples(key: Key, tally: Tally) -> None:
    """Right samples are right, unreadable ones unread, and wrong ones neither."""
    for part in key.variant.problem.parts:
        for sample in samples(key, part):
            ((verdict,), _) = judge(key, {part.id: from_json(sample.answer)})[part.id]
            got = word(verdict)
            as_named = got in NOT_RIGHT if sample.verdict == "wrong" else got == sample.verdict
            if not tally.check(as_named, "kind samples"):
                tally.complain(
                    f"{key.variant.problem.path.name}:{part.line}: part {part.id}: "
                    f"the sample {sample.answer!r} should be {sample.verdict} and is {described(verdict)}"
                )


def check_claims(key: Key, tally: Tally) -> None:
    """The laws that a proof names imply what it is to show, and hold at all times by its rates."""
    for part in key.variant.problem.parts:
        expected = expected_of(key, part)
        if expected.claim is None:
            continue
        grounds = grounds_of(expected.claim, expected.claim.points(), expected.question)
        if not tally.check(bool(sufficient(grounds)), "claims shown"):
            tally.complain(
                f"{key.variant.problem.path.name}:{part.line}: part {part.id}: the laws of the proof are not found to imply "
                f"{text(expected.claim.target)}: every derivation would wait for a person; name the law that is missing"
            )
        for law in changing(expected.claim, expected.question):
            tally.complain(
                f"{key.variant.problem.path.name}:{part.line}: part {part.id}: by its rates= the law {text(law)} does not go on to hold; "
                "name the derivative of each letter in it that changes"
            )


def changing(claim: Claim, question: Question) -> list[Relation]:
    """The laws of a proof that its rates contradict: whose sides change otherwise, where all that is in them has a known rate."""
    if not claim.rates:
        return []
    rates = dict(claim.rates)
    found: list[Relation] = []
    for law in (*claim.laws, claim.target):
        moved = [derivative(side) for side in (law.left, law.right)]
        if moved[0] is None or moved[1] is None:
            continue
        step = Equation(Relation("=", moved[0], moved[1]), 0)
        (known,) = with_known_rates((step,), rates, set(question.symbol_names) - set(rates))
        if "false" in truths((known,), claim.points()):
            found.append(law)
    return found


def samples(key: Key, part: Part) -> tuple[Sample, ...]:
    """What the part's answer type makes of its truth; programs and figures have theirs run elsewhere."""
    truth = _truth(key, part)
    question = question_in(key.variant, part)
    return () if truth is None else tuple(judging(part.answer_type).samples(truth, question))


def _truth(key: Key, part: Part) -> Truth | None:
    """What is right, as the part's answer type makes samples of it; None where there is nothing to make them of."""
    if part.id in key.choices:
        return key.choices[part.id]
    if part.id in key.solution.forces:
        return as_answered(free_body(key.solution.forces[part.id], key.variant), part)
    if part.id in key.solution.proofs:
        return "\n".join(key.solution.proofs[part.id].lines)
    if part.id in key.solution.examples:
        known = key.variant.exact | named(key.solution, list(key.values))
        instance = key.solution.examples[part.id].instance
        return None if instance is None else [number(tree, known) for tree in instance]
    if part.id not in key.truths:
        return ""
    if not answer_type(part.answer_type).in_symbols:
        return key.truths[part.id].values
    in_givens = key.find(key.truths[part.id]).in_givens
    return text(in_givens[0]) if in_givens else None
