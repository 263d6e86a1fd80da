"""How one of several options is asked for and read, by its letter."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from typing import final

from corollary.answers.answer import Answer, Blank, Letter, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.question import Question
from corollary.formula.by_hand import by_hand
from corollary.formula.characters import legible
from corollary.formula.numerals import TO_ASCII
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST = 400
AROUND = r"[\s()\[\].:;,!*_\"'“”„‘’`$]*"
LEAD = r"(?:i (?:think|choose|chose|pick|believe|say) |it is |it's |it must be |my )?(?:the )?"
NAMED = r"(?:option|answer|choice|alternative|letter|svar|alternativ|antwort|lösung)(?: is)?"
HOLDS = r"(?:is|ist|er) (?:the )?(?:correct|right|true|richtig|korrekt|riktig|rett|sann)(?: (?:one|answer|option|choice))?"
REASON = r"because|since|as|weil|da|denn|fordi|siden"
LETTER = re.compile(
    rf"{AROUND}(?:{LEAD}(?:{NAMED}{AROUND})?)?(?P<letter>[A-Za-z]){AROUND}(?:{HOLDS}{AROUND})?",
    re.IGNORECASE,
)

LABEL = re.compile(
    r"\s*[\[(]?(?P<letter>[A-Za-z])(?:\s*[).:\]–-]+\s*(?=\S)|\s+(?=\())|\s*(?:option|answer)\s+(?P<word>[A-Za-z])\s*[).:,–-]*\s+",
    re.IGNORECASE,
)
LABEL_BEHIND = re.compile(r"\s*[\[(](?P<letter>[A-Za-z])[\])]\s*$")
CLAUSE, COMMAND = re.compile(r"[:;,.]"), re.compile(r"\\[A-Za-z]+")


@final
class ChoiceType(AnswerType):
    name, word, stated_by = "choice", "choice", "choice"
    accepts = needs = frozenset({"options"})

    def heading(self, question: Question) -> str:
        return _("One letter.")

    def blank(self, question: Question) -> str:
        first, last = question.options[0].upper(), question.options[-1].upper()
        remark = _('one letter, "{first}" to "{last}"', first=first, last=last)
        return f"{question.name} = None   # {remark}"

    def read(self, value: Value, question: Question) -> Answer:
        wanted = _("answer with one letter of {letters}", letters=", ".join(question.options).upper())
        while isinstance(value, Items) and len(value.items) == 1:
            value = value.items[0]
        match value:
            case Nothing():
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Text(text) if len(text) <= LONGEST and (letter := _by_its_words(text, question)):
                return Letter(letter, f"({letter})")
            case Text(text):
                bare = _without_reason(text, question.options) if len(text) <= LONGEST else ""
                found = LETTER.fullmatch(by_hand(bare).translate(TO_ASCII))
                if found and (letter := found["letter"].lower()) in question.options:
                    return Letter(letter, f"({letter.upper()})")
                return Unclear(wanted, text.strip()[:40])
            case Refused():
                return turned_away(value)
            case _:
                return Unclear(_("{wanted}, as text", wanted=wanted), _("no letter"))


def _without_reason(text: str, options: Sequence[str]) -> str:
    """`A` of `A because momentum has a direction`, a text of bounded length; all of it where the reason names an option."""
    pieces = re.split(rf"[\s,;:–-]+({REASON})\b", text, maxsplit=1, flags=re.IGNORECASE)
    letter, reason, words = (*pieces, "", "")[:3]
    named = re.search(rf"\b[{''.join(options).upper()}]\b", words)
    return letter if reason and not named else text


def _by_its_words(text: str, question: Question) -> str:
    """The letter of the option whose words were copied, alone or with its letter: all of them, or all up to a mark; else ""."""
    label = LABEL.match(text) or LABEL_BEHIND.search(text)
    letter = (label["letter"] or label["word"]).lower() if label else ""
    options = dict(zip(question.options, map(_bare, question.option_texts), strict=True))
    if label and letter in options:
        words = _bare(text[: label.start()] + text[label.end() :])
        return letter if words and options[letter].startswith(words) else ""
    words = _bare(text)
    same = [each for each, option in options.items() if words == option]
    if not same:
        begun = zip(question.options, question.option_texts, strict=True)
        starts = {
            (each, _bare(option[: mark.start()]))
            for each, option in begun
            for mark in CLAUSE.finditer(option)
        }
        same = [each for each, start in starts if words == start]
    return same[0] if words and len(same) == 1 else ""


def _bare(text: str) -> str:
    """Letters, digits and signs that mean something, without TeX, accents and spaces."""
    text = COMMAND.sub("", legible(text).replace("\\le ", "≤").replace("\\ge ", "≥"))
    apart = unicodedata.normalize("NFKD", text).lower()
    return re.sub(r"[^a-z0-9<>≤≥=+-]", "", apart).removeprefix("the")


TYPE = ChoiceType()
