"""Misconceptions through a term: in which sets each student met them, who repeated them, and who lost them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from corollary.records.misconception_names import MISTAKEN, SLIP, Misconception, MisconceptionNames
from corollary.records.term import CourseTerm, SetMark

REPEATED, ONCE, LOST = "repeated", "once", "lost"
PASSED = frozenset({"right", "follows"})


@dataclass(frozen=True, slots=True)
class Followed:
    """One misconception of one student: the parts in which it was met, by set, and the sets that asked for it without its being met
    (in one part at least the answer was right); `since` are those after the last in which it was met."""

    student: str
    misconception: Misconception
    met: Mapping[str, tuple[str, ...]]
    passed: tuple[str, ...]
    since: tuple[str, ...]

    @property
    def status(self) -> str:
        """Lost: no more met in the sets that could show it since. Else repeated where two sets met it."""
        if self.since:
            return LOST
        return REPEATED if len(self.met) > 1 else ONCE


@dataclass(frozen=True, slots=True)
class MisconceptionTerm:
    """One misconception in the class: how many met it, by set, and the students by what became of it."""

    misconception: Misconception
    counts: Mapping[str, int]
    repeated: tuple[str, ...]
    once: tuple[str, ...]
    lost: tuple[str, ...]

    @property
    def count(self) -> int:
        return len(self.repeated) + len(self.once) + len(self.lost)


def names_of(term: CourseTerm) -> MisconceptionNames:
    """The names of all that the solutions of the term's sets list."""
    names = MisconceptionNames()
    for each in term.sets:
        if each.problem_set is not None and each.bank is not None:
            for problem in each.problem_set.problems:
                names.add(each.bank, problem)
    return names


def followed(term: CourseTerm, names: MisconceptionNames) -> tuple[Followed, ...]:
    """Every misconception of every student of the term, students in the order of the roster."""
    found: list[Followed] = []
    for line in term.students:
        student = line.student.id
        met: dict[Misconception, dict[str, tuple[str, ...]]] = {}
        passed: dict[Misconception, dict[str, None]] = {}
        for name in term.names:
            mark = term.marks[name].get(student)
            if mark is None:
                continue
            for what, parts in _met(mark, names).items():
                met.setdefault(what, {})[name] = tuple(parts)
            for row in mark.rows:
                if row.verdict in PASSED:
                    for what in names.shows.get((row.problem, row.part), ()):
                        passed.setdefault(what, {})[name] = None
        for what, where in met.items():
            without = tuple(name for name in passed.get(what, ()) if name not in where)
            last = max(term.names.index(name) for name in where)
            since = tuple(name for name in without if term.names.index(name) > last)
            found.append(Followed(student, what, where, without, since))
    return tuple(found)


def _met(mark: SetMark, names: MisconceptionNames) -> dict[Misconception, list[str]]:
    found: dict[Misconception, list[str]] = {}
    for row in mark.rows:
        if row.error and row.verdict in {MISTAKEN, SLIP}:
            what = names.named(row.problem, row.verdict, row.error)
            found.setdefault(what, []).append(f"{row.problem} {row.part}")
    return found


def by_misconception(lines: tuple[Followed, ...]) -> tuple[MisconceptionTerm, ...]:
    """The same by misconception: those first that most students repeat, slips last."""
    found: dict[Misconception, list[Followed]] = {}
    for each in lines:
        found.setdefault(each.misconception, []).append(each)
    made = [_in_class(what, several) for what, several in found.items()]
    return tuple(
        sorted(
            made,
            key=lambda each: (
                each.misconception.is_slip,
                -len(each.repeated),
                -each.count,
                each.misconception,
            ),
        )
    )


def _in_class(what: Misconception, lines: list[Followed]) -> MisconceptionTerm:
    counts: dict[str, int] = {}
    for each in lines:
        for name in each.met:
            counts[name] = counts.get(name, 0) + 1
    groups = [
        tuple(each.student for each in lines if each.status == status) for status in (REPEATED, ONCE, LOST)
    ]
    return MisconceptionTerm(what, counts, *groups)
