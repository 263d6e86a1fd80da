"""A request for regrading is known by its file's name, as students, browsers and LMSs leave it."""

from __future__ import annotations

import pytest

from corollary.records.regrade_requests import file_name, is_request, set_asked_about

SETS = ("week", "week1", "momentum_1", "Week-2", "set.3")


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize(
    "change",
    ["{}.md", "{}.txt", "{}.md.txt", "{} (1).md", "{}(2).md", "{}-1.md", "{} copy.md", "Ada_17_assignsubmission_file_/{}.md",
     "lovelaceada_2001_5678_{}-1.md", "ada/{}.MD", "{}_1_.md"],
)  # fmt: skip
def test_the_form_of_a_set_is_known_whatever_was_appended_to_its_name(name: str, change: str) -> None:
    stem = file_name(name).removesuffix(".md")
    assert is_request(change.format(stem), name)
    assert is_request(change.format(stem.upper()), name)


@pytest.mark.parametrize(
    "name", ["request week1.md", "request-week1.md", "my_request_week1.md", "ada/Request week1 (1).md"]
)
def test_a_blank_or_a_word_of_the_students_own_does_not_hide_a_form(name: str) -> None:
    assert is_request(name, "week1")


@pytest.mark.parametrize(
    "name", ["request_week2.md", "request_week1.ipynb", "week1.md", "request.md", "request_week12.md"]
)
def test_other_files_are_none(name: str) -> None:
    assert not is_request(name, "week1")


@pytest.mark.parametrize(
    ("name", "about"), [("ada/request_week2.md", "week2"), ("week1.ipynb", ""), ("notes.md", "")]
)
def test_a_form_says_which_set_it_is_about(name: str, about: str) -> None:
    assert set_asked_about(name) == about
