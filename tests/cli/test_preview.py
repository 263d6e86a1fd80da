"""`corollary preview`: what is shown of a draft and found in it, what is written, and what is refused."""

from __future__ import annotations

import json
import os
import re
from html import unescape
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from corollary.cli.author_words import author_words
from corollary.cli.commands import app
from corollary.cli.draft import Draft, PlacedComplaint, found_in
from corollary.cli.local_page import edition
from corollary.cli.preview import Editor
from corollary.cli.variant_sheets import rendered_variants
from corollary.derive.item_clauses import ALLOWED, BELOW, CLAIMS
from corollary.derive.item_examples import ITEMS, ITEMS_BELOW
from corollary.derive.load import load
from corollary.problem.bank import Bank, chapter_bank, home_of_file
from corollary.problem.field_examples import ATTRIBUTES, FIELDS, GIVEN
from corollary.problem.parts_markdown import KNOWN
from corollary.problem.reader import read_problem
from corollary.problem.schema import schema

Texts = dict[Any, str]


@pytest.fixture
def bank(tmp_path) -> Bank:
    done = CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", str(tmp_path / "mine")])
    assert done.exit_code == 0, done.output
    return Bank(tmp_path / "mine")


@pytest.fixture
def problem(bank) -> Path:
    return bank.problems / "exercises" / "ride.md"


def changed(path: Path, old: str, new: str) -> str:
    text = path.read_text(encoding="utf-8")
    assert old in text
    return text.replace(old, new, 1)


def change(path: Path, old: str, new: str) -> None:
    path.write_text(changed(path, old, new), encoding="utf-8")


def words(piece: str) -> str:
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", piece)).split())


def test_twenty_variants_with_key_mistakes_and_tolerance(bank, problem):
    page = rendered_variants(bank, problem)
    assert len(re.findall(r'<section class="sheet"', page)) >= 21
    reasons = (
        "the condition <code>abs(v - w) &gt; v/5</code> does not hold</td>",
        "cannot be told from the truth</td>",
    )
    assert page.count('<tr class="redrawn">') == sum(page.count(reason) for reason in reasons)
    shown = words(page)
    assert "20 variants as students get them" in shown
    # 12 km at 15 km/h and back at 20 km/h: 48 min there, 24 km in 84 min; the mean of the speeds is 17.5 km/h = 4.8611 m/s
    own = shown.partition("Its own numbers")[2]
    assert "2880.0 s" in own
    assert "4.7619 m/s" in own
    assert re.search(r"mean of the two speeds, but you ride longer at the slower one\. 4\.8611 m/s", own)
    assert "right within 0.5 %" in own
    assert "The way is longer, and so is the time. A" in own
    assert "Worked solution" in own
    assert "ridden there at 15\N{NO-BREAK SPACE}km/h" in page  # the figure's words


def test_a_draw_that_a_mistake_meets_says_so(bank, problem):
    change(problem, "  - abs(v - w) > v/5\n", "  - d > 0\n")
    shown = words(rendered_variants(bank, problem))
    assert re.search(r"redrawn \(↻\)", shown)
    assert "cannot be told from the truth" in shown


def test_a_change_of_one_sign_in_the_same_second_is_seen(bank, problem):
    solution = bank.solution_beside(problem)
    assert "4.7619" in words(rendered_variants(bank, problem))
    first = edition(bank, problem)
    before = solution.stat()
    change(solution, "u = 2*d/(t + d/w)", "u = 2*d/(t - d/w)")
    os.utime(solution, ns=(before.st_atime_ns, before.st_mtime_ns + 1000))
    assert edition(bank, problem) != first
    assert "4.7619" not in words(rendered_variants(bank, problem))  # 24 km in 12 min


def test_every_edition_counts_programs_beside_the_solution(tmp_path):
    bank, path = home_of_file(None, "P12.14")
    assert bank.folder == chapter_bank().folder
    assert "floor.py" in edition(bank, path) or ".py" in edition(bank, path).partition(".py")[2]


def checked(bank: Bank, problem: Path, folder: Path, texts: Texts, programs: bool = False) -> dict[str, Any]:
    """What is known when the variants are shown, and the first complaints under `first`."""
    found: dict[str, Any] = {}
    for what, value in found_in(folder, Draft(bank.place, problem, texts, "en", programs)):
        found[what] = value
        if what == "complaints" and value:
            found.setdefault("first", value)
        if what == "stage" and value == "laws put back":
            break
    return found


def test_a_draft_is_shown_and_nothing_is_written(bank, problem, tmp_path):
    before = problem.read_bytes()
    text = changed(problem, "You ride a bike", "You push a cart")
    found = checked(bank, problem, tmp_path / "draft", {"problem": text})
    assert "You push a cart along a way of 12" in words(found["html"])
    assert found["complaints"] == []
    assert problem.read_bytes() == before


