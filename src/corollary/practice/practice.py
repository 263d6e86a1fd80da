"""Exercises posed for practice: problems of a bank, each with numbers of its own, as often as one likes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field
from functools import cached_property

from corollary.answers.preview import Preview
from corollary.answers.questions import askable, question_in
from corollary.answers.registry import answer_type
from corollary.derive.load import NotDerivable
from corollary.derive.ready_scenes import film_of
from corollary.derive.simulation import Seen, simulations
from corollary.derive.time_limit import TooLong
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.neglect import neglected_in
from corollary.grading.part_grades import PartGrade
from corollary.grading.points import grade
from corollary.grading.run_programs import run_programs
from corollary.grading.solutions import Solutions, worked_steps_of
from corollary.notebook.worksheet import Exercise, exercise
from corollary.practice.hints import Hints, hints, hints_by_known
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter
from corollary.scenes.film import Film
from corollary.scenes.run import BadSetting, GuardFailed

Answer = str | list[str]


@dataclass(frozen=True)
class Posed:
    """A problem with the numbers of `key`, as a student practises it. An answer is a text, or one for each component."""

    key: Key

    @cached_property
    def exercise(self) -> Exercise:
        """What is asked. Raises Malformed when a part's heading does not fit its answer type."""
        return exercise(self.key.variant)

    def part(self, name: str) -> Part:
        """Raises LookupError for a part that the problem does not have."""
        found = next((each for each in self.exercise.problem.parts if each.id == name), None)
        if found is None:
            raise LookupError(f"{self.exercise.problem.code} has no part {name}")
        return found

    def preview(self, name: str, answer: Answer) -> Preview:
        """How an answer is read, never whether it is right; nothing is run."""
        part = self.part(name)
        its_type = answer_type(part.answer_type)
        return its_type.preview(from_json(answer), question_in(self.exercise.variant, part))

    def judged(self, name: str, answers: Mapping[str, Answer], wrong_before: int = 0) -> PartGrade:
        """What one part earns after so many wrong answers to it, with the others' answers to carry on from; only its own program
        is run, in isolation."""
        self.part(name)
        values = {part: from_json(answer) for part, answer in answers.items()}
        programs = run_programs(self.key, {part: value for part, value in values.items() if part == name})
        return grade(self.key, judge(self.key, values, programs), wrong_before=wrong_before)[name]

    def hints(self, name: str, right: frozenset[str]) -> tuple[str, ...]:
        """What may be told of a part, one after the other, to whom the parts in `right` are known."""
        return hints(self.key, self.part(name), right)

    def hints_by_known(self, name: str) -> Hints:
        """The same for every choice of known parts."""
        return hints_by_known(self.key, self.part(name))

    @cached_property
    def worked_steps(self) -> tuple[str, ...]:
        """The worked solution as Markdown, step by step."""
        return tuple(worked_steps_of(self.key))


def motion(bank: Bank, key: Key) -> Film | None:
    """The first simulation that the solution wants `animated`; none where there is none, or where these numbers let nothing move.

    Raises NotDerivable where the scene fails.
    """
    answers: dict[str, Seen] = {
        part: truth.values[0] if len(truth.values) == 1 else truth.values
        for part, truth in key.truths.items()
    }
    try:
        wanted = simulations(bank, key.variant, answers, neglected_in(key))
        first = next((each for each in wanted if each.animated), None)
        return film_of(first.scene, first.settings, first.bank) if first else None
    except (BadSetting, GuardFailed):
        return None


SECRET = b"practice"  # numbers for practice are nobody's own: they may be guessed
AT_HAND = 64  # exercises at hand; an older one is drawn again


@dataclass(slots=True)
class Practice:
    """The problems one may practise on. `turn` counts how often a problem was begun: each has other numbers.

    `broken`: what is wrong with files of the bank that cannot be read. A problem is in `endless` once its scene has not ended:
    it has no motion from then on."""

    bank: Bank
    problems: tuple[Problem, ...]
    solutions: Solutions
    broken: tuple[Diagnostic, ...] = ()
    posed: dict[tuple[str, int], Posed] = field(default_factory=dict[tuple[str, int], Posed])
    endless: set[str] = field(default_factory=set[str])

    def pose(self, code: str, turn: int) -> Posed:
        """The exercise of a turn; turn 0 has the printed numbers. Raises LookupError for a code that is left out,
        NotDerivable, NoVariant and Undefined where there is no answer."""
        problem = next((each for each in self.problems if each.code == code), None)
        if problem is None:
            raise LookupError(f"no problem {code} to practise on")
        if (code, turn) not in self.posed:
            while len(self.posed) >= AT_HAND:
                del self.posed[next(iter(self.posed))]
            self.posed[code, turn] = Posed(self._key(problem, turn))
        return self.posed[code, turn]

    def motion(self, code: str, turn: int) -> Film | None:
        """What moves in the exercise of a turn; it tells the answers. Raises as `pose` does."""
        if code in self.endless:
            return None
        try:
            return motion(self.bank, self.pose(code, turn).key)
        except NotDerivable as error:
            if isinstance(error.__cause__, TooLong):
                self.endless.add(code)
            return None

    def _key(self, problem: Problem, turn: int) -> Key:
        """The printed numbers where these are all there are."""
        if turn == 0 or all(given.grid.count == 1 for given in problem.givens):
            return self.solutions.key(chapter(problem))
        return self.solutions.assign_variant(problem, SECRET, str(turn), ()).key


def practice(bank: Bank, wanted: Sequence[str] = (), left_out: Set[str] = frozenset()) -> Practice:
    """The problems of the bank whose code, name or topic is wanted (all when none is), but those whose code is `left_out`.

    A file that cannot be read costs its own problem. Raises LookupError when nothing is left, or a word is none of these, and
    Malformed when no file can be read.
    """
    problems, broken = askable(bank)
    if broken and not problems:
        raise Malformed(broken)
    words = {word for each in problems for word in (each.code, each.name, each.topic)}
    if strange := [word for word in wanted if word not in words]:
        topics = ", ".join(sorted({each.topic for each in problems}))
        raise LookupError(
            f"{strange[0]} is neither a problem nor a topic of this bank; its topics are {topics}"
        )
    chosen = [
        each
        for each in problems
        if (not wanted or {each.code, each.name, each.topic} & set(wanted)) and each.code not in left_out
    ]
    if not chosen:
        raise LookupError(
            "no problem is left to practise on; name other problems or topics, or come back when the set is due"
        )
    first_of_its_code = {
        each.code: each for each in reversed(chosen)
    }  # a code used twice is among the complaints
    unique = tuple(each for each in chosen if first_of_its_code[each.code] is each)
    return Practice(bank, unique, Solutions(bank), tuple(broken))
