"""Names of options for people: the letter where the sheet shows letters, else the word."""

from __future__ import annotations

from corollary.answers.registry import answer_type
from corollary.answers.spellings import main_spelling
from corollary.problem.part import Part


def option_named(part: Part, letter: str) -> str:
    """`(B)`, or `ellipse`; "" where the sheet does not have the option."""
    if answer_type(part.answer_type).shows_letters:
        return f"({letter.upper()})" if letter else ""
    return next(
        (main_spelling(each.text) for each in part.options if part.letter_asked(each.letter) == letter), ""
    )
