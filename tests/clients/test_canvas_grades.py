"""Canvas's own importer takes the marks that the commands write, for whom and where they are meant.

With a checkout of canvas-lms in COROLLARY_CANVAS, and a Ruby that has activesupport, its `lib/gradebook_importer.rb` is asked; what
it was given and what stood in the gradebook then is written to recorded/canvas-marks-….json, named after the file's Git blob. Without
it the same term is played, and all that would be handed to it must be what it was handed.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import os
import re
import subprocess
import zipfile
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

import pytest

from .term_with_moodle import CLASS, EXCUSED, TITLE, Person, Term, fingerprint

CHECKOUT = os.environ.get("COROLLARY_CANVAS", "")
DRIVER = Path(__file__).with_name("canvas_gradebook.rb")
RECORDS = sorted((Path(__file__).parent / "recorded").glob("canvas-marks-*.json"))

Score = float | str | None
"""A number, EX, or nothing."""

NUMBERS = {each.username: 2001 + place for place, each in enumerate(CLASS)}
NED = "Nobody, Ned"
NED_NUMBER = 2098
NOTHING, MISSING = "corollary-cyd", "corollary-zoe"
"""Who hands nothing in; who is not in Canvas in some cases."""
NAMESAKES = ("corollary-anna1", "corollary-anna2")
BEFORE: dict[str, Score] = {"corollary-ada": 1.5, NOTHING: 40.0, EXCUSED: "EX"}
"""What stood in Canvas before."""
OURS, ANOTHER = 4411, 4412
"""Assignments of Canvas's: the set's, and one with a title that begins alike."""

PLAIN: dict[str, tuple[str, ...]] = {
    "by number": (),
    "over marks": (),
    "new assignment": (),
    "somebody missing": (),
    "--round 0": ("--round", "0"),
    "--round 6": ("--round", "6"),
    "--out-of 100": ("--out-of", "100"),
}
FILLED_IN = ("gradebook", "gradebook, excused with a mark", "gradebook, somebody missing")
WITH_COMMA = "gradebook, semicolons and decimal comma"
TWO_NAMES = "gradebook, two columns of names"
NEW = (WITH_COMMA, TWO_NAMES)
"""Forms of its gradebook that Canvas did not have in 2013."""
BY_NAME = "by name"
ROSTER = "roster"


def sortable(person: Person) -> str:
    return f"{person.last}, {person.first}"


def people(case: str) -> tuple[Person, ...]:
    """Who is in Canvas's course."""
    return tuple(
        each for each in CLASS if not (case.endswith("somebody missing") and each.username == MISSING)
    )


def standing(case: str) -> dict[str, Score]:
    """The marks that Canvas has before."""
    if case != "over marks" and not case.startswith("gradebook"):
        return {}
    return {**BEFORE, EXCUSED: 30.0} if case.endswith("with a mark") else BEFORE


def expected(case: str, marks: Mapping[str, float | None]) -> dict[str, Score]:
    """What should stand in Canvas then: our marks as they are written; where there is none, nothing, or what a template had."""
    if case == "new assignment":
        return dict.fromkeys(marks)  # Canvas asks, and the answer was to ignore it
    decimals = {"--round 0": 0, "--round 6": 6}.get(case, 2)
    scale = 20 if case == "--out-of 100" else 1
    found: dict[str, Score] = {
        who: None if mark is None else int(mark * scale * 10**decimals + 0.5 + 1e-9) / 10**decimals
        for who, mark in marks.items()
    }
    if case.startswith("gradebook"):
        found[NOTHING] = BEFORE[NOTHING]
        found[EXCUSED] = None if case.endswith("with a mark") else "EX"
    unknown = (
        NAMESAKES
        if case == BY_NAME
        else ()
        if MISSING in {each.username for each in people(case)}
        else (MISSING,)
    )
    return found | dict.fromkeys(unknown)


