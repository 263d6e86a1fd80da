"""A vector as a length and an angle: `5 m/s at 30°`, `5∠30° m/s`, `magnitude 5 m/s, angle 30°`."""

from __future__ import annotations

import re

from corollary.answers.direction import turn_of
from corollary.formula.errors import ParseError, refused
from corollary.messages import catalogue

_ = catalogue(__name__)

TURN = r"[+\-]?\s*[0-9.,]+\s*(?:°|º|deg(?:rees?)?(?![A-Za-z])|rad(?![A-Za-z]))"
POLAR = re.compile(
    r"\s+at(?: an angle of)?\s+|\s*[∠@]\s*"
    rf"|\s*[,;]?\s+(?:and |with |und |og )?(?:an? |the )?(?:angle|direction|Winkel|vinkel|θ|theta|[φϕ]|phi|α|alpha)\s*(?:of|is|[=:≈])?\s*(?={TURN})",
    re.IGNORECASE,
)
SIZE = re.compile(
    r"^\s*(?:the )?(?:magnitude|size|length|Betrag|størrelse)\s*(?:of|is|[=:≈])?\s*", re.IGNORECASE
)
BEHIND = re.compile(rf"(?<=[A-Za-z²³¹)])(?<!sin)(?<!cos)(?<!tan)\s*,?\s*\(?(?={TURN}[^0-9]*$)")
FROM = r"(?:the )?(?:positive )?(?:horizontal|ground|\+?x)(?:[- ]?(?:axis|direction|plane))?"
LEVEL = re.compile(rf"\s*,?\s*(?:to|from|with|relative to) {FROM}\s*\)?$", re.IGNORECASE)


def length_and_angle(normalized: str) -> tuple[str, str] | ParseError | None:
    """The two texts of `5 m/s at 30°`; None when it is no such vector."""
    pieces = POLAR.split(normalized)
    if len(pieces) == 1:
        pieces = BEHIND.split(normalized, maxsplit=1) if BEHIND.search(normalized) else pieces
    if len(pieces) == 1:
        return None
    if len(pieces) != 2:
        return refused(_("a length and one angle are expected"), None, _("write for example 5 m/s at 30 deg"))
    length, angle = SIZE.sub("", pieces[0]).rstrip(" ,;"), pieces[1]
    turn = turn_of(angle)
    if not turn and not LEVEL.search(angle) and (unit := re.match(rf"(\s*{TURN})\s+([A-Za-z].*)$", angle)):
        length, angle = f"{length} {unit[2]}", unit[1]  # `5∠30° m/s`
    if turn and turn.sign == -1:
        return length, "-" + turn.text.strip().lstrip("+")
    return length, LEVEL.sub("", turn.text if turn else angle).strip().rstrip(")")
