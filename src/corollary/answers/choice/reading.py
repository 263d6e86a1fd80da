"""Choices: one of several options, asked for and read by its letter."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import final

from corollary.answers.answer import Answer, Blank, Letter, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.changing_words import NEGATIONS, words_of
from corollary.answers.choice.option_text import folded, normal_form
from corollary.answers.choice.own_words import option_worded
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.question import Question
from corollary.answers.remark import BECAUSE
from corollary.formula.by_hand import by_hand
from corollary.formula.numerals import TO_ASCII
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST = 400
AROUND = r"[\s()\[\].:;,!*_\"'“”„‘’`$]*"
LEAD = r"(?:(?:die |der |das |(?:i|we) (?:would )?(?:think|choose|chose|pick|believe|say) |that |it is |it's |it must be |my |the ))*"
NAMED = r"(?:option|answer|choice|alternative|letter|svar|alternativ|antwort|lösung)(?: is)?"
HOLDS = r"(?:is|ist|er) (?:the )?(?:correct|right|true|richtig|korrekt|riktig|rett|sann)(?: (?:one|answer|option|choice))?"
REASON = rf"{BECAUSE}|as|da|denn|siden"
LETTER = re.compile(
    rf"{AROUND}(?:{LEAD}(?:{NAMED}{AROUND})?)?(?P<letter>[A-Za-z]){AROUND}(?:{HOLDS}{AROUND})?",
    re.IGNORECASE,
)

DENIED = re.compile(r"\s*!|.*[\s(\[\"']!(?=[(\[\"']*\w)", re.DOTALL)  # `!A` is any other; `A!` is A

LABEL = re.compile(
    r"\s*[\[(]?(?P<letter>[A-Za-z])(?:\s*[).:,;=\]–-]+\s*(?=\S)|\s+(?=\())|\s*(?:option|answer)\s+(?P<word>[A-Za-z])\s*[).:,–-]*\s+",
    re.IGNORECASE,
)
DENIED_BEHIND = re.compile(
    r"\s*(?:or|and|but|not|no|if|oder|und|aber|nicht|eller|og|men|ikke|is (?:not|wrong|false))\b",
    re.IGNORECASE,
)
DENIED_WORD = re.compile(rf"\b(?:{'|'.join(NEGATIONS.split())})\s+(?:the |a |an )?([^\W\d_]+)", re.IGNORECASE)
UNTICKED = re.compile(r"\s*(?:[-*]\s*)?\[\s*\]|\s*\\bar\b")  # `[ ] B`
LABEL_BEHIND = re.compile(r"\s*[\[(](?P<letter>[A-Za-z])[\])]\s*$")
LED = re.compile(
    r"(?:it|this|that|they)(?:['’]s| is| are)\s+|(?:across|through|at|in)\s+(?=the\b)", re.IGNORECASE
)
NOTHING_MORE: str = (
    "as large long much many high heavy fast strong great big far well before it was is what of"
)
ADD_NOTHING = frozenset(NOTHING_MORE.split())
# Where an option's first clause ends, unless what follows takes some of it back: `more than twice, but less than four times`.
CLAUSE = re.compile(
    r"(?:[:;]|[,.](?!\d)|(?<!\d)[,.])(?!\s*(?:but|yet|though|aber|jedoch|men)\b)", re.IGNORECASE
)


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
            case Text(text) if len(text) > LONGEST:
                return Unclear(wanted, text.strip()[:40])
            case Text(text) if DENIED.match(text) or UNTICKED.match(text):
                return Unclear(wanted, text.strip()[:40])
            case Text(text):
                meant = _by_its_words(text, question)
                if meant is None:
                    return Unclear(
                        _("the letter and the words are those of two options: {wanted}", wanted=wanted),
                        text.strip()[:40],
                    )
                found = LETTER.fullmatch(by_hand(_without_reason(text, question.options)).translate(TO_ASCII))
                letter = found["letter"].lower() if found else ""
                if letter not in question.options:
                    return Letter(meant, f"({meant})") if meant else _in_own_words(text, question, wanted)
                if meant not in ("", letter) and _bare_letter(text, question, meant):
                    return _two_meanings(letter, meant)
                return Letter(letter, f"({letter.upper()})")
            case Refused():
                return turned_away(value)
            case _:
                return Unclear(_("{wanted}, as text", wanted=wanted), _("no letter"))


def _in_own_words(text: str, question: Question, wanted: str) -> Letter | Unclear:
    """The option that a text means whose words are not copied; asked about where a word of it is none of the question's."""
    options = dict(zip(question.options, question.option_texts, strict=True))
    found = option_worded(text, options, f"{question.title} {question.text}")
    meant = Letter(found.letter, f"({found.letter.upper()})")
    if found.letter and found.sure:
        return meant
    return Unclear(wanted, text.strip()[:40], near=(meant,) if found.letter else ())


