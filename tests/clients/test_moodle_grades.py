"""Moodle's own importers take the marks, sheets and pages that the commands write, and the commands take what Moodle writes.

With the folder of an installed Moodle in COROLLARY_MOODLE it is asked; what it gave, and made of what it got, is written to
recorded/moodle-marks-VERSION.json. Without it the same term is played with what Moodle gave then, and all that would be handed
to it must be what it was handed.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from .term_with_moodle import (
    EXCUSED,
    TITLE,
    Lms,
    Moodle,
    Remembered,
    Term,
    fingerprint,
    names_in,
    sha1,
)

FOLDER = os.environ.get("COROLLARY_MOODLE", "")
RECORDS = sorted((Path(__file__).parent / "recorded").glob("moodle-marks-*.json"))
NOTHING = "corollary-cyd"
"""Who hands nothing in."""
BEFORE = {"corollary-ada": 1.5, NOTHING: 40, EXCUSED: 30}
"""Marks that stood in Moodle before."""
SMALL = 4
"""What an assignment is out of, of a set that is out of 5."""

BY_NUMBER, BY_EMAIL = ("ID number", "useridnumber"), ("Email address", "useremail")
PLAIN = {
    "by ID number": (BY_NUMBER, ()),
    "by email address": (BY_EMAIL, ()),
    "over marks": (BY_NUMBER, ()),
    "decimal comma": (BY_NUMBER, ()),
    "new item": (BY_NUMBER, ()),
    "new item, blank -": (BY_NUMBER, ("--blank", "-")),
    "--round 0": (BY_NUMBER, ("--round", "0")),
    "--round 6": (BY_NUMBER, ("--round", "6")),
    "--out-of 100": (BY_NUMBER, ("--out-of", "100")),
    "--out-of 200": (BY_NUMBER, ("--out-of", "200")),
    "small assignment": (BY_NUMBER, ()),
}
FILLED_IN = ("gradebook", "gradebook, decimal comma", "worksheet", "worksheet, decimal comma")


def expected(case: str, marks: Mapping[str, float | None], version: str) -> dict[str, float | None]:
    """What should stand in Moodle: our marks as they are written; where there is none, nothing, or what a template had."""
    if case == "--out-of 200" or (case == "small assignment" and not version.startswith("4.1 ")):
        return dict.fromkeys(marks)  # nothing of the file is taken
    decimals = {"--round 0": 0, "--round 6": 6}.get(case, 2)
    scale = 20 if case == "--out-of 100" else 1
    most = SMALL if case == "small assignment" else 100  # an older Moodle cuts off what is more
    found: dict[str, float | None] = {
        who: None if mark is None else min(most, int(mark * scale * 10**decimals + 0.5 + 1e-9) / 10**decimals)
        for who, mark in marks.items()
    }
    if case in FILLED_IN:
        found[NOTHING] = BEFORE[NOTHING]
    if case.startswith("worksheet"):  # Moodle leaves a mark alone whose cell is blank there
        found[EXCUSED] = BEFORE[EXCUSED]
    return found


def through(term: Term, before: Lms, after: Lms) -> tuple[Path, dict[str, str], Path]:
    """The term as far as the marks: the archive given out, whose each collected file is, and the archive of pages."""
    sheets = term.give_out(before)
    found = term.collect(after, folders=True)
    term.grade()
    whose = {own: who for who, own in term.ids.items()}
    names = {each["file"]: whose[each["student"]] for each in found["accepted"] + found["unchanged"]}
    return sheets, names, term.export("--to", "feedback-zip", "--ids", "after.csv")


def of_marks(term: Term, case: str, template: str | None) -> Path:
    """The file of marks that a case is about."""
    if template is None:
        return term.export("--to", "moodle-grades", *PLAIN[case][1])
    term.save("template.csv", template)
    return term.export("--to", "moodle-grades", "--template", "template.csv")


def asked(term: Term, case: str) -> dict[str, Any]:
    """What was given to an assignment of its own, and what stood in the gradebook then."""
    out_of = SMALL if case == "small assignment" else 100
    lms = Moodle.opened(FOLDER, term.folder, out_of=out_of, decimal="," if "comma" in case else ".")
    of_case: dict[str, Any] = {}
    if case in FILLED_IN or case == "over marks":
        lms.told("mark", marks=BEFORE)
    if case in FILLED_IN:
        of_case["template"] = lms.gradebook() if case.startswith("gradebook") else lms.worksheet()
    file = of_marks(term, case, of_case.get("template"))
    if case.startswith("worksheet"):
        said = lms.told("import-worksheet", file=str(file))
    else:
        heading, field = PLAIN[case][0] if case in PLAIN else BY_NUMBER
        column = f"Assignment: {TITLE} (Real)" if case in FILLED_IN else TITLE
        columns = {"from": heading, "to": field, "marks": column}
        said = lms.told("import-gradebook", file=str(file), new=case.startswith("new"), **columns)
    column = "new" if case.startswith("new") else "mark"
    marks = {who: each[column] for who, each in lms.read().items()}
    lms.told("close")
    return {**of_case, "given": fingerprint(file), **said, "marks": marks}


@pytest.mark.client
@pytest.mark.skipif(not FOLDER, reason="no COROLLARY_MOODLE")
def test_moodle_takes_what_we_write_and_we_take_what_it_writes(tmp_path: Path) -> None:
    term = Term(tmp_path)
    lms = Moodle.opened(FOLDER, tmp_path)
    gradebook, worksheet = lms.gradebook(), lms.worksheet()
    term.begin(gradebook)
    ids, course = term.ids, term.folder / "course"
    sheets, names, pages = through(term, lms, lms)
    handed_in = {who for who in ids if who != NOTHING}
    archive = names_in(
        term.folder / "submissions.zip"
    )  # of Moodle 4.1 with a page for each text, though blank
    assert sorted(names) == [name for name in archive if name.endswith(".ipynb")]
    assert set(names.values()) == handed_in
    for file, who in names.items():
        came = course / "submitted" / ids[who] / "week_1" / "week_1.ipynb"
        assert came.read_bytes() == (term.folder / f"{who}.ipynb").read_bytes(), file

    for archive in (sheets, pages):
        lms.told("give-back", file=str(archive))
    for who, each in lms.read().items():
        place = Path(ids[who]) / "week_1"
        own = {"/week_1.ipynb": sha1(course / "release" / place / "week_1.ipynb")}
        if who in handed_in:
            own["/week_1-feedback.html"] = sha1(course / "feedback" / place / "week_1.html")
        assert each["files"] == own
    after = lms.worksheet()
    flat = lms.ask("submissions", folders=False)
    (term.folder / "flat.zip").write_bytes(flat)
    again = term.run("collect", "week_1", "flat.zip", "--times", "after.csv")
    assert {each["student"] for each in again["unchanged"]} == {ids[who] for who in handed_in}
    lms.told("close")

    cases = {case: asked(term, case) for case in (*PLAIN, *FILLED_IN)}
    record: dict[str, Any] = {
        "client": "Moodle, marks and files",
        "version": lms.version,
        "gradebook": gradebook,
        "worksheets": [worksheet, after],
        "names": names,
        "flat": names_in(flat),
        "marks": term.marks,
        "archives": {"given out": fingerprint(sheets), "feedback": fingerprint(pages)},
        "cases": cases,
    }
    name = f"moodle-marks-{lms.version.split()[0].rstrip('+')}.json"
    text = json.dumps(record, indent=1, ensure_ascii=False)
    (Path(__file__).parent / "recorded" / name).write_text(text + "\n", encoding="utf-8")
    assert {case: each["marks"] for case, each in cases.items()} == {
        case: pytest.approx(expected(case, record["marks"], lms.version)) for case in cases
    }


def read(path: Path) -> dict[str, Any]:
    return json.loads(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("path", RECORDS, ids=lambda path: path.stem)
def test_what_stood_in_moodles_gradebook_is_what_we_meant(path: Path) -> None:
    record = read(path)
    assert set(record["cases"]) == {*PLAIN, *FILLED_IN}
    for case, each in record["cases"].items():
        meant = expected(case, record["marks"], record["version"])
        assert each["marks"] == pytest.approx(meant), case
        assert ("refused" in each) == (case != "over marks" and not any(meant.values())), case
    assert record["marks"][NOTHING] is None
    assert record["cases"]["by ID number"]["marks"]["corollary-ada"] == pytest.approx(3.89)  # of 3.885


@pytest.mark.whole
@pytest.mark.parametrize("path", RECORDS, ids=lambda path: path.stem)
def test_moodle_would_be_given_what_it_was_given(path: Path, tmp_path: Path) -> None:
    record, term = read(path), Term(tmp_path)
    before, after = (
        Remembered(record["gradebook"], table, record["names"]) for table in record["worksheets"]
    )
    term.begin(before.gradebook())
    sheets, names, pages = through(term, before, after)
    assert names == record["names"]
    assert term.marks == record["marks"]
    assert {"given out": fingerprint(sheets), "feedback": fingerprint(pages)} == record["archives"]
    made: dict[object, str] = {}
    for case, each in record["cases"].items():
        words = each.get("template") or PLAIN[case][1]
        if words not in made:
            made[words] = fingerprint(of_marks(term, case, each.get("template")))
        assert made[words] == each["given"], case
