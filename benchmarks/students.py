"""Simulated students: honest ones who round, mistaken ones with a listed misconception, and answers that are just anything."""

from __future__ import annotations

import json
import random
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from fractions import Fraction
from itertools import islice
from typing import Any

from corollary.answers.evaluation import number
from corollary.answers.expected import Values
from corollary.answers.tolerance import within
from corollary.answers.verdict import Follows, Mistaken, Right, word
from corollary.derive.solution import ClosedForms, Solution
from corollary.formula.ast import Expr, Number, Power, children, names, rebuilt
from corollary.formula.ball import RationalPi, Undefined
from corollary.formula.value import Items, Text, Value
from corollary.grading.assign import admitted
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.mistakes import visible_mistakes
from corollary.grading.replay import WhatIf, replay
from corollary.problem.part import Part
from corollary.problem.sampling import sample
from corollary.units.unit import canonical

FIXED = (0.01, 0.02, 0.05)
STEPS, OPERATIONS = "each step", "each operation"
SORTS = {
    f"{figures} figures {often}": (figures, often) for often in (STEPS, OPERATIONS) for figures in (3, 4)
}
OTHER_G = {Fraction("9.8"): Fraction("9.81"), Fraction("9.81"): Fraction("9.8")}
DRAWS_EACH = (
    20  # draws looked at for each student wanted, before a problem is given up as giving too few variants
)
Answers = dict[str, tuple[float, ...]]


@dataclass(slots=True)
class Tallies:
    """Answers judged, by sort of student; `fixed` holds what a fixed tolerance would have done with the same on every draw."""

    drawn: int = 0
    dealt: int = 0
    answers: Counter[str] = field(default_factory=Counter)
    rejected: Counter[str] = field(default_factory=Counter)
    fixed_answers: Counter[str] = field(default_factory=Counter)
    fixed_failed: Counter[str] = field(default_factory=Counter)
    mistaken: Counter[str] = field(default_factory=Counter)
    worst: Counter[str] = field(default_factory=Counter)
    dice: list[Any] = field(default_factory=list[Any])  # their state, for going on from here

    def record(self) -> dict[str, Any]:
        """Shares in per cent; `mistakes` counts verdicts on listed mistakes."""
        return {
            "drawn": self.drawn,
            "dealt": self.dealt,
            "redrawn_percent": _percent(self.drawn - self.dealt, self.drawn),
            "honest": {
                sort: {
                    "answers": self.answers[sort],
                    "rejected_percent": _percent(self.rejected[sort], self.answers[sort]),
                    "fixed": self._fixed(sort),
                }
                for sort in SORTS
            },
            "mistakes": {
                "answers": self.answers["mistaken"],
                "accepted_percent": _percent(self.mistaken["accepted"], self.answers["mistaken"]),
                "named_percent": _percent(self.mistaken["named"], self.answers["mistaken"]),
                "fixed": self._fixed("mistaken"),
            },
            "worst": [f"{what}: {count}" for what, count in self.worst.most_common(5)],
        }

    def _fixed(self, sort: str) -> dict[str, float | None]:
        return {
            f"{limit:.0%}": _percent(self.fixed_failed[f"{sort}, {limit:.0%}"], self.fixed_answers[sort])
            for limit in FIXED
        }

    def to_json(self) -> str:
        return json.dumps({each.name: getattr(self, each.name) for each in fields(self)})

    @staticmethod
    def from_json(text: str) -> Tallies:
        kept = json.loads(text)
        return Tallies(
            **{name: Counter(each) if isinstance(each, dict) else each for name, each in kept.items()}
        )

    @staticmethod
    def together(several: Iterable[Tallies]) -> Tallies:
        total = Tallies()
        for each in several:
            total.drawn, total.dealt = total.drawn + each.drawn, total.dealt + each.dealt
            for name in ("answers", "rejected", "fixed_answers", "fixed_failed", "mistaken", "worst"):
                getattr(total, name).update(getattr(each, name))
        return total


def simulate(solution: Solution, students: int) -> Tallies:
    """So many students with variants of their own. Fixed tolerances are tried on all the draws: they pass none over."""
    *_, tallies = simulated(solution, students)
    return tallies