def test_a_program_beside_the_solution_is_linked_to_and_not_written(bank, problem, tmp_path):
    program = bank.solution_beside(problem).with_suffix(".py")
    program.write_text("def scene(d, v, w):\n    return None\n", encoding="utf-8")
    before = {path: path.read_bytes() for path in bank.folder.rglob("*") if path.is_file()}
    text = changed(bank.solution_beside(problem), "The time is", "The duration is")
    found = checked(bank, problem, tmp_path / "draft", {"solution": text}, programs=True)
    assert "The duration is the way" in words(found["html"])
    assert {path: path.read_bytes() for path in bank.folder.rglob("*") if path.is_file()} == before


@pytest.mark.parametrize(
    ("side", "old", "new", "line", "complaint"),
    [
        ("problem", "code: Q1", "cod: Q1", 2, "the front matter has no `code`"),
        ("problem", "at {{v}}, turn", "at {{V}}, turn", 22, r"\{\{V\}\} is not among the givens"),
        ("solution", "- law: Speed", "- low: Speed", 7, "an item that begins with 'low' has no place here"),
        ("solution", "v = d/t", "v = d/s", 7, "Speed: what does s mean"),
        ("solution", "`v = d/t`", "v = d/t", 7, "write one law between backticks"),
        ("solution", "## (a) t", "## (a) d", 3, "d is a given"),
        ("solution", "## (a) t", "## (a)", 7, "an item that begins with 'law' has no place here"),
        ("solution", "`v = d/t`", "`v = d*t`", 3, "part a: the answer is not in s"),
        ("problem", "floor at", "flour at", 16, "flour"),
    ],
)  # fmt: skip
def test_a_complaint_names_its_text_and_line_though_both_files_have_one_name(
    bank, problem, tmp_path, side, old, new, line, complaint
):
    path = problem if side == "problem" else bank.solution_beside(problem)
    found = checked(bank, problem, tmp_path / "draft", {side: changed(path, old, new)})
    (first, *_) = found["first"]
    assert (first.side, first.line) == (side, line)
    assert re.search(complaint, first.sentence)
    if side == "solution":
        assert "You ride a bike along a way of 12" in words(found["html"])  # what is asked is still there


def test_a_code_that_is_taken_is_complained_of(bank, problem, tmp_path):
    assert CliRunner().invoke(app, ["new", "Q2", "walk", "--bank", str(bank.folder)]).exit_code == 0
    found = checked(bank, problem, tmp_path / "draft", {"problem": changed(problem, "code: Q1", "code: Q2")})
    sentence = "walk.md has the code Q2 already; change one of them"
    assert PlacedComplaint("problem", 2, sentence) in found["complaints"]


def test_programs_put_beside_a_bank_of_texts_are_not_run_by_the_page(bank, problem, tmp_path):
    mark = tmp_path / "was_run"
    program = bank.solution_beside(problem).with_suffix(".py")
    program.write_text(f"open({str(mark)!r}, 'w')\ndef scene(d, v, w): pass\n", encoding="utf-8")
    found = checked(bank, problem, tmp_path / "draft", {}, programs=False)
    assert "does not run programs" in found["complaints"][0].sentence
    assert found["ok"] is False
    assert not mark.exists()


# What the page may ask


class NoChecker:
    """No process: these tests save and open."""


@pytest.fixture
def ask(bank, problem):
    editor = Editor(bank, problem, NoChecker())  # type: ignore[arg-type]

    def asked(what: str, **more: Any) -> dict[str, Any]:
        return json.loads(editor.answered({"ask": what, "problem": "exercises/ride", **more}))

    return asked


def test_a_text_is_saved_where_the_file_is_as_it_was_read(ask, bank, problem):
    file = ask("open")["files"]["problem"]
    text = file["text"].replace("You ride", "You push")
    saved = ask("save", files={"problem": {"text": text, "fingerprint": file["fingerprint"]}})
    assert saved["conflict"] == []
    assert problem.read_text(encoding="utf-8") == text
    assert ask("open")["files"]["problem"]["fingerprint"] == saved["files"]["problem"]["fingerprint"]
    assert not [each for each in problem.parent.iterdir() if each.name.startswith(".")]


