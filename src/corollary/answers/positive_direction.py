"""The positive direction as the words of a problem name it, and the sign that words behind a number have by it."""

from __future__ import annotations

import re
from functools import lru_cache

from corollary.answers.sign_words import AXIS_OF, SIGNS

EMPHASIS = re.compile(r"[*_$]")
NAMED = re.compile(
    r"(?P<before>[^.;:!?]{2,120}?)\s+(?:is|are|als|as|ist|sind|er)\s+(?:the\s+|die\s+|den\s+)?(?:taken\s+as\s+)?positiv(?:e|en)?\b"
    r"|(?P<apposed>[^.;:,!?]{2,80}),\s+the\s+positive\s+(?:x[- ])?direction"
    r"|positive\s+in\s+the\s+direction\s+(?P<behind>[^.;:!?]{2,80})",
    re.IGNORECASE,
)
TOWARDS, AWAY = re.compile(r"\b(?:towards?|against|at|to|into)\b"), re.compile(r"\b(?:away from|from)\b")
REFERENCE_LINE = re.compile(
    r"\b(?:from|to|with|above|below|under|unter|unterhalb|gegen|mot|fra|von|zur|zum|off)\s+(?:the\s+|der\s+|die\s+|den\s+|its\s+)?"
    r"(?P<line>vertical|horizontal|normal|upright|vertikalen?|senkrechten?|horizontalen?|waagerechten?|vertikalen|horisontalen)\b",
    re.IGNORECASE,
)
BELOW = re.compile(r"below\b|under\b|unter", re.IGNORECASE)
UPRIGHT = re.compile("vert|upright|senk", re.IGNORECASE)
ALONG_MOTION = re.compile(
    r"(?:(?P<against>against|opposite to)|in|along)\s+(?:the\s+|its\s+)?(?:direction\s+of\s+)?(?:the\s+|its\s+)?(?:motion|travel|movement|driving)",
    re.IGNORECASE,
)
IN_MOTION = re.compile(
    r"\b(?:forwards?|motion|travel|moves?|moving|drives?|driving|leaves?|flies|rolls?|slides?|runs?)\b",
    re.IGNORECASE,
)
NO_CONTENT: str = (
    "the a an in of to its his her your my is it which that direction take velocities velocity with and so this all towards toward "
    "away from against at into straight"
)
EMPTY = frozenset(NO_CONTENT.split())


@lru_cache(maxsize=512)  # of a part, each time that an answer to it is read
def named_positive(*texts: str) -> str:
    """The words that the last of the texts to name a positive direction has for it; "" where none does."""
    return next((words for text in reversed(texts) if (words := _named(text))), "")


# Each is asked of the same few texts for every answer that is judged, and takes milliseconds of a long one.
@lru_cache(maxsize=256)
def _named(text: str) -> str:
    found = list(NAMED.finditer(EMPHASIS.sub("", " ".join(text.split()))))
    if not found:
        return ""
    words = found[-1]["before"] or found[-1]["apposed"] or found[-1]["behind"]
    return words.strip(" ,").lower()


@lru_cache(maxsize=512)
def angle_reference(*texts: str) -> str:
    """`vertical` or `horizontal`, from which the last of the texts to say so counts an angle, `below horizontal` where it counts
    downwards; "" where none does."""
    return next((line for text in reversed(texts) if (line := _reference(text))), "")


@lru_cache(maxsize=256)
def _reference(text: str) -> str:
    found = list(REFERENCE_LINE.finditer(EMPHASIS.sub("", text)))
    return f"{'below ' if BELOW.match(found[-1][0]) else ''}{line_of(found[-1])}" if found else ""


def line_of(found: re.Match[str]) -> str:
    """The line that an angle is counted from, in one word."""
    word = found["line"].lower()
    return "vertical" if UPRIGHT.match(word) else "normal" if word == "normal" else "horizontal"


def sign_of_way(way: str, positive: str) -> int:
    """The sign of `down`, `left`, `backwards`; where the problem counts the other way as positive, the other one."""
    way = way.lower()
    sign, axis = SIGNS[way], AXIS_OF.get(way)
    turned = {
        SIGNS[word] for word in re.findall(r"[^\W\d_]+", positive) if axis and AXIS_OF.get(word) == axis
    }
    return -sign if turned == {-1} else sign


def sign_of_words(words: str, positive: str) -> int | None:
    """The sign of `towards the wall` where the problem's positive direction is towards the wall, and of `away from the wall`; None
    where the problem's words do not tell it."""
    if (way := ALONG_MOTION.fullmatch(words)) is not None and IN_MOTION.search(positive):
        return -1 if way["against"] else 1
    mine, theirs = _content(words), _content(positive)
    if not mine or not mine <= theirs:
        return None
    senses = [
        -1 if AWAY.search(each.lower()) else 1 if TOWARDS.search(each.lower()) else 0
        for each in (words, positive)
    ]
    return senses[0] * senses[1] or (1 if senses[0] == senses[1] else None)


def _content(words: str) -> set[str]:
    return set(re.findall(r"[^\W_]+", words.lower())) - EMPTY
