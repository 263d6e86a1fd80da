"""Times of hand-in: as Moodle's grading worksheet says them in its languages, as the file does, or a guess that makes nobody late."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, tzinfo
from itertools import pairwise
from pathlib import Path

from corollary.course.owner import Found
from corollary.messages import few, visible
from corollary.problem.csv_table import read_table
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.records.deadlines import Deadlines
from corollary.records.lms_names import LmsName
from corollary.records.submissions import GUESSED, WORKSHEET, writable
from corollary.sandbox.archive import Member

# By language, from January on: within a date, then by itself where that is another form. Croatian is not here: its October is
# November in Polish and Czech.
NAMES: dict[str, tuple[str, ...]] = {
    "ca": ("gener febrer març abril maig juny juliol agost setembre octubre novembre desembre",),
    "cs": (
        "ledna února března dubna května června července srpna září října listopadu prosince",
        "leden únor březen duben květen červen červenec srpen září říjen listopad prosinec",
    ),
    "da": ("januar februar marts april maj juni juli august september oktober november december",),
    "de": ("januar februar märz april mai juni juli august september oktober november dezember",),
    "el": (
        "ιανουαρίου φεβρουαρίου μαρτίου απριλίου μαΐου ιουνίου ιουλίου αυγούστου σεπτεμβρίου οκτωβρίου νοεμβρίου δεκεμβρίου",
        "ιανουάριοσ φεβρουάριοσ μάρτιοσ απρίλιοσ μάιοσ ιούνιοσ ιούλιοσ αύγουστοσ σεπτέμβριοσ οκτώβριοσ νοέμβριοσ δεκέμβριοσ",
    ),
    "en": ("january february march april may june july august september october november december",),
    "es": ("enero febrero marzo abril mayo junio julio agosto septiembre octubre noviembre diciembre",),
    "fi": (
        "tammikuuta helmikuuta maaliskuuta huhtikuuta toukokuuta kesäkuuta heinäkuuta elokuuta syyskuuta lokakuuta marraskuuta joulukuuta",
        "tammikuu helmikuu maaliskuu huhtikuu toukokuu kesäkuu heinäkuu elokuu syyskuu lokakuu marraskuu joulukuu",
    ),
    "fr": ("janvier février mars avril mai juin juillet août septembre octobre novembre décembre",),
    "hu": ("január február március április május június július augusztus szeptember október november december",),
    "it": ("gennaio febbraio marzo aprile maggio giugno luglio agosto settembre ottobre novembre dicembre",),
    "nb": ("januar februar mars april mai juni juli august september oktober november desember",),
    "nl": ("januari februari maart april mei juni juli augustus september oktober november december",),
    "nn": ("januar februar mars april mai juni juli august september oktober november desember",),
    "pl": (
        "stycznia lutego marca kwietnia maja czerwca lipca sierpnia września października listopada grudnia",
        "styczeń luty marzec kwiecień maj czerwiec lipiec sierpień wrzesień październik listopad grudzień",
    ),
    "pt": ("janeiro fevereiro março abril maio junho julho agosto setembro outubro novembro dezembro",),
    "ro": ("ianuarie februarie martie aprilie mai iunie iulie august septembrie octombrie noiembrie decembrie",),
    "ru": (
        "января февраля марта апреля мая июня июля августа сентября октября ноября декабря",
        "январь февраль март апрель май июнь июль август сентябрь октябрь ноябрь декабрь",
    ),
    "sk": (
        "januára februára marca apríla mája júna júla augusta septembra októbra novembra decembra",
        "január február marec apríl máj jún júl august september október november december",
    ),
    "sl": ("januar februar marec april maj junij julij avgust september oktober november december",),
    "sv": ("januari februari mars april maj juni juli augusti september oktober november december",),
    "tr": ("ocak şubat mart nisan mayıs haziran temmuz ağustos eylül ekim kasım aralık",),
    "uk": (
        "січня лютого березня квітня травня червня липня серпня вересня жовтня листопада грудня",
        "січень лютий березень квітень травень червень липень серпень вересень жовтень листопад грудень",
    ),
}  # fmt: skip
NUMBERS = {
    name: number
    for forms in NAMES.values()
    for form in forms
    for number, name in enumerate(form.split(), start=1)
}


def month(word: str) -> int | None:
    """The number of the month that a word names, in any of the languages; None when it names none."""
    return NUMBERS.get(unicodedata.normalize("NFC", word.casefold()))


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


ONE_GO = 300.0  # seconds from one file to the next that an LMS writes: times that lie closer together are those of a download
UNPACKED = "the folder"  # of what an LMS gave, which has the times of the archive or of unpacking it


def dated(
    met: Iterable[Found], times: Times, zone: tzinfo, deadlines: Deadlines, now: datetime
) -> tuple[list[Found], list[str]]:
    """When each was handed in. An archive of an LMS has the times of its download: they make nobody late."""
    met = list(met)
    spans: dict[str, list[datetime]] = {}
    for each in met:
        if each.lms and (when := _own_time(each.member, zone)):
            spans.setdefault(each.member.archive or UNPACKED, []).append(when)
    downloaded = {archive: max(all_) for archive, all_ in spans.items() if _in_one_go(sorted(all_))}
    found, guessed = list[Found](), set[str]()
    for each in met:
        # In UTC: an hour that a clock shows twice compares as neither of its two moments.
        due = deadlines.of(each.student)
        due = None if due is None else due.astimezone(UTC)
        when = times.of(each.lms) if each.lms else None
        archive = each.member.archive or UNPACKED
        written = downloaded.get(archive) if each.lms else None
        bound, source = min(written or _own_time(each.member, zone) or now, now), WORKSHEET
        if when is None:
            when = bound
            says_in_time = each.lms is not None and each.lms.late is False
            unsaid = each.lms is not None and each.lms.late is None and written is not None
            source = GUESSED if says_in_time or unsaid or each.member.modified is None else ""
            if due is not None and when > due and source == GUESSED:
                when = due
                guessed |= {archive} if not says_in_time else set()
        found.append(replace(each, when=when, time=source, latest=bound))
    remarks = [
        f"{writable(archive)} does not say when anything was handed in: everything counts as in time; "
        "--times FILE (Moodle's grading worksheet) says who was late"
        for archive in sorted(guessed)
    ]
    return found, remarks


def _in_one_go(times: Sequence[datetime]) -> bool:
    """Whether times, in their order, are those of one download; that of a large class goes on for longer."""
    return all((after - before).total_seconds() <= ONE_GO for before, after in pairwise(times))


def _own_time(member: Member, zone: tzinfo) -> datetime | None:
    when = member.modified
    return when if when is None or when.tzinfo is not None else when.replace(tzinfo=zone).astimezone(UTC)