def simulated(solution: Solution, students: int, tallies: Tallies | None = None) -> Iterator[Tallies]:
    """The tallies after each student, those of all at last; from where they stood in `tallies` on."""
    tallies, dice = tallies or Tallies(), random.Random(solution.problem.code)
    if tallies.dice:
        version, state, gauss = tallies.dice
        dice.setstate((version, tuple(state), gauss))
    drawn = sample(solution.problem, DRAWS_EACH * students, salt="students")
    for variant in islice(drawn, tallies.drawn, None):
        if tallies.dealt >= students:
            break
        tallies.drawn += 1
        key, _ = admitted(solution, variant)
        try:
            compared = key or (make_key(solution, variant) if tallies.drawn <= students else None)
        except Undefined:
            compared = None
        if key is not None:
            tallies.dealt += 1
        if compared is not None:
            _honest(compared, tallies, dice, dealt=key is not None)
            _mistaken(compared, tallies, dice, dealt=key is not None)
        tallies.dice = list(dice.getstate())
        yield tallies
    yield tallies


def _honest(key: Key, tallies: Tallies, dice: random.Random, *, dealt: bool) -> None:
    for sort, (figures, often) in SORTS.items():
        givens = _givens(key, dice)
        try:
            found = (
                by_operation(key.solution, givens, figures)
                if often == OPERATIONS
                else _by_step(key, givens, figures)
            )
        except Undefined:
            continue
        answers = _numbers(key, found)
        for part, values in answers.items():
            _fixed(tallies, sort, key, part, values, accepted=False)
        if not dealt:
            continue
        tallies.answers[sort] += len(answers)
        for part, ((verdict,), _) in _judged(key, answers, figures):
            if not isinstance(verdict, (Right, Follows)):
                tallies.rejected[sort] += 1
                if often == STEPS:
                    tallies.worst[
                        f"{key.variant.problem.code} ({part}) honest, {sort}, judged {word(verdict)}"
                    ] += 1


def _mistaken(key: Key, tallies: Tallies, dice: random.Random, *, dealt: bool) -> None:
    """Each listed mistake once, by a student who rounds to three figures; looked at where it shows first."""
    solution = key.solution
    for place, find in enumerate(solution.unknowns):
        for wrong in find.mistakes:
            shown = [each.part for each in visible_mistakes(solution) if each.mistake is wrong]
            if not shown:
                continue
            first = min(shown, key=list(key.truths).index)  # where it shows again it has been paid for
            try:
                found = _by_step(key, _givens(key, dice), 3, {place: wrong.rule})
            except Undefined:
                continue
            answers = _numbers(key, found)
            if first not in answers:
                continue
            _fixed(tallies, "mistaken", key, first, answers[first], accepted=True)
            if not dealt:
                continue
            so_far = {
                part: values
                for part, values in answers.items()
                if key.truths[part].place <= key.truths[first].place
            }
            *_, (_, ((verdict,), _)) = _judged(key, so_far | {first: answers[first]}, 3)
            tallies.answers["mistaken"] += 1
            tallies.mistaken["named"] += isinstance(verdict, Mistaken)
            if isinstance(verdict, (Right, Follows)):
                tallies.mistaken["accepted"] += 1
                tallies.worst[
                    f"{solution.problem.code} ({first}) accepted, {word(verdict)}: {wrong.text[:60]}"
                ] += 1


def _numbers(key: Key, found: Sequence[Values]) -> Answers:
    """The numbers of a student's derivation by part, where a number is asked for."""
    problem = key.variant.problem
    return {
        part: found[truth.place]
        for part, truth in key.truths.items()
        if problem.part(part).answer_type != "expression"
    }


def _fixed(tallies: Tallies, sort: str, key: Key, part: str, values: Values, *, accepted: bool) -> None:
    """What fixed tolerances would have said: counted where they are wrong."""
    truth = key.truths[part]
    if tallies.drawn > 0 and truth.scale:
        tallies.fixed_answers[sort] += 1
        for limit in FIXED:
            tallies.fixed_failed[f"{sort}, {limit:.0%}"] += (
                within(values, truth.values, limit, truth.scale) == accepted
            )


def _givens(key: Key, dice: random.Random) -> Mapping[str, RationalPi]:
    """Three students in ten take the other usual value of g."""
    givens = key.variant.exact
    other = OTHER_G.get(givens["g"].ratio) if "g" in givens else None
    return givens | {"g": RationalPi(other)} if other is not None and dice.random() < 0.3 else givens


