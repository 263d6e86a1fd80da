"""Wrong answers that no solution lists, explained by rules one change from the derivation that several students share."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from corollary.derive.solution import Solution
from corollary.formula.arithmetics import arrays, ready
from corollary.formula.ast import Expr
from corollary.formula.errors import NotAvailable
from corollary.grading.unlisted_rules import UnlistedRule, as_derived, rules_near

LEAST_STUDENTS: Final = 3
BY_CHANCE: Final = 0.01  # how often a part without any shared rule may be offered one
SAME: Final = 1e-9  # relative: two rules that give this are one
MOST_RULES: Final = 4


@dataclass(frozen=True, slots=True)
class DrawnLetters:
    """What one student's formulas start from, by letter, in SI: givens, and what was found in other parts, the student's own values
    where there are any. `typed` is the wrong answer in SI (None: it is not wrong, or explained), `tolerance` relative to its length;
    `points` those that it would earn as a listed misconception."""

    student: str
    letters: Mapping[str, float]
    typed: tuple[float, ...] | None = None
    tolerance: float = 0.0
    points: float = 0.0


@dataclass(frozen=True, slots=True)
class SharedRule:
    """Rules (several where they explain the same answers) that give the wrong answers of `students`, out of `wrong` unexplained
    ones; `expected` are as many as would fit by chance. `adjusted` is the chance of so many, for all `tried` rules together; `points`
    move if it is listed, before lateness."""

    problem: str
    part: str
    rules: tuple[UnlistedRule, ...]
    students: tuple[str, ...]
    wrong: int
    expected: float
    p: float
    adjusted: float
    tried: int
    points: float


def shared_rules(
    solution: Solution, problem: str, part: str, drawn: Sequence[DrawnLetters]
) -> list[SharedRule]:
    """The rule shared by most students first; then those of the answers that it leaves. Nothing where fewer than three are wrong.

    Chance is how often the rule, with the numbers of other students, gives an answer: of students who all have the same numbers
    nothing can be told.
    """
    wrong = [place for place, one in enumerate(drawn) if one.typed is not None]
    if len(wrong) < LEAST_STUDENTS:
        return []
    values_of = _evaluation(drawn)
    found = list(_distinct(solution, part, values_of, wrong))
    met: list[tuple[UnlistedRule, Table]] = [(rule, _met(values, drawn, wrong)) for rule, values in found]
    offers: list[SharedRule] = []
    left = np.ones(len(wrong), dtype=bool)
    while met:
        most = max(met, key=lambda each: int((_own(each[1], wrong) & left).sum()))[1]
        own = _own(most, wrong) & left
        if own.sum() < LEAST_STUDENTS:
            break
        alike = [(rule, table) for rule, table in met if ((_own(table, wrong) & left) == own).all()]
        offer = _offer(problem, part, alike, drawn, wrong, left, len(found))
        if offer is None:  # too likely by chance: another rule may still tell more of the same answers
            refused = [id(rule) for rule, _ in alike]
            met = [(rule, table) for rule, table in met if id(rule) not in refused]
            continue
        offers.append(offer)
        left &= ~own
    return offers


def rules_giving(
    solution: Solution, part: str, drawn: Sequence[DrawnLetters], place: int
) -> list[tuple[UnlistedRule, list[int]]]:
    """The rules, one change from the derivation, that give the answer of the student at `place`; with each the places of all whose
    answer it gives with their own numbers, this student's among them."""
    if drawn[place].typed is None:
        return []
    wrong = [at for at, one in enumerate(drawn) if one.typed is not None]
    row = wrong.index(place)
    found: list[tuple[UnlistedRule, list[int]]] = []
    for rule, values in _distinct(solution, part, _evaluation(drawn), [place]):
        own = _own(_met(values, drawn, wrong), wrong)
        if own[row]:
            found.append((rule, [at for at, fits in zip(wrong, own, strict=True) if fits]))
    return found


