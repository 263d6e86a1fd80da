"""Sheets on paper: what stands on them, whose they are, and that no truth comes along."""

from __future__ import annotations

import re
import runpy
import zlib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests import forked
from tests.pdf_text import pages, right_ends, text_of

from corollary.grading.solutions import Solutions
from corollary.messages import language
from corollary.notebook.worksheet import SheetPlan, exercise
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.problem.variant import at, chapter
from corollary.render.exports import target
from corollary.render.paper.print_run import PrintRun
from corollary.render.paper.sheet import (
    PaperSheet,
    code_svg,
    sheet_address,
    typst_sheet,
)
from corollary.render.paper.typst import CannotTypeset, pdf, typst_formula, typst_text, words_of

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))
ADA = Student("ada", "Ada", "Lövelace-Ødegård")


def page(body: str) -> bytes:
    return pdf([f'#sheet("1", [], ("", "", ""))[\n{body}\n]'], "Title")


def catalogue_of(file: bytes) -> bytes:
    """What a PDF says of itself: its objects, unpacked."""
    packed = re.findall(rb"/Type ?/ObjStm.*?stream\r?\n(.*?)\r?\nendstream", file, re.DOTALL)
    return file + b"".join(map(zlib.decompress, packed))


@pytest.fixture(scope="module")
def run() -> PrintRun:
    bank = chapter_bank()
    found = find_set(bank, "momentum_1")
    sheets = [
        PaperSheet(SheetPlan(found, owner, tuple(at(problem, index) for problem in found.problems)))
        for index, owner in ((7, ADA), (11, Student("bo")))
    ]
    return PrintRun(found, sheets, Solutions(bank), formulas=True)


def printed(run: PrintRun, at: int) -> dict[str, bytes]:
    """The files of one sheet."""
    return run.printed(run.sheets[at], run.pages(run.sheets[at]))


FORMULAS = [
    r"\left(\frac{a}{b}\right)^{2} = 9{,}8\,\mathrm{m/s^{2}}",
    r"\left|\delta\right|^{\frac{3}{2}}",
    r"\dot{m}\vec{v}_B \ddot{x} \overline{ab} \hat{n} \sqrt[3]{2} \sum_{i=1}^N x_i \lim_{x \to 0} f",
    r"F_0\left[-\frac{T}{\pi}\cos\frac{\pi t}{T}\right]_0^T",
    r"\begin{cases} a & b \\ c & d\end{cases} \begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix}",
    r"e_{\mathrm{wall}}, x_{} ; \text{a \# $ ] \" b} 50\,\% \quad 20.0\N{NO-BREAK SPACE}m/s".replace(
        r"\N{NO-BREAK SPACE}", "\N{NO-BREAK SPACE}"
    ),
    r"\frac{",
    "#panic()",
]


@pytest.mark.parametrize("latex", FORMULAS)
@pytest.mark.parametrize("display", [False, True])
def test_every_formula_is_set_and_has_words(latex: str, display: bool):
    assert page(typst_formula(latex, display=display)).startswith(b"%PDF-")


def test_a_decimal_comma_is_one_number_and_a_unit_stands_upright():
    assert '#"9";class("normal",\\,)#"8";' in typst_formula("9{,}8")
    assert 'upright(#"kg";)' in typst_formula(r"3\,\mathrm{kg}")


def test_what_is_no_latex_is_shown_as_it_was_written():
    assert typst_formula(r"\frac{") == r'#raw("\\frac{");'


@settings(max_examples=25)
@given(st.text(st.characters(exclude_categories=["Cs", "Cc", "Cf"], max_codepoint=0x17F), max_size=40))
def test_no_name_and_no_text_is_markup(text: str):
    """Whatever a student is called, and whatever stands in a statement: nothing in it is obeyed."""
    assert page(f"{words_of(text)}\n\n{typst_text(text)}").startswith(b"%PDF-")


def test_a_letter_that_no_font_has_is_named():
    with pytest.raises(CannotTypeset, match="no font on this machine has a character of the text"):
        page(words_of("Ada \u0378"))