def _by_step(key: Key, givens: Mapping[str, RationalPi], figures: int, rules=None) -> list[Values]:
    return replay(key.solution, givens, WhatIf(rules=rules or {}, rounding=rounded(figures)))


def rounded(figures: int) -> Callable[[float], float]:
    """As it is written down with so many significant figures."""
    return lambda x: float(f"{x:.{figures - 1}e}")


def by_operation(solution: Solution, givens: Mapping[str, RationalPi], figures: int) -> list[Values]:
    """The derivation by a student who writes down every intermediate result rounded."""
    short = rounded(figures)
    values, found = dict(givens), []
    for find in solution.unknowns:
        if isinstance(find.local, ClosedForms):
            numbers = tuple(short(number(_worked(tree, values, short), values)) for tree in find.local.trees)
        else:
            numbers = replay(solution, givens, WhatIf(held=dict(enumerate(found))), len(found))[len(found)]
        values |= {name: RationalPi(Fraction(value)) for name, value in zip(find.names, numbers, strict=True)}
        found.append(numbers)
    return found


def _worked(tree: Expr, values: Mapping[str, RationalPi], short: Callable[[float], float]) -> Expr:
    """The formula with everything below its last operation worked out and rounded; what holds no letter is exact."""
    if not names(tree) - {"pi"}:
        return tree
    below = children(tree)
    if not below:
        return tree
    if isinstance(tree, Power):
        return rebuilt(tree, (_rounded(tree.base, values, short), tree.exponent))
    return rebuilt(tree, tuple(_rounded(each, values, short) for each in below))


def _rounded(tree: Expr, values: Mapping[str, RationalPi], short: Callable[[float], float]) -> Expr:
    if not children(tree) or not names(tree) - {"pi"}:
        return tree
    return Number(Fraction(short(number(_worked(tree, values, short), values))))


def _judged(key: Key, answers: Answers, figures: int) -> Iterator[tuple[str, Any]]:
    problem = key.variant.problem
    judged = judge(
        key, {part: written(problem.part(part), values, figures) for part, values in answers.items()}
    )
    return ((part, judged[part]) for part in answers)


def written(part: Part, values: Values, figures: int) -> Value:
    """Numbers as a student types them, with the part's unit."""
    size = part.unit.si
    unit = "" if part.unit.text == "1" else f" {canonical(part.unit)}"
    texts = [Text(f"{value / size:.{figures - 1}e}{unit}") for value in values]
    return Items(tuple(texts), (len(texts),)) if part.components else texts[0]


def wild(solutions: Iterable[Solution], count: int) -> dict[str, Any]:
    """Answers that are just anything: even on (-3, 3) times the truth, and even in their logarithm over four powers of ten.

    Given are the shares of each verdict, for answers to one part alone, and with wild answers to the parts before.
    """
    dice, result = random.Random(5), {}
    scatter: dict[str, Callable[[], float]] = {
        "even in -3..3": lambda: dice.uniform(-3, 3),
        "even in the logarithm, 1/100..100": lambda: dice.choice((-1, 1)) * 10 ** dice.uniform(-2, 2),
    }
    keys = [
        make_key(solution, variant)
        for solution in solutions
        for variant in sample(solution.problem, 5, salt="wild")
    ]
    for name, ratio in scatter.items():
        for earlier in (False, True):
            verdicts: Counter[str] = Counter()
            for _ in range(max(1, count // 100)):
                for key in keys:
                    truths = {part: truth for part, truth in key.truths.items() if truth.scale}
                    answers = {
                        part: tuple(ratio() * truth.scale for _ in truth.values)
                        for part, truth in truths.items()
                    }
                    for chosen in (
                        [answers] if earlier else [{part: values} for part, values in answers.items()]
                    ):
                        verdicts.update(word(verdict) for _, ((verdict,), _) in _judged(key, chosen, 5))
            total = sum(verdicts.values())
            result[f"{name}; {'after wild answers' if earlier else 'alone'}"] = {"answers": total} | {
                verdict: _percent(verdicts[verdict], total)
                for verdict in ("right", "follows", "mistaken", "slip", "wrong")
            }
    return result


def _percent(part: int, whole: int) -> float | None:
    return round(100 * part / whole, 3) if whole else None
