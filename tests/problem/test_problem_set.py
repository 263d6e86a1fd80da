"""Problem sets: which problems, what they weigh, when they are due, and what is said of a set that will not do."""

from __future__ import annotations

from datetime import UTC, datetime
from zoneinfo import ZoneInfo

import pytest

from corollary.problem.bank import Bank, UnknownCode, chapter_bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem_set import ProblemSet, Scheme, Usual, find_set


@pytest.fixture
def bank(write, tmp_path) -> Bank:
    write()
    (tmp_path / "problems" / "sets").mkdir()
    return Bank(tmp_path)


def a_set(bank: Bank, front: str, name: str = "week_1") -> ProblemSet:
    (bank.sets / f"{name}.md").write_text(f"---\n{front}\n---\nWelcome.\n", encoding="utf-8")
    return find_set(bank, name)


def test_what_a_set_holds(bank):
    about = "title: Week 1\ndue: 2026-12-04T23:59+01:00\nreveal: yes\ncredit: {slip: 0.4, late: 4/5}\n"
    found = a_set(bank, about + "problems:\n  - {code: X1.1, weight: 2}")
    assert (found.name, found.title, found.introduction, found.reveal) == (
        "week_1",
        "Week 1",
        "Welcome.",
        "after due",
    )
    assert found.due == datetime(2026, 12, 4, 22, 59, tzinfo=UTC)
    assert found.scheme == Scheme(slip=0.4, late=0.8)
    assert found.weight(found.problems[0]) == found.out_of == 2.0


def test_what_is_not_said(bank):
    found = a_set(bank, "title: Week 1\nproblems: cart")
    assert (found.due, found.reveal, found.scheme, found.weights) == (None, "no", Scheme(), (1.0,))


def test_the_dates_are_in_the_courses_zone_and_a_course_may_say_what_is_revealed(bank):
    about = "title: Week 1\nopens: 2026-11-27\ndue: 2026-12-04\nproblems: cart"
    usual = Usual(ZoneInfo("America/New_York"), "by hand")
    a_set(bank, about)
    found = find_set(bank, "week_1", usual)
    assert found.opens == datetime(2026, 11, 27, 5, 0, tzinfo=UTC)
    assert found.due == datetime(2026, 12, 5, 4, 59, 59, 999999, tzinfo=UTC)
    assert found.reveal == "by hand"
    a_set(bank, f"{about}\nreveal: no")
    assert find_set(bank, "week_1", usual).reveal == "no"


def test_a_weight_of_nothing_is_nothing(bank):
    assert a_set(bank, "title: W\nproblems:\n  - {code: X1.1, weight: 0}").out_of == 0


@pytest.mark.parametrize(
    ("front", "line", "words"),
    [
        ("title: W", 2, "holds no problems"),
        ("problems: [X1.1]", 2, "the problem set has no `title`"),
        ("title: W\nproblems:\n  - X1.1\n  - X9.9", 5, "no problem is called X9.9"),
        ("title: W\nproblems:\n  - X1.1\n  - cart", 5, "cart is in the set twice"),
        ("title: W\nproblems:\n  - [X1.1]", 4, "is a code, or"),
        ("title: W\nproblems:\n  - {code: X1.1, weight: -1}", 4, "weight: -1"),
        ("title: W\nproblems:\n  - {code: X1.1, weight: heavy}", 4, "is not a number"),
        (
            "title: W\nproblems:\n  - {code: X1.1, points: 3}",
            4,
            "`points` of a problem of the set must hold `name: value` lines",
        ),
        ("title: W\nproblems:\n  - {code: X1.1, points: {z: 3}}", 4, "X1.1 has no part z; it has a"),
        ("title: W\nproblems:\n  - {code: X1.1, points: {a: -3}}", 4, "X1.1 a has -3 points"),
        ("title: W\nproblems:\n  - {code: X1.1, parts: [b]}", 4, "X1.1 has no part b; it has a"),
        ("title: W\nproblems:\n  - {any: 1, of: [X1.1]}", 4, "any: 1 of 1 problems"),
        ("title: W\nproblems:\n  - {any: 1.5, of: [X1.1, Y1.1]}", 4, "any: 3/2 of"),
        ("title: W\nproblems:\n  - {any: 1, of: [X1.1, X1.1]}", 4, "X1.1 is in the set twice"),
        ("title: W\nproblems:\n  - {any: 1, from: [X1.1]}", 4, "`from` of a pool of the set is not known"),
        ("title: W\nproblems: [nowhere/X1.1]", 3, "nowhere is not a bank"),
        ("title: W\nbank: nowhere\nproblems: [X1.1]", 4, "nowhere is not a bank"),
        ("title: W\norder: any\nproblems: [X1.1]", 3, "order: any: say fixed"),
        ("title: W\ntries: 0\nproblems: [X1.1]", 3, "tries: 0: say how many"),
        ("title: W\ndue: tomorrow\nproblems: [X1.1]", 3, "is not a date or time"),
        ("title: W\nopens: 2026-12-32\nproblems: [X1.1]", 3, "opens: 2026-12-32 is not a date or time"),
        ("title: W\ndue: 2026-12-04\nopens: 2026-12-05\nproblems: [X1.1]", 4, "opens when it is due already"),
        ("title: W\nreveal: maybe\nproblems: [X1.1]", 3, "say yes"),
        ("title: W\ncredit: {slip: 2}\nproblems: [X1.1]", 3, "a share lies between 0 and 1"),
        ("title: W\ncredit: {slip: half}\nproblems: [X1.1]", 3, "is not a number"),
        ("title: W\ncredit: {slip: }\nproblems: [X1.1]", 3, "`slip` of credit is empty"),
        ("title: W\ncredit: {slips: 1}\nproblems: [X1.1]", 3, "`slips` of credit is not known"),
        ("title: W\ncredit: 1\nproblems: [X1.1]", 3, "must hold"),
    ],
)
def test_a_set_that_will_not_do(bank, front, line, words):
    with pytest.raises(Malformed) as raised:
        a_set(bank, front)
    assert any(
        complaint.line == line and words in complaint.sentence for complaint in raised.value.complaints
    )


def test_a_code_mistyped_in_a_pool_is_all_that_is_said(bank):
    """Nothing of the pool's size, which is right but for it."""
    with pytest.raises(Malformed) as raised:
        a_set(bank, "title: W\nproblems:\n  - {any: 1, of: [X1.1, X9.9]}")
    assert [each.line for each in raised.value.complaints] == [4]
    assert "no problem is called X9.9" in raised.value.complaints[0].sentence


def test_a_name_no_folder_can_have(bank):
    with pytest.raises(Malformed, match="becomes a folder's"):
        a_set(bank, "title: W\nproblems: [X1.1]", name="week 1+2")


def test_a_set_with_a_broken_problem_names_its_fault(bank, write):
    write("code: X1.3\ntitle: Broken", "", name="broken")
    with pytest.raises(Malformed, match=r"week_1\.md:4: broken\.md:5: asks nothing"):
        a_set(bank, "title: W\nproblems:\n  - broken")


def test_a_set_that_is_not_there(bank):
    a_set(bank, "title: W\nproblems: [X1.1]")
    with pytest.raises(
        UnknownCode, match=r"no problem set week_2 \(did you mean week_1\?\); the bank .* has: week_1"
    ):
        find_set(bank, "week_2")


def test_the_sets_of_the_chapter():
    bank = chapter_bank()
    names = [path.stem for path in bank.sets.glob("*.md") if "." not in path.stem]
    assert "momentum_1" in names
    for name in names:
        assert find_set(bank, name).out_of > 0