def exported(case: str, old: bool) -> str:
    """The gradebook as Canvas exports it (lib/gradebook_exporter.rb; in 2013 `Course#gradebook_to_csv`)."""
    comma = case == WITH_COMMA
    scores = {each.username: standing(case).get(each.username) for each in people(case)}
    notes, hidden = ([], "Muted") if old else (["Notes"], "Manual Posting")
    blank = ["" for _ in notes]

    def number(score: Score) -> str:
        text = f"{score:.2f}" if isinstance(score, float) else score or ""
        return text.replace(".", ",") if comma else text

    made = io.StringIO(newline="")
    table = csv.writer(made, delimiter=";" if comma else ",", lineterminator="\n")

    def write(last: str, first: str, number: object, sis: str, login: str, *more: str) -> None:
        if case == TWO_NAMES:  # with all that Canvas can have between the names and the section
            table.writerow(
                [last, first, number, sis, login, "", "school.example.org" if login else "", *more]
            )
        else:
            table.writerow([f"{last}, {first}" if first else last, number, sis, login, *more])

    of_marks = f"{TITLE} ({OURS})", f"{TITLE} 10 ({ANOTHER})", "Current Score", "Final Score"
    if case == TWO_NAMES:
        ids = ("ID", "SIS User ID", "SIS Login ID", "Integration ID", "Root Account")
        table.writerow(["LastName", "FirstName", *ids, "Section", *notes, *of_marks])
    else:
        table.writerow(["Student", "ID", "SIS User ID", "SIS Login ID", "Section", *notes, *of_marks])
    write("", "", "", "", "", "", *blank, hidden, "", "", "")
    read_only = "(read only)"
    write("    Points Possible", "", "", "", "", "", *blank, number(5.0), number(10.0), read_only, read_only)
    for each in sorted(people(case), key=sortable):
        marks = number(scores[each.username]), number(7.25), number(72.5), number(72.5)
        write(
            each.last, each.first, NUMBERS[each.username], each.number, each.email, "Physics", *blank, *marks
        )
    if case != ROSTER:
        write(
            "Nobody", "Ned", NED_NUMBER, "S-9", "ned@example.org", "Physics", *blank, number(33.0), "", "", ""
        )
    write("Student", "Test", 2099, "", "4f3c", "Physics", *blank, "", "", "", "")
    return ("\ufeff" if comma else "") + made.getvalue()


def of_canvas(case: str) -> dict[str, Any]:
    """The course as Canvas has it."""
    students = [
        {"id": NUMBERS[each.username], "name": f"{each.first} {each.last}", "sortable_name": sortable(each),
         "sis": each.number, "login": each.email}
        for each in people(case)
    ]  # fmt: skip
    ned = {
        "id": NED_NUMBER,
        "name": "Ned Nobody",
        "sortable_name": NED,
        "sis": "S-9",
        "login": "ned@example.org",
    }
    test = {
        "id": 2099,
        "name": "Test Student",
        "sortable_name": "Student, Test",
        "sis": None,
        "login": "4f3c",
    }
    title = "Something else" if case == "new assignment" else TITLE
    ours = {"id": OURS, "title": title, "out_of": 5.0}
    another = {"id": ANOTHER, "title": f"{TITLE} 10", "out_of": 10.0}
    scores = [[NUMBERS[who], OURS, score] for who, score in standing(case).items()]
    scores += [[NUMBERS[each.username], ANOTHER, 7.25] for each in people(case)]
    return {
        "students": [*students, ned, test],
        "assignments": [ours, another],
        "notes": ["Notes"],
        "scores": [*scores, [NED_NUMBER, OURS, 33.0]],
    }


def by_names() -> str:
    """A roster that Canvas has nothing to do with."""
    made = io.StringIO(newline="")
    rows = [[each.number, each.first, each.last, each.email] for each in CLASS]
    csv.writer(made, lineterminator="\n").writerows([["id", "first_name", "last_name", "email"], *rows])
    return made.getvalue()


def graded(folder: Path, roster: str) -> Term:
    """A term as far as the marks; handed in through Canvas's archive of all submissions (lib/content_zipper.rb)."""
    folder.mkdir()
    term = Term(folder)
    term.begin(roster)
    files = term.handed_in()
    with zipfile.ZipFile(folder / "submissions.zip", "w") as archive:
        for place, each in enumerate(each for each in CLASS if each.username in files):
            name = re.sub(r"[\W_]", "", f"{each.last}{each.first}").lower()
            late = "_LATE" if each.late else ""
            member = f"{name}{late}_{NUMBERS[each.username]}_{5001 + place}_{each.file.replace(' ', '+')}"
            archive.writestr(member, files[each.username].read_bytes())
    found = term.run("collect", "week_1", "submissions.zip")
    assert len(found["accepted"]) == len(files), found
    term.grade()
    return term