def test_a_name_that_no_font_has_costs_nobody_else_the_paper(tmp_path: Path):
    """Of nine students, for whom more processes print, and in a process of its own: Typst's threads do not survive a fork."""
    (tmp_path / "one.md").write_text("---\ntitle: One\nproblems: [X12.5]\n---\n")
    others = "".join(f"s{n},Student,Number{n}\n" for n in range(8))
    (tmp_path / "roster.csv").write_text(
        f"id,first_name,last_name\nada,Ada,\u0378\n{others}", encoding="utf-8"
    )
    for words in (
        ("generate", "one.md", "--roster", "roster.csv", "--course", "course"),
        ("export", "one", "--to", "pdf", "--course", "course", "-o", "paper"),
    ):
        done = forked.run(
            [forked.COMMAND, *words], cwd=tmp_path, capture_output=True, encoding="utf-8", timeout=100
        )
        assert done.returncode == 0, done.stderr
    assert "(ada): the id stands on the sheet in the place of the name" in done.stderr
    sheets = sorted(each.name for each in (tmp_path / "paper").glob("*.pdf"))
    assert len(sheets) == 10
    assert "one-ada.pdf" in sheets


MARKDOWN = """\
Two *words* and `code "#x"`, $x^2$.

1. one
2. two
   - inner $\\frac{a}{b}$

> said

| a | b |
|---|---|
| $1$ | *2* |

```python
print("#let x = 1")
```

$$\\int_0^1 x \\,\\mathrm{d}x$$
"""


def test_markdown_keeps_its_form():
    made = typst_text(MARKDOWN)
    for piece in (
        "#emph[",
        "#enum(start: 1",
        "#list(",
        "#quote(block: true)",
        "#table(columns: 2",
        "block: true)",
    ):
        assert piece in made
    assert page(made)


def test_a_sheet_has_its_owner_its_numbers_and_a_code(run: PrintRun):
    made = typst_sheet(run.sheets[0])
    assert "Ada Lövelace-Ødegård (ada)" in made
    assert "corollary:momentum_1?student=ada" in made
    for asked in run.sheets[0].worksheet.exercises:
        number = re.search(r"\d+\.\d+", asked.statement)
        assert number
        assert number[0] in made
    assert "#lines-for(" not in made
    form = typst_sheet(PaperSheet(run.sheets[0].plan, "B"))
    assert "corollary:momentum_1?form=B" in form
    assert "Ada" not in form
    assert "#lines-for(" in form


def test_no_answer_and_no_word_of_a_solution_is_on_a_sheet(run: PrintRun):
    """Neither a value of the key, to four figures, nor a sentence about a mistake, nor what a solution says."""
    for sheet in run.sheets:
        made = typst_sheet(sheet, run.formula_sheet())
        known = 0
        for asked in sheet.worksheet.exercises:
            key = run.solutions.key(asked.variant)
            for find in key.solution.unknowns:
                assert find.statement.because not in made
                assert not any(mistake.text in made for mistake in find.mistakes)
            for name, truth in key.truths.items():
                unit = asked.problem.part(name).unit
                texts = {f"{unit.from_si(value):.4g}" for value in truth.values}
                known += len(texts)
                assert not {text for text in texts if len(text.strip("-0.")) >= 4 and text in made}
        assert known > 20


def test_each_answer_has_the_room_it_takes(run: PrintRun):
    made = typst_sheet(run.sheets[0])
    of = {
        problem.code: typst_sheet(PaperSheet(_alone(run, problem.code)))
        for problem in run.problem_set.problems
    }
    assert of["X12.5"].count("#answers(") == 4
    assert of["X12.7"].count("field(") >= 4
    assert "#squared(" in of["P12.14"]
    assert "Write the program by hand: a function " in of["P12.14"]
    assert "#ruled(" in of["P12.14"]
    assert "#options(" in made or not any(prompt.options for prompt in run.sheets[0].worksheet.prompts)
    choice = chapter(next(each for each in chapter_bank() if each.code == "S12.2"))
    boxes = typst_sheet(PaperSheet(SheetPlan(run.problem_set, ADA, (choice,))))
    assert boxes.count('[#"A";]') == sum(bool(prompt.options) for prompt in exercise(choice).prompts)


def _alone(run: PrintRun, code: str) -> SheetPlan:
    whole = run.sheets[0].plan
    return SheetPlan(
        whole.problem_set, ADA, tuple(each for each in whole.variants if each.problem.code == code)
    )


def test_the_formula_sheet_has_general_laws_and_no_step_of_a_solution(run: PrintRun):
    made = run.formula_sheet()
    assert "Conservation of momentum" in made
    assert "Momentum" in made
    assert not re.search(r"X12|P12", made)
    assert made.count("Geometry of the rope") == 0


