"""Draws: the same for ever, different for each student and each key, always keeping the conditions."""

from __future__ import annotations

from itertools import islice

from hypothesis import given
from hypothesis import strategies as st

from corollary.problem.bank import chapter_bank, find
from corollary.problem.sampling import digest, draws, sample
from corollary.problem.variant import first_broken

KICK = find(chapter_bank(), "X12.5")
KEY = b"k" * 32


def indices(key: bytes, student: str, count: int = 5) -> list[int | None]:
    return [variant.index for variant in islice(draws(KICK, key, student), count)]


def test_the_same_in_ten_years():
    """A digest by HMAC-SHA256 over length-prefixed words: RFC 4231's construction, written out once by hand."""
    import hashlib
    import hmac

    words = b"\x00\x00\x00\x04draw\x00\x00\x00\x05X12.5"
    assert digest(KEY, "draw", "X12.5") == int(hmac.new(KEY, words, hashlib.sha256).hexdigest(), 16)
    assert digest(b"", "a") != digest(b"", "b")


@given(st.binary(max_size=40), st.text(max_size=20), st.text(max_size=20))
def test_a_draw_depends_on_key_and_student_and_nothing_else(key, student, other):
    assert indices(key, student) == indices(key, student)
    if student != other:
        assert indices(key, student) != indices(key, other)
    assert indices(key, student) != indices(key + b"x", student)


@given(
    st.lists(st.text(max_size=6), min_size=1, max_size=3),
    st.lists(st.text(max_size=6), min_size=1, max_size=3),
)
def test_words_are_kept_apart(these, those):
    assert (digest(KEY, *these) == digest(KEY, *those)) == (these == those)


def test_every_draw_keeps_the_conditions():
    found = list(islice(draws(KICK, KEY, "ada"), 200))
    assert len(found) == 200
    assert all(first_broken(variant) is None for variant in found)


def test_conditions_that_nothing_keeps_end(read):
    front = "code: X1.1\ntitle: A\ngiven:\n  m: {is: m, value: 1, from: 1, to: 3, step: 1}\nwhere: m > 5"
    problem = read(front, "## A {#a .value}\n")
    assert list(draws(problem, KEY, "ada", limit=50)) == []
    assert list(sample(problem, 10)) == []


def test_a_sample_is_spread_and_distinct():
    found = [variant.index for variant in sample(KICK, 300)]
    assert len(set(found)) == len(found) == 300
    assert found == [variant.index for variant in sample(KICK, 300)]
    assert found != [variant.index for variant in sample(KICK, 300, salt="other")]


def test_a_small_grid_is_sampled_whole(read):
    assert [variant.index for variant in sample(read(), 100)] == list(range(45))


def test_students_spread_over_the_grid():
    """60 students on 7.3 million points: the chance that any two of them meet at all is 2.5e-4."""
    assert len({next(draws(KICK, KEY, f"s{n}")).index for n in range(60)}) == 60
