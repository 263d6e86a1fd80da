"""Letters printed as their author wants them, under `shown:` of the front matter."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.formula.latex import letter, letters_printed, tex_of_letter
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, find
from corollary.problem.diagnostic import Malformed
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter
from corollary.verify.verify import verify

PROBLEM = r"""---
code: P1
title: A weak acid
given:
  c0: {is: concentration of the acid, value: 0.10, from: 0.05, to: 0.50, step: 0.01, unit: mol/l}
  pKa: {is: strength of the acid, value: 4.75, from: 3.00, to: 5.00, step: 0.05}
  c1: {is: unit of concentration, value: 1, unit: mol/l}
shown: SHOWN
require:
  - c0 > 0
  - pKa > 0
  - c1 > 0
---
A weak acid of {{c0}} has $\mathrm{pK}_a$ = {{pKa}}.

## pH {#a .value points=2}
What is its pH, if few of the molecules are dissociated?
"""
SOLUTION = """\
## (a) pH

Few are dissociated.

- law: Weak acid, `pH = (pKa - log10(c0/c1))/2`
"""


def bank(folder: Path, shown: str) -> Bank:
    for place, text in (("problems", PROBLEM.replace("SHOWN", shown)), ("solutions", SOLUTION)):
        (folder / place / "acids").mkdir(parents=True)
        (folder / place / "acids" / "acid.md").write_text(text, encoding="utf-8")
    return Bank(folder)


@pytest.mark.parametrize(
    ("typed", "tex"),
    [
        ("pH", r"\mathrm{pH}"),
        ("Δv", r"\Delta v"),
        ("pK_a", r"\mathrm{pK}_{a}"),
        ("γ", r"\gamma"),
        ("v_max", r"v_{\mathrm{max}}"),
        ("m1", "m_{1}"),
        (r"\hat{p}", r"\hat{p}"),
    ],
)
def test_a_letter_as_an_author_types_it(typed: str, tex: str):
    assert tex_of_letter(typed) == tex


@pytest.mark.parametrize("typed", ["", "c°", "p H", r"\mathrm{pH", r"a\$b", "<b>"])
def test_what_is_no_letter_is_a_sentence(typed: str):
    with pytest.raises(ValueError, match="letter"):
        tex_of_letter(typed)


def test_only_inside_and_only_those():
    with letters_printed({"pH": r"\mathrm{pH}"}):
        assert (letter("pH"), letter("v_A0")) == (r"\mathrm{pH}", "v_{A,0}")
    assert letter("pH") == "p_{H}"


def test_the_worked_solution_has_them(tmp_path: Path):
    place = bank(tmp_path, "{pH: pH, pKa: pK_a}")
    text = Solutions(place).worked_solution(chapter(find(place, "P1")))
    assert r"$$\mathrm{pH} = \frac{\mathrm{pK}_{a} - " in text
    assert "p_{H}" not in text


def test_a_letter_that_stands_nowhere_is_noted(tmp_path: Path):
    place = bank(tmp_path, "{pH: pH, dG: ΔG}")
    notes = verify(place, find(place, "P1"), 5).notes
    assert [note for note in notes if "shown: dG is no letter of the problem" in note]


def test_what_cannot_be_printed_is_refused_with_its_line(tmp_path: Path):
    place = bank(tmp_path, "{pH: p H}")
    with pytest.raises(Malformed, match=r"acid\.md:8: shown: pH: 'p H' is not a letter; write it as pH, Δv"):
        read_problem(place.problems / "acids" / "acid.md")
