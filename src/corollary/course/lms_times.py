"""When something was handed in, as Moodle's grading worksheet says it: archives have the times of their download only."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, tzinfo
from pathlib import Path

from corollary.course.month_names import month
from corollary.messages import few, visible
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.table import read_table
from corollary.records.lms_names import LmsName

IDENTIFIER = "identifier"
PARTICIPANT = re.compile(r"\D*[^\W\d]\D*\d+$")  # a word and a number, in whatever language
# "Last modified (submission)" of mod_assign; of another language, the first column with times whose heading is in two parts.
MODIFIED = frozenset(
    {
        "last modified (submission)", "zuletzt geändert (abgabe)", "dernière modification (travail remis)",
        "última modificación (entrega)", "ultima modifica (consegna)", "última atualização (submissão)",
        "laatst gewijzigd (inzending)", "senast modifierat (inlämning)", "poslední změna (odevzdání)",
    }
)  # fmt: skip
IN_TWO_PARTS = re.compile(r"[(（]")
CLOCK = re.compile(r"(\d{1,2})\s?[:.h]\s?(\d{2})(?:[:.]\d{2})?\s*(?:([ap])\.?\s?m\.?)?$", re.IGNORECASE)
WORD = re.compile(r"[^\W\d_]+")
NOTHING = ("", "-")


@dataclass(frozen=True, slots=True)
class Times:
    """Moments by the number of a participant; `remarks` are sentences on what could not be read, or might be meant otherwise."""

    by_number: dict[str, datetime]
    remarks: tuple[str, ...] = ()

    def of(self, name: LmsName) -> datetime | None:
        return self.by_number.get(name.number) if name.lms == "moodle" else None

    def joined(self, other: Times) -> Times:
        return Times(self.by_number | other.by_number, (*self.remarks, *other.remarks))


def read_times(path: Path, zone: tzinfo) -> Times:
    """The times of a worksheet, which are in this zone. Raises Malformed when the file is none."""
    table = read_table(path, (IDENTIFIER, *MODIFIED))
    head = [cell.lower() for cell in table.first]
    rows = [row for _, row in table.rows[1:]]
    number = _identifiers(head, rows)
    when, remarks = _moments(head, rows), list[str]()
    if number is None or when is None:
        sentence = (
            'has no columns "Identifier" and "Last modified (submission)", nor those of another language; '
            f"its columns are {', '.join(table.first)}; download the grading worksheet of the assignment"
        )
        raise Malformed([Diagnostic(path, 1, sentence)])
    if head[when] not in MODIFIED:
        remarks.append(f"{path.name}: times are taken from its column {visible(table.first[when])}")
    found, unread = dict[str, datetime](), list[str]()
    for row in rows:
        who, text = _cell(row, number), _cell(row, when)
        moment = _moment(text)
        if moment is not None:
            found["".join(filter(str.isdigit, who))] = moment.replace(tzinfo=zone).astimezone(UTC)
        elif text not in NOTHING:
            unread.append(visible(f"{who} ({text})"))
    if unread:
        remarks.append(
            f"{path.name}: no time could be read of {len(unread)}, so none counts as said: {few(unread, 3)}; "
            "set Moodle to English, and download the worksheet again"
        )
    return Times(found, tuple(remarks))


def _identifiers(head: Sequence[str], rows: Sequence[Sequence[str]]) -> int | None:
    if IDENTIFIER in head:
        return head.index(IDENTIFIER)
    return next(
        (at for at in range(len(head)) if all(PARTICIPANT.match(_cell(row, at)) for row in rows)), None
    )


def _moments(head: Sequence[str], rows: Sequence[Sequence[str]]) -> int | None:
    """Which column says when; a due date of one's own may stand before it."""
    named = [at for at, heading in enumerate(head) if heading in MODIFIED]
    dated = [
        at
        for at, heading in enumerate(head)
        if IN_TWO_PARTS.search(heading) and any(_moment(_cell(row, at)) for row in rows)
    ]
    return next(iter((*named, *dated)), None)


def _cell(row: Sequence[str], at: int) -> str:
    return row[at].strip() if at < len(row) else ""


def _moment(text: str) -> datetime | None:
    """What a date with a clock means: `Friday, 4 December 2026, 9:03 PM`, `4. prosince 2026 21.03`, `2026年12月4日 21:03`."""
    clock = CLOCK.search(text)
    if clock is None:
        return None
    date = text[: clock.start()]
    hour, half = int(clock[1]), (clock[3] or "").lower()
    if half:
        hour = hour % 12 + (12 if half == "p" else 0)
    numbers = [int(each) for each in re.findall(r"\d+", date)]
    months = [found for word in WORD.findall(date) if (found := month(word)) is not None]
    if len(months) == 1 and len(numbers) == 2:
        day, year = sorted(numbers)
        parts = (year, months[0], day)
    elif len(numbers) == 3 and not months:
        parts = (
            (numbers[0], numbers[1], numbers[2]) if numbers[0] > 31 else (numbers[2], numbers[1], numbers[0])
        )
    else:
        return None
    try:
        return datetime(*parts, hour, int(clock[2]))
    except ValueError:
        return None
