"""Tables and matrices: each entry is a number of its own, in the unit of its column."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from corollary.answers.answer import Blank, Entries, Unclear
from corollary.answers.expected import Expected, FollowThrough, Quantity
from corollary.answers.questions import checked, question_of
from corollary.answers.registry import answer_type, judging
from corollary.answers.table.entry import entry_name
from corollary.answers.verdict import Mistaken, Right, Unread, Wrong
from corollary.formula.value import Exact, Items, Named, Nothing, Real, Text
from corollary.grading.points import USUAL, share
from corollary.problem.diagnostic import Malformed
from corollary.problem.parts_markdown import read_parts
from corollary.problem.reader import read_problem

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
HEADING = '## Both {#a .table rows="before, after" columns="momentum, energy" unit="kg m/s, J" points=2}\n'
MATRIX = '## Both {#a .table rows=2 columns=2 unit="m" points=2}\n'
TRUTH = (8.0, 16.0, 8.0, 6.4)
LOST = "Kinetic energy is not kept."


def question(heading=HEADING):
    complaints = []
    _, (part,), _ = read_parts(Path("a.md"), heading, 1, complaints)
    assert not complaints, complaints
    return question_of(replace(PROBLEM, parts=(part,)), part)


def value(typed):
    match typed:
        case str():
            return Text(typed)
        case None:
            return Nothing()
        case float():
            return Real(typed)
        case int():
            return Exact(Fraction(typed))
        case dict():
            return Named(tuple(typed), tuple(map(value, typed.values())))
        case _:
            return Items(tuple(map(value, typed)), (len(typed),))


def read(typed, heading=HEADING):
    return answer_type("table").read(value(typed), question(heading))


def judged(typed, heading=HEADING, truth=TRUTH):
    wanted = Quantity(
        truth, 16.0, 0.01, (1e-9,) * 4, dict, None, dict, list, list,
        lambda: [FollowThrough(truth, (), lambda: [((8.0, 16.0, 8.0, 16.0), LOST)], list)],
        scales=tuple(abs(x) or 16.0 for x in truth),
    )  # fmt: skip
    answer = read(typed, heading)
    assert isinstance(answer, Entries), answer
    return judging("table").judge(answer, Expected(question(heading), quantity=wanted))


@pytest.mark.parametrize(
    "typed",
    [
        [[8.0, 16.0], [8.0, 6.4]],
        [8.0, 16.0, 8.0, 6.4],
        [["8 kg m/s", "16 J"], ["8 Ns", "0.0064 kJ"]],
        ["8, 16", "8, 6.4"],
        "8, 16; 8, 6.4",
        "8 | 16\n8 | 6,4",
        r"8 & 16 \\ 8 & 6.4",
        "[[8, 16], [8, 6.4]]",
        r"\begin{pmatrix}8 & 16\\ 8 & 6.4\end{pmatrix}",
        r"$\begin{array}{cc} 8 & 16 \\ 8 & 6.4 \end{array}$",
        "np.array([[8, 16], [8, 6.4]])",
        "before: 8, 16; after: 8, 6.4",
        "after: 8 kg m/s, 6.4 J\nbefore: 8 kg m/s, 16 J",
        "| | momentum | energy |\n|---|--:|---|\n| after | 8 | 6.4 |\n| before | 8 | 16 |",
        "| energy (J) | momentum / kg m/s |\n|---|---|\n| 16 | 8 |\n| 6.4 | 8 |",
        {"after": [8, 6.4], "before": [8, 16]},
        {"Energy": [16, 6.4], "Momentum": [8, 8]},
        {"before": {"energy": 16, "momentum": 8}, "after": {"momentum": 8, "energy": 6.4}},
    ],
)
def test_a_table_is_read_row_by_row(typed):
    found = read(typed)
    assert isinstance(found, Entries), found
    assert [each.values[0] for each in found.entries] == pytest.approx(TRUTH)
    assert isinstance(judged(typed), Right)


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ([[8, 16]], "2 rows with 2 entries each"),
        ([[8, 16], [8]], "2 rows with 1, 2"),
        ("some", "2 rows with 2"),
        (8.0, "2 rows"),
        ({"early": [1, 2], "late": [1, 2]}, "the rows are before, after"),
        ("| p | K |\n|---|---|\n| 8 | 16 |\n| 8 | 6.4 |", "your names are p, K"),
        ("| energy [kJ] | momentum |\n|---|---|\n| 16 | 8 |\n| 6.4 | 8 |", "your names are energy [kJ]"),
    ],
)
def test_another_shape_is_said(typed, words):
    found = read(typed)
    assert isinstance(found, Unclear)
    assert words in found.why


def test_nothing_is_blank():
    for typed in (None, "", [[None, None], [None, None]]):
        assert isinstance(read(typed), Blank)


def test_each_entry_earns_its_share():
    verdict = judged([[8, 16], [8, 1]])
    assert isinstance(verdict, Wrong)
    assert verdict.why.startswith("3 of 4 entries are right. (after, energy) ")
    assert share(verdict, USUAL) == 0.75


def test_a_misconception_is_known_and_costs_its_entries_only():
    verdict = judged([[8, 16], [8, 16]])
    assert isinstance(verdict, Mistaken)
    assert verdict.mistake == LOST
    assert share(verdict, USUAL) == pytest.approx((3 + USUAL.mistaken) / 4)


def test_what_is_empty_or_cannot_be_read_costs_its_entry_only():
    for typed in ([[8, 16], [8, None]], [[8, 16], [8, "about"]]):
        assert share(judged(typed), USUAL) == 0.75
    assert isinstance(judged([["a", "b"], ["c", "d"]]), Unread)


def test_a_small_entry_is_compared_with_itself_and_zero_with_the_largest_of_its_unit():
    truth = (8.0, 1.6e6, 0.0, 6.4)
    assert isinstance(judged([[8, 1.6e6], [0, 6.4]], truth=truth), Right)
    assert isinstance(judged([[8, 1.6e6], [0, 7.4]], truth=truth), Wrong)
    assert isinstance(judged([[8, 1.6e6], [1, 6.4]], truth=truth), Wrong)


def test_a_unit_of_another_column_is_a_wrong_unit():
    verdict = judged([["8 J", 16], [8, 6.4]])
    assert isinstance(verdict, Wrong)
    assert "(before, momentum) The number is right, but not its unit" in verdict.why
    assert share(verdict, USUAL) == pytest.approx((3 + USUAL.slip) / 4)


def test_check_says_which_entries_are_empty():
    found = answer_type("table").preview(value([[8, 16], [8, None]]), question())
    assert not found.ok
    assert found.text.startswith("read as before: (8 kg m/s, 16 J); after: (8 kg m/s, —)")
    assert found.text.endswith("1 entry is empty")
    assert answer_type("table").preview(value([[8, 16], [8, 6.4]]), question()).ok


def test_a_matrix_has_numbers_in_place_of_names():
    asked = question(MATRIX)
    assert entry_name(asked, 2) == "row 2, column 1"
    assert answer_type("table").instructions(asked) == "Answer with a matrix: 2 rows, 2 columns."
    assert answer_type("table").blank(asked).splitlines()[1:] == [
        "    [None, None],",
        "    [None, None],",
        "]",
    ]
    assert isinstance(judged("800 cm, 16; 8, 6.4", MATRIX), Right)


@pytest.mark.parametrize(
    ("attributes", "words"),
    [
        ('.table rows="a b"', "a table has rows= and columns="),
        (".table rows=9 columns=9", "at most 40 entries"),
        ('.table rows="a, a" columns="x y"', "two rows, or two columns, have one label"),
        ('.table rows="a b" columns="x y" unit="m, s, kg"', "2 columns and 3 units"),
        (".table", "name its rows and columns"),
        (".value rows=2 columns=2", "only .table parts have rows"),
        ('.table rows=1 columns=2 unit="°C"', "temperatures of a table are asked in K"),
    ],
)
def test_what_does_not_fit_is_said(attributes, words):
    complaints = []
    _, parts, _ = read_parts(Path("a.md"), f"## Both {{#a {attributes}}}\n", 1, complaints)
    if not complaints:
        with pytest.raises(Malformed) as found:
            checked(replace(PROBLEM, parts=parts))
        complaints = found.value.complaints if hasattr(found.value, "complaints") else [str(found.value)]
    assert words in str(complaints[0])


@pytest.mark.parametrize(
    "typed", ["5 J; -3 J", "5\n-3", "[[5], [-3]]", [5, -3], [[5], [-3]], [["5 J"], ["-3 J"]]]
)
def test_a_table_with_one_column(typed):
    read_as = read(typed, '## One {#a .table rows="before, after" columns="energy" unit="J"}\n')
    assert isinstance(read_as, Entries), read_as
    assert [entry.values for entry in read_as.entries] == [(5.0,), (-3.0,)]
