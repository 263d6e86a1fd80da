"""`corollary mark`: equal answers marked once, by a script, in the terminal and by the page's server, which obeys nobody else."""

from __future__ import annotations

import http.client
import io
import json
import shutil
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from corollary.cli.local_page import OnePageServer
from corollary.problem.bank import chapter_bank
from corollary.records.files import Course

from .conftest import STUDENTS, Done, grade, hand_in, run

pytestmark = pytest.mark.whole
PART = "X12_11_c"


def mark(course: Course, *words: object) -> Done:
    return run(course, "corollary", "mark", "words", "--course", ".", *words)


def points(course: Course) -> dict[str, float | None]:
    parts = grade(course).document["students"]
    return {student: one["parts"][PART].get("manual", {}).get("score") for student, one in parts.items()}


def test_a_script_lists_what_waits_and_gives_marks(marked_course: Course, tmp_path: Path) -> None:
    found = mark(marked_course, "--json").document
    (part,) = found["parts"]
    assert (part["key"], part["out_of"], len(part["rubric"])) == (PART, 2.0, 3)
    assert {name for group in part["groups"] for name in group["students"]} == {"ada", "ben"}
    assert [group["late"] for group in part["groups"] if group["students"] == ["ben"]] == [1]
    done = mark(marked_course, "--set", "ada/X12.11c=1,5", "--json")
    assert (done.status, done.document["given"]) == (0, 1), done.errors
    table = tmp_path / "marks.csv"
    table.write_text("student,part,points,comment\nben,X12.11 c,2,Very well.\n")
    assert mark(marked_course, "--from", table).status == 0
    assert mark(marked_course, "--json").document["parts"] == []
    assert points(marked_course) == {"ada": 1.5, "ben": 2.0, "cyd": None}
    page = (marked_course.place("feedback", "ben", "words") / "words.html").read_text(encoding="utf-8")
    assert "Very well." in page
    assert mark(marked_course, "--set", "ada/X12.11c=").status == 0
    assert points(marked_course)["ada"] is None


def test_a_table_comes_as_spreadsheets_save_it(marked_course: Course, tmp_path: Path) -> None:
    roster = marked_course.folder / ".corollary" / "roster.csv"
    first, *rest = roster.read_text(encoding="utf-8").splitlines()
    numbers = [f"{line},{number}" for number, line in enumerate(rest, start=2001)]
    roster.write_text("\n".join([f"{first},Number", *numbers]) + "\n", encoding="utf-8")
    table = tmp_path / "marks.csv"
    table.write_bytes("Student;Part;Points;Comment\r\n2001;X12.11c;1,5;Schön, aber kurz\r\n".encode("cp1252"))
    done = mark(marked_course, "--from", table, "--set", "2002/X12.11c=0,5")
    assert done.status == 0, done.errors
    assert points(marked_course) == {"ada": 1.5, "ben": 0.5, "cyd": None}
    page = (marked_course.place("feedback", "ada", "words") / "words.html").read_text(encoding="utf-8")
    assert "Schön, aber kurz" in page
    table.write_text("student,part,points\nada,X12.11c,1,5\n")
    done = mark(marked_course, "--from", table)
    assert done.status == 2
    assert "marks.csv:2: has 4 cells under 3 headings" in done.errors
    table.write_text("student,part\nada,X12.11c\n")
    assert "the columns points are missing" in mark(marked_course, "--from", table).errors
    table.write_text("student,part,points\nada,X12.11c\n")
    assert "has 2 cells under 3 headings" in mark(marked_course, "--from", table).errors
    for row, sentence in (
        ("ada,X12.11c,7", "marks.csv:3: X12_11_c earns from 0 to 2 points, not 7; no mark was given"),
        ("ada,X12.11z,1", "marks.csv:3: words has no part X12.11z; it has "),
        ("adda,X12.11c,1", "marks.csv:3: no submission of adda is graded (did you mean ada?); grade first"),
    ):
        table.write_text(f"student,part,points\nben,X12.11c,2\n{row}\n")
        done = mark(marked_course, "--from", table)
        assert (done.status, sentence in done.errors) == (2, True), done.errors
    assert "--set ada/X12.11c=7: X12_11_c earns" in mark(marked_course, "--set", "ada/X12.11c=7").errors
    assert points(marked_course) == {"ada": 1.5, "ben": 0.5, "cyd": None}


def test_a_part_that_was_taken_out_since_is_marked_as_it_was_handed_out(
    marked_course: Course, tmp_path: Path
) -> None:
    bank, chapter = tmp_path / "bank", chapter_bank().folder
    for file in ("problems/collisions/stopping_a_ball.md", "solutions/collisions/stopping_a_ball.md"):
        (bank / file).parent.mkdir(parents=True)
        shutil.copy(chapter / file, bank / file)
    problem = bank / "problems/collisions/stopping_a_ball.md"
    text = problem.read_text(encoding="utf-8")
    problem.write_text(text[: text.index("## Explain")], encoding="utf-8")
    solution = bank / "solutions/collisions/stopping_a_ball.md"
    text = solution.read_text(encoding="utf-8")
    before, _, rest = text.partition("## (c)\n")
    assert "rubric:" in rest
    assert "## " not in rest
    solution.write_text(before, encoding="utf-8")
    origin = marked_course.folder / ".corollary/origin/words.json"
    origin.write_text(json.dumps(json.loads(origin.read_text()) | {"bank": str(bank)}))
    done = grade(marked_course, "--yes")
    assert done.status == 0, done.errors
    (part,) = mark(marked_course, "--json").document["parts"]
    assert (part["key"], part["problem"], part["part"]) == (PART, "X12.11", "c")
    done = mark(marked_course, "--set", "ada/X12.11c=1.5")
    assert done.status == 0, done.errors
    assert points(marked_course)["ada"] == 1.5


