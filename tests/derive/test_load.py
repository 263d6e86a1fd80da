"""The door to the solutions: what is said of a file that is missing, broken, or asks for what is not given."""

from __future__ import annotations

import pytest

from corollary.derive.load import NotDerivable, load, source
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.bank import load as load_problems
from corollary.problem.reader import read_problem


@pytest.mark.parametrize(
    ("whole", "line", "words"),
    [
        ("x = 1\n", 1, "defines no function derive"),
        ("derive = 3\n", 1, "defines no function derive"),
        ("import functools\nderive = functools.partial(print)\n", 1, "defines no function derive"),
        ("class derive:\n    pass\n", 1, "defines no function derive"),
        ("x = 1\ndef derive(m:\n    pass\n", 2, "is not Python"),
        ("def derive(m, v, t):\nreturn 1\n", 2, "is not Python"),
        ("x = 1\n\nimport nothing_of_this_name\n", 3, "cannot be loaded: ModuleNotFoundError"),
        ("x = 1\nfrom corollary.author import Body\n", 2, "write from corollary.scenes.scene import Body"),
        ("from corollary.scenes import Weight\n", 1, "write from corollary.scenes.forces.fields import Weight"),
        ("import sys\nsys.exit(3)\n", 2, "cannot be loaded: SystemExit"),
        (b"x = '\xff\xfe'\n", 1, "is not Python"),
        (b"x = '\x00'\n", 1, "is not Python"),
        ("x = 1\n\ndef derive(m, v, speed, *more):\n    pass\n", 3,
         "derive takes speed, more, not among the givens of X1.1 (m, v, t)"),
        ("def derive(m):\n    y = 1\n    return m.nothing\n", 3, "derive fails: AttributeError"),
        ("def inner(m):\n    return 1 / 0\ndef derive(m):\n    return inner(m)\n", 2, "derive fails: ZeroDivisionError"),
        ("def derive(m):\n    raise SystemExit\n", 2, "derive fails: SystemExit"),
        ("from corollary.laws import law\ndef derive(m):\n    law('A', 'x = y', x=m)\n", 3, "what does y mean"),
        ("from corollary.laws import law\ndef derive(m):\n    law('A', 'x y', x=m)\n", 3, "derive fails: ValueError"),
        ("def derive(m):\n    pass\n", 1, "derive must return derivation(…)"),
        ("def derive(m):\n    return cos(m)\n", 2, "write from sympy import cos at the top"),
        ("def derive(m):\n    return step()\n", 2, "write from corollary.author import step at the top"),
        ("from corollary.author import step\ndef derive(m):\n    step(m, 'x', mistakes=None)\n", 3, "leave it out where there is nothing"),
        ("from corollary.author import step\ndef derive(m):\n    step(m, step)\n", 3, "because is a text for the reader, not a function; write it"),
        ("from corollary.author import derivation\ndef derive(m):\n    return derivation([])\n", 2, "without square brackets"),
    ],
)  # fmt: skip
def test_a_file_that_is_refused_with_its_line(refused, whole, line, words):
    at, sentence = refused(whole=whole)
    assert words in sentence
    assert at == line


def test_a_word_is_no_argument(refused):
    givens = "given:\n  body: {is: what rolls, in: [a cart, a sledge]}\n  m: {is: mass, value: 2, unit: kg}\n"
    front = f"code: X1.1\ntitle: A cart\n{givens}"
    _line, sentence = refused(whole="def derive(m, body):\n    pass\n", front=front)
    assert sentence.endswith("X1.1 (m); body is a word, which stands in the text only")


def test_a_missing_solution(make, tmp_path):
    make("")
    (tmp_path / "solutions" / "carts" / "cart.py").unlink()
    with pytest.raises(NotDerivable, match=r"cart\.md: is missing; cart\.md needs a solution there"):
        load(Bank(tmp_path), read_problem(tmp_path / "problems" / "carts" / "cart.md"))


def test_givens_that_derive_does_not_need(solved):
    found = solved(
        whole="""\
from corollary.author import *
from corollary.laws import momentum
def derive(v, m):
    p = unknown("p")
    return derivation(step(p, "Both.", momentum(p, m, v), answers="a"))
"""
    )
    assert found.entries == ()


def test_what_marks_depend_on_changes_with_the_file(make):
    bank = make(whole="def derive():\n    pass\nVERSION = 1\n")
    problem = read_problem(bank.problems / "carts" / "cart.md")
    before = source(bank, problem)
    make(whole="def derive():\n    pass\nVERSION = 2\n")
    assert source(bank, problem) != before


@pytest.mark.parametrize("problem", load_problems(chapter_bank()), ids=lambda problem: problem.code)
def test_every_problem_of_the_chapter_has_its_solution(problem):
    loaded = load(chapter_bank(), problem)
    assert loaded.derivation.entries
    assert loaded.path.relative_to(chapter_bank().folder / "solutions").with_suffix(
        ""
    ) == problem.path.relative_to(chapter_bank().problems).with_suffix("")


def test_what_a_solution_prints_is_kept_out_of_a_commands_document(make, capsys):
    bank = make(whole="print('loading')\ndef derive():\n    print('deriving')\n")
    with pytest.raises(NotDerivable):
        load(bank, read_problem(bank.problems / "carts" / "cart.md"))
    printed = capsys.readouterr()
    assert (printed.out, printed.err) == ("", "loading\nderiving\n")


def test_the_text_of_a_failing_is_shown_at_a_length_that_can_be_read(refused):
    _line, sentence = refused(whole="def derive():\n    raise ValueError('x' * 10**6)\n")
    assert len(sentence) < 700
