"""A problem in another language, and what is wrong with a translation."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.messages import language
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.reader import read_problem
from corollary.problem.statement import filled
from corollary.problem.translation import digest, faults, in_language, text_in_language, translation
from corollary.problem.variant import chapter

ORIGINAL = """\
---
code: Q1
title: A ball
given:
  m: {is: mass of the ball, value: 0.5, unit: kg}
figure: |
  ball a at=0,0 "at rest"
alt: A ball of {{m}}.
---
A ball has the mass {{m}}.

## Weight {#a .value unit="N"}
What does it weigh?

## Why {#b .choice}
Choose.
- (a) gravity
- (b) wind
"""
GERMAN = """\
---
title: Ein Ball
alt: Ein Ball mit {{m}}.
of: OF
---
Ein Ball hat die Masse {{m}}.

## Gewicht {#a}
Was wiegt er?

## Warum {#b}
Wähle.
- (a) Schwerkraft
- (b) Wind

# Texts

> at rest
in Ruhe

> mass of the ball
die Masse des Balls

> You forgot
> the mass.
Du hast die Masse
vergessen.
"""


@pytest.fixture
def problem(tmp_path: Path) -> Problem:
    path = tmp_path / "ball.md"
    path.write_text(ORIGINAL, encoding="utf-8")
    return read_problem(path)


def translated(problem: Problem, text: str = GERMAN) -> None:
    text = text.replace("OF", digest(problem))
    problem.path.with_name("ball.de.md").write_text(text, encoding="utf-8")


def complaints(problem: Problem) -> list[str]:
    found = translation(problem, "de")
    assert found is not None
    return [str(each) for each in faults(problem, found)]


def test_every_word_is_the_translations(problem: Problem):
    translated(problem)
    with language("de"):
        german = in_language(problem)
        assert text_in_language(problem, "You forgot the mass.") == "Du hast die Masse\nvergessen."
    assert (german.title, german.statement, german.figure_alt) == (
        "Ein Ball",
        "Ein Ball hat die Masse {{m}}.",
        "Ein Ball mit {{m}}.",
    )
    assert [part.title for part in german.parts] == ["Gewicht", "Warum"]
    assert [option.text for option in german.part("b").options] == ["Schwerkraft", "Wind"]
    assert '"in Ruhe"' in german.figure
    assert german.given("m").meaning == "die Masse des Balls"
    assert german.part("a").unit == problem.part("a").unit
    assert complaints(problem) == []


def test_words_that_are_drawn_are_translated(tmp_path: Path):
    path = tmp_path / "ball.md"
    given = "  m: {is: mass of the ball, value: 0.5, unit: kg}\n"
    text = ORIGINAL.replace(given, given + "  body: {is: body, in: [a ball, a cart]}\n")
    path.write_text(text.replace("A ball has", "{{body}} has"), encoding="utf-8")
    drawn = read_problem(path)
    german = GERMAN.replace("Ein Ball hat", "{{body}} hat") + "\n> body\nder Körper\n\n> a cart\nein Wagen\n"
    translated(drawn, german)
    with language("de"):
        assert in_language(drawn).given("body").words == ("a ball", "ein Wagen")
    assert [each.partition(": ")[2] for each in complaints(drawn)] == [
        "the text 'a ball' is missing; it is read in the original's language"
    ]
    translated(drawn, german + "\n> a ball\nein Ball\n")
    assert complaints(drawn) == []
    with language("de"):
        asked = in_language(drawn)
        assert (
            filled(asked.statement, replace(chapter(asked), problem=asked))
            == "ein Ball hat die Masse 0,5\u00a0kg."
        )


def test_a_hint_is_translated(tmp_path: Path):
    path = tmp_path / "ball.md"
    path.write_text(ORIGINAL.replace("{#a ", '{#a hint="Weigh it." ', 1), encoding="utf-8")
    hinted = read_problem(path)
    translated(hinted)
    assert [each.partition(": ")[2] for each in complaints(hinted)] == [
        "the text 'Weigh it.' is missing; it is read in the original's language"
    ]
    translated(hinted, GERMAN + "\n> Weigh it.\nWiege ihn.\n")
    with language("de"):
        assert in_language(hinted).part("a").hint == "Wiege ihn."


def test_what_is_missing_is_read_in_the_original(problem: Problem):
    translated(problem, "---\ntitle: Ein Ball\nof: OF\n---\n\n## Gewicht {#a}\nMit {{q}}?\n")
    with language("de"):
        german = in_language(problem)
    assert german.statement == problem.statement
    assert german.part("a").text == "What does it weigh?"
    found = "\n".join(complaints(problem))
    assert "ball.de.md:1: the statement is missing" in found
    assert "part b is missing: add ## Why {#b}, translated" in found
    assert "ball.de.md:6: the text of part a differs from the original in the holes {{q}}" in found


def test_an_original_that_changed_since_is_named(problem: Problem):
    translated(problem)
    problem.path.write_text(ORIGINAL.replace("A ball has", "Some ball has"), encoding="utf-8")
    now = read_problem(problem.path)
    (sentence,) = complaints(now)
    assert f"compare the two, and write of: {digest(now)}" in sentence
    assert digest(now) != digest(problem)


@pytest.mark.parametrize(
    ("lines", "sentence"),
    [
        ("> wall\nWand\n\n> wall\nMauer\n", "> wall stands here twice"),
        ("Wand\n", "a translation stands below its original"),
    ],
)
def test_a_list_of_texts_that_cannot_be_read(problem: Problem, lines: str, sentence: str):
    translated(problem, f"---\ntitle: Ein Ball\n---\n# Texts\n\n{lines}")
    with pytest.raises(Malformed, match=sentence):
        translation(problem, "de")


def test_a_translation_left_alone_is_called_that(problem: Problem):
    translated(problem)
    problem.path.unlink()
    with pytest.raises(Malformed) as error:
        read_problem(problem.path.with_name("ball.de.md"))
    (complaint,) = error.value.complaints
    assert "this is ball.md in another language (de)" in str(complaint)
