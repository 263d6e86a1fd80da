"""Front matter: YAML that guesses nothing, and complaints that name the line."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.problem.diagnostic import Malformed
from corollary.problem.front_matter import ListNode, TableNode, TextNode, exact, split


def front(tmp_path, source: str):
    path = tmp_path / "a.md"
    path.write_text(f"---\n{source}\n---\nbody\n", encoding="utf-8")
    return split(path)


GUESSED = [
    "no",
    "yes",
    "on",
    "null",
    "~x",
    "1:30",
    "1e3",
    "0x10",
    "0o17",
    "2026-12-04",
    ".inf",
    "1_000",
    "True",
]
"""What YAML takes for truth values, times, numbers in other bases, dates…"""


@pytest.mark.parametrize("text", GUESSED)
def test_every_value_is_the_text_that_was_written(tmp_path, text):
    table, _, _ = front(tmp_path, f"name: {text}")
    assert table.entries["name"] == TextNode(text, 2)


def test_lines_are_those_of_the_file(tmp_path):
    table, body, line = front(tmp_path, "a: 1\n\nb:\n  - x\n  - {c: y}")
    assert table.entries["a"].line == 2
    items = table.entries["b"]
    assert isinstance(items, ListNode)
    assert [item.line for item in items.items] == [5, 6]
    inner = items.items[1]
    assert isinstance(inner, TableNode)
    assert inner.entries["c"] == TextNode("y", 6)
    assert (body, line) == ("body", 8)


@pytest.mark.parametrize(
    ("source", "line", "words"),
    [
        ("a: 1\na: 2", 3, "`a` is given twice"),
        ("a: {b: 1, b: 2}", 2, "`b` is given twice"),
        ("a: 1\n\tb: 2", 3, "not YAML"),
        ("a: [1, 2\nb: 3", 3, "not YAML"),
        ("a: 1\n? [x, y]\n: 2", 3, "must be one word"),
        ("- a\n- b", 2, "must be a list of `name: value` lines"),
        ("only words", 2, "must be a list of `name: value` lines"),
        ("a: {b: {c: {d: {e: {f: {g: {h: 1}}}}}}}", 2, "nested too deeply"),
        ("a: &x\n  b: *x", 2, "nested too deeply"),
        ("a: " + "[" * 5000, 2, "nested too deeply"),
    ],
)
def test_a_front_matter_that_is_refused(tmp_path, source, line, words):
    with pytest.raises(Malformed) as raised:
        front(tmp_path, source)
    (complaint, *_) = raised.value.complaints
    assert words in complaint.sentence
    assert complaint.line == line


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "without front matter"),
        (b"# A title\n", "without front matter"),
        (b"---\ncode: X1\n", "never ends"),
        (b"---\ncode: \xff\xfe\n---\n", "is not in UTF-8"),
        (b"---\ncode: X\x001\n---\n", "not YAML"),
    ],
)
def test_a_file_that_is_no_problem(tmp_path, content, words):
    path = tmp_path / "a.md"
    path.write_bytes(content)
    with pytest.raises(Malformed, match=words):
        split(path)


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(Malformed, match=r"a\.md:1: cannot be read"):
        split(tmp_path / "a.md")


@given(st.integers(-(10**9), 10**9), st.integers(-30, 30))
def test_decimals_are_exact(mantissa, power):
    assert exact(f"{mantissa}e{power}") == Fraction(mantissa) * Fraction(10) ** power


@given(st.fractions(max_denominator=10**6))
def test_fractions_are_exact(value):
    assert exact(str(value)) == value


NO_NUMBERS = [
    "",
    "9" * 61,
    "1:30",
    "no",
    "1/0",
    "nan",
    "inf",
    "1_000",
    "1e999",
    "1e--5",
    "1e",
    "1,5",
    "٣",
    "1e1e1",
    "0x10",
]


@pytest.mark.parametrize("text", NO_NUMBERS)
def test_what_is_no_number(text):
    assert exact(text) is None


@given(st.text(max_size=12))
def test_no_text_breaks_it(text):
    assert exact(text) is None or isinstance(exact(text), Fraction)


@pytest.mark.parametrize(
    ("source", "line", "remedy"),
    [
        ("title: a: b", 2, "a text with a colon between quotation marks"),
        ("given:\n\tm: 1", 3, "indent with blanks, not with a tab"),
        ("title: %x", 2, "a text that begins with a sign of YAML"),
        ("title: *x", 2, "a text that begins with * between quotation marks"),
        ("title: 'x", 2, "a quotation mark or a bracket is not closed"),
        ("m: {is: mass, unit: kg", 2, "close the braces"),
        ("tags: [a b", 2, "close the brackets"),
        ('title: "x" y', 2, "put a text with quotation marks"),
    ],
)
def test_what_an_author_meant_stands_behind_the_words_of_yaml(tmp_path, source: str, line: int, remedy: str):
    with pytest.raises(Malformed) as raised:
        front(tmp_path, source)
    (complaint,) = raised.value.complaints
    assert remedy in complaint.sentence
    assert complaint.line in (line, line + 1)


def test_a_byte_that_is_no_utf8_is_named_with_its_line(tmp_path):
    path = tmp_path / "a.md"
    path.write_bytes(b"---\ntitle: x\nsource: M\xfcller\n---\n")
    with pytest.raises(Malformed, match=r"a\.md:3: is not in UTF-8 \(byte 0xfc\); save the file"):
        split(path)
