"""The text of an option as people compare it: without markup, spaces and marks, but with every sign that means something."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping

from corollary.formula.characters import legible

FRACTION = re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
EMPHASIS = re.compile(r"(?<![\w)*])\*{1,2}([^\W\d](?:[^*$\n]*[^\W_])?)\*{1,2}(?![\w(*])")  # of Markdown
LAYOUT = re.compile(
    r"\\(?:mathrm|mathit|mathbf|text|textbf|vec|left|right|displaystyle|limits|quad|qquad|big|Big|[dt]?frac)\b"
    r"|\\[,;:! ]"
)
MEANT_BY = {
    **dict.fromkeys((r"\leq", r"\le"), "≤"),
    **dict.fromkeys((r"\geq", r"\ge"), "≥"),
    **dict.fromkeys((r"\neq", r"\ne"), "≠"),
    **dict.fromkeys((r"\cdot", r"\times", "·", "×", "⋅"), "*"),
    **dict.fromkeys(("−", "–", "—"), "-"),
    **dict.fromkeys(("′", "’", "`"), "'"),
}
COMMAND = re.compile("|".join(rf"{re.escape(each)}(?![A-Za-z])" for each in MEANT_BY if each[0] == "\\"))
RAISED = re.compile("[⁰¹²³⁴-⁹⁺⁻]+")
POINT = re.compile(r"(?<=\d)[.,](?=\d)")
WORD = re.compile(r"[^\W\d_]{2,}")
SIGNS = frozenset("%/*-'\u2030")
DROPPED = frozenset("$`")


def normal_form(text: str) -> str:
    """What the options of a choice are compared by. Only the capital at the beginning of a word is no difference, and in a number
    with a unit not even that: 5 mW and 5 MW are two options."""
    text = unicodedata.normalize("NFC", text)
    text = EMPHASIS.sub(r"\1", text)
    text = FRACTION.sub(r"\1/\2", text)
    text = COMMAND.sub(lambda found: MEANT_BY[found[0]], text)
    text = LAYOUT.sub(" ", legible(text))
    for sign, other in MEANT_BY.items():
        if sign[0] != "\\":
            text = text.replace(sign, other)
    text = RAISED.sub(lambda found: "^" + unicodedata.normalize("NFKC", found[0]).replace("−", "-"), text)
    if not re.search(r"[\d$]", text):
        text = WORD.sub(_without_capital, text)
    points = {found.start() for found in POINT.finditer(text)}
    signs = ("." if place in points else _sign_or_letter(sign) for place, sign in enumerate(text))
    return "".join(signs).strip("'*").removeprefix("the")


def folded(text: str) -> str:
    """The same where small letters are as good as capitals."""
    return normal_form(text).lower()


def alike(texts: Mapping[str, str]) -> tuple[str, str] | None:
    """The letters of two options that people cannot tell apart, if there are any."""
    seen: dict[str, str] = {}
    for letter, text in texts.items():
        if (first := seen.setdefault(normal_form(text), letter)) != letter:
            return first, letter
    return None


def _without_capital(found: re.Match[str]) -> str:
    word = found[0]
    return word.lower() if word[1:].islower() else word


def _sign_or_letter(sign: str) -> str:
    """A letter without its accent, a digit, a sign with a meaning; else nothing."""
    if sign in DROPPED:
        return ""
    kind = unicodedata.category(sign)
    if kind[0] in "LN":
        apart = unicodedata.normalize("NFKD", sign)
        return "".join(each for each in apart if not unicodedata.combining(each))
    return sign if sign in SIGNS or kind[0] == "S" else ""
