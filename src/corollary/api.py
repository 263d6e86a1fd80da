"""The front door: a bank loaded, a problem solved, its key for given numbers, answers judged, a scene played."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from corollary.formula.errors import ParseError, sentence
from corollary.problem.bank import Bank, bank_of, open_bank
from corollary.problem.front_matter import exact
from corollary.problem.given import Given
from corollary.problem.problem import Problem
from corollary.problem.variant import OutOfRange, Variant, chosen
from corollary.units.unit import show

if TYPE_CHECKING:  # each function loads the rooms it needs: a key needs no scenes, a scene no solutions
    from corollary.derive.solution import Solution
    from corollary.grading.key import Key
    from corollary.grading.part_grades import Grade
    from corollary.scenes.run import Run

GivenValue = str | float | Fraction
AnswerValue = str | float | Fraction | list["AnswerValue"] | dict[str, "AnswerValue"] | None

# Radians kept in degrees: pi to 60 figures, far beyond what a double can tell.
PI = Fraction(314159265358979323846264338327950288419716939937510582097494, 10**59)


class UnknownPart(LookupError):
    """An answer to a part that the problem does not have; one sentence says which parts it has."""


def load_bank(place: str | Path | None = None) -> Bank:
    """The bank in a folder, or the chapter's when nothing is named. Raises UnknownCode when the folder is no bank."""
    return open_bank(None if place is None else Path(place))


def solve(problem: Problem) -> Solution:
    """The problem's derivation solved, or recalled from the user's cache when nothing it depends on has changed.

    Raises NotDerivable, with file and line, when the solution is missing or does not lead to the answers.
    """
    from corollary.derive.cache import solution_of

    return solution_of(bank_of(problem), problem)


def key(problem: Problem | Solution, /, **given: GivenValue) -> Key:
    """The answers for given numbers, in SI, with certified digits. Givens left out have their printed values.

    A number is in the given's SI unit, a text may carry its own (`v="72 km/h"`). For many keys of one problem, solve it once
    and pass the solution. Raises OutOfRange for numbers against the physics, Undefined where an answer does not exist.
    """
    from corollary.grading.key import make_key

    solution = solve(problem) if isinstance(problem, Problem) else problem
    return make_key(solution, variant(solution.problem, given))


def judge(
    problem: Problem | Solution,
    answers: Mapping[str, AnswerValue],
    given: Mapping[str, GivenValue] | None = None,
    *,
    reveal: bool = False,
) -> Grade:
    """What a student's answers earn, part by part, with the verdicts and the feedback the student reads.

    An answer is a text as typed, a number (in the part's unit), or a list of either for components (or an object, by
    their names); a part left out was left blank. The source of a program is run in isolation. `reveal`: feedback may give the right values. Raises UnknownPart, and
    what `key` raises.
    """
    from corollary.grading.from_json import from_json
    from corollary.grading.judge import judge as judge_parts
    from corollary.grading.points import grade
    from corollary.grading.run_programs import run_programs

    solution = solve(problem) if isinstance(problem, Problem) else problem
    parts = solution.problem.parts
    if strange := [name for name in answers if name not in {part.id for part in parts}]:
        known = ", ".join(part.id_and_letter for part in parts)
        raise UnknownPart(f"{solution.problem.code} has no part {', '.join(strange)}; its parts are {known}")
    of = key(solution, **(given or {}))
    values = {part: from_json(_as_a_process_holds_it(answer)) for part, answer in answers.items()}
    return grade(of, judge_parts(of, values, run_programs(of, values)), reveal=reveal)


def play(
    scene: str,
    *,
    tolerance: float = 1e-12,
    conditions: bool = True,
    bank: Bank | str | Path | None = None,
    **settings: float | tuple[float, ...],
) -> Run:
    """A ready-made scene of a bank (as `load_bank` finds it) or of the chapter's, played with the least model that answers; settings are in SI, those left out
    have the scene's own values.

    `tolerance` is relative to the scene's natural scale. Each value has its condition, and `warnings` announce a grazing hit, an edge
    or chaos, for a run more for each setting; without `conditions` they are left out.
    Raises BadSetting when a setting is unknown or unphysical, GuardFailed when momentum or energy is not kept.
    """
    from corollary.derive import ready_scenes
    from corollary.scenes.progress import with_bar

    place = load_bank(bank) if isinstance(bank, (str, Path)) else bank
    if conditions:
        return ready_scenes.play(scene, settings, tolerance, bank=place)
    with with_bar(f"scene {scene}"):
        return ready_scenes.run(scene, settings, tolerance, bank=place)


def variant(problem: Problem, given: Mapping[str, GivenValue]) -> Variant:
    """The problem with these numbers. Raises OutOfRange for an unknown symbol, what is no number, or a value against the physics."""
    return chosen(problem, {name: _in_own_unit(problem, name, value) for name, value in given.items()})


def _as_a_process_holds_it(answer: AnswerValue) -> AnswerValue:
    """Exact decimals of a file, as the machine numbers a student's process would hold."""
    match answer:
        case Fraction():
            try:
                return float(answer)
            except OverflowError:
                return answer
        case list():
            return [_as_a_process_holds_it(each) for each in answer]
        case dict():
            return {name: _as_a_process_holds_it(each) for name, each in answer.items()}
        case _:
            return answer


def _in_own_unit(problem: Problem, name: str, value: GivenValue) -> Fraction:
    """What somebody says a given is, in the unit in which the given is kept."""
    given = _given(problem, name)
    if given.words:
        return _place_of(given, value)
    match value:
        case float() | str():
            return _read(given, str(value))
        case int() | Fraction() if not isinstance(value, bool):
            return _from_si(given, Fraction(value), 0)
        case _:
            raise OutOfRange(f"{name}: {json.dumps(value, default=str)} is not a number")


def _place_of(given: Given, value: GivenValue) -> Fraction:
    """The place of a word in its list, from the word or the place."""
    if value in given.words:
        return Fraction(given.words.index(str(value)))
    place = exact(str(value))
    if place is None or place not in range(len(given.words)):
        raise OutOfRange(f"{given.symbol}={value}: say one of {', '.join(given.words)}")
    return place


def _read(given: Given, text: str) -> Fraction:
    """A text, exactly: a bare number is in SI; what has a unit must fit the given's."""
    number = exact(text)
    if number is not None:
        return _from_si(given, number, 0)
    from corollary.answers.quantity import read_quantity

    found = read_quantity(text, given.unit)
    if isinstance(found, ParseError):
        raise OutOfRange(f"{given.symbol}={text}: {sentence(found)}")
    if found.fit != "fits":
        raise OutOfRange(f"{given.symbol}={text}: {found.why}")
    return _from_si(given, *found.si)


def _from_si(given: Given, ratio: Fraction, pi: int) -> Fraction:
    """`ratio` times pi to a power, in SI, as a number of the given's own unit."""
    power = pi - given.unit.pi if ratio else 0
    return (ratio * PI**power - given.unit.offset) / given.unit.factor


def _given(problem: Problem, name: str) -> Given:
    for given in problem.givens:
        if given.symbol == name:
            return given
    known = ", ".join(f"{given.symbol} [{show(given.unit) or '1'}]" for given in problem.givens)
    raise OutOfRange(f"{name} is not among the givens of {problem.code}: {known}")
