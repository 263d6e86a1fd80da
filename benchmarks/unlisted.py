"""Whether a rule that students share and nobody listed is found, and how often one is offered that nobody used.

`python benchmarks/unlisted.py [--courses 1] [--markdown FILE]`

In each part of a few problems a rule one change from the derivation is planted in some students of sixty; others are wrong in ways
of their own: two changes of the derivation at once, or a number that is off by anything. All answers are typed to three figures, and
only those are looked at that the marking calls wrong. Courses without a planted rule tell how often one is offered falsely.
"""

from __future__ import annotations

import argparse
import math
import random
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import corollary
from corollary.answers.evaluation import as_exact, balls, numbers
from corollary.answers.verdict import Wrong
from corollary.formula.ball import Undefined
from corollary.formula.value import Text
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.unlisted_rules import UnlistedRule, changes, rules_near
from corollary.problem.sampling import sample
from corollary.records.unlisted import DrawnLetters, SharedRule, shared_rules

CODES = ("X12.5", "X12.13", "P12.15", "X12.7")
STUDENTS, OTHERS = 60, 12
SHARING = (0, 3, 5, 8)


@dataclass(frozen=True, slots=True)
class Course:
    """What was planted, whether any answers of it were left to find, and what was offered."""

    sharing: int
    planted: frozenset[str]
    offers: tuple[SharedRule, ...]

    @property
    def found(self) -> bool:
        return any(self.planted & {*offer.students} for offer in self.offers)

    @property
    def false(self) -> int:
        return sum(len(self.planted & {*offer.students}) <= len(offer.students) / 2 for offer in self.offers)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--courses", type=int, default=1, help="simulated courses of each part and each size")
    parser.add_argument("--markdown", type=Path)
    asked = parser.parse_args()
    courses = list(_courses(asked.courses))
    text = "\n".join(_table(courses, asked.courses)) + "\n"
    print(text, end="")
    if asked.markdown:
        asked.markdown.write_text(text, encoding="utf-8")


def _table(courses: list[Course], count: int) -> Iterator[str]:
    yield f"# Unlisted rules found\n\n`python benchmarks/unlisted.py --courses {count}`\n"
    yield (
        f"Parts of {', '.join(CODES)}, {STUDENTS} students each with numbers of their own, {OTHERS} of them wrong in ways of their"
        " own. *Found*: an offer names students in whom the rule was planted. *False*: an offer most of whose students had it not.\n"
    )
    yield "| students with the rule | courses | found | courses with a false offer |"
    yield "|---|---|---|---|"
    for sharing in SHARING:
        some = [each for each in courses if each.sharing == sharing]
        if some:
            found = f"{sum(each.found for each in some) / len(some):.1%}" if sharing else "–"
            false = sum(each.false > 0 for each in some)
            yield f"| {sharing} | {len(some)} | {found} | {false} ({false / len(some):.1%}) |"


def _courses(count: int) -> Iterator[Course]:
    bank, chance = corollary.load_bank(), random.Random(15)
    for code in CODES:
        solution = corollary.solve(bank[code])
        keys: list[Key] = []
        for variant in sample(bank[code], STUDENTS, salt="unlisted"):
            try:
                keys.append(make_key(solution, variant))
            except Undefined:
                continue
        for find in solution.unknowns:
            rules = rules_near(solution, find.part) if find.part else []
            for sharing in SHARING:
                for _ in range(count if rules else 0):
                    course = _course(keys, find.part, rules, sharing, chance)
                    if course is not None:
                        yield course


def _course(
    keys: list[Key], part: str, rules: list[UnlistedRule], sharing: int, chance: random.Random
) -> Course | None:
    """None where the rule drawn gives nothing that would be called wrong: it is right, or listed."""
    order = chance.sample(range(len(keys)), len(keys))
    rule = chance.choice(rules)
    typed: dict[int, tuple[float, ...]] = {}
    for place in order[:sharing]:
        values = _called_wrong(keys[place], part, _by(keys[place], rule))
        if values is None:
            return None
        typed[place] = values
    for place in order[sharing : sharing + OTHERS]:
        values = _called_wrong(keys[place], part, _own_way(keys[place], part, rules, chance))
        if values is not None:
            typed[place] = values
    drawn = [
        DrawnLetters(str(place), _letters(key), typed.get(place), key[part].tolerance)
        for place, key in enumerate(keys)
    ]
    planted = frozenset(str(place) for place in order[:sharing])
    return Course(
        sharing, planted, tuple(shared_rules(keys[0].solution, keys[0].variant.problem.code, part, drawn))
    )


def _letters(key: Key) -> dict[str, float]:
    letters = dict(key.variant.si)
    for find, values in zip(key.solution.unknowns, key.values, strict=True):
        letters |= zip(find.names, values, strict=True)
    return letters


def _by(key: Key, rule: UnlistedRule) -> tuple[float, ...] | None:
    known = key.variant.exact | {
        name: as_exact(value) for name, value in _letters(key).items() if name not in key.variant.exact
    }
    try:
        return numbers(rule.trees, balls(known))
    except Undefined:
        return None


def _own_way(
    key: Key, part: str, rules: list[UnlistedRule], chance: random.Random
) -> tuple[float, ...] | None:
    """Two changes at once, or anything between a tenth and ten times as much."""
    if chance.random() < 0.5:
        trees = chance.choice(rules).trees
        measured = [given.symbol for given in key.variant.problem.givens]
        twice = chance.choice(changes(trees, {}, measured))
        return _by(key, UnlistedRule("", "", "", "", twice.trees))
    factor = math.exp(chance.uniform(-math.log(10), math.log(10)))
    return tuple(factor * value for value in key[part].values)


def _called_wrong(key: Key, part: str, values: tuple[float, ...] | None) -> tuple[float, ...] | None:
    if values is None or not all(map(math.isfinite, values)):
        return None
    unit = key.variant.problem.part(part).unit
    shown = [f"{float(unit.from_si(value)):.3g}" for value in values]
    text = shown[0] if len(shown) == 1 else f"({', '.join(shown)})"
    verdicts, _ = judge(key, {part: Text(f"{text} {unit.text}".strip())})[part]
    return tuple(float(one) * unit.si for one in shown) if isinstance(verdicts[0], Wrong) else None


if __name__ == "__main__":
    main()
