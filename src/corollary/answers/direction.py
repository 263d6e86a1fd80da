"""What words behind a number say of its direction: in `0.43 m/s to the left` they are its sign."""

from __future__ import annotations

import re
from dataclasses import dataclass

from corollary.answers.remark import LONGEST

WAYS = {  # to the right, up and forwards are positive in every figure of the chapter; where they are not, a person decides
    "right": 1, "up": 1, "upward": 1, "upwards": 1, "forward": 1, "forwards": 1, "positive": 1,
    "left": -1, "down": -1, "downward": -1, "downwards": -1, "backward": -1, "backwards": -1, "back": -1, "negative": -1,
    "opposite": -1,
}  # fmt: skip
HEADING = re.compile(
    r"[\s,;(]+(?:(?:pointing|directed|moving|going|acting|pushing) )?"
    rf"(?:(?:(?:in|along|to|towards) )?(?:the )?(?P<way>{'|'.join(sorted(WAYS, key=len, reverse=True))})(?: [xy])?"
    r"|(?:in|along) (?:the )?(?P<sign>[+−–-])[xy])(?:[ -](?:axis|direction))?\)?\.?\s*$",
    re.IGNORECASE,
)
TOWARDS = re.compile(
    r"(?<=[A-Za-z0-9²)])[\s,;(]+(?P<said>(?:in|towards?|away from|against|from|opposite to|along) (?:the|my|his|its|our|your) [a-z' ]{2,60})\)?\.?\s*$",
    re.IGNORECASE,
)
LOST = re.compile(
    r"^\s*(?:(?:a|the|it)\s+)?(?P<before>loss of|decrease of|drop of|loses|lost)\s+|\s+(?P<behind>lost|loss|less)\.?\s*$",
    re.I,
)


@dataclass(frozen=True, slots=True)
class Direction:
    """A text without its words on direction; the sign they give, none where they alone do not tell it; the words."""

    text: str
    sign: int | None
    said: str


def direction_of(text: str, directed: bool) -> Direction | None:
    """The direction a text names, if any; `directed` tells that what is asked for has one."""
    if len(text) > LONGEST:
        return None
    if lost := LOST.search(text):
        return Direction(LOST.sub("", text), None, (lost["before"] or lost["behind"]).strip())
    if not directed:
        return None
    if found := HEADING.search(text):
        sign = WAYS[found["way"].lower()] if found["way"] else 1 if found["sign"] == "+" else -1
        return Direction(text[: found.start()], sign, found[0].strip(" ,;().\t\n"))
    if found := TOWARDS.search(text):
        return Direction(text[: found.start()], None, found["said"].strip())
    return None
