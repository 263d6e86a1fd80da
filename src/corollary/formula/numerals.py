"""Numbers as students write them: decimal comma or point, powers of ten, fractions, and the figures shown."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST = 200
MOST_DIGITS = 40
LARGEST_EXPONENT = 300

# One character for another, so that a position in the plain text is a position in what was typed.
FANCY = {
    "-": "−–—‐‑﹣",
    "*": "·×∙⋅•∗⨯✕✖‧・",
    "/": "∕⁄÷",
    "≈": "∼≃≅≒",
    "'": "’",
    " ": "\u00a0\u2002\u2003\u2009\u200a\u202f\u2007\u200b\u2060\u2062\u3000\ufeff\t\n\r",
}
# The full-width forms U+FF01 … U+FF5E are typed on keyboards for Chinese and Japanese.
TO_ASCII = {wide: chr(wide - 0xFEE0) for wide in range(0xFF01, 0xFF5F)} | {
    ord(fancy): sign for sign, several in FANCY.items() for fancy in several
}
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
VULGAR = {
    "½": Fraction(1, 2),
    "⅓": Fraction(1, 3),
    "⅔": Fraction(2, 3),
    "¼": Fraction(1, 4),
    "¾": Fraction(3, 4),
}

SIGN = re.compile(r"\s*([+-]?)\s*")
BODY = re.compile(
    r"[0-9]{1,3}(?:[ '][0-9]{3})*[.,](?:[0-9]{3}[ '])+[0-9]{1,3}(?![0-9.,])|(?:[0-9]{1,3}(?:[ '][0-9]{3})+(?![0-9])|[0-9]+)(?:[.,][0-9]+)*\.?|[.,][0-9]+"
)
POWER = r"(?:(?:\^|\*\*)\s*(?:([+-]?[0-9]+)|[({]([+-]?[0-9]+)[)}])|([⁻⁺]?[⁰¹²³⁴-⁹]+))"
TEN = re.compile(rf"\s?[eE]\s?([+-]?[0-9]+)(?![0-9.,])|(?:\s*(?:\*|[xX](?=\s*10))\s*|\s+)10\s*{POWER}")
BARE_TEN = re.compile(rf"10\s*{POWER}(?![0-9.,]*[.,][0-9])")
BELOW = re.compile(r"\s*/\s*(?=[0-9.,])")
MIXED = re.compile(r"([0-9]{1,9}) +([0-9]{1,2})/([0-9]{1,2})(?![0-9.,/])")


@dataclass(frozen=True, slots=True)
class Written:
    """A number and how it was written: at most `figures` significant figures, at least `least`.

    `20` has one or two, so `figures` is 2 and `least` 1; a fraction is exact, both are 0.
    """

    value: Fraction
    figures: int
    least: int


def scan_number(text: str) -> tuple[Written, int] | ParseError:
    """The number a text (translated by TO_ASCII) begins with, and where it ends."""
    start = SIGN.match(text)
    assert start is not None  # the pattern matches the empty string
    sign, at = (-1 if start[1] == "-" else 1), start.end()
    if (mixed := MIXED.match(text, at)) and 0 < int(mixed[2]) < int(mixed[3]):  # 8 3/5; `20 1/s` has a unit
        value = int(mixed[1]) + Fraction(int(mixed[2]), int(mixed[3]))
        return Written(sign * value, 0, 0), mixed.end()
    found = unsigned(text, at)
    if isinstance(found, ParseError):
        return found
    number, end = found
    below = BELOW.match(text, end)
    if below:
        bottom = unsigned(text, below.end(), below_a_line=True)
        if isinstance(bottom, ParseError):
            return bottom
        divisor, end = bottom
        if divisor.value == 0:
            return refused(_("a fraction cannot have 0 below its line"), below.end())
        number = Written(number.value / divisor.value, 0, 0)
    if (
        number.value
        and not Fraction(10) ** -LARGEST_EXPONENT <= number.value <= Fraction(10) ** LARGEST_EXPONENT
    ):
        return refused(_("this number is too large or too small to be meant"), at)
    return Written(sign * number.value, number.figures, number.least), end


def unsigned(text: str, at: int, *, below_a_line: bool = False) -> tuple[Written, int] | ParseError:
    """The number without a sign that stands at one place of a text (translated by TO_ASCII), and where it ends.

    `below_a_line`: of `6.72/2*10^2` it is the 2, as the product of two numbers is taken from the left.
    """
    bare = BARE_TEN.match(text, at)
    if bare:
        power = _exponent(bare)
        return power if isinstance(power, ParseError) else (Written(Fraction(10) ** power, 0, 0), bare.end())
    body = BODY.match(text, at)
    end = body.end() if body else at
    if body and text[end : end + 1] == " " and text[end + 1 : end + 2] in VULGAR and text[end + 1 : end + 2]:
        end += 1
    if end < len(text) and text[end] in VULGAR and (not body or body[0].isdecimal()):
        whole = int(body[0]) if body and len(body[0]) <= MOST_DIGITS else 0
        return Written(whole + VULGAR[text[end]], 0, 0), end + 1
    if not body:
        return refused(_("a number is missing here"), at, _("begin with digits, such as 8.6"))
    if sum(letter in "0123456789" for letter in body[0]) > MOST_DIGITS:
        return refused(_("this number has more than {most} digits", most=MOST_DIGITS), at)
    ten = TEN.match(text, end)
    if ten and below_a_line and ten[0].lstrip().startswith("*"):
        ten = None
    digits = _with_one_point(body[0], at, scientific=ten is not None)
    if isinstance(digits, ParseError):
        return digits
    power = _exponent(ten) if ten else 0
    if isinstance(power, ParseError):
        return power
    whole, _point, decimals = digits.partition(".")
    significant = (whole + decimals).lstrip("0")
    least = len(significant) if decimals else len(significant.rstrip("0"))
    value = Fraction(int(whole + decimals or "0"), 10 ** len(decimals)) * Fraction(10) ** power
    return Written(value, max(len(significant), 1), max(least, 1)), ten.end() if ten else end


def _exponent(found: re.Match[str]) -> int | ParseError:
    written = next(filter(None, found.groups())).translate(RAISED)
    if len(written) > 5 or abs(int(written)) > LARGEST_EXPONENT:
        return refused(_("powers of ten go up to {largest}", largest=LARGEST_EXPONENT), found.start())
    return int(written)


def _with_one_point(body: str, at: int, *, scientific: bool) -> str | ParseError:
    """The digits with one point or none; a comma is a decimal comma unless it may part thousands."""
    body = body.replace(" ", "").replace("'", "")
    body = body.removesuffix(".") if body[0] not in ".," else body  # a point at the end ends a sentence
    marks = [mark for mark in body if mark in ".,"]
    if not marks or marks == ["."]:
        return body
    groups = re.split("[.,]", body)
    if len(marks) == 1:
        before, after = groups
        if len(after) == 3 and 1 <= len(before) <= 3 and before.strip("0") and not scientific:
            return ambiguous(
                _("{body} can be {before}.{after} or {before}{after}", body=body, before=before, after=after),
                at,
                f"{before}.{after}",
                f"{before}{after}",
            )
        return f"{before}.{after}"
    thousands = 1 <= len(groups[0]) <= 3 and all(len(group) == 3 for group in groups[1:-1])
    if thousands and len(set(marks)) == 1 and len(groups[-1]) == 3:
        return "".join(groups)
    if thousands and len(set(marks[:-1])) == 1 and marks[-1] != marks[0]:
        return "".join(groups[:-1]) + "." + groups[-1]
    return refused(
        _("{body} has too many commas or points", body=body), at, _("write one decimal point, such as 1234.5")
    )


def decimal_text(number: Fraction | float, figures: int) -> str:
    """The number for people, rounded half to even to so many figures, trailing zeros kept; `figures=0` writes it exactly.

    Powers of ten (`1.2e-5`) only below 0.001 and from a million on.
    """
    if isinstance(number, float):
        if not math.isfinite(number):
            return str(number)
        number = Fraction(number) if figures else Fraction(repr(number))
    if number == 0:
        return "0" if figures < 2 else "0." + "0" * (figures - 1)
    size, sign = Fraction(abs(number)), "-" if number < 0 else ""
    figures = figures or _exact_figures(size)
    if figures == 0:
        return str(number)
    power = power_of_ten(size)
    digits = str(round(size * Fraction(10) ** (figures - 1 - power)))
    if len(digits) > figures:
        digits, power = digits[:-1], power + 1
    return sign + _placed(digits, power)


def figures_apart(values: Iterable[Fraction | float], least: int) -> int:
    """The figures, `least` or as many more as it takes, with which values that differ are written differently."""
    different = {each for each in values if not isinstance(each, float) or math.isfinite(each)}
    figures = least
    while len({decimal_text(each, figures) for each in different}) < len(different):
        figures += 1
    return figures


def _placed(digits: str, power: int) -> str:
    if -4 < power < 0:
        return "0." + "0" * (-power - 1) + digits
    if 0 <= power < 6:
        whole = digits[: power + 1].ljust(power + 1, "0")
        return whole + ("." + digits[power + 1 :] if len(digits) > power + 1 else "")
    return digits[0] + ("." + digits[1:] if len(digits) > 1 else "") + f"e{power}"


def _exact_figures(size: Fraction) -> int:
    """How many figures it takes to write it exactly; 0 when no decimal number does."""
    digits, rest = divmod(size.numerator * 10 ** size.denominator.bit_length(), size.denominator)
    return 0 if rest else len(str(digits).rstrip("0"))


def power_of_ten(size: Fraction) -> int:
    """The largest power p with 10**p <= size."""
    power = math.floor((size.numerator.bit_length() - size.denominator.bit_length()) * math.log10(2))
    while Fraction(10) ** power > size:
        power -= 1
    while Fraction(10) ** (power + 1) <= size:
        power += 1
    return power
