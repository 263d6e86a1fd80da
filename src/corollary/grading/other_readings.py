"""Other readings of a typed answer: what may have been meant by a slip of the keyboard, of notation or of order."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence, Set
from dataclasses import replace
from itertools import combinations, permutations, product

from corollary.answers.answer import Answer, Numbers, Unclear
from corollary.answers.expected import Values
from corollary.answers.question import Question
from corollary.formula.functions import SPELLINGS
from corollary.formula.value import Exact, Items, Named, Real, Text, Value
from corollary.units.unit import ONE, Unit, read_unit, show

Change = Callable[[str], str]
Reading = tuple[str, Value | Numbers]
"""A kind, and a value that is still to be read or an answer as it would be read."""

LONGEST = 200
MOST_CASES = 64
MOST_TOKENS = 20
MOST_COMPONENTS = 4
MOST_NUMBERS = 3
NUMBER = r"\d+(?:[.,]\d+)?(?:\s*(?:[x×*·⋅]\s*10\s*(?:\^|\*\*)?|e)\s*[-+−–]?\d+)?"
SIGNED = re.compile(rf"(?<![\w.,])[-+−–]?\s?{NUMBER}", re.IGNORECASE)
LOST_POWER = re.compile(r"(?<![\d.,])(\d+(?:[.,]\d+)?)\s*(?:[x×X*·⋅]\s*)10\s?([-+−–]?\s?\d{1,2})(?![\d.,])")
WORD = re.compile(r"[^\W\d_]+")
LETTERS = re.compile(r"(?<![\w.])[^\W\d]\w*")
SYMBOL = re.compile(r"[^\W\d_](?:_?\w{1,2})?")
OR = re.compile(r"\b(?:or|oder|eller)\b", re.IGNORECASE)
NOT = re.compile(
    r"\b(?:not?|never|wrong|false|incorrect|nicht|kein\w*|falsch|nie|ikke|feil|aldri)\b|n['’]t\b",
    re.IGNORECASE,
)
TOKENS = re.compile(r"\*\*|[-+*/^·×()]|[^-+*/^·×()\s]+")
DIGITS_TYPED_AS_LETTERS = str.maketrans({"O": "0", "o": "0", "l": "1", "I": "1"})

MARK = "decimal or thousands mark"
POWER = "power of ten lost"
CASE = "capital or small letter"
LETTER_FOR_DIGIT = "letter typed for a digit"
ORDER = "components in another order"
DEGREES = "degrees without their sign"
RADIANS = "radians without their unit"
OTHER_LETTER = "another letter for the same quantity"
BRACKET = "bracket lost"
RIGHT_SIDE = "right side of an equation"
SPREAD = "number before an uncertainty"
IN_WORDS = "one number in words that were not read"
SEVERAL = "one of several numbers"
OPTION = "one option in words that were not read"
NO_QUOTES = "text without quotes"
NO_NAME = "value not given to its name"
SIGN = "sign told in words"
TWO_WAYS = "one of the ways in which it can be read"


def text_typed(value: Value) -> str:
    """The answer as it was typed, in one line; empty where that cannot be said."""
    match value:
        case Text(text):
            return " ".join(text.split())
        case Exact(number):
            return str(number)
        case Real(number):
            return f"{number:.12g}"
        case Items(items):
            return f"[{', '.join(map(text_typed, items))}]"
        case _:
            return ""


def other_readings(value: Value, answer: Answer, question: Question) -> Iterator[Reading]:
    """Each other reading with its kind, the likeliest first; a missing unit of another scale is none."""
    for kind, change in _changes(question):
        changed = _changed(value, change)
        if changed != value:
            yield kind, changed
    if isinstance(value, Items) and not question.components and len(value.items) == 2:
        whole, decimals = value.items  # 8,6 without quotes is a pair of numbers in Python
        if isinstance(whole, Exact) and isinstance(decimals, Exact) and decimals.value >= 0:
            yield MARK, Text(f"{whole.value},{decimals.value}")
    if isinstance(answer, Numbers):
        yield from _of_numbers(value, answer, question)
    if isinstance(value, Text) and len(value.text) <= LONGEST:
        yield from _of_text(value.text, question)
        if isinstance(answer, Unclear) and not NOT.search(value.text):
            yield from _of_unread(value.text, question)


def _changed(value: Value, change: Change) -> Value:
    """The value with each of its texts changed."""
    match value:
        case Text(text) if len(text) <= LONGEST:
            return Text(change(text))
        case Items(items):
            return replace(value, items=tuple(_changed(each, change) for each in items))
        case _:
            return value


def _changes(question: Question) -> Iterator[tuple[str, Change]]:
    """Changes of a text that holds one number."""
    yield POWER, lambda text: LOST_POWER.sub(r"\1e\2", text)
    yield POWER, lambda text: re.sub(r"(?<=\d)\s*[x×*·⋅]\s*10\s*[eE]\s*(?=[-+]?\d)", "e", text)
    yield MARK, lambda text: re.sub(r"(?<=\d)[.,'’ ](?=\d{3}(?!\d))", "", text)
    yield MARK, lambda text: text.translate(str.maketrans(".,", ",."))
    yield MARK, lambda text: re.sub(r"(?<=\d)(?:[;:'’]|[.,]{2,}|\s*[.,]\s+|\s+[.,])(?=\d)", ".", text)
    yield MARK, lambda text: re.sub(r"(?<=\d)\s+(?=\d)", "", text)
    yield (
        LETTER_FOR_DIGIT,
        lambda text: re.sub(
            r"(?<![^\W\d])[\dOolI]*(?:\d[.,]?[OolI]|[OolI][.,]?\d)[\dOolI.,]*",
            lambda found: found[0].translate(DIGITS_TYPED_AS_LETTERS),
            text,
        ),
    )


def _of_numbers(value: Value, answer: Numbers, question: Question) -> Iterator[Reading]:
    values, count = answer.values, len(answer.values)
    named = isinstance(value, Named) or (
        isinstance(value, Text) and set(LETTERS.findall(value.text)) & {*question.components}
    )
    if 1 < count <= MOST_COMPONENTS and not named and "list" not in question.types and not question.rows:
        for order in permutations(range(count)):
            moved = tuple(values[place] for place in order)
            if moved != values:
                yield ORDER, _with_values(answer, moved, question, order)
    for turned in (
        turn for many in range(1, len(answer.in_words) + 1) for turn in combinations(answer.in_words, many)
    ):
        signed = tuple(-x if place in turned else x for place, x in enumerate(values))
        yield SIGN, replace(_with_values(answer, signed, question), in_words=())
    bare = not isinstance(value, Text) or not re.search(r"[^\W\d_eE]|[°′″]", value.text)
    if bare and question.unit.dimension == ONE and question.unit.text in ("rad", "deg", "°"):
        kind, converted = (DEGREES, math.radians) if question.unit.text == "rad" else (RADIANS, math.degrees)
        other = replace(_with_values(answer, tuple(map(converted, values)), question), missing="")
        yield (
            kind,
            replace(
                other,
                as_read=f"{answer.as_read.removesuffix(' rad').removesuffix('°')}{'°' if kind == DEGREES else ' rad'}",
            ),
        )


def _with_values(answer: Numbers, values: Values, question: Question, order: Sequence[int] = ()) -> Numbers:
    """The answer with other values, or the same in another order, and how that is written in the unit asked for."""
    written = [f"{value / question.unit.si:.6g}" for value in values]
    body, unit = written[0] if len(written) == 1 else f"({', '.join(written)})", show(question.unit)
    places = order or range(len(values))
    figures, sizes = (
        tuple(each[place] for place in places) if len(each) == len(values) else each
        for each in (answer.figures, answer.sizes)
    )
    return replace(
        answer,
        values=values,
        as_read=f"{body} {unit}".strip(),
        figures=tuple(map(int, figures)),
        sizes=sizes,
        polar=None,
        most=(),
    )


def _of_text(text: str, question: Question) -> Iterator[Reading]:
    """Readings of one text that change more than a sign of it."""
    if question.options:
        return
    for cased in _cases(text, {*question.symbol_names}):
        yield CASE, Text(cased)
    if re.search(r"[^=<>!]=[^=]", text):
        yield RIGHT_SIDE, Text(text.rpartition("=")[2])
    if spread := re.search(r"±|\+\s*/?\s*-|\+/-", text):
        ending = re.search(r"[^\W\d_].*$", text[spread.end() :])
        yield SPREAD, Text(f"{text[: spread.start()].strip(' (')} {ending[0].strip(' )') if ending else ''}")
    for bracketed in _bracketed(text):
        yield BRACKET, Text(bracketed)


def _of_unread(text: str, question: Question) -> Iterator[Reading]:
    """Readings of a text that could not be read, and denies nothing."""
    if question.options:
        letters = {option.casefold(): option for option in question.options}
        alone = {
            found[0].casefold() for found in re.finditer(r"(?<!\w)(?!a\s)\w(?!\w)", text)
        } & letters.keys()
        if len(alone) == 1 and len(text.split()) > 1 and not OR.search(text):
            yield OPTION, Text(letters[alone.pop()])
        return
    for renamed in _renamed(text, question):
        yield OTHER_LETTER, Text(renamed)
    yield from _single_numbers(text, question)


def _cases(text: str, symbols: Set[str]) -> Iterator[str]:
    """The text with other capitals in the words behind its first number; of a unit only those that are units or symbols again."""
    start = re.search(r"\d", text)
    if start is None:
        return
    words = [
        found for found in WORD.finditer(text, start.end()) if len(found[0]) <= 4 and found[0].lower() != "e"
    ]
    if not words or len(words) > 4:
        return
    choices = [[found[0], *sorted(_capitals(found[0]) - {found[0]})] for found in words]
    behind = words[0].start()
    is_unit = isinstance(read_unit(text[behind:]), Unit)
    for count, chosen in enumerate(product(*choices)):
        if count >= MOST_CASES:
            return
        if count:
            changed = text
            for found, word in reversed(list(zip(words, chosen, strict=True))):
                changed = changed[: found.start()] + word + changed[found.end() :]
            if not is_unit or symbols >= {*chosen} or isinstance(read_unit(changed[behind:]), Unit):
                yield changed


def _capitals(word: str) -> set[str]:
    return {"".join(letters) for letters in product(*((each.lower(), each.upper()) for each in word))}


def _renamed(text: str, question: Question) -> Iterator[str]:
    """The text with its letters that the problem does not have, at most two, taken for letters that it has."""
    known = [symbol.name for symbol in question.symbols]
    strange = list(
        dict.fromkeys(
            each
            for each in LETTERS.findall(text)
            if each not in known and each not in SPELLINGS and each != "pi"
        )
    )
    if not known or not 1 <= len(strange) <= 2 or len(known) > 12 or not all(map(SYMBOL.fullmatch, strange)):
        return
    for chosen in permutations(known, len(strange)):
        meant = dict(zip(strange, chosen, strict=True))
        yield LETTERS.sub(lambda found, meant=meant: meant.get(found[0], found[0]), text)


def _bracketed(text: str) -> Iterator[str]:
    """The text with a bracket that lacks its other half made whole, or with one pair of brackets more."""
    tokens: Sequence[str] = TOKENS.findall(text)
    if not 3 <= len(tokens) <= MOST_TOKENS or not re.search(r"[/^*]", text):
        return
    depth = text.count("(") - text.count(")")
    number = SIGNED.search(text)
    if not depth and number is not None and isinstance(read_unit(text[number.end() :]), Unit):
        return  # behind the number stands its unit, which has one reading
    if abs(depth) == 1:
        for place in range(len(tokens) + 1):
            yield " ".join([*tokens[:place], ")" if depth > 0 else "(", *tokens[place:]])
        for found in re.finditer(r"[()]", text):
            yield text[: found.start()] + text[found.end() :]
    elif not depth and re.search(r"\w\s*[-+]|[/^]", text):
        for first, last in combinations(range(len(tokens) + 1), 2):
            if last - first > 2:
                yield " ".join([*tokens[:first], "(", *tokens[first:last], ")", *tokens[last:]])


def _single_numbers(text: str, question: Question) -> Iterator[Reading]:
    """The numbers in a text taken out of it, each with the words behind it as its unit and without them."""
    found = list(SIGNED.finditer(text))
    wanted = len(question.components)
    if wanted > 1:
        if len(found) == wanted:
            yield IN_WORDS, Items(tuple(Text(each[0]) for each in found), ())
        return
    if not 1 <= len(found) <= MOST_NUMBERS or len(text.split()) < 2:
        return
    kind = IN_WORDS if len(found) == 1 else SEVERAL
    for place, each in enumerate(found):
        until = found[place + 1].start() if place + 1 < len(found) else len(text)
        behind = text[each.end() : until].split()
        for count in range(min(3, len(behind)), -1, -1):
            yield kind, Text(" ".join([each[0], *behind[:count]]).rstrip(".,;:!?)"))