def test_a_file_that_changed_meanwhile_is_not_written_over_nor_is_the_other_one(ask, bank, problem):
    files = ask("open")["files"]
    solution = bank.solution_beside(problem)
    change(solution, "The time is", "The duration is")
    theirs, before = solution.read_text(encoding="utf-8"), problem.read_bytes()
    mine = {
        side: {"text": each["text"] + "\n", "fingerprint": each["fingerprint"]}
        for side, each in files.items()
    }
    found = ask("save", files=mine)
    assert found["conflict"] == ["solution"]
    assert found["files"]["solution"]["text"] == theirs
    assert solution.read_text(encoding="utf-8") == theirs
    assert problem.read_bytes() == before


def test_ends_of_lines_and_rights_stay_as_they_are(ask, problem):
    problem.write_bytes(problem.read_bytes().replace(b"\n", b"\r\n"))
    problem.chmod(0o640)
    file = ask("open")["files"]["problem"]
    assert "\r" not in file["text"]
    text = file["text"].replace("You ride", "You push")
    assert ask("save", files={"problem": {**file, "text": text}})["conflict"] == []
    assert problem.read_bytes() == text.replace("\n", "\r\n").encode()
    assert problem.stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize(
    "name",
    ["../../outside", "exercises/../exercises/ride", "/etc/passwd", "exercises/ride.md", "sets/ride", "", "..", "exercises\\ride"],
)  # fmt: skip
def test_only_problems_of_the_bank_are_opened_and_written(ask, bank, name, tmp_path):
    (tmp_path / "outside.md").write_text("mine", encoding="utf-8")
    if name:
        with pytest.raises(ValueError, match="no problem of this bank"):
            ask("open", problem=name)
    with pytest.raises(ValueError, match="no problem of this bank"):
        ask("save", problem=name, files={"problem": {"text": "x", "fingerprint": ""}})
    assert (tmp_path / "outside.md").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("side", ["../problem", "/etc/passwd", "ride.py", "problem.md"])
def test_no_other_file_than_the_two_is_written(ask, bank, side):
    before = {path: path.read_bytes() for path in bank.folder.rglob("*") if path.is_file()}
    with pytest.raises(ValueError, match="only the problem and its solution"):
        ask("save", files={side: {"text": "x", "fingerprint": ""}})
    assert {path: path.read_bytes() for path in bank.folder.rglob("*") if path.is_file()} == before


def test_a_link_is_not_written_through(ask, bank, problem, tmp_path):
    outside = tmp_path / "outside.md"
    outside.write_bytes(problem.read_bytes())
    problem.unlink()
    problem.symlink_to(outside)
    file = ask("open")["files"]["problem"]
    assert "is a link" in file["locked"]
    with pytest.raises(ValueError, match="is a link"):
        ask("save", files={"problem": {"text": "x", "fingerprint": file["fingerprint"]}})
    assert outside.read_text(encoding="utf-8") != "x"
    assert problem.is_symlink()


def test_a_topic_behind_a_link_is_not_written_into(ask, bank, tmp_path):
    outside = tmp_path / "elsewhere"
    (bank.folder / "solutions" / "exercises").rename(outside)
    (bank.folder / "solutions" / "exercises").symlink_to(outside, target_is_directory=True)
    before = (outside / "ride.md").read_bytes()
    file = ask("open")["files"]["solution"]
    assert "lies behind one" in file["locked"]
    with pytest.raises(ValueError, match="lies behind one"):
        ask("save", files={"solution": {**file, "text": "x"}})
    with pytest.raises(ValueError, match="lies behind one"):
        ask("new", code="Q2", name="exercises/walk")
    assert (outside / "ride.md").read_bytes() == before
    assert not (outside / "walk.md").exists()


def test_a_bank_of_an_installed_package_is_read_only(tmp_path):
    folder = tmp_path / "site-packages" / "theirs"
    assert CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", str(folder)]).exit_code == 0
    bank = Bank(folder)
    path = bank.problems / "exercises" / "ride.md"
    editor = Editor(bank, path, NoChecker())  # type: ignore[arg-type]
    found = json.loads(editor.answered({"ask": "open", "problem": ""}))
    assert found["new"] is False
    for each in found["files"].values():
        assert "belongs to an installed package and is read only" in each["locked"]
    before = path.read_bytes()
    file = {"text": "x", "fingerprint": found["files"]["problem"]["fingerprint"]}
    wanted = {"ask": "save", "problem": "exercises/ride", "files": {"problem": file}}
    with pytest.raises(ValueError, match="installed package"):
        editor.answered(wanted)
    assert path.read_bytes() == before


