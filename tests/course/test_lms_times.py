"""Times of Moodle's grading worksheet in the languages that it is downloaded in, held against dates as the CLDR writes them."""

from __future__ import annotations

import unicodedata
from datetime import UTC, datetime
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest
from babel import Locale
from babel.dates import format_datetime

from corollary.course.hand_in_time import NAMES, month, read_times
from corollary.problem.diagnostic import Malformed
from corollary.records.lms_names import LmsName

OSLO = ZoneInfo("Europe/Oslo")


def worksheet(path: Path, *times: str, head: str = "Identifier;Last modified (submission)") -> Path:
    lines = [f'Participant {number};"{text}"' for number, text in enumerate(times, start=171)]
    path.write_text("\n".join([head, *lines]) + "\n", encoding="utf-8")
    return path


def read(path: Path) -> list[datetime | None]:
    found = read_times(path, OSLO)
    return [
        found.of(LmsName("moodle", "", str(number), ""))
        for number in range(171, 171 + len(path.read_text("utf-8").splitlines()) - 1)
    ]


@pytest.mark.parametrize("language", sorted(NAMES))
def test_the_names_are_those_of_the_cldr(language: str) -> None:
    for form in ("format", "stand-alone"):
        for number, name in Locale.parse(language).months[form]["wide"].items():
            last = name.replace("’", " ").split()[-1]  # Catalan's « d’abril »
            assert month(last) == month(last.capitalize()) == number
    assert {unicodedata.normalize("NFC", name) for names in NAMES[language] for name in names.split()} == {
        name for names in NAMES[language] for name in names.split()
    }


@pytest.mark.parametrize("language", sorted(NAMES))
@pytest.mark.parametrize(
    "pattern", ["EEEE, d MMMM y, HH:mm", "d LLLL y, HH:mm", "EEEE d. MMMM y HH.mm", "y. MMMM d., EEEE, H:mm"]
)
def test_a_date_in_words(language: str, pattern: str, tmp_path: Path) -> None:
    """As Moodle's language packs write one (`strftimedaydatetime`), each month and each weekday."""
    moments = [datetime(2026, number, 3 + number, 21, 3) for number in range(1, 13)]
    texts = [format_datetime(each, pattern, locale=language) for each in moments]
    assert read(worksheet(tmp_path / "grades.csv", *texts)) == [
        each.replace(tzinfo=OSLO).astimezone(UTC) for each in moments
    ]


@pytest.mark.parametrize(
    "text",
    [
        "Friday, 4 December 2026, 9:03 PM",
        "Friday, December 4, 2026, 9:03 pm",
        "viernes, 4 de diciembre de 2026, 21:03",
        "viernes, 4 de diciembre de 2026, 9:03 p. m.",
        "sexta-feira, 4 de dezembro de 2026 às 21:03",
        "vendredi 4 décembre 2026 à 21h03",
        "divendres, 4 de desembre 2026, 21:03",
        "04.12.2026, 21:03",
        "04/12/2026 21:03",
        "2026-12-04 21:03:00",
        "2026年12月4日(金曜日) 21:03",
    ],
)  # fmt: skip
def test_one_evening_in_many_words(text: str, tmp_path: Path) -> None:
    assert read(worksheet(tmp_path / "grades.csv", text)) == [datetime(2026, 12, 4, 20, 3, tzinfo=UTC)]


@pytest.mark.parametrize(("text", "hour"), [("12:05 AM", 23), ("12:05 PM", 11), ("1:05 AM", 0)])
def test_noon_and_midnight(text: str, hour: int, tmp_path: Path) -> None:
    (found,) = read(worksheet(tmp_path / "grades.csv", f"Friday, 4 December 2026, {text}"))
    assert found is not None
    assert found.hour == hour


@pytest.mark.parametrize(
    "text", ["soon", "4 Smarch 2026, 21:03", "31 February 2026, 21:03", "4 December 2026", "4 December 2026, 25:03", "21:03", "1 2 21:03"]
)  # fmt: skip
def test_what_cannot_be_read_is_said_and_none_is_no_complaint(text: str, tmp_path: Path) -> None:
    found = read_times(worksheet(tmp_path / "grades.csv", "4 December 2026, 21:03", text, "-", ""), OSLO)
    assert list(found.by_number) == ["171"]
    (remark,) = found.remarks
    assert remark.startswith(
        f"grades.csv: no time could be read of 1, so none counts as said: Participant 172 ({text})"
    )


GERMAN = "ID,Vollständiger Name,E-Mail-Adresse,Status,Fällig am,Bewertung,Zuletzt geändert (Abgabe),Zuletzt geändert (Bewertung)"
JAPANESE = "識別子,氏名,メールアドレス,ステータス,期限,評点,最終更新日時 (提出),最終更新日時 (評定)"


@pytest.mark.parametrize(("head", "said"), [(GERMAN, 0), (JAPANESE, 1)])
def test_a_worksheet_in_another_language(head: str, said: int, tmp_path: Path) -> None:
    """The column of the submission, and not a due date of one's own nor when it was graded."""
    path = tmp_path / "grades.csv"
    path.write_text(
        f'{head}\nTeilnehmer/in171,Ada Lovelace,ada@uio.no,Abgegeben,"1. Dezember 2026, 23:00",,'
        '"Freitag, 4. Dezember 2026, 21:03","Samstag, 5. Dezember 2026, 9:00"\n'
        "Teilnehmer/in172,Ben Bool,ben@uio.no,Keine Abgabe,-,,-,-\n",
        encoding="utf-8",
    )
    found = read_times(path, OSLO)
    assert found.by_number == {"171": datetime(2026, 12, 4, 20, 3, tzinfo=UTC)}
    assert len(found.remarks) == said
    assert all("times are taken from its column 最終更新日時 (提出)" in each for each in found.remarks)


def test_a_table_that_is_no_worksheet_is_refused_with_its_columns(tmp_path: Path) -> None:
    path = tmp_path / "grades.csv"
    path.write_text("Name,Note\nAda,1\n")
    with pytest.raises(Malformed, match="its columns are Name, Note; download the grading worksheet"):
        read_times(path, OSLO)


def test_of_an_hour_that_comes_twice_the_earlier_is_meant(tmp_path: Path) -> None:
    """The worksheet does not say which; nobody is made late by it."""
    assert read(worksheet(tmp_path / "grades.csv", "25 October 2026, 02:30")) == [
        datetime(2026, 10, 25, 0, 30, tzinfo=UTC)
    ]
