"""Forces on a body, asked for and read: a name and a direction each, as a list, a dictionary or one text (`weight: down`)."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Blank, DirectedForce, Formulas, NamedForces, Numbers, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import PLACEHOLDERS, scalar, turned_away
from corollary.answers.question import Question
from corollary.answers.spellings import main_spelling, words_met
from corollary.answers.ways import in_words, spellings
from corollary.formula.value import Items, Named, Nothing, Refused, Text, Value
from corollary.messages import catalogue
from corollary.units.unit import unit

_ = catalogue(__name__)

LONGEST, MOST = 1000, 20  # signs of a text, forces of an answer
SPOKEN = re.compile(
    r"\b(?:acts?|points?|is directed|acting|pointing)\b", re.IGNORECASE
)  # `the weight acts down`
BETWEEN = re.compile(r"\s*(?::|=|->|→)\s*")


@final
class ForcesType(AnswerType):
    name, word, stated_by = "forces", "forces", "forces"
    accepts, needs = frozenset({"options", "slope"}), frozenset({"options"})
    shows_letters = False

    def instructions(self, question: Question) -> str:
        names = ", ".join(map(main_spelling, question.option_texts))
        ways = ", ".join(map(in_words, spellings(bool(question.slope))))
        return _(
            "Name every force that acts, and no other, each with its direction. The names: {names}. The directions: {ways}; "
            "or an angle, counter-clockwise from the right, such as 30°.",
            names=names,
            ways=ways,
        )

    def blank(self, question: Question) -> str:
        name = main_spelling(question.option_texts[0])
        return f"{question.name} = []   # " + _(
            'a list of texts, one for each force: ["{name}: {way}"]', name=name, way=in_words("up")
        )

    def read(self, value: Value, question: Question) -> Answer:
        match value:
            case Nothing() | Items(()):
                return Blank()
            case Items(items) if all(isinstance(item, Nothing) for item in items):
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Text(text) if len(text) <= LONGEST:
                text = SPOKEN.sub(" ", text)
                pieces = re.split(
                    r"[;\n]" if ";" in text or "\n" in text else r",\s*(?:and\s)?|\s+and\s+(?:the\s+)?", text
                )
                return _together([_pull(piece, question) for piece in pieces if piece.strip()])
            case Named(names, items):
                return _together(
                    [_pair(name, item, question) for name, item in zip(names, items, strict=True)]
                )
            case Items((Text(name), direction), _) if not _is_force(name, question):
                return _together([_pair(name, direction, question)])
            case Items(items):
                return _together([_item(item, question) for item in items])
            case Refused():
                return turned_away(value)
            case _:
                return Unclear(
                    _("the forces are asked for, each as a name and a direction"), _("something else")
                )


def _is_force(text: str, question: Question) -> bool:
    """Whether a text names its direction, too."""
    return isinstance(_pull(text, question), DirectedForce)


def _item(item: Value, question: Question) -> DirectedForce | Unclear:
    match item:
        case Text(text):
            return _pull(text, question)
        case Items((Text(name), direction), _):
            return _pair(name, direction, question)
        case Named((name,), (direction,)):
            return _pair(name, direction, question)
        case _:
            return Unclear(_("each force is a name and a direction"), _("something else"))


def _pull(text: str, question: Question) -> DirectedForce | Unclear:
    """`weight: down`, `weight down`: the longest beginning that is a name."""
    if len(parts := BETWEEN.split(text.strip(), maxsplit=1)) == 2:
        return _pair(parts[0], Text(parts[1]), question)
    words = dict(zip(question.options, question.option_texts, strict=True))
    pieces = re.split(r"[\s,()]+", text.strip())
    for count in range(len(pieces) - 1, 0, -1):
        name = " ".join(pieces[:count])
        if words_met(name, words).exact:
            return _pair(name, Text(" ".join(pieces[count:]).strip()), question)
    return Unclear(
        _(
            "\u201c{text}\u201d should be a name and a direction, such as \u201c{example}\u201d",
            text=text.strip()[:40],
            example=f"{main_spelling(question.option_texts[0])}: {in_words('up')}",
        ),
        text.strip()[:40],
    )


def _pair(name: str, direction: Value, question: Question) -> DirectedForce | Unclear:
    words = dict(zip(question.options, question.option_texts, strict=True))
    found = words_met(name, words)
    if not found.exact or len(found.letters) != 1:
        return _unknown(
            name, [words[letter] for letter in found.letters] or list(words.values()), bool(found.letters)
        )
    (letter,) = found.letters
    spoken = main_spelling(words[letter])
    if isinstance(direction, Text):
        ways = spellings(bool(question.slope))
        way = words_met(direction.text, ways)
        if way.exact:
            return DirectedForce(letter, way.letters[0], None, f"{spoken}: {in_words(way.letters[0])}")
        if way.letters and not re.search(r"[0-9]", direction.text):
            return _unknown(direction.text, [in_words(each) for each in way.letters], near=True)
    angle = scalar(direction, _angle_asked(question))
    match angle:
        case Numbers() if not angle.misfit:
            return DirectedForce(letter, "", angle, f"{spoken}: {angle.as_read}")
        case Formulas():
            return DirectedForce(letter, "", angle, f"{spoken}: {angle.as_read}")
        case _:
            text = direction.text if isinstance(direction, Text) else _("something else")
            return _unknown(text, [in_words(each) for each in spellings(bool(question.slope))], near=False)


def _angle_asked(question: Question) -> Question:
    return replace(question, unit=unit("deg"), components=(), options=(), option_texts=())


def _unknown(text: str, words: list[str], near: bool) -> Unclear:
    listed = ", ".join(map(main_spelling, words))
    typed = text.strip()[:40]
    if near:
        return Unclear(
            _(
                "\u201c{typed}\u201d is none of the words; did you mean {near}? Write it so",
                typed=typed,
                near=listed,
            ),
            typed,
        )
    return Unclear(_("\u201c{typed}\u201d is none of these: {words}", typed=typed, words=listed), typed)


def _together(found: list[DirectedForce | Unclear]) -> Answer:
    pulls = [each for each in found if isinstance(each, DirectedForce)]
    for each in found:
        if isinstance(each, Unclear):
            return each
    if len(pulls) > MOST:
        return Unclear(_("more than {count} forces", count=MOST), _("a list"))
    return NamedForces(tuple(pulls), "; ".join(each.as_read for each in pulls)) if pulls else Blank()


TYPE = ForcesType()
