"""A proof judged: no line may be false, the laws must stand among them, and all else must follow from the lines above it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from corollary.answers.answer import Answer, Chain, Equation
from corollary.answers.expected import Claim, Expected, Point
from corollary.answers.proof.argument import Grounds, equal_to, standings, sufficient
from corollary.answers.proof.form import repeats
from corollary.answers.proof.rates import letter_of, with_known_rates
from corollary.answers.proof.steps import defined
from corollary.answers.proof.truth import truths
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Mistaken, Right, Unmarked, Verdict, Wrong
from corollary.formula.ast import names
from corollary.formula.plain_text import text
from corollary.messages import catalogue
from corollary.polynomials.polynomial_signs import Bounds
from corollary.sandbox.limited import NotFinished, limited

_ = catalogue(__name__)

SECONDS = 2.0  # of the processor, for all that is decided on one derivation


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Right where a set of laws that implies the claim stands among the lines and each line, the claim too, follows from those above.

    A line that does not hold is wrong. A line that holds and is not seen to follow is for a person.
    """
    assert isinstance(answer, Chain)
    claim = expected.claim
    assert claim is not None
    steps, points = _with_rates(answer.steps, claim, expected.question), claim.points()
    grounds = grounds_of(claim, points, expected.question)
    held = truths(steps, points)
    if not points:
        return Unmarked(_("This could not be checked, so your teacher will mark it."), _rubric(claim))
    unknown = next((step for step in steps if step.undefined), None)
    if unknown is not None and ("false" not in held or unknown.line <= steps[held.index("false")].line):
        why = _(
            "{letter} in line {line} is not a letter of the problem, and no line defines it, so your teacher will mark this.",
            letter=unknown.undefined,
            line=unknown.line,
        )
        return Unmarked(why, _rubric(claim))
    if "false" in held:
        place = held.index("false")
        if any(repeats(step.relation, claim.target) for step in steps[:place]) and isinstance(
            _on_the_way(steps[:place], held[:place], claim, grounds), Right
        ):  # it had been shown; what is said of it then, for r = 0 perhaps, need not hold for every r
            return _open(steps[place].line, claim)
        return _false(steps, place, claim, grounds, text(answer.steps[place].relation))
    return _on_the_way(steps, held, claim, grounds)


def _with_rates(steps: Sequence[Equation], claim: Claim, question: Question) -> Sequence[Equation]:
    """The steps with what the problem says of derivatives; of one of which it says nothing, a person decides."""
    if not any(letter_of(name) for step in steps for name in names(step.relation)):
        return steps
    rates, known = dict(claim.rates), frozenset({*question.symbol_names, *question.components, "pi"})
    constants = set(question.symbol_names) if rates else set[str]()
    return defined(with_known_rates(steps, rates, constants), known, rates_known=False)


def grounds_of(claim: Claim, points: Sequence[Point], question: Question) -> Grounds:
    """What a derivation of the claim stands on."""
    known: dict[str, Bounds] = {
        name: (Fraction(low), Fraction(high)) for name, (low, high) in claim.domain().items()
    }
    seen: dict[
        str, Bounds
    ] = {}  # a letter of one sign in all that is drawn has it by the physics of the problem
    for name in question.components:
        signs = {(point[name].ratio > 0) - (point[name].ratio < 0) for point in points if name in point}
        if len(signs) == 1 and signs != {0}:
            seen[name] = (Fraction(0), None) if signs == {1} else (None, Fraction(0))
    return Grounds(
        claim.laws,
        claim.given,
        claim.target,
        question.components,
        tuple(sorted(known.items())),
        tuple(sorted(seen.items())),
    )


def _on_the_way(steps: Sequence[Equation], held: Sequence[str], claim: Claim, grounds: Grounds) -> Verdict:
    """The verdict on lines of which none is false."""
    try:
        found = limited(standings, tuple(steps), grounds, seconds=SECONDS)
    except NotFinished:
        return Unmarked(_("This took too long to check, so your teacher will mark it."), _rubric(claim))
    content = [each for each in found if each.kind not in ("definition", "empty")]
    if not content:
        return Wrong(_("These lines are identities: they hold for all values of the quantities."))
    if not any(each.claims for each in found):
        if any(each.kind == "undecided" for each in found):
            return Unmarked(_("This could not be checked, so your teacher will mark it."), _rubric(claim))
        return Wrong(_("Your lines are right, but the claim itself is not yet among them."))
    if all(each.claims for each in content):
        return Wrong(_("This is only the claim; a proof derives it from the laws."))
    reached = next(
        (place for place, each in enumerate(found) if each.claims and each.kind == "follows"), len(found)
    )
    for place, each in enumerate(found[: reached + 1]):
        if held[place] == "otherwise":
            why = _(
                "Line {line} can be read in two ways, and is right if the bracket is in the denominator, so your teacher will decide.",
                line=steps[place].line,
            )
            return Unmarked(why, _rubric(claim))
        if held[place] != "true" or each.kind in ("open", "undecided"):
            return _open(steps[place].line, claim)
    stated = {each.law for each in found[:reached]}
    if reached == len(found) or not any(laws <= stated for laws in sufficient(grounds)):
        return _open(steps[-1].line, claim)
    for place, each in enumerate(found[: reached + 1]):
        if each.divisor is not None:
            why = _(
                "Line {line} divides by {divisor}, which may be zero, and no line treats that case, so your teacher will mark this.",
                line=steps[place].line,
                divisor=text(each.divisor),
            )
            return Unmarked(why, _rubric(claim))
    return Right(_("The laws are given, and every line follows from the lines above it."))


def _open(line: int, claim: Claim) -> Unmarked:
    return Unmarked(
        _(
            "No line is wrong, but the program could not derive line {line} from the lines above it; a "
            "law may be missing. Your teacher will mark it.",
            line=line,
        ),
        _rubric(claim),
    )


def _false(steps: Sequence[Equation], place: int, claim: Claim, grounds: Grounds, relation: str) -> Verdict:
    """Names the line as it was typed, and those that say what the letters of the student's own in it stand for."""
    step = steps[place]
    own = [
        _("{letter} as line {line} defines it", letter=each.defines, line=each.line)
        for each in steps
        if each.defines and each.defines in names(step.relation)
    ]
    try:
        mistake = limited(
            equal_to,
            step,
            tuple(wrong for wrong, _sentence in claim.wrong),
            tuple(steps),
            grounds,
            seconds=SECONDS,
        )
    except NotFinished:
        mistake = -1
    if mistake >= 0:
        return Mistaken(_("Line {line}: {mistake}", line=step.line, mistake=claim.wrong[mistake][1]))
    if own:
        return Wrong(
            _(
                "Line {line} does not hold, with {own}: {relation}.",
                line=step.line,
                own=", ".join(own),
                relation=relation,
            )
        )
    return Wrong(_("Line {line} does not hold: {relation}.", line=step.line, relation=relation))


def _rubric(claim: Claim) -> tuple[str, ...]:
    """What the person looks for."""
    return (
        *(_("states or uses correctly: {law}", law=text(law)) for law in claim.laws),
        _("arrives at {target} without a gap", target=text(claim.target)),
    )


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` holds a right chain, one equation a line."""
    assert isinstance(truth, str)
    lines = truth.splitlines()
    return (
        Sample(lines, "right"),
        Sample(["1 = 1", lines[-1]], "wrong"),
        Sample([*lines[:-1], "0 = 1"], "wrong"),
        Sample(["so it is"], "unread"),
        Sample(4, "unread"),
        Sample(None, "unread"),
    )
