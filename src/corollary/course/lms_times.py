"""When something was handed in, as Moodle's grading worksheet says it: archives have the times of their download only."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import UTC, datetime, tzinfo
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.table import read_table
from corollary.records.lms_names import LmsName

# Moodle's strftimedatetime and its kin, in English; what a worksheet in another language says is read where it is in digits.
FORMS = (
    "%A, %d %B %Y, %I:%M %p", "%A, %d %B %Y, %H:%M", "%d %B %Y, %I:%M %p", "%d %B %Y, %H:%M", "%d %B %Y %H:%M",
    "%Y-%m-%d %H:%M:%S", "%Y-%m-%d %H:%M", "%d.%m.%Y, %H:%M", "%d.%m.%Y %H:%M", "%d/%m/%Y, %H:%M", "%d/%m/%Y %H:%M",
)  # fmt: skip
MODIFIED = "last modified (submission)"


@dataclass(frozen=True, slots=True)
class Times:
    """Moments by the number of a participant."""

    by_number: dict[str, datetime]

    def of(self, name: LmsName) -> datetime | None:
        return self.by_number.get(name.number) if name.lms == "moodle" else None

    def joined(self, other: Times) -> Times:
        return Times(self.by_number | other.by_number)


def read_times(path: Path, zone: tzinfo) -> Times:
    """The times of a worksheet, which are in this zone. Raises Malformed when the file is none."""
    table = read_table(path, ("identifier", MODIFIED))
    head = [cell.lower() for cell in table.first]
    if "identifier" not in head or MODIFIED not in head:
        sentence = 'has no columns "Identifier" and "Last modified (submission)"; download the grading worksheet of the assignment'
        raise Malformed([Diagnostic(path, 1, sentence)])
    number, when = head.index("identifier"), head.index(MODIFIED)
    found: dict[str, datetime] = {}
    for _, row in table.rows[1:]:
        if len(row) > max(number, when) and (moment := _moment(row[when].strip())) is not None:
            found["".join(filter(str.isdigit, row[number]))] = moment.replace(tzinfo=zone).astimezone(UTC)
    return Times(found)


def _moment(text: str) -> datetime | None:
    for form in FORMS:
        try:
            return datetime.strptime(text, form)
        except ValueError:
            continue
    return None
