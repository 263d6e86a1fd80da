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
from corollary.formula.numerals import decimal_text
from corollary.messages import in_convention, language, languages
from corollary.problem.bank import open_bank
from corollary.problem.dates import in_words, moment
from corollary.problem.statement import formulas_in_convention
from corollary.problem.variant import chapter
from corollary.units.unit import unit

ROOT = Path(__file__).parents[1]
MESSAGES = run_path(str(ROOT / ".ci" / "messages.py"))
OTHERS = [code for code in languages() if code != "en"]
HOLE = re.compile(r"\{\w+\}")


def test_german_is_spoken():
    assert "de" in OTHERS


@pytest.mark.parametrize("code", OTHERS)
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
)
def test_a_number_printed_with_a_comma_is_never_read_as_another(value: Fraction, figures: int, name: str):
    meant = f"{decimal_text(value, figures)} {name}"
    with language("de"):
        printed = in_convention(meant)
    found, wanted = read_quantity(printed, unit(name)), read_quantity(meant, unit(name))
    assert "." not in printed
    assert isinstance(wanted, Reading)
    # 1,234 alone can be a thousand and more: it is asked about, and taken for neither.
    assert not isinstance(found, Reading) or (found.si == wanted.si and found.figures == wanted.figures)


def test_codes_keep_their_point_and_lists_are_parted_by_semicolons():
    with language("de"):
        assert in_convention("(3.5, -4.25) m/s") == "(3,5; -4,25) m/s"
        assert in_convention("X12.5") == "X12.5"
        assert formulas_in_convention("In 1.5 $p = 1.5$\n```python\nx = 1.5  # $1.5$\n```") == (
            "In 1.5 $p = 1{,}5$\n```python\nx = 1.5  # $1.5$\n```"
        )


def test_a_day_is_named_in_the_language():
    when = moment("2026-12-04T23:59+00:00")
    assert when is not None
    with language("de"):
        assert in_words(when).startswith("Freitag, 4. Dezember 2026, 23:59 Uhr")


def test_a_translation_says_every_number_of_its_original():
    """The holes are those of the original: a statement in another language must not lose a given."""
    from corollary.problem.statement import filled
    from corollary.problem.translation import in_language

    problem = open_bank(None)["X12.5"]
    with language("de"):
        german = in_language(problem)
        assert german.title != problem.title
        assert "0,43" in filled(german.statement, chapter(german))
    assert in_language(problem) is problem