def shared_rules_record(found: SharedRule) -> dict[str, object]:
    """As plain data for JSON."""
    return {
        "problem": found.problem,
        "part": found.part,
        "rules": [
            {"change": one.words, "formula": one.formula, "message": one.message, "draft": one.draft}
            for one in found.rules
        ],
        "students": list(found.students),
        "count": len(found.students),
        "wrong": found.wrong,
        "expected": found.expected,
        "p": found.p,
        "p_adjusted": found.adjusted,
        "tried": found.tried,
        "points": found.points,
    }


Values = NDArray[np.float64]
Table = NDArray[np.bool_]


def _evaluation(drawn: Sequence[DrawnLetters]) -> Callable[[tuple[Expr, ...]], Values | None]:
    """Formulas at everybody's numbers: a row for each student, NaN where there is no value; None where they cannot be evaluated."""
    letters = {name: None for one in drawn for name in one.letters}
    columns: dict[str, Any] = {
        name: np.array([one.letters.get(name, np.nan) for one in drawn]) for name in letters
    }
    arithmetic = arrays()

    def values(trees: tuple[Expr, ...]) -> Values | None:
        try:
            with np.errstate(all="ignore"):
                found = [np.asarray(ready(tree, arithmetic)(columns), dtype=float) for tree in trees]
        except (NotAvailable, KeyError, ZeroDivisionError, OverflowError):
            return None
        return np.column_stack([np.broadcast_to(each, len(drawn)) for each in found])

    return values


def _distinct(
    solution: Solution,
    part: str,
    values_of: Callable[[tuple[Expr, ...]], Values | None],
    wrong: Sequence[int],
) -> Iterator[tuple[UnlistedRule, Values]]:
    """Rules that do not give the same as one before them, or as the derivation, for those who are wrong."""
    right = as_derived(solution, part)
    known = [] if right is None or (values := values_of(right)) is None else [values[wrong]]
    for rule in rules_near(solution, part):
        values = values_of(rule.trees)
        if values is None or np.isnan(values[wrong]).all():
            continue
        if any(np.allclose(values[wrong], each, SAME, 0.0, equal_nan=True) for each in known):
            continue
        known.append(values[wrong])
        yield rule, values


def _met(values: Values, drawn: Sequence[DrawnLetters], wrong: Sequence[int]) -> Table:
    """For each wrong answer (a row), whether the rule gives it with each student's numbers."""
    lengths = np.linalg.norm(values, axis=1)
    rows: list[Table] = []
    for place in wrong:
        typed = np.array(drawn[place].typed)
        if typed.shape != values.shape[1:]:
            rows.append(np.zeros(len(drawn), dtype=bool))
            continue
        with np.errstate(invalid="ignore"):
            near = np.linalg.norm(values - typed, axis=1) <= drawn[place].tolerance * lengths
        rows.append(near & (lengths > 0))
    return np.array(rows)


def _own(table: Table, wrong: Sequence[int]) -> Table:
    return table[np.arange(len(wrong)), list(wrong)]


def _offer(
    problem: str,
    part: str,
    alike: Sequence[tuple[UnlistedRule, Table]],
    drawn: Sequence[DrawnLetters],
    wrong: Sequence[int],
    left: Table,
    tried: int,
) -> SharedRule | None:
    """None where so many may fit by chance; of several rules that explain the same answers the one that fits others least counts."""
    from scipy.special import pdtrc

    own = _own(alike[0][1], wrong) & left
    same = np.array([[one.letters == drawn[place].letters for one in drawn] for place in wrong])
    others = ~same[left]
    if not others.any():
        return None
    hits = min(int((table[left] & others).sum()) for _, table in alike)
    expected = float(left.sum()) * (hits + 0.5) / (int(others.sum()) + 1)
    p = float(pdtrc(int(own.sum()) - 1, expected))
    adjusted = min(1.0, p * tried)
    if adjusted > BY_CHANCE:
        return None
    explained = [drawn[place] for place, one in zip(wrong, own, strict=True) if one]
    return SharedRule(
        problem,
        part,
        tuple(rule for rule, _ in alike[:MOST_RULES]),
        tuple(one.student for one in explained),
        len(wrong),
        expected,
        p,
        adjusted,
        tried,
        round(sum(one.points for one in explained), 6),
    )
