"""What a student reads of a verdict."""

from __future__ import annotations

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Wrong
from corollary.grading.verdict_text import sentence


def test_a_mistake_is_told_alone_or_with_what_was_carried_along():
    assert sentence(Mistaken("That is the kinetic energy.")) == "That is the kinetic energy."
    carried = sentence(Mistaken("That is the kinetic energy.", ("a", "b")))
    assert carried.startswith("That is the kinetic energy. ")
    assert "(a) and (b)" in carried
    assert "costs nothing" in carried


def test_each_verdict_has_its_sentence():
    assert sentence(Right("")) == "Right."
    assert sentence(Right("Right, but coarse.")) == "Right, but coarse."
    assert "follows correctly from your answer in (a)" in sentence(Follows(("a",)))
    assert "earns nothing here" in sentence(Follows(("a",), True))


def test_the_verdict_that_stands_above_a_sentence_is_not_said_in_it_again():
    assert sentence(Slip("The sign is wrong.")) == "The sign is wrong."
    assert sentence(Wrong("Neither the sign nor the size fits.")) == "Neither the sign nor the size fits."
    assert sentence(Wrong("")) == "Not right yet."
