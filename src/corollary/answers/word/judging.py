"""A word judged as a choice is, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.choice.judging import judge as judge
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.spellings import MARK, main_spelling, words_met


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` is the letter of the right word: each of its spellings; another word; what is none."""
    assert isinstance(truth, str)
    words = dict(zip(question.options, question.option_texts, strict=True))
    ways = [way.strip() for way in words[truth].split(MARK)]
    other = next(letter for letter in question.options if letter != truth)
    near = main_spelling(words[truth])[:-1]
    doubtful = (
        len(near) > 3 and words_met(near, words).letters[:1] == (truth,) and not words_met(near, words).exact
    )
    return (
        *(Sample(way, "right") for way in ways),
        Sample(f" {ways[0].upper()}. ", "right"),
        *((Sample(near, "unmarked"),) if doubtful else ()),
        Sample(main_spelling(words[other]), "wrong"),
        Sample("xyzzy", "unread"),
        Sample(7, "unread"),
        Sample(None, "unread"),
    )
