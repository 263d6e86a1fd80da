"""Numbers in words, and ratios: `twice as large`, `half`, `two thirds`, `2:1`, `a factor of 2`, `2 times`, `zero m/s`."""

from __future__ import annotations

import re

NUMBERS = dict(
    zip(
        [
            "zero",
            "one",
            "two",
            "three",
            "four",
            "five",
            "six",
            "seven",
            "eight",
            "nine",
            "ten",
            "eleven",
            "twelve",
        ],
        range(13),
        strict=True,
    )
)
# As words that stand for a number on their own, in English, German, French and Nordic; with the fraction they are.
RATIOS = {
    "twice": "2", "double": "2", "doubled": "2", "doubles": "2", "thrice": "3", "triple": "3", "tripled": "3", "quadruple": "4",
    "half": "1/2", "halved": "1/2", "third": "1/3",
    "quarter": "1/4", "fourth": "1/4",
    "tenth": "1/10", "fifth": "1/5", "equal": "1",
    "doppelt": "2", "doppelte": "2", "zweimal": "2", "dreimal": "3", "halb": "1/2", "hälfte": "1/2", "le double": "2", "la moitié": "1/2",
    "dobbelt": "2", "dubbelt": "2", "halvparten": "1/2", "hälften": "1/2",
}  # fmt: skip
DIGITS = r"[0-9]+(?:[.,][0-9]+)?"
ABOUT = r"(?:(?:it|this|that|the|is|was|by|about|exactly|approximately|roughly|just|only|always|a|an|die|das|≈)\s+)*"
RATIO = re.compile(
    rf"\s*{ABOUT}(?:ratio\s*(?:of|is|=|:)?\s*)?({DIGITS})\s*(?::|\bto\b|\bzu\b)\s*({DIGITS})\s*",
    re.IGNORECASE,
)
FACTOR = re.compile(
    rf"\s*{ABOUT}(?:(?:fa[ck]tor|ratio)\s*(?:of|is|=|:)?|[x*])\s*({DIGITS}(?:/{DIGITS})?)\s*", re.IGNORECASE
)
LARGE = r"(?:as\s+)?(?:much|large|big|great|high|fast|strong|heavy|long|many|larger|bigger|greater|higher|faster|more)"
BESIDE = rf"(?:\s+{LARGE}(?:\s+(?:as|than|for)\b[^0-9]{{0,60}})?|\s+(?:of|that of)\b[^0-9]{{0,60}}|\s+(?:the|that|its|so|så)\b[^0-9]{{0,60}})?"
TIMES = re.compile(
    rf"\s*{ABOUT}({DIGITS}(?:/{DIGITS})?)\s*(?:x|\*|times|-?fold|mal|fois|ganger)(?:{BESIDE})\s*",
    re.IGNORECASE,
)
NUMBER_TIMES = re.compile(
    rf"\s*{ABOUT}({'|'.join(NUMBERS)})(?:\s+times|[\s-]?fold){BESIDE}\s*", re.IGNORECASE
)
FACTOR_IN_WORDS = re.compile(
    rf"\s*{ABOUT}(?:factor|faktor)\s*(?:of|von|på)?\s*({'|'.join(NUMBERS)})\s*", re.IGNORECASE
)
WORD = re.compile(rf"\s*{ABOUT}({'|'.join(sorted(RATIOS, key=len, reverse=True))}){BESIDE}\s*", re.IGNORECASE)
REST = re.compile(
    r"(?:\b(?:is|stays|remains|comes to|comes)\s+)?\b(?:at rest|to rest|stationary)\b", re.IGNORECASE
)
PER_CENT = re.compile(r"\bper cent\b", re.IGNORECASE)
CROSS = re.compile(r"(?<=[0-9A-Za-z)²³] )[xX](?= [0-9A-Za-z(])|(?<=[0-9])[xX](?=[0-9])")
FRACTION = re.compile(
    rf"\s*{ABOUT}(one|two|three|four|five|six|seven)[ -](half|halves|third|quarter|fourth|fifth|sixth|eighth|ninth|tenth)s?{BESIDE}\s*",
    re.IGNORECASE,
)
BELOW = {"half": 2, "halves": 2, "third": 3, "quarter": 4, "fourth": 4, "fifth": 5, "sixth": 6, "eighth": 8, "ninth": 9, "tenth": 10}  # fmt: skip
FIRST = re.compile(rf"\s*([+-]?)\s*({'|'.join(NUMBERS)})(?=\s+[A-Za-zµ°%]|\s*$)", re.IGNORECASE)


def rest_is_zero(text: str) -> str:
    """`A at rest` as `A 0`."""
    return REST.sub("0", text)


def in_digits(normalized: str, *, pure: bool) -> str:
    """The number in digits; as it is where there is no word for one. Ratios are read where a `pure` number is asked for."""
    normalized = CROSS.sub("*", rest_is_zero(PER_CENT.sub("%", normalized)))
    text = normalized.strip().rstrip(".!")
    if pure:
        if found := RATIO.fullmatch(text):
            return f"{found[1]}/{found[2]}"
        if found := FACTOR.fullmatch(text) or TIMES.fullmatch(text):
            return found[1]
        if found := FRACTION.fullmatch(text):
            return f"{NUMBERS[found[1].lower()]}/{BELOW[found[2].lower()]}"
        if found := NUMBER_TIMES.fullmatch(text) or FACTOR_IN_WORDS.fullmatch(text):
            return str(NUMBERS[found[1].lower()])
        if found := WORD.fullmatch(text):
            return RATIOS[re.sub(r"\s+", " ", found[1].lower())]
    if found := FIRST.match(normalized):
        return found[1] + str(NUMBERS[found[2].lower()]) + normalized[found.end() :]
    return normalized