def test_a_solution_in_python_is_shown_and_not_written(ask, bank, problem):
    solution = bank.solution_beside(problem)
    program = solution.with_suffix(".py")
    solution.unlink()
    program.write_text("def derive(d, v, w):\n    pass\n", encoding="utf-8")
    file = ask("open")["files"]["solution"]
    assert (file["name"], file["text"]) == ("solutions/exercises/ride.py", "def derive(d, v, w):\n    pass\n")
    assert "is a program" in file["locked"]
    with pytest.raises(ValueError, match="is a program"):
        ask("save", files={"solution": {"text": "x", "fingerprint": file["fingerprint"]}})


def test_a_file_that_is_gone_is_not_made_again(ask, problem, bank):
    solution = bank.solution_beside(problem)
    file = ask("open")["files"]["solution"]
    solution.unlink()
    with pytest.raises(ValueError, match=r"ride\.md is missing"):
        ask("save", files={"solution": file})
    assert not solution.exists()


def test_a_new_problem_is_the_one_of_corollary_new(ask, bank):
    assert ask("new", code="Q2", name="walk") == {"problem": "exercises/walk"}
    assert "code: Q2" in ask("open", problem="exercises/walk")["files"]["problem"]["text"]
    assert (bank.folder / "solutions" / "exercises" / "walk.md").is_file()
    with pytest.raises(ValueError, match="has the code Q2 already"):
        ask("new", code="q2", name="run")
    for name in ("../walk", "a/b/c", "walk.md", "/tmp/walk", "exercises/../walk", "walk"):
        with pytest.raises(ValueError, match=r"is not a valid file name|exists already"):
            ask("new", code="Q3", name=name)


# Words


def test_every_word_that_may_be_written_is_listed_with_an_example():
    listed = {each.word: each for group in author_words() for each in group.words}
    assert {f"{word}:" for word in {*ITEMS, *ITEMS_BELOW}} <= listed.keys()
    assert {word for words in ALLOWED.values() for word in words} | {*CLAIMS} == {*ITEMS}
    assert {word for words in BELOW.values() for word in words} == {*ITEMS_BELOW}
    assert {*ATTRIBUTES} == KNOWN
    fields = schema()["properties"]
    assert {*FIELDS} == {*fields}
    assert {*GIVEN} == {*fields["given"]["additionalProperties"]["properties"]}
    assert all(each.example and each.meaning for each in listed.values())


STEP = (
    "law",
    "also",
    "where",
    "reject",
    "mistake",
    "check",
    "scale",
    "letter",
    "at",
    "limit",
    "always",
    "printed",
)


@pytest.mark.parametrize("word", STEP)
def test_an_example_of_an_item_can_be_read_below_a_step(bank, problem, word):
    change(bank.solution_beside(problem), "## (c)\n", f"{ITEMS[word][1]}\n\n## (c)\n")
    assert load(bank, read_problem(problem)).branches


@pytest.mark.parametrize(
    "word",
    [
        each
        for each in FIELDS
        if each not in ("code", "title", "given", "figure", "alt", "require", "rows", "variables")
    ],
)
def test_an_example_of_a_line_of_the_front_matter_can_be_read(bank, problem, word):  # fmt: skip
    text = re.sub(rf"^{word}:.*\n(?:  .*\n)*", "", problem.read_text(encoding="utf-8"), flags=re.MULTILINE)
    problem.write_text(text.replace("title:", f"{FIELDS[word]}\ntitle:", 1), encoding="utf-8")
    assert read_problem(problem).code == "Q1"


@pytest.mark.parametrize("example", sorted(set(GIVEN.values())))
def test_an_example_of_a_given_can_be_read(bank, problem, example):
    change(problem, "given:\n", f"given:\n{example}\n")
    assert read_problem(problem).givens[0].symbol == "m"


@pytest.mark.parametrize(
    "word",
    sorted(
        KNOWN
        - {"given", "components", "rows", "columns", "function", "of", "slope", "unit", "points", "expected"}
    ),
)
def test_an_example_of_an_attribute_can_be_read(bank, problem, word):  # fmt: skip
    change(problem, '{#b .value unit="m/s" points=2 ', f'{{#b .value unit="m/s" {ATTRIBUTES[word][1]} ')
    assert read_problem(problem).part("b")


def test_an_example_of_a_variable_can_be_read(bank, problem):
    text = problem.read_text(encoding="utf-8").replace("title:", f"{FIELDS['variables']}\ntitle:", 1)
    problem.write_text(text, encoding="utf-8")
    change(problem, '{#b .value unit="m/s" points=2 ', f'{{#b .expression unit="m" {ATTRIBUTES["of"][1]} ')
    assert read_problem(problem).part("b").of == ("t",)


def test_the_preview_of_a_missing_problem_ends_with_a_sentence(tmp_path):
    done = CliRunner().invoke(app, ["preview", "nothing_of_this_name"])
    assert done.exit_code == 2
    assert "no problem is called" in done.output
