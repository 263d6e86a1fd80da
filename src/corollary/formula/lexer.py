"""A formula cut into its signs: numbers, letters, operators and brackets, each with its place in what was typed."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from corollary.formula.errors import ParseError, refused
from corollary.formula.numerals import RAISED, TO_ASCII, VULGAR
from corollary.formula.symbols import RUN, Piece
from corollary.messages import N_, catalogue

_ = catalogue(__name__)

LONGEST = 400
MOST_TOKENS = 200
MOST_DIGITS = 40
LARGEST_EXPONENT = 400

Kind = Literal[
    "number",
    "name",
    "unit",
    "function",
    "e",
    "degree",
    "sign",
    "open",
    "close",
    "comma",
    "bar",
    "compare",
    "end",
]
NUMBER = re.compile(r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE](?P<power>[+-]?[0-9]+))?")
WORD_BEFORE_DIGIT = re.compile(r"[^\W\d_]+(?=[0-9])")
RAISED_RUN = re.compile(r"[⁻⁺]?[⁰¹²³⁴-⁹]+")
COMPARE = re.compile(r"==|!=|<=|>=|[=<>≤≥≠]")
LONE: dict[str, tuple[Kind, str]] = {
    "(": ("open", "("),
    "[": ("open", "["),
    ")": ("close", ")"),
    "]": ("close", "]"),
    "°": ("degree", "°"),
    "º": ("degree", "°"),
    "√": ("function", "sqrt"),
    "∛": ("function", "cbrt"),
    "|": ("bar", "|"),
    ",": ("comma", ","),
}
HINTS = {
    "\\": N_("write it without TeX, such as m*v/dt"),
    "{": N_("use round brackets"),
    "}": N_("use round brackets"),
    ";": N_("write one formula"),
}
COMPARED = {"==": "=", "≤": "<=", "≥": ">=", "≠": "!="}


@dataclass(frozen=True, slots=True)
class Token:
    """One sign. `tight`: it follows the one before without a space. A number keeps its exact value and the figures shown."""

    kind: Kind
    text: str
    at: int
    tight: bool
    value: Fraction = Fraction(0)
    figures: int = 0


ReadRun = Callable[[str, int], list[Piece] | ParseError]
Found = tuple[list[Token], int]  # signs, and where they end
ReadFirst = Callable[[str, int, list[Token]], Found | ParseError | None]


def tokens(
    text: str,
    read_run: ReadRun,
    *,
    read_first: ReadFirst | None = None,
    longest: int = LONGEST,
    most: int = MOST_TOKENS,
) -> list[Token] | ParseError:
    """The signs of a formula, an `end` last; words are taken apart by `read_run`.

    `read_first` is asked before all else at each place, with the signs before it: it may find a sign of its own, or refuse.
    """
    if len(text) > longest:
        return refused(_("this is longer than {most} characters", most=longest), longest)
    normalized = text.translate(TO_ASCII)
    found: list[Token] = []
    at, tight = 0, True
    while at < len(normalized):
        if normalized[at] == " ":
            at, tight = at + 1, False
            continue
        own = read_first(normalized, at, found) if read_first is not None else None
        step = own or _next(normalized, at, tight, read_run)
        if isinstance(step, ParseError):
            return step
        more, at = step
        found += more
        tight = True
        if len(found) > most:
            return refused(_("this formula has more than {most} signs", most=most), at)
    return [*found, Token("end", "", len(text), False)]


def _next(normalized: str, at: int, tight: bool, read_run: ReadRun) -> Found | ParseError:
    letter = normalized[at]
    number = NUMBER.match(normalized, at)
    if number:
        token = _number(number, tight)
        return token if isinstance(token, ParseError) else ([token], number.end())
    run = RUN.match(normalized, at)
    if run:
        pieces = read_run(run[0], at)
        if isinstance(pieces, ParseError):
            return _glued_function(run[0], at, tight, read_run) or pieces
        return [
            Token(piece.kind, piece.name, piece.at, tight or place > 0) for place, piece in enumerate(pieces)
        ], run.end()
    raised = RAISED_RUN.match(normalized, at)
    if raised:
        return _raised(raised, tight)
    compare = COMPARE.match(normalized, at)
    if compare:
        return [Token("compare", COMPARED.get(compare[0], compare[0]), at, tight)], compare.end()
    if normalized.startswith("**", at):
        return [Token("sign", "^", at, tight)], at + 2
    if letter in "+-*/^":
        return [Token("sign", letter, at, tight)], at + 1
    if letter in VULGAR:
        return _vulgar(VULGAR[letter], at, tight), at + 1
    if letter in LONE:
        kind, text = LONE[letter]
        return [Token(kind, text, at, tight)], at + 1
    return refused(
        _("{sign} does not belong in a formula", sign=repr(letter)),
        at,
        _(HINTS[letter]) if letter in HINTS else "",
    )


def _glued_function(run: str, at: int, tight: bool, read_run: ReadRun) -> Found | None:
    """The function of `sqrt2gh`, `sin2x`: what stands before the first digit of a run that is no letter of the exercise."""
    word = WORD_BEFORE_DIGIT.match(run)
    pieces = read_run(word[0], at) if word else None
    if word is None or not isinstance(pieces, list) or [piece.kind for piece in pieces][-1:] != ["function"]:
        return None
    found = [
        Token(piece.kind, piece.name, piece.at, tight or place > 0) for place, piece in enumerate(pieces)
    ]
    return found, at + word.end()


def _number(found: re.Match[str], tight: bool) -> Token | ParseError:
    mantissa = re.split("[eE]", found[0])[0]
    if len(mantissa) > MOST_DIGITS:
        return refused(_("this number has more than {most} digits", most=MOST_DIGITS), found.start())
    if found["power"] and (len(found["power"]) > 6 or abs(int(found["power"])) > LARGEST_EXPONENT):
        return refused(_("powers of ten go up to {largest}", largest=LARGEST_EXPONENT), found.start())
    whole = "." not in mantissa and not found["power"]
    value = Fraction(mantissa.rstrip(".")) if mantissa[0] != "." else Fraction("0" + mantissa)
    value *= Fraction(10) ** int(found["power"] or 0)
    significant = mantissa.replace(".", "").lstrip("0")
    return Token("number", found[0], found.start(), tight, value, 0 if whole else len(significant))


def _vulgar(value: Fraction, at: int, tight: bool) -> list[Token]:
    """`½` is (1/2)."""
    top, bottom = Fraction(value.numerator), Fraction(value.denominator)
    return [
        Token("open", "(", at, tight),
        Token("number", str(top), at, True, top),
        Token("sign", "/", at, True),
        Token("number", str(bottom), at, True, bottom),
        Token("close", ")", at, True),
    ]


def _raised(found: re.Match[str], tight: bool) -> Found | ParseError:
    normalized, at = found[0].translate(RAISED), found.start()
    digits = normalized.lstrip("+-")
    if len(digits) > 4:
        return refused(_("this exponent is too large"), at)
    minus = [Token("sign", "-", at, True)] if normalized[0] == "-" else []
    return [
        Token("sign", "^", at, tight),
        *minus,
        Token("number", digits, at, True, Fraction(int(digits))),
    ], found.end()
