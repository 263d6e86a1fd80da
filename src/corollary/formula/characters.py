"""Characters that look like others: zero-width ones, letters of other alphabets in units, digits of other scripts, mathematical letters."""

from __future__ import annotations

import re
import unicodedata

# Marks that cannot be seen, and stand in what was copied from a page or a chat.
INVISIBLE = (
    "\u00ad\u034f\u061c\u115f\u180e\u200b\u200c\u200d\u200e\u200f\u2060\u2061\u2062\u2063\u2064\ufeff"
    + "".join(map(chr, (*range(0x202A, 0x202F), *range(0x2066, 0x2070), *range(0xFE00, 0xFE10))))
)
# Units as a Cyrillic keyboard writes them; elsewhere a letter is what it looks like.
RUSSIAN = {
    "кг": "kg", "г": "g", "м": "m", "см": "cm", "мм": "mm", "км": "km", "с": "s", "мс": "ms", "ч": "h", "мин": "min",
    "Н": "N", "кН": "kN", "Дж": "J", "кДж": "kJ", "МДж": "MJ", "Вт": "W", "кВт": "kW", "Па": "Pa", "рад": "rad",
}  # fmt: skip
CYRILLIC = re.compile(r"[\u0400-\u04ff]+")
LOOKS = dict(zip("АВЕЅЈКМНОРСТУХаеіјкморѕстухԛԝ", "ABESJKMHOPCTYXaeijkmopsctyxqw", strict=True)) | dict(
    zip("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧοıɡᴇ", "ABEZHIKMNOPTYXoigE", strict=True)
)
MARKS = {
    "\u2024": ".", "\u3002": ".", "\u066b": ".", "\u201a": ",", "\u060c": ",", "\u066c": "'", "\u3001": ",", "\u2236": ":",
    "\ua789": ":", "\u02d7": "-", "\u2043": "-", "\u30fc": "-", "\u2796": "-", "\u2215": "/", "\u29f8": "/", "\u2795": "+",
    "\u02da": "°", "\u02b9": "'", "\u2032": "'", "\u02c6": "^", "\u2038": "^", "\u2217": "*", "\u204e": "*",
}  # fmt: skip
HALVES = dict.fromkeys(
    map(chr, range(0xD800, 0xE000)), "\ufffd"
)  # of characters cut in two: they cannot be written down
EXACT = str.maketrans(dict.fromkeys(INVISIBLE) | LOOKS | MARKS | HALVES)
# Mathematical letters and digits (𝑚, 𝟖), squared units (㎏, ㎧), letters run together (ﬁ), signs that are units (K, ℃).
COMPATIBLE = re.compile(r"[\U0001d400-\U0001d7ff㌀-㏿ﬀ-ﬆK\u2100-\u2103\u210e\u2113\u213c]")


def legible(text: str) -> str:
    """The text in characters that can be typed, each look-alike as what it looks like; as it is where it has none."""
    if text.isascii():
        return text
    text = COMPATIBLE.sub(lambda found: unicodedata.normalize("NFKC", found[0]), text)
    text = CYRILLIC.sub(lambda found: RUSSIAN.get(found[0], found[0]), text).translate(EXACT)
    return "".join(_digit(sign) for sign in text)


def _digit(sign: str) -> str:
    """A digit of any script as one of ours; raised and lowered digits stay."""
    value = unicodedata.decimal(sign, None)
    return sign if value is None else str(value)