def test_files_are_tagged_and_say_language_and_title(run: PrintRun):
    with language("de"):
        file = printed(run, 0)["momentum_1-ada.pdf"]
    about = catalogue_of(file)
    assert re.search(rb"/Lang ?\(de", about)
    assert b"/StructTreeRoot" in about
    assert b"pdfuaid" in about
    assert "Ødegård".encode("utf-16-be") in about or "Ødegård".encode() in about


def test_the_same_run_gives_the_same_bytes(run: PrintRun):
    first, again = (printed(run, 1) for _ in range(2))
    assert first == again
    assert set(first) == {"momentum_1-bo.pdf", "keys/momentum_1-bo-key.pdf"}


def test_a_code_can_be_told_from_another(run: PrintRun):
    assert sheet_address("week 1", ADA, "") == "corollary:week%201?student=ada"
    assert sheet_address("week1", Student(""), "") == "corollary:week1"
    assert code_svg("corollary:a") != code_svg("corollary:b")


def test_what_typst_refuses_is_a_sentence():
    with pytest.raises(CannotTypeset, match="Title cannot be set on paper: PDF/UA-1 error: missing alt text"):
        page("#image(bytes(\"<svg xmlns='http://www.w3.org/2000/svg' width='1' height='1'/>\"))")


def test_one_problem_with_and_without_its_solution():
    write = target("pdf").exercise
    assert write is not None
    asked = exercise(chapter(next(each for each in chapter_bank() if each.code == "X12.5")))
    assert len(write(asked, ADA, "### (a) One\n\nBecause $p = mv$.")) != len(write(asked, ADA, ""))


def test_the_title_of_a_part_and_its_points_are_words_apart():
    said = catalogue_of(page("= Set\n\n== One\n\n#part([Mean force], [2 points])"))
    assert b"(Mean force 2 points)" in said


def test_a_question_stands_with_its_lines_and_three_lines_stand_together():
    """Where a page ends among them; the title had stood alone at its foot, and one line on the next page."""

    def page_of(word: str, above: float) -> int:
        body = f"= Set\n\nAll.\n\n#v({above}cm)\n\n#asked[== Why?]\n\n#ruled(9)\n\nEnd"
        return next(at for at, text in enumerate(pages(page(body))) if word in text)

    assert (page_of("Why?", 12), page_of("End", 12)) == (0, 0)
    assert (page_of("Why?", 18), page_of("End", 18)) == (0, 1)
    assert page_of("Why?", 22.3) == 1, "there is room for the title and one line"


def test_no_line_of_a_marking_scheme_reaches_into_another():
    """Two lines of fractions of fractions are as high as both."""
    tall = typst_formula(r"\frac{\sqrt{\frac{a}{b}}^2}{\frac{c}{d}}")
    both = f"measure(items([{tall}#linebreak(){tall}])).height"
    page(f"#context assert({both} >= 2 * measure([#set par(leading: 0pt);{tall}]).height)")


def test_another_program_reads_the_students_numbers_pages_and_no_key(run: PrintRun):
    sheet = run.sheets[0]
    files = printed(run, 0)
    found, key = pages(files["momentum_1-ada.pdf"]), text_of(files["keys/momentum_1-ada-key.pdf"])
    count, text = len(found), "\n".join(found)
    assert f"{count} of {count}" in text
    flat = " ".join(text.split())
    for asked in sheet.worksheet.exercises:
        for number in re.findall(r"\d+\.\d+", asked.statement):
            assert number in flat
    answers = re.findall(r"^ *• ([−\d.]+) .*\(", key, re.MULTILINE)
    long = [answer for answer in answers if len(answer.strip("−0.").replace(".", "")) >= 4]
    assert len(long) > 5
    assert not [answer for answer in long if answer in flat]
    both = pages(run.together([run.pages(each) for each in run.sheets])["momentum_1.pdf"])
    first = [at for at, each in enumerate(both) if re.search(rf"\b1 of {count}", each)]
    assert len(first) == 2
    assert all(at % 2 == 0 for at in first), "each sheet begins on the front of a leaf"


def test_no_formula_is_wider_than_the_page_however_large_the_print(run: PrintRun):
    """Neither in the table of formulas nor on a line of its own."""
    long = " + ".join(rf"\frac{{m_{{{each}}} v_{{{each}}}^2}}{{2}}" for each in range(40))
    body = f"= Title\n\n{run.formula_sheet()}\n\n{typst_formula(long, display=True)}"
    file = pdf([f'#sheet("1", [], ("", "", ""))[\n{body}\n]'], "Title", large=True)
    ends = right_ends(file)
    assert len(ends) > 100
    assert max(ends) < 595.3 - 56  # A4 without its margin, in points