def _without_reason(text: str, options: Sequence[str]) -> str:
    """`A` of `A because momentum has a direction`, a text of bounded length; all of it where the reason names an option."""
    pieces = re.split(rf"[\s,;:–-]+({REASON})\b", text, maxsplit=1, flags=re.IGNORECASE)
    letter, reason, words = (*pieces, "", "")[:3]
    named = re.search(rf"\b[{''.join(options).upper()}]\b", words)
    return letter if reason and not named else text


def _bare_letter(text: str, question: Question, meant: str) -> bool:
    """Whether a letter stands alone that is the text of another option, too. `A` is not the text `a`: it is how letters are printed."""
    alone = text.strip()
    printed = question.option_texts[question.options.index(meant)]
    return len(alone) == 1 and (alone.islower() or normal_form(alone) == normal_form(printed))


def _two_meanings(letter: str, meant: str) -> Unclear:
    mark, other = letter.upper(), meant.upper()
    why = _(
        "\u201c{mark}\u201d is the letter of one option and the text of another: write ({mark}) or ({other}), in brackets",
        mark=mark,
        other=other,
    )
    return Unclear(why, mark, (Letter(letter, f"({mark})"), Letter(meant, f"({other})")))


def _by_its_words(text: str, question: Question) -> str | None:
    """The letter of the option whose words were copied, alone or with its letter: all of them, or all up to a mark; else "".
    None where letter and words are those of two options."""
    label = LABEL.match(text) or LABEL_BEHIND.search(text)
    letter = (label["letter"] or label["word"]).lower() if label else ""
    options = dict(zip(question.options, question.option_texts, strict=True))
    if label and letter in options:
        words = text[: label.start()] + text[label.end() :]
        worded = option_worded(words, options, question.text)
        meant = _copied(words, options) or (worded.letter if worded.sure else "")
        if meant not in ("", letter):
            return None
        if label["letter"] and label["letter"].isupper() and _explains(words, options):
            return None if _denies(words, options[letter]) else letter
        started = normal_form(words) and folded(options[letter]).startswith(folded(words))
        return letter if started or meant else ""
    if same := _copied(text, options):
        return same
    starts = {
        (each, folded(option[: mark.start()]))
        for each, option in options.items()
        for mark in CLAUSE.finditer(option)
    }
    begun = [each for each, start in starts if folded(text) == start]
    if normal_form(text) and len(begun) == 1:
        return begun[0]
    return _shortened(text, options)


def _explains(words: str, options: Mapping[str, str]) -> bool:
    """True for an explanation behind a letter, which names no other letter and takes nothing back."""
    other = re.search(rf"\b[{''.join(options).upper()}]\b", words)
    return other is None and words.strip() != "" and DENIED_BEHIND.match(words) is None


def _denies(words: str, option: str) -> bool:
    """True for a negation in front of a word of the option itself: `not down (C)`."""
    own = words_of(option)
    return any(found[1].lower() in own for found in DENIED_WORD.finditer(words))


def _shortened(text: str, options: Mapping[str, str]) -> str:
    """The letter of the one option that is longer by words which add nothing: `four times` of `four times as large`."""
    typed = _words(LED.sub("", text.strip(), count=1))
    if typed[:1] == ["only"]:
        typed = [*_words(" ".join(typed[1:])), "only"]
    longer = [each for each, option in options.items() if typed and _words(option)[: len(typed)] == typed]
    if len(longer) != 1 or set(_words(options[longer[0]])[len(typed) :]) - ADD_NOTHING:
        return ""
    return longer[0]


def _words(text: str) -> list[str]:
    """The words of a text without marks, capitals and an article in front; none of one with signs, whose meaning may be lost."""
    if not re.fullmatch(r"[^\W_]+(?:[\s,.;:'’-]+[^\W_]+)*[.!]?", text.strip()):
        return []
    found = re.findall(r"[^\W_]+", text.lower())
    return found[1:] if found[:1] in (["the"], ["a"], ["an"]) else found


def _copied(text: str, options: Mapping[str, str]) -> str:
    """The letter of the one option of just this text; capitals tell where small letters alone do not."""
    for key in (normal_form, folded) if not re.search(r"\d", text) else (normal_form,):
        same = [each for each, option in options.items() if key(option) == key(text)]
        if key(text) and len(same) == 1:
            return same[0]
        if same:
            break
    return ""


TYPE = ChoiceType()
