"""Every catalogue of every language is complete and compiled, and what is printed in a language is read as it was meant."""

from __future__ import annotations

import io
import re
from fractions import Fraction
from pathlib import Path
from runpy import run_path

import pytest
from babel.messages.pofile import read_po
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.quantity import Reading, read_quantity
from corollary.answers.verdict import word
from corollary.formula.numerals import decimal_text
from corollary.grading.advice import advice
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.solutions import Solutions
from corollary.grading.verdict_text import sentence
from corollary.messages import WITH_COMMA, in_convention, language, languages
from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import open_bank
from corollary.problem.dates import in_words, moment
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.problem.statement import formulas_in_convention
from corollary.problem.translation import faults, in_language, translation
from corollary.problem.variant import chapter
from corollary.units.unit import unit

ROOT = Path(__file__).parents[1]
MESSAGES = run_path(str(ROOT / ".ci" / "messages.py"))
OTHERS = [code for code in languages() if code != "en"]
each_language = pytest.mark.parametrize("code", OTHERS)
HOLE = re.compile(r"\{\w+\}")


def test_german_and_norwegian_are_spoken():
    assert {"de", "nb"} <= set(OTHERS)


@each_language
def test_a_language_says_every_text_with_its_holes(code: str):
    wrong: list[str] = []
    for place, text in MESSAGES["templates"]().items():
        path = place.parent / code / "LC_MESSAGES" / f"{place.stem}.po"
        theirs = read_po(io.BytesIO(path.read_bytes()), locale=code)
        for message in read_po(io.BytesIO(text.encode())):
            if not message.id:
                continue
            several = isinstance(message.id, tuple | list)
            found = theirs.get(message.id[0] if several else message.id)
            strings = list(found.string) if several and found else [found.string if found else ""]
            holes = set(HOLE.findall(message.id[-1] if several else message.id))
            if not all(strings) or len(strings) != (2 if several else 1) or found.fuzzy:
                wrong.append(f"{path.stem}: {message.id} is not translated")
            elif set(HOLE.findall(strings[-1])) != holes:
                wrong.append(f"{path.stem}: {message.id} has other holes")
    assert not wrong


def test_what_is_compiled_is_what_stands_in_the_sources():
    stale = [str(path) for path, content in MESSAGES["catalogues"]().items() if path.read_bytes() != content]
    assert not stale, "make messages"


@given(
    st.fractions(min_value=Fraction(1, 1000), max_value=10**6, max_denominator=1000),
    st.integers(2, 6),
    st.sampled_from(["kg*m/s", "N", "m/s", "J", "s"]),
    st.sampled_from(sorted(WITH_COMMA)),
)
def test_a_number_printed_with_a_comma_is_never_read_as_another(
    value: Fraction, figures: int, name: str, code: str
):
    meant = f"{decimal_text(value, figures)} {name}"
    with language(code):
        printed = in_convention(meant)
    found, wanted = read_quantity(printed, unit(name)), read_quantity(meant, unit(name))
    assert "." not in printed
    assert isinstance(wanted, Reading)
    # 1,234 alone can be a thousand and more: it is asked about, and taken for neither.
    assert not isinstance(found, Reading) or (found.si == wanted.si and found.figures == wanted.figures)


@each_language
def test_codes_keep_their_point_and_lists_are_parted_by_semicolons(code: str):
    with language(code):
        assert in_convention("(3.5, -4.25) m/s") == "(3,5; -4,25) m/s"
        assert in_convention("X12.5") == "X12.5"
        assert formulas_in_convention("In 1.5 $p = 1.5$\n```python\nx = 1.5  # $1.5$\n```") == (
            "In 1.5 $p = 1{,}5$\n```python\nx = 1.5  # $1.5$\n```"
        )


@pytest.mark.parametrize(
    ("code", "words"),
    [("de", "Freitag, 4. Dezember 2026, 23:59 Uhr"), ("nb", "fredag 4. desember 2026 kl. 23:59")],
)
def test_a_day_is_named_in_the_language(code: str, words: str):
    when = moment("2026-12-04T23:59+00:00")
    assert when is not None
    with language(code):
        assert in_words(when).startswith(words)


@each_language
def test_a_translation_says_every_number_of_its_original(code: str):
    """The holes are those of the original: a statement in another language must not lose a given."""
    from corollary.problem.statement import filled

    problem = open_bank(None)["X12.5"]
    with language(code):
        translated = in_language(problem)
        assert translated.title != problem.title
        assert "0,43" in filled(translated.statement, chapter(translated))
    assert in_language(problem) is problem


@each_language
def test_the_exercises_of_the_demonstration_are_whole(code: str):
    """Nothing is missing in a translation, no hole differs, and it was made from the original as it is today."""
    bank = open_bank(None)
    for problem in find_set(bank, "momentum_1").problems:
        found = translation(problem, code)
        assert found is not None, f"{problem.code} is not translated"
        assert [str(each) for each in faults(problem, found)] == []


@pytest.mark.parametrize(
    ("code", "title", "time"),
    [("de", "Impuls und Kraftstoß", "23:59 Uhr"), ("nb", "Bevegelsesmengde og impuls", "kl. 23:59")],
)
def test_a_worksheet_has_no_english_sentence_of_the_catalogues(code: str, title: str, time: str):
    with language(code):
        bank = open_bank(None)
        problem_set = find_set(bank, "momentum_1")
        sheet = worksheet(problem_set, Student("ada", "Ada"), map(chapter, problem_set.problems))
        words = "\n".join(cell.source for cell in notebook(sheet).cells)
    assert title in words
    assert time in words
    texts = "".join(MESSAGES["templates"]().values())
    template = read_po(io.BytesIO(texts.encode()))
    english = [str(m.id) for m in template if m.id and isinstance(m.id, str) and len(m.id.split()) > 3]
    assert len(english) > 300
    assert [text for text in english if HOLE.sub("", text) == text and text in words] == []
    for problem in problem_set.problems:
        assert problem.title not in words
        assert not [part.text for part in problem.parts if part.text and part.text in words]


@pytest.mark.parametrize(
    ("code", "right", "wrong"), [("de", "Richtig.", "Gelesen als "), ("nb", "Riktig.", "Lest som ")]
)
def test_answers_with_commas_are_right(code: str, right: str, wrong: str):
    bank = open_bank(None)
    with language(code):
        solutions = Solutions(bank)
        key = solutions.key(chapter(bank["X12.5"]))
        typed = {"a": "8,60 kg m/s", "b": "8,6 Ns", "c": "86,0 N", "d": "3,70 N"}
        judged = judge(key, {part: from_json(text) for part, text in typed.items()})
        found = {part: verdicts[0] for part, (verdicts, _) in judged.items()}
        said = sentence(found["a"]), sentence(found["d"])
    assert [word(found[name]) for name in "abcd"] == ["right", "right", "right", "wrong"]
    assert said[0] == right
    assert said[1].startswith(wrong)


@each_language
def test_advice_names_quantities_in_the_language_alone(code: str):
    bank = open_bank(None)
    with language(code):
        problem = in_language(bank["X12.5"])
        said = " ".join(advice(Solutions(bank).key(chapter(problem)), problem.part("a")))
    assert problem.given("m").meaning in said
    assert "the " not in said
