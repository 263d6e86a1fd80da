"""Choices whose options hold numbers: read as they are shown, and never dealt where two of them print alike."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from corollary.answers.verdict import Right, Unmarked, Unread, Verdict, Wrong
from corollary.grading.assign import admitted, assign_variant
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.variant import chosen
from corollary.verify.verify import verify

PROBLEM = """---
code: T9
title: Ways
given:
  a: {is: first way, value: 3, from: 1, to: 4, step: 1, unit: m}
  b: {is: second way, value: 1, from: 1, to: 4, step: 1, unit: m}
---
The ways are {{a}} and {{b}}.

## Which {#c .KIND points=1}
Which is right?

"""
SOLUTION = '''"""Ways."""

from corollary.author import choice, derivation


def derive(a, b):
    return derivation(choice("c", "The first.", a=True, b=False, c=False))
'''


def written(folder: Path, *options: str, kind: str = "choice") -> Path:
    lines = "\n".join(f"- ({letter}) {text}" for letter, text in zip("ABC", options, strict=True))
    problem = PROBLEM.replace("KIND", kind) + lines + "\n"
    for place, text in (("problems/all/ways.md", problem), ("solutions/all/ways.py", SOLUTION)):
        (folder / place).parent.mkdir(parents=True, exist_ok=True)
        (folder / place).write_text(text, encoding="utf-8")
    return folder


def verdict(folder: Path, answer: str) -> Verdict:
    bank, problem = home(folder, "T9")
    key = make_key(Solutions(bank).of(problem), chosen(problem, dict[str, Fraction]()))
    return judge(key, {"c": from_json(answer)})["c"][0][0]


@pytest.mark.parametrize(
    "options",
    [("{{b}}", "{{a}}", "{{a+b}}"), ("{{a}}", "{{b}}", "neither"), ("{{a in cm}}", "{{b}}", "{{a}}")],
)
def test_a_letter_is_never_compared_with_the_name_of_a_hole(tmp_path, options):
    folder = written(tmp_path, *options)
    assert [type(verdict(folder, answer)) for answer in "ABC"] == [Right, Wrong, Wrong]


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        ("3 m", Right),
        ("3m", Right),
        ("(A) 3 m", Right),
        ("4 m", Wrong),
        ("1 m", Wrong),
        ("a+b", Unread),
        ("C: 3 m", Unread),
    ],
)
def test_an_option_is_compared_as_it_is_shown(tmp_path, answer, expected):
    assert isinstance(verdict(written(tmp_path, "{{a}}", "{{b}}", "{{a+b}}"), answer), expected)


@pytest.mark.parametrize(
    ("options", "answer", "expected"),
    [
        (("3.5 m", "35 m", "0.35 m"), "3,5 m", Right),
        (("3.5 m", "35 m", "0.35 m"), "35 m", Wrong),
        (("5 mW", "5 MW", "5 W"), "5 MW", Wrong),
        (("5 mW", "5 MW", "5 W"), "5 mW", Right),
        (("5 µm", "5 m", "5 mm"), "5 μm", Right),
        (("5 µm", "5 m", "5 mm"), "5 m", Wrong),
        ((r"$\\alpha$", r"$\\beta$", "both"), "β", Unread),
        (("3,000 m", "3 m", "30 m"), "3 m", Wrong),
        (("Up", "down", "neither: at rest"), "up", Right),
        (("$x < 0$", "$x > 0$", r"$x \\le 0$"), "x < 0", Right),
        (("10 m^2", "102 m", "10 m"), "10 m²", Right),
        (("→", "←", "none"), "←", Wrong),
        (("the momentum only", "the kinetic energy only", "both"), "momentum", Right),
        (("the momentum only", "the kinetic energy only", "both"), "only the momentum", Right),
        (("the momentum only", "the kinetic energy only", "both"), "not the momentum", Unread),
        (("the momentum only", "the kinetic energy only", "both"), "only", Unread),
        (("four times as large", "twice as large", "as large"), "it is four times", Right),
        (("four times as large", "twice as large", "as large"), "four", Unmarked),
        (("four times as large", "twice as large", "as large"), "twice", Wrong),
        (("the resistor", "the capacitor", "the supply"), "across the resistor", Right),
        (("no longer", "longer", "shorter"), "no", Unread),
        (("more than twice, but less than four times", "twice", "four times"), "more than twice", Unread),
        (
            ("more than twice, but less than four times", "twice", "four times"),
            "more than twice but less than four times",
            Right,
        ),
    ],
)
def test_signs_that_mean_something_tell_options_apart(tmp_path, options, answer, expected):
    assert isinstance(verdict(written(tmp_path, *options), answer), expected)


def test_a_letter_that_is_the_text_of_another_option_is_asked(tmp_path):
    folder = written(tmp_path, "B", "A", "none")
    assert isinstance(verdict(folder, "A"), Unmarked)  # one of the readings is right: a person decides
    assert isinstance(verdict(folder, "C"), Wrong)
    assert isinstance(verdict(folder, "(A)"), Right)
    assert isinstance(verdict(folder, "option B"), Wrong)


def test_letters_that_are_their_own_text_are_not_asked(tmp_path):
    folder = written(tmp_path, "a", "b", "c")
    assert [type(verdict(folder, answer)) for answer in "aBc"] == [Right, Wrong, Wrong]


@pytest.mark.parametrize(
    ("options", "kind"),
    [
        (("up", "up", "down"), "choice"),
        (("Up", "up", "down"), "choice"),
        (("{{a*1.0001|3}}", "{{a|3}}", "{{b}}"), "choice"),
        (("ellipse | oval", "circle", "oval"), "word"),
    ],
)
def test_options_that_print_alike_are_complained_of(tmp_path, options, kind):
    bank, problem = home(written(tmp_path, *options, kind=kind), "T9")
    assert any("print alike" in sentence for sentence in verify(bank, problem, 5).complaints)


def test_numbers_with_which_two_options_print_alike_are_never_dealt_and_named(tmp_path):
    bank, problem = home(written(tmp_path, "{{2*a}}", "{{5*a+b}}", "{{a*a/b|number}} m"), "T9")
    solution = Solutions(bank).of(problem)
    alike = chosen(problem, {"a": Fraction(2), "b": Fraction(1)})
    assert admitted(solution, alike)[0] is None
    for student in range(40):
        values = assign_variant(solution, b"secret", f"s{student}").variant.values
        assert values["a"] != 2 * values["b"]
    found = verify(bank, problem, 5)
    assert any(
        "print alike with a = 2 m, b = 1 m (2 of 16" in note.replace("\N{NO-BREAK SPACE}", " ")
        for note in found.notes
    )
    assert found.checks["options apart"] == 14
