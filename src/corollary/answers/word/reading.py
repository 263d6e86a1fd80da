"""Words from a list, asked for and read in any spelling; a near miss is named the word, and never guessed."""

from __future__ import annotations

import re
from typing import final

from corollary.answers.answer import Answer, Blank, Letter, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.preamble import without_reason
from corollary.answers.question import Question
from corollary.answers.spellings import LONGEST, main_spelling, word_held, words_met
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

LED = re.compile(r"\s*(?:it|this|that|they)(?:['’]s| is| are)\s+", re.IGNORECASE)


@final
class WordType(AnswerType):
    name, word, stated_by = "word", "word", "choice"
    accepts = needs = frozenset({"options"})
    shows_letters = False

    def instructions(self, question: Question) -> str:
        return _(
            "Answer with one of these words: {words}.",
            words=", ".join(map(main_spelling, question.option_texts)),
        )

    def blank(self, question: Question) -> str:
        return f"{question.name} = None   # " + _("one of the words, as text")

    def read(self, value: Value, question: Question) -> Answer:
        while isinstance(value, Items) and len(value.items) == 1:
            value = value.items[0]
        words = dict(zip(question.options, question.option_texts, strict=True))
        listed = ", ".join(map(main_spelling, question.option_texts))
        match value:
            case Nothing():
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Text(text):
                text = without_reason(text) if len(text) <= LONGEST else text
                found, typed = words_met(LED.sub("", text, count=1), words), text.strip()[:40]
                letters = [Letter(letter, main_spelling(words[letter])) for letter in found.letters]
                if found.exact and len(letters) == 1:
                    return letters[0]
                if held := word_held(text, words):
                    return Letter(held, main_spelling(words[held]))
                if not letters:
                    return Unclear(_("answer with one of these words: {words}", words=listed), typed)
                near = _(" or ").join(f"\u201c{each.as_read}\u201d" for each in letters)
                why = _(
                    "\u201c{typed}\u201d is none of the words; did you mean {near}? Write it so",
                    typed=typed,
                    near=near,
                )
                return Unclear(why, typed, near=tuple(letters))
            case Refused():
                return turned_away(value)
            case _:
                return Unclear(_("answer with one of these words: {words}", words=listed), _("no word"))


TYPE = WordType()