@pytest.mark.parametrize(
    ("words", "why"),
    [
        ("ada/X12.11c=3", "from 0 to 2 points, not 3; no mark was given"),
        ("zoe/X12.11c=1", "no submission of zoe is graded"),
        ("adda/X12.11c=1", "no submission of adda is graded (did you mean ada?)"),
        ("ada/X99=1", "has no part X99"),
        ("ada=1", "write it as STUDENT/PART=POINTS"),
        ("ada/X12.11c=two", "not a number of points"),
    ],
)
def test_what_cannot_be_given_is_said(marked_course: Course, words: str, why: str) -> None:
    done = mark(marked_course, "--set", words)
    assert done.status == 2
    assert why in done.errors


def test_with_all_the_mark_of_the_program_is_seen_and_tells_equal_texts_apart(marked_course: Course) -> None:
    """The same number is right for one student's numbers and wrong for another's: they are no group."""
    ada = next(
        group["answer"]
        for part in mark(marked_course, "--all", "--json").document["parts"]
        if part["key"] == "X12_11_b"
        for group in part["groups"]
        if "ada" in group["students"]
    )
    hand_in(marked_course, STUDENTS[1], X12_11_b_answer=ada[0])
    assert grade(marked_course).status == 0
    parts = mark(marked_course, "--all", "--json").document["parts"]
    groups = {
        student: group
        for part in parts
        if part["key"] == "X12_11_b"
        for group in part["groups"]
        for student in group["students"]
    }
    assert groups["ada"]["answer"] == groups["ben"]["answer"]
    assert groups["ada"]["students"] == ["ada"]
    assert groups["ada"]["why"].startswith("Marked by the program: right, ")
    assert groups["ben"]["why"].startswith("Marked by the program: ")
    assert groups["ben"]["why"] != groups["ada"]["why"]


def test_equal_answers_are_marked_once_in_the_terminal(
    marked_course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    for student in STUDENTS[:2]:
        hand_in(
            marked_course,
            student,
            **{PART: "It  moves.\x1b[2J" if student.id == "ada" else "it moves.\x1b[2J"},
        )
    assert grade(marked_course).status == 0
    lines = iter(["nine", "9", "r13 Nearly."])
    monkeypatch.setattr("builtins.input", lambda prompt: next(lines))
    done = mark(marked_course, "--terminal")
    assert done.status == 0, done.errors
    assert "given by 2 students, 1 late" in done.out
    assert "\x1b" not in done.out
    assert points(marked_course) == {"ada": 1.33, "ben": 1.33, "cyd": None}


def test_the_end_of_the_input_is_said_and_what_was_given_is_kept(
    marked_course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("1 Well argued.\n"))
    done = mark(marked_course, "--terminal")
    assert (done.status, done.errors) == (0, "")
    assert done.out.endswith("\nthe input ended: 1 mark given and saved; the other answers still wait\n")
    assert sorted(filter(None, points(marked_course).values())) == [1.0]


def test_json_has_what_was_written_to_the_letter(marked_course: Course) -> None:
    written = "If <b>v</b> < 0, see [this](https://example.org)<script>alert(1)</script>"
    hand_in(marked_course, STUDENTS[0], **{PART: written})
    assert grade(marked_course).status == 0
    (part,) = mark(marked_course, "--json").document["parts"]
    assert [group["answer"] for group in part["groups"] if group["students"] == ["ada"]] == [[written]]
    notebook = json.loads(marked_course.notebook("autograded", "ada", "words").read_text(encoding="utf-8"))
    (cell,) = [cell for cell in notebook["cells"] if cell["id"] == PART]
    assert "<script" not in "".join(cell["source"])


@pytest.fixture
def received() -> list[dict]:
    return []


@pytest.fixture
def server(received: list[dict]) -> Iterator[OnePageServer]:
    def receive(posted: dict) -> None:
        if "group" not in posted:
            raise ValueError("which answer?")
        received.append(posted)

    with OnePageServer(lambda: "<p>the page</p>", receive) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield server
        server.shutdown()
        thread.join()


Ask = Callable[..., tuple[int, str]]


@pytest.fixture
def ask(server: OnePageServer) -> Ask:
    def asked(method: str, path: str, body: str = "", **headers: str) -> tuple[int, str]:
        connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=20)
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        connection.request(method, path, body or None, named)
        response = connection.getresponse()
        found = response.status, response.read().decode()
        connection.close()
        return found

    return asked


def test_only_the_page_itself_gives_marks(server: OnePageServer, ask: Ask, received: list[dict]) -> None:
    home, mark = f"/{server.token}/", json.dumps({"group": "a0", "points": 1})
    assert ask("GET", home) == (200, "<p>the page</p>")
    assert ask("GET", "/")[0] == 404
    assert ask("GET", home, Host="evil.example")[0] == 404, "a name that is made to point here"
    assert ask("POST", home + "give", mark, Content_Type="text/plain")[0] == 403, "a form of another site"
    assert (
        ask("POST", home + "give", mark, Content_Type="application/json", Origin="http://evil.example")[0]
        == 403
    )
    assert ask("POST", "/guess/give", mark, Content_Type="application/json")[0] == 404
    assert received == []
    assert ask("POST", home + "give", "[1]", Content_Type="application/json")[0] == 400
    assert ask("POST", home + "give", "{}", Content_Type="application/json") == (400, "which answer?")
    own = f"http://127.0.0.1:{server.server_port}"
    assert ask("POST", home + "give", mark, Content_Type="application/json", Origin=own) == (200, "saved")
    assert received == [{"group": "a0", "points": 1}]
