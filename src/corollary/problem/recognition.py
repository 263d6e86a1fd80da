"""Who on the roster is meant by a row of an LMS's file: by any id that is known of a student, else by a name that only one has."""

from __future__ import annotations

import re
import unicodedata
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from corollary.problem.roster import NOBODY, Student
from corollary.problem.roster_columns import OTHERS, columns_of

IDENTIFIER = OTHERS[0]  # Moodle's grading worksheet: "Participant 123"
# Canvas writes a name that begins with = as a formula that gives it.
AS_FORMULA = re.compile(r'="(.*)"$')


@dataclass(frozen=True, slots=True)
class Recognition:
    """The students of a roster, by all that they are called."""

    _by_heading: dict[tuple[str, str], set[Student]]
    _by_id: dict[str, set[Student]]
    _by_name: dict[str, set[Student]]

    @classmethod
    def of(cls, students: Iterable[Student]) -> Recognition:
        by_heading = defaultdict[tuple[str, str], set[Student]](set)
        by_id, by_name = (defaultdict[str, set[Student]](set) for _ in range(2))
        for each in students:
            for heading, value in (("id", each.id), ("email", each.email), *each.ids):
                if value:
                    by_heading[folded(heading), folded(value)].add(each)
                    by_id[folded(value)].add(each)
            first, last = each.first_name, each.last_name
            for name in {f"{first} {last}", f"{last} {first}", f"{last}, {first}"} if first or last else ():
                by_name[folded(name)].add(each)
        return cls(dict(by_heading), dict(by_id), dict(by_name))

    def by_ids(self, cells: Iterable[tuple[str, str]]) -> set[Student]:
        """Whom ids point to, each given with its heading: several when they contradict each other. Where a student is known
        under the same heading, what stands under others is not asked."""
        found: set[Student] = set()
        for heading, value in cells:
            if value:
                same = self._by_heading.get((folded(heading), folded(value)))
                found |= same or self._by_id.get(folded(value), set())
        return found

    def by_name(self, name: str) -> set[Student]:
        return self._by_name.get(folded(name), set())


@dataclass(frozen=True, slots=True)
class RowOwners:
    """Whom the rows of a file are about, by row; `by_name`: recognized by the name alone; `strangers` are rows of somebody who
    is not known, `unclear` of whom ids contradict each other, or several have the name."""

    students: dict[int, Student]
    by_name: tuple[int, ...]
    strangers: tuple[int, ...]
    unclear: tuple[int, ...]


def recognized(
    known: Recognition, headings: Sequence[str], rows: Sequence[tuple[int, Sequence[str]]]
) -> RowOwners:
    """Whom each row of a file with these headings is about. RowOwners of nobody (Canvas's points, its test student) are in none."""
    columns = columns_of(headings)
    others = [at for at, heading in enumerate(headings) if folded(heading) == IDENTIFIER]
    found: dict[int, Student] = {}
    by_name, strangers, unclear = list[int](), list[int](), list[int]()
    for number, row in rows:

        def cell(at: int | None, row: Sequence[str] = row) -> str:
            return row[at] if at is not None and at < len(row) else ""

        names = _names(cell(columns.name), cell(columns.first_name), cell(columns.last_name))
        ids = [(headings[at], cell(at)) for at in (*columns.ids, *others)]
        if NOBODY.match(cell(0)) or not (any(value for _, value in ids) or any(names)):
            continue
        meant = known.by_ids(ids)
        if not meant:
            meant = set[Student]().union(*map(known.by_name, names))
            by_name += [number] if len(meant) == 1 else []
        if len(meant) == 1:
            found[number] = meant.pop()
        else:
            (unclear if meant else strangers).append(number)
    return RowOwners(found, tuple(by_name), tuple(strangers), tuple(unclear))


def folded(text: str) -> str:
    """Equal for texts that differ in capitals, spaces, or the way accents are stored."""
    return " ".join(unicodedata.normalize("NFC", unicodedata.normalize("NFKC", text).casefold()).split())


def _names(full: str, first: str, last: str) -> set[str]:
    formula = AS_FORMULA.match(full)
    given = formula[1] if formula else full
    return {name for name in (given, f"{first} {last}".strip()) if name}