def written(terms: Mapping[bool, Term], case: str, template: str | None) -> Path:
    """The file of marks that a case is about."""
    term = terms[case == BY_NAME]
    if template is None:
        return term.export("--to", "canvas-grades", *PLAIN.get(case, ()))
    term.save("template.csv", template)
    return term.export("--to", "canvas-grades", "--template", "template.csv")


def asked(importer: Path, case: str, file: Path) -> dict[str, Any]:
    """Of what the importer asks, and what stands in the gradebook then."""
    about = file.with_name("course.json")
    about.write_text(json.dumps(of_canvas(case)), encoding="utf-8")
    line = ["ruby", DRIVER, importer, about, file]
    run = subprocess.run(line, capture_output=True, encoding="utf-8", check=False)
    assert run.returncode == 0, run.stderr[-2000:]
    told = json.loads(run.stdout)
    assert "scores" in told, (case, told)
    scores = {(student, assignment): score for student, assignment, score in told["scores"]}
    others = {NUMBERS[each.username]: scores[NUMBERS[each.username], ANOTHER] for each in people(case)}
    assert set(others.values()) == {7.25}
    marks = {each.username: scores.get((NUMBERS[each.username], OURS)) for each in CLASS}
    return {"asks": told["asks"], "marks": marks, "ned": scores[NED_NUMBER, OURS]}


def cases(old: bool) -> Collection[str]:
    return (*PLAIN, BY_NAME, *FILLED_IN, *(() if old else NEW))


@pytest.mark.client
@pytest.mark.skipif(not CHECKOUT, reason="no COROLLARY_CANVAS")
def test_canvas_takes_what_we_write(tmp_path: Path) -> None:
    importer = Path(CHECKOUT) / "lib" / "gradebook_importer.rb"
    content = importer.read_bytes()
    blob = hashlib.sha1(b"blob %d\0" % len(content) + content).hexdigest()
    old = b"decimal_comma" not in content
    roster = exported(ROSTER, old)
    terms = {False: graded(tmp_path / "numbers", roster), True: graded(tmp_path / "names", by_names())}
    found: dict[str, Any] = {}
    for case in cases(old):
        template = exported(case, old) if case.startswith("gradebook") else None
        file = written(terms, case, template)
        given = {} if template is None else {"template": template}
        found[case] = {**given, "given": fingerprint(file), **asked(importer, case, file)}
    record = {
        "client": "Canvas, marks",
        "version": f"lib/gradebook_importer.rb, Git blob {blob}",
        "old": old,
        "roster": roster,
        "marks": terms[False].marks,
        "cases": found,
    }
    path = Path(__file__).parent / "recorded" / f"canvas-marks-{blob[:7]}.json"
    path.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    _as_we_meant(record)


def _as_we_meant(record: dict[str, Any]) -> None:
    assert set(record["cases"]) == set(cases(record["old"]))
    for case, each in record["cases"].items():
        assert each["marks"] == pytest.approx(expected(case, record["marks"])), case
        missing = [
            sortable(one) for one in CLASS if one not in people(case) and not case.startswith("gradebook")
        ]
        new = [TITLE] if case == "new assignment" else []
        assert each["asks"] == {"students": missing, "assignments": new}, case
        assert each["ned"] == 33, case


def read(path: Path) -> dict[str, Any]:
    return json.loads(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("path", RECORDS, ids=lambda path: path.stem)
def test_what_stood_in_canvas_is_what_we_meant(path: Path) -> None:
    record = read(path)
    _as_we_meant(record)
    assert record["marks"][NOTHING] is None
    assert record["cases"]["by number"]["marks"]["corollary-ada"] == pytest.approx(3.89)  # of 3.885


@pytest.fixture(scope="module")
def without_numbers(tmp_path_factory: pytest.TempPathFactory) -> Term:
    """A term with a roster that no record of Canvas's changes."""
    return graded(tmp_path_factory.mktemp("terms") / "names", by_names())


@pytest.mark.whole
@pytest.mark.parametrize("path", RECORDS, ids=lambda path: path.stem)
def test_canvas_would_be_given_what_it_was_given(path: Path, tmp_path: Path, without_numbers: Term) -> None:
    record = read(path)
    terms = {False: graded(tmp_path / "numbers", record["roster"]), True: without_numbers}
    assert terms[False].marks == terms[True].marks == record["marks"]
    for case, each in record["cases"].items():
        assert fingerprint(written(terms, case, each.get("template"))) == each["given"], case
