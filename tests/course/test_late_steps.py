"""Lateness by steps from the set to the sheet, the marks and the feedback, and what an extension moves of it."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from zoneinfo import ZoneInfo

from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.records.files import open_course
from corollary.records.marks import feedback_place

from .changing_bank import ChangingBank, Text

STAMPS = {
    "ada": "2026-10-25 22:30",
    "ben": "2026-10-26 00:30",
    "cyd": "2026-11-03 12:00",
    "dee": "2026-10-24 12:00",
}


def test_calendar_days_are_taken_off_and_an_extension_shifts_them(tmp_path: Path) -> None:
    balls = ChangingBank(tmp_path)
    balls.write(Text())
    (balls.bank.sets / "week.md").write_text(
        "---\ntitle: A week\ndue: 2026-10-24\nlate: {daily: 10 %, last: 7 days}\nproblems: [X1.1]\n---\nBalls.\n"
    )
    balls.course.mkdir()
    (balls.course / "corollary.toml").write_text('timezone = "Europe/Berlin"\n')
    roster = tmp_path / "roster.csv"
    roster.write_text("id\n" + "\n".join(STAMPS) + "\n")

    def run(*words: object) -> None:
        line = [*map(str, words), "--course", str(balls.course)]
        done = CliRunner().invoke(app, line, catch_exceptions=False)
        assert done.exit_code == 0, done.output

    run("generate", "week", "--roster", roster, "--bank", balls.bank.folder)
    made = balls.generate(*STAMPS)
    rule = "Late work loses 10 % of its points for each calendar day. Nothing counts after Saturday 31 October 2026, 23:59"
    assert rule in made.notebooks["ada"].read_text()
    for student, stamp in STAMPS.items():
        balls.hand_in(made, student)
        moment = datetime.fromisoformat(stamp).replace(tzinfo=ZoneInfo("Europe/Berlin"))
        (made.course.notebook("submitted", student, "week").parent / "timestamp.txt").write_text(
            moment.isoformat(" ")
        )

    def pages() -> dict[str, str]:
        run("grade", "week", "--bank", balls.bank.folder, "--yes")
        return {each: feedback_place(open_course(balls.course), "week", each).read_text() for each in STAMPS}

    # The night to Sunday has 25 hours: Ada's 22:30 is 23.5 hours after the deadline, Ben's 00:30 25.5.
    found = pages()
    assert "Handed in 1 calendar day late, 10 % a day: × 0.90 (3 points became 2.7)" in found["ada"]
    assert "Handed in 2 calendar days late, 10 % a day: × 0.80 (3 points became 2.4)" in found["ben"]
    assert "the last day: nothing counts. (3 points became 0)" in found["cyd"]
    assert "late" not in found["dee"].lower().partition("<main>")[2].partition("<table")[0]
    run("extend", "ben", "week", "2026-10-25")
    run("extend", "cyd", "week", "2026-10-31")
    found = pages()
    assert "Handed in 1 calendar day late, 10 % a day: × 0.90" in found["ben"]
    assert "Handed in 3 calendar days late, 10 % a day: × 0.70" in found["cyd"]
