"""What the lines of a derivation define: letters of the student's own, said in letters that are known."""

from __future__ import annotations

import pytest

from corollary.answers.proof.steps import steps_of


@pytest.mark.parametrize(
    ("lines", "defines", "undefined"),
    [
        (["E = m g h"], ["E"], [""]),
        (["E = pi m g h"], ["E"], [""]),  # all that is known is in it
        (["E = m g"], ["E"], [""]),
        (["m g h = E"], ["E"], [""]),
        (["E = K", "K = m g h"], ["E", "K"], ["", ""]),
        (["E = m g h z"], [""], ["z"]),
        (["m g h = 2 m"], [""], [""]),
        (["(mass per length E = m/h)"], ["E"], [""]),
        (["h = E*m (mass per length E = m/h)"], ["E", ""], ["", ""]),
        (["h = λ*m [where λ = m/h]", "g = λ*h"], ["lambda", "", ""], ["", "", ""]),
        (["λ' = m/h", "g = λ'h"], ["lambda_prime", ""], ["", ""]),
        (["h = m*g (at t = 0)"], [""], [""]),
    ],
)
def test_a_letter_means_what_the_first_line_says_in_known_letters(lines, defines, undefined):
    found = steps_of(list(enumerate(lines, 1)), ["m", "g", "h"])
    assert isinstance(found, tuple)
    assert [step.defines for step in found] == defines
    assert [step.undefined for step in found] == undefined
