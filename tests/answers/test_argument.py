"""What each line of a derivation is: nothing, a definition, a law, what follows from the lines above it, or open."""

from __future__ import annotations

import pytest

from corollary.answers.proof.argument import Grounds, equal_to, standings, sufficient
from corollary.answers.proof.steps import steps_of
from corollary.formula.ast import Relation
from corollary.formula.syntax import author_formula

LETTERS = ("p", "K", "m", "v")
MOMENTUM, ENERGY, CLAIM = "p = m*v", "K = m*v^2/2", "K = p^2/(2*m)"


def relation(text: str) -> Relation:
    found = author_formula(text)
    assert isinstance(found, Relation)
    return found


GROUNDS = Grounds(
    (relation(MOMENTUM), relation(ENERGY)), (), relation(CLAIM), ("p", "K"), (("m", (0, None)),), ()
)


def read(*lines: str):
    steps = steps_of(list(enumerate(lines, 1)), LETTERS)
    assert isinstance(steps, tuple), steps
    return steps


def kinds(*lines: str) -> list[str]:
    return [each.kind for each in standings(read(*lines), GROUNDS)]


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        ((MOMENTUM, ENERGY, CLAIM), ["law", "law", "follows"]),
        (("m*v = v*m", "p = p", CLAIM), ["empty", "empty", "open"]),
        (("2*p = 2*m*v", "v = p/m"), ["law", "law"]),
        ((MOMENTUM, "p^2 = m^2*v^2", "K = p*v/2"), ["law", "follows", "law"]),
        (("Q = v^2", "K = m*Q/2", MOMENTUM, CLAIM), ["definition", "law", "law", "follows"]),
        (("Q = m*v", ENERGY, "K = Q^2/(2*m)"), ["law", "law", "follows"]),
        ((MOMENTUM, CLAIM, ENERGY), ["law", "open", "law"]),
    ],
)
def test_lines_and_what_they_are(lines, found):
    assert kinds(*lines) == found


def test_laws_and_the_claim_are_told_by_their_places():
    energy, momentum, claim = standings(read(ENERGY, MOMENTUM, CLAIM), GROUNDS)
    assert (energy.law, momentum.law, claim.law) == (1, 0, -1)
    assert (energy.claims, momentum.claims, claim.claims) == (False, False, True)


def test_of_a_letter_without_a_value_nothing_is_decided():
    """D divides by zero: no line can be held against what is known of it."""
    assert kinds("D = 1/(m - m)", MOMENTUM, "K = D*p") == ["undecided"] * 3


def test_both_laws_are_needed():
    assert sufficient(GROUNDS) == (frozenset({0, 1}),)


def test_a_known_mistake_is_told_by_what_it_says_and_not_by_its_words():
    wrong = (relation("K = m*v"), relation("K = p*v"))
    (step,) = read("2*K = 2*v*p")
    assert equal_to(step, wrong, (step,), GROUNDS) == 1
    (other,) = read("K = p*v/3")
    assert equal_to(other, wrong, (other,), GROUNDS) == -1


def test_a_letter_made_of_all_that_is_known_is_a_definition():
    """Of a line that uses every letter, pi among them, the one that stands alone and is new is the student's own."""
    steps = steps_of([(1, "Q = pi*m*v")], ("m", "v"))
    assert isinstance(steps, tuple)
    assert (steps[0].defines, steps[0].undefined) == ("Q", "")
