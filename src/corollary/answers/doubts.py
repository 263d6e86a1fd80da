"""Texts asked about, or refused, before a number is looked for: lost powers of ten, bounds, tables."""

from __future__ import annotations

import re

from corollary.answers.bound import bound_in, of_a_bound
from corollary.answers.spread import in_brackets
from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.messages import catalogue

_ = catalogue(__name__)

TABLE = re.compile(r"^\s*\|[^|]*\|[^|]+\|\s*$|\|\s*:?-{3,}", re.MULTILINE)  # of Markdown
LOST_POWER = re.compile(
    r"(?<![0-9.,])(?P<number>[0-9]+(?:[.,][0-9]+)?)\s?[xX×·⋅]\s?10(?P<power>[1-9][0-9]?)(?![0-9.,^*])"
)
# `1.13*10 -3`, `1.13*10 3`: a power that lost its raising, or a difference or a product; `5*10 - 3` is a difference.
LOST_RAISING = re.compile(
    r"(?<![0-9.,])(?:(?P<number>[0-9]+(?:[.,][0-9]+)?)\s?[xX×*·⋅]\s?10(?P<sign>\s+[-−–]|[-−–]\s|\s(?=[0-9]))"
    r"|(?P<small>[1-9][.,][0-9]+)\s?[xX×*·⋅]\s?10(?P<apart>\s[-−–]\s))(?P<power>[0-9]{1,2})(?![0-9.,^*/(])"
)
# `6/2x10^3`: with a cross or a blank the power of ten may belong to the divisor; with `*` it is a factor, as in Python.
TEN_BELOW = re.compile(
    r"(?P<top>[0-9.,]+)\s*/\s*(?P<bottom>[0-9]+(?:[.,][0-9]+)?)(?:\s?[xX]\s?|\s+)10(?:\^|\*\*)(?P<power>[({]?[-+]?[0-9]+[)}]?)"
)
# `1.13 10 -3`, where a blank stands for the cross, too.
LOST_CROSS = re.compile(
    r"(?<![0-9.,])(?P<number>[1-9][.,][0-9]+)\s+10\s?(?P<power>[-−–]\s?[0-9]{1,2}|\s[0-9])(?![0-9.,^*/(])"
)
# `1.6x10e-19`: ten to that power, or ten times as much.
TEN_TWICE = re.compile(
    r"(?<![0-9.,])(?P<number>[0-9]+(?:[.,][0-9]+)?)\s?[xX×*·⋅]\s?10\s?[eE]\s?(?P<power>[-+−–]?[0-9]{1,2})(?![0-9.,])"
)
HEXADECIMAL = re.compile(r"(?<![0-9.,A-Za-z])0[xXbBoO][0-9A-Fa-f]")


def doubtful(typed: str, normalized: str) -> ParseError | None:
    """What is asked about or refused before a number is looked for: `65.0(5)`, a table, `3x108`, `≥ 5`, `0x10`."""
    if asked := in_brackets(normalized):
        return asked
    if TABLE.search(typed):
        return refused(_("a table is not read here"), None, _("write one number and a unit"))
    if "10" in typed and (doubt := _of_a_power(typed)) is not None:
        return doubt
    if (bound := bound_in(typed)) is not None:
        return ParseError("asked", of_a_bound(bound), None)
    if HEXADECIMAL.search(normalized):
        why = _("{text} is not a decimal number", text=normalized.strip())
        return refused(why, 0, _("write one number and a unit"))
    return None


def _of_a_power(typed: str) -> ParseError | None:
    """What is asked about a power of ten that lost its raising, or that may belong to a divisor."""
    if (lost := LOST_POWER.search(typed)) is not None:
        number, power = lost["number"], lost["power"]
        why = _("{text} can be a power of ten or a product", text=lost[0].strip())
        return _asked(typed, lost, why, f"{number}*10^{power}", f"{number}*10{power}")
    if (lost := LOST_RAISING.search(typed)) is not None:
        number, power = lost["number"] or lost["small"], lost["power"]
        if not (lost["sign"] or lost["apart"]).strip():
            why = _("{text} can be a power of ten or a product", text=lost[0].strip())
            return _asked(typed, lost, why, f"{number}*10^{power}", f"{number}*10*{power}")
        why = _("{text} can be a power of ten or a difference", text=lost[0].strip())
        return _asked(typed, lost, why, f"{number}*10^-{power}", f"({number}*10) - {power}")
    if (lost := LOST_CROSS.search(typed)) is not None:
        power = re.sub(r"\s", "", lost["power"]).replace("−", "-").replace("–", "-")
        why = _("{text} may be a power of ten whose exponent is not raised", text=lost[0].strip())
        return _asked(typed, lost, why, f"{lost['number']}*10^{power}")
    if (ten := TEN_TWICE.search(typed)) is not None:
        number, power = ten["number"], ten["power"].replace("−", "-").replace("–", "-").lstrip("+")
        why = _("{text} can be a power of ten, or ten times it", text=ten[0].strip())
        return _asked(typed, ten, why, f"{number}*10^{power}", f"{number}*10*10^{power}")
    if (ten := TEN_BELOW.search(typed)) is not None:
        top, bottom, power = ten["top"], ten["bottom"], f"10^{ten['power'].strip('(){}')}"
        why = _("{text} can be a product or a fraction", text=ten[0].strip())
        return _asked(typed, ten, why, f"({top}/{bottom})*{power}", f"{top}/({bottom}*{power})")
    return None


def _asked(typed: str, found: re.Match[str], why: str, *meant: str) -> ParseError:
    """The question which of its meanings stands in the place of what was found."""
    choices = tuple(f"{typed[: found.start()]}{each}{typed[found.end() :]}" for each in meant)
    return ambiguous(why, None, *choices)
